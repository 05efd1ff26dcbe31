"""The first wrong cell in the order of work, explained with the student's own numbers.

Enters: `Cells`, the table as it was read.  Leaves: `FirstWrong` or None.  Used by `grade.py`.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.ways import ANGLES, EARLIER, KEY, START, STEP, STEP_TRUE, rows_above
from coursework.grading.reading.student_work import Table
from coursework.grading.reading.table.headers import PRINTED
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# The unit of a rate that can be added to a coordinate in this unit: angles in degrees step with degrees per second.
_RATE_OF = {"rad": "rad/s", "deg": "deg/s", "m": "m/s", "mm": "mm/s", "cm": "cm/s"}
_MOST_DIGITS = 12  # of a number in a sentence
_TURN = 2 * math.pi
_SAID = {KEY: "key", ANGLES: "own angles", EARLIER: "own velocities", STEP: "step", STEP_TRUE: "step", START: "start"}


@frozen
class FirstWrong:
    """The first wrong cell: `row` from 1; `expected` and `tolerance` (SI) are those of the way that comes nearest."""

    t: float
    row: int
    column: str
    found: float
    expected: float
    tolerance: float
    way: str
    sentence: Sentence


@frozen
class _Shown:
    """How a column was handed in: its unit, the unit's size in SI, the whole turns that were taken off."""

    unit: str
    factor: float
    turns: int

    def number(self, value: float) -> float:
        """Return a value (SI) as it stands in the student's file."""
        return (value + self.turns * _TURN) / self.factor


def first_wrong(key: Key, cells: Cells, table: Table | None = None) -> FirstWrong | None:
    """Return the first wrong cell, row by row; in a row angles first, then velocities block by block, driven rates last.

    Its sentence tells the numbers as they stand in `table`, or in SI if no table is given.  None if no cell is wrong.
    """
    wrong = cells.wrong
    for row in np.flatnonzero(wrong.any(axis=1)).tolist():
        place = next(place for place in key.order if wrong[row, place])
        return _explained(key, cells, table, row, place)
    return None


def _shown(key: Key, table: Table | None, name: str, row: int) -> _Shown:
    si = key.variant.unit_of(name)
    column = table.column(name) if table else None
    if column is None:
        return _Shown(si, 1.0, 0)
    known = PRINTED.get(si.replace("rad/s", "1/s"), {})
    turns = column.turns[row] if column.turns else 0
    return _Shown("rad/s" if column.unit == "1/s" else column.unit, known.get(column.unit, 1.0), turns)


def _explained(key: Key, cells: Cells, table: Table | None, row: int, place: int) -> FirstWrong:
    found = float(cells.student.values[row, place])
    way, expected, tolerance = _nearest(key, cells, row, place)
    name = key.names[place]
    shown = _shown(key, table, name, row)
    off = tolerance / shown.factor
    places = 1 - math.floor(math.log10(off)) if off > 0 else _MOST_DIGITS  # so that a tenth of the tolerance is visible

    def number(value: float, as_shown: _Shown = shown) -> float:
        return float(f"{round(as_shown.number(value), places):.{_MOST_DIGITS}g}") + 0.0  # 0 for -0

    stated = replace(shown, turns=0) if way == START else shown  # a start value is told as it stands in the task
    before = int(rows_above(cells.student.values)[row - 1]) if row else 0
    values: dict[str, object] = {
        "row": _told(key, table, row), "name": name, "found": number(found), "expected": number(expected, stated),
        "before": _told(key, table, before),
        "tolerance": float(f"{off:.2g}"), "unit": shown.unit,
    }  # fmt: skip
    said = _SAID[way].replace(" ", "_")
    if way in {STEP, STEP_TRUE}:
        rate = _shown(key, table, key.velocities[place % key.m], row)
        if row - before > 1:
            said, values["steps"] = "step_several", row - before
        elif way == STEP_TRUE:
            said = "step_true"
        elif place >= key.m or rate.unit != _RATE_OF.get(shown.unit):  # the step of a free rate is made with an acceleration
            said = "step_alone"
        else:
            used = cells.student.values[row - 1]
            speed = rate.number(float(used[key.m + place]))
            rate_shown = float(f"{abs(speed):.{_MOST_DIGITS}g}")
            values |= {
                "start": number(float(used[place])),
                "sign": "−" if speed < 0 else "+",
                "rate": rate_shown,
                "step": key.step,
            }
    sentence = say(f"marking.first.{said}", **values)
    return FirstWrong(float(key.t[row]), row + 1, name, found, expected, tolerance, _SAID[way], sentence)


def _told(key: Key, table: Table | None, row: int) -> Sentence | int:
    """Return the number of a row (from 0) as a person is told it: with its time and place in the file, if that is another."""
    if table is None or table.rows[row] in (0, row + 1):
        return row + 1
    return say("marking.first.row_of_file", row=row + 1, t=float(key.t[row]), at=table.rows[row])


def _nearest(key: Key, cells: Cells, row: int, place: int) -> tuple[str, float, float]:
    """Return the way that comes nearest to a cell: its name, the expected value, its tolerance."""
    if row == 0 and place < key.m:
        return START, float(key.table[0, place]), float(0.5 * (cells.student.units[0, place] + key.told_to[place]))
    found = float(cells.student.values[row, place])
    said = [(way.name, float(way.expected[row, place]), float(way.tolerance[row, place])) for way in cells.ways]
    said = [entry for entry in said if np.isfinite(entry[1])]
    closest = min(abs(found - expected) for _, expected, _ in said)
    # If the key and the student's own cells are about as near, the student's own numbers explain more.
    near = [entry for entry in said if abs(found - entry[1]) <= closest + entry[2]]
    return next((entry for entry in near if entry[0] != KEY), near[0])
