"""Velocities that no single construction gives, solved from the same geometry: rigid links, guides, sleeves, given velocities.

Enters: a `Pose` and the velocities known so far.  Leaves: `Solved`, the other velocities as far as they are determined.
Used by `instant_centres.py`.  No velocity equation of the file enters, so the result is an independent check of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from coursework.drawing.check_sheet.sketch import Pose
from coursework.system.angles import dot
from coursework.system.frozen import frozen

Row = tuple[dict[int, float], float]  # one equation: coefficients by column, and the right-hand side
NOUGHT = 1e-13  # relative to the largest velocity found: smaller values are round-off
FREE = 1e-9  # relative to the largest singular value: below it a combination of velocities is not determined


@frozen
class Solved:
    """Velocities (m/s) of points and angular velocities (rad/s) of links that the geometry determines."""

    velocities: Mapping[str, complex]
    omegas: Mapping[str, float]


def solve_plan(pose: Pose, velocities: Mapping[str, complex]) -> Solved:
    """Return all velocities that rigid links, guides and sleeves determine, given the `velocities` of some points (m/s)."""
    points = dict.fromkeys([*(name for body in pose.bodies for name in body.points), *(slide.rider for slide in pose.slides)])
    turns = {body.name: 2 * len(points) + k for k, body in enumerate(pose.bodies)}
    unknowns = _Unknowns({name: 2 * k for k, name in enumerate(points)}, turns, pose.size or 1.0)
    rows = [*unknowns.given(pose, velocities), *unknowns.rigid(pose), *unknowns.sliding(pose)]
    matrix = np.zeros((len(rows), 2 * len(points) + len(turns)))
    for k, (row, _) in enumerate(rows):
        for place, value in row.items():
            matrix[k, place] += value
    _, strengths, ways = np.linalg.svd(matrix)
    rank = int(np.sum(strengths > FREE * strengths[0])) if len(strengths) else 0
    free = np.max(np.abs(ways[rank:]), axis=0, initial=0.0)
    found = np.linalg.lstsq(matrix, np.array([value for _, value in rows]), rcond=FREE)[0]
    found[np.abs(found) <= NOUGHT * np.max(np.abs(found), initial=0.0)] = 0.0
    columns = unknowns.column.items()
    determined = {name: complex(found[k], found[k + 1]) for name, k in columns if max(free[k], free[k + 1]) < FREE**0.5}
    return Solved(determined, {name: float(found[k]) / unknowns.size for name, k in turns.items() if free[k] < FREE**0.5})


@frozen
class _Unknowns:
    """Columns of the unknowns: `column` of a point's vx (m/s), vy is next to it; `turn` of a link's rate times `size` (m/s)."""

    column: Mapping[str, int]
    turn: Mapping[str, int]
    size: float

    def vector(self, name: str, along: complex, factor: float = 1.0) -> dict[int, float]:
        return {self.column[name]: factor * along.real, self.column[name] + 1: factor * along.imag}

    def given(self, pose: Pose, velocities: Mapping[str, complex]) -> Iterator[Row]:
        """Yield the equations of points: known velocities, and guides along which points move."""
        for name, velocity in velocities.items():
            if name in self.column:
                yield {self.column[name]: 1.0}, velocity.real
                yield {self.column[name] + 1: 1.0}, velocity.imag
        for name, along in pose.guided.items():
            if name in self.column:
                yield self.vector(name, 1j * along), 0.0

    def rigid(self, pose: Pose) -> Iterator[Row]:
        """Yield the equations of links: their points move as on a rigid body; guided links do not turn; known and equal rates."""
        for body in pose.bodies:
            first = body.points[0] if body.points else ""
            for name in body.points[1:]:
                arm = 1j * (pose.positions[name] - pose.positions[first])
                for axis in (1 + 0j, 1j):
                    turned = {self.turn[body.name]: -dot(axis, arm) / self.size}
                    yield {**self.vector(name, axis), **self.vector(first, axis, -1.0), **turned}, 0.0
            if body.guide:
                yield {self.turn[body.name]: 1.0}, 0.0
            if body.rate is not None and body.rate in pose.rates:
                yield {self.turn[body.name]: 1.0}, pose.rates[body.rate] * self.size
        same = {body.rate: body.name for body in reversed(pose.bodies) if body.rate}
        for body in pose.bodies:
            if body.rate and same[body.rate] != body.name:
                yield {self.turn[body.name]: 1.0, self.turn[same[body.rate]]: -1.0}, 0.0

    def sliding(self, pose: Pose) -> Iterator[Row]:
        """Yield the equations of slides: the rider stays on its bar, its speed may be driven, its block turns with the bar."""
        for slide in pose.slides:
            first = next((body.points[0] for body in pose.bodies if body.name == slide.link), slide.rider)
            arm = 1j * (pose.positions[slide.rider] - pose.positions[first])
            if first != slide.rider:
                for along, speed in ((1j * slide.along, 0.0), (slide.along, slide.speed)):
                    if speed is not None:
                        turned = {self.turn[slide.link]: -dot(along, arm) / self.size}
                        yield {**self.vector(slide.rider, along), **self.vector(first, along, -1.0), **turned}, speed
            if slide.block in self.turn:
                yield {self.turn[slide.link]: 1.0, self.turn[slide.block]: -1.0}, 0.0
