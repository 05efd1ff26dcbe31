"""What the drive gives a plan without any construction: velocities of points, and rates of driven lengths along links.

Enters: an `Outline` and its variant, velocity equations and the exact rows.  Leaves: names of points, rates by link and rider.
Used by `plans.py`, `graph_check.py` and `sketch.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import read_poses
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.integration.motion import Motion
from coursework.variant.record.entries import reached
from coursework.variant.record.variant import Variant

ALIKE = 1e-9  # relative to the longest distance: a length and a coordinate that differ by less in every row are the same

DrivenLengths = Mapping[tuple[str, str], str]


def given_points(outline: Outline, variant: Variant) -> tuple[str, ...]:
    """Return the points with a given velocity, and those moved only by driven coordinates, along a guide or by a law.

    A point that only a driven angle moves is none of these: its crank carries it.
    """
    formulas = dict(outline.points)
    coordinates = {c.name: c for c in variant.coordinates}
    laws = {law.name: {law.of, *(name for one in law.formulas for name in one.names())} for law in variant.functions}

    def pushed(name: str) -> bool:
        names = {*reached([name], formulas)}
        led = [laws[one] for one in laws.keys() & names]
        direct = coordinates.keys() & names
        moving = [coordinates[one] for one in coordinates.keys() & names.union(*led)]
        along = any(coordinates[one].unit == "m" for one in direct) if direct else bool(led)
        return along and all(c.rate in variant.known_rates for c in moving)

    drawn = dict.fromkeys(name for bar in outline.bars for name in bar.corners)
    return tuple(dict.fromkeys((*outline.driven, *(name for name in drawn if name in formulas and pushed(name)))))


def driven_lengths(outline: Outline, equations: VelocityEquations, exact: Motion) -> DrivenLengths:
    """Return (link, rider) -> the rate of the driven distance along the link from its point to the rider, as in a cylinder."""
    driven = [c for c in equations.variant.driven_coordinates if c.unit == "m"]
    if not driven or not outline.slots or len(exact.t) < 2:
        return {}
    poses = read_poses(outline, equations)(exact.t, exact.coordinates)
    found = {}
    for slot in outline.slots:
        for rider in slot.riders:
            ways = poses.at[rider] - poses.at[slot.at]
            way = (ways * poses.along(slot.base, slot.toward).conjugate()).real
            for coordinate in driven:
                if np.max(np.abs(way - exact.column(coordinate.name))) <= ALIKE * np.max(np.abs(ways)):
                    found[slot.link, rider] = coordinate.rate
    return found
