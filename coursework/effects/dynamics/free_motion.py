"""The rows of a motion under forces, and why they end.

Enters: what `Dynamics` computed.  Leaves: `FreeMotion`.  Used by `dynamics.py`, `known_rows.py` and `scene/motor_scene.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.system.arrays import Array
from coursework.system.frozen import frozen


@frozen
class FreeMotion:
    """The rows of a motion: `t` (n,) s, all coordinates (n, m), free rates (n, f), and the number of `slopes` evaluated.

    `ended` is "" if it reached its end, else "dead point", "too steep" (the forces), "not finite", "held" or "locked" (by
    friction at the point `by`), "sensitive" (unknown beyond), "limit position" (of the free coordinates alone), "change point";
    `at` is the time (s), and `lost` holds time, coordinates and free rates at which something had no value.
    """

    t: Array
    coordinates: Array
    rates: Array
    slopes: int
    ended: str = ""
    at: float = 0.0
    by: str = ""
    lost: tuple[float, ...] = ()

    def first(self, rows: int, **ended: Any) -> FreeMotion:
        """Return the first rows alone; `ended` says why they are the last ones."""
        return replace(self, t=self.t[:rows], coordinates=self.coordinates[:rows], rates=self.rates[:rows], **ended)


def one_by_one(start: Sequence[float], count: int) -> FreeMotion:
    """Return the `start` (m,) in as many rows as there are free rates, in each of which one of them is 1 and the others rest."""
    return FreeMotion(np.zeros(count), np.tile(start, (count, 1)), np.eye(count), 0)
