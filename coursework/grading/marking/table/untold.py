"""Cells that are right only because few digits were printed: those do not tell Euler's rules from what was done instead.

Enters: marked cells, what a cause expects that explains them.  Leaves: which right cells do not count.
Used by `points.py`, `misconceptions.py`, `whole.py`.
The same fault costs the same with any digits: what a cause makes wrong is wrong, whether or not the digits show it in every cell.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.grading.marking.decimals import NO_GAP
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import MISSING, WRONG, Cells
from coursework.grading.marking.table.ways import ANGLES, KEY, STEP, Places, StudentTable, near, own_ways
from coursework.system.arrays import Array, Flags

# Half steps leave Euler's by half as much as Heun's, and round-off hides them: so many tolerances tell a step.  Up to which part
# of what is told being Euler's nothing else counts, and from which part on all of it.
_TOLD, _FEW_TOLD, _MOST_TOLD = 3.0, 0.25, 0.75
# Of a column's range: below it two numbers that were worked out with all digits are one.
_SAME = 1e-6
FINEST = 1e-9


def untold_steps(key: Key, cells: Cells, steps: Flags, rows: Places) -> Flags:
    """Return which of the right `steps` (n, m + r) the digits cannot tell from any other rule's and do not count.

    A step is told by how far those of other rules leave it.  Where most of them are Euler's, so are the others; where few, none.
    """
    m, gaps = len(key.coordinates), _gaps(key, rows)
    marks = cells.marks[rows[1:], :m]
    told = np.where(marks == MISSING, 0.0, gaps)
    euler = float((told * (marks != WRONG)).sum() / told.sum()) if told.any() else 1.0
    open_by = cells.way(STEP).tolerance[rows[1:], :m]
    found = np.zeros_like(steps)
    found[rows[1:], :m] = steps[rows[1:], :m] & (gaps <= _TOLD * open_by)
    return but(found, ramp(euler, _FEW_TOLD, _MOST_TOLD))


def untold_cells(key: Key, cells: Cells, expected: Array, holds: Flags, table: Array | None) -> Flags:
    """Return which right cells (n, m + r) are right only as far as printed: a cause that `holds` there has others `expected`.

    `table` (n, m + r) is what it makes as a whole, where that is known.  They count as those do which the digits tell: where most
    of these are right, so are the others; where few, none.
    """
    m = len(key.coordinates)
    of_euler = np.hstack([cells.way(STEP).expected[:, :m], cells.way(ANGLES).expected[:, m:]])
    with np.errstate(invalid="ignore"):
        other = (np.abs(expected - of_euler) > _SAME * key.ranges) & cells.counted & ~cells.missing
    other &= ~_right_with_all_digits(key, table) if table is not None else cells.marks != KEY
    right = ~cells.wrong
    told, untold = other & ~(right & holds), other & right & holds
    euler = float(right[told].mean()) if told.any() else 1.0
    return but(untold, ramp(euler, _FEW_TOLD, _MOST_TOLD))


def _right_with_all_digits(key: Key, table: Array) -> Flags:
    """Return which cells of a table (n, m + r) that a cause makes without a slip are right in any way, to the last digit."""
    own = own_ways(key, StudentTable(table, np.full(table.shape, FINEST)))
    same = np.broadcast_to(_SAME * key.ranges, table.shape)
    return np.asarray(np.any([near(table, way, same) for way in (key.table, *(way.expected for way in own.tried))], axis=0))


def _gaps(key: Key, rows: Places) -> Array:
    """Return how near to Euler's steps from one of some rows to the next (n - 1, m) those of Heun or of another time come.

    A rule that makes of a coordinate what Euler's does, as any time does under a steady drive, is no other one; 0 where all do.
    """
    off = np.pad(key.off_euler, ((0, 0), (1, 0), (0, 0)))
    gaps = np.abs(np.diff(np.cumsum(off, axis=1)[:, rows], axis=1))
    is_other = np.abs(off).max(axis=1, keepdims=True) > NO_GAP * key.ranges[: off.shape[2]]
    nearest = np.min(np.where(is_other, gaps, np.inf), axis=0)
    return np.asarray(np.where(np.isfinite(nearest), nearest, 0.0))


def ramp(share: float, none: float, whole: float) -> float:
    """Return which part (0 to 1) counts at a share: nothing up to `none`, all from `whole` on: no cell decides on many."""
    return min(1.0, max(0.0, (share - none) / (whole - none)))


def but(found: Flags, part: float) -> Flags:
    """Return the cells found without the first of them, which are this part."""
    left, places = found.copy(), np.argwhere(found)
    left[tuple(places[: math.ceil(part * len(places))].T)] = False
    return left
