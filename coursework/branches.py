"""The velocities possible at a change point, where two motions meet.

Enters: a change point.  Leaves: the two velocities of every unknown.  Used by `quantities.py` for the message.
At a change point A u = b has a line of solutions u + x v; of these the second derivative of the closure keeps
w (dA/dt u - db/dt) = 0 with w A = 0: quadratic in x.  Source: hard case H04, tangent cone of the loop closure.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.dead_point import Event, Flow

Array = NDArray[np.float64]
_STEP = 1e-5  # s along the motion; central difference, error about 1e-10
_FLAT = 1e-6  # a coefficient of the quadratic below this part of the largest is zero


def branches_at(flow: Flow, event: Event) -> tuple[dict[str, float], ...]:
    """Return the possible velocities at a change point, or nothing where they cannot be told apart."""
    matrix, right, known = flow.system.matrix(event.time, event.position.tolist())
    left, sizes, directions = np.linalg.svd(matrix)
    if len(sizes) < 2 or sizes[-2] < 1e-6 * sizes[0]:
        return ()
    w, v = left[:, -1], directions[-1]
    inverse = np.where(sizes > 1e-4 * sizes[0], 1.0 / np.where(sizes > 0, sizes, 1.0), 0.0)
    particular = directions.T @ (inverse * (left.T @ right))

    def demand(u: Array) -> float:
        motion = np.array([known[place] if driven else u[place] for driven, place in flow.rates])
        after, before = (
            flow.system.matrix(event.time + side * _STEP, (event.position + side * _STEP * motion).tolist()) for side in (1, -1)
        )
        return float(w @ ((after[0] - before[0]) @ u - (after[1] - before[1])) / (2 * _STEP))

    at = {x: demand(particular + x * v) for x in (-1.0, 0.0, 1.0)}
    square, slope, constant = (at[1.0] + at[-1.0]) / 2 - at[0.0], (at[1.0] - at[-1.0]) / 2, at[0.0]
    largest = max(abs(square), abs(slope), abs(constant), 1e-300)
    if abs(square) < _FLAT * largest:
        roots = [-constant / slope] if abs(slope) > _FLAT * largest else []
    else:
        inside = slope**2 - 4 * square * constant
        if inside < 0:
            return ()
        roots = [(-slope + sign * np.sqrt(inside)) / (2 * square) for sign in (1, -1)]
    found = [particular + x * v for x in roots]
    return tuple({name: float(value) for name, value in zip(flow.system.unknowns, u, strict=True)} for u in found)
