"""What a hypothesis says about each cell of a table, and how exactly the printed digits allow it to.

Enters: a `Key`, a student's table.  Leaves: `Claim`s by way of `TableUnderTest`.
Used by the hypotheses, by the code that compares them, and for the share that follows a student's own equations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.sensitivity import with_spread
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.starts import march
from coursework.grading.marking.table.ways import HALF, LEAST, SLACK, StudentTable, clear_velocities, put_right
from coursework.system.arrays import Array, Flags, shifted

# A hypothesis is examined only if this part of the velocities lies within _NEAR times Euler's tolerances of what it expects.
_NEARLY, _NEAR = 0.4, 60.0


@dataclass(frozen=True)
class Claim:
    """What a hypothesis says: the `expected` cells (n, m + r) and their `tolerance`, NaN where it says nothing.

    A column in which it says nothing at all is left to Euler's rules.  `student` is the table that it speaks about if that is not
    the one handed in (columns exchanged back, origins taken off); `is_whole`: it also claims the start.  `names` are the columns,
    starts or equations that it speaks of; `part` is its step as a part of the task's.  `table` computes its whole table, by
    Euler's steps with the velocities of `velocities_at` if that is given; `family` makes the claim about another table.
    `is_read_off`: its number was computed from the table itself, so that another cause that explains as much is preferred.
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
    family: Family | None = None
    is_read_off: bool = False


Family = Callable[["TableUnderTest"], Iterator[Claim]]


@dataclass(frozen=True)
class TableUnderTest:
    """A student's table as hypotheses see it: coordinates, velocities and the units of their last places.

    Without `closely` no hypothesis is skipped and no sensitivity computed: only the expected values are needed.
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
        """Return the units of the last places of the coordinates (n, m), 0 where missing."""
        return np.nan_to_num(self.student.units[:, : self.m])

    @cached_property
    def w_units(self) -> Array:
        """Return the units of the last places of all velocities (n, r), 0 where missing."""
        return np.nan_to_num(self.student.units[:, self.m :])

    @cached_property
    def of_task(self) -> Flags:
        """Return which cells (n, m + r) agree with the key."""
        return alike(self.key, self.student, self.key.table)

    def whole(self, q: Array | None = None, w: Array | None = None) -> Array:
        """Return a table (n, m + r) with the given coordinates or velocities, NaN elsewhere."""
        blank = np.full(self.student.values.shape, np.nan)
        if q is not None:
            blank[:, : self.m] = q
        if w is not None:
            blank[:, self.m :] = w
        return blank

    def steps(self, increments: Array, spread: Array) -> tuple[Array, Array]:
        """Return coordinates (n, m) made from the row before with `increments` (n, m) in rad or m, and their tolerance."""
        h = self.key.step
        expected = shifted(self.q + increments, 1)
        size = np.maximum(np.abs(self.w), LEAST * self.key.usual_ranges[self.m : 2 * self.m])
        slack = SLACK * h * np.nan_to_num(size)
        tolerance = HALF * self.q_units + shifted(HALF * self.q_units + HALF * spread + slack, 1)
        return expected, tolerance

    def rates_used(self) -> list[int]:
        """Return for each coordinate the rate of the same unit with which most of its steps were made; its own if in doubt.

        A coordinate that does not begin as the task's does keeps its own rate: its column may be that of another one.
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
        """Return velocities (n, r), NaN where the digits are too few, and their tolerance."""
        return clear_velocities(self.key, self.w_units, found, spread)

    def with_spread(
        self, function: Callable[[Array], Array], at: Array | None = None, units: Array | None = None
    ) -> tuple[Array, Array]:
        """Return a function of cells (by default the angles), and how uncertain it is because of their last places."""
        at = self.q if at is None else at
        if not self.closely:
            found = function(at)
            return found, np.zeros_like(found)
        return with_spread(function, at, self.q_units if units is None else units)

    def stacked(self, function: Callable[[Array, Array], Array], t: Array | None = None) -> Callable[[Array], Array]:
        """Return the function of q alone, for stacked copies of the rows, as sensitivities need it."""
        times = self.key.t if t is None else t
        return lambda q: function(np.tile(times, len(q) // len(times)), q)

    @cached_property
    def true_velocities(self) -> tuple[Array, Array]:
        """Return the velocities at the time and angles printed in each row, and their tolerance."""
        at = self.stacked(self.key.velocities_at)
        return self.velocities(*self.with_spread(at))

    def nearly(self, found: Array) -> bool:
        """Return whether velocities (n, r) come near enough to the printed ones for the hypothesis to be examined.

        Cells that may have been put right are near, and others with the task's value are left out.
        """
        if not self.closely:
            return True
        printed, tolerance, put, looked_at = self._nearness
        there = np.isfinite(found) & looked_at
        with np.errstate(invalid="ignore"):
            close = (put | (np.abs(printed - found) <= tolerance)) & there
        count = np.count_nonzero(there)
        return bool(count and np.count_nonzero(close) / count >= _NEARLY)

    @cached_property
    def _nearness(self) -> tuple[Array, Array, Flags, Flags]:
        """Return velocities (n, r), how near others must come, which may have been put right, and which to look at."""
        of_task, printed = self.of_task[:, self.m :], self.student.values[:, self.m :]
        put = put_right(of_task)
        return printed, _NEAR * self.true_velocities[1], put, np.isfinite(printed) & (put | ~of_task)

    @property
    def with_turns(self) -> Array | None:
        """Return the coordinates (n, m) as they were handed in, None if no whole turn was taken off."""
        turns = self.student.turns
        return None if turns is None or not turns[:, : self.m].any() else self.q + 2 * np.pi * turns[:, : self.m]

    def velocity_claim(
        self,
        code: str,
        at: Callable[[Array, Array], Array],
        found: Array | None = None,
        names: tuple[str, ...] = (),
        q: Array | None = None,
    ) -> Iterator[Claim]:
        """Yield the claim that the velocities are `at` (t, q) with the printed angles or `q`, if they are near enough."""
        stacked = self.stacked(at)
        q = self.q if q is None else q
        found = stacked(q) if found is None else found
        if self.nearly(found):
            spread = self.with_spread(stacked, q)[1] if self.closely else np.zeros_like(found)
            claim = self.claim(code, None, self.velocities(found, spread), names)
            yield replace(claim, table=self.marched(at), velocities_at=at)

    def marched(
        self, velocities_at: Callable[[Array, Array], Array], increments: Callable[[Array, Array, Array], Array] | None = None
    ) -> Callable[[], Array]:
        """Return a function that makes the whole table from the task's start with other velocities or steps, at most once."""
        return cache(partial(march, self.key, self.key.table[0, : self.m], velocities_at, increments))

    def claim(
        self,
        code: str,
        step: tuple[Array, Array] | None = None,
        velocities: tuple[Array, Array] | None = None,
        names: tuple[str, ...] = (),
    ) -> Claim:
        """Return a claim about steps, velocities or both; what is not given is left to Euler's rules."""
        q, q_tolerance = step or (None, None)
        w, w_tolerance = velocities or (None, None)
        return Claim(code, self.whole(q, w), self.whole(q_tolerance, w_tolerance), names=names)
