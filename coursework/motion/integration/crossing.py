"""Where a value of one number is zero: the straight line through both ends of a bracket, again and again.

Enters: a function, a bracket with its values.  Leaves: the number.
Used by `turning.py`, `motion/singular/walk.py` and `effects/friction/rubbing.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

_TRIALS = 80


def crossing(
    value: Callable[[float], float], bracket: tuple[float, float], ends: tuple[float, float], settled: float
) -> float | None:
    """Return where a value is zero to a part `settled` of a bracket, None where it has no number on the way (Illinois).

    `ends` are the values at the bracket, of two signs.

    >>> round(crossing(lambda x: x * x - 2, (0.0, 2.0), (-2.0, 2.0), 1e-13), 12)
    1.414213562373
    """
    (low, high), width, (at_low, at_high) = bracket, bracket[1] - bracket[0], ends
    place, side = (low, 0) if abs(at_low) < abs(at_high) else (high, 0)
    for _ in range(_TRIALS):
        # The straight line through both ends; one that stays twice counts half, so that both close in.
        between = (low * at_high - high * at_low) / (at_high - at_low) if at_high != at_low else place
        if not low < between < high or min(high - low, abs(between - place)) <= settled * width:
            break
        place, found = between, value(between)
        if not math.isfinite(found):
            return None
        if found == 0:
            break
        if found * at_high > 0:
            at_low = at_low / 2 if side == 1 else at_low
            high, at_high, side = place, found, 1
        else:
            at_high = at_high / 2 if side == -1 else at_high
            low, at_low, side = place, found, -1
    return place
