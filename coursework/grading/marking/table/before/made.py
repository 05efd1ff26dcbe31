"""What rows of a table make: their velocities and the next coordinates; and a table with cells as the rows above make them.

Enters: a `Key`, rows, a `StudentTable` and its ways.  Leaves: arrays, `StudentTable`s.  Used by `restored.py`, `guesses.py`.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable
from coursework.system.arrays import Array, Flags, neighbours

# The march forward is repeated with the velocities at its new angles.
_PASSES = 2


def beside_makers(cells: NDArray[Any], m: int) -> NDArray[Any]:
    """Return cells (n, r + m) beside the row from which they are made: its velocities, and the coordinates of the next row."""
    return np.hstack([cells[:, m:], np.vstack([cells[1:, :m], np.zeros_like(cells[:1, :m])])])


def made_from_rows(key: Key, t: Array, rows: Array) -> Array:
    """Return what rows (n, m + r) make: velocities from angles, later ones from earlier ones, next coordinates in three ways."""
    m, h = key.m, key.stride
    velocities = key.velocities_at(t, rows[:, :m])
    later = _later(key, t, rows)
    steps = (rows[:, :m] + h * rates[:, :m] for rates in (rows[:, m:], velocities, np.where(np.isnan(later), rows[:, m:], later)))
    return np.hstack([velocities, later, *steps])


def as_it_was(key: Key, student: StudentTable, right: Flags, own: OwnWays) -> StudentTable | None:
    """Return the table with `right` cells that do not follow from the rows before replaced by what does; None if unchanged."""
    m = key.m
    w, printed = student.values[:, m:], student.values[:, m:]
    allowed = np.fmax(own.angles.tolerance, own.earlier.tolerance)[:, m:]
    follows = (own.step.holds(student.values) | own.step_true.holds(student.values))[:, :m]
    for _ in range(_PASSES):
        q, units = _marched(key, student, right[:, :m], follows, w)
        made = _made(key, q, w)
        before = w
        with np.errstate(invalid="ignore"):
            w = np.where(right[:, m:] & (np.abs(printed - made) > allowed), made, printed)
        if np.array_equal(w, before, equal_nan=True):
            break
    values = np.hstack([q, w])
    return None if np.array_equal(values, student.values, equal_nan=True) else replace(student, values=values, units=units)


def _marched(key: Key, student: StudentTable, right: Flags, follows: Flags, velocities: Array) -> tuple[Array, Array]:
    """Return coordinates (n, m) and units (n, m + r); a `right` coordinate that is no step from above is replaced by the step."""
    m, h = key.m, key.stride
    q, units = student.values[:, :m].copy(), student.units.copy()
    edge = right & ~neighbours(right)
    for place in range(m):
        column, digits, rates = q[:, place].tolist(), units[:, place].tolist(), units[:, m + place].tolist()
        last = 0
        for row in (np.flatnonzero(right[1:, place]) + 1).tolist():
            if follows[row, place] and last < row - 1 and not edge[row, place]:
                continue
            moved = column[row - 1] + h * float(velocities[row - 1, place])
            doubt = digits[row] + digits[row - 1] + h * rates[row - 1]
            if edge[row, place] or abs(column[row] - moved) > HALF * doubt:
                column[row], digits[row], last = moved, doubt, row
        q[:, place], units[:, place] = column, digits
    return q, units


def _made(key: Key, q: Array, w: Array) -> Array:
    """Return the velocities (n, r) at coordinates `q` (n, m); later blocks use the velocities `w` (n, r) of earlier ones."""
    made, later = key.velocities_at(key.t, q), _later(key, key.t, np.hstack([q, w]))
    return np.where(np.isnan(later), made, later)


def _later(key: Key, t: Array, cells: Array) -> Array:
    """Return the velocities (n, r) of later blocks from rows of `cells` (n, m + r); NaN in the first block."""
    found = np.full((len(cells), len(key.velocities)), np.nan)
    for index, block in enumerate(key.blocks[1:], start=1):
        found[:, [key.velocities.index(name) for name in block]] = key.block_at(index, t, cells[:, : key.m], cells[:, key.m :])
    return found
