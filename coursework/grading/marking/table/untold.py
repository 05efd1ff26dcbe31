"""Cells that are right only because few digits were printed, which do not tell Euler's rule from what was done instead.

Enters: marked cells, the values that a cause expects.  Leaves: which right cells do not count.
Used by `points.py`, `misconceptions.py`, `whole.py`.
The same fault costs the same with any digits: what a cause makes wrong is wrong, even if the digits do not show it everywhere.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.grading.marking.decimals import NO_GAP
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import MISSING, WRONG, Cells
from coursework.grading.marking.table.ways import ANGLES, KEY, STEP, Places, StudentTable, near, own_ways
from coursework.system.arrays import Array, Flags

# A step is told if other rules miss it by over _TOLD tolerances: half steps miss Euler's by half as much as Heun's, and round-off
# hides some.  If up to _FEW_TOLD of the told steps are Euler's, no untold step counts; from _MOST_TOLD on, all count.
_TOLD, _FEW_TOLD, _MOST_TOLD = 3.0, 0.25, 0.75
# Part of a column's range up to which two numbers computed with all digits are equal.
_SAME = 1e-6
FINEST = 1e-9


def untold_steps(key: Key, cells: Cells, steps: Flags, rows: Places) -> Flags:
    """Return which right `steps` (n, m + r) do not count because the digits cannot tell them from other rules' steps.

    A step is told if all other rules miss it clearly. If most told steps are Euler's, untold ones count; if few are, none does.
    """
    m, gaps = key.m, _gaps(key, rows)
    marks = cells.marks[rows[1:], :m]
    told = np.where(marks == MISSING, 0.0, gaps)
    euler = float((told * (marks != WRONG)).sum() / told.sum()) if told.any() else 1.0
    open_by = cells.way(STEP).tolerance[rows[1:], :m]
    found = np.zeros_like(steps)
    found[rows[1:], :m] = steps[rows[1:], :m] & (gaps <= _TOLD * open_by)
    return but(found, ramp(euler, _FEW_TOLD, _MOST_TOLD))


def untold_cells(key: Key, cells: Cells, expected: Array, holds: Flags, table: Array | None) -> Flags:
    """Return which right cells (n, m + r) do not count: a cause `holds` there too and `expected` another value than Euler's.

    `table` (n, m + r) is the whole table that the cause makes, None if unknown. Cells whose digits do tell decide: if most of
    these are right, the others count; if few are, none does.
    """
    of_euler = np.hstack([cells.way(STEP).expected[:, : key.m], cells.way(ANGLES).expected[:, key.m :]])
    with np.errstate(invalid="ignore"):
        other = (np.abs(expected - of_euler) > _SAME * key.ranges) & cells.judged
    other &= ~_right_with_all_digits(key, table) if table is not None else cells.marks != KEY
    right = ~cells.wrong
    told, untold = other & ~(right & holds), other & right & holds
    euler = float(right[told].mean()) if told.any() else 1.0
    return but(untold, ramp(euler, _FEW_TOLD, _MOST_TOLD))


def _right_with_all_digits(key: Key, table: Array) -> Flags:
    """Return which cells of a table (n, m + r), made by a cause without a slip, are right in any way with all digits."""
    own = own_ways(key, StudentTable(table, np.full(table.shape, FINEST)))
    same = np.broadcast_to(_SAME * key.ranges, table.shape)
    return np.asarray(np.any([near(table, way, same) for way in (key.table, *(way.expected for way in own.tried))], axis=0))


def _gaps(key: Key, rows: Places) -> Array:
    """Return the least distance (n - 1, m) of other rules' steps between successive `rows` from Euler's: Heun, or another time.

    A rule that makes the same of a coordinate as Euler's, as another time does in a steady drive, is left out; 0 if all do.
    """
    off = np.pad(key.off_euler, ((0, 0), (1, 0), (0, 0)))
    gaps = np.abs(np.diff(np.cumsum(off, axis=1)[:, rows], axis=1))
    is_other = np.abs(off).max(axis=1, keepdims=True) > NO_GAP * key.ranges[: off.shape[2]]
    nearest = np.min(np.where(is_other, gaps, np.inf), axis=0)
    return np.asarray(np.where(np.isfinite(nearest), nearest, 0.0))


def ramp(share: float, none: float, whole: float) -> float:
    """Return the part (0 to 1) that counts: 0 up to the share `none`, 1 from `whole` on; so no single cell decides about many."""
    return min(1.0, max(0.0, (share - none) / (whole - none)))


def but(found: Flags, part: float) -> Flags:
    """Return the cells in `found` except the first of them; `part` (0 to 1) says how many are left out."""
    left, places = found.copy(), np.argwhere(found)
    left[tuple(places[: math.ceil(part * len(places))].T)] = False
    return left
