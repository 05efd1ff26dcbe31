"""Functions of expressions, with what is known of them at once: sin(-x) = -sin x, cos(x + pi/2) = -sin x, sin(asin x) = x.

Enters: the name of a function and its arguments.  Leaves: an `Expression`.  Used by `calculus.py` and `symbolic.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from coursework.equations.algebra.expression import (
    HALF,
    ONE,
    PI,
    POLE,
    ZERO,
    Expression,
    absolute,
    add,
    multiply,
    node,
    number,
    power,
)
from coursework.equations.algebra.tree import has_minus

_ODD = {"sin", "tan", "cot", "asin", "atan", "sign"}
_TRIGONOMETRIC = {"sin", "cos", "tan", "cot"}
# Sines of parts of pi that are roots of one whole number, by (the angle, its sine squared).
_SINES = {Fraction(part, 12): Fraction(square, 4) for part, square in ((0, 0), (2, 1), (3, 2), (4, 3), (6, 4))}


def call(name: str, *args: Expression) -> Expression:
    """Return a function of expressions."""
    first = args[0]
    match name:
        case "sqrt":
            return power(first, HALF)
        case "abs":
            return absolute(first)
        case "exp" if first is ZERO or first.op == "log":
            return ONE if first is ZERO else first.args[0]
        case "log" if first is ONE or first.op == "exp":
            return ZERO if first is ONE else first.args[0]
    if name in _ODD and has_minus(first):
        return -call(name, -first)
    if name == "cos" and has_minus(first):
        return call(name, -first)
    if first is ZERO and name in _ODD:
        return ZERO
    found = None
    if name in _TRIGONOMETRIC:
        found = _of_angle(name, first)
    elif name == "sign":
        outside = [factor for factor in first.factors if factor.op == "number"]
        found = ONE if first.op == "number" else call(name, multiply(*first.factors[1:])) if outside else None
    return node(name, args) if found is None else found


def sine(angle: Expression) -> Expression:
    """Return the sine of an angle."""
    return call("sin", angle)


def cosine(angle: Expression) -> Expression:
    """Return the cosine of an angle."""
    return call("cos", angle)


def _of_angle(name: str, angle: Expression) -> Expression | None:
    """Return a trigonometric function where more is known of its argument."""
    turned = sum(filter(None, map(_part_of_pi, angle.terms)), Fraction(0))
    if angle is ZERO or _part_of_pi(angle) is not None:
        return _of_part(name, turned)
    quarters = turned // HALF.value
    if angle.op == "+" and quarters:
        rest = add(angle, multiply(number(Fraction(-quarters, 2)), PI))
        return _quarter_turns(name, int(quarters) % 4, rest)
    return _of_inverse(name, angle.op, angle.args)


def _part_of_pi(angle: Expression) -> Fraction | None:
    """Return which part of pi an angle is."""
    factor, rest = angle.split()
    return factor if rest is PI else None


def _quarter_turns(name: str, quarters: int, rest: Expression) -> Expression:
    """Return a function of an angle and a number of right angles."""
    if name in {"tan", "cot"}:
        return call(name, rest) if quarters % 2 == 0 else -call("cot" if name == "tan" else "tan", rest)
    sign = -1 if quarters in ({2, 3} if name == "sin" else {1, 2}) else 1
    other = {"sin": "cos", "cos": "sin"}[name] if quarters % 2 else name
    return sign * call(other, rest)


def _of_part(name: str, part: Fraction) -> Expression | None:
    """Return a function of a part of pi: exactly, or of the smallest angle that gives it, None for that angle itself."""
    if name == "cot":
        return call("tan", multiply(number(HALF.value - part), PI))
    least = part % (1 if name == "tan" else 2)
    if least > 1:
        return -call(name, multiply(number(least - 1), PI))
    if least > HALF.value:
        other = call(name, multiply(number(1 - least), PI))
        return other if name == "sin" else -other
    square = _SINES.get(HALF.value - least if name == "cos" else least)
    if name == "tan" and square is not None:
        return POLE if square == 1 else power(number(square / (1 - square)), HALF)
    if square is not None:
        return power(number(square), HALF)
    return None if least == part else call(name, multiply(number(least), PI))


def _of_inverse(name: str, op: str, args: Sequence[Expression]) -> Expression | None:
    """Return a trigonometric function of an inverse one: of the angle of a right triangle, from its sides."""
    if op == "atan2":
        opposite, adjacent = args
        long = power(opposite**2 + adjacent**2, HALF)
    elif op == "atan":
        opposite, adjacent = args[0], ONE
        long = power(1 + args[0] ** 2, HALF)
    elif op in {"asin", "acos"}:
        other = power(1 - args[0] ** 2, HALF)
        opposite, adjacent = (args[0], other) if op == "asin" else (other, args[0])
        long = ONE
    else:
        return None
    sides = {"sin": (opposite, long), "cos": (adjacent, long), "tan": (opposite, adjacent), "cot": (adjacent, opposite)}
    return sides[name][0] / sides[name][1]
