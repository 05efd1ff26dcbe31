"""Velocities that no single construction gives, solved from the same geometry: rigid links, guides, sleeves, given velocities.

Enters: a `Pose` and what is known so far.  Leaves: what is determined of the rest.
Used by `instant_centres.py`.  No velocity equation of the file enters: it stays a check of them.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from coursework.drawing.check_sheet.pose import Pose
from coursework.system.angles import dot
from coursework.system.frozen import frozen

NOUGHT = 1e-13  # of the largest velocity found: what is smaller is round-off
FREE = 1e-9  # of the largest singular value: below it a combination of velocities is not determined


@frozen
class Solved:
    """Velocities (m/s) of points and angular velocities (rad/s) of links that the geometry determines."""

    velocities: Mapping[str, complex]
    omegas: Mapping[str, float]


def solve_plan(pose: Pose, velocities: Mapping[str, complex]) -> Solved:
    """Return all that rigid links, guides and sleeves determine, given velocities of points (m/s)."""
    points = list(dict.fromkeys(name for body in pose.bodies for name in body.points))
    points += [slide.rider for slide in pose.slides if slide.rider not in points]
    column = {name: 2 * k for k, name in enumerate(points)}
    turn = {body.name: 2 * len(points) + k for k, body in enumerate(pose.bodies)}
    size = pose.size or 1.0
    rows: list[dict[int, float]] = []
    right: list[float] = []

    def require(row: dict[int, float], value: float = 0.0) -> None:
        rows.append(row)
        right.append(value)

    def vector(name: str, along: complex, factor: float = 1.0) -> dict[int, float]:
        return {column[name]: factor * along.real, column[name] + 1: factor * along.imag}

    for name, velocity in velocities.items():
        if name in column:
            require({column[name]: 1.0}, velocity.real)
            require({column[name] + 1: 1.0}, velocity.imag)
    for name, along in pose.guided.items():
        if name in column:
            require(vector(name, 1j * along))
    for body in pose.bodies:
        first = body.points[0] if body.points else ""
        for name in body.points[1:]:
            arm = 1j * (pose.positions[name] - pose.positions[first])
            for axis in (1 + 0j, 1j):
                part = dot(axis, arm)
                require({**vector(name, axis), **vector(first, axis, -1.0), turn[body.name]: -part / size})
        if body.guide:
            require({turn[body.name]: 1.0})
        if body.rate is not None and body.rate in pose.rates:
            require({turn[body.name]: 1.0}, pose.rates[body.rate] * size)
    same = {body.rate: body.name for body in reversed(pose.bodies) if body.rate}
    for body in pose.bodies:
        if body.rate and same[body.rate] != body.name:
            require({turn[body.name]: 1.0, turn[same[body.rate]]: -1.0})
    for slide in pose.slides:
        first = next((body.points[0] for body in pose.bodies if body.name == slide.link), slide.rider)
        arm = 1j * (pose.positions[slide.rider] - pose.positions[first])
        normal = 1j * slide.along
        if first != slide.rider:
            part = dot(normal, arm)
            require({**vector(first, normal), **vector(slide.rider, normal, -1.0), turn[slide.link]: part / size})
        if slide.speed is not None and first != slide.rider:
            part = dot(slide.along, arm)
            row = {**vector(slide.rider, slide.along), **vector(first, slide.along, -1.0), turn[slide.link]: -part / size}
            require(row, slide.speed)
        if slide.block in turn:
            require({turn[slide.link]: 1.0, turn[slide.block]: -1.0})
    count = 2 * len(points) + len(pose.bodies)
    matrix = np.zeros((len(rows), count))
    for k, row in enumerate(rows):
        for place, value in row.items():
            matrix[k, place] += value
    _, strengths, ways = np.linalg.svd(matrix)
    rank = int(np.sum(strengths > FREE * strengths[0])) if len(strengths) else 0
    free = np.max(np.abs(ways[rank:]), axis=0, initial=0.0)
    found = np.linalg.lstsq(matrix, np.array(right), rcond=FREE)[0]
    found[np.abs(found) <= NOUGHT * np.max(np.abs(found), initial=0.0)] = 0.0
    determined = {name: complex(found[k], found[k + 1]) for name, k in column.items() if max(free[k], free[k + 1]) < FREE**0.5}
    return Solved(determined, {name: float(found[k]) / size for name, k in turn.items() if free[k] < FREE**0.5})
