"""The smallest and the largest value of every column of the exact motion over a run, including between rows.

Enters: the exact motion, its rates, the accelerations of any rows.  Leaves: (low, high) by column.
Used by `way_to_motion.py`.

Close samples show where a column is largest.  The slopes at the three samples around it give the time of zero slope with an error
of the third power of their spacing; the column is flat there, so its exact value at that time has an error of the sixth power.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from coursework.motion.integration.finer import exact_at
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.integration.turning import closer
from coursework.system.arrays import Array

Range = tuple[float, float]


def extremes(exact: Motion, rates: Rates, accelerations: Callable[[Motion], Array]) -> dict[str, Range]:
    """Return (low, high) of every column over the run; `accelerations` gives the derivatives (n, k) of a motion's velocities."""
    if not len(exact.t):
        return {}
    samples = closer(exact, rates)
    slopes = np.concatenate([samples.velocities[:, : len(exact.coordinate_names)], accelerations(samples)], axis=1)
    found: dict[str, Range] = {}
    for column, name in enumerate(exact.names):
        values, slope = samples.rows[:, column], slopes[:, column]
        ends = []
        for seen in (int(np.argmin(values)), int(np.argmax(values))):
            ends.append(float(values[seen]))
            if 0 < seen < len(values) - 1:
                row = exact_at(exact, rates, _flat(samples.t[seen - 1 : seen + 2], slope[seen - 1 : seen + 2]))
                ends += [float(row[column])] if row is not None else []
        found[name] = (min(ends), max(ends))
    return found


def _flat(t: Array, slopes: Array) -> float:
    """Return the time (s) at which the parabola through the slopes of three samples is zero; the middle one if there is none."""
    first, middle, last = t.tolist()
    before, here, after = slopes.tolist()
    unit = last - middle
    back = (first - middle) / unit
    square = (after - here - (before - here) / back) / (1.0 - back)
    linear = after - here - square
    under = linear * linear - 4 * square * here
    if under < 0:
        return float(middle)
    far = -(linear + math.copysign(math.sqrt(under), linear)) / 2  # this form of the root subtracts no two similar numbers
    roots = [top / bottom for top, bottom in ((far, square), (here, far)) if bottom]
    return float(middle + unit * min((root for root in roots if back <= root <= 1), key=abs, default=0.0))
