"""A table as it was read, on the grid and in the columns of the key.

Enters: a `Key`, a `Table`.  Leaves: `StudentTable`.  Used by `grade.py` and `precheck.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.ways import OwnRows, StudentTable
from coursework.grading.reading.student_work import Table


def student_of(key: Key, table: Table) -> StudentTable:
    """Return a table as it was read, with a column of its own for everything the key has."""
    values, units, turns = np.full(key.table.shape, np.nan), np.full(key.table.shape, np.nan), np.zeros(len(key.names))
    for place, name in enumerate(key.names):
        if column := table.column(name):
            values[:, place], units[:, place] = column.values[: len(values)], column.last_place[: len(values)]
            turns[place] = column.turns
    return StudentTable(values, units, turns, _own_rows(key, table))


def _own_rows(key: Key, table: Table) -> OwnRows | None:
    """Return all rows of a table whose own times are those of another step."""
    if table.own is None:
        return None
    rows = len(next(iter(table.own.columns.values()))[0])
    values, units = np.full((rows, len(key.names)), np.nan), np.full((rows, len(key.names)), np.nan)
    for place, name in enumerate(key.names):
        if name in table.own.columns:
            values[:, place], units[:, place] = table.own.columns[name]
    return OwnRows(table.own.step, values, units)
