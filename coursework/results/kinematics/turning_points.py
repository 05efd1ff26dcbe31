"""Where coordinates of the exact motion turn back, even between its rows, and the stroke between two such positions.

Enters: `Evidence` with its exact motion.  Leaves: `TurningPoint`, `Stroke`.  Used by `report/sections/verdict/conclusion.py`.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.results.checks.evidence import Evidence
from coursework.results.kinematics.strokes import dead_positions, samples_of
from coursework.system.frozen import frozen

STILL = 1e-9  # share of a period: closer times are the same
CLOSED = 1e-6  # rad or m: a motion that comes back this close has returned
MOST = 24  # largest number of turning points of one coordinate


@frozen
class TurningPoint:
    """An extreme `value` (SI) of a coordinate at `time` (s); `row` holds all coordinates there."""

    time: float
    value: float
    row: tuple[float, ...]


@frozen
class Stroke:
    """One coordinate back and forth in a turn of the crank.

    The longer way, from `begin` to `end`, takes `slow` seconds and the crank angle `slow_angle` (rad); the way back takes `fast`
    and `fast_angle`.
    """

    begin: TurningPoint
    end: TurningPoint
    slow: float
    fast: float
    slow_angle: float
    fast_angle: float

    @property
    def length(self) -> float:
        """Return the stroke (m) or the angle of swing (rad)."""
        return abs(self.end.value - self.begin.value)

    @property
    def ratio(self) -> float:
        """Return the time of the slow way divided by that of the fast one."""
        return self.slow / self.fast


def turning_points(evidence: Evidence, name: str, rate: str) -> tuple[TurningPoint, ...] | None:
    """Return the turning points of a coordinate in the first period, or in the run if that is shorter.

    None if there are too many, or if the motion between the rows is unknown.
    """
    exact = evidence.exact
    if name not in exact.coordinate_names or rate not in exact.velocity_names or len(exact.t) < 3:
        return None
    rows = f"of {len(exact.t)} rows each {exact.step!r} s"
    return evidence.once(f"turning points of {name} {rows}", lambda: _turning_points(evidence, exact, name, rate, rows))


def _turning_points(evidence: Evidence, exact: Motion, name: str, rate: str, of: str) -> tuple[TurningPoint, ...] | None:
    last, place = _last(evidence), exact.coordinate_names.index(name)
    if not np.any(exact.column(rate)[: last + 1]):
        return ()
    whole = evidence.rates.motion(exact.t[: last + 1], exact.coordinates[: last + 1], exact.scheme, exact.step)
    samples = evidence.once(f"close samples {of}", lambda: samples_of(whole, evidence.rates))
    found = dead_positions(whole, evidence.rates, rate, samples)
    if found is None or len(found.t) > MOST:
        return None
    rows = zip(found.t.tolist(), found.coordinates.tolist(), strict=True)
    # The search reaches a little beyond both ends, for a start in a dead position; what it finds there is dropped.
    begin, end = float(exact.t[0]), float(exact.t[last])
    points = tuple(TurningPoint(time, row[place], tuple(row)) for time, row in rows if begin <= time <= end)
    closes = abs(exact.t[last] - evidence.period) < STILL * evidence.period
    both = points and points[-1].time - points[0].time > evidence.period - STILL * evidence.period
    return points[:-1] if closes and both else points  # the end of a period is its beginning


def _last(evidence: Evidence) -> int:
    """Return the row at which the first period ends, or the last row if the run is shorter."""
    exact = evidence.exact
    return min(round(evidence.period / exact.step), len(exact.t) - 1)


def stroke(evidence: Evidence, name: str, rate: str, crank: str) -> Stroke | None:
    """Return the stroke of a coordinate; None unless the crank makes one turn a period and the coordinate turns back twice in it.

    `crank` is the angle of the only driven link.
    """
    exact, points = evidence.exact, turning_points(evidence, name, rate)
    if points is None or len(points) != 2 or crank not in exact.coordinate_names:
        return None
    last, turned = _last(evidence), exact.coordinate_names.index(crank)
    angles, own = exact.column(crank)[: last + 1], exact.column(name)[: last + 1]
    turn = float(angles[-1] - angles[0])
    goes_one_way = np.all(np.diff(angles) * math.copysign(1.0, turn) > 0)
    if abs(abs(turn) - 2 * math.pi) > CLOSED or abs(own[-1] - own[0]) > CLOSED or not goes_one_way:
        return None
    first, second = points
    there, whole = second.time - first.time, float(exact.t[last])
    angle = abs(second.row[turned] - first.row[turned])
    if 2 * there >= whole:
        return Stroke(first, second, there, whole - there, angle, 2 * math.pi - angle)
    return Stroke(second, first, whole - there, there, 2 * math.pi - angle, angle)
