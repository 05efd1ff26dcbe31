"""Where coordinates of the exact motion turn back, between its rows, and the stroke between two such positions.

Enters: `Evidence` with its exact motion.  Leaves: `TurningPoint`, `Stroke`.  Used by `report/sections/conclusion.py`.
A coordinate turns back where its rate changes sign; the moment is sought on the exact motion until the next double.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursework.motion.integration.finer import exact_at
from coursework.results.checks.evidence import Evidence

STILL = 1e-9  # of its largest size: a smaller rate is none
CLOSED = 1e-6  # rad or m: a motion that returns so near has returned
MOST = 24  # turning points of one coordinate that are sought
_TRIALS = 60


@dataclass(frozen=True, slots=True)
class TurningPoint:
    """At `time` (s) a coordinate has its extreme `value` (SI); `row` holds all coordinates there."""

    time: float
    value: float
    row: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Stroke:
    """One coordinate to and fro in a turn of the crank: `slow` seconds and crank `slow_angle` (rad) for the longer way, from
    `begin` to `end`, and `fast`, `fast_angle` for the way back.
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
        """Return the slow way's time by the fast one's."""
        return self.slow / self.fast


def turning_points(evidence: Evidence, name: str, rate: str) -> tuple[TurningPoint, ...] | None:
    """Return the turning points of a coordinate in the first period, or in the run where it is shorter.

    None where they are too many, or the motion between the rows is not known.
    """
    exact = evidence.exact
    if exact is None or name not in exact.coordinate_names or rate not in exact.velocity_names or len(exact.t) < 3:
        return None
    place, speed = exact.coordinate_names.index(name), exact.velocity_names.index(rate)
    last = _last(evidence)
    rates = exact.velocities[: last + 1, speed]
    signs = np.where(np.abs(rates) > STILL * np.max(np.abs(rates)), np.sign(rates), 0.0)
    closes = abs(exact.t[last] - evidence.period) < STILL * evidence.period
    times: list[tuple[float, float] | float] = []
    for row in range(last):
        before = signs[row - 1] if row else (signs[last - 1] if closes else 0.0)
        if signs[row] == 0 and before * signs[row + 1] < 0:
            times.append(float(exact.t[row]))
        elif signs[row] * signs[row + 1] < 0:
            times.append((float(exact.t[row]), float(exact.t[row + 1])))
    found = [_at(evidence, time, place, speed) for time in times] if len(times) <= MOST else [None]
    known = tuple(point for point in found if point is not None)
    return known if len(known) == len(found) else None


def _last(evidence: Evidence) -> int:
    """Return the row at which the first period ends, the last one where the run is shorter."""
    exact = evidence.exact
    assert exact is not None
    return min(round(evidence.period / exact.step), len(exact.t) - 1)


def _at(evidence: Evidence, time: tuple[float, float] | float, place: int, speed: int) -> TurningPoint | None:
    """Return the turning point at a time, or between two, by the rule of false position with halved ends (Illinois)."""
    exact = evidence.exact
    assert exact is not None
    many = len(exact.coordinate_names)

    def row_at(moment: float) -> tuple[float, ...] | None:
        row = exact_at(exact, evidence.rates, moment)
        return None if row is None else tuple(map(float, row))

    if isinstance(time, float):
        row = row_at(time)
        return None if row is None else TurningPoint(time, row[place], row[:many])
    (begin, end), kept = time, 0
    first, second = row_at(begin), row_at(end)
    if first is None or second is None:
        return None
    low, high = first[many + speed], second[many + speed]
    size, row, moment = abs(low) + abs(high), first, begin
    for _ in range(_TRIALS):
        moment = (begin * high - end * low) / (high - low)
        tried = row_at(moment)
        if tried is None:
            return None
        row, value = tried, tried[many + speed]
        if abs(value) < STILL * STILL * size or math.nextafter(begin, end) >= end:
            break
        if value * low > 0:
            begin, low = moment, value
            high, kept = (high / 2 if kept < 0 else high), -1
        else:
            end, high = moment, value
            low, kept = (low / 2 if kept > 0 else low), 1
    return TurningPoint(moment, row[place], row[:many])


def stroke(evidence: Evidence, name: str, rate: str, crank: str) -> Stroke | None:
    """Return the stroke of a coordinate; None unless the crank makes one whole turn a period and it turns back twice in it.

    `crank` is the angle of the only driven link.
    """
    exact, points = evidence.exact, turning_points(evidence, name, rate)
    if exact is None or points is None or len(points) != 2 or crank not in exact.coordinate_names:
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
