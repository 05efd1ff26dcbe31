"""The plan of velocities of the graph-analytical check: drawn from the constructed velocities, with those of the table beside.

Enters: a `Sketch`, the `Findings`, and the motion by the table.  Leaves: `CheckPlan`.
Used by `graph_check.py`, `readings.py` and `graph_words.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from coursework.drawing.check_sheet.instant_centres import Centre, Findings
from coursework.drawing.check_sheet.layout import lay_out
from coursework.drawing.check_sheet.sketch import Sketch
from coursework.drawing.plans.known import Driven
from coursework.drawing.plans.moving import Kinematics, Moving
from coursework.drawing.plans.plan_scale import SEEN, PlanScale, scale_of
from coursework.drawing.plans.polygons import polygons
from coursework.drawing.plans.vectors import POLE, VELOCITY, Polygons
from coursework.system.frozen import frozen


@frozen
class CheckPlan:
    """The polygons of one row, and the velocities (m/s) from the pole to each image, as `drawn` and as `tabled`.

    `specials` are the special points of links by name; all of them lie on the sheet of the position.
    """

    polygons: Polygons
    scale: PlanScale
    drawn: Mapping[str, complex]
    tabled: Mapping[str, complex]
    specials: Mapping[str, Centre]

    def has(self, start: str, end: str) -> bool:
        """Return whether the plan draws the vector from one image to another itself; `start` is "" for the pole."""
        here = (s for s in self.polygons.segments if s.plan == VELOCITY)
        return any((s.start, s.end) == (start or POLE, end) for s in here)

    def moves(self, name: str) -> bool:
        """Return whether the image of a point can be told from the pole."""
        return abs(self.drawn[name]) > SEEN * self.scale.longest

    @property
    def solved(self) -> set[str]:
        """Return the points whose image was computed, because no two lines of the plan meet in it."""
        return {one.point for one in self.polygons.found if one.rule == "solved"}


def plan_of(sketch: Sketch, findings: Findings, table: Kinematics) -> CheckPlan | None:
    """Return the plan of a row, None if the geometry leaves a velocity open; `table` holds that one row."""
    links = [bar for bar in sketch.outline.bars if bar.corners]
    if findings.missing or any(bar.link not in findings.omegas for bar in links if len(bar.corners) > 1):
        return None
    sheet, taken = lay_out(sketch, findings), dict[tuple[str, ...], Centre]()

    def on_sheet(place: complex, ends: tuple[str, ...]) -> bool:
        """Return whether a special point fits on the sheet beside all that is there; if so, keep it in `taken`."""
        wanted = {**taken, ends: Centre(place, ends)}
        tried = lay_out(sketch, replace(findings, specials={"".join(key): special for key, special in wanted.items()}))
        if fits := tried.near >= sheet.near and all(map(tried.holds, wanted.values())):
            taken.update(wanted)
        return fits

    driven = Driven(tuple(sketch.pose.velocities), tuple(sketch.pose.rates), sketch.pose.driven_lengths)
    drawn = polygons(sketch.outline, _constructed(sketch, findings), driven, on_sheet=on_sheet)
    tabled = polygons(sketch.outline, table, driven, on_sheet=lambda _, ends: ends in taken)
    named = [one.point for one in drawn.found if one.rule == "special"]
    specials = dict(zip(named, taken.values(), strict=True))
    return CheckPlan(drawn, scale_of(drawn, VELOCITY, 0), _images(sketch, drawn), _images(sketch, tabled), specials)


def _images(sketch: Sketch, drawn: Polygons) -> dict[str, complex]:
    found = {s.end: complex(s.vector[0]) for s in drawn.segments if s.plan == VELOCITY and s.kind == "absolute"}
    return dict.fromkeys(sketch.outline.hinges, 0j) | found


def _constructed(sketch: Sketch, findings: Findings) -> Kinematics:
    """Return the motion as constructed; a point without a constructed velocity is carried by its link."""
    velocities = {**findings.velocities}
    places = {name: complex(at[sketch.row]) for name, at in sketch.poses.at.items()}
    for bar in sketch.outline.bars:
        base = next((name for name in bar.corners if name in velocities), "")
        for name in bar.corners:
            if base and name not in velocities:
                velocities[name] = velocities[base] + 1j * findings.omegas[bar.link] * (places[name] - places[base])
    still = np.zeros(1, dtype=complex)
    points = {name: Moving(np.array([at]), np.array([velocities.get(name, 0j)]), still) for name, at in places.items()}
    none = np.zeros(1)
    turning = {bar.link: (np.array([findings.omegas.get(bar.link, 0.0)]), none) for bar in sketch.outline.bars}
    return Kinematics(np.array([float(sketch.poses.t[sketch.row])]), points, turning)
