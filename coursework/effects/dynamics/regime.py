"""The steady motion of a crank driven by forces: the speed that repeats after a turn, its period, its unevenness.

Enters: `EquationsOfMotion` in one free coordinate, a start.  Leaves: `Regime`.  Computed on request only.
Used by `scene/motor_scene.py`.

The crank angle replaces the time: dw/dphi = a/w, dt/dphi = 1/w over a turn.  The speed at its start is found by shooting: the
secant method makes the change of speed in a turn zero.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.effects.dynamics.dynamics import Dynamics
from coursework.effects.dynamics.equations_of_motion import EquationsOfMotion
from coursework.effects.dynamics.why_ended import Open
from coursework.motion.integration.order_eight import dormand_prince_8
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

PIECES = 180  # parts of a turn: Dormand and Prince 8 leaves 1e-12 in each
MOST_SHOTS, REPEATS = 30, 1e-11  # largest number of trials; relative accuracy with which the speed must repeat


@frozen
class Regime:
    """The steady motion over a turn.

    `speed` is that at the first angle (rad/s), `period` in s, `mean` the mean speed; `largest` and `least` are the extreme speeds
    by size, at the angles `largest_at` and `least_at` (rad).
    """

    speed: float
    period: float
    mean: float
    largest: float
    largest_at: float
    least: float
    least_at: float

    @property
    def delta(self) -> float:
        """Return the unevenness (w_max - w_min)/w_mean, computed from sizes, for either sense of rotation."""
        return (abs(self.largest) - abs(self.least)) / self.mean


def find_regime(motion: EquationsOfMotion, places: list[float], speed: float) -> Regime | None:
    """Return the steady motion near a speed (rad/s), at the angle in `places`; None if no full turn is made.

    The forces must not depend on time.
    """
    try:
        tried = [(w, _turn(motion, places, w)[-1][1] - w) for w in (speed, 0.99 * speed)]
        for _ in range(MOST_SHOTS):
            (a, fa), (b, fb) = tried[-2:]
            if abs(fb) <= REPEATS * abs(b):
                return _told(motion, places, b)
            following = b - fb * (b - a) / (fb - fa)
            tried.append((following, _turn(motion, places, following)[-1][1] - following))
    except (Open, ZeroDivisionError, OverflowError, ValueError):
        return None
    return None


def _turn(motion: EquationsOfMotion, places: list[float], speed: float) -> list[tuple[float, float, float, float]]:
    """Return angle, speed, time and dw/dphi at the ends of the pieces of a turn."""
    dynamics = Dynamics(motion, list(places))
    begin = places[motion.free[0]]

    def moving(w: float, t: float, phi: float) -> list[float]:
        if w * speed <= 0:
            raise Open  # it turns back: not a full turn
        return [dynamics.slope(0.0, [phi, w])[1] / w, 1 / w, 1.0]

    state, length = np.array([speed, 0.0, begin]), math.copysign(2 * math.pi / PIECES, speed)
    rows = []
    for _ in range(PIECES + 1):
        slope = np.array(moving(*state.tolist()))
        rows.append((float(state[2]), float(state[0]), float(state[1]), float(slope[0])))
        state, _ = dormand_prince_8(moving, state, slope, length)
    return rows


def _told(motion: EquationsOfMotion, places: list[float], speed: float) -> Regime:
    rows = _turn(motion, places, speed)
    angle, w, t, slope = (np.array(column) for column in zip(*rows, strict=True))
    ends = []
    for sign in (1, -1):
        crossed = np.flatnonzero((sign * slope[:-1] > 0) & (sign * slope[1:] <= 0))
        places_of = [_between(angle, w, slope, int(k)) for k in crossed]
        ends.append(max(places_of, key=lambda one: sign * abs(one[1]), default=(float(angle[0]), float(w[0]))))
    (largest_at, largest), (least_at, least) = ends
    period = float(t[-1])
    return Regime(speed, period, float(abs(angle[-1] - angle[0])) / period, largest, largest_at, least, least_at)


def _between(angle: Array, w: Array, slope: Array, k: int) -> tuple[float, float]:
    """Return the angle between two rows at which the slope is zero, and the speed there, by the quintic through six slopes."""
    low = min(max(k - 2, 0), len(angle) - 6)
    x = (angle[low : low + 6] - angle[k]) / (angle[k + 1] - angle[k])
    quintic = np.polynomial.Polynomial.fit(x, slope[low : low + 6], 5).convert()
    found = [complex(root) for root in quintic.roots().tolist()]
    roots = [one.real for one in found if abs(one.imag) < 1e-9 and -1e-9 <= one.real <= 1 + 1e-9]
    at = roots[0] if roots else 0.0
    whole = quintic.integ()
    step = float(angle[k + 1] - angle[k])
    return float(angle[k]) + at * step, float(w[k]) + step * float(whole(at) - whole(0.0))
