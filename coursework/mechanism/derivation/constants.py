"""Names for constant angles: arccos((b^2 + d^2 - e^2)/(2 b d)) is written out once, and called beta from there on.

Enters: formulas, the moving names, the names already taken.  Leaves: formulas that contain the new names, and their meanings.
Used by the pages.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, mapped, named, spelled

INVERSE = {"asin", "acos", "atan", "atan2"}
ROUND_OFF = 1e-12  # rad: largest difference between two forms of the same angle


@frozen
class NamedAngles:
    """The constant angles of some formulas as (name, formula), in order of appearance; `alike` lists other forms of them."""

    angles: tuple[tuple[str, Formula], ...]
    alike: tuple[tuple[str, Formula], ...] = ()

    def put_in(self, formula: Formula) -> Formula:
        """Return the formula with each constant angle replaced by its name."""
        for name, angle in (*self.angles, *self.alike):
            if formula == angle:
                return named(name)
        return mapped(formula, self.put_in)


def named_angles(
    formulas: Iterable[Formula], moving: Collection[str], taken: Collection[str], values: Mapping[str, float] | None = None
) -> NamedAngles:
    """Return names for the angles that are inverse functions of data alone: beta, or beta1, beta2 … if there are several.

    If beta or one of these is in `taken`, the names are beta_1, beta_2 ….  With the `values` of the data (SI), two forms of one
    angle get the same name; the shorter form is kept.

    >>> from coursework.variant.formula.reader import parse
    >>> found = named_angles([parse("cos(phi + acos(b/(2*d)))")], {"phi"}, {"phi", "b", "d"})
    >>> found.angles[0][0]
    'beta'
    """
    groups: list[list[Formula]] = []
    for angle in dict.fromkeys(angle for formula in formulas for angle in _constant(formula, moving)):
        same = next((group for group in groups if _is_same(group[0], angle, values or {})), None)
        groups.append([angle]) if same is None else same.append(angle)
    forms = [sorted(group, key=lambda angle: len(spelled(angle))) for group in groups]
    names = ["beta"] if len(forms) == 1 else [f"beta{place}" for place in range(1, len(forms) + 1)]
    if any(name in taken for name in names):
        names = [f"beta_{place}" for place in range(1, len(forms) + 1)]
    first = tuple((name, group[0]) for name, group in zip(names, forms, strict=True))
    return NamedAngles(first, tuple((name, angle) for name, group in zip(names, forms, strict=True) for angle in group[1:]))


def _is_same(one: Formula, other: Formula, values: Mapping[str, float]) -> bool:
    """Return whether two formulas have the same value, for the data and for slightly changed data."""
    if set(one.names()) != set(other.names()) or not set(one.names()) - {"pi"} <= set(values):
        return False
    for part in (0.0, 0.003, -0.005):
        moved = {name: value * (1 + part * place) for place, (name, value) in enumerate(sorted(values.items()), start=1)}
        try:
            if abs(evaluate(one, moved) - evaluate(other, moved)) > ROUND_OFF:
                return False
        except FormulaFault:
            return False
    return True


def _constant(formula: Formula, moving: Collection[str]) -> Iterator[Formula]:
    """Yield the outermost constant angles inside a formula."""
    if formula.op == "call" and formula.name in INVERSE and formula.names() and not set(formula.names()) & set(moving):
        yield formula
        return
    for arg in formula.args:
        yield from _constant(arg, moving)
