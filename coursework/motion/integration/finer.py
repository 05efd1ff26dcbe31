"""The exact motion between its rows, by a few Runge-Kutta 4 steps from each row, and after its last row.

Enters: exact rows and rates.  Leaves: the exact motion on rows n times as close, at one more time, or for longer.
Used by the checks.
All intervals are followed at once, with a cubic between the steps; an interval where this is too inexact is refined by itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.drives.drive import resolution
from coursework.motion.integration.exact_motion import MOST_STEPS, OutOfReach, refine
from coursework.motion.integration.hermite import hermite
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import PRECISE
from coursework.system.arrays import Array

# Smallest number of Runge-Kutta steps in an interval.
_FEWEST = 2
# Largest error of Runge-Kutta at the end of an interval, as a share of the coordinate's range; the limit of a check is 0.05.
_GAP = 1e-5
_SUDDEN = 2  # a stretch of the drive shorter than 1/_SUDDEN of a step is refined
# Largest error of the precise scheme after the last row (rad or sizes): with more the motion meets something it cannot pass.
_LOST = 1e-7


def finer(exact: Motion, rates: Rates, parts: int, rows: int) -> Motion | None:
    """Return the first `rows` rows of the exact motion at 1/`parts` of its step, None if it cannot be followed so far."""
    intervals = -(-(rows - 1) // parts)
    if rows < 1 or intervals > len(exact.t):
        return None
    step = exact.step / parts
    times = np.arange(rows).astype(np.float64) * step
    try:
        filled = _followed(exact, rates, parts, intervals, times)
        positions = np.concatenate([filled.reshape(-1, filled.shape[2]), exact.coordinates[intervals : intervals + 1]])[:rows]
        velocities, determinants = rates.table(times, positions)
    except (ArithmeticError, ValueError, OutsideTable):
        return None
    if not (len(positions) == rows and np.all(np.isfinite(positions)) and np.all(np.isfinite(velocities))):
        return None
    bare = np.zeros((rows, 0))
    return replace(
        exact, t=times, coordinates=positions, velocities=velocities, determinants=determinants, scaled=bare, step=step,
    )  # fmt: skip


def _followed(exact: Motion, rates: Rates, parts: int, intervals: int, times: Array) -> Array:
    """Return the positions (intervals, parts, m) within each interval, starting with its exact row."""
    steps = parts * -(-_FEWEST // parts) if parts < _FEWEST else _FEWEST
    length = exact.step / steps
    t, q = exact.t[:intervals], exact.coordinates[:intervals]
    size = q.shape[1]
    slopes = rates.slopes_of_rows(t + exact.step)
    positions, rising = np.empty((2, steps + 1, intervals, size))
    with np.errstate(all="ignore"):
        for index in range(steps + 1):
            positions[index] = q
            rising[index] = slopes(t + index * length, q)
            if index < steps:
                q = PRECISE.step(slopes, t + index * length, q, length, rising[index])
        filled = _between(positions, length * rising, np.arange(parts) * steps / parts)
    left = np.full((intervals, size), np.inf)
    known = len(exact.coordinates[1 : intervals + 1])
    left[:known] = np.abs(q[:known] - exact.coordinates[1 : intervals + 1])
    spread = np.ptp(exact.coordinates, axis=0)
    most = MOST_STEPS
    near = np.all(left <= _GAP * np.where(spread > 0, spread, 1.0), axis=1)
    # A change of the drive that is undone within a step leaves no error at the step's end.
    sudden, _ = resolution(rates.equations, float(times[-1])).shorter(length / _SUDDEN)
    near &= np.diff(np.searchsorted(sudden, np.append(t, t[-1:] + exact.step))) == 0
    for row in np.flatnonzero(~near).tolist():
        inside = times[row * parts + 1 : (row + 1) * parts]
        if len(inside):
            start = exact.coordinates[row].tolist()
            found, _, taken = refine(rates, start, np.array([t[row], *inside]), most)
            filled[row, 1 : len(inside) + 1] = found[1:]
            most -= taken
            if most < 0:
                raise OutOfReach
    return filled


def _between(positions: Array, moved: Array, places: Array) -> Array:
    """Return the positions (intervals, k, m) at `places` (k,), counted in steps, from a cubic through the ends of each step.

    `positions` and `moved`, the slopes times the step length, have the shape (steps + 1, intervals, m).  A cubic errs by 1/384 of
    the step to the fourth power: not more than Runge-Kutta may.
    """
    index = places.astype(int)
    share = (places - index)[:, None, None]
    found = hermite(positions[index], positions[index + 1], moved[index], moved[index + 1], share)
    return np.asarray(np.moveaxis(found, 0, 1))


def exact_at(exact: Motion, rates: Rates, time: float) -> Array | None:
    """Return the exact row (m + k,) at a time (s) up to a step outside the rows, None if it cannot be computed."""
    found = _known_at(exact, rates, time)
    return None if found is None else found[: len(exact.names)]


def at_times(exact: Motion, rates: Rates, times: Sequence[float]) -> Motion | None:
    """Return the exact motion at growing `times` (s), at or between rows; None if it cannot be followed there."""
    rows = [row for time in times if (row := _known_at(exact, rates, time)) is not None]
    if len(rows) < len(times):
        return None
    size, every = len(rates.coordinates), len(rates.coordinates) + len(rates.velocities)
    listed = np.array(rows).reshape(len(rows), every + len(rates.blocks))
    known = listed[:, size:every].copy(), listed[:, every:].copy()
    return rates.motion(np.array(times), listed[:, :size].copy(), exact.scheme, exact.step, known=known)


def _known_at(exact: Motion, rates: Rates, time: float) -> Array | None:
    """Return coordinates, velocities and determinants of the exact motion at a time (s), None if they cannot be computed."""
    index = min(int(time / exact.step * (1 + 1e-12)), len(exact.t) - 1) if exact.step else 0
    with suppress(ArithmeticError, ValueError, OutsideTable):
        begin = float(exact.t[index])
        q = exact.coordinates[index]
        if time != begin:
            q = refine(rates, q.tolist(), np.array([begin, time]))[0][-1]
        row = np.array([*q.tolist(), *rates.evaluate(time, *q.tolist())])
        return row if np.isfinite(row[: len(exact.names)]).all() else None
    return None


def prolonged(exact: Motion, rates: Rates, time: float) -> Motion | None:
    """Return the exact motion continued with its step up to a row at `time` (s), None if it cannot be followed so far.

    This fails beyond the end of a table over t, and where a determinant differs in sign from the last known row.
    """
    begin, step = float(exact.t[-1]), exact.step
    grid = begin + step * np.arange(1, int((time - begin) / step * (1 + 1e-12)) + 1)
    times = np.append(grid[grid < time * (1 - 1e-12)], time)
    with suppress(ArithmeticError, ValueError, OutsideTable):
        positions, gap, _ = refine(rates, exact.coordinates[-1].tolist(), np.append(begin, times))
        velocities, determinants = rates.table(times, positions[1:])
        same = np.all(np.sign(determinants) == np.sign(exact.determinants[-1]))
        if gap <= _LOST and same and np.all(np.isfinite(positions)) and np.all(np.isfinite(velocities)):
            rows = len(exact.t) + len(times)
            return replace(
                exact, t=np.append(exact.t, times), coordinates=np.vstack([exact.coordinates, positions[1:]]),
                velocities=np.vstack([exact.velocities, velocities]), scaled=np.zeros((rows, 0)),
                determinants=np.vstack([exact.determinants, determinants]),
            )  # fmt: skip
    return None
