"""How a mechanism lies on the page: scale from the series of drawing standards, scale of velocities, upright or landscape.

Enters: a `Sketch` and the `Findings`.  Leaves: `Layout`.  Used by `drawing.py` and `check_plan.py`.
Source of the series: ISO 5455, GOST 2.302 (1:1, 1:2, 1:2.5, 1:4, 1:5, 1:10 ...); the coursework of 1995 asks for 1:10.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from coursework.drawing.check_sheet.instant_centres import Centre, Findings
from coursework.drawing.check_sheet.sketch import Sketch
from coursework.drawing.paper.board import Board, Circle, around, vector_scale
from coursework.drawing.paper.cover import Rectangle
from coursework.drawing.plans.foot import FOOT
from coursework.system.frozen import frozen

PAGE = (170.0, 190.0)  # mm: the text width of A4 with margins of 20 mm, and room for a caption
LANDSCAPE = (257.0, 138.0)  # mm: the same page in landscape, with room for heading and caption
EDGE = 3.0  # mm
SHALLOW = 100.0  # mm: a lower drawing leaves half of a landscape page empty, and most of the page before it
COARSER = 2.0  # an upright drawing among the text may be this many times smaller instead
SCALES = tuple(sorted(m * 10.0**k for k in range(-7, 9) for m in (1.0, 2.0, 2.5, 4.0, 5.0)))
ARROWS = (45.0, 30.0, 20.0)  # mm: limits of the longest velocity; the first that fits is taken
ROOM = {"point": 8.0, "hinge": 11.0, "tip": 6.0, "rim": 3.0}  # mm around each such place, for symbols and labels
CENTRE_ROOM = 6.0
CROSS = 1.5  # mm: the arms of the cross that marks a centre


@frozen
class Layout(Board):
    """A board with `speed` m/s per mm of a velocity; `wide`: landscape; `near`: the links whose centre lies on the sheet."""

    speed: float
    wide: bool
    near: frozenset[str]

    def arrow(self, velocity: complex) -> complex:
        """Return the arrow (mm, y down) of a velocity (m/s)."""
        return (velocity / self.speed).conjugate()

    @property
    def field(self) -> Rectangle:
        """Return left, top, right and bottom (mm) of the room for the drawing."""
        return (EDGE, EDGE, self.width - EDGE, self.height - FOOT)

    def holds(self, centre: Centre) -> bool:
        """Return whether a centre and the cross that marks it lie within the borders."""
        if centre.at is None or not centre.lines:
            return False
        (left, top, right, bottom), at = self.field, self.put(centre.at)
        return left + CROSS <= at.real <= right - CROSS and top + CROSS <= at.imag <= bottom - CROSS


def lay_out(sketch: Sketch, findings: Findings) -> Layout:
    """Return the layout with the largest scale at which links and velocities fit, on the page that shows more centres.

    If a landscape page would stay half empty, an upright one on which all is drawn somewhat smaller is preferred.
    If nothing fits (a mechanism of many kilometres), the smallest scale is taken.
    """
    shallow: Layout | None = None
    for scale in _possible(sketch) if sketch.pose.size > 0 else (1.0,):
        if shallow is not None and scale > COARSER * shallow.scale:
            return shallow
        for longest in ARROWS:
            found = [way for wide in (False, True) if (way := _try(sketch, findings, scale, longest, wide))]
            if shallow is not None:
                found = [way for way in found if not way.wide and way.near >= shallow.near]
            if found:
                best = max(found, key=lambda way: (len(way.near), sum(map(way.holds, findings.specials.values())), not way.wide))
                if not best.wide or best.height >= SHALLOW:
                    return best
                shallow = best
                break
    return shallow or Layout(SCALES[-1], *PAGE, complex(PAGE[0] / 2, PAGE[1] / 2), 1.0, False, frozenset())


def _possible(sketch: Sketch) -> Iterator[float]:
    """Yield the scales at which the points alone are not already longer than the longer side of a page."""
    places = [sketch.pose.positions[name] * 1000 for name in _points(sketch)]
    extent = max((max(way) - min(way) for way in zip(*((z.real, z.imag) for z in places), strict=True)), default=0.0)
    return (scale for scale in SCALES if extent <= max(PAGE + LANDSCAPE) * scale)


def _points(sketch: Sketch) -> list[str]:
    tracks = {track.centre for track in sketch.outline.tracks if track.centre in sketch.pose.positions}
    return sorted({name for body in sketch.pose.bodies for name in body.points} | set(sketch.hinges) | tracks)


def _try(sketch: Sketch, findings: Findings, scale: float, longest: float, wide: bool) -> Layout | None:
    mm = 1000 / scale
    fastest = max((abs(v) for v in findings.velocities.values()), default=0.0)
    speed = vector_scale(fastest, longest)
    most_wide, most_high = LANDSCAPE if wide else PAGE

    def fits(circles: list[Circle]) -> bool:
        left, low, right, high = around(circles)
        return right - left <= most_wide - 2 * EDGE and high - low <= most_high - EDGE - FOOT

    circles = [*_needed(sketch, findings, mm, speed)]
    if not fits(circles):
        return None
    left, low, right, high = around(circles)
    middle = complex(left + right, low + high) / 2
    drawn = [centre.at * mm for centre in findings.drawn.values() if centre.at is not None and centre.lines]
    specials = [special.at * mm for special in findings.specials.values() if special.at is not None]
    # The nearest first: a far centre must not take the room of those that fit.
    for at in (*sorted(drawn, key=lambda at: abs(at - middle)), *specials):
        if fits([*circles, (at, CENTRE_ROOM)]):
            circles.append((at, CENTRE_ROOM))
    left, low, right, high = around(circles)
    width = max(PAGE[0], right - left + 2 * EDGE)
    origin = complex((width - right - left) / 2, EDGE + high)
    sheet = Layout(scale, width, high - low + EDGE + FOOT, origin, speed, wide, frozenset())
    # A centre with too little room for its name may still lie on the sheet.
    return replace(sheet, near=frozenset(name for name, centre in findings.drawn.items() if sheet.holds(centre)))


def _needed(sketch: Sketch, findings: Findings, mm: float, speed: float) -> Iterator[Circle]:
    """Yield circles (middle and radius in mm, y up) of what must be on the sheet."""
    positions = sketch.pose.positions
    for name in _points(sketch):
        yield positions[name] * mm, ROOM["hinge" if name in sketch.hinges else "point"]
        if velocity := findings.velocities.get(name, 0j):
            yield positions[name] * mm + velocity / speed, ROOM["tip"]
    for slot in sketch.outline.slots:
        beside, low, high = sketch.poses.line(slot)
        along = complex(sketch.poses.along(slot.base, slot.toward)[sketch.row])
        foot = sketch.poses.pose(sketch.row)[slot.at] + 1j * along * beside
        yield from (((foot + along * way) * mm, ROOM["tip"] + 10) for way in (low, high))
    for centre, contact in sketch.wheels.values():
        yield positions[centre] * mm, abs(positions[contact] - positions[centre]) * mm + ROOM["rim"]
