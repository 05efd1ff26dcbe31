"""How far the motion under forces is known: where it doubles what it is off again and again, its last rows are any motion.

Enters: the rows of the motion, and some of them with a coarser tolerance.  Leaves: the rows that are known.
Used by `scene/motor_scene.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.dynamics import FreeMotion

# Ten thousand times what the motion itself may be off in a step: where that has grown to this part of the range of a column,
# the motion is off by a millionth of it, and soon by all.
COARSER, LOST = 1e-9, 0.01
LOOKS = 40  # rows that are followed again
_LEAST = 1e-6  # rad, m, rad/s or m/s: a smaller range is no scale for a tolerance


def known_rows(found: FreeMotion, coarser: FreeMotion, pace: int) -> FreeMotion:
    """Return the rows up to the last one that agrees with those of the coarser tolerance, `pace` rows apart."""
    count = min(len(coarser.t), (len(found.t) - 1) // pace + 1)
    own, other = (np.concatenate([one.coordinates, one.rates], axis=1) for one in (found, coarser))
    if count < 2:
        return found
    gaps = np.abs(own[: (count - 1) * pace + 1 : pace] - other[:count]) / np.maximum(np.ptp(own, axis=0), _LEAST)
    lost = np.flatnonzero(~(gaps <= LOST).all(axis=1))
    if not len(lost):
        return found
    rows = max(0, int(lost[0]) - 1) * pace + 1
    return replace(
        found, t=found.t[:rows], coordinates=found.coordinates[:rows], rates=found.rates[:rows], ended="sensitive",
        at=float(coarser.t[lost[0]]), by="",
    )  # fmt: skip
