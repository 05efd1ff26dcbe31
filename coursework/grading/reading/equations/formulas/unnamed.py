"""A formula without a name, as in a spreadsheet's cell (=V1*SIN(…)): the value of some velocity, or the residual of an equation.

Enters: the text of a line, a variant, a reader of equations.  Leaves: `EquationReading`s.  Used by `equations.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.student_work import EquationReading
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.places import has_one_dimension
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault

_NAMED = re.compile(r"\s*([^\W\d]\w{0,9})\s*:?(=[^=]+)")


def called_otherwise(text: str, fault: Fault) -> str:
    """Return "= formula" of a line "v = formula" whose fault is that nothing says what v is, "" for any other line."""
    found = _NAMED.fullmatch(text)
    return found[2] if found and found[1] == fault.place else ""


def without_a_name(text: str, variant: Variant, read: Callable[[str], EquationReading | Fault]) -> tuple[EquationReading, ...]:
    """Return the readings of "=formula": a residual if it can be the value of no velocity; else, loosely, each value and that."""
    if not text.lstrip().startswith("=") or len(text) > EQUATION_CHARACTERS:
        return ()
    formula = text.lstrip(" =")
    zero = read(f"0 = {formula}")
    if isinstance(zero, Fault):
        return ()
    values = [read(f"{velocity} = {formula}") for velocity in _values_of(zero.tree.args[1], variant)]
    found = [replace(one, guessed=True, is_loose=True) for one in values if not isinstance(one, Fault)]
    residual = replace(zero, text=zero.text or f"0 = {formula}", guessed=True, is_loose=bool(found))
    return (*found, residual)


def _values_of(formula: Formula, variant: Variant) -> tuple[str, ...]:
    """Return the sought velocities that a formula may give: those of its dimension that do not stand in it.

    A formula without any sought velocity is no residual, whatever its dimension.
    """
    names = {*formula.names()}
    if names.isdisjoint(variant.sought):
        return variant.sought
    others = (name for name in variant.sought if name not in names)
    return tuple(name for name in others if has_one_dimension(Formula("-", (named(name), formula)), variant))
