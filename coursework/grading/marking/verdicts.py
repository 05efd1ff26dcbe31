"""Verdicts on equations, integration and arithmetic: they tell a misunderstanding from a slip.

Enters: marks.  Leaves: `Verdicts`.  Used by `grade.py`, and by the sentence that says how many steps are Euler's.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.misconceptions import FEWEST, FEWEST_SHARE
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.points import true_steps
from coursework.grading.marking.table_marks import TableMarks
from coursework.system.arrays import Flags
from coursework.system.frozen import frozen

# The integration is right from this part of the steps on; with fewer rows than LEAST_ROWS it cannot be judged.
FOLLOWED, LEAST_ROWS = 0.93, 3


@frozen
class Verdicts:
    """Three independent verdicts."""

    equations: Literal["right", "wrong", "none"]
    integration: Literal["right", "wrong", "unknown"]
    arithmetic: Literal["right", "slip", "unknown"]


def verdicts(key: Key, table: TableMarks | None, equations: EquationMarks | None) -> Verdicts:
    """Return the verdicts on a submission; without a table, those on integration and arithmetic are unknown."""
    first: Literal["right", "wrong", "none"] = "none"
    if equations is not None:
        complete = equations.independent == equations.needed and not equations.wrong
        first = "none" if equations.unread else "right" if complete else "wrong"
    if table is None:
        return Verdicts(first, "unknown", "unknown")
    return Verdicts(first, _integration(key, table.cells), _arithmetic(table))


def telling_steps(key: Key, cells: Cells) -> Flags:
    """Return which steps (n - 1, m) can be judged: Euler's rule makes the coordinate, and the cells that it needs are there."""
    there = np.isfinite(cells.student.values)
    return np.asarray(there[1:, : key.m] & there[:-1, : key.m] & there[:-1, key.m : 2 * key.m] & key.stepped)


def euler_steps(key: Key, cells: Cells) -> tuple[int, int]:
    """Return how many steps follow by Euler's rule from the printed row before, and how many can be judged."""
    speaks = telling_steps(key, cells)
    return int((true_steps(key, cells) & speaks).sum()), int(speaks.sum())


def _integration(key: Key, cells: Cells) -> Literal["right", "wrong", "unknown"]:
    rows = int(np.all(np.isfinite(cells.student.values[:, : key.m]), axis=1).sum())
    held, spoken = euler_steps(key, cells)
    if rows < LEAST_ROWS or not spoken:
        return "unknown"
    return "right" if held / spoken >= FOLLOWED else "wrong"


def _arithmetic(table: TableMarks) -> Literal["right", "slip", "unknown"]:
    wrong = int(table.cells.wrong.sum())
    if not wrong:
        return "right"
    few = table.misconception is None and wrong <= max(FEWEST, FEWEST_SHARE * table.points.cells)
    return "slip" if few else "unknown"
