"""What the checks can use: any motion of a scene, together with the exact one.

Enters: a motion (of a scheme, exact, or somebody else's rows) and its scene.  Leaves: `Evidence`, which measures once what
several checks need.  Used by the rooms of `checks/` and made by `motion_results.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field
from functools import cached_property
from typing import TypeVar, cast

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.closure import Closure
from coursework.motion.integration.motion import Motion, Stop
from coursework.motion.integration.passage import Passage
from coursework.motion.integration.rates import Rates
from coursework.motion.integration.replay import Replay
from coursework.motion.singular.search import Search
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import caching
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say

Fact = TypeVar("Fact")
# The task sheet ends its table at a round number near the period (0.48 s for 0.480366 s): this share counts as the period.
NEAR_PERIOD = 0.01
# The scale of a column is at least OF_SIZE of a rate's largest size and OF_UNIT of the largest range in its unit.
OF_SIZE, OF_UNIT = 0.1, 0.05
# A smaller error (rad, sizes of the mechanism, or per second) counts as none: two exact motions differ by as much.
NO_ERROR = 1e-10
# The scale (rad or sizes) of a column at rest in a mechanism at rest: any error that counts is then off the scale.
STILL = 1e-9
# Products of doubles below this have fewer than sixteen digits: their differences mean nothing.
NO_DIGITS = float(np.finfo(float).tiny / np.finfo(float).eps)
# Relative difference of two largest values that may be due to round-off.
ALIKE = 1e-9
# Share of a column's scale by which a table may be off: nobody sees it in a graph.
LIMIT = 0.05


@caching
class Evidence:
    """`motion` judged against `exact`, on the same rows as far as both go; `exact` has no rows if it is unknown.

    `stop` is where the true motion ends; `extended_precision` the coordinates in extended precision (n, m), if known; `used` the
    equations solved for the velocities; `drive_frequency` (rad/s) that of the fastest sine in the drive; `search` the true motion
    followed for dead points, None if it was not.  `replay` makes each row again from the row before, None for rows not made by
    one of our schemes; `rerun(scheme, step)` gives the same run made otherwise, None if that is impossible.
    `passages` are singular positions that the motion goes through; `order` is the highest derivative of the motion asked for.
    `facts` about the exact motion alone are found once and shared by all tables of the scene.  `is_trial` marks a trial of a step
    that may be advised.
    """

    variant: Variant
    equations: VelocityEquations
    rates: Rates
    motion: Motion
    exact: Motion
    extended_precision: Array | None
    closure: Closure | None
    agreed: tuple[str, ...]
    stop: Stop | None
    used: tuple[str, ...]
    drive_frequency: float
    search: Search | None = None
    replay: Replay | None = None
    rerun: Callable[[str, float], Motion | None] | None = None
    passages: tuple[Passage, ...] = ()
    order: int = 1
    facts: dict[str, object] = field(default_factory=dict)
    is_trial: bool = False

    def say(self, key: str, /, **values: object) -> str:
        """Return a sentence about the motion; empty for a trial, of which only verdicts and numbers are read."""
        return "" if self.is_trial else say(key, **values)

    @property
    def restricted(self) -> bool:
        """Return whether only some columns were asked for."""
        return len(self.motion.names) < len(self.variant.columns)

    @property
    def period(self) -> float:
        """Return the period of the motion (s): the stated one, else the end of the run."""
        time = self.variant.time
        return time.period if time.period is not None else time.end

    @property
    def period_row(self) -> int | None:
        """Return the row nearest to the last whole period inside the run, None if the run is shorter than one period."""
        step = self.motion.step
        if not len(self.motion.t):
            return None
        near = max(step / 2, NEAR_PERIOD * self.period)
        whole = int((self.motion.t[-1] + near) / self.period)
        return min(round(whole * self.period / step), len(self.motion.t) - 1) if whole else None

    @cached_property
    def _of_rows(self) -> dict[str, object]:
        return {}

    def once(self, name: str, find: Callable[[], Fact], *, of_rows: bool = False) -> Fact:
        """Return a fact about the exact motion, or one `of_rows` themselves, computed when it is first asked for."""
        facts = self._of_rows if of_rows else self.facts
        if name not in facts:
            facts[name] = find()
        return cast("Fact", facts[name])

    def unit(self, name: str) -> str:
        """Return the unit of a column."""
        return self.variant.unit_of(name)

    @cached_property
    def angles(self) -> Flags:
        """Return which of the judged columns are angles (k,)."""
        return np.array([self.unit(name) == "rad" for name in self.names], dtype=bool)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Return the columns that are judged: all but the driven rates, which no scheme can get wrong."""
        known = self.variant.known_rates
        return tuple(name for name in self.motion.names if name not in known)

    @cached_property
    def scale(self) -> dict[str, float]:
        """Return the scale S = max(R, 0.1 A, 0.05 U) of each column in its unit.

        R is the range of the exact motion over the first period at most (an angle's at most 2π), A the largest size of a
        velocity, U the largest R among the columns of the same unit.
        """
        return self.once(f"scale of {len(self.exact.t)} rows each {self.exact.step!r} s", self._scale)

    def _scale(self) -> dict[str, float]:
        exact = self.exact
        period = self.variant.time.period
        last = len(exact.t) if period is None or not exact.step else round(period / exact.step) + 1
        rows = exact.rows[: max(last, 2)]
        units = [self.unit(name) for name in exact.names]
        spreads = [
            min(spread, 2 * np.pi) if unit == "rad" else spread
            for spread, unit in zip(np.ptp(rows, axis=0).tolist(), units, strict=True)
        ]
        sizes = np.max(np.abs(rows), axis=0)
        sizes[: len(exact.coordinate_names)] = 0.0
        still = [STILL / NO_ERROR * self.least(name) for name in exact.names]
        return dict(zip(exact.names, scales_of(spreads, sizes.tolist(), units, still), strict=True))

    def least(self, name: str) -> float:
        """Return the error (unit of a column) below which it counts as none."""
        return NO_ERROR * float(self.equations.units([name])[0])

    @cached_property
    def scales(self) -> Array:
        """Return the scales of the judged columns (k,)."""
        return np.array([self.scale[name] for name in self.names])

    @property
    def compared(self) -> int:
        """Return how many rows the table and the exact motion have in common."""
        return min(len(self.motion.t), len(self.exact.t))

    def table(self, motion: Motion) -> Array:
        """Return the judged columns of a motion (compared rows, k)."""
        places = [motion.names.index(name) for name in self.names]
        return np.asarray(motion.rows[: self.compared, places])

    @cached_property
    def errors(self) -> Array:
        """Return table minus exact as shares of the scales (compared rows, k); whole turns of an angle are no error."""
        gap = self.table(self.motion) - self.table(self.exact)
        if np.any(np.abs(gap[:, self.angles]) >= np.pi / 2):  # with smaller gaps no angle is a turn off
            jumps = np.diff(gap[:, self.angles], axis=0, prepend=0.0)
            gap[:, self.angles] -= np.cumsum(whole_turns(jumps), axis=0)
        return np.where(np.abs(gap) < [self.least(name) for name in self.names], 0.0, gap) / self.scales

    @cached_property
    def residuals(self) -> tuple[tuple[str, ...], Array]:
        """Return the names of all equations and |A u - b| for every row, relative to the sum of the absolute terms."""
        motion = self.motion
        system = compile_system(self.equations, self.equations.equations)
        matrix, right, _ = system.matrices(motion.t, motion.coordinates)
        u = np.array([motion.column(name) for name in system.unknowns]).T.reshape(len(motion.t), len(system.unknowns))
        terms = matrix * u[:, None, :]
        scale = np.abs(terms).sum(axis=2) + np.abs(right)
        gap = np.abs(terms.sum(axis=2) - right)
        shares = np.where(scale > NO_DIGITS, gap / np.where(scale > NO_DIGITS, scale, 1.0), 0.0)
        for passage in self.passages:  # there the equations say 0 = 0, and the share would be pure round-off
            shares[passage.is_at(motion.t)] = 0.0
        return system.names, shares


def scales_of(spreads: Sequence[float], sizes: Sequence[float], units: Sequence[str], still: Sequence[float]) -> list[float]:
    """Return max(R, 0.1 A, 0.05 U, still) of each column: R its range, A its size, U the widest range of its unit."""
    widest = {unit: max(spread for spread, other in zip(spreads, units, strict=True) if other == unit) for unit in set(units)}
    return [
        max(spread, OF_SIZE * size, OF_UNIT * widest[unit], least)
        for spread, size, unit, least in zip(spreads, sizes, units, still, strict=True)
    ]


def worst(shares: Array) -> tuple[int, int]:
    """Return row and column (from 0) of the largest size in (n, k); nan and infinity count as largest.

    Of sizes equal but for round-off, the first column is taken, and in it the first row, so that all places of a page agree.
    """
    sizes = np.where(np.isfinite(shares), np.abs(shares), np.inf)
    alike = sizes >= (1 - ALIKE) * np.max(sizes)
    column = int(np.argmax(alike.any(axis=0)))
    return int(np.argmax(alike[:, column])), column
