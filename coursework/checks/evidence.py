"""What the checks may look at, gathered once.

Enters: the motion and what was computed around it.  Leaves: `Evidence` with the scheme's own estimated error.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.geometry.closure import Closure
from coursework.integration.motion import Motion
from coursework.reduction.equations import VelocityEquations
from coursework.schemes import SCHEMES
from coursework.variant.record import Variant

Array = NDArray[np.float64]
# The task sheet ends its table at a round number beside the period (0.48 s for 0.480366 s): that counts as the period.
NEAR_PERIOD = 0.01


@dataclass(frozen=True, slots=True)
class Evidence:
    """`motion` judged; `half` the same scheme with half the step; `exact` and `wide` (extended numbers) where known.

    `scheme_error` (n, m + k) estimated from our own runs, so that a wrong row cannot widen the limit it is judged by;
    `used` names the equations solved for the velocities; `drive_frequency` rad/s of the fastest sine in the drive,
    `sinusoidal` whether the drive is made of sines alone; `fastest` per coordinate (largest rate of the true motion, when).
    """

    variant: Variant
    equations: VelocityEquations
    motion: Motion
    half: Motion | None
    exact: Motion | None
    wide: Array | None
    closure: Closure | None
    scheme_error: Array | None
    used: tuple[str, ...]
    drive_frequency: float
    sinusoidal: bool
    fastest: tuple[tuple[float, float], ...] = ()

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
        """Return the row nearest to the last whole period inside the run, None where the run is shorter than one."""
        step = self.motion.step
        if not len(self.motion.t):
            return None
        near = max(step / 2, NEAR_PERIOD * self.period)
        whole = int((self.motion.t[-1] + near) / self.period)
        return min(round(whole * self.period / step), len(self.motion.t) - 1) if whole else None

    def unit(self, name: str) -> str:
        """Return the unit of a column."""
        return self.variant.unit_of(name)


def richardson(motion: Motion, half: Motion | None) -> Array | None:
    """Return the estimated scheme error of every row and column (n, m + k), None without a half-step run.

    With order p, error = (y_h - y_h/2) 2^p/(2^p - 1).
    """
    rows = motion.rows
    if half is None or len(half.t) < 2 * len(rows) - 1:
        return None
    factor = 2.0 ** SCHEMES[motion.scheme].order
    return np.asarray((rows - half.rows[: 2 * len(rows) : 2]) * factor / (factor - 1))
