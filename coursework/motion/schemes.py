"""The schemes: explicit Runge-Kutta methods, each one Butcher tableau that is checked when it is made.

Enters: nothing.  Leaves: `SCHEMES`, name -> frozen `Scheme`.  Used by every room that makes steps or names a scheme.
To add one: write its tableau here, list it in `SCHEMES`, and name it in
`variant/record/vocabulary.py`.  Step, generated loops, count of slopes, formula on the page,
order test, comparison chart and `--scheme` come from the tableau; a words file may translate its title as `scheme.NAME`.

Source: J. C. Butcher, "Numerical Methods for Ordinary Differential Equations", Wiley 2016, chapter 3: a method has order p
when sum_i b_i Phi_i(tree) = 1/density(tree) for every rooted tree with at most p vertices.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from fractions import Fraction
from typing import Any

import numpy as np

from coursework.system.frozen import frozen
from coursework.variant.record.vocabulary import scheme_hint, scheme_names
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say

Slopes = Callable[[Any, Any], Any]
Tree = tuple[Any, ...]  # the trees that grow from a root; () is a single vertex


@frozen
class Sum:
    """One row of a tableau with its common factor taken out: h * factor * sum of whole * slope.

    `terms` are pairs (index of a slope, whole number other than zero), as a lecture writes h/6 (k1 + 2 k2 + 2 k3 + k4).
    """

    factor: Fraction
    terms: tuple[tuple[int, int], ...]

    def added(self, q: Any, h: Any, slopes: Sequence[Any]) -> Any:
        """Return q plus this sum; the generated loops do the same operations in the same order."""
        if not self.terms:
            return q
        (place, whole), *rest = self.terms
        total = slopes[place] if whole == 1 else whole * slopes[place]
        for place, whole in rest:
            total = total + (slopes[place] if whole == 1 else whole * slopes[place])
        return q + _part(self.factor, h) * total

    def text(self, slopes: Sequence[str], factor: str, plus: str = " + ") -> str:
        """Return this sum as code: `factor` times the sum of the slopes by name."""
        terms = [f"{'' if whole == 1 else f'{whole}*'}{slopes[place]}" for place, whole in self.terms]
        return f"{factor}*{terms[0] if len(terms) == 1 else f'({plus.join(terms)})'}"


@frozen
class Scheme:
    """An explicit scheme as its Butcher tableau: k_i = f(t + c_i h, q + h sum_j a_ij k_j), next q + h sum_i b_i k_i.

    `name` is used by `--scheme`, `title` is the name in words.  The numbers are exact fractions: `nodes` c (s,), `rows` a (row i
    has i numbers), `weights` b (s,).  `order` is the order of accuracy.  Raises `ValueError` if the numbers do not form an
    explicit scheme of exactly this order.

    >>> Scheme("half", "half a step", (0,), ((),), (Fraction(1, 2),), 1)
    Traceback (most recent call last):
    ValueError: half: the weights add up to 1/2, not to 1.
    """

    name: str
    title: str
    nodes: tuple[Fraction | int, ...]
    rows: tuple[tuple[Fraction | int, ...], ...]
    weights: tuple[Fraction | int, ...]
    order: int
    inner: tuple[Sum, ...] = field(init=False, repr=False)
    outer: Sum = field(init=False, repr=False)

    def __hash__(self) -> int:  # every cached loop asks for the hash; hashing a hundred fractions would take as long as the loop
        return hash(self.name)

    def __post_init__(self) -> None:
        fault = self._fault()
        if fault:
            raise ValueError(f"{self.name}: {fault}")
        object.__setattr__(self, "inner", tuple(map(_common, self.rows)))
        object.__setattr__(self, "outer", _common(self.weights))

    @property
    def slopes(self) -> int:
        """Return how many slopes a step computes."""
        return len(self.nodes)

    @property
    def damped(self) -> float:
        """Return the largest product of step and decay rate for which one step does not enlarge a decaying deviation.

        A step multiplies the deviation by R(-x) = sum_k (-x)^k b a^(k-1) 1: 2 for explicit Euler, 2.785 for Runge-Kutta 4.

        >>> SCHEMES["euler"].damped
        2.0
        """
        inside: list[Fraction | int] = [1] * self.slopes
        factors = [Fraction(1)]
        for _ in range(self.slopes):
            factors.append(
                Fraction(sum(weight * one for weight, one in zip(self.weights, inside, strict=True))) * (-1) ** len(factors)
            )
            inside = [sum(a * one for a, one in zip(row, inside, strict=False)) for row in self.rows]
        growing = [float(factor) for factor in reversed(factors)]
        roots = [np.roots([*growing[:-1], growing[-1] - edge]) for edge in (1.0, -1.0)]
        return min(float(root.real) for root in np.concatenate(roots) if abs(root.imag) < 1e-9 < root.real)

    def step(self, f: Slopes, t: Any, q: Any, h: Any, first: Any = None) -> Any:
        """Return the position after one step of length h from q at t; `f(t, q)` gives the slopes, as numbers or arrays.

        `first` is the slope at (t, q), if it is already known.

        >>> SCHEMES["euler"].step(lambda t, q: -q, 0.0, 1.0, 0.1)
        0.9
        """
        found: list[Any] = [] if first is None else [first]
        for node, row in list(zip(self.nodes, self.inner, strict=True))[len(found) :]:
            found.append(f(t + _part(node, h) if node else t, row.added(q, h, found)))
        return self.outer.added(q, h, found)

    def _fault(self) -> str:
        """Return what is wrong with the numbers; an empty string if nothing is wrong."""
        stages = len(self.nodes)
        if len(self.weights) != stages or [len(row) for row in self.rows] != list(range(stages)):
            return f"{stages} nodes need as many weights, and rows of 0 to {stages - 1} numbers."
        if not all(isinstance(value, (int, Fraction)) for row in (*self.rows, self.nodes, self.weights) for value in row):
            return "the numbers must be whole numbers or fractions, which are exact."
        for place, (node, row) in enumerate(zip(self.nodes, self.rows, strict=True), start=1):
            if sum(row) != node:
                return f"row {place} adds up to {sum(row)}, not to its node {node}."
        if sum(self.weights) != 1:
            return f"the weights add up to {sum(self.weights)}, not to 1."
        for size in range(1, self.order + 1):
            if not all(map(self._meets, _trees(size))):
                return f"order {self.order} is stated, but a condition of order {size} is not met."
        if all(map(self._meets, _trees(self.order + 1))):
            return f"order {self.order} is stated, but every condition of order {self.order + 1} is met too."
        return ""

    def _meets(self, tree: Tree) -> bool:
        """Return whether the condition of one rooted tree holds."""
        found = sum(weight * inside for weight, inside in zip(self.weights, self._inside(tree), strict=True))
        return bool(found * _density(tree) == 1)

    def _inside(self, tree: Tree) -> list[Fraction | int]:
        """Return Phi_i of a tree for every stage: the product over its branches of sum_j a_ij Phi_j(branch)."""
        products: list[Fraction | int] = [1] * len(self.nodes)
        for branch in tree:
            below = self._inside(branch)
            for stage, row in enumerate(self.rows):
                products[stage] *= sum(a * phi for a, phi in zip(row, below, strict=False))
        return products


def _part(part: Fraction | int, h: Any) -> Any:
    """Return part*h computed as a lecture writes it: h, h/2, 2*h/3."""
    above = h if part.numerator == 1 else part.numerator * h
    return above if part.denominator == 1 else above / part.denominator


def share(part: Fraction | int, step: str) -> str:
    """Return part*h as code; `step` is the name of h."""
    above = step if part.numerator == 1 else f"{part.numerator}*{step}"
    return above if part.denominator == 1 else f"{above}/{part.denominator}"


def _common(row: Sequence[Fraction | int]) -> Sum:
    """Return a row with its common factor taken out."""
    kept = [(place, Fraction(value)) for place, value in enumerate(row) if value]
    if not kept:
        return Sum(Fraction(1), ())
    denominator = math.lcm(*(value.denominator for _, value in kept))
    wholes = [value.numerator * (denominator // value.denominator) for _, value in kept]
    shared = math.gcd(*wholes)
    terms = tuple((place, whole // shared) for (place, _), whole in zip(kept, wholes, strict=True))
    return Sum(Fraction(shared, denominator), terms)


def _trees(size: int) -> Iterator[Tree]:
    """Yield every rooted tree with `size` vertices once."""
    yield from _forests(size - 1, size - 1)


def _forests(size: int, largest: int) -> Iterator[Tree]:
    """Yield every collection of rooted trees with `size` vertices in all, none with more than `largest`, larger trees first."""
    if size == 0:
        yield ()
        return
    for first in range(min(size, largest), 0, -1):
        for tree in _trees(first):
            for others in _forests(size - first, first):
                # Trees of equal size are ordered by `repr`, so that no collection is yielded twice.
                if not others or _vertices(others[0]) < first or repr(others[0]) <= repr(tree):
                    yield (tree, *others)


def _vertices(tree: Tree) -> int:
    return 1 + sum(map(_vertices, tree))


def _density(tree: Tree) -> int:
    return _vertices(tree) * math.prod(map(_density, tree))


_HALF, _THIRD = Fraction(1, 2), Fraction(1, 3)

EULER = Scheme("euler", "explicit Euler", nodes=(0,), rows=((),), weights=(1,), order=1)
"""One slope, order 1.  Common mistake: the velocities of row i + 1 computed with the coordinates of row i."""

MIDPOINT = Scheme("midpoint", "midpoint", nodes=(0, _HALF), rows=((), (_HALF,)), weights=(0, 1), order=2)
"""Two slopes, order 2.  Common mistake: the first slope added too, or the second one taken at t and not at t + h/2."""

HEUN = Scheme("heun", "Heun", nodes=(0, 1), rows=((), (1,)), weights=(_HALF, _HALF), order=2)
"""Two slopes, order 2.  Common mistake: the second slope computed at q instead of q + h k1."""

RALSTON = Scheme("ralston", "Ralston", (0, 2 * _THIRD), ((), (2 * _THIRD,)), (Fraction(1, 4), Fraction(3, 4)), order=2)
"""Two slopes, order 2, the least bound on the error of one step among these.  Common mistake: the weights 1/4 and 3/4 swapped.

A. Ralston, "Runge-Kutta methods with minimum error bounds", Math. Comp. 16 (1962).
"""

RK4 = Scheme(
    "rk4", "Runge-Kutta 4", nodes=(0, _HALF, _HALF, 1), rows=((), (_HALF,), (0, _HALF), (0, 0, 1)),
    weights=(_HALF * _THIRD, _THIRD, _THIRD, _HALF * _THIRD), order=4,
)  # fmt: skip
"""Four slopes, order 4, the classical scheme.  Common mistake: k3 computed from k1, or the sum divided by 4."""

SCHEMES: dict[str, Scheme] = {scheme.name: scheme for scheme in (EULER, MIDPOINT, HEUN, RALSTON, RK4)}
# Only for motion under forces, where the state holds rates: first v + h a(q, v, t), then q + h v with the new rates.  It is not
# in `SCHEMES`; its slopes and its order are those of Euler.
SEMI_IMPLICIT = Scheme("semi-implicit", "semi-implicit Euler", nodes=(0,), rows=((),), weights=(1,), order=1)
# The scheme used if none is named: the scheme of the coursework.
DEFAULT_SCHEME = EULER
# The scheme that finds a motion to round-off by halving its steps, and that the accuracy study calls the better scheme.
PRECISE = RK4


# The schemes a lesson compares for motion under forces: three orders, and the scheme that keeps a pendulum's energy bounded.
COMPARED = (EULER, SEMI_IMPLICIT, HEUN, RK4)


def scheme_of(name: str, also: tuple[str, ...] = ()) -> Scheme:
    """Return a scheme by its name; `also` are further names that are allowed.  Raises `InputError` for an unknown name.

    >>> scheme_of("rk4").slopes
    4
    """
    found = scheme_named(name) if name in SCHEMES or name in also else None
    if found is None:
        known = (*scheme_names(), *also)
        raise InputError(say("fault.C003", scheme=name, hint=scheme_hint(str(name), known), known=", ".join(known)))
    return found


def scheme_named(name: str) -> Scheme | None:
    """Return the scheme with this name; None for the exact motion, which has no tableau."""
    return SEMI_IMPLICIT if name == SEMI_IMPLICIT.name else SCHEMES.get(name)


def title_of(scheme: Scheme) -> Sentence:
    """Return the title of a scheme: the sentence `scheme.NAME` of the words file if it exists, else the title in the record."""
    key = f"scheme.{scheme.name}"
    return say(key) if load_phrases().has(key) else Sentence(scheme.title, key, {})
