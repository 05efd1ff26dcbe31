"""The drives of the mechanism without any reaction: from the power of all forces in the motion that each drive alone would make.

Enters: `Rows`, equations.  Leaves: the driving couples and forces (n, drives).  Computed on request only.
Used by `analysis.py`.

A u + B v = 0 gives the velocities u for a unit of each drive v; for each, sum F V + M w + F_d = 0 (Zhukovsky's lever is the
same sum, drawn).  A and B come from the geometry, because written equations may have dropped a drive that is 0.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from coursework.effects.force_scheme import drives_of
from coursework.effects.rows import Rows
from coursework.equations.algebra.calculus import derivative
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import symbol
from coursework.motion.geometry.judging.agreement import given_by_geometry
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.system.arrays import Array


def unit_motions(rows: Rows, equations: VelocityEquations) -> Array | None:
    """Return the velocities (n, names, drives) of unknowns and driven rates for a unit of each drive.

    The names are `equations.unknowns`, then the driven rates; None if the geometry does not give all velocities.
    """
    drives, names = [one.is_drive for one in drives_of(rows.scheme)], equations.unknowns
    own, motion = given_by_geometry(equations), rows.motion
    if len(own) < len(names) or not drives:
        return None
    wanted: list[Expression] = []
    for one in own:
        wanted += [one.coefficients.get(name, symbol("t") * 0) for name in names]
        wanted += [derivative(one.right_side, symbol(drive)) for drive in drives]
    found = compile_rows(equations, wanted, 0)(motion.t, motion.coordinates)
    found = found.reshape(rows.count, len(own), len(names) + len(drives))
    matrix, right = found[..., : len(names)], found[..., len(names) :]
    known = [[float(drive == rate) for drive in drives] for rate in equations.variant.known_rates]
    driven = np.broadcast_to(np.array(known, dtype=float).reshape(len(known), len(drives)), (rows.count, len(known), len(drives)))
    if len(own) == len(names):
        try:
            return np.concatenate([np.linalg.solve(matrix, right), driven], axis=1)
        except np.linalg.LinAlgError:
            return None
    if np.linalg.matrix_rank(matrix).min(initial=len(names)) < len(names):
        return None
    return np.concatenate([np.linalg.pinv(matrix) @ right, driven], axis=1)


def twists(rows: Rows, equations: VelocityEquations, velocities: Array) -> Array:
    """Return the velocity of each body's centre and its rate (n, bodies, 3, k) for velocities (n, names, k)."""
    names = [*equations.unknowns, *equations.variant.known_rates]
    place = {name: velocities[:, index] for index, name in enumerate(names)}
    moved = [(c.name, place[c.rate]) for c in equations.variant.coordinates]
    found = np.zeros((rows.count, len(rows.scheme.bodies), 3, velocities.shape[-1]))
    for index, body in enumerate(rows.scheme.bodies):
        way: Any = sum(rows.slopes[body.name, name][:, None] * rate for name, rate in moved)
        found[:, index, 0], found[:, index, 1] = np.real(way), np.imag(way)
        turned = (rows.turned_by(body, name)[:, None] * rate for name, rate in moved)
        found[:, index, 2] = place[body.rate] if body.rate else sum(turned)
    return found


def drive_by_power(rows: Rows, equations: VelocityEquations, wrench: Array) -> Array | None:
    """Return the drives (n, drives) needed against wrenches (n, bodies, 3); None if the geometry does not determine them."""
    velocities = unit_motions(rows, equations)
    if velocities is None:
        return None
    moves = twists(rows, equations, velocities)
    needed = -np.einsum("nbi,nbik->nk", wrench, moves)
    return np.asarray(np.linalg.solve(_shares(rows, moves), needed[..., None])[..., 0])


def _shares(rows: Rows, moves: Array) -> Array:
    """Return the power (n, k, drives) of a unit of each driving force in each unit motion.

    A couple has the power of the rotation of its link relative to the link it stands on.
    """
    drives = drives_of(rows.scheme)
    found = np.tile(np.eye(len(drives)), (rows.count, 1, 1))
    places = {body.name: index for index, body in enumerate(rows.scheme.bodies)}
    for column, drive in enumerate(drives):
        if drive.direction.kind == "couple":
            below = moves[:, places[drive.off], 2] if drive.off in places else 0.0
            found[:, :, column] = moves[:, places[drive.on], 2] - below
    return found
