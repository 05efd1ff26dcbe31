"""A table made with another step, marked on all its own rows, whichever of them are on the task's grid.

Enters: a `Key`, a student's table.  Leaves: that table marked as if its own step were the task's.  Used by `misconceptions.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

from coursework.grading.marking.key.key import Key, key_of
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.ways import StudentTable
from coursework.words.errors import CourseworkError


@dataclass(frozen=True)
class OnOwnRows:
    """The `key` for the student's own step, the `cells` marked by it, and the part (0 to 1) of the task's rows they fill."""

    key: Key
    cells: Cells
    filled: float


def on_own_rows(key: Key, student: StudentTable) -> OnOwnRows | None:
    """Return a table marked on its own rows, None if its times are the task's or a motion with its step cannot be computed."""
    own = student.own
    if own is None:
        return None
    rows = len(own.values)
    try:
        made = key_of(key.variant.timed(step=own.step, end=(rows - 1) * own.step))
    except CourseworkError:
        return None
    rows = min(rows, len(made.table))
    cells = mark_cells(made, StudentTable(own.values[:rows], own.units[:rows]))
    return OnOwnRows(made, cells, min(1.0, rows / len(key.table)))
