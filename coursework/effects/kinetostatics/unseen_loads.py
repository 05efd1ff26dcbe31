"""Loads that jump or grow without bounds between two rows, where no row of the forces shows it.

Enters: the `ForceAnalysis` of a motion.  Leaves: `Break`s, each with load and time.
Used by `checks.py`.

Between rows the motion is a cubic through their positions, and the velocities change evenly; a load can break there only by its
own formula, so a change that stays however closely it is looked at is a jump of the load, or a pole.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.symbolic import placed
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.hermite import hermite
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array
from coursework.system.frozen import frozen

Indices = NDArray[np.intp]
_PARTS = 17  # of an interval, looked at together; no round share of a step, such as a half, is a multiple of one part
_CLOSER = 9  # number of times that a part is divided again: 17^-9 of a step is about round-off of the time
_JUMP = 0.01  # share of the largest load: a smaller change is no jump
_BEYOND = 1e3  # a load that has no bound grows at least so many times as it is looked at more closely
_MOST = 4000  # number of intervals looked into, those with the largest loads or changes: of more rows, these tell where to look
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
    with np.errstate(all="ignore"):
        known = np.nan_to_num(values(motion.t, motion.coordinates, motion.velocities))
    usual, found = np.abs(known).max(axis=0), dict[str, Break]()
    sizes, changes = np.maximum(np.abs(known[:-1]), np.abs(known[1:])), np.abs(np.diff(known, axis=0))
    for is_pole, telling in ((True, sizes), (False, changes)):
        chosen = np.sort(np.argsort(-telling, axis=None, kind="stable")[:_MOST])
        row, place = np.unravel_index(chosen, telling.shape)
        part, largest, last = _closest(partial(_loads_at, motion, values, row, place), len(row), is_pole=is_pole)
        limit = largest * _BEYOND if is_pole else np.maximum(usual[place], largest) * _JUMP
        broken = ((last > limit) | np.isinf(last)) & (part > _AT_ROW) & (part < 1 - _AT_ROW)
        for at in np.flatnonzero(broken).tolist():
            index = int(row[at])
            one = Break(names[place[at]], index, float(motion.t[index] + part[at] * motion.step), is_pole)
            found.setdefault(one.name, one)
    return tuple(found[name] for name in dict.fromkeys(names) if name in found)


def _loads_at(motion: Motion, values: Callable[..., Array], row: Indices, place: Indices, part: Array) -> Array:
    """Return loads (k, n) at the parts (k, n) of intervals: in each column one interval `row` (n,) and one load `place` (n,)."""
    at, share = np.broadcast_to(row, part.shape).ravel(), part.reshape(-1, 1)
    size, h, q, u = motion.coordinates.shape[1], motion.step, motion.coordinates, motion.velocities
    where = hermite(q[at], q[at + 1], h * u[at, :size], h * u[at + 1, :size], share)
    with np.errstate(all="ignore"):
        loads = values(motion.t[at] + share[:, 0] * h, where, u[at] + share * (u[at + 1] - u[at]))
    return np.asarray(loads[np.arange(len(at)), np.broadcast_to(place, part.shape).ravel()].reshape(part.shape))


def _closest(load_at: Callable[[Array], Array], count: int, *, is_pole: bool) -> tuple[Array, Array, Array]:
    """Return where (n,), as a part of each interval, a load is largest or changes most.

    Behind it come the largest load at the first look, and that load or change at the last one.

    Each interval is divided, and the part with the largest load, or the largest change, is divided again.
    """
    left, width, largest, last = np.zeros(count), np.ones(count), np.zeros(count), np.zeros(count)
    for look in range(_CLOSER):
        part = left + width * np.arange(_PARTS + 1)[:, None] / _PARTS
        values = load_at(part)
        values = np.where(np.isfinite(values), values, np.inf)
        with np.errstate(invalid="ignore"):
            looked = np.abs(values) if is_pole else np.nan_to_num(np.abs(np.diff(values, axis=0)))
        best = np.argmax(looked, axis=0)
        last = looked[best, np.arange(count)]
        largest = largest if look else np.abs(values).max(axis=0)
        # About the largest value both neighbouring parts are kept: a pole may lie on either side of it.
        left = np.clip(left + width * (best - is_pole) / _PARTS, 0.0, 1.0)
        width = np.minimum(width * (1 + is_pole) / _PARTS, 1.0 - left)
    return left + width / 2, largest, last
