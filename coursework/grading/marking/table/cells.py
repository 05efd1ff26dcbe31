"""Each cell of a table marked right in some way or wrong: against the key, or against the student's cells it was made from.

Enters: a `Key` and the student's table on its grid.  Leaves: `Cells`.  Used by the points, the first wrong cell, the pages.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.restored import restored
from coursework.grading.marking.table.ways import (
    ANGLES,
    EARLIER,
    HALF,
    KEY,
    START,
    STEP,
    STEP_TRUE,
    StudentTable,
    Way,
    as_printed,
    near,
    own_ways,
)
from coursework.system.arrays import Array, Flags

Marks = NDArray[np.str_]

_PART_OF_PLACE = 1e-3  # round-off, as a part of the unit of the last place
_ROUND_OFF = 1e-12
_KEPT = 8  # marks of so many tables
WRONG, MISSING, GIVEN = "wrong", "missing", "given"
# Ways in which a cell is right only from the student's own earlier cells.
CARRIED = (ANGLES, EARLIER, STEP, STEP_TRUE)


@dataclass(frozen=True)
class Cells:
    """The marks of a table: `marks` (n, m + r) has the name of the way that holds, or "wrong", "missing", "given".

    `follows` (n, m + r): the cell follows from the student's own cells, or is a velocity of the key. `given` marks the right ones
    among the first `starts` cells of row 1, the start values. `ways` are in the order tried. `too_coarse`: the cell has too few
    digits to show anything. `computed_to`: decimals of the work if it is coarser than its print, else None. `fitted`: wrong cells
    that tell what others were. `before`: the table before cells were put right, None if none was.
    """

    student: StudentTable
    marks: Marks
    follows: Flags
    ways: tuple[Way, ...]
    too_coarse: Flags
    computed_to: int | None
    starts: int
    fitted: Flags
    before: StudentTable | None = None

    def way(self, name: str) -> Way:
        """Return the way with this name."""
        return next(way for way in self.ways if way.name == name)

    @property
    def wrong(self) -> Flags:
        """Return the cells that are shown and right in no way."""
        return np.asarray(self.marks == WRONG)

    @property
    def counted(self) -> Flags:
        """Return the cells that count: all except the start values, which the task gives."""
        found = np.ones(self.marks.shape, dtype=bool)
        found[:1, : self.starts] = False
        return found

    @property
    def missing(self) -> Flags:
        """Return the cells that cannot be judged."""
        return np.asarray(self.marks == MISSING)

    @property
    def judged(self) -> Flags:
        """Return the cells that count and can be judged."""
        return self.counted & ~self.missing

    @property
    def right(self) -> Flags:
        """Return the cells that count and are right in some way."""
        return self.judged & ~self.wrong

    @property
    def carried(self) -> Flags:
        """Return the cells that are right only from the student's own earlier cells."""
        return np.isin(self.marks, CARRIED)


def alike(key: Key, student: StudentTable, table: Array) -> Flags:
    """Return which cells (n, m + r) agree with those of `table` as far as they are printed; a missing cell does not."""
    return near(student.values, table, as_printed(key, student.units))


def marks_by(key: Key, student: StudentTable, ways: Sequence[Way], given: Flags) -> tuple[Marks, Flags]:
    """Return the marks (n, m + r) by the first way that holds, and the too coarse cells; `given` (1, m): right start values."""
    values = student.values
    with np.errstate(invalid="ignore"):
        datum = np.array([key.given.get(name, np.nan) for name in key.names])  # printed whole, it hides nothing
        shown = np.isfinite(values) & ((student.units <= key.coarsest) | (np.abs(values - datum) <= _ROUND_OFF * np.abs(datum)))
    marks = np.full(values.shape, WRONG, dtype="<U16")
    for way in reversed(ways):
        marks[way.holds(values)] = way.name
    marks[:1, : given.shape[1]] = np.where(given, GIVEN, WRONG)
    marks[~shown] = MISSING
    return marks, ~shown & np.isfinite(values)


def _cut_off(start: Array, printed: Array, units: Array) -> Flags:
    """Return which start values (1, m) are the task's with further digits cut off instead of rounded."""
    with np.errstate(invalid="ignore", divide="ignore"):
        places = np.floor(np.abs(start) / units + _PART_OF_PLACE) * np.sign(start)
        return np.asarray(np.abs(printed / units - places) < _PART_OF_PLACE)


def mark_cells(key: Key, student: StudentTable, table: Array | None = None) -> Cells:
    """Return the marks of all cells; `table` (n, m + r) replaces the key's if the motion begins elsewhere."""
    return _by_key(key, student) if table is None else _marked(key, student, table)


@lru_cache(_KEPT)
def _by_key(key: Key, student: StudentTable) -> Cells:
    """Return the marks by the key; whether a table is clockwise, and each cause that takes it back, asks for the same."""
    return _marked(key, student, key.table)


def _marked(key: Key, student: StudentTable, table: Array) -> Cells:
    m, values = key.m, student.values
    own = own_ways(key, student)
    units = student.units.copy()
    units[:, :m] = np.maximum(units[:, :m], own.coarse)  # work coarser than its print misses the key by as much
    ways = (Way(KEY, table, as_printed(key, units)), *own.tried)
    start = Way(START, table[:1, :m], HALF * (student.units[:1, :m] + key.told_to) + _ROUND_OFF)
    begins = start.holds(values[:1, :m]) | _cut_off(table[:1, :m], values[:1, :m], student.units[:1, :m])
    marks, too_coarse = marks_by(key, student, ways, begins)
    follows = own.holds(values)
    follows[:, m:] |= ways[0].holds(values)[:, m:]
    before, fitted = None, np.zeros(marks.shape, dtype=bool)
    if (marks == WRONG).any():
        # In a motion from another start, a cell with the task's value was put right; one with that motion's value was not.
        right = marks == KEY if table is key.table else alike(key, student, key.table) & (marks != KEY)
        made = restored(key, student, marks == WRONG, right, own)
        before, fitted = made.before, made.fitted
        for way in reversed(made.ways):  # a true step is tried before a step with a velocity that may be wrong
            holds = way.holds(values)
            holds[:1, :m] = False
            marks[holds & (marks == WRONG) & ~fitted] = way.name
            follows |= holds
    return Cells(student, marks, follows, ways, too_coarse, own.computed_to, m, fitted, before)
