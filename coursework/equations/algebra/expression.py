"""One immutable expression: numbers, symbols, sums, products, powers and functions, each always in the same canonical form.

Enters: parts, by `number`, `variable`, `add`, `multiply`, `power` and `node`.  Leaves: `Expression`; equal ones are one object.
Used by `functions.py`, `calculus.py`, `symbolic_objects.py` and whoever reads the kind of an expression.

A sum has its number first and no two terms alike; a product has its number first, no two factors with the same base, and a
number times a sum alone is multiplied out.  Order, and what is done at once, are SymPy's: it is the judge in the tests.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any
from weakref import WeakValueDictionary

from coursework.equations.algebra.roots import Primes, gather, roots
from coursework.equations.algebra.tree import Tree, has_minus, is_nonnegative, value

Number = int | Fraction


class Expression(Tree):
    """A tree that one can calculate with."""

    __slots__ = ()

    def __reduce__(self) -> tuple[Callable[..., Expression], tuple[Any, ...]]:
        return node, (self.op, self.args, self.name, self.value)

    def split(self) -> tuple[Fraction, Expression]:
        """Return the number before an expression and the rest."""
        if self.op == "number":
            return self.value, ONE
        if self.op == "*" and self.args[0].op == "number":
            rest = self.args[1:]
            return self.args[0].value, rest[0] if len(rest) == 1 else node("*", rest)
        return _ONE, self

    @property
    def base_and_power(self) -> tuple[Expression, Expression]:
        """Return base and exponent, the exponent 1 of what is no power."""
        return (self.args[0], self.args[1]) if self.op == "^" else (self, ONE)

    def __add__(self, other: Expression | Number) -> Expression:
        return add(self, as_expression(other))

    __radd__ = __add__

    def __neg__(self) -> Expression:
        return multiply(MINUS, self)

    def __sub__(self, other: Expression | Number) -> Expression:
        return add(self, -as_expression(other))

    def __rsub__(self, other: Number) -> Expression:
        return add(number(other), -self)

    def __mul__(self, other: Expression | Number) -> Expression:
        return multiply(self, as_expression(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Expression | Number) -> Expression:
        return multiply(self, power(as_expression(other), MINUS))

    def __rtruediv__(self, other: Number) -> Expression:
        return multiply(number(other), power(self, MINUS))

    def __pow__(self, other: Expression | Number) -> Expression:
        return power(self, as_expression(other))


_ONE, _ZERO = Fraction(1), Fraction(0)
_known: WeakValueDictionary[tuple[object, ...], Expression] = WeakValueDictionary()


def node(op: str, args: tuple[Expression, ...] = (), name: str = "", value: Fraction = _ZERO) -> Expression:
    """Return the one expression of a kind with these arguments, as they are."""
    key = (op, value) if op == "number" else (op, args, name)  # fractions are slow to hash
    found = _known.get(key)
    return _known.setdefault(key, Expression(op, args, name, value)) if found is None else found


def number(value: Number) -> Expression:
    """Return a number."""
    return node("number", value=value if type(value) is Fraction else Fraction(value))


def variable(name: str) -> Expression:
    """Return a symbol, which stands for a real number."""
    return node("symbol", name=name)


def as_expression(value: Expression | Number) -> Expression:
    """Return an expression as it is, a number as one."""
    return value if isinstance(value, Expression) else number(value)


ZERO, ONE, MINUS, HALF, PI = number(0), number(1), number(-1), number(Fraction(1, 2)), node("pi")
_E = node("e")
POLE = node("^", (ZERO, MINUS))  # what has no value, whatever the motion


def add(*terms: Expression) -> Expression:
    """Return a sum."""
    total, found, waiting = _ZERO, dict[Expression, Fraction](), list(terms)
    for term in waiting:  # grows
        if term.op == "+":
            waiting.extend(term.args)
        elif term.op == "number":
            total = total + term.value if total else term.value
        else:
            factor, rest = term.split()
            found[rest] = found[rest] + factor if rest in found else factor
    parts = [rest if factor is _ONE or factor == 1 else _times(factor, rest) for rest, factor in found.items() if factor]
    parts.sort()
    if total:
        parts.insert(0, number(total))
    return node("+", tuple(parts)) if len(parts) > 1 else parts[0] if parts else ZERO


def _times(factor: Fraction, rest: Expression) -> Expression:
    return node("*", (number(factor), *rest.factors))


def multiply(*factors: Expression) -> Expression:
    """Return a product."""
    total, waiting = _ONE, list(factors)
    powers: dict[tuple[Expression, Expression], Fraction] = {}
    primes: Primes = {}
    for factor in waiting:  # grows
        if factor.op == "*":
            waiting.extend(factor.args)
        elif factor.op == "number":
            total = factor.value if total is _ONE else total * factor.value
        elif factor.op == "^" and factor.args[0].value > 0:
            gather(primes, factor.args[0].value, factor.args[1].value)
        else:
            # exp(2 x) exp(x) is exp(3 x), as of any other base.
            base, exponent = (_E, factor.args[0]) if factor.op == "exp" else factor.base_and_power
            times, tail = exponent.split()
            powers[base, tail] = powers[base, tail] + times if (base, tail) in powers else times
    if not total:
        return ZERO
    parts: list[Expression] = []
    if primes:
        total, parts = _with_roots(total, primes)
    changed = False
    for (base, tail), times in powers.items():
        plain = tail is ONE and base is not _E and (times is _ONE or times == 1)
        part = base if plain else power(base, multiply(number(times), tail))
        # What is a power no more, or one of another base, may meet its like.
        changed |= part.op in {"*", "number"} or (base is not _E and len(powers) > 1 and part.base_and_power[0] != base)
        parts.append(part)
    if changed:
        return multiply(number(total), *parts)
    parts.sort()
    if total is not _ONE and total != 1:
        if len(parts) == 1 and parts[0].op == "+":
            return add(*[multiply(number(total), term) for term in parts[0].args])
        parts.insert(0, number(total))
    return node("*", tuple(parts)) if len(parts) > 1 else parts[0] if parts else ONE


def _with_roots(total: Fraction, primes: Primes) -> tuple[Fraction, list[Expression]]:
    """Return a number times what is rational of a product of powers of primes, and the roots that are left."""
    whole, left = roots(primes)
    return total * whole, [node("^", (number(base), number(exponent))) for exponent, base in left.items()]


def power(base: Expression, exponent: Expression) -> Expression:
    """Return a power; its exponent is a number, or its base e."""
    if base is _E:
        return node("exp", (exponent,)) if exponent is not ZERO else ONE
    by = exponent.value
    if by == 0 or base is ONE:
        return ONE
    if by == 1:
        return base
    match base.op:
        case "number":
            return _power_of_number(base, by)
        case "*":
            return _power_of_product(base, by)
        case "^":
            inner, first = base.args[0], base.args[1].value
            even = first.denominator == 1 and first.numerator % 2 == 0
            if by.denominator == 1 or even or abs(first) < 1 or is_nonnegative(inner):
                return power(absolute(inner) if even and by.denominator > 1 else inner, number(first * by))
        case "abs" if by.denominator == 1 and by != -1:
            return power(base.args[0], exponent) if by % 2 == 0 else multiply(power(base.args[0], number(by - 1)), base)
        case "exp":
            return node("exp", (multiply(base.args[0], exponent),))
    return node("^", (base, exponent))


def _power_of_number(base: Expression, by: Fraction) -> Expression:
    if by.denominator == 1 and (base.value or by > 0):
        return number(base.value**by.numerator)
    if base.value <= 0:
        return ZERO if not base.value and by > 0 else POLE if not base.value else node("^", (base, number(by)))
    primes: Primes = {}
    gather(primes, base.value, by)
    total, left = _with_roots(_ONE, primes)
    return left[0] if total == 1 and len(left) == 1 else multiply(number(total), *left)


def _power_of_product(base: Expression, by: Fraction) -> Expression:
    exponent = number(by)
    if by.denominator == 1:
        return multiply(*[power(factor, exponent) for factor in base.args])
    # Of a root only what is not negative comes out.
    outside = [factor for factor in base.args if is_nonnegative(factor)]
    inside = [factor for factor in base.args if not is_nonnegative(factor)]
    if base.args[0].is_negative and base.args[0] is not MINUS:
        outside.append(-base.args[0])
        inside[0] = MINUS
    if not outside:
        return node("^", (base, exponent))
    rest = multiply(*inside)
    left = [node("^", (rest, exponent))] if rest.op in {"*", "number"} and rest is not ONE else [power(rest, exponent)]
    return multiply(*[power(factor, exponent) for factor in outside], *left)


def absolute(part: Expression) -> Expression:
    """Return the absolute value of an expression."""
    if is_nonnegative(part) or (not part.free_symbols and value(part) < 0):
        return part if is_nonnegative(part) else -part
    if part.op == "*":
        # x/y stays together below the bars, as x y does; what is known of a factor comes out.
        inside = [one for one in part.args if absolute(power(*_upright(one))).op == "abs"]
        known = [absolute(one) for one in part.args if one not in inside]
        return multiply(*known, node("abs", (multiply(*inside),))) if inside else multiply(*known)
    if part.op == "^" and part.args[1].value.denominator == 1:
        return power(absolute(part.args[0]), part.args[1])
    return node("abs", (-part if part.op == "+" and has_minus(part) else part,))


def _upright(part: Expression) -> tuple[Expression, Expression]:
    base, exponent = part.base_and_power
    return base, -exponent if exponent.is_negative else exponent
