"""How far the motion under forces is known: while its errors do not double again and again, and every force has a value.

Enters: the rows of the motion, and some of them with a coarser tolerance, or a `Variant`.  Leaves: the rows that are known.
Used by `scene/motor_scene.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.free_motion import FreeMotion
from coursework.system.arrays import Array
from coursework.variant.record.no_value import without_value
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

# COARSER is ten thousand times the tolerance of a step.  If the difference has grown to LOST of a column's range, the motion
# itself is off by a millionth of the range, and soon by all of it.
COARSER, LOST = 1e-9, 0.01
LOOKS = 40  # number of rows that are followed again
_LEAST = 1e-6  # rad or sizes of the mechanism, and that a second: the smallest range used as a scale
UNDEFINED = "no value"


def known_rows(found: FreeMotion, coarser: FreeMotion, pace: int, sizes: Sequence[float]) -> FreeMotion:
    """Return the rows up to the last one that agrees with those of the coarser tolerance, which are `pace` rows apart.

    `sizes` are what counts as 1 of each coordinate and free rate.
    """
    count = min(len(coarser.t), (len(found.t) - 1) // pace + 1)
    own, other = (np.concatenate([one.coordinates, one.rates], axis=1) for one in (found, coarser))
    if count < 2:
        return found
    gaps = np.abs(own[: (count - 1) * pace + 1 : pace] - other[:count]) / np.maximum(
        np.ptp(own, axis=0), _LEAST * np.array(sizes)
    )
    lost = np.flatnonzero(~(gaps <= LOST).all(axis=1))
    if not len(lost):
        return found
    return found.first(max(0, int(lost[0]) - 1) * pace + 1, ended="sensitive", at=float(coarser.t[lost[0]]), by="")


def up_to_values(variant: Variant, found: FreeMotion, table: Callable[[Array, Array, Array], Array]) -> FreeMotion:
    """Return rows up to where a force is beyond all numbers, or its law leaves the numbers for which it holds.

    `table` gives velocities and what follows from them.  Raises `InputError` for a law that has no value at this time even where
    the motion begins.
    """
    names = (*(c.name for c in variant.coordinates), *variant.velocities)

    def fault_at(t: float, q: Array, v: Array) -> Fault | None:
        velocities = table(np.array([t]), q[None], v[None])[0, : len(variant.velocities)]
        return without_value(variant, t, dict(zip(names, (*q.tolist(), *velocities.tolist()), strict=True)))

    count, kept, ended = len(variant.coordinates), len(found.t), found
    if found.lost:
        time, *state = found.lost
        fault = fault_at(time, np.array(state[:count]), np.array(state[count:]))
        if fault is not None:
            if fault_at(time, found.coordinates[0], found.rates[0]):
                raise InputError([fault])
            ended = replace(found, ended=UNDEFINED, at=time, by=say("dynamics.undefined", place=fault.place, why=fault.message))
    if ended.ended in {"not finite", UNDEFINED} and kept > 1:
        t, q, v = found.t[-1:], found.coordinates[-1:], found.rates[-1:]
        if not np.isfinite(table(t, q, v)).all():
            return ended.first(kept - 1, at=float(t[0]))
    return ended
