"""Equations, integration, arithmetic: what was understood and what was only slipped, told apart.

Enters: marks.  Leaves: `Verdicts`.  Used by `grade.py`, and by what says how many steps are Euler's.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from coursework.grading.marking.equations.equations import EquationMarks
from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.misconceptions import FEWEST, FEWEST_SHARE, Misconception
from coursework.grading.marking.table.points import TablePoints, true_steps
from coursework.system.frozen import frozen

# Steps that follow from the row before, from which on the integration is right; rows below which nobody can tell.
FOLLOWED, LEAST_ROWS = 0.93, 3


@frozen
class Verdicts:
    """Three verdicts that do not depend on each other."""

    equations: Literal["right", "wrong", "none"]
    integration: Literal["right", "wrong", "unknown"]
    arithmetic: Literal["right", "slip", "unknown"]


def verdicts(
    key: Key, cells: Cells | None, points: TablePoints | None, equations: EquationMarks | None, named: Misconception | None
) -> Verdicts:
    """Return the verdicts of a submission; a table that is not there leaves two of them unknown."""
    first: Literal["right", "wrong", "none"] = "none"
    if equations is not None:
        complete = equations.independent == equations.needed and not equations.wrong
        first = "none" if equations.unread else "right" if complete else "wrong"
    if cells is None or points is None:
        return Verdicts(first, "unknown", "unknown")
    return Verdicts(first, _integration(key, cells), _arithmetic(cells, points, named))


def euler_steps(key: Key, cells: Cells) -> tuple[int, int]:
    """Return how many steps of the coordinates are Euler's from the printed row before, and of how many that can be told."""
    m = len(key.coordinates)
    there = np.isfinite(cells.student.values)
    speaks = there[1:, :m] & there[:-1, :m] & there[:-1, m : 2 * m] & key.stepped
    return int((true_steps(key, cells) & speaks).sum()), int(speaks.sum())


def _integration(key: Key, cells: Cells) -> Literal["right", "wrong", "unknown"]:
    m = len(key.coordinates)
    rows = int(np.all(np.isfinite(cells.student.values[:, :m]), axis=1).sum())
    held, spoken = euler_steps(key, cells)
    if rows < LEAST_ROWS or not spoken:
        return "unknown"
    return "right" if held / spoken >= FOLLOWED else "wrong"


def _arithmetic(cells: Cells, points: TablePoints, named: Misconception | None) -> Literal["right", "slip", "unknown"]:
    wrong = int(cells.wrong.sum())
    if not wrong:
        return "right"
    if named is not None:
        return "unknown"
    return "slip" if wrong <= max(FEWEST, FEWEST_SHARE * points.cells) else "unknown"
