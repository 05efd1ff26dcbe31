"""How far the motion under forces is known: if errors double again and again, its last rows mean nothing.

Enters: the rows of the motion, and some of them with a coarser tolerance.  Leaves: the rows that are known.
Used by `scene/motor_scene.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.dynamics import FreeMotion

# COARSER is ten thousand times the tolerance of a step.  If the difference has grown to LOST of a column's range, the motion
# itself is off by a millionth of the range, and soon by all of it.
COARSER, LOST = 1e-9, 0.01
LOOKS = 40  # number of rows that are followed again
_LEAST = 1e-6  # rad, m, rad/s or m/s: the smallest range used as a scale


def known_rows(found: FreeMotion, coarser: FreeMotion, pace: int) -> FreeMotion:
    """Return the rows up to the last one that agrees with those of the coarser tolerance, which are `pace` rows apart."""
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
