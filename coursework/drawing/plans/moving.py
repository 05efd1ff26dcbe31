"""How every point of an outline and of the links it draws moves, over all rows of a motion.

Enters: an `Outline`, velocity equations, a motion and its accelerations.  Leaves: `Kinematics`.
Used by `polygons.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.outline import Bar, Outline
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.time_derivatives import jets
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True, slots=True)
class Moving:
    """The motion of one point or of a point of a link: place, velocity, acceleration, each (n,)."""

    at: Complex
    velocity: Complex
    acceleration: Complex


class Kinematics:
    """The motion of every point of an outline and of the links it draws; arrays over the rows of a motion."""

    def __init__(self, outline: Outline, equations: VelocityEquations, motion: Motion, accelerations: Array) -> None:
        symbols = equations.symbols
        self.outline, self.motion, self.accelerations = outline, motion, accelerations
        self.t = motion.t
        vectors = [symbols.vectors.get(name) or symbols.vector(formula) for name, formula in outline.points]
        wanted = [component for vector in vectors for component in vector]
        rows = (motion.t, motion.coordinates, motion.velocities, accelerations)
        levels = [level(*rows) for level in jets(equations, wanted, 2)]
        self.points = {
            name: Moving(*(np.asarray(level[:, 2 * k] + 1j * level[:, 2 * k + 1]) for level in levels))
            for k, (name, _) in enumerate(outline.points)
        }

    def turning(self, bar: Bar) -> tuple[Array, Array]:
        """Return angular velocity and acceleration (n,) of a link: its column, else how its slot or two of its points turn."""
        if bar.rate in self.motion.velocity_names:
            place = self.motion.velocity_names.index(bar.rate)
            return self.motion.velocities[:, place], self.accelerations[:, place]
        ends = next(((slot.base, slot.toward) for slot in self.outline.slots if slot.link == bar.link), bar.corners[:2])
        if len(ends) < 2:
            return np.zeros(len(self.t)), np.zeros(len(self.t))
        a, b = (self.points[name] for name in ends)
        arm = b.at - a.at
        square = np.abs(arm) ** 2
        rate = (arm.conjugate() * (b.velocity - a.velocity)).imag / square
        return rate, (arm.conjugate() * (b.acceleration - a.acceleration)).imag / square

    def carried(self, bar: Bar, base: str, at: Complex) -> Moving:
        """Return the motion of the point of a link that lies at a place, from that of its point `base`."""
        omega, epsilon = self.turning(bar)
        moving = self.points[base]
        arm = at - moving.at
        return Moving(at, moving.velocity + 1j * omega * arm, moving.acceleration + (1j * epsilon - omega * omega) * arm)
