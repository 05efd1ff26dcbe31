"""What friction stops: nothing balances it, or a pair that stands still does not go on.

Used by `dynamics.py` and `scene/motor_scene.py`, which tell where a motion ends, `rubbing.py`, which finds it, `friction.py`,
and `dynamics_checks.py`.
"""

from __future__ import annotations

import math

STILL = 1e-12  # of the largest speed: slower is still


class Held(ArithmeticError):
    """Friction holds: nothing balances (`locked`), or a pair that stands still does not go on; at the point `at`, `time` (s).

    `state` is the one in which it does not go on, its time last, () where that is not known; `at` is "" where nothing pulls.
    """

    def __init__(self, at: str, locked: bool) -> None:
        super().__init__(at)
        self.at, self.locked, self.time = at, locked, math.nan
        self.state: tuple[float, ...] = ()

    def seen(self, time: float) -> Held:
        """Return the same with its time (s), where none is known yet."""
        self.time = time if math.isnan(self.time) else self.time
        return self
