"""What a hypothesis says about each cell of a table, and how exactly the printed digits let it speak.

Enters: a `Key`, a student's table.  Leaves: `Claim`s by way of `TableUnderTest`.
Used by the hypotheses, by what weighs them, and by the share of a student's own equations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.sensitivity import sensitivity
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.starts import march
from coursework.grading.marking.table.ways import HALF, LEAST, SLACK, StudentTable, clear, velocity_tolerance
from coursework.system.arrays import Array, Flags, shifted

# A hypothesis is worth a closer look where this part of the velocities lies within this many of Euler's tolerances.
_NEARLY, _NEAR = 0.4, 60.0


@dataclass(frozen=True)
class Claim:
    """What a hypothesis says: `expected` (n, m + r), NaN where it is silent; `tolerance` alike.

    A column of which it says nothing is left to Euler's rules.  `student` is the table it speaks about where it is not the one
    handed in (columns put back, origins taken off); `is_whole` where the start is claimed too.
    `names` are the columns, starts or equations that it speaks of; `part` is that of the task's step which was made; `table`
    makes the whole table as the hypothesis has it, with steps of Euler from `velocities_at` where that is there; `family` makes
    the claim about another table; `is_read_off` where its number is the table's own: what else explains as much is meant then.
    """

    code: str
    expected: Array
    tolerance: Array
    student: StudentTable | None = None
    is_whole: bool = False
    names: tuple[str, ...] = ()
    table: Callable[[], Array] | None = None
    part: float = 1.0
    velocities_at: Callable[[Array, Array], Array] | None = None
    family: Callable[[TableUnderTest], Iterator[Claim]] | None = None
    is_read_off: bool = False


@dataclass(frozen=True)
class TableUnderTest:
    """A student's table seen by hypotheses: angles, velocities and their digits by themselves.

    Without `closely` no hypothesis is passed over and no sensitivity is worked out: what it expects is all that is asked.
    """

    key: Key
    student: StudentTable
    closely: bool = True

    @property
    def m(self) -> int:
        """Return the number of coordinates."""
        return len(self.key.coordinates)

    @property
    def q(self) -> Array:
        """Return the printed coordinates (n, m)."""
        return self.student.values[:, : self.m]

    @property
    def w(self) -> Array:
        """Return the printed rates of the coordinates (n, m)."""
        return self.student.values[:, self.m : 2 * self.m]

    @cached_property
    def q_units(self) -> Array:
        """Return the digits of the coordinates, 0 where missing."""
        return np.nan_to_num(self.student.units[:, : self.m])

    @cached_property
    def w_units(self) -> Array:
        """Return the digits of all velocities (n, r), 0 where missing."""
        return np.nan_to_num(self.student.units[:, self.m :])

    @cached_property
    def of_task(self) -> Flags:
        """Return which cells (n, m + r) are the key's."""
        return alike(self.key, self.student, self.key.table)

    def whole(self, q: Array | None = None, w: Array | None = None) -> Array:
        """Return a table (n, m + r) of some columns, NaN elsewhere."""
        blank = np.full(self.student.values.shape, np.nan)
        if q is not None:
            blank[:, : self.m] = q
        if w is not None:
            blank[:, self.m :] = w
        return blank

    def steps(self, increments: Array, spread: Array) -> tuple[Array, Array]:
        """Return coordinates (n, m) made from each row before by `increments` (n, m) in rad or m, and their tolerance."""
        h = self.key.step
        expected = shifted(self.q + increments, 1)
        size = np.maximum(np.abs(self.w), LEAST * self.key.usual_ranges[self.m : 2 * self.m])
        slack = SLACK * h * np.nan_to_num(size)
        tolerance = HALF * self.q_units + shifted(HALF * self.q_units + HALF * spread + slack, 1)
        return expected, tolerance

    def rates_used(self) -> list[int]:
        """Return for each coordinate the rate of its unit that most of its steps were made with, in doubt its own.

        Where a coordinate does not begin as the task's does, its column may be another one's: its own rate is left to it.
        """
        h, m, units = self.key.step, self.m, [one.unit for one in self.key.variant.coordinates]
        begins = np.abs(self.q[0] - self.key.table[0, :m]) <= self.q_units[0]
        found = list(range(m))
        for place in np.flatnonzero(begins).tolist():
            alike = [place, *(other for other in range(m) if other != place and units[other] == units[place])]
            held: list[int] = []
            for other in alike:
                rates, digits = (cells[:, [other] * m] for cells in (self.w, self.w_units[:, :m]))
                expected, tolerance = self.steps(h * rates, h * digits)
                held.append(int(np.count_nonzero(np.abs(self.q - expected)[:, place] <= tolerance[:, place])))
            found[place] = alike[held.index(max(held))]
        return found

    def velocities(self, found: Array, spread: Array) -> tuple[Array, Array]:
        """Return velocities (n, r) and their tolerance."""
        tolerance = velocity_tolerance(self.key, self.w_units, found, spread)
        return clear(self.key, found, tolerance), tolerance

    def spread(self, function: Callable[[Array], Array], at: Array | None = None, units: Array | None = None) -> Array:
        """Return by how much the digits of cells (the angles, where none are named) leave a function of them open."""
        at = self.q if at is None else at
        if not self.closely:
            return np.zeros_like(function(at))
        return sensitivity(function, at, self.q_units if units is None else units)

    def stacked(self, function: Callable[[Array, Array], Array], t: Array | None = None) -> Callable[[Array], Array]:
        """Return a function of stacked copies of the rows, as sensitivities need it."""
        times = self.key.t if t is None else t
        return lambda q: function(np.tile(times, len(q) // len(times)), q)

    @cached_property
    def true_velocities(self) -> tuple[Array, Array]:
        """Return the velocities of the printed row's time and angles."""
        at = self.stacked(self.key.velocities_at)
        return self.velocities(at(self.q), self.spread(at))

    def nearly(self, found: Array) -> bool:
        """Return whether velocities (n, r) come anywhere near those printed, the task's apart, which may have been put right.

        What does not is not looked at closer.
        """
        if not self.closely:
            return True
        tolerance = _NEAR * self.true_velocities[1]
        there = np.isfinite(found) & np.isfinite(self.student.values[:, self.m :]) & ~self.of_task[:, self.m :]
        with np.errstate(invalid="ignore"):
            close = np.abs(self.student.values[:, self.m :] - found) <= tolerance
        return bool(there.any()) and float(close[there].mean()) >= _NEARLY

    def velocity_claim(
        self, code: str, at: Callable[[Array, Array], Array], found: Array | None = None, names: tuple[str, ...] = ()
    ) -> Iterator[Claim]:
        """Yield the claim that the velocities are `at` (t, q) of the printed angles, where they are nearly so."""
        stacked = self.stacked(at)
        found = stacked(self.q) if found is None else found
        if self.nearly(found):
            claim = self.claim(code, None, self.velocities(found, self.spread(stacked)), names)
            yield replace(claim, table=self.marched(at), velocities_at=at)

    def marched(
        self, velocities_at: Callable[[Array, Array], Array], increments: Callable[[Array, Array, Array], Array] | None = None
    ) -> Callable[[], Array]:
        """Return what makes the whole table from the task's start, with other velocities or other steps: once, if at all."""
        return cache(partial(march, self.key, self.key.table[0, : self.m], velocities_at, increments))

    def claim(
        self,
        code: str,
        step: tuple[Array, Array] | None = None,
        velocities: tuple[Array, Array] | None = None,
        names: tuple[str, ...] = (),
    ) -> Claim:
        """Return a claim; what a hypothesis does not change is left to Euler."""
        q, q_tolerance = step or (None, None)
        w, w_tolerance = velocities or (None, None)
        return Claim(code, self.whole(q, w), self.whole(q_tolerance, w_tolerance), names=names)
