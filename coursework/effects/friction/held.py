"""Friction that stops a motion: no equilibrium exists, or a pair at rest does not start to slide.

Used by `dynamics.py` and `scene/motor_scene.py`, which tell where a motion ends, `rubbing.py`, which finds it, `friction.py`,
and `dynamics_checks.py`.
"""

from __future__ import annotations

import math

STILL = 1e-12  # share of the largest speed: slower counts as at rest


class Held(ArithmeticError):
    """Friction holds the mechanism at the point `at` and `time` (s): no equilibrium (`locked`), or a pair at rest does not start.

    `state` is the state in which it does not start, its time last, () if unknown; `at` is "" if no force pulls.
    """

    def __init__(self, at: str, locked: bool) -> None:
        super().__init__(at)
        self.at, self.locked, self.time = at, locked, math.nan
        self.state: tuple[float, ...] = ()

    def seen(self, time: float) -> Held:
        """Return the exception with its time (s) set, unless it is known already."""
        self.time = time if math.isnan(self.time) else self.time
        return self
