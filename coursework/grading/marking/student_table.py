"""A table as it was read, put on the key's grid and into its columns.

Enters: a `Key`, a `Table`.  Leaves: `StudentTable`, the names of the columns that it lacks.
Used by `grade.py`, the reasons and `precheck.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.ways import HALF, OwnRows, StudentTable
from coursework.grading.reading.student_work import Table
from coursework.system.arrays import Array

# Two programs that compute the same table in another order differ in the decimals beyond this place (SI).
_COPIED = 1e-13


def student_of(key: Key, table: Table) -> StudentTable:
    """Return a table with all columns of the key, in its order; NaN where the student's table has none."""
    count = len(key.table)
    columns = {column.name: (column.values[:count], column.last_place[:count]) for column in table.columns}
    turns = np.zeros((count, len(key.names)))
    for place, name in enumerate(key.names):
        if (column := table.column(name)) and column.turns:
            turns[:, place] = column.turns[:count]
    own = None
    if table.own is not None:
        rows = len(next(iter(table.own.columns.values()))[0])
        own = OwnRows(table.own.step, *_filled(key, table.own.columns, rows))
    return StudentTable(*_filled(key, columns, count), turns, own)


def lacking(key: Key, table: Table) -> tuple[str, ...]:
    """Return the names of the columns that a table lacks, except those whose values the task gives."""
    return tuple(name for name in key.names if table.column(name) is None and name not in key.given)


def with_given(key: Key, student: StudentTable) -> StudentTable:
    """Return a table completed, in the rows it has, in the columns that it may leave out because the task gives them.

    What may be left out whole may be left out in single rows: a cell more in such a column takes nothing.
    """
    there = np.isfinite(student.values)
    empty = ~there & there.any(axis=1, keepdims=True) & np.array([name in key.given for name in key.names])
    if not empty.any():
        return student
    datum = np.array([key.given.get(name, np.nan) for name in key.names])
    fine = np.where(there.any(axis=0), np.fmax.reduce(student.units), np.nanmin(student.units))
    return replace(student, values=np.where(empty, datum, student.values), units=np.where(empty, fine, student.units))


def is_the_key(key: Key, student: StudentTable) -> bool:
    """Return whether a table equals the key in every digit and has more digits than two programs would share."""
    if np.array_equal(student.values, key.table):
        return True
    if np.isnan(student.units).any() or np.max(student.units) > _COPIED:
        return False
    return bool(np.all(np.abs(student.values - key.table) <= HALF * student.units + np.spacing(np.abs(key.table))))


def _filled(key: Key, columns: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]], rows: int) -> tuple[Array, Array]:
    """Return values and units of the last place, each (rows, m + r); NaN in columns that are not there."""
    values, units = np.full((rows, len(key.names)), np.nan), np.full((rows, len(key.names)), np.nan)
    for place, name in enumerate(key.names):
        if name in columns:
            values[:, place], units[:, place] = columns[name]
    return values, units
