"""Columns of forces in a table: right by the exact motion or by the assigned table; a wrong column is named after its slip.

Enters: a `Key`, a table as it was read, the names of the forces.  Leaves: `ForceColumns`.  Imported only if forces are asked for.
Used by `grade.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.ways import HALF
from coursework.grading.reading.student_work import Table
from coursework.grading.reading.submission import Note, note
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.words.sentences import say

# Tolerance, as a part of the largest force of a column: forces are computed from printed rows, whose digits they magnify.
CLOSE = 0.01
EXPLAINS = 0.8  # a slip is named if it gives this part of the cells that are filled in


@frozen
class ForceColumn:
    """One column of `count` cells: how many are right or missing, and how many its `slip` explains ("" if no slip does)."""

    name: str
    count: int
    right: int
    missing: int
    slip: str = ""
    explained: int = 0


@frozen
class ForceColumns:
    """All columns of forces that were asked for; `worth` is what a cell earns that a slip explains."""

    columns: tuple[ForceColumn, ...]
    worth: float

    @property
    def count(self) -> int:
        """Return the number of cells in all columns."""
        return sum(one.count for one in self.columns)

    @property
    def earned(self) -> float:
        """Return what the columns earn, counted in cells."""
        return sum(max(float(one.right), self.worth * one.explained) for one in self.columns)

    def plain(self) -> list[dict[str, Any]]:
        """Return the records as grades.json writes them."""
        return [
            {"name": one.name, "cells": one.count, "right": one.right, "missing": one.missing, "slip": one.slip}
            for one in self.columns
        ]

    def notes(self) -> list[Note]:
        """Return a note for each column that is not all right."""
        return [_told(one) for one in self.columns if one.right < one.count]


def _told(one: ForceColumn) -> Note:
    known = {"name": one.name, "right": one.right, "count": one.count}
    if not one.slip:
        return note("force_column", **known)
    return note("force_column", "force_column_slip", **known, slip=say(f"forces.slip.{one.slip}"))


def mark_forces(key: Key, table: Table, names: Sequence[str], worth: float) -> ForceColumns:
    """Return the marks of the columns of forces called `names`; `worth` is what a cell earns that a slip explains."""
    return ForceColumns(tuple(_column(key, table, name) for name in names), worth)


def _column(key: Key, table: Table, name: str) -> ForceColumn:
    assert key.forces is not None
    exact, assigned, slips = key.forces.columns(name)
    count = min(len(exact), len(assigned), len(key.table))
    column = table.column(name)
    if column is None:
        return ForceColumn(name, count, 0, count)
    values, digits = np.array(column.values[:count]), np.nan_to_num(np.array(column.last_place[:count]))

    def holds(expected: Array) -> Flags:
        room = HALF * digits + CLOSE * float(np.nanmax(np.abs(expected[:count]), initial=0.0))
        with np.errstate(invalid="ignore"):
            return np.asarray(np.abs(values - expected[:count]) <= room)

    right, there = holds(exact) | holds(assigned), int(np.isfinite(values).sum())
    found, slip = int(right.sum()), ("", 0)
    if found < count:
        explained = {code: int(holds(rows).sum()) for code, rows in slips.items()}
        code = max(explained, key=lambda code: explained[code])
        if explained[code] >= EXPLAINS * max(there, 1) and explained[code] > found:
            slip = code, explained[code]
    return ForceColumn(name, count, found, count - there, *slip)
