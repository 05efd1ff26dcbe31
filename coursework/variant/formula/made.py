"""Sums, products and multiples of pi, made as formulas.

Enters and leaves: `Formula`.  Used on every floor.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import reduce

from coursework.variant.formula.tree import Formula, named, number


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


def product_of(parts: Sequence[Formula]) -> Formula:
    """Return the product of formulas, 1 if there are none."""
    return reduce(lambda first, second: Formula("*", (first, second)), parts) if parts else number(1)


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
