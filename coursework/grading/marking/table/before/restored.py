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

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.guesses import FEW, Counts, guesses, makers_of_several
from coursework.grading.marking.table.before.made import as_it_was, beside_makers
from coursework.grading.marking.table.ways import (
    HALF,
    OwnWays,
    Places,
    StudentTable,
    Way,
    as_printed,
    near,
    own_ways,
    ways_of_all,
)
from coursework.system.arrays import Flags
from coursework.system.frozen import frozen

# How often the values found are put in and the rows beside them searched again.
_PASSES = 4
# How often the beginning of a restored part is moved down because no cell speaks for its first rows.
_BEGINNINGS = 4


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
    m, put = key.m, near(student.values, key.table, as_printed(key, student.units))
    sure = ~wrong & ~put & own.holds(student.values)
    search = _Search(key, student, wrong & ~put, wrong | put, sure, own)
    was = search.was(student)
    pool = [was]
    (_, least), told = search.cheapest(pool), np.zeros_like(wrong)
    for _ in range(_PASSES):
        pool = [*dict.fromkeys([*pool, *search.followed(was, right & ~told.any(axis=1, keepdims=True))])]
        last, _ = search.cheapest(pool)
        pool = [*dict.fromkeys([*pool, *search.guessed(last, told)])]
        was, cost = search.cheapest(pool)
        if cost >= least:
            break
        told, least = told | (was.other & _other(was.table, last.table)), cost
    was, _ = search.cheapest(pool, velocities_first=True)
    made = beside_makers(search.wrong & was.held, m)
    costs = was.slips.sum(axis=1) + beside_makers(sure & ~was.held, m).sum(axis=1)
    fitted = made & (np.cumsum(made, axis=1) <= costs[:, None])
    left = np.argwhere(made & ~fitted)[: costs.sum() - fitted.sum()]  # a row may cost more than the cells that are made from it
    fitted[tuple(left.T)] = True
    return Restored(
        tuple(replace(way, expected=np.where(_made_into(made, m), way.expected, np.nan)) for way in was.ways.tried),
        _made_into(fitted, m),
        was.table if was.other.any() else None,
    )


@dataclass(frozen=True, eq=False)
class _Was:
    """A table that may have been and the `ways` from its cells; all flags are (n, m + r).

    `held` are the printed cells that these ways make right, `other` its own cells that are not the printed ones, and `slips`
    those of them that do not follow from its cells either.
    """

    table: StudentTable
    ways: OwnWays
    held: Flags
    other: Flags
    slips: Flags


@dataclass(frozen=True)
class _Search:
    """A table being searched: its `wrong` cells (n, m + r), those that may have been `other`, the `sure` ones, its `own` ways."""

    key: Key
    student: StudentTable
    wrong: Flags
    other: Flags
    sure: Flags
    own: OwnWays

    @cached_property
    def _known(self) -> dict[bytes, _Was]:
        return {}

    def was(self, table: StudentTable) -> _Was:
        """Return a table with the ways from its cells: the same record for the same numbers."""
        return self.were([table])[0]

    def were(self, tables: Iterable[StudentTable]) -> list[_Was]:
        """Return several tables with the ways from their cells."""
        numbers = [(table.values.tobytes() + table.units.tobytes(), table) for table in tables]
        new = {one: table for one, table in numbers if one not in self._known}
        for (one, table), ways in zip(new.items(), self._ways([*new.values()]), strict=True):
            other = _other(table, self.student)
            slips = other & ~ways.holds(table.values) if other.any() else other
            self._known[one] = _Was(table, ways, ways.holds(self.student.values), other, slips)
        return [self._known[one] for one, _ in numbers]

    def _ways(self, tables: Sequence[StudentTable]) -> list[OwnWays]:
        if len(tables) != 1:
            return ways_of_all(self.key, tables, self.own.coarse) if tables else []
        return [self.own if tables[0] is self.student else own_ways(self.key, tables[0], self.own.coarse)]

    def _costs(
        self, pool: Sequence[_Was], *, velocities_first: bool = False
    ) -> tuple[Counts, Callable[[Places, Places, Places], Counts]]:
        """Return what the velocities in each row of each table in the `pool` cost (k, n), and a function for the coordinates.

        It takes two tables and a row, (p,) each: coordinates are made from the row above of the first, in the row of the second
        one. Of equally many cells the velocities may cost a little more: the gates of the points look at rows with all of them
        right.
        """
        m, width = self.key.m, self.wrong.shape[1]
        values, units, other, held, slips = (
            np.array(one)
            for one in zip(*((was.table.values, was.table.units, was.other, was.held, was.slips) for was in pool), strict=True)
        )
        broken = (1 + width) * ((self.wrong | self.sure) & ~held) + velocities_first * (self.wrong & ~held)
        here = broken[:, :, m:].sum(axis=2) + (1 + width) * slips[:, :, m:].sum(axis=2)
        steps = [[was.ways.tried[place] for was in pool] for place in (2, 3)]
        made = [(np.array([one.expected for one in step]), np.array([one.tolerance for one in step])) for step in steps]

        def between(above: Places, below: Places, row: Places) -> Counts:
            first, second = (above, row, slice(m)), (below, row, slice(m))
            own_digits = HALF * (units[second] - units[first])  # of the second table's row, not of the first one's
            follows = [near(values[second], expected[first], open_by[first] + own_digits) for expected, open_by in made]
            lost = (broken[first] > 0).sum(axis=1) + (other[second] & ~np.logical_or(*follows)).sum(axis=1)
            return np.asarray((1 + width) * lost)

        return here, between

    def cheapest(self, pool: Sequence[_Was], *, velocities_first: bool = False) -> tuple[_Was, int]:
        """Return the table that takes each row from any in the `pool` and costs least, and its cost; the first ones if equal."""
        here, between = self._costs(pool, velocities_first=velocities_first)
        joints = [*pairwise([np.zeros(1, dtype=int), *self._differing(pool)])]
        pairs = [
            (np.repeat(above, len(below)), np.tile(below, len(above)), np.full(len(above) * len(below), row))
            for (above, below), row in zip(joints, self._rows, strict=True)
        ]
        costs = np.split(between(*map(np.concatenate, zip(*pairs, strict=True))), np.cumsum([len(one) for one, *_ in pairs])[:-1])
        cost, taken = np.zeros(1, dtype=int), []
        for (above, below), row, joint in zip(joints, self._rows, costs, strict=True):
            via = cost[:, None] + joint.reshape(len(above), len(below))
            taken.append(via.argmin(axis=0))
            cost = via.min(axis=0) + here[below, row]
        place, chosen = int(cost.argmin()), []
        for (_, below), came in zip(reversed(joints), reversed(taken), strict=True):
            chosen.append(int(below[place]))
            place = int(came[place])
        return self._joined(pool, chosen[::-1]), int(cost.min())

    def _differing(self, pool: Sequence[_Was]) -> list[Places]:
        """Return for each row the first tables of the `pool` with its numbers: guesses differ from each other in few rows."""
        rows, tables = self._rows, [was.table for was in pool]
        digits_below = np.s_[[*rows[1:], rows[-1]], : self.key.m]
        cells = [np.hstack([table.values[rows], table.units[rows], table.units[digits_below]]) for table in tables]
        alike = ({cells[place][row].tobytes(): place for place in reversed(range(len(pool)))} for row in range(len(rows)))
        return [np.array(sorted(first.values())) for first in alike]

    @cached_property
    def _rows(self) -> list[int]:
        return [int(row) for row in np.flatnonzero(np.isfinite(self.student.values).any(axis=1))]

    def _joined(self, pool: Sequence[_Was], chosen: Sequence[int]) -> _Was:
        """Return the table that takes each row that is there from the `chosen` table of the pool."""
        if not any(chosen):
            return pool[0]
        values, units = self.student.values.copy(), self.student.units.copy()
        for row, place in zip(self._rows, chosen, strict=True):
            values[row], units[row] = pool[place].table.values[row], pool[place].table.units[row]
        return self.was(replace(self.student, values=values, units=units))

    def followed(self, was: _Was, free: Flags) -> Iterator[_Was]:
        """Yield a table with `free` cells as its rows make them, then only from the first row on for which any cell speaks."""
        before = self._of_makers(was)
        for _ in range(_BEGINNINGS):
            found = as_it_was(self.key, was.table, free, self.own)
            if found is None:
                return
            made = self.was(found)
            yield made
            silent = _silent(np.any(_other(found, was.table), axis=1), self._of_makers(made) < before)
            if not silent.any():
                return
            free = free & ~silent[:, None]

    def _of_makers(self, was: _Was) -> Counts:
        """Return what is lost (n,) in what each row makes: its velocities and the coordinates of the next row."""
        here, between = self._costs([was])
        every = np.arange(len(here[0]))
        return np.asarray(here[0] + np.append(between(0 * every, 0 * every, every)[1:], 0))

    def guessed(self, last: _Was, told: Flags) -> Iterator[_Was]:
        """Yield guesses of what cells were, beside the table as found, as printed, and with misprints recomputed.

        `told` cells speak with what they were, as the printed ones do.
        """
        m, speaking = self.key.m, self.wrong | told
        printed = np.where(told, last.table.values, self.student.values)
        bases = [last.table, replace(self.student, values=printed)]
        misprints = self.wrong & (np.arange(self.wrong.shape[1]) < m) & makers_of_several(self.wrong, m)[:, None]
        if 0 < misprints.any(axis=1).mean() <= FEW and (above := as_it_was(self.key, last.table, misprints, last.ways)):
            bases.append(above)
        for base in dict.fromkeys(map(self.was, bases)):
            yield base
            silent = ~base.ways.holds(printed)
            yield from self.were(guesses(self.key, base.table, base.ways, speaking & silent, self.other, self.other & ~told))


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
