"""How much of a table something explains, behind the gates of the points.

Enters: marked cells, where an explanation holds.  Leaves: `Fit`, shares of the cells.
Used by `misconceptions.py`, `earning.py`, `whole.py`.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells, alike
from coursework.grading.marking.table.points import (
    constant,
    following,
    handed_in,
    in_a_run,
    left_open,
    moves_as_it_may,
    stands_still,
)
from coursework.grading.marking.table.untold import but, ramp
from coursework.grading.marking.table.ways import KEY, Places
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import caching, frozen

# If an explanation holds for up to _FEW of a column's cells, it held for none of those beside a cell put right; from _MOSTLY on
# it held for all.
_FEW, _MOSTLY = 0.25, 0.5


@frozen
class Fit:
    """A hypothesis (`code`) and the share of the cells that it or the key explains, with the gates of the points.

    `beyond_euler`: it explains more than Euler's rules do. `in_print`: by a table that differs from the one handed in only in how
    it was printed.
    """

    code: str
    share: float
    names: tuple[str, ...] = ()
    beyond_euler: bool = True
    in_print: bool = False


@caching
class Explained:
    """The gates of a marked table, which many explanations are held against."""

    key: Key
    cells: Cells

    def share(self, holds: Flags, *, as_it_is: bool = False, table: Array | None = None, excuses: float = 1.0) -> float:
        """Return the share of counted cells that some explanation `holds` for (n, m + r), or that agree with the key.

        The gates are those of the points. A step counts if its velocity is explained too; a velocity, if its row belongs to the
        motion of the explained steps and it is explained too. A cell that agrees with the key counts whatever explains others;
        where an explanation has another value, what was made from that one is explained as it was before. A wrong start value
        costs a cell. With `as_it_is` no cell is taken as put right, and those of the key count in runs. `table` (n, m + r) is the
        one that the explanation makes, None if unknown: where it has another value, a cell of the key was put right. `excuses` is
        the part (0 to 1) of the cells explained as they were before that counts.
        """
        m, rows = self.key.m, self._rows
        explained = (holds | self.by_key) & self.spoken
        counts = self._in_runs.copy()
        if not as_it_is:
            counts |= self.by_key & self.cells.counted & ~constant(self.key)
            before = self._as_before(holds if table is None else alike(self.key, self.cells.student, table), explained)
            explained |= before & ~but(before, excuses)
        steps = explained[rows[1:], :m] & explained[rows[:-1], m : 2 * m] & (self._moves | self._hardly)
        counts[rows[1:], :m] |= steps
        moves = np.asarray(self._moves.any(axis=1))
        follows, motion = following(self.cells.student.values[rows, :m], steps | self._left_open, moves)
        found = np.zeros_like(explained)
        found[rows, m:] = explained[rows, m:] & follows[:, None]
        counts |= found & ~but(found, motion)
        return max(float(counts.sum()) - int((self.cells.wrong & ~holds)[:1, :m].sum()), 0.0) / max(
            int(self.cells.counted.sum()), 1
        )

    def _as_before(self, holds: Flags, explained: Flags) -> Flags:
        """Return cells (n, m + r) that were explained before cells of their row or of the row above were put right.

        Put right are cells of columns with few of the key's values. Where few of a column's other cells are explained, or few
        are left, few were explained.
        """
        rows = self._rows
        beside = np.zeros(len(holds), dtype=bool)
        beside[rows] = self._beside_put((self.by_key & ~holds & self.spoken)[rows], explained[rows])
        lost = self.spoken & beside[:, None] & ~explained
        told = (self.spoken & ~beside[:, None]) | (explained & ~self.by_key)
        usual = (explained & told).sum(axis=0) / np.maximum(_FEW * len(rows), told.sum(axis=0))
        before = np.zeros_like(explained)
        for column in np.flatnonzero(lost.any(axis=0) & (usual > _FEW)).tolist():
            alone = np.zeros_like(lost)
            alone[:, column] = lost[:, column]
            before |= alone & ~but(alone, ramp(float(usual[column]), _FEW, _MOSTLY))
        return before

    def _beside_put(self, put: Flags, explained: Flags) -> Flags:
        """Return which rows handed in hold a cell `put` right, or are made from such a row.

        A velocity beside an angle that nothing explains tells no more what its row was made from: it may agree by chance, and
        be explained as soon as that angle is right.
        """
        m = self.key.m
        unexplained = self.spoken[self._rows, :m] & ~explained[:, :m]
        angles, rates, astray = (np.asarray(part.any(axis=1)) for part in (put[:, :m], put[:, m:], unexplained))
        beside = np.zeros(len(put), dtype=bool)
        for row in np.flatnonzero(angles | rates).tolist():
            beside[row : row + 2] |= angles[row] | beside[row] | ~astray[row]
        return beside

    @cached_property
    def _rows(self) -> Places:
        return handed_in(self.cells)

    @cached_property
    def by_key(self) -> Flags:
        """Return which cells (n, m + r) agree with the key."""
        return np.asarray(self.cells.marks == KEY)

    @cached_property
    def spoken(self) -> Flags:
        """Return the cells (n, m + r) about which anything can be said: all that are shown except start values."""
        return self.cells.judged

    @cached_property
    def _moves(self) -> Flags:
        return moves_as_it_may(self.key, self.cells)

    @cached_property
    def _left_open(self) -> Flags:
        return left_open(self.key, self.cells, self._rows)

    @cached_property
    def _hardly(self) -> Flags:
        """Return the steps (n - 1, m) that the table's own velocities make smaller than its digits, if anything moves at all."""
        m, rows, student = self.key.m, self._rows, self.cells.student
        small = np.diff(self.key.t[rows])[:, None] * np.abs(student.values[rows[:-1], m : 2 * m]) <= student.units[rows[1:], :m]
        return np.asarray(small & (not stands_still(self.key, self.cells)))

    @cached_property
    def _in_runs(self) -> Flags:
        """Return the cells that agree with the key in runs of rows: they count whatever explains the others."""
        return np.asarray(self.by_key & self.cells.counted & in_a_run(self.by_key, self._rows) & ~constant(self.key))


def share_of(explained: Flags, spoken: Flags) -> float:
    """Return the share of the cells spoken about that are explained; 0 if there are none."""
    return float(explained.sum()) / float(spoken.sum()) if spoken.any() else 0.0


def euler_cells(cells: Cells) -> tuple[Flags, Flags]:
    """Return which cells follow Euler's rules, and which cells these speak about: all that are shown except start values."""
    spoken = cells.judged
    return cells.follows & spoken, spoken
