"""How much of a table something explains, behind the gates of the points.

Enters: marked cells, where an explanation holds.  Leaves: `Fit`, shares of the cells.
Used by `misconceptions.py`, `earning.py`, `whole.py`.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.cells import Cells
from coursework.grading.marking.table.points import (
    constant,
    excused,
    following,
    handed_in,
    in_a_run,
    moves_as_it_may,
    stands_still,
)
from coursework.grading.marking.table.untold import but
from coursework.grading.marking.table.ways import KEY, Places
from coursework.system.arrays import Flags
from coursework.system.frozen import caching, frozen

# Part of the velocities that must be explained before a row counts as one in which a cell was put right.
_MOSTLY = 0.5


@frozen
class Fit:
    """A hypothesis (`code`) and the share of the cells that it or the key explains, with the gates of the points.

    For steps of another length only velocities count: the steps are wrong, whichever of their rows are on the grid.
    `beyond_euler`: it explains more than Euler's rules do.
    """

    code: str
    share: float
    names: tuple[str, ...] = ()
    beyond_euler: bool = True


@caching
class Explained:
    """The gates of a marked table, which many explanations are held against."""

    key: Key
    cells: Cells

    def share(self, holds: Flags, *, only_velocities: bool = False, as_it_is: bool = False) -> float:
        """Return the share of counted cells that some explanation `holds` for (n, m + r), or that agree with the key.

        The gates are those of the points. A step counts if its velocity is explained too, or was before a cell of its row was
        put right; a velocity, if its row belongs to the motion of the explained steps and it is explained too, or may have been
        before a coordinate of its row was put right; other right cells count in runs. A wrong start value costs a cell.
        With `as_it_is` no cell of the table is taken as put right; with `only_velocities` no coordinate counts.
        """
        m, rows, by_key, held = len(self.key.coordinates), self._rows, self._by_key, holds
        after_put = (holds & ~by_key)[rows[1:], :m] & self._above_put
        holds = (holds | by_key) & self._spoken
        mostly = not as_it_is and holds[rows, m:].mean() >= _MOSTLY
        after_put &= mostly
        before = mostly & excused(by_key[rows, :m], holds[rows, m:]) & self._spoken[rows, m:]
        steps = holds[rows[1:], :m] & (holds[rows[:-1], m : 2 * m] | after_put) & (self._moves | self._hardly)
        counts = self._in_runs.copy()
        counts[rows[1:], :m] |= steps
        follows, motion = following(self.cells.student.values[rows, :m], steps, np.asarray(self._moves.any(axis=1)))
        found = np.zeros_like(holds)
        found[rows, m:] = (holds[rows, m:] | before) & follows[:, None]
        counts |= found & ~but(found, motion)
        if only_velocities:
            counts[:, :m] = False
        return max(float(counts.sum()) - int((self.cells.wrong & ~held)[:1, :m].sum()), 0.0) / max(self._count, 1)

    @cached_property
    def _rows(self) -> Places:
        return handed_in(self.cells)

    @cached_property
    def _by_key(self) -> Flags:
        return np.asarray(self.cells.marks == KEY)

    @cached_property
    def _above_put(self) -> Flags:
        """Return the steps (n - 1, 1) from a row in which a cell agrees with the key."""
        return np.asarray(self._by_key.any(axis=1))[self._rows[:-1], None]

    @cached_property
    def _spoken(self) -> Flags:
        return ~self.cells.missing & self.cells.counted

    @cached_property
    def _count(self) -> int:
        return int(self.cells.counted.sum())

    @cached_property
    def _moves(self) -> Flags:
        return moves_as_it_may(self.key, self.cells)

    @cached_property
    def _hardly(self) -> Flags:
        """Return the steps (n - 1, m) that the table's own velocities make smaller than its digits, if anything moves at all."""
        m, rows, student = len(self.key.coordinates), self._rows, self.cells.student
        small = np.diff(self.key.t[rows])[:, None] * np.abs(student.values[rows[:-1], m : 2 * m]) <= student.units[rows[1:], :m]
        return np.asarray(small & (not stands_still(self.key, self.cells)))

    @cached_property
    def _in_runs(self) -> Flags:
        """Return the cells that agree with the key in runs of rows: they count whatever explains the others."""
        return np.asarray(self._by_key & self.cells.counted & in_a_run(self._by_key, self._rows) & ~constant(self.key))


def share_of(explained: Flags, spoken: Flags) -> float:
    """Return the share of the cells spoken about that are explained; 0 if there are none."""
    return float(explained.sum()) / float(spoken.sum()) if spoken.any() else 0.0


def euler_cells(key: Key, cells: Cells) -> tuple[Flags, Flags]:
    """Return which cells follow Euler's rules, and which cells these speak about: all that are shown except start values."""
    spoken = ~cells.missing
    spoken[0, : len(key.coordinates)] = False
    return cells.follows & spoken, spoken
