"""Slides whose length is driven, as that of a hydraulic cylinder is: what slides moves along its link at a known rate.

Enters: an `Outline`, velocity equations and the exact rows.  Leaves: rates by link and rider.
Used by `plans.py` and `graph_check.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import all_rows, read_poses
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.integration.motion import Motion

ALIKE = 1e-9  # of the longest distance: a way and a coordinate that differ by less in every row are one

DrivenLengths = Mapping[tuple[str, str], str]


def driven_lengths(outline: Outline, equations: VelocityEquations, exact: Motion) -> DrivenLengths:
    """Return (link, rider) -> the driven rate of the way along the link from its point to what slides on it."""
    driven = [c for c in equations.variant.driven_coordinates if c.unit == "m"]
    if not driven or not outline.slots or len(exact.t) < 2 or not all_rows(equations, exact):
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
