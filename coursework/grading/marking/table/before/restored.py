"""What stood in a table before a cell was misprinted or put right: cells that were made from the old value still show it.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
The table is explained with the fewest slips. A cell that does not follow from what others were when it was made is a slip and
costs one. A printed cell either is what it was; or is a misprint, which costs one; or was put right to the task's number, which
costs nothing. The cost is the least over all tables that may have been.

One more right cell never raises it: each table that may have been still may, and costs no more, since a printed cell put right
costs nothing whatever it was. Costs join each row only with the one that it is made from, so the least of all tables that take
each row from any of a pool is found exactly, and no choice in one row decides about rows far from it. What can still be lost is
a row that was never put into the pool.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.guesses import FEW, Counts, guesses, makers_of_several
from coursework.grading.marking.table.before.made import as_it_was, beside_makers
from coursework.grading.marking.table.ways import HALF, OwnWays, StudentTable, Way, as_printed, near, own_ways
from coursework.system.arrays import Flags
from coursework.system.frozen import frozen

# How often the values found are put in and the rows beside them searched again.
_PASSES = 4
# How often the beginning of a restored part is moved down because no cell speaks for its first rows.
_BEGINNINGS = 4

# A table that may have been, and what follows from its cells.
Was = tuple[StudentTable, OwnWays]


@frozen
class Restored:
    """`ways` make wrong cells right from what others were; `fitted` (n, m + r) are the wrong cells that told what these were.

    `before` is the table as it was, None if nothing in it was different.
    """

    ways: tuple[Way, ...]
    fitted: Flags
    before: StudentTable | None


def restored(key: Key, student: StudentTable, wrong: Flags, right: Flags, own: OwnWays) -> Restored:
    """Return what makes `wrong` cells (n, m + r) right: earlier values of cells in their row or in the row above.

    Those cells may be wrong, or have the task's value because they were put right. A `right` cell may have been what the rows
    above make of it; any other earlier value is told by the cells made from it, and costs a cell as before the correction.
    """
    m, put = len(key.coordinates), near(student.values, key.table, as_printed(key, student.units))
    sure = ~wrong & ~put & own.holds(student.values)
    search = _Search(key, student, wrong & ~put, wrong | put, sure, own)
    was, pool = (student, own), [(student, own)]
    (_, least), told = search.cheapest(pool), np.zeros_like(wrong)
    for _ in range(_PASSES):
        pool += search.followed(*was, right & ~told.any(axis=1, keepdims=True))
        last, _ = search.cheapest(pool)
        pool += search.guessed(*last, told)
        was, cost = search.cheapest(pool)
        if cost >= least:
            break
        told, least = told | (_other(was[0], student) & _other(was[0], last[0])), cost
    (table, ways), _ = search.cheapest(pool, velocities_first=True)
    held = ways.holds(student.values)
    made = beside_makers(search.wrong & held, m)
    costs = (_other(table, student) & ~ways.holds(table.values)).sum(axis=1) + beside_makers(sure & ~held, m).sum(axis=1)
    fitted = made & (np.cumsum(made, axis=1) <= costs[:, None])
    left = np.argwhere(made & ~fitted)[: costs.sum() - fitted.sum()]  # a row may cost more than the cells that are made from it
    fitted[tuple(left.T)] = True
    return Restored(
        tuple(replace(way, expected=np.where(_made_into(made, m), way.expected, np.nan)) for way in ways.tried),
        _made_into(fitted, m),
        table if _other(table, student).any() else None,
    )


@dataclass(frozen=True)
class _Search:
    """A table being searched: its `wrong` cells (n, m + r), those that may have been `other`, the `sure` ones, its `own` ways."""

    key: Key
    student: StudentTable
    wrong: Flags
    other: Flags
    sure: Flags
    own: OwnWays

    def made_by(self, table: StudentTable) -> OwnWays:
        """Return the ways from the cells of a table."""
        return self.own if table is self.student else own_ways(self.key, table, self.own.coarse)

    def _costs(self, pool: Sequence[Was], *, velocities_first: bool = False) -> tuple[Counts, Counts]:
        """Return what each row of each table in the `pool` costs: its velocities (k, n), and its coordinates (k, k, n).

        Coordinates are made from the row above of the first table, in the row of the second one. Of equally many cells the
        velocities may cost a little more: the gates of the points look at rows with all of them right.
        """
        m, width, printed = len(self.key.coordinates), self.wrong.shape[1], self.student.values
        values = np.array([table.values for table, _ in pool])
        other = (values != printed) & np.isfinite(values)
        held = np.array([ways.holds(printed) for _, ways in pool])
        broken = (1 + width) * ((self.wrong | self.sure) & ~held) + velocities_first * (self.wrong & ~held)
        slips = other[:, :, m:] & ~np.array([ways.holds(table.values)[:, m:] for table, ways in pool])
        here = broken[:, :, m:].sum(axis=2) + (1 + width) * slips.sum(axis=2)
        digits = np.array([table.units[:, :m] for table, _ in pool])
        own_digits = HALF * (digits - digits[:, None])  # of the second table's row, not of the first one's
        follows = np.zeros(own_digits.shape, dtype=bool)
        for place in (2, 3):
            steps = [ways.tried[place] for _, ways in pool]
            expected, open_by = (np.array([getattr(one, name)[:, :m] for one in steps]) for name in ("expected", "tolerance"))
            follows |= near(values[None, :, :, :m], expected[:, None], open_by[:, None] + own_digits)
        between = (1 + width) * (broken[:, None, :, :m] > 0).sum(axis=3) + (1 + width) * (other[:, :, :m] & ~follows).sum(axis=3)
        return here, between

    def cheapest(self, pool: Sequence[Was], *, velocities_first: bool = False) -> tuple[Was, int]:
        """Return the table that takes each row from any in the `pool` and costs least, and its cost; the first ones if equal."""
        rows, (here, between) = self._rows, self._costs(pool, velocities_first=velocities_first)
        cost, taken = here[:, rows[0]] + between[0, :, rows[0]], []
        for row in rows[1:]:
            via = cost[:, None] + between[:, :, row]
            taken.append(via.argmin(axis=0))
            cost = via.min(axis=0) + here[:, row]
        chosen = [int(cost.argmin())]
        for came in reversed(taken):
            chosen.append(int(came[chosen[-1]]))
        return self._joined(pool, chosen[::-1]), int(cost.min())

    @cached_property
    def _rows(self) -> list[int]:
        return [int(row) for row in np.flatnonzero(np.isfinite(self.student.values).any(axis=1))]

    def _joined(self, pool: Sequence[Was], chosen: Sequence[int]) -> Was:
        """Return the table that takes each row that is there from the `chosen` table of the pool."""
        if not any(chosen):
            return pool[0][0], self.made_by(pool[0][0])
        values, units = self.student.values.copy(), self.student.units.copy()
        for row, place in zip(self._rows, chosen, strict=True):
            values[row], units[row] = pool[place][0].values[row], pool[place][0].units[row]
        found = replace(self.student, values=values, units=units)
        return found, self.made_by(found)

    def followed(self, table: StudentTable, ways: OwnWays, free: Flags) -> Iterator[Was]:
        """Yield a table with `free` cells as its rows make them, then only from the first row on for which any cell speaks."""
        before = self._of_makers(table, ways)
        for _ in range(_BEGINNINGS):
            found = as_it_was(self.key, table, free, self.own)
            if found is None:
                return
            made = self.made_by(found)
            yield found, made
            silent = _silent(np.any(_other(found, table), axis=1), self._of_makers(found, made) < before)
            if not silent.any():
                return
            free = free & ~silent[:, None]

    def _of_makers(self, table: StudentTable, ways: OwnWays) -> Counts:
        """Return what is lost (n,) in what each row makes: its velocities and the coordinates of the next row."""
        here, between = self._costs([(table, ways)])
        return np.asarray(here[0] + np.append(between[0, 0, 1:], 0))

    def guessed(self, last: StudentTable, ways: OwnWays, told: Flags) -> Iterator[Was]:
        """Yield guesses of what cells were, beside the table as found, as printed, and with misprints recomputed.

        `told` cells speak with what they were, as the printed ones do.
        """
        m, speaking = len(self.key.coordinates), self.wrong | told
        printed = np.where(told, last.values, self.student.values)
        bases = [last, replace(self.student, values=printed)]
        misprints = self.wrong & (np.arange(self.wrong.shape[1]) < m) & makers_of_several(self.wrong, m)[:, None]
        if 0 < misprints.any(axis=1).mean() <= FEW and (above := as_it_was(self.key, last, misprints, ways)):
            bases.append(above)
        for base in bases:
            ways = self.made_by(base)
            yield base, ways
            for guess in guesses(self.key, base, ways, speaking & ~ways.holds(printed), self.other, self.other & ~told):
                yield guess, self.made_by(guess)


def _silent(moved: Flags, gains: Flags) -> Flags:
    """Return the first rows (n,) of each run of `moved` rows, up to the first one that gains anything."""
    found, silent = np.zeros_like(moved), False
    for row, here in enumerate(moved.tolist()):
        silent = here and not gains[row] and (silent or not row or not moved[row - 1])
        found[row] = silent
    return found


def _other(table: StudentTable, than: StudentTable) -> Flags:
    return np.asarray((table.values != than.values) & np.isfinite(table.values))


def _made_into(cells: Flags, m: int) -> Flags:
    """Return cells (n, r + m) beside the row they are made from moved to where they stand, (n, m + r)."""
    return np.hstack([np.roll(cells[:, -m:], 1, axis=0), cells[:, :-m]])
