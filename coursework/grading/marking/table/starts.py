"""A table that begins elsewhere than the task says: Euler's table from the student's own start values.

Enters: marked cells.  Leaves: the same cells marked against that table.  Used by `earning.py`, `misconceptions.py`, `claims.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import GIVEN, MISSING, Cells, mark_cells
from coursework.grading.marking.table.ways import KEY
from coursework.system.arrays import Array, Flags


def other_starts(key: Key, cells: Cells) -> tuple[str, ...]:
    """Return the coordinates whose start values, or what row 2 was made from in their place, are not the task's."""
    return tuple(key.coordinates[place] for place in np.flatnonzero(_own_start(key, cells)[1]).tolist())


def cells_from_own_start(key: Key, cells: Cells) -> Cells | None:
    """Return the table marked as if the task began where the student does; None where the velocities of row 1 do not follow."""
    m = len(key.coordinates)
    made = mark_cells(key, cells.student, march(key, _own_start(key, cells)[0], key.velocities_at))
    made.marks[:1, :m][cells.marks[:1, :m] == GIVEN] = GIVEN
    made.marks[made.wrong & (cells.marks == KEY)] = KEY
    return None if made.wrong[0].any() else made


def _own_start(key: Key, cells: Cells) -> tuple[Array, Flags]:
    """Return the start (m,) that a table was made from, and where it is not the task's.

    Where row 1 prints the task's and neither its velocities nor row 2 follow from it, it is what the step to row 2 was made from.
    """
    m, values = len(key.coordinates), cells.student.values
    own, other = np.where(np.isfinite(values[0, :m]), values[0, :m], key.table[0, :m]), cells.wrong[0, :m].copy()
    if len(values) < 2 or np.isin(cells.marks[0, m:], (KEY, MISSING)).all():
        return own, other
    unused = (cells.marks[0, :m] == GIVEN) & np.isfinite(values[0, m : 2 * m]) & ~cells.missing[1, :m]
    unused &= ~np.any([way.holds(values)[1, :m] for way in cells.ways], axis=0)
    return np.where(unused, values[1, :m] - key.step * values[0, m : 2 * m], own), other | unused


def march(
    key: Key,
    start: Array,
    velocities_at: Callable[[Array, Array], Array],
    increments: Callable[[Array, Array, Array], Array] | None = None,
) -> Array:
    """Return a table (n, m + r) from a start (m,), velocities as a function gives them; NaN where there are none.

    `increments` (t, q, velocities) of a row are Euler's where none are given.
    """
    m, step = len(key.coordinates), key.step
    rows = np.full(key.table.shape, np.nan)
    q = np.asarray(start, dtype=float)[None]
    for place in range(len(rows)):
        t = np.array([place * step])
        w = velocities_at(t, q)
        rows[place] = np.hstack([q, w])[0]
        if not np.isfinite(w).all():
            rows[place] = np.nan
            break
        q = q + (step * w[:, :m] if increments is None else increments(t, q, w))
    return rows
