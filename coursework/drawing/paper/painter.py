"""A mechanism on a sheet, from the background to the foreground: rails, hinges, links, blocks, joints.

Enters: an `Outline`, its `Poses` and a mapping from the plane to the sheet.  Leaves: items on the `Sheet`.
Used by `drawing/figures.py`, `naming.py`, `dimensions.py`, `offsets.py` and `drawing/check_sheet/drawing.py`.
SVG elements say what they are: data-link, data-sleeve, data-rail.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable, Iterator
from functools import cached_property

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side, wheel_on
from coursework.drawing.outline.outline import Bar, Block, Outline, Rail, Slot, Track, Wheel
from coursework.drawing.outline.poses import Poses
from coursework.drawing.paper.board import around
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.sheet import PITCH, Sheet, inside, plain
from coursework.system.angles import dot

LINK = 'stroke="black" stroke-width="0.8"'
THIN = 'stroke="black" stroke-width="0.2"'
FRAME = 'stroke="black" stroke-width="0.35"'
OUTLINE = 'fill="none" stroke="black" stroke-width="0.35"'
RING = 'fill="white" stroke="black" stroke-width="0.35"'
DOT = 'fill="black"'
BLOCK = (4.2, 2.4)  # mm, half length and half height of a slider
BEYOND = 10.0  # mm: length of a bar beyond the farthest place of its sleeve
RAIL, LEAST_RAIL = 9.0, 5.0  # mm: length of a rail beyond the farthest place of its slider; at least
OFF_JOINT = 2.4  # mm: a rail keeps this far from joints that do not slide on it
JOINT = 1.0  # mm: the radius of a joint, less than the shortest arrow that begins in one
GROUND, HALF_GROUND = 8.0, 5.5  # mm: depth and half width of the symbol of a hinge, with the room around it
ALIGNED = 1e-9  # relative to the size of the link: a point this near to a line lies on it


class Painter:
    """Draws one row of a mechanism; `put` maps a point (m) to the sheet (mm, y down), 1 m is `mm` mm long there."""

    def __init__(
        self, sheet: Sheet, outline: Outline, poses: Poses, row: int, put: Callable[[complex], complex], mm: float
    ) -> None:
        self.sheet, self.outline, self.poses, self.row, self.put, self.mm = sheet, outline, poses, row, put, mm
        self.place = poses.pose(row)
        self.at = {name: put(z) for name, z in self.place.items()}
        self.names = outline.shown
        self.middle = sum((self.at[name] for name in self.names), 0j) / max(len(self.names), 1)
        self.grounds: list[tuple[complex, complex]] = []  # lines of rails and hinges as drawn
        self.rails: dict[Rail, tuple[complex, complex]] = {}  # the rails among them

    def extent(self) -> Iterator[tuple[complex, float]]:
        """Yield the places on the sheet (mm, y down) that need room, each with the radius of its room."""
        for name in self.names:
            yield self.at[name], 11.0 if name in self.outline.hinges else 7.0
        for wheel in self.outline.wheels:
            yield self.at[wheel.centre], abs(self.at[wheel.contact] - self.at[wheel.centre]) + 3.0
        for track in self.rings:
            yield self.at[track.centre], abs(self.at[track.rim] - self.at[track.centre]) + 3.0
        for slot in self.outline.slots:
            yield from ((end, 3.0) for end in self.slot_line(slot))
        for rail in self.outline.rails:
            yield from ((end, 4.0) for end in self.rail_line(rail))

    def fixed(self) -> None:
        """Draw what stands still: tracks, rails, hinges."""
        for track in self.outline.tracks:
            self.track(track)
        for rail in self.outline.rails:
            self.rail(rail)
        for name in self.outline.hinges:
            self.hinge(name)

    def moving(self, *, dragged: bool = False) -> None:
        """Draw what moves: blocks, links, joints; if `dragged`, with the positions by which the desk lets a hand drag joints."""
        for block in self.outline.blocks:
            self.block(block)
        for wheel in self.outline.wheels:
            self.wheel(wheel)
        for bar in self.outline.bars:
            self.bar(bar)
        for slot in self.outline.slots:
            self.slot(slot)
        for name in self.names:
            self.joint(name, self.spot(name) if dragged else "")

    def thin(self) -> None:
        """Draw only the links, with thin lines, as one of many positions."""
        for bar in self.outline.bars:
            self.sheet.path([self.at[name] for name in bar.corners], f'fill="none" {THIN}', blocks=False)
        for slot in self.outline.slots:
            self.sheet.path(self.slot_line(slot), f'fill="none" {THIN}', blocks=False)
        for wheel in self.outline.wheels:
            radius = abs(self.at[wheel.contact] - self.at[wheel.centre])
            self.sheet.circle(self.at[wheel.centre], radius, f'fill="none" {THIN}', rim=True, blocks=False)

    # what is fixed

    def rail_line(self, rail: Rail) -> tuple[complex, complex]:
        """Return both ends of a rail (mm): the travel of its slider and a little more on both sides."""
        start, along, low, high = self.poses.travel(rail)
        wheels = [w for w in self.outline.wheels if w.contact == rail.rider and rail.rolls]
        radius = max((abs(self.place[w.contact] - self.place[w.centre]) for w in wheels), default=0.0)
        more = max(RAIL / self.mm, 1.25 * radius)
        return self.put(start + along * (low - more)), self.put(start + along * (high + more))

    def rail(self, rail: Rail) -> None:
        """Draw a rail, hatched on its free side."""
        a, b = self.rail_line(rail)
        side = -1j * (b - a) / abs(b - a) * rail_side(self.outline, self.poses.pose(0), rail)
        pieces = [(a, b)]
        if rail.rider and not rail.rolls:
            side, pieces = self.clear_of_joints(rail, (a, b), side)
        for piece in pieces:
            if part := inside(*piece, self.sheet.field):
                self.sheet.line(*part, FRAME, ' data-rail=""')
                self.sheet.hatch(*part, side)
                self.grounds.append(part)
                self.rails.setdefault(rail, part)

    def clear_of_joints(self, rail: Rail, ends: Segment, side: complex) -> tuple[complex, list[Segment]]:
        """Return the side of its block on which a rail is drawn, and its pieces, which avoid joints that do not slide on it.

        A shorter rail, or the other side, is preferred to two pieces with the joint between them.
        """
        a, b = ends
        along = (b - a) / abs(b - a)
        joints = [self.at[name] for name in self.names if name != rail.rider]

        def near(begin: complex, end: complex) -> list[float]:
            ways = ((joint - begin) * along.conjugate() for joint in joints)
            return [
                way.real for way in ways if abs(way.imag) < OFF_JOINT and -OFF_JOINT < way.real < abs(end - begin) + OFF_JOINT
            ]

        for way, less in itertools.product((side, -side), (0.0, RAIL - LEAST_RAIL)):
            begin, end = a + BLOCK[1] * way + less * along, b + BLOCK[1] * way - less * along
            if not near(begin, end):
                return way, [(begin, end)]
        begin, end = a + BLOCK[1] * side, b + BLOCK[1] * side
        cuts = [0.0, *(reach for at in sorted(near(begin, end)) for reach in (at - OFF_JOINT, at + OFF_JOINT)), abs(end - begin)]
        pieces = [(begin + low * along, begin + high * along) for low, high in zip(cuts[::2], cuts[1::2], strict=True)]
        return side, [piece for piece, low, high in zip(pieces, cuts[::2], cuts[1::2], strict=True) if high - low > PITCH]

    def track(self, track: Track) -> None:
        """Draw a ring whole if it has room, else the part of a fixed circle near its wheel, hatched on the solid side.

        The radius to the wheel is drawn too.
        """
        middle = self.at[track.centre]
        radius = abs(self.at[track.rim] - middle)
        wheel = wheel_on(self.outline, self.poses.pose(0), track)
        if not radius or wheel is None:
            return
        out = self.at[wheel.contact] - middle
        self.sheet.line(middle, middle + radius * out / abs(out), THIN)
        left, top, right, bottom = self.sheet.field
        has_room = left <= middle.real - radius and middle.real + radius <= right
        has_room = has_room and top <= middle.imag - radius and middle.imag + radius <= bottom
        half = math.pi if track in self.rings and has_room else min(math.pi, max(35.0 / radius, 0.5))
        steps = math.ceil(2 * half * radius / PITCH)
        arc = [middle + radius * out / abs(out) * cmath.exp(1j * half * (2 * k / steps - 1)) for k in range(steps + 1)]
        kept = [p for p in arc if inside(p - 0.01, p + 0.01, self.sheet.field)]
        self.sheet.path(kept, OUTLINE)
        solid = inward(self.outline, self.poses.pose(0), track)
        for a, b in itertools.pairwise(kept):
            self.sheet.hatch(a, b, solid * (middle - a))

    def hinge(self, name: str) -> None:
        """Draw a hinge of the frame: a triangle on hatched ground, on the side away from the links."""
        at, down = self.at[name], self.ground(name)
        side = 1j * down
        foot = at + 5.0 * down
        self.sheet.path([at, foot + 2.9 * side, foot - 2.9 * side], RING, closed=True)
        self.sheet.line(foot - 4.6 * side, foot + 4.6 * side, FRAME)
        self.sheet.hatch(foot - 4.6 * side, foot + 4.6 * side, down)
        self.grounds.append((foot - 4.6 * side, foot + 4.6 * side))
        self.sheet.boxes.append(around([(at + 3.5 * down, 4.0)]))

    def in_ground(self, place: complex) -> bool:
        """Return whether a place lies in the symbol of a hinge below its ring, where the end of an arrow cannot be seen."""
        offs = ((place - self.at[name]) * self.ground(name).conjugate() for name in self.outline.hinges)
        return any(JOINT < off.real < GROUND and abs(off.imag) < HALF_GROUND for off in offs)

    def at_joint(self, place: complex) -> bool:
        """Return whether a place lies on the ring of a joint, or so near to it that an arrow would end in it."""
        return any(abs(self.at[name] - place) < 1.4 * JOINT for name in self.names)

    def ground(self, name: str) -> complex:
        """Return the direction on the sheet from a hinge to its ground: below, as in a textbook, unless a link hides it there."""
        return hinge_ground(self.outline, self.place, name).conjugate()

    # what moves

    def bar(self, bar: Bar) -> None:
        """Draw a link: lines through its points, filled where it is bent, or a rack."""
        data = f' data-link="{plain(bar.link)}"'
        if contact := self.racks.get(bar.link):
            self.rack(bar, contact)
        for a, b in itertools.pairwise(bar.corners):
            ends = f' data-from="{plain(a)}" data-to="{plain(b)}"'
            self.sheet.line(self.at[a], self.at[b], LINK, data + ends, heavy=True)
        for a, b, c in zip(bar.corners, bar.corners[1:], bar.corners[2:], strict=False):
            self.corner(a, b, c)

    def corner(self, a: str, b: str, c: str) -> None:
        """Fill the angle of a bent link, to show that it is rigid there."""
        arms = [self.at[name] - self.at[b] for name in (a, c)]
        if all(arms) and abs((arms[0].conjugate() * arms[1]).imag) > 0.05 * abs(arms[0]) * abs(arms[1]):
            tips = [self.at[b] + arm / abs(arm) * min(5.0, abs(arm)) for arm in arms]
            self.sheet.path([self.at[b], *tips], 'fill="#999"', closed=True)

    def wheel(self, wheel: Wheel) -> None:
        """Draw a wheel with the radius to its contact."""
        centre, contact = self.at[wheel.centre], self.at[wheel.contact]
        self.sheet.circle(centre, abs(contact - centre), OUTLINE, f' data-link="{plain(wheel.link)}"', rim=True)
        self.sheet.line(centre, contact, THIN)

    def slot_line(self, slot: Slot) -> list[complex]:
        """Return the line of a slot (mm): from its point at right angles to the line, then along it past the farthest rider."""
        beside, low, high = self.poses.line(slot)
        at, along = self.place[slot.at], complex(self.poses.along(slot.base, slot.toward)[self.row])
        corners = next((bar.corners for bar in self.outline.bars if bar.link == slot.link), ())
        own = [(self.place[name] - at) * along.conjugate() for name in corners]
        on_line = [0.0, *(p.real for p in own if abs(p.imag - beside) <= ALIGNED * max(map(abs, own), default=0.0))]
        more = BEYOND / self.mm
        first = min(on_line) if min(on_line) <= low else low - more
        last = max(on_line) if max(on_line) >= high else high + more
        foot = at + 1j * along * beside
        ends = [self.put(foot + along * first), self.put(foot + along * last)]
        if abs(beside) <= ALIGNED * (abs(first) + abs(last)):
            return ends
        return [ends[0], self.put(foot), self.put(at), self.put(foot), ends[1]]

    def slot(self, slot: Slot) -> None:
        """Draw the line on which a block slides, as part of its link."""
        for a, b in itertools.pairwise(self.slot_line(slot)):
            if a != b:
                self.sheet.line(a, b, LINK, f' data-link="{plain(slot.link)}" data-slot=""', heavy=True)

    def block(self, block: Block) -> None:
        """Draw the block of a slider, or a sleeve: a block with open ends through which the bar is seen."""
        at = self.at[block.at]
        along = complex(self.poses.along(block.base, block.toward)[self.row]).conjugate()
        long, high = BLOCK[0] * along, BLOCK[1] * 1j * along
        corners = (at + long + high, at - long + high, at - long - high, at + long - high)
        self.sheet.boxes.append(around((corner, 0.0) for corner in corners))
        if not block.open:
            self.sheet.path(corners, RING, closed=True)
            return
        name = f' data-sleeve="{plain(block.link)}"'
        self.sheet.path(corners, f'fill="white"{name}', closed=True)
        for side in (high, -high):
            self.sheet.line(at - long + side, at + long + side, 'stroke="black" stroke-width="0.5"')

    @cached_property
    def rings(self) -> list[Track]:
        """Return the fixed circles inside which wheels roll; they are drawn whole."""
        return [track for track in self.outline.tracks if inward(self.outline, self.poses.pose(0), track) < 0]

    @cached_property
    def racks(self) -> dict[str, str]:
        """Return the racks, link -> contact with its gear."""
        return {rack.link: rack.contact for rack in racks(self.outline, self.poses.pose(0))}

    def rack(self, bar: Bar, contact: str) -> None:
        """Draw a rack as a bar from its joint beyond its gear, on the side away from the gear."""
        at, touch = self.at[bar.corners[0]], self.at[contact]
        if at == touch:
            return
        along = (touch - at) / abs(touch - at)
        gear = next(self.at[wheel.centre] for wheel in self.outline.wheels if wheel.contact == contact)
        side = 1j * along * BLOCK[1] * (1 if dot(1j * along, gear - touch) < 0 else -1)
        end = touch + 12 * along
        self.sheet.path([at, end, end + side, at + side], RING, closed=True)

    def spot(self, name: str) -> str:
        """Return SVG attributes with a joint's name, its position in the mechanism (m), and the mm per metre of this drawing."""
        at = self.place[name]
        return f' data-joint="{plain(name)}" data-at="{at.real:.6g} {at.imag:.6g}" data-mm="{self.mm:.6g}"'

    def joint(self, name: str, data: str = "") -> None:
        """Draw a joint as a ring; a mere point of a link as a dot."""
        if any(name == wheel.contact for wheel in self.outline.wheels):
            self.sheet.circle(self.at[name], 0.7, DOT, data)
            return
        members = sum(name in bar.corners for bar in self.outline.bars)
        pinned = name in self.outline.hinges or any(name == block.at for block in self.outline.blocks)
        ring = members > 1 or pinned or any(name == wheel.centre for wheel in self.outline.wheels)
        self.sheet.circle(self.at[name], JOINT if ring else 0.9, RING if ring else DOT, data)
