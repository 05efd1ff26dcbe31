"""Immutable expressions: numbers, symbols, sums, products, powers and functions, each always in the same canonical form.

Enters: parts, by `number`, `variable`, `add`, `multiply`, `power` and `node`.  Leaves: `Expression`; equal ones are one object.
Used by `functions.py`, `calculus.py`, `symbolic_objects.py` and whoever reads the kind of an expression.

A sum has its number first and no two similar terms.  A product has its number first and no two factors with the same base; a
product of only a number and a sum is multiplied out.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any
from weakref import WeakValueDictionary

Number = int | Fraction
# Sort order of the kinds in sums and products; other functions follow by name.
_KINDS = {"pi": 11, "symbol": 13, "^": 15, "*": 16, "+": 17, "abs": 20}
_NUMBERS = {(0, 1): 0, (1, 1): 1, (1, 2): 2, (-1, 1): 5}


class Expression:
    """An expression: `op` is number, symbol, pi, + * ^, piecewise or a function name; a number has a `value`, a symbol a `name`.

    `depth` is the number of levels, `size` the number of nodes, repeated parts counted each time.  The arguments of "piecewise"
    are t, then each piece followed by the time at which it ends, and the last piece, which has no end.
    """

    __slots__ = ("__weakref__", "_free", "_key", "args", "depth", "name", "op", "size", "value")

    def __init__(self, op: str, args: tuple[Expression, ...], name: str, value: Fraction) -> None:
        self.op, self.args, self.name, self.value = op, args, name, value
        self.depth: int = 1 + max([arg.depth for arg in args], default=0)
        self.size: int = 1 + sum([arg.size for arg in args])
        self._free: frozenset[Expression] | None = None
        parts = value.numerator, value.denominator
        kind = _KINDS.get(op, 99) if op != "number" else _NUMBERS.get(parts, 7 + (parts[1] > 1))
        self._key: tuple[Any, ...] = (kind, op, len(args), name, *parts, *[arg._key for arg in args])

    def __repr__(self) -> str:
        own = self.name or (str(self.value) if self.op == "number" else self.op)
        return f"{own}({', '.join(map(repr, self.args))})" if self.args else own

    def __reduce__(self) -> tuple[Callable[..., Expression], tuple[Any, ...]]:
        return node, (self.op, self.args, self.name, self.value)

    @property
    def free_symbols(self) -> frozenset[Expression]:
        """Return every symbol in the expression."""
        if self._free is None:
            own = (self,) if self.op == "symbol" else ()
            self._free = frozenset(own).union(*(arg.free_symbols for arg in self.args))
        return self._free

    def __lt__(self, other: Expression) -> bool:
        return self._key < other._key

    def walk(self) -> Iterator[Expression]:
        """Yield every distinct part once, this expression first."""
        found, met = [self], {self}
        for part in found:  # the list grows during the loop
            yield part
            fresh = [arg for arg in part.args if arg not in met]
            met.update(fresh)
            found += fresh

    def has(self, symbol: Expression) -> bool:
        """Return whether the expression contains a symbol."""
        return symbol in self.free_symbols

    @property
    def terms(self) -> tuple[Expression, ...]:
        """Return the terms of a sum; any other expression is its own single term."""
        return self.args if self.op == "+" else (self,)

    @property
    def factors(self) -> tuple[Expression, ...]:
        """Return the factors of a product; any other expression is its own single factor."""
        return self.args if self.op == "*" else (self,)

    @property
    def is_negative(self) -> bool:
        """Return whether the expression is a number below zero."""
        return self.op == "number" and self.value < 0

    @property
    def has_minus(self) -> bool:
        """Return whether the expression is written with a minus: -x, or a sum in which most terms are, or half with the first."""
        parts = [term.split() for term in self.terms]
        negative = sum(factor < 0 for factor, _ in parts)
        if 2 * negative != len(parts):
            return 2 * negative > len(parts)
        moving = [part for part in parts if part[1].free_symbols] or parts
        return min(moving, key=lambda part: part[1]._key)[0] < 0

    def split(self) -> tuple[Fraction, Expression]:
        """Return the numerical factor of the expression and the rest."""
        if self.op == "number":
            return self.value, ONE
        if self.op == "*" and self.args[0].op == "number":
            rest = self.args[1:]
            return self.args[0].value, rest[0] if len(rest) == 1 else node("*", rest)
        return _ONE, self

    @property
    def base_and_power(self) -> tuple[Expression, Fraction]:
        """Return base and exponent; the exponent is 1 if the expression is no power."""
        return (self.args[0], self.args[1].value) if self.op == "^" else (self, _ONE)

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
        return multiply(self, power(as_expression(other), -1))

    def __rtruediv__(self, other: Number) -> Expression:
        return multiply(number(other), power(self, -1))

    def __pow__(self, exponent: Number) -> Expression:
        return power(self, exponent)


_ONE, _ZERO = Fraction(1), Fraction(0)
_known: WeakValueDictionary[tuple[object, ...], Expression] = WeakValueDictionary()


def node(op: str, args: tuple[Expression, ...] = (), name: str = "", value: Fraction = _ZERO) -> Expression:
    """Return the unique expression with this kind and these arguments, without simplification."""
    # Fractions are slow to hash and to compare.
    key = (op, value.numerator, value.denominator) if op == "number" else (op, args, name)
    found = _known.get(key)
    return _known.setdefault(key, Expression(op, args, name, value)) if found is None else found


def number(value: Number) -> Expression:
    """Return a number."""
    return node("number", value=value if type(value) is Fraction else Fraction(value))


def as_expression(value: Expression | Number) -> Expression:
    """Return an expression unchanged, a number as an expression."""
    return value if isinstance(value, Expression) else number(value)


ZERO, ONE, MINUS, HALF, PI = number(0), number(1), number(-1), number(Fraction(1, 2)), node("pi")
POLE = node("^", (ZERO, MINUS))  # an expression without a value, whatever the motion


def add(*terms: Expression) -> Expression:
    """Return a sum in canonical form."""
    found: dict[Expression, Fraction] = {}
    for term in [part for one in terms for part in one.terms]:
        factor, rest = term.split()
        found[rest] = found[rest] + factor if rest in found else factor
    total = found.pop(ONE, _ZERO)
    parts = sorted(rest if by is _ONE or by == 1 else node("*", (number(by), *rest.factors)) for rest, by in found.items() if by)
    return _joined("+", [number(total), *parts] if total else parts, ZERO)


def _joined(op: str, parts: list[Expression], nothing: Expression) -> Expression:
    return node(op, tuple(parts)) if len(parts) > 1 else parts[0] if parts else nothing


def multiply(*factors: Expression) -> Expression:
    """Return a product in canonical form."""
    numbers, powers = list[Fraction](), dict[Expression, Fraction]()
    for factor in [part for one in factors for part in one.factors]:
        base, by = factor.base_and_power
        if factor.op == "number":
            numbers.append(factor.value)
        else:
            powers[base] = powers[base] + by if base in powers else by
    total = functools.reduce(operator.mul, numbers) if numbers else _ONE
    if not total:
        return ZERO
    parts = [base if by is _ONE or by == 1 else power(base, by) for base, by in powers.items()]
    if any(part.op in {"*", "number"} or part.base_and_power[0] not in powers for part in parts):
        # A part that is no longer a power, or has another base now, may join with a similar factor.
        return multiply(number(total), *parts)
    parts.sort()
    is_one = total is _ONE or total == 1
    if not is_one and len(parts) == 1 and parts[0].op == "+":
        return add(*[multiply(number(total), term) for term in parts[0].args])
    return _joined("*", parts if is_one else [number(total), *parts], ONE)


def power(base: Expression, exponent: Number) -> Expression:
    """Return a power in canonical form."""
    by = exponent if isinstance(exponent, Fraction) else Fraction(exponent)
    whole = by.denominator == 1
    if by == 0 or base is ONE:
        return ONE
    if by == 1:
        return base
    match base.op:
        case "number" if base is ZERO:
            return ZERO if by > 0 else POLE
        case "number" if whole:
            return number(base.value**by.numerator)
        case "number" if base.value > 0:
            return _root(base.value, by)
        case "*":
            outside = [factor for factor in base.args if whole or is_nonnegative(factor)]  # of a root, only these come out
            if outside:
                inside = multiply(*[factor for factor in base.args if factor not in outside])
                return multiply(*[power(factor, by) for factor in outside], power(inside, by))
        case "^":
            inner, first = base.base_and_power
            even = first.denominator == 1 and first.numerator % 2 == 0
            if whole or even or is_nonnegative(inner):
                return power(absolute(inner) if even and not whole else inner, first * by)
        case "abs" if whole and by % 2 == 0:
            return power(base.args[0], by)
    return node("^", (base, number(by)))


def _root(value: Fraction, by: Fraction) -> Expression:
    """Return a positive number to a fractional power, as a rational factor and roots of whole numbers."""
    if value.denominator > 1:
        return multiply(power(number(value.numerator), by), power(number(value.denominator), -by))
    exact = round(value.numerator ** (1 / by.denominator))
    if exact**by.denominator == value:
        return number(Fraction(exact) ** by.numerator)
    left = node("^", (number(value), number(by % 1)))
    return multiply(number(value ** math.floor(by)), left) if by != by % 1 else left


def absolute(part: Expression) -> Expression:
    """Return the absolute value of an expression."""
    if is_nonnegative(part):
        return part
    if (not part.free_symbols and value(part) < 0) or (part.op == "+" and part.has_minus):
        return absolute(-part)
    known = [factor for factor in part.args if not factor.free_symbols or is_nonnegative(factor)] if part.op == "*" else []
    if known:
        unknown = [factor for factor in part.args if factor not in known]
        return multiply(*map(absolute, known), absolute(multiply(*unknown)))
    return node("abs", (part,))


def is_nonnegative(part: Expression) -> bool:
    """Return whether an expression can be recognised as zero or more."""
    if not part.free_symbols:
        return value(part) >= 0
    match part.op:
        case "abs" | "exp":
            return True
        case "^":
            base, by = part.base_and_power
            return (by.denominator == 1 and by % 2 == 0) or is_nonnegative(base)
    return part.op in {"+", "*"} and all(map(is_nonnegative, part.args))


def value(part: Expression) -> float:
    """Return the value of an expression without symbols, nan if it has none."""
    if part.op == "number":
        return part.value.numerator / part.value.denominator
    args = [value(arg) for arg in part.args]
    try:
        match part.op:
            case "pi":
                return math.pi
            case "+":
                return math.fsum(args)
            case "*":
                return math.prod(args)
            case "^":
                return math.pow(*args)
            case "abs":
                return abs(args[0])
        return float(getattr(math, part.op)(*args))
    except (ArithmeticError, ValueError):
        return math.nan
