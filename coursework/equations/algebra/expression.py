"""One immutable expression: numbers, symbols, sums, products, powers and functions, each always in the same canonical form.

Enters: parts, by `number`, `variable`, `add`, `multiply`, `power` and `node`.  Leaves: `Expression`; equal ones are one object.
Used by `functions.py`, `calculus.py`, `symbolic_objects.py` and whoever reads the kind of an expression.

A sum has its number first and no two terms alike; a product has its number first, no two factors with the same base, and a
number times a sum alone is multiplied out.  Order, and what is done at once, are SymPy's: it is the judge in the tests.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any
from weakref import WeakValueDictionary

Number = int | Fraction
_KINDS = {"number": 7, "pi": 11, "symbol": 13, "^": 15, "*": 16, "+": 17, "abs": 20}  # all others are functions, by name
_SINGLE = {Fraction(0): 0, Fraction(1): 1, Fraction(1, 2): 2, Fraction(-1): 5}


class Expression:
    """`op` is number, symbol, pi, + * ^, piecewise or the name of a function; `value` that of a number, `name` that of a symbol.

    The arguments of "piecewise" are t, then each piece and the time at which it ends, last the piece that has no end.
    """

    __slots__ = ("__weakref__", "_free", "_hash", "_order", "args", "name", "op", "value")

    def __init__(self, op: str, args: tuple[Expression, ...], name: str, value: Fraction) -> None:
        self.op, self.args, self.name, self.value = op, args, name, value
        self._hash = hash(value if op == "number" else (op, name, args))
        self._free: frozenset[Expression] | None = None
        self._order: tuple[Any, ...] | None = None

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, Expression):
            return self.op == "number" and self.value == other
        alike = self._hash == other._hash and self.op == other.op and self.name == other.name
        return alike and self.value == other.value and self.args == other.args

    def __repr__(self) -> str:
        own = self.name or (str(self.value) if self.op == "number" else self.op)
        return f"{own}({', '.join(map(repr, self.args))})" if self.args else own

    def __reduce__(self) -> tuple[Callable[..., Expression], tuple[Any, ...]]:
        return node, (self.op, self.args, self.name, self.value)

    @property
    def free_symbols(self) -> frozenset[Expression]:
        """Return every symbol inside."""
        if self._free is None:
            own = (self,) if self.op == "symbol" else ()
            self._free = frozenset(own).union(*(arg.free_symbols for arg in self.args))
        return self._free

    @property
    def order(self) -> tuple[Any, ...]:
        """Return what sums and products sort their parts by."""
        if self._order is None:
            kind = _KINDS.get(self.op, 99)
            if self.op == "number":
                kind = _SINGLE.get(self.value, kind + (self.value.denominator > 1))
            size, inner = len(self.args), tuple(arg.order for arg in self.args)
            self._order = kind, self.op, size, self.name, self.value.numerator, self.value.denominator, inner
        return self._order

    def walk(self) -> Iterator[Expression]:
        """Yield every different part, this one first."""
        waiting, met = [self], {self}
        while waiting:
            part = waiting.pop()
            yield part
            fresh = [arg for arg in part.args if arg not in met]
            met.update(fresh)
            waiting += fresh

    def has(self, symbol: Expression) -> bool:
        """Return whether a symbol stands inside."""
        return symbol in self.free_symbols

    @property
    def terms(self) -> tuple[Expression, ...]:
        """Return the terms of a sum, an expression of another kind as its only one."""
        return self.args if self.op == "+" else (self,)

    @property
    def factors(self) -> tuple[Expression, ...]:
        """Return the factors of a product, an expression of another kind as its only one."""
        return self.args if self.op == "*" else (self,)

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

    @property
    def is_negative(self) -> bool:
        """Return whether the expression is a number below zero."""
        return self.op == "number" and self.value < 0

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
    key = (op, args, name, value)
    found = _known.get(key)
    return _known.setdefault(key, Expression(op, args, name, value)) if found is None else found


def number(value: Number) -> Expression:
    """Return a number."""
    return node("number", value=Fraction(value))


def variable(name: str) -> Expression:
    """Return a symbol, which stands for a real number."""
    return node("symbol", name=name)


def as_expression(value: Expression | Number) -> Expression:
    """Return an expression as it is, a number as one."""
    return value if isinstance(value, Expression) else number(value)


ZERO, ONE, MINUS, HALF, PI = number(0), number(1), number(-1), number(Fraction(1, 2)), node("pi")
_LARGEST_PRIME = 2**15
POLE = node("^", (ZERO, MINUS))  # what has no value, whatever the motion


def add(*terms: Expression) -> Expression:
    """Return a sum."""
    total, found, waiting = _ZERO, dict[Expression, Fraction](), list(terms)
    for term in waiting:  # grows
        if term.op == "+":
            waiting.extend(term.args)
        elif term.op == "number":
            total += term.value
        else:
            factor, rest = term.split()
            found[rest] = found.get(rest, _ZERO) + factor
    parts = [rest if factor == 1 else _times(factor, rest) for rest, factor in found.items() if factor]
    parts.sort(key=_in_order)
    if total:
        parts.insert(0, number(total))
    return node("+", tuple(parts)) if len(parts) > 1 else parts[0] if parts else ZERO


def _times(factor: Fraction, rest: Expression) -> Expression:
    return node("*", (number(factor), *rest.factors))


def _in_order(part: Expression) -> tuple[Any, ...]:
    return part.order


def multiply(*factors: Expression) -> Expression:
    """Return a product."""
    total, waiting = _ONE, list(factors)
    powers: dict[tuple[Expression, Expression], Fraction] = {}
    primes: dict[int, Fraction] = {}
    for factor in waiting:  # grows
        if factor.op == "*":
            waiting.extend(factor.args)
        elif factor.op == "number":
            total *= factor.value
        elif factor.op == "^" and factor.args[0].value > 0:
            _gather(primes, factor.args[0].value, factor.args[1].value)
        else:
            # exp(2 x) exp(x) is exp(3 x), as of any other base.
            base, exponent = (_E, factor.args[0]) if factor.op == "exp" else factor.base_and_power
            times, tail = exponent.split()
            powers[base, tail] = powers.get((base, tail), _ZERO) + times
    if not total:
        return ZERO
    whole, parts = _roots(primes)
    total *= whole
    changed = False
    for (base, tail), times in powers.items():
        part = power(base, multiply(number(times), tail)) if times != 1 or tail is not ONE or base is _E else base
        # What is a power no more, or one of another base, may meet its like.
        changed |= part.op in {"*", "number"} or (base is not _E and len(powers) > 1 and part.base_and_power[0] != base)
        parts.append(part)
    if changed:
        return multiply(number(total), *parts)
    parts.sort(key=_in_order)
    if total != 1:
        if len(parts) == 1 and parts[0].op == "+":
            return add(*[multiply(number(total), term) for term in parts[0].args])
        parts.insert(0, number(total))
    return node("*", tuple(parts)) if len(parts) > 1 else parts[0] if parts else ONE


def _gather(primes: dict[int, Fraction], value: Fraction, exponent: Fraction) -> None:
    """Multiply powers of primes by a power of a positive number."""
    for whole, sign in ((value.numerator, 1), (value.denominator, -1)):
        for prime, times in _factored(whole):
            primes[prime] = primes.get(prime, _ZERO) + sign * times * exponent


@lru_cache(maxsize=256)
def _factored(whole: int) -> tuple[tuple[int, int], ...]:
    """Return primes and how often each divides a whole number; what no small prime divides stands for one."""
    found, prime = dict[int, int](), 2
    while prime * prime <= whole and prime < _LARGEST_PRIME:
        while whole % prime == 0:
            whole //= prime
            found[prime] = found.get(prime, 0) + 1
        prime += 1
    root = math.isqrt(whole)
    left, times = (root, 2) if root * root == whole else (whole, 1)
    return (*found.items(), *(((left, times),) if left > 1 else ()))


def _roots(primes: dict[int, Fraction]) -> tuple[Fraction, list[Expression]]:
    """Return the rational part of a product of powers of primes, and the roots that are left of it."""
    total, left = _ONE, dict[Fraction, int]()
    for prime, exponent in primes.items():
        whole = math.floor(exponent)
        total *= Fraction(prime) ** whole
        if exponent != whole:
            left[exponent - whole] = left.get(exponent - whole, 1) * prime
    return total, [node("^", (number(base), number(exponent))) for exponent, base in left.items()]


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
    primes: dict[int, Fraction] = {}
    _gather(primes, base.value, by)
    total, roots = _roots(primes)
    return multiply(number(total), *roots) if total != 1 or len(roots) != 1 else roots[0]


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


def is_nonnegative(part: Expression) -> bool:
    """Return whether an expression is seen to be zero or more."""
    match part.op:
        case "number":
            return part.value >= 0
        case "pi" | "abs" | "exp":
            return True
        case "^":
            by = part.args[1].value
            return (by.denominator == 1 and by % 2 == 0) or is_nonnegative(part.args[0])
    return part.op in {"+", "*"} and all(map(is_nonnegative, part.args))


def absolute(part: Expression) -> Expression:
    """Return the absolute value of an expression."""
    if part.op == "number" or is_nonnegative(part):
        return number(abs(part.value)) if part.op == "number" else part
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


def has_minus(part: Expression) -> bool:
    """Return whether an expression is written with a minus: -x, or a sum of which more terms, or the leading one, are such."""
    if part.op != "+":
        return part.factors[0].is_negative
    negative = sum(map(has_minus, part.args))
    if 2 * negative != len(part.args):
        return 2 * negative > len(part.args)
    powers = [_monomial(term) for term in part.args]
    names = sorted(set().union(*powers), key=_rank)
    leading = max(range(len(powers)), key=lambda place: [powers[place].get(name, 0) for name in names])
    return has_minus(part.args[leading])


def _monomial(term: Expression) -> dict[tuple[Expression, int], int]:
    """Return the powers in a term: {(base, n): k} for the power k/n of a base."""
    parts = [factor.base_and_power for factor in term.factors if factor.free_symbols]
    return {(base, by.value.denominator): by.value.numerator for base, by in parts}


def _rank(part: tuple[Expression, int]) -> tuple[Any, ...]:
    base, root = part
    kind = {"symbol": -2, "*": -1, "+": 0, "exp": 10, "log": 11, "sin": 20, "cos": 21, "tan": 22, "cot": 23}.get(base.op, 99)
    return kind, base.order, Fraction(1, root)


_E = node("e")
