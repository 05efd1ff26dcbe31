"""A table that begins elsewhere than the task says: Euler's table from the student's own start values.

Enters: marked cells.  Leaves: the same cells marked against that table.  Used by `earning.py`, `misconceptions.py`, `claims.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import Cells, mark_cells
from coursework.grading.marking.table.ways import KEY
from coursework.system.arrays import Array


def other_starts(key: Key, cells: Cells) -> tuple[str, ...]:
    """Return the coordinates whose start values are not the task's."""
    return tuple(key.coordinates[place] for place in np.flatnonzero(cells.wrong[0, : len(key.coordinates)]).tolist())


def cells_from_own_start(key: Key, cells: Cells) -> Cells | None:
    """Return the table marked as if the task began where the student does; None where the velocities of row 1 do not follow."""
    m = len(key.coordinates)
    own = np.where(np.isfinite(cells.student.values[0, :m]), cells.student.values[0, :m], key.table[0, :m])
    made = mark_cells(key, cells.student, march(key, own, key.velocities_at))
    made.marks[made.wrong & (cells.marks == KEY)] = KEY
    return None if made.wrong[0].any() else made


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
