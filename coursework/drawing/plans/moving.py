"""The motion of every point of an outline and of the links that it draws, over all rows of a motion.

Enters: an `Outline`, velocity equations, a motion and its accelerations.  Leaves: `Kinematics`.
Used by `plans.py`, `polygons.py`, `vectors.py` and `check_plan.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np

from coursework.drawing.outline.outline import Bar, Outline
from coursework.drawing.outline.poses import drawn_vectors
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.time_derivatives import jets
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen


@frozen
class Moving:
    """The motion of a point: position, velocity, acceleration, each (n,) complex."""

    at: Complex
    velocity: Complex
    acceleration: Complex


@frozen
class Kinematics:
    """The motion of every point, and angular velocity and acceleration of every link, by name, (n,) at times `t` (s).

    `driven` gives, for (link, rider) of a driven length, the sliding velocity and its derivative as vectors along the link.
    """

    t: Array
    points: dict[str, Moving]
    turning: Mapping[str, tuple[Array, Array]]
    driven: Mapping[tuple[str, str], tuple[Complex, Complex]] = field(default_factory=dict)

    def carried(self, bar: Bar, base: str, at: Complex) -> Moving:
        """Return the motion of the point of a link that lies at `at` (n,), from that of its point `base`."""
        omega, epsilon = self.turning[bar.link]
        moving = self.points[base]
        arm = at - moving.at
        return Moving(at, moving.velocity + 1j * omega * arm, moving.acceleration + (1j * epsilon - omega * omega) * arm)


def kinematics_of(outline: Outline, equations: VelocityEquations, motion: Motion, accelerations: Array) -> Kinematics:
    """Return the motion of all points and links in every row; `accelerations` (n, k) belong to the motion's velocities."""
    symbols = equations.symbols
    vectors = drawn_vectors(outline, symbols)
    wanted = [component for vector in vectors for component in vector]
    levels = [level(motion.t, motion.coordinates, motion.velocities, accelerations) for level in jets(equations, wanted, 2)]
    points = {
        name: Moving(*(np.asarray(level[:, 2 * k] + 1j * level[:, 2 * k + 1]) for level in levels))
        for k, (name, _) in enumerate(outline.points)
    }
    turning = {bar.link: _turning(bar, outline, points, motion, accelerations) for bar in outline.bars}
    return Kinematics(motion.t, points, turning)


def _turning(
    bar: Bar, outline: Outline, points: Mapping[str, Moving], motion: Motion, accelerations: Array
) -> tuple[Array, Array]:  # fmt: skip
    """Return angular velocity and acceleration (n,) of a link: from its column, else from its slot or two of its points."""
    if bar.rate in motion.velocity_names:
        place = motion.velocity_names.index(bar.rate)
        return motion.velocities[:, place], accelerations[:, place]
    ways = [(slot.base, slot.toward) for slot in outline.slots if slot.link == bar.link]
    ways += [(bar.corners[0], bar.corners[1])] if len(bar.corners) > 1 else []
    ways += [(block.base, block.toward) for block in outline.blocks if block.link == bar.link and block.open]
    if not ways:
        return np.zeros(len(motion.t)), np.zeros(len(motion.t))
    a, b = (points[name] for name in ways[0])
    arm = b.at - a.at
    square = np.abs(arm) ** 2
    rate = (arm.conjugate() * (b.velocity - a.velocity)).imag / square
    return rate, (arm.conjugate() * (b.acceleration - a.acceleration)).imag / square
