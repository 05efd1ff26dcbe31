"""Loads that jump or grow without bounds between two rows, where no row of the forces shows it.

Enters: the `ForceAnalysis` of a motion.  Leaves: `Break`s, each with load and time.
Used by `checks.py`.

Between rows the motion is a cubic through their positions, and the velocities change evenly; a load can break there only by its
own formula, so a change that stays however closely it is looked at is a jump of the load, or a pole.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.symbolic import placed
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.hermite import hermite
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

_PARTS = 16  # of an interval, looked at together
_CLOSER = 9  # number of times that a part is divided again: 16^-9 of a step is about round-off of the time
_JUMP, _BEYOND = 0.01, 1e4  # shares of the largest load in the rows: a smaller change is none, a larger load has no bound
_AT_ROW = 1e-6  # of a step: a break nearer to a row counts as on it


@frozen
class Break:
    """The load `name` jumps at `time` (s) behind the row of index `row`; `is_pole`: it grows without bounds there."""

    name: str
    row: int
    time: float
    is_pole: bool


def unseen_loads(of: ForceAnalysis) -> tuple[Break, ...]:
    """Return the poles and jumps of loads between rows, in the order of the file; of each load the first pole, or jump.

    A load at a row is known, so a break that falls on a row is not among them.
    """
    variant, motion, symbols = of.equations.variant, of.rows.motion, of.equations.symbols
    varying = {"t", *motion.names, *(law.name for law in (*variant.drive, *variant.functions))}
    names, parts = list[str](), list[Expression]()
    for load in of.rows.scheme.forces.loads:
        formula = load.torque if load.force is None else load.force
        if formula is None or not varying & set(formula.names()):
            continue
        with placed(variant, f"forces.{load.name}", 1):
            own = (symbols.scalar(formula),) if load.force is None else symbols.vector(formula)
        names, parts = names + [load.name] * len(own), [*parts, *own]
    if not parts or len(motion.t) < 2:
        return ()
    values = compile_rows(of.equations, parts, 1)
    size, h = motion.coordinates.shape[1], motion.step
    places, speeds = motion.coordinates, motion.velocities

    row, place = (one.ravel() for one in np.indices((len(motion.t) - 1, len(parts))))

    def load_at(part: Array) -> Array:
        """Return the loads (k, n) at the parts (k, n) of the intervals: one interval and one component in each column."""
        at = np.broadcast_to(row, part.shape).ravel()
        share = part.reshape(-1, 1)
        q = hermite(places[at], places[at + 1], h * speeds[at, :size], h * speeds[at + 1, :size], share)
        u = speeds[at] + share * (speeds[at + 1] - speeds[at])
        with np.errstate(all="ignore"):
            found = values(motion.t[at] + share[:, 0] * h, q, u)
        return np.asarray(found[np.arange(len(at)), np.broadcast_to(place, part.shape).ravel()].reshape(part.shape))

    known = np.abs(values(motion.t, places, speeds))
    usual = np.max(np.where(np.isfinite(known), known, 0.0), axis=0)
    found: dict[str, Break] = {}
    for is_pole in (True, False):
        part, size_there = _closest(load_at, len(row), is_pole=is_pole)
        limit = usual[place] * (_BEYOND if is_pole else _JUMP)
        broken = (size_there > limit) & (part > _AT_ROW) & (part < 1 - _AT_ROW)
        for at in np.flatnonzero(broken).tolist():
            index = int(row[at])
            one = Break(names[place[at]], index, float(motion.t[index] + part[at] * h), is_pole)
            found.setdefault(one.name, one)
    return tuple(found[name] for name in dict.fromkeys(names) if name in found)


def _closest(load_at: Callable[[Array], Array], count: int, *, is_pole: bool) -> tuple[Array, Array]:
    """Return where (n,), as a part of each interval, a load is largest or changes most, and that size or change.

    Each interval is divided, and the part with the largest load, or the largest change, is divided again.
    """
    left, width, sizes = np.zeros(count), np.ones(count), np.zeros(count)
    for _ in range(_CLOSER):
        part = left + width * np.arange(_PARTS + 1)[:, None] / _PARTS
        values = load_at(part)
        values = np.where(np.isfinite(values), values, np.inf)
        with np.errstate(invalid="ignore"):
            looked = np.abs(values) if is_pole else np.nan_to_num(np.abs(np.diff(values, axis=0)), nan=0.0)
        best = np.argmax(looked, axis=0)
        sizes = looked[best, np.arange(count)]
        # About the largest value both neighbouring parts are kept: a pole may lie on either side of it.
        left = np.clip(left + width * (best - is_pole) / _PARTS, 0.0, 1.0)
        width = np.minimum(width * (1 + is_pole) / _PARTS, 1.0 - left)
    return left + width / 2, sizes
