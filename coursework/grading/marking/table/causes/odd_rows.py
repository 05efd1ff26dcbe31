"""Rows of a table that repeat the row before, and rows that belong elsewhere.

Enters: a `Key`, marked cells.  Leaves: numbers of rows (from 1), runs of rows.  Used by `table.py`, `misconceptions.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.ways import StudentTable, as_printed, near
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen

# A shift is told if so many successive rows are shifted by the same number.
FEWEST_SHIFTED = 3


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
    alike = alike_rows(key, cells.student)
    at_home = np.diagonal(alike)
    found: list[Shift] = []
    for by in sorted(shifts(alike), key=abs):
        rows = np.zeros(len(alike), dtype=bool)
        rows[max(-by, 0) : len(alike) - max(by, 0)] = np.diagonal(alike, by)
        found += _runs(rows & ~at_home, by)
    return tuple(sorted(found, key=lambda shift: shift.first))


def shifts(alike: Flags) -> dict[int, int]:
    """Return by how many rows at least `FEWEST_SHIFTED` rows are shifted, with the number of these rows."""
    rows, places = np.nonzero(alike)
    by, counts = np.unique((places - rows)[places != rows], return_counts=True)
    return {int(one): int(count) for one, count in zip(by, counts, strict=True) if count >= FEWEST_SHIFTED}


def alike_rows(key: Key, student: StudentTable, stands: Flags | None = None) -> Flags:
    """Return which rows (n) agree with which rows of the key (n), in every cell that is there, with their whole turns or without.

    Cells that are right where they stand (`stands`, (n, m + r)) may have been put right: they agree with any row of the key, but
    rows that are right where they stand only with their own.
    """
    there, known = np.isfinite(student.values), np.isfinite(key.table)
    tolerance = as_printed(key, np.nan_to_num(student.units))
    turns = np.zeros(there.shape) if student.turns is None else 2 * np.pi * student.turns
    alike = there.astype(int) @ known.T.astype(int) > there.shape[1] / 2
    for place in range(there.shape[1]):
        values, expected, off = student.values[:, place, None], key.table[None, :, place], tolerance[:, place, None]
        holds = near(values, expected, off) | near(values + turns[:, place, None], expected, off)
        alike &= holds | ~(there[:, place, None] & known[None, :, place]) | (False if stands is None else stands[:, place, None])
    if stands is not None:
        at_home = np.diagonal(alike).copy()
        alike[at_home] = np.eye(len(alike), dtype=bool)[at_home]
    return np.asarray(alike)


def _tolerance(key: Key, cells: Cells) -> Array:
    return as_printed(key, np.nan_to_num(cells.student.units))


def _runs(rows: Flags, by: int) -> list[Shift]:
    """Return the runs of at least `FEWEST_SHIFTED` successive rows."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], rows, [False]]).astype(int))).reshape(-1, 2)
    return [Shift(first + 1, last, by) for first, last in edges.tolist() if last - first >= FEWEST_SHIFTED]
