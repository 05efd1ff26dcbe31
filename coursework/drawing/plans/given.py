"""Points whose velocity the drive gives without any construction.

Enters: an `Outline` and its variant.  Leaves: names of points.  Used by `plans.py` and `sketch.py`.
"""

from __future__ import annotations

from coursework.drawing.outline.outline import Outline
from coursework.variant.record.entries import reached
from coursework.variant.record.variant import Variant


def given_points(outline: Outline, variant: Variant) -> tuple[str, ...]:
    """Return the points with a given velocity, and those that only driven coordinates move, one of them along a guide.

    A point that a driven angle moves is no such point: it is carried by its crank.
    """
    formulas = dict(outline.points)
    coordinates = {c.name: c for c in variant.coordinates}

    def pushed(name: str) -> bool:
        moving = [coordinates[one] for one in coordinates.keys() & reached([name], formulas)]
        return any(c.unit == "m" for c in moving) and all(c.rate in variant.known_rates for c in moving)

    drawn = dict.fromkeys(name for bar in outline.bars for name in bar.corners)
    return tuple(dict.fromkeys((*outline.driven, *(name for name in drawn if name in formulas and pushed(name)))))
