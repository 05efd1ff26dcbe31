"""Marked cells -> the share of the table's points, with the gates that give nothing for nonsense.

Enters: `Cells`.  Leaves: `TablePoints`, `Earned`.  Used by `grade.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import GIVEN, KEY, SLACK, STEP, STEP_TRUE, Cells
from coursework.system.arrays import Array, Flags

# Rows whose velocities are all shown and right, below which steps made with them prove nothing; right cells below each other,
# fewer of which are chance.
ENOUGH_ROWS, RUN = 0.6, 5
_CONSTANT = 1e-9
# Of a step: the part of the largest one-step gap to spare, the coordinates of a row that must be near, the rows that must follow.
_SPARE, _MOST, _FOLLOWING = 0.25, 0.66, 0.75


GATES = ("start", "used_velocity", "rows", "motion", "chance")
Rule = Literal["cells", "start", "misconception", "own_equations"]


@dataclass(frozen=True, slots=True)
class TablePoints:
    """`share` of the table earned by its cells; how many cells count; whether row 1 is right.

    `shut` counts the cells that are right and do not count, by the gate that closed: row 1 is wrong ("start"), a step was made
    with a velocity that is wrong or not there ("used_velocity"), too few rows have all velocities right ("rows"), the row
    belongs to no motion ("motion"), single right cells are chance ("chance").  `uncounted` (n, m + r) is where they stand.
    """

    share: float
    cells: int
    start_right: bool
    shut: Mapping[str, int] = field(default_factory=dict)
    uncounted: Flags | None = None


@dataclass(frozen=True, slots=True)
class Earned:
    """How the points of a table came about: the best of what several rules give.

    `share` of the points by `rule`; `of_cells` the share by cells alone; `explained` the share of cells that the rule's
    explanation covers (0 for "cells") and `worth` the number of the rubric it was multiplied by (1 for "cells"); `cause` the code
    of the misconception or start, or the number of the student's own equation, "" for "cells"; `shut` as in `TablePoints`.
    """

    share: float
    rule: Rule
    of_cells: float
    explained: float
    worth: float
    cause: str
    shut: Mapping[str, int]


def best_rule(points: TablePoints, *others: Earned) -> Earned:
    """Return what earns most; of equal ones the cells, then the first."""
    by_cells = Earned(points.share, "cells", points.share, 0.0, 1.0, "", points.shut)
    return max((by_cells, *others), key=lambda earned: earned.share)


def table_points(key: Key, cells: Cells, carried: float = 1.0) -> TablePoints:
    """Return the points of a table; `carried` is the worth of a cell that is right from the student's own cells only."""
    m, r = len(key.coordinates), len(key.velocities)
    rows = len(key.table)
    count = rows * (m + r) - m
    marks = cells.marks
    right = ~cells.wrong & ~cells.missing
    start_right = bool(np.all(~cells.wrong[0])) if rows else False
    rows_enough = bool(np.mean(np.all(right[:, m:], axis=1)) >= ENOUGH_ROWS) if rows else False
    credit = np.where(marks == KEY, 1.0, 0.0)
    follows = rows_that_follow(key, cells)
    closed: dict[str, Flags] = {}
    if start_right:
        credit[cells.carried] = carried
        steps = np.isin(marks[:, :m], (STEP, STEP_TRUE))
        open_gate = np.zeros_like(steps)
        open_gate[1:] = right[:-1, m : 2 * m] & (_moves(cells.student.values[:, :m]) | ~_moves(key.table[:, :m]))
        closed["used_velocity"] = _padded(steps & ~open_gate, r)
        closed["rows"] = _padded(steps & ~np.full_like(steps, rows_enough), r)
        closed["motion"] = cells.carried & ~follows[:, None]
        closed["motion"][:, :m] = False
    else:
        closed["start"] = cells.carried
    # What never changes is right in any row, whatever else stands there.
    still = key.ranges <= _CONSTANT * np.max(np.abs(key.table), axis=0)
    closed["motion"] = closed.get("motion", np.zeros_like(right)) | (right & still & ~follows[:, None])
    if not (rows_enough and follows[1:].any()):
        closed["chance"] = right & ~_in_a_run(marks == KEY)
    shut: dict[str, int] = {}
    uncounted = np.zeros_like(right)
    for gate in GATES:
        if gate in closed:
            gone = closed[gate] & (marks != GIVEN) & (credit > 0 if gate != "start" else right)
            shut |= {gate: int(gone.sum())} if gone.any() else {}
            uncounted |= gone
            credit[closed[gate]] = 0.0
    credit[marks == GIVEN] = 0.0
    return TablePoints(float(credit.sum()) / count if count else 0.0, count, start_right, shut, uncounted)


def _padded(steps: Flags, velocities: int) -> Flags:
    """Return flags of angles (n, m) as flags of a table (n, m + velocities)."""
    return np.hstack([steps, np.zeros((len(steps), velocities), dtype=bool)])


def rows_that_follow(key: Key, cells: Cells) -> Flags:
    """Return which rows (n,) belong to a motion: the way from or to a neighbour lies between what both velocities make of a step.

    Any scheme passes, with a part of the one-step gap to spare, and a coordinate in three may be wrong.  Rows that are copied,
    shuffled or invented follow nothing, and what is right in them from each other is no work; where few rows follow, none does.
    """
    m, h = len(key.coordinates), key.step
    q, w = cells.student.values[:, :m], cells.student.values[:, m : 2 * m]
    units = cells.student.units
    with np.errstate(invalid="ignore"):
        largest = np.max(h / 2 * np.abs(np.diff(key.table[:, m : 2 * m], axis=0)), axis=0, initial=0.0)
        own = np.minimum(h / 2 * np.abs(np.diff(w, axis=0)), largest)
        spare = _SPARE * largest + SLACK * key.ranges[:m] + np.fmax(units[1:, :m], h * units[1:, m : 2 * m])
        near = np.abs(np.diff(q, axis=0) - h / 2 * (w[1:] + w[:-1])) <= own + spare
    moves = _moves(q).any(axis=1) | ~_moves(key.table[:, :m]).any(axis=1)
    joined = (np.mean(near, axis=1) >= _MOST) & moves
    follows = np.zeros(len(q), dtype=bool)
    follows[1:] |= joined
    follows[:-1] |= joined
    present = np.isfinite(q).any(axis=1)
    if follows[present].sum() < _FOLLOWING * present.sum():
        follows[:] = False
    follows[:1] = True
    return follows


def _in_a_run(right: Flags) -> Flags:
    """Return where a cell (n, k) is one of several right ones below each other; fewer are right by chance."""
    if len(right) < RUN:
        return right
    whole: Flags = np.asarray(np.lib.stride_tricks.sliding_window_view(right, RUN, axis=0).all(axis=-1))
    run = np.zeros_like(right)
    for place in range(RUN):
        run[place : place + len(whole)] |= whole
    return run


def stands_still(key: Key, cells: Cells) -> bool:
    """Return whether no coordinate of a table moves, although the key's do."""
    m = len(key.coordinates)
    return not _moves(cells.student.values[:, :m]).any() and bool(_moves(key.table[:, :m]).any())


def _moves(angles: Array) -> Flags:
    """Return where a coordinate (n, m) is another than in the row before (n - 1, m)."""
    return np.asarray(np.abs(np.diff(angles, axis=0)) > _CONSTANT)


def true_steps(key: Key, cells: Cells) -> Flags:
    """Return which steps of angles (n - 1, m) follow from the printed row before, where both are there."""
    step = next(way for way in cells.ways if way.name == STEP)
    m = len(key.coordinates)
    return np.asarray(step.holds(cells.student.values)[1:, :m])
