"""Constant angles get a name: arccos((b^2 + d^2 - e^2)/(2 b d)) is written once, and is beta from there on.

Enters: formulas, the names that move, the names that are taken.  Leaves: formulas with names in place, and what those mean.
Used by the pages.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace

from coursework.formula.tree import Formula

INVERSE = {"asin", "acos", "atan", "atan2"}


@dataclass(frozen=True, slots=True)
class NamedAngles:
    """The constant angles of some formulas, (name, formula) each in the order met."""

    angles: tuple[tuple[str, Formula], ...]

    def put_in(self, formula: Formula) -> Formula:
        """Return the formula with names in the place of the angles."""
        for name, angle in self.angles:
            if formula == angle:
                return Formula("name", name=name)
        args = tuple(self.put_in(arg) for arg in formula.args)
        return replace(formula, args=args) if args != formula.args else formula


def named_angles(formulas: Iterable[Formula], moving: Collection[str], taken: Collection[str]) -> NamedAngles:
    """Return names for every angle that is an inverse function of data alone: beta, or beta_1, beta_2 … where there are several.

    >>> from coursework.formula.reader import parse
    >>> found = named_angles([parse("cos(phi + acos(b/(2*d)))")], {"phi"}, {"phi", "b", "d"})
    >>> found.angles[0][0]
    'beta'
    """
    angles = list(dict.fromkeys(angle for formula in formulas for angle in _constant(formula, moving)))
    names = ["beta"] if len(angles) == 1 else [f"beta{place}" for place in range(1, len(angles) + 1)]
    if any(name in taken for name in names):
        names = [f"beta_{place}" for place in range(1, len(angles) + 1)]
    return NamedAngles(tuple(zip(names, angles, strict=True)))


def _constant(formula: Formula, moving: Collection[str]) -> Iterator[Formula]:
    """Yield the outermost constant angles inside a formula."""
    if formula.op == "call" and formula.name in INVERSE and formula.names() and not set(formula.names()) & set(moving):
        yield formula
        return
    for arg in formula.args:
        yield from _constant(arg, moving)
