"""Whether rows follow from each other: each row is made again from the row before it.

Enters: rates, a scheme, a correction, a motion.  Leaves: the rows as they must be.  Used by the checks.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.motion.integration.integrate import Correction, Row
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import Scheme
from coursework.system.arrays import Array
from coursework.system.frozen import frozen


@frozen
class Replay:
    """How the rows of a run were made: with `scheme` from `start` (rad, m), with the run's own `correction`."""

    rates: Rates
    scheme: Scheme
    start: Sequence[float]
    correction: Correction | None = None

    def rows(self, motion: Motion) -> Array:
        """Return all rows (n, m + k): coordinates by one step from the row before, velocities from the row's own coordinates."""
        if self.correction is not None:
            return np.array([self.row(motion, index) for index in range(len(motion.t))])
        t, q, slopes = motion.t[:-1], motion.coordinates[:-1], self.rates.slopes_of_rows(motion.t[1:])
        with np.errstate(all="ignore"):
            moved = self.scheme.step(slopes, t, q, motion.step) if len(t) else q
            velocities, _ = self.rates.table(motion.t, motion.coordinates)
        return np.hstack([np.vstack([np.array(self.start, dtype=float)[None, :], moved]), velocities])

    def row(self, motion: Motion, index: int) -> Array:
        """Return one row (m + k,) in the scalar arithmetic of the march itself."""
        rates = self.rates
        own = rates.evaluate(float(motion.t[index]), *motion.coordinates[index].tolist())[: len(rates.velocities)]
        if index == 0:
            return np.array([*self.start, *own])
        t, q, step = float(motion.t[index - 1]), motion.coordinates[index - 1], motion.step
        moved = self.scheme.step(rates.slopes(index * step), t, q, step)
        if self.correction is not None:
            targets = self.correction.closure.targets(motion.t)
            moved = self.correction.corrected(targets, Row(index - 1, t, q), step, moved)
        return np.array([*moved, *own])
