"""The addition theorems: cos a cos b + sin a sin b -> cos(a - b), and the three similar ones.

Enters: terms of a sum.  Leaves: fewer terms with the same sum.  Used by `tidy.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import combinations

from coursework.equations.algebra.expression import ZERO, Expression, multiply, number, power
from coursework.equations.algebra.functions import cosine, sine

Rank = Callable[[Expression], tuple[int, ...]]
Angles = list[tuple[str, Expression]]


def pair_angles(terms: list[Expression], rank: Rank) -> list[Expression]:
    """Join pairs of terms until no pair is left; `rank` gives the place of a function in the author's order."""
    turning = [k for k, term in enumerate(terms) if len(_angles(term)) > 1]
    for i, j in combinations(turning, 2):
        if (joined := _join(terms[i], terms[j], rank)) is not None:
            left = [term for k, term in enumerate(terms) if k not in {i, j}]
            return pair_angles([*left, joined] if joined is not ZERO else left, rank)
    return terms


def common(terms: Sequence[Expression], *, divisors: bool = False) -> Expression:
    """Return the factors that all terms share, without numbers; with `divisors`, also every divisor that any term has."""
    powers = [dict(factor.base_and_power for factor in term.split()[1].factors) for term in terms]
    bases = dict.fromkeys(base for own in powers for base in own if divisors or all(base in other for other in powers))
    least = {base: min(own.get(base, Fraction(0)) for own in powers) for base in bases}
    return multiply(*[power(base, by) for base, by in least.items()])


def _join(first: Expression, second: Expression, rank: Rank) -> Expression | None:
    (p, a), (q, b) = first.split(), second.split()
    if abs(p) != abs(q):
        return None
    # A divisor of one term only counts as a factor of the other.
    shared = common([a, b], divisors=True)
    only_a, only_b = a / shared, b / shared
    if any(sum(factor.base_and_power[1] for factor in part.factors) != 2 for part in (only_a, only_b)):
        return None
    trig_a, trig_b = _angles(only_a), _angles(only_b)
    if len(trig_a) != 2 or len(trig_b) != 2:
        return None
    merged = _addition(trig_a, trig_b, p, q, rank)
    return None if merged is None else multiply(merged, shared)


def _angles(part: Expression) -> Angles:
    """Return ("sin" or "cos", angle) for each such factor of a product."""
    powers = [factor.base_and_power for factor in part.factors]
    return [(base.op, base.args[0]) for base, by in powers if base.op in {"sin", "cos"} for _ in range(int(by))]


def _addition(a: Angles, b: Angles, p: Fraction, q: Fraction, rank: Rank) -> Expression | None:
    angles = sorted({angle for _, angle in a}, key=lambda x: rank(cosine(x)))
    if {angle for _, angle in b} != set(angles):
        return None
    x, y = angles if len(angles) == 2 else (angles[0], angles[0])
    kinds = {"".join(sorted(kind for kind, _ in part)) for part in (a, b)}
    if kinds == {"coscos", "sinsin"}:
        cosines = p if a[0][0] == a[1][0] == "cos" else q
        return number(cosines) * (cosine(x - y) if p == q else cosine(x + y))
    # What both share is taken out, so they are sin x cos y and cos x sin y.
    leading = p if ("sin", x) in a else q
    return number(leading) * (sine(x + y) if p == q else sine(x - y))
