"""A rail of the frame that does not lie along the motion of its point.

Enters: directions as complex numbers.  Leaves: a sentence.  Used by `rigid.py` and `effects/kinetostatics/analysis.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def off_rail(point: str, along: complex, way: complex, is_curved: bool) -> Sentence:
    """Return that a point moves by `way`, or along a curve, and not `along` its rail."""
    angles = {"angle": _degrees(along), "way": _degrees(way)}
    return say("fault.V316.curved" if is_curved else "fault.V316.straight", point=point, **angles)


def _degrees(along: complex) -> float:
    """Return the angle of a line in degrees, above -90 and up to 90, to the digits that a path has."""
    return float(90.0 - (90.0 - np.round(np.degrees(np.angle(along)), 6)) % 180.0)
