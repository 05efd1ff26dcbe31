"""Marks of the answers measured in the graph-analytical check, with the tolerance of a drawing.

Enters: answer lines, a `Key`, the rubric.  Leaves: `AnswerMarks`.  Used by `grade.py`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Literal

import numpy as np

from coursework.grading.marking.equations.probe import names_at
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.rubric import Answer
from coursework.grading.reading.student_work import AnswerLine
from coursework.system.frozen import frozen

# An answer off by up to this many tolerances earns half: the construction was made, but read badly.
HALF_CREDIT = 2.0
CLEARLY = 5.0  # a wrong force is named after a slip if it agrees with the slip's value within tolerance / CLEARLY
_DIFFERENCE = 1e-5  # of a step: with it a central difference of a position is right to ten digits


@frozen
class AnswerMark:
    """One answer: the value found and the one expected (SI), the tolerance, and the verdict."""

    name: str
    found: float | None
    expected: float
    tolerance: float
    verdict: Literal["right", "half", "wrong", "blank", "unreadable"]
    slip: str = ""  # of a wrong force: the code of the slip that gives this value

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        return {name: value for name, value in asdict(self).items() if name != "slip" or value}


@frozen
class AnswerMarks:
    """The marks of all answers that the rubric asks for."""

    marks: tuple[AnswerMark, ...]

    @property
    def share(self) -> float:
        """Return the share of the points earned; 1 if no answer can be asked for."""
        worth = {"right": 1.0, "half": 0.5}
        return sum(worth.get(mark.verdict, 0.0) for mark in self.marks) / len(self.marks) if self.marks else 1.0


def mark_answers(key: Key, asked: Sequence[Answer], lines: Sequence[AnswerLine]) -> AnswerMarks:
    """Return the marks of every answer in `asked`; if a name stands in several lines, the last one counts.

    An answer that has no value in its row is left out: the motion stops before that row, or the reaction is not unique.
    """
    handed_in = {line.name: line for line in lines}
    rows = [(answer.row or key.variant.time.row_of_check) - 1 for answer in asked]
    reached = [(answer, row) for answer, row in zip(asked, rows, strict=True) if row < len(key.exact)]
    marks = (_mark(key, answer, row, handed_in.get(answer.name)) for answer, row in reached)
    return AnswerMarks(tuple(mark for mark in marks if math.isfinite(mark.expected)))


def _mark(key: Key, answer: Answer, row: int, line: AnswerLine | None) -> AnswerMark:
    expected, table, largest = _expected(key, answer.of, row)
    tolerance = answer.tolerance * largest
    if line is None or line.value is None:
        unread = line is not None and line.state == "unreadable"
        return AnswerMark(answer.name, None, expected, tolerance, "unreadable" if unread else "blank")
    # A drawing gives sizes: a size without its sign is accepted, a wrong sign is not.
    off = min(abs(line.value - right) for one in (expected, table) for right in (one, abs(one)))
    verdict: Literal["right", "half", "wrong"] = "wrong"
    if off <= tolerance * (1 + 1e-12):
        verdict = "right"
    elif off <= HALF_CREDIT * tolerance * (1 + 1e-12):
        verdict = "half"
    slip = _slip(key, answer, row, line.value, tolerance) if verdict == "wrong" else ""
    return AnswerMark(answer.name, line.value, expected, tolerance, verdict, slip)


def _slip(key: Key, answer: Answer, row: int, value: float, tolerance: float) -> str:
    """Return the code of the slip whose force is nearest to `value`; "" if none is near or the answer is no force."""
    if key.forces is None or answer.of not in key.forces.names:
        return ""
    slips = {code: float(rows[row]) for code, rows in key.forces.columns(answer.of)[2].items()}
    off = {code: min(abs(value - one), abs(value - abs(one))) for code, one in slips.items()}
    code = min(off, key=lambda code: off[code])
    return code if off[code] <= tolerance / CLEARLY else ""


def _expected(key: Key, of: str, row: int) -> tuple[float, float, float]:
    """Return the exact value in `row` (from 0), the table's value, and the largest of its kind in that row.

    Only for a force are the first two different.
    """
    if key.forces is not None and of in key.forces.names:
        return key.forces.right(of, row)
    if of in key.names:
        place = key.names.index(of)
        unit = key.variant.unit_of(of)
        alike = [index for index, name in enumerate(key.names) if key.variant.unit_of(name) == unit]
        value = float(key.exact[row, place])
        return value, value, float(np.max(np.abs(key.exact[row, alike])))
    speeds = {name: _speed(key, name, row) for name, _ in key.variant.points}
    value = speeds[of.removeprefix("v_")]
    return value, value, max(speeds.values())


def _speed(key: Key, point: str, row: int) -> float:
    """Return the speed (m/s) of a point in a row of the exact motion."""
    q, rates = key.exact[row, : key.m], key.exact[row, key.m : 2 * key.m]
    h = _DIFFERENCE * key.step
    t = key.t[row] + np.array([-h, h])
    positions = names_at(key, t, q + np.outer([-h, h], rates))[point]
    return float(abs(positions[1] - positions[0]) / (2 * h))
