"""Where the ground of a mechanism is, on paper as on the screen: below a hinge, behind a rail, inside a fixed circle.

Enters: an `Outline` and places of its points (name -> x + iy in m) in one position.  Leaves: directions, sides, racks.
Used by `painter.py`, `polygons.py`, `drawing/check_sheet/sketch.py`, `report/live/drawn.py`, `report/live/spots.py` and
`moving_picture.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.drawing.outline.outline import Outline, Rail, Slot, Track, Wheel
from coursework.system.angles import dot
from coursework.system.frozen import frozen

FREE = 0.75  # cosine of the angle between a link and the ground of a hinge, up to which the link does not hide it
TOUCHING = 0.02  # relative to the radius of a fixed circle: a wheel this near to it rolls on it
ON_LINE = 1e-6  # relative to its distance along the rail: the contact of a rack is this near to the line of the rail
Places = Mapping[str, complex]


@frozen
class Rack:
    """A slider of one point moved by a gear: the line of its `rail` runs through the `contact`; `side` +1 if it lies left."""

    link: str
    rail: Rail
    contact: str
    side: int

    @property
    def slot(self) -> Slot:
        """Return the rack as a slot of the slider, along which the contact moves."""
        return Slot(self.link, self.rail.rider, self.rail.base, self.rail.toward, (self.contact,))


def hinge_ground(outline: Outline, places: Places, name: str) -> complex:
    """Return the direction from a hinge to its ground: below, as in a textbook, unless a link hides it there."""
    at = places[name]
    arms = [places[p] - at for bar in outline.bars if name in bar.corners for p in bar.corners if places[p] != at]
    near = {way: max((dot(arm, way) / abs(arm) for arm in arms), default=0.0) for way in (-1j, -1 + 0j, 1 + 0j, 1j)}
    return -1j if near[-1j] < FREE else min(near, key=lambda way: round(near[way], 6))


def rail_side(outline: Outline, places: Places, rail: Rail) -> int:
    """Return the free side of a rail: +1 to the left of its direction, -1 to the right."""
    along = places[rail.toward] - places[rail.base]
    wheels = [wheel.centre for wheel in outline.wheels if wheel.contact == rail.rider and rail.rolls]
    others = [places[name] for name in wheels or outline.shown if wheels or name != rail.rider]
    middle = sum(others, 0j) / len(others) if others else 0j
    return 1 if others and dot(1j * along, middle - places[rail.at]) < 0 else -1


def wheel_on(outline: Outline, places: Places, track: Track) -> Wheel | None:
    """Return the wheel that touches a fixed circle, None if none does; use row 1, as later rows of a scheme drift away."""
    radius = abs(places[track.rim] - places[track.centre])
    gaps = {wheel: abs(abs(places[wheel.contact] - places[track.centre]) - radius) for wheel in outline.wheels}
    return next((wheel for wheel, gap in gaps.items() if gap <= TOUCHING * radius), None)


def inward(outline: Outline, places: Places, track: Track) -> int:
    """Return +1 if a fixed circle is solid inside, -1 if it is a ring in which its wheel rolls, 0 if it has no wheel."""
    wheel = wheel_on(outline, places, track)
    if wheel is None:
        return 0
    middle = places[track.centre]
    return 1 if abs(places[wheel.centre] - middle) > abs(places[track.rim] - middle) else -1


def racks(outline: Outline, places: Places) -> list[Rack]:
    """Return the racks: sliders of one point whose rail runs through the contact of a gear that rolls on nothing fixed."""
    found = []
    resting = {rail.rider for rail in outline.rails if rail.rolls}
    for wheel in outline.wheels:
        on_track = any(wheel_on(outline, places, track) == wheel for track in outline.tracks)
        if wheel.contact in resting or on_track or sum(wheel.contact in bar.corners for bar in outline.bars) > 1:
            continue
        for rail in outline.rails:
            along = places[rail.toward] - places[rail.base]
            way = (places[wheel.contact] - places[rail.at]) * along.conjugate()
            links = [bar.link for bar in outline.bars if bar.corners == (rail.rider,)]
            if links and abs(way.imag) <= ON_LINE * abs(way):
                to_gear = places[wheel.centre] - places[wheel.contact]
                found.append(Rack(links[0], rail, wheel.contact, 1 if dot(1j * along, to_gear) < 0 else -1))
    return found


def touched(outline: Outline, places: Places, wheel: Wheel) -> list[str]:
    """Return the moving links that a wheel touches: other wheels, links with the contact as a corner, racks."""
    wheels = [one.link for one in outline.wheels if one.contact == wheel.contact and one is not wheel]
    holders = [bar.link for bar in outline.bars if wheel.contact in bar.corners and bar.link != wheel.link]
    return [*wheels, *holders, *(rack.link for rack in racks(outline, places) if rack.contact == wheel.contact)]
