"""A table made with another step, marked on all its own rows, whichever of them are on the task's grid.

Enters: a `Key`, the table marked by it.  Leaves: the shares of it that are right as if its own step were the task's.
Used by `misconceptions.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.key.key import Key, key_of
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.explained import Explained, euler_cells, share_of
from coursework.grading.marking.table.ways import KEY, OwnRows, StudentTable
from coursework.words.errors import CourseworkError

_NEAR = 0.01  # of a step: times that differ by less are the same


def on_own_rows(key: Key, cells: Cells, own: OwnRows) -> tuple[float, float] | None:
    """Return two shares that are right on a table's `own` rows: of cells, behind the gates; None if no motion has their step.

    Velocities that have the task's number were put right. The second share is of the task's rows: own rows closer than these
    fill no more of them than the time they reach; rows farther apart fill as many as there are.
    """
    rows = len(own.values)
    try:
        made = key_of(key.variant.timed(step=own.step, end=(rows - 1) * own.step))
    except CourseworkError:
        return None
    rows = min(rows, len(made.table))
    marked = mark_cells(made, StudentTable(own.values[:rows], own.units[:rows]))
    right, says = euler_cells(marked)
    at = np.rint(key.t / own.step).astype(int)
    on_grid = (at < rows) & np.isclose(at * own.step, key.t)
    right[at[on_grid], key.m :] |= ((cells.marks == KEY)[on_grid] & says[at[on_grid]])[:, key.m :]
    reached = int(np.sum(key.t <= (rows - 1 + _NEAR) * own.step))
    return share_of(right, says), min(rows, reached) / len(key.table) * Explained(made, marked).share(right)
