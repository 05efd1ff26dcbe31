"""A line with the sign of some velocities turned: what it says if the student counts angles clockwise.

Enters: a line, names.  Leaves: the line so changed.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.tree import Formula, with_names


def with_other_sign(line: EquationLine, names: Collection[str]) -> EquationLine:
    """Return a line in which each of the names is replaced by its negative; its text does not change."""

    def turned(name: Formula) -> Formula:
        return Formula("neg", (name,), column=name.column) if name.name in names else name

    return replace(line, tree=with_names(line.difference, turned), others=())
