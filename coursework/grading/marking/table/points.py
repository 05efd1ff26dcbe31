"""Marked cells -> the share of the table's points, with the gates that give nothing for nonsense.

Enters: `Cells`.  Leaves: `TablePoints`, `Earned`.  Used by `earning.py` and what it asks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import MISSING, Cells
from coursework.grading.marking.table.untold import but, ramp, untold_steps
from coursework.grading.marking.table.ways import KEY, SLACK, STEP, STEP_TRUE, Places, StudentTable
from coursework.system.arrays import Array, Flags, neighbours, shifted
from coursework.system.frozen import frozen

# Rows whose velocities are all shown and right, below which steps made with them prove nothing, if not so many of the columns
# are the task's in as many rows: one wrong throughout is one fault.  Right cells below each other, fewer of which are chance.
ENOUGH_ROWS, _COLUMNS, RUN = 0.6, 0.5, 5
_CONSTANT = 1e-9
# Of the velocities: the part that is to be explained before a row may be one of which a cell was put right.
_MOSTLY = 0.5
# Of a step: the part of the largest one-step gap to spare, the coordinates of a row that must be near, the rows that must follow
# for anything to count and for all of it.
_SPARE, _MOST, FEW_FOLLOWING, FOLLOWING = 0.25, 0.66, 0.35, 0.75
# Part of the rows in which a coordinate must move, to stand in others without a word.
_MOVES = 0.33
# Steps of one coordinate with a right velocity that may be others, before they are taken for no motion.
_EXCUSED = 0.25


Rule = Literal["cells", "start", "misconception", "own_equations"]


@frozen
class TablePoints:
    """`share` of the table earned by its cells; how many cells count.

    `shut` counts the cells that are right and do not count, by the gate that closed: row 1 is wrong ("start"), a step was made
    with a velocity that is wrong, as many others of its column are, or of a coordinate that does not move ("used_velocity"), too
    few rows have all velocities right, and too few columns ("rows"), the digits do not tell a step from those that are not
    Euler's ("untold"), the row belongs to no motion ("motion"), single right cells are chance ("chance").  `uncounted`
    (n, m + r) is where they stand.
    """

    share: float
    cells: int
    shut: Mapping[str, int] = field(default_factory=dict)
    uncounted: Flags | None = None


@frozen
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


def table_points(key: Key, cells: Cells, carried: float = 1.0, untold: Flags | None = None) -> TablePoints:
    """Return the points of a table; `carried` is the worth of a cell that is right from the student's own cells only.

    `untold` (n, m + r) are cells that are right only because their digits do not tell them from what was done instead.
    """
    m = len(key.coordinates)
    marks, counted = cells.marks, cells.counted
    untold = np.zeros_like(counted) if untold is None else untold
    right = ~cells.wrong & ~cells.missing & counted
    sound, rows = (right & ~untold) | cells.fitted, handed_in(cells)  # as they were before others were put right
    rows_enough = bool(len(rows)) and (
        np.mean(np.all(sound[rows, m:], axis=1)) >= ENOUGH_ROWS
        or np.mean(np.mean(marks[rows, m:] == KEY, axis=0) >= ENOUGH_ROWS) >= _COLUMNS
    )
    follows, motion = rows_that_follow(key, cells)
    works = motion if rows_enough and follows[1:].any() else 0.0
    steps = np.zeros_like(right)
    steps[:, :m] = np.isin(marks[:, :m], (STEP, STEP_TRUE))
    used = np.zeros_like(right)
    rates = sound[rows, m : 2 * m]
    used[rows[1:], :m] = rates[:-1] | (marks[rows[1:], :m] == STEP_TRUE) | (np.mean(rates, axis=0) >= ENOUGH_ROWS)
    used[rows[1:], :m] &= _moves_as_it_may(key, cells)
    velocities = cells.carried & ~steps
    still = right & _constant(key)
    shut = {
        "start": cells.carried & (_begins_wrong(cells, m) or (bool(cells.wrong[0, m:].any()) and not works)),
        "used_velocity": steps & ~used,
        "rows": steps & (not rows_enough),
        "untold": untold | untold_steps(key, cells, steps, rows),
        "motion": but((velocities | still) & follows[:, None], motion) | ((velocities | still) & ~follows[:, None]),
        "chance": but(right & ~_in_a_run(marks == KEY, rows), works),
    }
    credit = np.where(cells.carried, carried, np.where(right, 1.0, 0.0))
    counts: dict[str, int] = {}
    uncounted = np.zeros_like(right)
    for gate, closed in shut.items():
        lost = closed & (credit > 0)
        counts |= {gate: int(lost.sum())} if lost.any() else {}
        uncounted |= lost
        credit[closed] = 0.0
    count = int(counted.sum())
    # The start values are given and earn nothing; one that is copied wrong is a wrong cell like any other.
    earned = max(float(credit.sum()) - int(cells.wrong[:1, :m].sum()), 0.0)
    return TablePoints(earned / count if count else 0.0, count, counts, uncounted)


def handed_in(cells: Cells) -> Places:
    """Return the rows of which anything was handed in, and row 1: others cost their cells, and no gate speaks of them."""
    found = np.asarray(~cells.missing.all(axis=1))
    found[:1] = True
    return np.flatnonzero(found)


def _constant(key: Key) -> Flags:
    """Return which columns (m + r,) never change: what stands there is right in any row, whatever else does."""
    return np.asarray(key.ranges <= _CONSTANT * np.max(np.abs(key.table), axis=0))


def _begins_wrong(cells: Cells, m: int) -> bool:
    """Return whether a start value is wrong and the table was made with it: the first value below it is not the key's."""
    for place in np.flatnonzero(cells.wrong[0, :m]).tolist():
        below = np.flatnonzero(cells.marks[1:, place] != MISSING)
        if not len(below) or cells.marks[1 + below[0], place] != KEY:
            return True
    return False


def explained_share(key: Key, cells: Cells, holds: Flags, *, only_velocities: bool = False, as_it_is: bool = False) -> float:
    """Return the share of the cells that count of which some explanation `holds` (n, m + r), or the key does.

    The gates are those of the points: a step counts where its velocity is explained too, or was before a cell of its row was
    put right, a velocity where its row belongs to the motion that the explained steps make, a right cell without either where
    several stand below each other.  The table `as_it_is` had no cell put right.
    """
    m = len(key.coordinates)
    rows, by_key = handed_in(cells), cells.marks == KEY
    after_put = (holds & ~by_key)[rows[1:], :m] & np.any(by_key, axis=1, keepdims=True)[rows[:-1]]
    holds = (holds | by_key) & ~cells.missing & cells.counted
    after_put &= not as_it_is and holds[rows, m:].mean() >= _MOSTLY
    moves = _moves_as_it_may(key, cells)
    steps = holds[rows[1:], :m] & (holds[rows[:-1], m : 2 * m] | after_put) & moves
    counts = np.zeros_like(holds)
    counts[rows[1:], :m] = steps
    follows, motion = _following(cells.student.values[rows, :m], steps, np.asarray(moves.any(axis=1)))
    found = np.zeros_like(holds)
    found[rows, m:] = holds[rows, m:] & follows[:, None]
    counts |= found & ~but(found, motion)
    counts |= by_key & cells.counted & _in_a_run(by_key, rows) & ~_constant(key)
    if only_velocities:
        counts[:, :m] = False
    return float(counts.sum()) / max(int(cells.counted.sum()), 1)


def share_of(explained: Flags, spoken: Flags) -> float:
    """Return how many of the cells spoken about are explained; 0 where none are."""
    return float(explained.sum()) / float(spoken.sum()) if spoken.any() else 0.0


def rows_that_follow(key: Key, cells: Cells) -> tuple[Flags, float]:
    """Return which rows (n,) belong to a motion: the way from or to a neighbour lies between what both velocities make of a step.

    Any scheme passes, with a part of the one-step gap to spare, and a coordinate in three may be wrong.  Rows that are copied,
    shuffled or invented follow nothing, and what is right in them from each other is no work; the second number is which part
    of them counts (0 to 1), the less the fewer rows follow.
    """
    m, rows = len(key.coordinates), handed_in(cells)
    q, marks = cells.student.values[rows, :m], cells.marks[rows]
    near = _near_steps(key, cells.student, rows)
    if cells.before is not None:
        near |= _near_steps(key, cells.before, rows)
    steps = np.isin(marks[1:, :m], (STEP, STEP_TRUE)) & ~(cells.wrong & ~cells.fitted)[rows[:-1], m : 2 * m]
    steps |= marks[1:, :m] == KEY
    put = marks[:-1] == KEY
    excused = ~(near | steps) & (put[:, :m] | put[:, m : 2 * m])  # put right, the step from it as it was
    steps |= excused & (excused.sum(axis=0) <= _EXCUSED * len(excused))
    moves = np.asarray(_moves(q).any(axis=1) | ~_moves(key.table[rows, :m]).any(axis=1))
    follows = np.zeros(len(cells.marks), dtype=bool)
    follows[rows], motion = _following(q, near | steps, moves)
    return follows, motion


def _near_steps(key: Key, table: StudentTable, rows: Places) -> Flags:
    """Return which ways (n - 1, m) from row to row lie between what both velocities make of a step, with some to spare."""
    m, h = len(key.coordinates), np.diff(key.t[rows])[:, None]
    q, w, units = table.values[rows, :m], table.values[rows, m : 2 * m], table.units[rows]
    with np.errstate(invalid="ignore"):
        largest = np.max(h / 2 * np.abs(np.diff(key.table[rows, m : 2 * m], axis=0)), axis=0, initial=0.0)
        own = np.minimum(h / 2 * np.abs(np.diff(w, axis=0)), largest)
        spare = _SPARE * largest + SLACK * key.usual_ranges[:m] + np.fmax(units[1:, :m], h * units[1:, m : 2 * m])
        near = np.abs(np.diff(q, axis=0) - h / 2 * (w[1:] + w[:-1])) <= own + spare
        for t in (key.t[rows[1:]], 2 * key.t[rows[:-1]] - key.t[rows[1:]]):  # with the velocity of a neighbour's time, or row
            near |= np.abs(np.diff(q, axis=0) - h * key.velocities_at(t, q[:-1])[:, :m]) <= spare
        near |= np.abs(np.diff(q, axis=0) - h * shifted(w, 1)[:-1]) <= spare
    return np.asarray(near)


def _following(q: Array, near: Flags, moves: Flags) -> tuple[Flags, float]:
    """Return which rows follow where steps (n - 1, m) are `near` enough and rows (n - 1,) move, and which part of them counts.

    A step beside which those of its coordinate are may be broken: one slip, or one cell put right, is no other motion.
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


def _in_a_run(right: Flags, rows: Places) -> Flags:
    """Return where a cell (n, k) is one of several right ones below each other in `rows`; fewer are right by chance."""
    if len(rows) < RUN:
        return right
    whole: Flags = np.asarray(np.lib.stride_tricks.sliding_window_view(right[rows], RUN, axis=0).all(axis=-1))
    run = np.zeros_like(right)
    for place in range(RUN):
        run[rows[place : place + len(whole)]] |= whole
    return run


def stands_still(key: Key, cells: Cells) -> bool:
    """Return whether no coordinate of a table moves, although the key's do."""
    m, rows = len(key.coordinates), handed_in(cells)
    return not _moves(cells.student.values[rows, :m]).any() and bool(_moves(key.table[:, :m]).any())


def _moves(angles: Array) -> Flags:
    """Return where a coordinate (n, m) is another than in the row before (n - 1, m)."""
    return np.asarray(np.abs(np.diff(angles, axis=0)) > _CONSTANT)


def _moves_as_it_may(key: Key, cells: Cells) -> Flags:
    """Return where a coordinate moves from row to row handed in, now or before cells were put right, or need not.

    It need not where the key's hardly does, nor in some rows if it does in many: a small step is lost in its digits.
    """
    rows, m, student = handed_in(cells), len(key.coordinates), cells.student
    moves = _moves(student.values[rows, :m]) | _moves((cells.before or student).values[rows, :m])
    with np.errstate(invalid="ignore"):
        hardly = np.abs(np.diff(key.table[rows, :m], axis=0)) <= np.fmax(_CONSTANT, student.units[rows, :m][1:])
    return np.asarray(moves | hardly | (moves.sum(axis=0) >= _MOVES * (~hardly).sum(axis=0)))


def true_steps(key: Key, cells: Cells) -> Flags:
    """Return which steps of angles (n - 1, m) follow from the printed row before, where both are there."""
    return np.asarray(cells.way(STEP).holds(cells.student.values)[1:, : len(key.coordinates)])
