"""Whether the true motion of many data sets is sure to reach its end: all are followed at once, with every determinant watched.

Enters: a `Model`, the numbers of the sets, where they begin.  Leaves: (n,) True where no dead or change point can have been
missed.  Used by `sets.py`; sets that are not sure are searched one by one.

The motion is followed by Runge-Kutta steps, and the determinants are evaluated at their ends and middles.  A set is sure if every
determinant keeps a distance from zero that is larger than its possible dip between two looks (its second difference; a
parabola dips an eighth of it) plus its change by the error of the positions (the defect of the cubic through both
ends of a step, measured in its middle and added up: E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential
Equations I", Springer 1993, II.6 and II.9).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from coursework.equations.reduction.symbolic import TIME, symbol
from coursework.motion.integration.rates import may_look_until
from coursework.motion.schemes import PRECISE, Slopes
from coursework.scene.model.model import Columns, Model
from coursework.system.arrays import Array, Flags

# Largest turn in one step (rad) of a driven angle or of the argument of a sine in the drive; fewest and most steps.
TURN, FEWEST, MOST = 0.5, 12, 4000
# Distance from zero that is required beyond dips and errors, as a share of the determinant's largest value.
MARGIN = 0.02
# The error of a position is taken as GROWTH times the summed defect; SLOPE bounds how fast a determinant changes with it.
GROWTH, SLOPE = 30.0, 4.0
# A determinant that stays below this share of its largest possible value is not judged by its own largest value.
_FLAT = 1e-6


@dataclass(slots=True)
class Watch:
    """What is known of the determinants (blocks, n) so far, look by look."""

    last: Array
    before: Array | None
    least: Array
    most: Array
    dip: Array
    changed: Flags
    fastest: Array

    @classmethod
    def at(cls, determinants: Array) -> Watch:
        """Return the watch after the first look."""
        size = np.abs(determinants)
        return cls(determinants, None, size, size, np.zeros_like(size), np.zeros(size.shape[1], dtype=bool), np.zeros_like(size))

    def look(self, determinants: Array) -> None:
        """Record the determinants of the next look."""
        size = np.abs(determinants)
        self.changed |= ~(determinants * self.last > 0).all(axis=0)
        self.least, self.most = np.minimum(self.least, size), np.maximum(self.most, size)
        self.fastest = np.maximum(self.fastest, np.abs(determinants - self.last))
        if self.before is not None:
            self.dip = np.maximum(self.dip, np.abs(determinants - 2 * self.last + self.before))
        self.before, self.last = self.last, determinants


def sure_to_move(model: Model, numbers: Columns, q: Array, end: float, steps: int) -> Flags:
    """Return for which sets (n,) the motion from positions q (m, n), followed in `steps` steps, is sure to reach `end` (s)."""
    blocks, m = len(model.blocks), q.shape[0]
    if not blocks:
        return np.asarray(np.isfinite(q).all(axis=0))

    def rates(t: float, at: Array) -> tuple[Array, Array]:
        values = model.program(t, *at, *numbers)
        return stacked(values[:m], at), stacked(values[-blocks:], at[:1])

    breaks = {time for time in model.breaks if 0 < time < end}
    times = sorted({*np.linspace(0.0, end, steps + 1).tolist(), *breaks})
    slope, determinants = rates(0.0, q)
    watch = Watch.at(determinants)
    error, moved = np.zeros(q.shape[1]), np.zeros(q.shape[1])
    for t, after in itertools.pairwise(times):
        h, first = after - t, slope
        ahead = PRECISE.step(slopes(model, numbers, after), t, q, h, first)
        slope, determinants = rates(min(after, may_look_until(model.breaks, after)), ahead)
        middle = (q + ahead) / 2 + h / 8 * (first - slope)
        there, between = rates(t + h / 2, middle)
        watch.look(between)
        watch.look(determinants)
        error += h * np.max(np.abs(1.5 * (ahead - q) / h - (first + slope) / 4 - there), axis=0)
        moved = np.maximum(moved, np.max(np.abs(ahead - q), axis=0))
        q = ahead
        if after in breaks:
            slope, determinants = rates(after, q)
            watch.look(determinants)
    return _judged(model, watch, error, moved)


def _judged(model: Model, watch: Watch, error: Array, moved: Array) -> Flags:
    scale = np.where(watch.most > 0, watch.most, 1.0)
    slope = np.maximum(SLOPE, SLOPE * watch.fastest / scale / np.maximum(moved, 1e-12))
    room = watch.least / scale - watch.dip / scale - slope * GROWTH * error
    largest = np.array([block.largest for block in model.blocks])[:, None]
    flat = watch.most < _FLAT * largest
    return np.asarray((room > MARGIN).all(axis=0) & ~watch.changed & ~flat.any(axis=0) & np.isfinite(error))


def fewest_steps(model: Model, numbers: Columns, frequency: Array, start: Array, end: float) -> int:
    """Return the number of steps for a first look: in one step no drive turns further than `TURN`."""
    drives = tuple(symbol(rate) for c, rate in zip(model.variant.coordinates, model.variant.rates, strict=True)
                   if rate in model.variant.known_rates and c.unit == "rad")  # fmt: skip
    turning = np.abs(np.array([np.max(np.abs(v)) for v in model.compiled(drives)(0.0, *start, *numbers)])) if drives else 0.0
    fastest = max(float(np.max(frequency, initial=0.0)), float(np.max(turning, initial=0.0)))
    fastest = fastest if math.isfinite(fastest) else 0.0
    return int(min(MOST, max(FEWEST, math.ceil(end * fastest / TURN))))


def frequencies(model: Model, slopes: Sequence[Any], numbers: Columns, count: int, end: float) -> Array:
    """Return the fastest change (n,) in rad/s of the argument of a sine or cosine in the drive, 0 without any."""
    found = np.zeros(count)
    if not slopes:
        return found
    timely = any(TIME in slope.free_symbols for slope in slopes)
    times = np.linspace(0.0, end, 257)[:, None] if timely else 0.0
    for value in model.compiled(tuple(slopes))(times, *np.zeros(len(model.coordinates)), *numbers):
        size = np.abs(value)
        found = np.maximum(found, np.max(size, axis=0) if np.ndim(size) == 2 else size)
    return found


def slopes(model: Model, numbers: Columns, end: float) -> Slopes:
    """Return `f(t, q)`: the slopes (m, n) of all sets in a step that ends at `end` (s)."""
    latest, m = may_look_until(model.breaks, end), len(model.coordinates)
    return lambda t, q: stacked(model.program(min(t, latest), *q, *numbers)[:m], q)


def stacked(values: Sequence[Any], like: Array) -> Array:
    """Return numbers and arrays (n,) stacked as rows (k, n)."""
    rows = np.empty((len(values), like.shape[1]))
    for row, value in zip(rows, values, strict=True):
        row[:] = value
    return rows
