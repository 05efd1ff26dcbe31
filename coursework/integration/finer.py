"""The exact motion between its rows, by a few steps of Runge-Kutta 4 from each of them.

Enters: exact rows and rates.  Leaves: the exact motion on rows n times as close, or at one more time.  Used by the checks.
All intervals are followed at once; where that is not exact enough an interval is refined by itself.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.codegen.tabulated import OutsideTable
from coursework.integration.exact_motion import refine
from coursework.integration.motion import Motion
from coursework.integration.rates import Rates
from coursework.schemes import PRECISE

Array = NDArray[np.float64]
# Runge-Kutta steps an interval is followed by at least.
_FEWEST = 4
# What Runge-Kutta may be off at the end of an interval, as part of the range of the coordinate; the limit of a check is 0.05.
_GAP = 1e-5


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
    step, substeps = exact.step / parts, -(-_FEWEST // parts)
    t, q = exact.t[:intervals], exact.coordinates[:intervals]
    size = q.shape[1]
    latest = np.array([rates.latest(end) for end in (t + exact.step).tolist()]) if rates.breaks else np.inf

    def slopes(at: Array, position: Array) -> Array:
        return rates.table(np.minimum(at, latest), position)[0][:, :size]

    filled = np.empty((intervals, parts, size))
    with np.errstate(all="ignore"):
        for k in range(parts):
            filled[:, k] = q
            for part in range(substeps if k < parts - 1 or intervals < len(exact.t) else 0):
                q = PRECISE.step(slopes, t + (k + part / substeps) * step, q, step / substeps)
    left = np.full((intervals, size), np.inf)
    known = len(exact.coordinates[1 : intervals + 1])
    left[:known] = np.abs(q[:known] - exact.coordinates[1 : intervals + 1])
    spread = np.ptp(exact.coordinates, axis=0)
    for index in np.flatnonzero(~np.all(left <= _GAP * np.where(spread > 0, spread, 1.0), axis=1)).tolist():
        inside = times[index * parts + 1 : (index + 1) * parts]
        if len(inside):
            start = exact.coordinates[index].tolist()
            filled[index, 1 : len(inside) + 1] = refine(rates, start, np.array([t[index], *inside]))[0][1:]
    return filled


def exact_at(exact: Motion, rates: Rates, time: float) -> Array | None:
    """Return the exact row (m + k,) at any time (s) up to a step behind the last row, None where there is none."""
    index = min(int(time / exact.step * (1 + 1e-12)), len(exact.t) - 1) if exact.step else 0
    with suppress(ArithmeticError, ValueError, OutsideTable):
        begin = float(exact.t[index])
        q = exact.coordinates[index]
        if time > begin:
            q = refine(rates, q.tolist(), np.array([begin, time]))[0][-1]
        row = np.array([*q, *rates.evaluate(time, *q.tolist())[: len(exact.velocity_names)]])
        return row if np.all(np.isfinite(row)) else None
    return None
