"""The exact motion between its rows, by a few steps of Runge-Kutta 4 from each of them, and behind its last row.

Enters: exact rows and rates.  Leaves: the exact motion on rows n times as close, at one more time, or for longer.
Used by the checks.
All intervals are followed at once, with a cubic between the steps; where that is not exact enough one is refined by itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.geometry.drive import resolution
from coursework.motion.integration.exact_motion import MOST_STEPS, OutOfReach, refine
from coursework.motion.integration.hermite import hermite
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import PRECISE
from coursework.system.arrays import Array

# Runge-Kutta steps an interval is followed by at least.
_FEWEST = 2
# What Runge-Kutta may be off at the end of an interval, as part of the range of the coordinate; the limit of a check is 0.05.
_GAP = 1e-5
_SUDDEN = 2  # a stretch of the drive in which it needs such a part of a step
# What the precise scheme may be off behind the last row (rad or m): beyond that the motion meets something it cannot pass.
_LOST = 1e-7


def finer(exact: Motion, rates: Rates, parts: int, rows: int) -> Motion | None:
    """Return the first `rows` rows of the exact motion with a step of 1/`parts`, None where it cannot be followed so far."""
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
    """Return the positions (intervals, parts, m) from each exact row on."""
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
    # What a drive does and undoes between two steps leaves no gap at their end.
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
    """Return the positions (intervals, k, m) at places (k,) counted in steps: the cubic through both ends of a step.

    `positions` and what their slopes move in a step, `moved`: (steps + 1, intervals, m).  A cubic is off by 1/384 of the step
    to the fourth power: where Runge-Kutta is off by what it may be, not more than that.
    """
    index = places.astype(int)
    share = (places - index)[:, None, None]
    found = hermite(positions[index], positions[index + 1], moved[index], moved[index + 1], share)
    return np.asarray(np.moveaxis(found, 0, 1))


def exact_at(exact: Motion, rates: Rates, time: float) -> Array | None:
    """Return the exact row (m + k,) at any time (s) up to a step off the first and the last row, None where there is none."""
    found = _known_at(exact, rates, time)
    return None if found is None else found[: len(exact.names)]


def at_times(exact: Motion, rates: Rates, times: Sequence[float]) -> Motion | None:
    """Return the exact motion at growing `times` (s), rows and any moments between; None where it cannot be followed there."""
    rows = [row for time in times if (row := _known_at(exact, rates, time)) is not None]
    if len(rows) < len(times):
        return None
    size, every = len(rates.coordinates), len(rates.coordinates) + len(rates.velocities)
    listed = np.array(rows).reshape(len(rows), every + len(rates.blocks))
    known = listed[:, size:every].copy(), listed[:, every:].copy()
    return rates.motion(np.array(times), listed[:, :size].copy(), exact.scheme, exact.step, known=known)


def _known_at(exact: Motion, rates: Rates, time: float) -> Array | None:
    """Return coordinates, velocities and determinants of the exact motion at a time (s), None where there are none."""
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
    """Return the exact motion with its rows going on up to one at `time` (s), None where it cannot be followed so far.

    It cannot beyond a table over t, nor past a row where a determinant has another sign than in the last one known.
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
