"""A table made with another step, marked on all its own rows, whichever of them are on the task's grid.

Enters: a `Key`, the table marked by it.  Leaves: that table marked as if its own step were the task's.
Used by `misconceptions.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from coursework.grading.marking.key.key import Key, key_of
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.ways import KEY, OwnRows, StudentTable
from coursework.system.arrays import Flags
from coursework.words.errors import CourseworkError

_NEAR = 0.01  # of a step: times that differ by less are the same


@dataclass(frozen=True)
class OnOwnRows:
    """The `key` for the student's own step, the `cells` marked by it, and the part (0 to 1) of the task's rows they fill.

    Rows closer than the task's fill no more of them than the time they reach; rows farther apart fill as many as there are.
    `put_right` (n, m + r) are the velocities that have the task's number.
    """

    key: Key
    cells: Cells
    filled: float
    put_right: Flags


def on_own_rows(key: Key, cells: Cells, own: OwnRows) -> OnOwnRows | None:
    """Return a table marked on its `own` rows, None if a motion with their step cannot be computed."""
    rows = len(own.values)
    try:
        made = key_of(key.variant.timed(step=own.step, end=(rows - 1) * own.step))
    except CourseworkError:
        return None
    rows = min(rows, len(made.table))
    marked = mark_cells(made, StudentTable(own.values[:rows], own.units[:rows]))
    put_right = np.zeros_like(marked.wrong)
    at = np.rint(key.t / own.step).astype(int)
    on_grid = (at < rows) & np.isclose(at * own.step, key.t)
    put_right[at[on_grid], key.m :] = (cells.marks == KEY)[on_grid, key.m :]
    reached = int(np.sum(key.t <= (rows - 1 + _NEAR) * own.step))
    return OnOwnRows(made, marked, min(rows, reached) / len(key.table), put_right)
