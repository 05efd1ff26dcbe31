"""An embedded pair that chooses its own step: Dormand and Prince 5(4).  Twelve digits are for `order_eight.py`.

Enters: a vector field.  Leaves: one accepted step at a time.  Used by `singular` and the accuracy study.
Source: J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.system.arrays import Array
from coursework.system.frozen import frozen

Field = Callable[[float, Array], Array]

_NODES = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
_ROWS = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
_ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
_WEIGHTS = [np.array(row) for row in _ROWS]
_DIFFERENCE = np.array(_ERROR)
SLOPES = 6  # new slopes a step: the last one is the first of the next step


@frozen
class Step:
    """`state` after the step, its estimated `error` (same shape), the slope there."""

    state: Array
    error: Array
    slope: Array


def dormand_prince(field: Field, at: float, state: Array, slope: Array, length: float) -> Step:
    """Return one step of the pair from `state` with known `slope` = field(at, state)."""
    slopes = np.empty((len(_NODES), len(state)))
    slopes[0] = slope
    point = state
    for index in range(1, len(_NODES)):
        point = state + length * (_WEIGHTS[index] @ slopes[:index])
        slopes[index] = field(at + _NODES[index] * length, point)
    return Step(point, length * (_DIFFERENCE @ slopes), slopes[-1])


def next_length(length: float, ratio: float, order: int = 5) -> float:
    """Return the next step length from the ratio error/tolerance of the last one, for a pair of `order`."""
    return float(length * min(4.0, max(0.2, 0.85 * max(ratio, 1e-10) ** (-1 / order))))


def integrate_adaptive(field: Field, state: Array, times: Array, tolerance: float) -> tuple[Array, int]:
    """Return the states at `times` (n, m) and the number of slopes; every row is hit by a step, not interpolated."""
    slope = field(float(times[0]), state)
    count = 1
    at, length = float(times[0]), float(times[-1] - times[0]) / 100
    rows = [state]
    for goal in times[1:]:
        while at < goal:
            last = at + length >= goal * (1 - 1e-14)
            taken = float(goal) - at if last else length
            step = dormand_prince(field, at, state, slope, taken)
            count += SLOPES
            ratio = float(np.max(np.abs(step.error) / (tolerance * (1.0 + np.abs(state)))))
            if ratio <= 1.0:
                at, state, slope = (float(goal) if last else at + taken), step.state, step.slope
            if not last or ratio > 1.0:
                length = next_length(taken, ratio)
        rows.append(state)
    return np.array(rows), count
