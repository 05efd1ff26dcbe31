"""Expressions -> their derivatives, themselves multiplied out or with parts replaced, and the values of those of numbers alone.

Enters: expressions.  Leaves: expressions; a value.  Used by whoever reduces equations.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from coursework.equations.algebra.expression import MINUS, ONE, ZERO, Expression, add, multiply, node, number, power
from coursework.equations.algebra.functions import call, cosine, sine


def rebuilt(part: Expression, args: tuple[Expression, ...]) -> Expression:
    """Return an expression of the same kind with other arguments, in canonical form."""
    match part.op:
        case "+":
            return add(*args)
        case "*":
            return multiply(*args)
        case "^":
            return power(*args)
        case "piecewise":
            return piecewise(*args)
    return call(part.op, *args)


def piecewise(time: Expression, *parts: Expression) -> Expression:
    """Return what is a piece until the time after it, and so on, the last for ever; pieces alike that meet are one."""
    kept = [parts[-1]]
    for piece, end in zip(parts[-3::-2], parts[-2::-2], strict=True):
        if piece is not kept[0]:
            kept = [piece, end, *kept]
    return node("piecewise", (time, *kept)) if len(kept) > 1 else kept[0]


def replaced(part: Expression, by: Mapping[Expression, Expression]) -> Expression:
    """Return an expression with parts replaced."""
    done = dict(by)

    def changed(one: Expression) -> Expression:
        if one not in done:
            args = tuple(changed(arg) for arg in one.args)
            done[one] = one if args == one.args else rebuilt(one, args)
        return done[one]

    return changed(part)


@lru_cache(maxsize=4096)
def derivative(part: Expression, by: Expression) -> Expression:
    """Return the derivative of an expression by a symbol."""
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
            return multiply(part, derivative(base, by) * exponent / base)
        case "piecewise":
            time, *parts = part.args
            return piecewise(time, *[one if k % 2 else derivative(one, by) for k, one in enumerate(parts)])
    inner = [(place, derivative(arg, by)) for place, arg in enumerate(part.args)]
    return add(*[_slope(part, place) * slope for place, slope in inner if slope is not ZERO])


def _slope(part: Expression, place: int) -> Expression:
    """Return the derivative of a function by one of its arguments."""
    first = part.args[0]
    match part.op:
        case "sin":
            return cosine(first)
        case "cos":
            return -sine(first)
        case "tan":
            return part**2 + 1
        case "cot":
            return -1 - part**2
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
            return ZERO  # but at the jump itself
    return table(part, 1)


def table(law: Expression, more: int) -> Expression:
    """Return the derivative, `more` times, of a tabulated law by its argument: `_table_r_0` has the derivatives `_table_r_1` …"""
    stem, _, order = law.op.rpartition("_")
    return node(f"{stem}_{int(order) + more}", law.args)


def expand(part: Expression) -> Expression:
    """Return an expression multiplied out, inside functions and below fractions, too."""
    before = None
    while part is not before:
        before, part = part, _expanded(part)
    return part


def _expanded(part: Expression) -> Expression:
    args = tuple(map(_expanded, part.args))
    part = part if args == part.args else rebuilt(part, args)
    match part.op:
        case "^":
            return _expanded_power(*part.args)
        case "*":
            return _expanded_product(part)
        case "exp" if part.args[0].op == "+":
            return multiply(*[call("exp", term) for term in part.args[0].args])
    return part


def _expanded_power(base: Expression, exponent: Expression) -> Expression:
    by = exponent.value
    if base.op != "+" or abs(by) <= 1:
        return power(base, exponent)
    if by < 0:
        return 1 / _expanded_power(base, -exponent)
    total: Expression = ONE
    for _ in range(int(by)):
        total = add(*[multiply(one, other) for one in total.terms for other in base.args])
    left = power(base, number(by - int(by)))
    return add(*[multiply(term, left) for term in total.terms])


def _expanded_product(part: Expression) -> Expression:
    above, below = fraction(part)
    if below.op == "*":
        above, below = (_expanded_product(one) if one.op == "*" else one for one in (above, below))
    part = above / below
    sums = [factor for factor in part.factors if factor.op == "+"]
    if part.op != "*" or not sums:
        return part
    terms = [multiply(*[factor for factor in part.args if factor.op != "+"])]
    for one in sums:
        terms = [multiply(term, other) for term in terms for other in one.args]
    return add(*[_expanded_product(term) if any(f.op == "+" for f in term.args) and term.op == "*" else term for term in terms])


def fraction(part: Expression) -> tuple[Expression, Expression]:
    """Return what stands above and below in a product."""
    above, below = [], []
    for factor in part.factors:
        if factor.op == "^" and factor.args[1].is_negative:
            below.append(power(factor.args[0], -factor.args[1]))
        elif factor.op == "exp" and factor.args[0].factors[0].is_negative:
            below.append(call("exp", -factor.args[0]))
        elif factor.op == "number":
            above.append(number(factor.value.numerator))
            below.append(number(factor.value.denominator))
        else:
            above.append(factor)
    return multiply(*above), multiply(*below)


def together(part: Expression) -> tuple[Expression, Expression]:
    """Return what stands above and below when all terms are brought to one denominator."""
    if part.op == "*":
        sides = [together(factor) for factor in part.args]
        return fraction(multiply(*[above for above, _ in sides], *[power(below, MINUS) for _, below in sides]))
    if part.op == "^":
        (above, below), exponent = together(part.args[0]), part.args[1]
        if exponent.value.denominator > 1 and below.op != "number":
            return fraction(power(above / below, exponent))
        return fraction(multiply(power(above, exponent), power(below, -exponent)))
    if part.op != "+":
        return fraction(part)
    sides = [together(term) for term in part.args]
    number_below, divisors = 1, dict[Expression, Fraction]()
    for _, below in sides:
        content, factors = _whole(below)
        number_below = math.lcm(number_below, content.numerator)
        for base, times in factors.items():
            divisors[base] = max(divisors.get(base, times), times)
    common = [number(number_below), *[power(base, number(times)) for base, times in divisors.items()]]
    above = add(*[multiply(over, *common, *_below_one(below)) for over, below in sides])
    both = number(math.gcd(number_below, _content(above).numerator))
    return above / both, multiply(1 / both, *common)


def _whole(product: Expression) -> tuple[Fraction, dict[Expression, Fraction]]:
    """Return the number in a product and the powers of its factors, sums without a common divisor of their numbers."""
    total, powers = Fraction(1), dict[Expression, Fraction]()
    for factor in product.factors:
        base, exponent = factor.base_and_power
        if base.op == "number" and exponent is ONE:
            total *= base.value
            continue
        if base.op == "+" and exponent.value.denominator == 1:
            content = _content(base)
            base, total = base / number(content), total * content**exponent.value.numerator
        powers[base] = powers.get(base, Fraction(0)) + exponent.value
    return total, powers


def _content(part: Expression) -> Fraction:
    """Return the largest number that divides every term."""
    sizes = [abs(_whole(term)[0]) for term in part.terms]
    return Fraction(math.gcd(*(size.numerator for size in sizes)), math.lcm(*(size.denominator for size in sizes)))


def _below_one(below: Expression) -> list[Expression]:
    """Return the factors of 1/below, as `_whole` takes it apart."""
    content, factors = _whole(below)
    return [number(1 / content), *[power(base, number(-exponent)) for base, exponent in factors.items()]]


def operations(part: Expression) -> int:
    """Return how many operations an expression has, written out; a minus within a sum is none of its own."""
    counted: dict[Expression, int] = {}

    def count(one: Expression) -> int:
        if one not in counted:
            inside, times = sum(map(count, one.args)), one.split()[0]
            match one.op:
                case "number":
                    counted[one] = (times < 0) + (times.denominator > 1)
                case "+":
                    minus = sum(term.split()[0] < 0 for term in one.args)
                    counted[one] = inside + len(one.args) - 1 - minus + (minus == len(one.args))
                case "*":
                    counted[one] = inside + len(one.args) - 1 - (abs(times.numerator) == 1 != times)
                case "^":
                    counted[one] = inside + 1 - one.args[1].is_negative - (one.args[1] is MINUS)
                case _:
                    counted[one] = inside + bool(one.args)
        return counted[one]

    return count(part)
