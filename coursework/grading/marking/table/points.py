"""Marked cells -> the share of the table's points, with gates that refuse points for nonsense.

Enters: `Cells`.  Leaves: `TablePoints`, `Earned`.  Used by `earning.py` and what it asks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import MISSING, Cells, alike
from coursework.grading.marking.table.untold import but, ramp, untold_steps
from coursework.grading.marking.table.ways import KEY, SLACK, STEP, STEP_TRUE, Places, StudentTable, put_right
from coursework.system.arrays import Array, Flags, neighbours, shifted
from coursework.system.frozen import frozen

# ENOUGH_ROWS: part of the rows that must have all velocities shown and right, or else steps made with them prove nothing; it also
# suffices if in _COLUMNS of the columns as many rows have the task's value.  RUN: fewer right cells in a column are chance.
ENOUGH_ROWS, _COLUMNS, RUN = 0.6, 0.5, 5
_CONSTANT = 1e-9
# _SPARE: extra tolerance of a step, as a part of the largest one-step gap.  _MOST: part of a row's coordinates that must be near.
# FEW_FOLLOWING: part of the rows that must follow before anything counts; FOLLOWING: for everything to count.
_SPARE, _MOST, FEW_FOLLOWING, FOLLOWING = 0.25, 0.66, 0.35, 0.75
# A coordinate that moves in this part of the rows may stand still in the others.
_MOVES = 0.33


Rule = Literal["cells", "start", "misconception", "own_equations"]


@frozen
class TablePoints:
    """The `share` of the table's points that its cells earn, and the number of `cells` that count.

    `shut` counts the right cells that do not count, by gate.  "start": row 1 is wrong.  "used_velocity": the step was made with a
    wrong velocity in a column with many wrong ones, or its coordinate does not move.  "rows": too few rows have all velocities
    right, and too few columns do.  "untold": the digits do not tell the step from other rules' steps.  "motion": the row belongs
    to no motion.  "chance": single right cells are chance.  `uncounted` (n, m + r) marks all these cells.
    """

    share: float
    cells: int
    shut: Mapping[str, int] = field(default_factory=dict)
    uncounted: Flags | None = None


@frozen
class Earned:
    """How the points of a table came about, by the best of several rules.

    `share` is what `rule` gives, `of_cells` what the cells alone give. `explained` is the share of cells that the rule's
    explanation covers (0 for "cells"), `worth` the rubric's factor for it (1 for "cells"). `cause` is the code of the
    misconception or start, or the number of the student's own equation, "" for "cells". `shut` is as in `TablePoints`.
    """

    share: float
    rule: Rule
    of_cells: float
    explained: float
    worth: float
    cause: str
    shut: Mapping[str, int]


def table_points(key: Key, cells: Cells, carried: float = 1.0, untold: Flags | None = None) -> TablePoints:
    """Return the points of a table; `carried` is what a cell earns that is right only from the student's own cells.

    `untold` (n, m + r) marks cells that are right only because their few digits hide what was done instead.
    """
    m = key.m
    marks = cells.marks
    untold = np.zeros_like(cells.counted) if untold is None else untold
    right = cells.right
    sound, rows = (right & ~untold) | cells.fitted, handed_in(cells)  # `fitted` were right before others were put right
    made = sound[rows, m:]
    excused = put_right(marks[rows, :m] == KEY).any(axis=1, keepdims=True)  # all may have been made from what stood there
    rows_enough = bool(len(rows)) and (
        np.mean(np.all(made | excused, axis=1)) >= ENOUGH_ROWS
        or np.mean(np.mean(marks[rows, m:] == KEY, axis=0) >= ENOUGH_ROWS) >= _COLUMNS
    )
    follows, motion = rows_that_follow(key, cells)
    works = motion if rows_enough and follows[1:].any() else 0.0
    steps = np.zeros_like(right)
    steps[:, :m] = np.isin(marks[:, :m], (STEP, STEP_TRUE))
    used = np.zeros_like(right)
    rates = sound[rows, m : 2 * m]
    used[rows[1:], :m] = rates[:-1] | (marks[rows[1:], :m] == STEP_TRUE) | (np.mean(rates, axis=0) >= ENOUGH_ROWS)
    used[rows[1:], :m] &= moves_as_it_may(key, cells)
    velocities = cells.carried & ~steps
    still = right & constant(key)
    shut = {
        "start": cells.carried & (_begins_wrong(cells, m) or (bool(cells.wrong[0, m:].any()) and not works)),
        "used_velocity": steps & ~used,
        "rows": steps & (not rows_enough),
        "untold": untold | untold_steps(key, cells, steps, rows),
        "motion": but((velocities | still) & follows[:, None], motion) | ((velocities | still) & ~follows[:, None]),
        "chance": but(right & ~in_a_run(marks == KEY, rows), works),
    }
    return credited(cells, carried, shut)


def credited(cells: Cells, carried: float, shut: Mapping[str, Flags]) -> TablePoints:
    """Return the points of the right cells except those that gates `shut`; `carried` is as in `table_points`."""
    credit = np.where(cells.carried, carried, np.where(cells.right, 1.0, 0.0))
    counts: dict[str, int] = {}
    uncounted = np.zeros_like(cells.counted)
    for gate, closed in shut.items():
        lost = closed & (credit > 0)
        counts |= {gate: int(lost.sum())} if lost.any() else {}
        uncounted |= lost
        credit[closed] = 0.0
    count = int(cells.counted.sum())
    # Start values are given and earn nothing; one that is copied wrong costs as much as any other wrong cell.
    earned = max(float(credit.sum()) - int(cells.wrong[:1, : cells.starts].sum()), 0.0)
    return TablePoints(earned / count if count else 0.0, count, counts, uncounted)


def handed_in(cells: Cells) -> Places:
    """Return row 1 and the rows in which anything was handed in: the others cost their cells, but no gate looks at them."""
    found = np.asarray(~cells.missing.all(axis=1))
    found[:1] = True
    return np.flatnonzero(found)


def constant(key: Key) -> Flags:
    """Return which columns (m + r,) never change: a right value in them says nothing about its row."""
    return np.asarray(key.ranges <= _CONSTANT * np.max(np.abs(key.table), axis=0))


def _begins_wrong(cells: Cells, m: int) -> bool:
    """Return whether a start value is wrong and was used: the first value below it is missing or not the key's."""
    for place in np.flatnonzero(cells.wrong[0, :m]).tolist():
        below = np.flatnonzero(cells.marks[1:, place] != MISSING)
        if not len(below) or cells.marks[1 + below[0], place] != KEY:
            return True
    return False


def rows_that_follow(key: Key, cells: Cells) -> tuple[Flags, float]:
    """Return which rows (n,) belong to a motion: the step from or to a neighbour lies between those by the velocities of both.

    Steps of any scheme pass, with a part of the one-step gap to spare, and one coordinate in three may be wrong. Rows that are
    copied, shuffled or invented follow from nothing, and right cells in them are no work. The second number is the part of
    such cells that counts (0 to 1); it falls as fewer rows follow.
    """
    m, rows = key.m, handed_in(cells)
    q, marks = cells.student.values[rows, :m], cells.marks[rows]
    near = _near_steps(key, cells.student, rows)
    if cells.before is not None:
        near |= _near_steps(key, cells.before, rows)
    steps = np.isin(marks[1:, :m], (STEP, STEP_TRUE)) & ~(cells.wrong & ~cells.fitted)[rows[:-1], m : 2 * m]
    steps |= left_open(key, cells, rows)
    moves = np.asarray(_moves(q).any(axis=1) | ~_moves(key.table[rows, :m]).any(axis=1))
    follows = np.zeros(len(cells.marks), dtype=bool)
    follows[rows], motion = following(q, near | steps, moves)
    return follows, motion


def left_open(key: Key, cells: Cells, rows: Places) -> Flags:
    """Return the steps (n - 1, m) between successive `rows` that no gate counts as broken: those to or from a right cell.

    It may have been put right, and all velocities of its row may have been made from what stood there; so no gate closes when
    one more cell becomes right: to the task's number, or to that of the table from another start that it is marked by.
    """
    m, right = key.m, (alike(key, cells.student, key.table) | (cells.marks == KEY))[rows]
    used = right[:-1, : 2 * m] & ~constant(key)[: 2 * m]
    put = put_right(right[:, :m])[:-1].any(axis=1, keepdims=True)
    return np.asarray(right[1:, :m] | used[:, :m] | used[:, m:] | put)


def _near_steps(key: Key, table: StudentTable, rows: Places) -> Flags:
    """Return which steps (n - 1, m) from row to row lie between those by the velocities of both rows, with some to spare."""
    m, h = key.m, np.diff(key.t[rows])[:, None]
    q, w, units = table.values[rows, :m], table.values[rows, m : 2 * m], table.units[rows]
    with np.errstate(invalid="ignore"):
        largest = np.max(h / 2 * np.abs(np.diff(key.table[rows, m : 2 * m], axis=0)), axis=0, initial=0.0)
        own = np.minimum(h / 2 * np.abs(np.diff(w, axis=0)), largest)
        spare = _SPARE * largest + SLACK * key.usual_ranges[:m] + np.fmax(units[1:, :m], h * units[1:, m : 2 * m])
        near = np.abs(np.diff(q, axis=0) - h / 2 * (w[1:] + w[:-1])) <= own + spare
        for t in (key.t[rows[1:]], 2 * key.t[rows[:-1]] - key.t[rows[1:]]):  # with the velocity of the time after or before
            near |= np.abs(np.diff(q, axis=0) - h * key.velocities_at(t, q[:-1])[:, :m]) <= spare
        near |= np.abs(np.diff(q, axis=0) - h * shifted(w, 1)[:-1]) <= spare
    return np.asarray(near)


def following(q: Array, near: Flags, moves: Flags) -> tuple[Flags, float]:
    """Return which rows follow, from the steps (n - 1, m) that are `near` and the rows (n - 1,) that move, and their worth.

    A step may be broken if those beside it in its column are not: one slip, or one cell put right, is no other motion.
    """
    near = near | neighbours(near)
    joined = (np.mean(near, axis=1) >= _MOST) & moves
    follows = np.zeros(len(q), dtype=bool)
    follows[1:] |= joined
    follows[:-1] |= joined
    present = np.isfinite(q).any(axis=1)
    motion = ramp(float(follows[present].mean()), FEW_FOLLOWING, FOLLOWING) if present.any() else 0.0
    follows[:1] = True
    return follows, motion


def in_a_run(right: Flags, rows: Places) -> Flags:
    """Return where a cell (n, k) is one of RUN right ones in successive `rows`; fewer are right by chance."""
    if len(rows) < RUN:
        return right
    whole: Flags = np.asarray(np.lib.stride_tricks.sliding_window_view(right[rows], RUN, axis=0).all(axis=-1))
    run = np.zeros_like(right)
    for place in range(RUN):
        run[rows[place : place + len(whole)]] |= whole
    return run


def stands_still(key: Key, cells: Cells) -> bool:
    """Return whether no coordinate of a table moves, although the key's coordinates do."""
    m, rows = key.m, handed_in(cells)
    return not _moves(cells.student.values[rows, :m]).any() and bool(_moves(key.table[:, :m]).any())


def _moves(angles: Array) -> Flags:
    """Return where a coordinate (n, m) differs from the row before, (n - 1, m)."""
    return np.asarray(np.abs(np.diff(angles, axis=0)) > _CONSTANT)


def moves_as_it_may(key: Key, cells: Cells) -> Flags:
    """Return where a coordinate moves from one row handed in to the next, now or before cells were put right, or need not.

    It need not move where the key's hardly does; nor in some rows if it moves in many, as digits hide small steps.
    """
    rows, m, student = handed_in(cells), key.m, cells.student
    moves = _moves(student.values[rows, :m]) | _moves((cells.before or student).values[rows, :m])
    with np.errstate(invalid="ignore"):
        hardly = np.abs(np.diff(key.table[rows, :m], axis=0)) <= np.fmax(_CONSTANT, student.units[rows, :m][1:])
    return np.asarray(moves | hardly | (moves.sum(axis=0) >= _MOVES * (~hardly).sum(axis=0)))


def true_steps(key: Key, cells: Cells) -> Flags:
    """Return which steps of angles (n - 1, m) follow from the printed row before; a missing cell follows from nothing."""
    return np.asarray(cells.way(STEP).holds(cells.student.values)[1:, : key.m])
