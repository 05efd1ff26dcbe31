"""Functions of expressions with immediate simplification: sin(-x) = -sin x, cos(x + pi/2) = -sin x, sin(asin x) = x.

Enters: the name of a function and its arguments.  Leaves: an `Expression`.  Used by `calculus.py` and `symbolic.py`.
"""

from __future__ import annotations

from fractions import Fraction

from coursework.equations.algebra.expression import HALF, ONE, PI, ZERO, Expression, absolute, node, number, power, value

_ODD = {"sin", "tan", "asin", "atan", "sign"}
# Sines of multiples of pi that are square roots of a rational number: angle / pi -> its sine squared.
_SINES = {Fraction(part, 12): Fraction(square, 4) for part, square in ((0, 0), (2, 1), (3, 2), (4, 3), (6, 4))}


def call(name: str, *args: Expression) -> Expression:
    """Return a function of expressions, simplified where possible."""
    first = args[0]
    match name:
        case "sqrt":
            return power(first, HALF.value)
        case "abs":
            return absolute(first)
        case "exp" | "log" if first.op == {"exp": "log", "log": "exp"}[name]:
            return first.args[0]
        case "exp" if first is ZERO:
            return ONE
        case "log" if first is ONE:
            return ZERO
        case "sign" if not first.free_symbols:
            size = value(first)
            return number((size > 0) - (size < 0))
        case "sign" if first.op == "*":
            times, rest = first.split()
            return node(name, (rest,)) if times > 0 else -node(name, (rest,))
    if first is ZERO and name in _ODD:
        return ZERO
    if first.has_minus and (name in _ODD or name == "cos"):
        return call(name, -first) if name == "cos" else -call(name, -first)
    found = _of_angle(name, first) if name in {"sin", "cos", "tan"} else None
    return node(name, args) if found is None else found


def sine(angle: Expression) -> Expression:
    """Return the sine of an angle."""
    return call("sin", angle)


def cosine(angle: Expression) -> Expression:
    """Return the cosine of an angle."""
    return call("cos", angle)


def _of_angle(name: str, angle: Expression) -> Expression | None:
    """Return a simpler form of a trigonometric function of an angle, None if there is none."""
    part = sum((factor for factor, rest in map(Expression.split, angle.terms) if rest is PI), Fraction(0))
    quarters = part // HALF.value
    if quarters:
        rest = angle - PI * Fraction(quarters, 2)
        other = {"sin": cosine, "cos": sine}.get(name)
        if other is None:
            return call(name, rest) if quarters % 2 == 0 else -1 / call(name, rest)
        sign = -1 if quarters % 4 in ({2, 3} if name == "sin" else {1, 2}) else 1
        return sign * (other(rest) if quarters % 2 else call(name, rest))
    if angle == PI * part:
        square = _SINES.get(HALF.value - part if name == "cos" else part)
        return None if square is None else power(number(square / (1 - square) if name == "tan" else square), HALF.value)
    return _of_inverse(name, angle)


def _of_inverse(name: str, angle: Expression) -> Expression | None:
    """Return a trigonometric function of an inverse one, from the sides of a right triangle; None for any other angle."""
    x = angle.args[0] if angle.args else ONE
    match angle.op:
        case "asin":
            opposite, adjacent, long = x, call("sqrt", 1 - x**2), ONE
        case "acos":
            opposite, adjacent, long = call("sqrt", 1 - x**2), x, ONE
        case "atan":
            opposite, adjacent, long = x, ONE, call("sqrt", 1 + x**2)
        case "atan2":
            opposite, adjacent, long = x, angle.args[1], call("sqrt", x**2 + angle.args[1] ** 2)
        case _:
            return None
    return {"sin": opposite, "cos": adjacent, "tan": opposite}[name] / (adjacent if name == "tan" else long)
