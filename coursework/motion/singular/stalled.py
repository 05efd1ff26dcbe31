"""Where a flow that has stalled was going: the zero of a determinant that comes whatever the block itself does.

Enters: the flow, the state at which it stalled.  Leaves: the state of the zero.  Used by `walk.py`.
A determinant that touches zero is below 1e-10 from 1e-5 before that on; time and place of the zero are found by Newton's method.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.singular.scaled_flow import Flow
from coursework.system.arrays import Array

_STEPS = 4  # each doubles the digits
_NUDGE = 1e-6  # share of the run; step of the differences


def ahead(flow: Flow, state: Array, block: int, end: float, *, within: float | None = None) -> Array:
    """Return the state (position, then t) at which the determinant of a block has its simple or double zero.

    The block rests on the way, because its velocities may grow without bound, or moves at most `within` (rad or share of the
    size) as it did.
    """

    def size_at(state: Array) -> float:
        *q, t = state.tolist()
        return flow.scaled(t, q)[block]

    begun, size, nudge = state, abs(size_at(state)), _NUDGE * end
    for _ in range(_STEPS):
        if not size:
            break
        *q, t = state.tolist()
        if within is None:
            moving = np.append(flow.part(t, q, block)[2], 1.0)
        else:
            moving = np.array(flow.slopes(t, q, block))
            moving /= moving[-1]
        now, after, before = (size_at(state + side * nudge * moving) for side in (0, 1, -1))
        lengths = [-order * now * 2 * nudge / (after - before) for order in (1, 2)] if after != before else [0.0]
        reached = {abs(size_at(one)): one for one in (state + length * moving for length in lengths)}
        nearest = min(reached)
        if not nearest < size or (within is not None and np.max(np.abs(reached[nearest] - begun)[:-1] / flow.units) > within):
            break
        state, size = reached[nearest], nearest
    return state
