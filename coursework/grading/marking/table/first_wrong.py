"""The first wrong cell in the order of work, explained with the student's own numbers.

Enters: `Cells`.  Leaves: `FirstWrong` or None.  Used by `grade.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import ANGLES, EARLIER, KEY, START, STEP, STEP_TRUE, Cells
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_SAID = {KEY: "key", ANGLES: "own angles", EARLIER: "own velocities", STEP: "step", STEP_TRUE: "step", START: "start"}


@dataclass(frozen=True, slots=True)
class FirstWrong:
    """`row` from 1; `expected` and `tolerance` by the way that comes nearest, SI."""

    t: float
    row: int
    column: str
    found: float
    expected: float
    tolerance: float
    way: str
    sentence: Sentence

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        return {
            "t": self.t, "row": self.row, "column": self.column, "found": self.found, "expected": self.expected,
            "tolerance": self.tolerance, "way": self.way, "sentence": self.sentence,
        }  # fmt: skip


def first_wrong(key: Key, cells: Cells) -> FirstWrong | None:
    """Return the first wrong cell: rows downwards; in a row angles, then velocities block by block, driven rates last."""
    wrong = cells.wrong
    for row in np.flatnonzero(wrong.any(axis=1)).tolist():
        place = next(place for place in key.order if wrong[row, place])
        return _explained(key, cells, row, place)
    return None


def _explained(key: Key, cells: Cells, row: int, place: int) -> FirstWrong:
    found = float(cells.student.values[row, place])
    m = len(key.coordinates)
    if row == 0 and place < m:
        nearest = START, float(key.table[0, place]), float(0.5 * cells.student.units[0, place])
    else:
        said = [(way.name, float(way.expected[row, place]), float(way.tolerance[row, place])) for way in cells.ways]
        said = [entry for entry in said if np.isfinite(entry[1])]
        closest = min(abs(found - expected) for _, expected, _ in said)
        # Where the key and the student's own cells say the same, the student's own numbers explain more.
        near = [entry for entry in said if abs(found - entry[1]) <= closest + entry[2]]
        nearest = next((entry for entry in near if entry[0] != KEY), near[0])
    way, expected, tolerance = nearest
    name = key.names[place]
    values: dict[str, object] = {"row": row + 1, "name": name, "found": found, "expected": expected, "before": row}
    values["unit"] = key.variant.unit_of(name)
    if way in {STEP, STEP_TRUE}:
        used = cells.student.values[row - 1]
        values |= {"start": float(used[place]), "rate": float(used[m + place]), "step": key.step}
        values["rate_name"] = key.velocities[place]
    sentence = say(f"marking.first.{_SAID[way].replace(' ', '_')}", **values)
    if way == STEP_TRUE and not np.isfinite(values["rate"]):  # type: ignore[call-overload]
        sentence = say("marking.first.step_alone", **values)
    return FirstWrong(float(key.t[row]), row + 1, name, found, expected, tolerance, _SAID[way], sentence)
