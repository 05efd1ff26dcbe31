"""The tree of an expression: equal trees compare equal, all have one order, and some have a sign that is seen.

Enters: nodes that `expression.py` makes.  Leaves: what can be told of a tree without making another.  Used by `expression.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, Self

# What comes first in sums and products; functions follow by name.
_KINDS = {"pi": 11, "symbol": 13, "^": 15, "*": 16, "+": 17, "abs": 20}
_SINGLE = {Fraction(0): 0, Fraction(1): 1, Fraction(1, 2): 2, Fraction(-1): 5}
# What leads in a sum, so that a - b and not b - a is written without a minus.
_RANKS = {"symbol": -2, "*": -1, "+": 0, "exp": 10, "log": 11, "sin": 20, "cos": 21, "tan": 22, "cot": 23}


class Tree:
    """`op` is number, symbol, pi, + * ^, piecewise or the name of a function; `value` that of a number, `name` that of a symbol.

    `depth` counts its levels.  The arguments of "piecewise" are t, then each piece and the time at which it ends, last the piece
    that has no end.
    """

    __slots__ = ("__weakref__", "_free", "_hash", "_kind", "args", "depth", "name", "op", "value")

    def __init__(self, op: str, args: tuple[Self, ...], name: str, value: Fraction) -> None:
        self.op, self.args, self.name, self.value = op, args, name, value
        self._hash = hash(value if op == "number" else (op, name, args))
        self.depth: int = 1 + max((arg.depth for arg in args), default=0)
        self._free: frozenset[Self] | None = None
        kind = _KINDS.get(op, 99) if op != "number" else _SINGLE.get(value, 7 + (value.denominator > 1))
        self._kind = kind, op, len(args), name, value.numerator, value.denominator

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, Tree):
            return self.op == "number" and self.value == other
        alike = self._hash == other._hash and self.op == other.op and self.name == other.name
        return alike and self.value == other.value and self.args == other.args

    def __repr__(self) -> str:
        own = self.name or (str(self.value) if self.op == "number" else self.op)
        return f"{own}({', '.join(map(repr, self.args))})" if self.args else own

    @property
    def free_symbols(self) -> frozenset[Self]:
        """Return every symbol inside."""
        if self._free is None:
            own = (self,) if self.op == "symbol" else ()
            self._free = frozenset(own).union(*(arg.free_symbols for arg in self.args))
        return self._free

    def __lt__(self, other: Tree) -> bool:
        one: Tree = self
        while one is not other:
            if (first := one._kind) != (second := other._kind):
                return first < second
            pairs = zip(one.args, other.args, strict=True)
            one, other = next((pair for pair in pairs if pair[0] is not pair[1]), (other, other))
        return False

    def walk(self) -> Iterator[Self]:
        """Yield every different part, this one first."""
        waiting, met = [self], {self}
        while waiting:
            part = waiting.pop()
            yield part
            fresh = [arg for arg in part.args if arg not in met]
            met.update(fresh)
            waiting += fresh

    def has(self, symbol: Tree) -> bool:
        """Return whether a symbol stands inside."""
        return symbol in self.free_symbols

    @property
    def terms(self) -> tuple[Self, ...]:
        """Return the terms of a sum, an expression of another kind as its only one."""
        return self.args if self.op == "+" else (self,)

    @property
    def factors(self) -> tuple[Self, ...]:
        """Return the factors of a product, an expression of another kind as its only one."""
        return self.args if self.op == "*" else (self,)

    @property
    def is_negative(self) -> bool:
        """Return whether the expression is a number below zero."""
        return self.op == "number" and self.value < 0


def is_nonnegative(part: Tree) -> bool:
    """Return whether an expression is seen to be zero or more."""
    if not part.free_symbols:
        return value(part) >= 0
    match part.op:
        case "abs" | "exp":
            return True
        case "^":
            by = part.args[1].value
            return (by.denominator == 1 and by % 2 == 0) or is_nonnegative(part.args[0])
    return part.op in {"+", "*"} and all(map(is_nonnegative, part.args))


def has_minus(part: Tree) -> bool:
    """Return whether an expression is written with a minus: -x, or a sum of which more terms, or the leading one, are such."""
    if part.op != "+":
        return part.factors[0].is_negative
    negative = sum(map(has_minus, part.args))
    if 2 * negative != len(part.args):
        return 2 * negative > len(part.args)
    powers = [_monomial(term) for term in part.args]
    names = sorted(set().union(*powers))
    leading = max(range(len(powers)), key=lambda place: [powers[place].get(name, 0) for name in names])
    return has_minus(part.args[leading])


def _monomial(term: Tree) -> dict[tuple[Any, ...], int]:
    """Return the powers in a term: k for the power k/n of a base, by what such powers are sorted by."""
    found = {}
    for factor in term.factors:
        base, by = (factor.args[0], factor.args[1].value) if factor.op == "^" else (factor, Fraction(1))
        inner: tuple[Tree, ...] = (base,)
        if factor.op == "exp":  # exp(-2 x) is the power -2 of exp(x)
            parts = factor.args[0].factors
            by = parts[0].value if parts[0].op == "number" else by
            inner = tuple(part for part in parts if part.op != "number")
        if factor.free_symbols:
            found[_RANKS.get(base.op, 99), inner, Fraction(1, by.denominator)] = by.numerator
    return found


def value(part: Tree) -> float:
    """Return the value of an expression of numbers alone, nan where it has none."""
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
            case "sign":
                return math.copysign(1.0, args[0]) if args[0] else 0.0
            case "cot":
                return 1 / math.tan(args[0])
        return float(getattr(math, part.op)(*args))
    except (ArithmeticError, ValueError):
        return math.nan
