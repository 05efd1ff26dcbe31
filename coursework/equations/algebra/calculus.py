"""Calculus on expressions: derivatives, expansion, replacement of parts, common denominators.

Enters: expressions.  Leaves: expressions.  Used by whoever reduces equations.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache

from coursework.equations.algebra.expression import ONE, ZERO, Expression, add, multiply, node, number, power
from coursework.equations.algebra.functions import call, cosine, sine


def rebuilt(part: Expression, args: tuple[Expression, ...]) -> Expression:
    """Return an expression of the same kind with other arguments, in canonical form."""
    match part.op:
        case "+":
            return add(*args)
        case "*":
            return multiply(*args)
        case "^":
            return power(args[0], args[1].value)
        case "piecewise":
            return piecewise(*args)
    return call(part.op, *args)


def piecewise(time: Expression, *parts: Expression) -> Expression:
    """Return a piecewise expression: each piece applies until the time after it, the last for ever; equal neighbours merge."""
    kept = [parts[-1]]
    for piece, end in zip(parts[-3::-2], parts[-2::-2], strict=True):
        if piece is not kept[0]:
            kept = [piece, end, *kept]
    return node("piecewise", (time, *kept)) if len(kept) > 1 else kept[0]


def replaced(part: Expression, by: Mapping[Expression, Expression]) -> Expression:
    """Return an expression in which each key of `by` is replaced by its value."""
    done = dict(by)

    def changed(one: Expression) -> Expression:
        if one not in done:
            args = tuple(changed(arg) for arg in one.args)
            done[one] = one if args == one.args else rebuilt(one, args)
        return done[one]

    return changed(part)


@lru_cache(maxsize=4096)
def derivative(part: Expression, by: Expression) -> Expression:
    """Return the derivative of an expression with respect to a symbol."""
    if by not in part.free_symbols:
        return ZERO
    match part.op:
        case "symbol":
            return ONE
        case "+":
            return add(*[derivative(term, by) for term in part.args])
        case "*":
            slopes = [(place, derivative(factor, by)) for place, factor in enumerate(part.args)]
            return add(*[multiply(*part.args[:k], slope, *part.args[k + 1 :]) for k, slope in slopes if slope is not ZERO])
        case "^":
            base, exponent = part.args
            return multiply(exponent, power(base, exponent.value - 1), derivative(base, by))
        case "piecewise":
            time, *parts = part.args
            return piecewise(time, *[one if k % 2 else derivative(one, by) for k, one in enumerate(parts)])
    inner = [(place, derivative(arg, by)) for place, arg in enumerate(part.args)]
    return add(*[_slope(part, place) * slope for place, slope in inner if slope is not ZERO])


def _slope(part: Expression, place: int) -> Expression:
    """Return the derivative of a function with respect to its argument number `place`."""
    first = part.args[0]
    match part.op:
        case "sin":
            return cosine(first)
        case "cos":
            return -sine(first)
        case "tan":
            return part**2 + 1
        case "asin" | "acos":
            slope = 1 / call("sqrt", 1 - first**2)
            return slope if part.op == "asin" else -slope
        case "atan":
            return 1 / (1 + first**2)
        case "atan2":
            square = first**2 + part.args[1] ** 2
            return part.args[1] / square if place == 0 else -first / square
        case "exp":
            return part
        case "log":
            return 1 / first
        case "abs":
            return call("sign", first)
        case "sign":
            return ZERO  # except at the jump itself
    return table(part, 1)


def table(law: Expression, more: int) -> Expression:
    """Return the derivative of order `more` of a tabulated law by its argument: `_table_r_0` has `_table_r_1`, `_table_r_2`."""
    stem, _, order = law.op.rpartition("_")
    return node(f"{stem}_{int(order) + more}", law.args)


def expand(part: Expression) -> Expression:
    """Return an expression multiplied out, also inside functions and in denominators."""
    before = None
    while part is not before:
        before, part = part, _expanded(part)
    return part


def _expanded(part: Expression) -> Expression:
    args = tuple(map(_expanded, part.args))
    if part.op == "^" and args[0].op == "+" and abs(args[1].value) > 1 == args[1].value.denominator:
        factors = [args[0]] * abs(args[1].value.numerator)
    elif part.op == "*":
        factors = list(args)
    else:
        return part if args == part.args else rebuilt(part, args)
    total: Expression = ONE
    for factor in factors:
        total = add(*[multiply(one, other) for one in total.terms for other in factor.terms])
    return 1 / total if part.op == "^" and part.args[1].is_negative else total


def together(part: Expression) -> tuple[Expression, Expression]:
    """Return numerator and denominator of an expression with all terms over one denominator."""
    above, below = _sides(part)
    return above, multiply(*[power(base, by) for base, by in below.items()])


def without_denominators(parts: Sequence[Expression], about: frozenset[Expression]) -> list[Expression]:
    """Return expressions multiplied by the least denominator of them all, as far as it depends on `about`; tan is sin/cos.

    Roots and squares stay below: the zero of a square does not tell on which side of it a motion is.
    """
    fractions = [together(_by_sines(part, about)) for part in parts]
    sides = [_sides(above / below) for above, below in fractions]  # what stands above and below is gone
    common: dict[Expression, Fraction] = {}
    for _, below in sides:
        common |= {base: max(by, common.get(base, by)) for base, by in below.items() if not about.isdisjoint(base.free_symbols)}
    common = {base: by for base, by in common.items() if by == 1}
    if not common:
        return list(parts)
    return [
        multiply(above, *[power(base, common.get(base, Fraction(0)) - below.get(base, 0)) for base in {**common, **below}])
        for above, below in sides
    ]


def divisors(part: Expression) -> list[Expression]:
    """Return by what an expression divides, in any part of it; a tangent divides by its cosine.

    A divisor that stands below another, as a in 1/(1/a) or the cosine in 1/tan, makes that one infinite: nothing is divided by 0.
    """
    found: dict[Expression, None] = {}
    ahead, seen = [(part, False)], {(part, False)}
    while ahead:
        one, is_below = ahead.pop()
        divides = one.op == "^" and one.args[1].is_negative
        if not is_below and (divides or one.op == "tan"):
            found[cosine(one.args[0]) if one.op == "tan" else one.args[0]] = None
        inside = not is_below if divides else is_below and one.op in {"+", "*", "^"}
        inner = [(each, inside) for each in reversed(one.args) if (each, inside) not in seen]
        seen.update(inner)
        ahead += inner
    return [*found]


def _by_sines(part: Expression, about: frozenset[Expression]) -> Expression:
    """Return an expression in which no tangent depends on `about`."""
    if about.isdisjoint(part.free_symbols) or not part.args:
        return part
    args = tuple(_by_sines(arg, about) for arg in part.args)
    if part.op == "tan":
        return sine(args[0]) / cosine(args[0])
    return part if args == part.args else rebuilt(part, args)


def _sides(part: Expression) -> tuple[Expression, dict[Expression, Fraction]]:
    """Return the numerator, and the denominator as powers of bases that are not numbers."""
    if part.op == "+":
        sides = [_sides(term) for term in part.args]
        common: dict[Expression, Fraction] = {}
        for _, below in sides:
            common |= {base: max(by, common.get(base, by)) for base, by in below.items()}
        lacking = [[power(base, by - below.get(base, 0)) for base, by in common.items()] for _, below in sides]
        return add(*[multiply(above, *more) for (above, _), more in zip(sides, lacking, strict=True)]), common
    above, powers = list[Expression](), dict[Expression, Fraction]()
    for factor in part.factors:
        base, by = factor.base_and_power
        over, under = _sides(base) if base.op == "+" and by.denominator == 1 else (base, {})
        if by > 0:
            above.append(power(over, by))
        else:  # the denominator 2 a + 2 b is written as a + b, its 2 goes into the numerator
            whole = content(term.split()[0] for term in over.terms)
            above.append(power(number(whole), by))
            parts = [one.base_and_power for one in (over / number(whole)).factors]
            powers |= {one: powers.get(one, Fraction(0)) - by * times for one, times in parts}
        for one, times in under.items():
            powers[one] = powers.get(one, Fraction(0)) + by * times
    upward = [power(one, -times) for one, times in powers.items() if times < 0]
    return multiply(*above, *upward), {one: times for one, times in powers.items() if times > 0}


def content(numbers: Iterable[Fraction]) -> Fraction:
    """Return the largest number that divides all `numbers`."""
    found = list(numbers)
    return Fraction(math.gcd(*(one.numerator for one in found)), math.lcm(*(one.denominator for one in found)))
