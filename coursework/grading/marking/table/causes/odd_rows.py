"""Rows of a table that repeat the row before, and rows that belong elsewhere.

Enters: a `Key`, marked cells.  Leaves: numbers of rows (from 1), runs of rows.  Used by `table.py`, `misconceptions.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.ways import as_printed, near
from coursework.system.arrays import Array, Flags, shifted
from coursework.system.frozen import frozen

# A shift is told if so many successive rows are shifted by the same number, which is at most FARTHEST.
FEWEST_SHIFTED, FARTHEST = 3, 3


@frozen
class Shift:
    """Rows `first` to `last` (from 1) hold what belongs `by` rows further down (further up if negative)."""

    first: int
    last: int
    by: int


def repeated_rows(key: Key, cells: Cells) -> tuple[int, ...]:
    """Return the rows (from 1) that print the numbers of the row before, although the key's rows differ."""
    values = cells.student.values
    there = np.isfinite(values[1:]) & np.isfinite(values[:-1])
    same = (values[1:] == values[:-1]) & there
    moves = np.abs(np.diff(key.table, axis=0)) > _tolerance(key, cells)[1:]
    whole = np.all(same | ~there, axis=1) & (there.sum(axis=1) > there.shape[1] / 2)
    return tuple((np.flatnonzero(whole & (moves & there).any(axis=1)) + 2).tolist())


def displaced_rows(key: Key, cells: Cells) -> tuple[Shift, ...]:
    """Return the runs of rows that agree with rows of the key, but not with the row where they stand."""
    count = len(key.table)
    at_home = _rows_alike(key, cells, 0)
    found: list[Shift] = []
    for by in sorted(range(-FARTHEST, FARTHEST + 1), key=abs):
        if by and count > abs(by):
            found += _runs(_rows_alike(key, cells, by) & ~at_home, by)
    return tuple(sorted(found, key=lambda shift: shift.first))


def _rows_alike(key: Key, cells: Cells, by: int) -> Flags:
    """Return which rows (n,) agree, in every cell that is there, with the key's row that is `by` further down."""
    values = cells.student.values
    expected = shifted(key.table, -by)
    there = np.isfinite(values) & np.isfinite(expected)
    alike = near(values, expected, _tolerance(key, cells))
    return np.asarray(np.all(alike | ~there, axis=1) & (there.sum(axis=1) > there.shape[1] / 2))


def _tolerance(key: Key, cells: Cells) -> Array:
    return as_printed(key, np.nan_to_num(cells.student.units))


def _runs(rows: Flags, by: int) -> list[Shift]:
    """Return the runs of at least `FEWEST_SHIFTED` successive rows."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], rows, [False]]).astype(int))).reshape(-1, 2)
    return [Shift(first + 1, last, by) for first, last in edges.tolist() if last - first >= FEWEST_SHIFTED]
