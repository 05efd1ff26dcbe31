"""Accelerations from the differentiated velocity equations: A du/dt = db/dt - dA/dt u, never by differencing a table.

Enters: equations and a motion.  Leaves: the derivative of every velocity (n, k).  Computed on request only.
Used by `way_to_motion.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import TIME, symbol
from coursework.equations.reduction.system import compile_system
from coursework.motion.geometry.time_derivatives import acceleration_rest, compile_rows
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.passage import WEIGHTS, Passage
from coursework.system.arrays import Array


def accelerations(equations: VelocityEquations, reduction: Reduction, motion: Motion, passages: Sequence[Passage] = ()) -> Array:
    """Return the derivatives (n, k) of `motion.velocities`, rad/s² or m/s² (no rows if the motion has none).

    In a row at one of the `passages` they are a weighted mean over its flanks.
    """
    if not any(np.any(passage.is_at(motion.t)) for passage in passages):
        return _accelerations(equations, reduction, motion)
    beside = [_accelerations(equations, reduction, _moved(motion, passages, place)) for place in range(len(WEIGHTS))]
    found = beside[0].copy()
    for passage in passages:
        at = passage.is_at(motion.t)
        found[at] = sum(weight * rows[at] for weight, rows in zip(WEIGHTS, beside, strict=True))
    return found


def _moved(motion: Motion, passages: Sequence[Passage], place: int) -> Motion:
    """Return the motion with each row at a passage replaced by the flank number `place`."""
    t, q, u = motion.t.copy(), motion.coordinates.copy(), motion.velocities.copy()
    for passage in passages:
        at, state = passage.is_at(motion.t), passage.flanks[place]
        t[at], q[at] = state.time, state.position
        u[at] = [state.velocities[name] for name in motion.velocity_names]
    return replace(motion, t=t, coordinates=q, velocities=u)


def _accelerations(equations: VelocityEquations, reduction: Reduction, motion: Motion) -> Array:
    variant = equations.variant
    used = [equation for equation in equations.equations if equation.name in reduction.used]
    rest = [acceleration_rest(equations, equation) for equation in used]
    sought: Array = np.zeros((len(motion.t), len(used)))
    if sought.size:
        right = compile_rows(equations, rest, 1)(motion.t, motion.coordinates, motion.velocities)
        matrix, _, _ = compile_system(equations, used).matrices(motion.t, motion.coordinates)
        sought = np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0], dtype=float)
    known = [equations.symbols.partial(symbol(rate), TIME) for rate in variant.known_rates]
    driven = compile_rows(equations, known, 0)(motion.t, motion.coordinates) if known else np.zeros((len(motion.t), 0))
    columns = {**dict(zip(equations.unknowns, sought.T, strict=True)), **dict(zip(variant.known_rates, driven.T, strict=True))}
    return np.array([columns[name] for name in motion.velocity_names]).T.reshape(len(motion.t), len(motion.velocity_names))
