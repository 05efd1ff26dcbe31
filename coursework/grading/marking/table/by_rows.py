"""Tables of a motion under forces, marked row by row: against the key's rows, or by Euler's step from the student's row before.

Enters: a `Key`, a student's table.  Leaves: `Cells`, `TablePoints`, also for a mechanism driven by given laws.
Used by `grade.py` and `precheck.py`.

The state of a row is its free coordinates and free rates. Euler's step leads from it to the next state, with the accelerations
that the forces give in that row; all other positions and velocities follow from the state of their own row.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.decimals import NO_GAP
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.sensitivity import with_spread
from coursework.grading.marking.table.cells import Cells, mark_cells, marks_by
from coursework.grading.marking.table.points import TablePoints, credited, table_points
from coursework.grading.marking.table.ways import (
    ANGLES,
    HALF,
    KEY,
    LEAST,
    SLACK,
    STEP,
    StudentTable,
    Way,
    as_printed,
    near,
)  # fmt: skip
from coursework.system.arrays import Flags


def marked(key: Key, student: StudentTable) -> Cells:
    """Return the marks of all cells."""
    return mark_cells(key, student) if key.free is None else _mark_rows(key, student)


def points_of(key: Key, cells: Cells, carried: float = 1.0, untold: Flags | None = None) -> TablePoints:
    """Return the points of a table; `untold` cells do not count (see `table_points`)."""
    return table_points(key, cells, carried, untold) if key.free is None else _points(key, cells, carried)


def _mark_rows(key: Key, student: StudentTable) -> Cells:
    values, units = student.values, student.units
    ways = (Way(KEY, key.table, as_printed(key, units)), *_own(key, student))
    given = near(values[:1, : key.m], key.table[:1, : key.m], as_printed(key, units)[:1, : key.m])
    marks, too_coarse = marks_by(key, student, ways, given)
    follows = np.asarray(np.any([way.holds(values) for way in ways[1:]], axis=0))
    return Cells(student, marks, follows, ways, too_coarse, None, key.m, np.zeros_like(follows))


def _own(key: Key, student: StudentTable) -> tuple[Way, Way]:
    """Return two ways to be right: the state by Euler's step from the row before, and the other cells from their row's state."""
    assert key.free is not None
    values, units, h = student.values, np.nan_to_num(student.units), key.step
    state, count = list(key.free.state), len(key.free.state) // 2
    found, spread = with_spread(key.free.rows_of, values[:, state], units[:, state])
    width = values.shape[1]
    slack = SLACK * np.maximum(np.abs(found[:, :width]), LEAST * key.ranges)
    places = np.setdiff1d(np.arange(width), state)
    follows, open_by = np.full(values.shape, np.nan), np.full(values.shape, np.nan)
    follows[:, places] = found[:, places]
    open_by[:, places] = (HALF * (units + spread[:, :width]) + slack)[:, places]
    step, off = np.full(values.shape, np.nan), np.full(values.shape, np.nan)
    slopes = np.hstack([values[:, state[count:]], found[:, width:]])
    by = np.hstack([units[:, state[count:]], spread[:, width:]])
    step[1:, state] = values[:-1, state] + h * slopes[:-1]
    size = np.maximum(np.abs(slopes), LEAST * np.nanmax(np.abs(slopes), axis=0, initial=0.0))
    off[1:, state] = HALF * (units[1:, state] + units[:-1, state] + h * by[:-1]) + SLACK * h * size[:-1]
    return Way(STEP, step, off), Way(ANGLES, follows, open_by)


def _points(key: Key, cells: Cells, carried: float = 1.0) -> TablePoints:
    """Return the points of a table; a cell that is right only from the student's own counts if the state of its row is right."""
    assert key.free is not None
    state = list(key.free.state)
    moves = np.asarray(np.all((~cells.wrong & ~cells.missing)[:, state], axis=1))
    still = key.ranges <= NO_GAP * np.max(np.abs(key.table), axis=0)
    return credited(cells, carried, {"motion": cells.right & (cells.carried | still) & ~moves[:, None]})
