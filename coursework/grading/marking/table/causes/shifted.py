"""A table that is right except for some rows too many or too few: rows are repeated, left out, or put before the first.

Enters: a `TableUnderTest`.  Leaves: the table with its rows put back, also where they stand in any other order.
Used by `printed_otherwise.py`.
From the slip on, every row stands beside another time and no longer follows; with the rows put back, the slip costs one row.
"""

from __future__ import annotations

from collections.abc import Container, Mapping

import numpy as np

from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.odd_rows import FEWEST_SHIFTED, alike_rows, shifts
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.ways import StudentTable
from coursework.system.arrays import Array, Flags

# The rows are put back only if then at least this part of the cells is right.
_ENOUGH = 0.5
_MOST = 0.5  # of the rows that are there
_MOST_SHIFTS = 2  # of more than one row, those of most rows
_DIGITS = 9  # of the sums, without round-off


def put_back(printed: TableUnderTest) -> StudentTable | None:
    """Return the table without the surplus rows, or with empty rows where some are left out; None if there are neither.

    A cell that is right where it stands is right in the rows put back too: its value was shifted before it was put right.
    """
    student, count = printed.student, len(printed.student.values)
    stands = printed.of_task
    as_it_is = _right(printed, stands, 0)
    best = _total(as_it_is, as_it_is, count)[0] + student.values.shape[1], np.inf  # the cells of a row that then is missing
    made: list[int | None] = []
    usual = shifts(alike_rows(printed.key, student, stands))
    for by in dict.fromkeys([-1, 1, *sorted(usual, key=lambda one: -usual[one])[:_MOST_SHIFTS]]):
        there, rows = _right(printed, stands, by), abs(by)
        for place in range(int(by < 0), count):
            if (total := _total(as_it_is, there, place)) <= best:
                continue
            best = total
            if by > 0:
                made = [*range(place), *[None] * rows, *range(place, count - rows)][:count]
            else:
                begun = max(place - rows, 0)
                gone = range(place, place + rows)
                if as_it_is[begun:place].sum() < there[place : place + rows].sum() or place + rows > count:
                    gone = range(begun, begun + rows)
                made = [*(row for row in range(count) if row not in gone), *[None] * rows]
    if not made or best[0] < _ENOUGH * np.isfinite(student.values).sum():
        return None
    return _put(printed, {row: of for row, of in enumerate(made) if of is not None})


def _put(printed: TableUnderTest, made: Mapping[int, int], mended: Container[int] = ()) -> StudentTable:
    """Return the table with other rows in the place of its own; a cell that is right where it stands is right there, too.

    So are all cells in rows that are `mended`.
    """
    values, units = np.full_like(printed.student.values, np.nan), np.full_like(printed.student.units, np.nan)
    for row, of in made.items():
        put = (printed.of_task[of] & (row != of)) | (row in mended)
        values[row], units[row] = np.where(put, printed.key.table[row], printed.student.values[of]), printed.student.units[of]
    return StudentTable(values, units)


def in_order(printed: TableUnderTest) -> StudentTable | None:
    """Return the table with its rows beside their times, if most are rows of the task in another order; else None.

    A row may be another one's that was put right meanwhile: then the row that stood there is right in the place that is left.
    """
    same = alike_rows(printed.key, printed.student, printed.of_task)
    there = np.flatnonzero(np.isfinite(printed.student.values).any(axis=1))
    at_home = np.diagonal(same)
    # Of a row that agrees with several rows, the first that no other row is.
    made, again = {int(row): int(row) for row in there[at_home[there]]}, dict[int, int]()
    for row in there[~at_home[there]].tolist():
        places = [int(place) for place in np.flatnonzero(same[row])]
        if free := [place for place in places if place not in made]:
            made[free[0]] = row
        elif twice := [place for place in places if made[place] == place and place not in again]:
            again[twice[0]] = row
    moved = len(again) + sum(place != row for place, row in made.items())
    if moved < FEWEST_SHIFTED or len(made) + len(again) < _MOST * len(there):
        return None
    left = dict(zip((place for place in range(len(same)) if place not in made), again.values(), strict=False))
    return _put(printed, made | left, left)


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
    after = np.hstack([last, key.velocities_at(key.t[-1:] + key.step, last)])
    none = np.full((abs(by), values.shape[1]), np.nan)
    table = np.vstack([none, key.table, after, none])[abs(by) + by : abs(by) + by + len(values)]
    right = alike(key, printed.student, table) | stands
    with np.errstate(invalid="ignore"):
        own = np.abs(values[:, m:] - key.velocities_at(t, printed.q)) <= printed.true_velocities[1]
    right[:, m:] |= own & (t >= 0)[:, None]
    there = np.isfinite(values)
    parts = [part for part in (slice(0, m), slice(m, None)) if there[:, part].any()]
    shares = [right[:, part].sum(axis=1) / np.maximum(there[:, part].sum(axis=1), 1) for part in parts]
    return np.asarray(np.min(shares, axis=0, initial=1.0) * values.shape[1])
