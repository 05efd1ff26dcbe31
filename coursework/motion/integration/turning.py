"""The times at which a column of the exact motion turns back, found in continuous time and not read off the rows;
and its smallest and largest value over a run.

Enters: the exact motion, its rates, the slope of a column.  Leaves: times (s), and closer samples.
Used by `strokes.py` and `way_to_motion.py`.

Samples of a closer exact motion bracket each change of sign.  The slope at a time between them comes from the exact motion
followed from the row before, so that a root has the accuracy of the exact rows, not of the step.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from coursework.motion.integration.crossing import crossing
from coursework.motion.integration.finer import at_times, exact_at, finer
from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.system.arrays import Array

Slope = Callable[[Motion], Array]
# Number of samples of a run that bracket the roots, and the largest number of parts of a step for them.
_SAMPLES, _MOST_PARTS = 2000, 16
# A slope below this share of its largest size counts as zero: round-off at a dead position, or of a drive at rest.
STANDS = 1e-11
# A root is located to this share of the time between two samples.
_SETTLED = 1e-13


def closer(exact: Motion, rates: Rates) -> Motion:
    """Return the exact motion with rows close enough to bracket what lies between the rows of `exact`."""
    parts = min(_MOST_PARTS, -(-_SAMPLES // len(exact.t)))
    rows = (len(exact.t) - 1) * parts + 1
    return (finer(exact, rates, parts, rows) if parts > 1 else None) or exact


def stands(slopes: Array) -> NDArray[np.bool_]:
    """Return at which samples (n,) a slope counts as zero."""
    return np.asarray(np.abs(slopes) <= STANDS * np.max(np.abs(slopes), initial=0.0))


def turns(slopes: Array) -> list[tuple[int, int]]:
    """Return the pairs of samples between which a slope (n,) changes its sign; samples that count as zero are skipped."""
    signed = np.flatnonzero(~stands(slopes))
    changes = np.flatnonzero(np.diff(np.sign(slopes[signed])))
    return [(int(signed[place]), int(signed[place + 1])) for place in changes]


def root(exact: Motion, rates: Rates, slope: Slope, bracket: tuple[float, float]) -> float | None:
    """Return the time (s) in a bracket at which a slope of the exact motion is zero; None if it cannot be followed there."""
    low, high = bracket
    begin = at_times(exact, rates, [low])
    if begin is None:
        return None

    def value(time: float) -> float:
        motion = at_times(begin, rates, [time])  # from `begin` the way is shorter than from the row before
        return math.nan if motion is None else float(slope(motion)[0])

    ends = float(slope(begin)[0]), value(high)
    return crossing(value, bracket, ends, _SETTLED) if ends[0] * ends[1] <= 0 else None


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
