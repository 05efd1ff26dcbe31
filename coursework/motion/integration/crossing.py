"""The zero of a function of one number, found by the secant through both ends of a bracket (Illinois method).

Enters: a function, a bracket with its values.  Leaves: the number.
Used by `turning.py`, `walk.py`, `divided.py` and `effects/friction/rubbing.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

_TRIALS = 80


def crossing(
    value: Callable[[float], float], bracket: tuple[float, float], ends: tuple[float, float], settled: float
) -> float | None:
    """Return where `value` is zero, to a share `settled` of the bracket; None if it is infinite or nan on the way (Illinois).

    `ends` are the values at the two ends of the bracket, of opposite sign.

    >>> round(crossing(lambda x: x * x - 2, (0.0, 2.0), (-2.0, 2.0), 1e-13), 12)
    1.414213562373
    """
    (low, high), width, (at_low, at_high) = bracket, bracket[1] - bracket[0], ends
    place, side = low if abs(at_low) < abs(at_high) else high, 0
    for _ in range(_TRIALS):
        # The secant through both ends; the value of an end that is kept twice is halved, so that both ends close in.
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
