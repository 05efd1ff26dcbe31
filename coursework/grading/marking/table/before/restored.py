"""What stood in a table before a cell of it was misprinted or put right: the cells made from that follow from it still.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
A table is told by the fewest slips that explain it.  Each cell follows from what others were when it was made, or is a slip, and
costs one; what is printed is what a cell was, a misprint, which costs one, or the task's number, which costs nothing.  Whatever
explains a table explains it with any misprint put right too, at no more: so points do not fall by a cell put right, as far as
the search finds what explains it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.before.guesses import FEW, Counts, guesses, makers_of_several
from coursework.grading.marking.table.before.made import as_it_was, beside_makers
from coursework.grading.marking.table.ways import OwnWays, StudentTable, Way, as_printed, near, own_ways
from coursework.system.arrays import Flags
from coursework.system.frozen import frozen

# What is found is set in, and what stands beside it looked for again.
_PASSES = 2
# How often it is asked whether what was made from rows of which nothing tells was made later.
_BEGINNINGS = 4


@frozen
class Restored:
    """`ways` by which wrong cells are right from what others were; `fitted` (n, m + r) the wrong ones that say what these were.

    `before` is the table as it was, None where it is as it stands.
    """

    ways: tuple[Way, ...]
    fitted: Flags
    before: StudentTable | None


def restored(key: Key, student: StudentTable, wrong: Flags, right: Flags, own: OwnWays) -> Restored:
    """Return what makes `wrong` cells (n, m + r) right: what cells of their row, or of the row above, were.

    Those may be wrong, or the task's, put right.  What is `right` may have been what the rows above make of it; any other value
    is told by what was made from it, and costs a cell, as it did before it was put right.
    """
    m, put = len(key.coordinates), near(student.values, key.table, as_printed(key, student.units))
    was, told = student, np.zeros_like(wrong)
    sure = ~wrong & ~put & own.holds(student.values)
    looked = _Looked(key, student, wrong & ~put, wrong | put, sure, own, told, student)
    for _ in range(_PASSES):
        last, own = looked.followed(was, right & ~told.any(axis=1, keepdims=True))
        was, now = looked.guessed(last, own, told)
        if now is told:
            break
        own, told = looked.made_by(was), now
        looked = replace(looked, printed=replace(student, values=np.where(told, was.values, student.values)), told=told)
    made: Flags = beside_makers(looked.wrong & own.holds(student.values), m)
    fitted = made & (np.cumsum(made, axis=1) <= _slips(was, student, own)[:, None])
    return Restored(
        tuple(replace(way, expected=np.where(_made_into(made, m), way.expected, np.nan)) for way in own.tried),
        _made_into(fitted, m),
        was if _other(was, student).any() else None,
    )


@dataclass(frozen=True)
class _Looked:
    """A table that is looked at: `wrong` cells (n, m + r), those that may have been `other`, the `sure` ones, its `own` ways.

    `told` are cells of which it was found what they were, and `printed` is the table with that.
    """

    key: Key
    student: StudentTable
    wrong: Flags
    other: Flags
    sure: Flags
    own: OwnWays
    told: Flags
    printed: StudentTable

    @property
    def speaking(self) -> Flags:
        """Return which cells say what others were."""
        return self.wrong | self.told

    def worth(self, table: StudentTable, ways: OwnWays) -> Counts:
        """Return how many cells made from each row (n,) are right if a table stood there, without those that it costs."""
        held = ways.holds(self.printed.values)
        found = beside_makers((self.speaking & held) * 1 - (self.sure & ~held), len(self.key.coordinates)).sum(axis=1)
        return np.asarray(found - _slips(table, self.student, ways))

    def made_by(self, table: StudentTable) -> OwnWays:
        """Return what a table makes."""
        return self.own if table is self.student else own_ways(self.key, table, self.own.coarse)

    def followed(self, table: StudentTable, free: Flags) -> tuple[StudentTable, OwnWays]:
        """Return a table with what its rows make of cells that are `free`, from the first row on of which anything tells."""
        found, ways = as_it_was(self.key, table, free, self.own), self.made_by(table)
        if found is None:
            return table, ways
        least, ways = self.worth(table, ways), self.made_by(found)
        for _ in range(_BEGINNINGS):
            silent = _silent(np.any(_other(found, table), axis=1), self.worth(found, ways) > least)
            free = free & ~silent[:, None]
            if not silent.any():
                break
            later = as_it_was(self.key, table, free, self.own) or table
            made = self.made_by(later)
            if self.worth(later, made).sum() < self.worth(found, ways).sum():
                break
            found, ways = later, made
        return found, ways

    def bases(self, last: StudentTable, own: OwnWays, told: Flags) -> Iterator[StudentTable]:
        """Yield the tables beside which a cell may have been another: as found, as printed, without misprints."""
        m, speaking = len(self.key.coordinates), self.speaking
        yield last
        if _touched(beside_makers(speaking, m), self.printed, last):
            yield self.printed
        misprints = self.wrong & ~told & (np.arange(self.wrong.shape[1]) < m)
        misprints &= makers_of_several(speaking & ~own.holds(self.printed.values), m)[:, None]
        if 0 < misprints.any(axis=1).mean() <= FEW and (above := as_it_was(self.key, last, misprints, own)):
            yield above

    def guessed(self, last: StudentTable, own: OwnWays, told: Flags) -> tuple[StudentTable, Flags]:
        """Return the table with the guesses by which more cells are right, and what is told now: `told` itself for no guess."""
        m, speaking, was, now = len(self.key.coordinates), self.speaking, last, told
        best = np.maximum(self.worth(last, own), 0)
        for base in self.bases(last, own, now):
            ways = own if base is last else self.made_by(base)
            left = speaking & ~ways.holds(self.printed.values)
            for guess in guesses(self.key, base, ways, left, self.other, self.other & ~now):
                if not _touched(beside_makers(left, m), guess, base):
                    continue
                found = self.worth(guess, self.made_by(guess))
                rows = found > best
                if rows.any():  # what is gained beside rows as the guess has them may be nothing beside those that stay
                    joined = _joined(rows, guess, was)
                    rows &= self.worth(joined, self.made_by(joined)) >= found
                if rows.any():
                    best = np.where(rows, found, best)
                    now = now | (rows[:, None] & _other(guess, base))
                    was = _joined(rows, guess, was)
        return was, now


def _silent(moved: Flags, gains: Flags) -> Flags:
    """Return the first rows (n,) of each run of `moved` ones, before one that gains anything."""
    found, silent = np.zeros_like(moved), False
    for row, here in enumerate(moved.tolist()):
        silent = here and not gains[row] and (silent or not row or not moved[row - 1])
        found[row] = silent
    return found


def _slips(table: StudentTable, printed: StudentTable, ways: OwnWays) -> Counts:
    """Return how many cells of each row (n,) are other than they are printed, and do not follow from those before either."""
    return np.asarray((_other(table, printed) & ~ways.holds(table.values)).sum(axis=1))


def _joined(rows: Flags, guess: StudentTable, was: StudentTable) -> StudentTable:
    """Return a table with some rows (n,) of a guess."""
    values, units = (np.where(rows[:, None], *both) for both in ((guess.values, was.values), (guess.units, was.units)))
    return replace(was, values=values, units=units)


def _other(table: StudentTable, than: StudentTable) -> Flags:
    return np.asarray((table.values != than.values) & np.isfinite(table.values))


def _touched(made: Flags, table: StudentTable, than: StudentTable) -> bool:
    """Return whether any cell `made` from a row (n, r + m) is made from one in which two tables differ."""
    return bool((made.any(axis=1) & _other(table, than).any(axis=1)).any())


def _made_into(cells: Flags, m: int) -> Flags:
    """Return cells (n, r + m) that stand beside the row that they are made from, where they stand, (n, m + r)."""
    return np.hstack([np.roll(cells[:, -m:], 1, axis=0), cells[:, :-m]])
