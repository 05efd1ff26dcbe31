"""The dimension of a formula, from the dimensions of its names.

Enters: checked formulas.  Leaves: dimensions; raises `Clash` at the first place where two dimensions cannot be equal.
Used where a variant file is read.
"""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Sequence
from fractions import Fraction

from coursework.system.frozen import frozen
from coursework.variant.dimensions.exponents import NUMBER, TIME, Dimension, System, added, dimension_of, is_known
from coursework.variant.formula.tree import Formula, constant, factors, terms

_SUMS = {"+", "-", "neg"}
_PRODUCTS = {"*", "/"}


@frozen
class Term:
    """A part of a formula and its dimension, None for a part of numbers only, which fits any dimension."""

    tree: Formula
    dimension: Dimension | None


class Clash(Exception):
    """Two dimensions that cannot be equal.

    `kind` is "terms" (added, compared or paired), "argument" (of a function, or the angle after @) or "place" (its place in the
    file requires another dimension).  `first` and `second` are the two parts; for "argument", `first` is the whole call.
    """

    def __init__(self, kind: str, first: Term, second: Term) -> None:
        super().__init__(kind)
        self.kind = kind
        self.first = first
        self.second = second


@frozen
class Factor:
    """A number that multiplies a `term`; `key` is the unknown for the dimension that the number must have."""

    key: Hashable
    tree: Formula
    term: Formula


class Measurer:
    """Measures formulas one after the other; what one formula reveals about a name holds for the next ones.

    `names` maps every name to its dimension; `measured` are the data with a unit.  In a product with one of these, a number is a
    plain number; in other products it takes the dimension that is needed.
    """

    def __init__(self, names: dict[str, Dimension], measured: frozenset[str]) -> None:
        self.names = names
        self.measured = measured
        self.system = System()
        self.factors: list[Factor] = []
        self.times_as_angles: list[Formula] = []
        self.lenient = False
        self._fresh = itertools.count()

    def measure(self, tree: Formula) -> Term:
        """Return the dimension of a formula.  Raises `Clash`."""
        self.lenient = _is_of_time_alone(tree)
        found = Term(tree, self._measure(tree)[0])
        return Term(tree, None) if self.lenient else found

    def compare(self, kind: str, first: Term, second: Term) -> None:
        """Require two parts to have the same dimension.  Raises `Clash`."""
        if first.dimension is None or second.dimension is None or self.lenient:
            return
        if not self.system.equal(first.dimension, second.dimension):
            raise Clash(kind, first, second)

    def fresh(self) -> Hashable:
        """Return the key of a new unknown."""
        return next(self._fresh)

    def _measure(self, tree: Formula) -> tuple[Dimension | None, bool]:
        """Return the dimension, and whether a datum with a unit occurs (outside the arguments of sin and the like)."""
        op = tree.op
        if op == "name":
            return self._name(tree.name), tree.name in self.measured
        if op == "number":
            return (dimension_of(tree.si), True) if tree.si else (None, False)
        if op in _SUMS or op == "pair":
            return self._alike([*terms(tree)] if op in _SUMS else tree.args)
        if op in _PRODUCTS:
            return self._product(tree)
        if op == "^":
            base, has = self._measure(tree.args[0])
            power = constant(tree.args[1]) or 0
            return (None if base is None else added(NUMBER, base, power.numerator if power.denominator == 1 else power)), has
        if op == "@":
            self._require_angle(tree, tree.args[1])
        return self._call(tree) if op == "call" else self._measure(tree.args[0])

    def _name(self, name: str) -> Dimension:
        if name not in self.names:  # not declared: reported elsewhere
            self.names[name] = {self.fresh(): 1}
        return self.names[name]

    def _alike(self, trees: Sequence[Formula]) -> tuple[Dimension | None, bool]:
        first: Term | None = None
        any_measured = False
        for tree in trees:
            dimension, has = self._measure(tree)
            any_measured |= has
            if dimension is None:
                continue
            term = Term(tree, dimension)
            if first is None:
                first = term
            else:
                self.compare("terms", first, term)
        return (first.dimension if first else None), any_measured

    def _product(self, tree: Formula) -> tuple[Dimension | None, bool]:
        total: Dimension = NUMBER
        numbers: list[Formula] = []
        any_measured = others = False
        for factor, power in factors(tree, _PRODUCTS):
            dimension, has = self._measure(factor)
            any_measured |= has
            if dimension is None:
                numbers.append(factor)
            else:
                total = added(total, dimension, power)
                others |= factor.op != "name" or factor.name != "pi"
        if numbers and not others:
            return None, any_measured
        if numbers and not any_measured:
            self.factors.append(Factor(self.fresh(), numbers[0], tree))
            total = added(total, {self.factors[-1].key: 1})
        return total, any_measured

    def _call(self, tree: Formula) -> tuple[Dimension | None, bool]:
        if tree.name == "atan2":
            self._alike(tree.args)
            return NUMBER, False
        if tree.name in {"abs", "sqrt"}:
            inner, has = self._measure(tree.args[0])
            half = inner if inner is None or tree.name == "abs" else added(NUMBER, inner, _HALF)
            return half, has
        return (NUMBER if self._require_angle(tree, tree.args[0]) else None), False

    def _require_angle(self, whole: Formula, argument: Formula) -> bool:
        """Require the `argument` of `whole` to be an angle; return False if it is a bare number, which fits.  Raises `Clash`."""
        outer, self.lenient = self.lenient, _is_of_time_alone(argument)
        dimension, _ = self._measure(argument)
        lenient, self.lenient = self.lenient, outer
        if dimension is None:
            return False
        found = self.system.reduced(dimension)
        bare = any(term.op == "name" and term.name == "t" for term in terms(argument))
        if found and is_known(found) and (lenient or (bare and found == {TIME: 1})):
            self.times_as_angles.append(whole)
        elif not self.system.equal(dimension, NUMBER):
            raise Clash("argument", Term(whole, dimension), Term(argument, NUMBER))
        return True


_HALF = Fraction(1, 2)


def _is_of_time_alone(tree: Formula) -> bool:
    # In "1 + t + t^2/2" each term has a factor with a unit, and factors of 1 are not written.
    return {*tree.names()} <= {"t", "pi"} and not any(node.si for node in tree.walk())
