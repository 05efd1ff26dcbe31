"""The plan of velocities of the graph-analytical check: drawn from what the construction found, beside what the table says.

Enters: a `Sketch`, the `Findings`, and how all moves by the table.  Leaves: `CheckPlan`.
Used by `graph_check.py`, `readings.py` and `graph_words.py`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from coursework.drawing.check_sheet.instant_centres import Findings
from coursework.drawing.check_sheet.sketch import Sketch
from coursework.drawing.plans.moving import Kinematics, Moving
from coursework.drawing.plans.plan_scale import PlanScale, scale_of
from coursework.drawing.plans.polygons import polygons
from coursework.drawing.plans.vectors import POLE, VELOCITY, Found, Polygons


@dataclass(frozen=True, slots=True)
class CheckPlan:
    """The polygons of one row, and the velocities (m/s) from the pole to each image, as `drawn` and as `tabled`."""

    polygons: Polygons
    scale: PlanScale
    drawn: Mapping[str, complex]
    tabled: Mapping[str, complex]

    @property
    def steps(self) -> Sequence[Found]:
        """Return how the images were found, in the order of drawing."""
        return self.polygons.found

    def has(self, start: str, end: str) -> bool:
        """Return whether a vector between two images, "" for the pole, is drawn by itself."""
        here = (s for s in self.polygons.segments if s.plan == VELOCITY)
        return any((s.start, s.end) == (start or POLE, end) for s in here)

    @property
    def solved(self) -> set[str]:
        """Return the points whose velocity no two lines gave."""
        return {one.point for one in self.steps if one.rule == "solved"}


def plan_of(sketch: Sketch, findings: Findings, table: Kinematics) -> CheckPlan | None:
    """Return the plan of a row, None where the geometry leaves something open; `table` holds one row."""
    links = [bar for bar in sketch.outline.bars if bar.corners]
    if findings.missing or any(bar.link not in findings.omegas for bar in links if len(bar.corners) > 1):
        return None
    drawn = polygons(sketch.outline, _constructed(sketch, findings), *_drive(sketch))
    tabled = polygons(sketch.outline, table, *_drive(sketch))
    return CheckPlan(drawn, scale_of(drawn, VELOCITY, 0), _images(sketch, drawn), _images(sketch, tabled))


def _drive(sketch: Sketch) -> tuple[tuple[str, ...], tuple[str, ...]]:
    return tuple(sketch.pose.velocities), tuple(sketch.pose.rates)


def _images(sketch: Sketch, drawn: Polygons) -> dict[str, complex]:
    found = {s.end: complex(s.vector[0]) for s in drawn.segments if s.plan == VELOCITY and s.kind == "absolute"}
    return dict.fromkeys(sketch.outline.hinges, 0j) | found


def _constructed(sketch: Sketch, findings: Findings) -> Kinematics:
    """Return how all moves by the construction; points that are no points of the file are carried by their links."""
    velocities = {**findings.velocities}
    places = {name: complex(at[sketch.row]) for name, at in sketch.poses.at.items()}
    for bar in sketch.outline.bars:
        base = next((name for name in bar.corners if name in velocities), "")
        for name in bar.corners:
            if base and name not in velocities:
                velocities[name] = velocities[base] + 1j * findings.omegas.get(bar.link, 0.0) * (places[name] - places[base])
    still = np.zeros(1, dtype=complex)
    points = {name: Moving(np.array([at]), np.array([velocities.get(name, 0j)]), still) for name, at in places.items()}
    none = np.zeros(1)
    turning = {bar.link: (np.array([findings.omegas.get(bar.link, 0.0)]), none) for bar in sketch.outline.bars}
    return Kinematics(np.array([float(sketch.poses.t[sketch.row])]), points, turning)
