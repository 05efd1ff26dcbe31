"""Marked cells -> the share of the table's points, with the gates that give nothing for nonsense.

Enters: `Cells`.  Leaves: `TablePoints`.  Used by `grade.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import GIVEN, KEY, STEP, STEP_TRUE, Cells
from coursework.system.arrays import Flags

# Rows whose velocities are all shown and right, below which steps made with them prove nothing.
ENOUGH_ROWS = 0.6


@dataclass(frozen=True, slots=True)
class TablePoints:
    """`share` of the table earned by its cells; how many cells count; whether row 1 is right."""

    share: float
    cells: int
    start_right: bool


def table_points(key: Key, cells: Cells, carried: float = 1.0) -> TablePoints:
    """Return the points of a table; `carried` is the worth of a cell that is right from the student's own cells only."""
    m, r = len(key.coordinates), len(key.velocities)
    rows = len(key.table)
    count = rows * (m + r) - m
    marks = cells.marks
    right = ~cells.wrong & ~cells.missing
    start_right = bool(np.all(~cells.wrong[0])) if rows else False
    rows_enough = bool(np.mean(np.all(right[:, m:], axis=1)) >= ENOUGH_ROWS) if rows else False
    credit = np.where(marks == KEY, 1.0, 0.0)
    if start_right:
        credit[cells.carried] = carried
        steps = np.isin(marks[:, :m], (STEP, STEP_TRUE))
        open_gate = np.zeros_like(steps)
        open_gate[1:] = right[:-1, m : 2 * m]
        credit[:, :m][steps & ~(open_gate & rows_enough)] = 0.0
    credit[marks == GIVEN] = 0.0
    return TablePoints(float(credit.sum()) / count if count else 0.0, count, start_right)


def true_steps(key: Key, cells: Cells) -> Flags:
    """Return which steps of angles (n - 1, m) follow from the printed row before, where both are there."""
    step = next(way for way in cells.ways if way.name == STEP)
    m = len(key.coordinates)
    return np.asarray(step.holds(cells.student.values)[1:, :m])
