"""Rows of a motion under forces, up to where a force has a value.

Enters: a `Variant` and the rows as found.  Leaves: rows without the last one, if it has none.  Used by `motor_scene.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.dynamics import FreeMotion
from coursework.system.arrays import Array
from coursework.variant.record.no_value import without_value
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

UNDEFINED = "no value"


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
            return replace(ended, t=found.t[:-1], coordinates=found.coordinates[:-1], rates=found.rates[:-1], at=float(t[0]))
    return ended
