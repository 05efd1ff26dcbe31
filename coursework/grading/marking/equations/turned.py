"""A line of equations with the other sign of some velocities: what it says to one who counts turning clockwise.

Enters: a line, names.  Leaves: the line so changed.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from coursework.grading.reading.student_work import EquationLine
from coursework.variant.formula.tree import Formula, with_names


def with_other_sign(line: EquationLine, names: Collection[str]) -> EquationLine:
    """Return a line that was read with each of the names replaced by its negative; its text stays."""

    def turned(name: Formula) -> Formula:
        return Formula("neg", (name,), column=name.column) if name.name in names else name

    return replace(line, tree=with_names(line.difference, turned), others=())
