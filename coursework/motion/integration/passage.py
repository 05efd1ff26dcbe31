"""A motion through a singular position where its velocities have a limit (0/0) and only one continuation exists.

Enters: `Passage`, found by the search for dead points.  Leaves: rates that know the limit, and positions on the way through.
Used by `integrate.py`, `exact_motion.py`, the kinematics and the scene; made by `motion/singular/passing.py`.

Between the flanks, two on each side, the motion is the polynomial through their positions and rates and those of the passage
itself.  Its degree is nine, so it is exact to round-off over a hundredth of the way to the next singular position.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from coursework.motion.integration.motion import AT_EVENT
from coursework.motion.integration.rates import Rates
from coursework.system.arrays import Array
from coursework.system.frozen import caching, frozen

# Places of the flanks about the passage, and weights by which their values interpolate its own (error flank^4).
FLANKS = (-2, -1, 1, 2)
WEIGHTS = (-1 / 6, 2 / 3, 2 / 3, -1 / 6)


@frozen
class State:
    """One state of the true motion: `time` (s), `position` (m,), every velocity by its name."""

    time: float
    position: Array
    velocities: Mapping[str, float]


@caching
class Passage:
    """A passage through the singular position `middle`, where the determinant of block number `block` vanishes.

    The four `flanks` are states around it, `flank` s apart; `rates` are the names of the coordinates' rates.  The determinant has
    a zero of the given `order`: a double one does not change its sign.
    """

    block: int
    middle: State
    flanks: tuple[State, ...]
    flank: float
    rates: tuple[str, ...]
    order: int = 1

    def is_at(self, t: Any) -> Any:
        """Return whether a time (s), or each of times (n,), is that of the passage."""
        return np.abs(t - self.middle.time) <= AT_EVENT * self.middle.time

    @cached_property
    def _coefficients(self) -> Array:
        states = (self.middle, *self.flanks)
        x = np.array([(state.time - self.middle.time) / self.flank for state in states])
        count = 2 * len(states)
        values = np.vander(x, count, increasing=True)
        slopes = np.hstack([np.zeros((len(x), 1)), values[:, :-1] * np.arange(1, count)])
        rates = [[state.velocities[name] * self.flank for name in self.rates] for state in states]
        return np.linalg.solve(np.vstack([values, slopes]), np.vstack([[state.position for state in states], rates]))

    def positions(self, times: Array) -> Array:
        """Return the positions (n, m) at `times` (s) between the outer flanks."""
        x = (times - self.middle.time) / self.flank
        return np.vander(x, len(self._coefficients), increasing=True) @ self._coefficients


def through(rates: Rates, passages: Sequence[Passage]) -> Rates:
    """Return rates that give the limit's velocities at each passage, where their own formulas are 0/0."""
    if not passages:
        return rates
    limits = [_limit(rates, passage) for passage in passages]

    def evaluate(t: float, *q: float) -> tuple[float, ...]:
        known = (limit for passage, limit in zip(passages, limits, strict=True) if passage.is_at(t))
        return next(known, None) or rates.evaluate(t, *q)

    def rows(t: Array, *q: Array) -> tuple[Array, ...]:
        with np.errstate(all="ignore"):
            found: tuple[Array, ...] = rates.rows(t, *q)
        for passage, limit in zip(passages, limits, strict=True):
            found = tuple(np.where(passage.is_at(t), there, value) for there, value in zip(limit, found, strict=True))
        return found

    evaluate.__doc__ = rates.evaluate.__doc__
    return replace(rates, evaluate=evaluate, rows=rows)


def _limit(rates: Rates, passage: Passage) -> tuple[float, ...]:
    """Return velocities and determinants at a passage: its own determinant is 0, the others are interpolated from the flanks."""
    own = [passage.middle.velocities[name] for name in rates.velocities]
    places = [index for index, rate in enumerate(passage.rates) if rate in rates.velocities[: len(rates.coordinates)]]
    beside = [rates.evaluate(state.time, *state.position[places].tolist())[len(own) :] for state in passage.flanks]
    others = np.array(WEIGHTS) @ np.array(beside)
    return (*own, *(0.0 if block == passage.block else float(value) for block, value in zip(rates.blocks, others, strict=True)))
