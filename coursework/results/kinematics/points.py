"""Positions, velocities and accelerations of the named points along a motion.

Enters: equations and a motion.  Leaves: names and rows, two columns for each level of a point.  Computed on request only.
Used by `drawing/trajectories.py` and `motion_results.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.time_derivatives import jets
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array


def point_rows(equations: VelocityEquations, motion: Motion, second: Array | None = None) -> tuple[tuple[str, ...], Array]:
    """Return names (A.x, A.y, A.vx, A.vy and, with accelerations `second` (n, k), A.ax, A.ay) and rows (n, names) in SI units."""
    vectors = equations.symbols.vectors
    wanted = [component for vector in vectors.values() for component in vector]
    order = 1 if second is None else 2
    levels = [rows(motion.t, motion.coordinates, motion.velocities, second) for rows in jets(equations, wanted, order)]
    prefixes = ("", "v", "a")[: order + 1]
    names = [f"{name}.{prefix}{axis}" for name in vectors for prefix in prefixes for axis in "xy"]
    columns = [level[:, 2 * index + place] for index in range(len(vectors)) for level in levels for place in (0, 1)]
    return tuple(names), np.array(columns).T.reshape(len(motion.t), len(names))
