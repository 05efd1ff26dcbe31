"""What stood in a table before a cell was misprinted or put right: cells that were made from the old value still show it.

Enters: a `Key`, a student's table, its ways.  Leaves: `Way`s by which no cell becomes wrong that was right before.
Used by `cells.py`.
The table is explained with the fewest slips. A cell that does not follow from what others were when it was made is a slip and
costs one. A printed cell either is what it was; or is a misprint, which costs one; or was put right to the task's number, which
costs nothing. What explains a table still does, at no higher cost, when a misprint is put right: so a correction never costs
points, as far as the search finds the explanation.
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

# How often the values found are put in and the rows beside them searched again.
_PASSES = 3
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
    """A table being searched: its `wrong` cells (n, m + r), those that may have been `other`, the `sure` ones, its `own` ways.

    `told` are cells whose earlier value was found, and `printed` is the table with these values.
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
        """Return which cells tell something about others."""
        return self.wrong | self.told

    def worth(self, table: StudentTable, ways: OwnWays) -> Counts:
        """Return for each row (n,) how many cells made from it `table` explains, less the slips that `table` costs.

        Of equally many the velocities are worth a little more: the gates of the points look at rows with all of them right.
        """
        m, held = len(self.key.coordinates), ways.holds(self.printed.values)
        found = beside_makers((self.speaking & held) * 1 - (self.sure & ~held), m)
        cells = found.sum(axis=1) - _slips(table, self.student, ways)
        return np.asarray(cells * (1 + found.shape[1]) + found[:, :-m].sum(axis=1))

    def made_by(self, table: StudentTable) -> OwnWays:
        """Return the ways from the cells of a table."""
        return self.own if table is self.student else own_ways(self.key, table, self.own.coarse)

    def followed(self, table: StudentTable, free: Flags) -> tuple[StudentTable, OwnWays]:
        """Return a table with `free` cells as its rows make them, from the first row on for which any cell speaks."""
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
        """Yield the tables beside which a cell may have been different: as found, as printed, with misprints recomputed."""
        m, speaking = len(self.key.coordinates), self.speaking
        yield last
        if _touched(beside_makers(speaking, m), self.printed, last):
            yield self.printed
        misprints = self.wrong & ~told & (np.arange(self.wrong.shape[1]) < m)
        misprints &= makers_of_several(speaking & ~own.holds(self.printed.values), m)[:, None]
        if 0 < misprints.any(axis=1).mean() <= FEW and (above := as_it_was(self.key, last, misprints, own)):
            yield above

    def guessed(self, last: StudentTable, own: OwnWays, told: Flags) -> tuple[StudentTable, Flags]:
        """Return the table with all guesses that explain more cells, and the cells told now; `told` itself if no guess does."""
        m, speaking, was, now = len(self.key.coordinates), self.speaking, last, told
        best = np.maximum(self.worth(last, own), 0)
        tried: list[tuple[StudentTable, StudentTable, Counts]] = []
        for base in self.bases(last, own, told):
            ways = own if base is last else self.made_by(base)
            left = speaking & ~ways.holds(self.printed.values)
            for guess in guesses(self.key, base, ways, left, self.other, self.other & ~told):
                if _touched(beside_makers(left, m), guess, base):
                    tried.append((base, guess, self.worth(guess, self.made_by(guess))))
        # A slip that explains one velocity gains nothing but the gates of the points: it is taken if nothing gains more, as it
        # may stand in the way. Two rows are taken together if they gain only so.
        for least in (len(self.key.velocities), 0):
            for base, guess, found in tried if now is told else ():
                changed = np.asarray(_other(guess, was).any(axis=1))
                gain = np.where(changed, found - best, 0)
                both = changed[:-1] & changed[1:] & (gain[:-1] + gain[1:] > least)
                for rows in (gain > least, np.append(both, False) | np.append(False, both)):
                    # A gain beside rows as the guess has them may vanish beside the rows that stay.
                    joined = _joined(rows, guess, was)
                    if rows.any() and (gains := rows & (self.worth(joined, self.made_by(joined)) >= found)).any():
                        best = np.where(gains, np.maximum(found, best), best)
                        now = now | (gains[:, None] & _other(guess, base))
                        was = _joined(gains, guess, was)
                        break
        return was, now


def _silent(moved: Flags, gains: Flags) -> Flags:
    """Return the first rows (n,) of each run of `moved` rows, up to the first one that gains anything."""
    found, silent = np.zeros_like(moved), False
    for row, here in enumerate(moved.tolist()):
        silent = here and not gains[row] and (silent or not row or not moved[row - 1])
        found[row] = silent
    return found


def _slips(table: StudentTable, printed: StudentTable, ways: OwnWays) -> Counts:
    """Return how many cells of each row (n,) differ from the print and do not follow from earlier cells either."""
    return np.asarray((_other(table, printed) & ~ways.holds(table.values)).sum(axis=1))


def _joined(rows: Flags, guess: StudentTable, was: StudentTable) -> StudentTable:
    """Return the table `was` with some rows (n,) from a guess."""
    values, units = (np.where(rows[:, None], *both) for both in ((guess.values, was.values), (guess.units, was.units)))
    return replace(was, values=values, units=units)


def _other(table: StudentTable, than: StudentTable) -> Flags:
    return np.asarray((table.values != than.values) & np.isfinite(table.values))


def _touched(made: Flags, table: StudentTable, than: StudentTable) -> bool:
    """Return whether any cell `made` from a row (n, r + m) comes from a row in which the two tables differ."""
    return bool((made.any(axis=1) & _other(table, than).any(axis=1)).any())


def _made_into(cells: Flags, m: int) -> Flags:
    """Return cells (n, r + m) beside the row they are made from moved to where they stand, (n, m + r)."""
    return np.hstack([np.roll(cells[:, -m:], 1, axis=0), cells[:, :-m]])
