"""A table that is right except for one row too many or too few: a row is repeated, left out, or put before the first.

Enters: a `TableUnderTest`.  Leaves: the table with its rows put back.  Used by `other_data.py`.
From the slip on, every row stands beside another time and no longer follows; with the rows put back, the slip costs one row.
"""

from __future__ import annotations

import numpy as np

from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.ways import StudentTable
from coursework.system.arrays import Array, Flags

# The rows are put back only if then at least this part of the cells is right.
_ENOUGH = 0.5
_DIGITS = 9  # of the sums, without round-off


def put_back(printed: TableUnderTest) -> StudentTable | None:
    """Return the table without the surplus row, or with an empty row where one is left out; None if there is neither.

    A cell that is right where it stands is right in the rows put back too: its value was shifted before it was put right.
    """
    student, count = printed.student, len(printed.student.values)
    stands = printed.of_task
    as_it_is, late, early = (_right(printed, stands, by) for by in (0, -1, 1))
    best = float(np.round(as_it_is.sum() + student.values.shape[1], _DIGITS)), np.inf  # the cells of the row that then is missing
    made: list[int | None] | None = None
    for place in range(1, count):
        if (total := _total(as_it_is, late, place)) > best:
            best, gone = total, place if as_it_is[place - 1] >= late[place] else place - 1
            made = [*(row for row in range(count) if row != gone), None]
    for place in range(count):
        if (total := _total(as_it_is, early, place)) > best:
            best, made = total, [*range(place), None, *range(place, count - 1)]
    if made is None or best[0] < _ENOUGH * student.values.size:
        return None
    values, units = np.full_like(student.values, np.nan), np.full_like(student.units, np.nan)
    for row, of in enumerate(made):
        if of is not None:
            put = stands[of] & (row != of)
            values[row], units[row] = np.where(put, printed.key.table[row], student.values[of]), student.units[of]
    return StudentTable(values, units)


def _total(stays: Array, shifted: Array, place: int) -> tuple[float, float]:
    """Return how much is right if the rows (n,) up to a place stay and those from it on are shifted, and how much of it stays.

    Without round-off, and of equal totals the one in which more stays: rows that are right in both ways decide nothing.
    """
    above = stays[:place].sum()
    return float(np.round(above + shifted[place:].sum(), _DIGITS)), float(np.round(above, _DIGITS))


def _right(printed: TableUnderTest, stands: Flags, by: int) -> Array:
    """Return how far each row (n,) agrees with the one `by` further on, in cells: coordinates with the key, velocities too.

    Velocities may also follow from own angles; the worse share counts, as velocities alone may be those of another time.
    Cells that are right where they stand (`stands`, (n, m + r)) count as the others of their row.
    """
    key, m, values = printed.key, printed.m, printed.student.values
    last = key.table[-1:, :m] + key.step * key.table[-1:, m : 2 * m]
    t = np.asarray(key.t + by * key.step)
    after = np.hstack([last, key.velocities_at(t[-1:], last)])
    table = np.vstack([np.full_like(after, np.nan), key.table, after])[1 + by : 1 + by + len(values)]
    right = alike(key, printed.student, table) | stands
    with np.errstate(invalid="ignore"):
        own = np.abs(values[:, m:] - key.velocities_at(t, printed.q)) <= printed.true_velocities[1]
    right[:, m:] |= own & (t >= 0)[:, None]
    there = np.isfinite(values)
    parts = [part for part in (slice(0, m), slice(m, None)) if there[:, part].any()]
    shares = [right[:, part].sum(axis=1) / np.maximum(there[:, part].sum(axis=1), 1) for part in parts]
    return np.asarray(np.min(shares, axis=0, initial=1.0) * values.shape[1])
