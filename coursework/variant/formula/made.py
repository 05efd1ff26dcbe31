"""Sums, products and multiples of pi, made as formulas; angles in degrees, as a person reads them.

Enters and leaves: `Formula`.  Used on every floor.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from math import degrees, isclose, radians

from coursework.variant.formula.tree import Formula, constant, mapped, named, number, spelled

_READ_FROM_DEGREES = 12  # least number of digits: nobody writes an angle in radians with so many


def summed(terms: Iterable[tuple[Formula, int]]) -> Formula:
    """Return the sum of terms with their signs, 0 for no terms.

    >>> summed([(named("a"), -1), (named("b"), 1)]) == Formula("+", (Formula("neg", (named("a"),)), named("b")))
    True
    """
    total: Formula | None = None
    for term, sign in terms:
        if total is None:
            total = term if sign > 0 else Formula("neg", (term,))
        else:
            total = Formula("+" if sign > 0 else "-", (total, term))
    return number(0) if total is None else total


def sum_of(sign: str, first: Formula, second: Formula) -> Formula:
    """Return first + second or first - second, without a zero."""
    if second == number(0):
        return first
    if first == number(0):
        return second if sign == "+" else Formula("neg", (second,))
    return Formula(sign, (first, second))


def product_of(parts: Sequence[Formula]) -> Formula:
    """Return the product of formulas, 1 if there are none."""
    return reduce(lambda first, second: Formula("*", (first, second)), parts) if parts else number(1)


def quotient_of(parts: Iterable[tuple[Formula, int]]) -> Formula:
    """Return the product of factors with their powers, 1 or -1."""
    parts = [*parts]
    above, below = (product_of([part for part, power in parts if power == side]) for side in (1, -1))
    return above if constant(below) == 1 else Formula("/", (above, below))


def part_of_pi(part: Fraction) -> Formula:
    """Return pi, 3*pi/2 … for a nonnegative multiple of pi.

    >>> from coursework.variant.formula.tree import spelled
    >>> spelled(part_of_pi(Fraction(3, 2)))
    '3*pi/2'
    """
    if part == 0:
        return number(0)
    pi = named("pi")
    above = pi if part.numerator == 1 else Formula("*", (number(part.numerator), pi))
    return above if part.denominator == 1 else Formula("/", (above, number(part.denominator)))


def degrees_in(tree: Formula) -> str:
    """Return "15" for the number 0.2617993877991494, an angle that a file gave in degrees; "" for any other formula."""
    value = constant(tree) if tree.op in {"number", "/"} else None
    if value is None or len(repr(float(value)).strip("0.")) < _READ_FROM_DEGREES:
        return ""
    written = round(degrees(value), 2)
    return f"{written:g}" if written and isclose(radians(written), value, rel_tol=1e-14) else ""


def as_read(tree: Formula) -> str:
    """Return a formula as text for a person, who reads angles in degrees.

    >>> from coursework.variant.formula.reader import parse
    >>> as_read(parse("l4*cos(1.9198621771937625 + phi4)"))
    'l4*cos(110° + phi4)'
    """

    def turned(part: Formula) -> Formula:
        found = degrees_in(part)
        return named(f"{found}°") if found else mapped(part, turned)

    return spelled(turned(tree))


def unsigned(tree: Formula) -> Formula:
    """Return a term without the sign at its begin, as a message names it.

    >>> from coursework.variant.formula.reader import parse
    >>> spelled(unsigned(parse("-l*om*cos(q)")))
    'l*om*cos(q)'
    """
    return _led(tree)[1]


def with_sign(tree: Formula) -> str:
    """Return a product as text with its sign before it, as a person writes it.

    >>> from coursework.variant.formula.reader import parse
    >>> with_sign(Formula("*", (parse("-z2/z1"), parse("a - b"))))
    '-z2/z1*(a - b)'
    """
    sign, bare = _led(tree)
    return spelled(bare) if sign > 0 else f"-{spelled(bare)}"


def _led(tree: Formula) -> tuple[int, Formula]:
    if tree.op == "neg":
        sign, bare = _led(tree.args[0])
        return -sign, bare
    if tree.op in {"*", "/", "@"}:
        sign, first = _led(tree.args[0])
        return sign, replace(tree, args=(first, *tree.args[1:]))
    return 1, tree
