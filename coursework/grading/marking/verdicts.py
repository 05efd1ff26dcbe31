"""Equations, integration, arithmetic: what was understood and what was only slipped, told apart.

Enters: marks.  Leaves: `Verdicts` and the sentence that follows from the three.  Used by `grade.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from coursework.grading.marking.equations.equations import EquationMarks
from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.misconceptions import FEWEST, FEWEST_SHARE, Misconception
from coursework.grading.marking.table.points import TablePoints, true_steps
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# Steps that follow from the row before, from which on the integration is right; rows below which nobody can tell.
FOLLOWED, LEAST_ROWS = 0.93, 3


@dataclass(frozen=True, slots=True)
class Verdicts:
    """Three verdicts that do not depend on each other."""

    equations: Literal["right", "wrong", "none"]
    integration: Literal["right", "wrong", "unknown"]
    arithmetic: Literal["right", "slip", "unknown"]
    unread: bool = False  # equations that wait for a person: "none" in grades.json

    def plain(self) -> dict[str, str]:
        """Return the three as grades.json writes them."""
        return {"equations": self.equations, "integration": self.integration, "arithmetic": self.arithmetic}

    @property
    def sentence(self) -> Sentence:
        """Return what the three mean together."""
        told = self.plain() | ({"equations": "unread"} if self.unread else {})
        return joined([say(f"marking.verdict.{name}.{verdict}") for name, verdict in told.items()])


def verdicts(
    key: Key, cells: Cells | None, points: TablePoints | None, equations: EquationMarks | None, named: Misconception | None
) -> Verdicts:
    """Return the verdicts of a submission; a table that is not there leaves two of them unknown."""
    first: Literal["right", "wrong", "none"] = "none"
    if equations is not None:
        complete = equations.independent == equations.needed and not equations.wrong
        first = "none" if equations.unread else "right" if complete else "wrong"
    unread = equations is not None and equations.unread is not None
    if cells is None or points is None:
        return Verdicts(first, "unknown", "unknown", unread)
    return Verdicts(first, _integration(key, cells), _arithmetic(cells, points, named), unread)


def _integration(key: Key, cells: Cells) -> Literal["right", "wrong", "unknown"]:
    m = len(key.coordinates)
    there = np.isfinite(cells.student.values)
    rows = int(np.all(there[:, :m], axis=1).sum())
    speaks = there[1:, :m] & there[:-1, :m] & there[:-1, m : 2 * m]
    if rows < LEAST_ROWS or not speaks.any():
        return "unknown"
    return "right" if float(true_steps(key, cells)[speaks].mean()) >= FOLLOWED else "wrong"


def _arithmetic(cells: Cells, points: TablePoints, named: Misconception | None) -> Literal["right", "slip", "unknown"]:
    wrong = int(cells.wrong.sum())
    if not wrong:
        return "right"
    if named is not None:
        return "unknown"
    return "slip" if wrong <= max(FEWEST, FEWEST_SHARE * points.cells) else "unknown"
