"""One row of a motion -> what stands on the paper before anything is constructed.

Enters: velocity equations (for the formulas of points, rails and drives) and a row.  Leaves: `Sketch`.
Used by `graph_check.py`.  What slides or rolls where is told by the joints, which go by names: a point that merely happens
to lie on a rail slides on nothing.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.plans.instant_centres import cross
from coursework.drawing.plans.pose import Body, Pose
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import symbol
from coursework.mechanism.joints import FRAME, linkage
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.variant.formula.tree import named
from coursework.variant.record.variant import Link, Variant
from coursework.words.sentences import say

# A contact touches what it touches at the start, where positions are exact but for rounded data of a task sheet.
INCIDENT = 1e-6
# Below this cosine one component of a driven velocity says nothing about the speed along a rail.
STEEP = 1e-6


@dataclass(frozen=True, slots=True)
class Rail:
    """A straight guide through `at` (m) along a unit vector; `point` slides or `rolls` on it and has left it by `off` m."""

    at: complex
    along: complex
    point: str
    rolls: bool
    off: float


@dataclass(frozen=True, slots=True)
class Track:
    """A fixed circle (m) on which the contact `point` of a wheel rolls; it has left it by `off` m."""

    centre: complex
    radius: float
    point: str
    off: float


@dataclass(frozen=True, slots=True)
class Sketch:
    """The position: `pose` for the construction, and what only the drawing needs.

    `start` holds the positions of row 1; `wheels` link -> (centre, contact); `racks` link -> contact with its gear;
    `moving` the points of links, contacts apart, that are not at rest; `outline`, `poses` and `row` (from 0) are what is painted.
    """

    pose: Pose
    rails: tuple[Rail, ...]
    tracks: tuple[Track, ...]
    hinges: tuple[str, ...]
    links: tuple[Link, ...]
    start: Mapping[str, complex]
    wheels: Mapping[str, tuple[str, str]]
    racks: Mapping[str, str]
    moving: tuple[str, ...]
    notes: tuple[str, ...]
    outline: Outline
    poses: Poses
    row: int


def read_sketch(mechanism: Mechanism, equations: VelocityEquations) -> Callable[[Motion, int], Sketch]:
    """Return `read(motion, row)` (row from 0), compiled once for every row."""
    outline = read_outline(mechanism)
    assert outline is not None
    variant, symbols = with_links(equations.variant, outline), equations.symbols
    posed = read_poses(outline, equations)
    wanted: dict[str, Any] = {}

    def vector(key: str, components: Any) -> None:
        wanted[f"{key}.x"], wanted[f"{key}.y"] = components

    for name, components in symbols.vectors.items():
        vector(name, components)
    for index, (through, angle) in enumerate(variant.frame.rails):
        vector(f"rail {index}", symbols.vector(through))
        wanted[f"angle {index}"] = symbols.scalar(angle)
    for index, (centre, radius) in enumerate(variant.frame.circles):
        vector(f"circle {index}", symbols.vector(centre))
        wanted[f"radius {index}"] = symbols.scalar(radius)
    for law in variant.drive:
        wanted[f"drive {law.name}"] = symbol(law.name)
    rows = compile_rows(equations, list(wanted.values()), 0)
    names = tuple(symbols.vectors)

    def read(motion: Motion, row: int) -> Sketch:
        both = [0, row]
        values = rows(motion.t[both], motion.coordinates[both])
        first, here = (_Values(dict(zip(wanted, map(float, line), strict=True))) for line in values)
        return _Reader(variant, names, first, here).sketch(outline, posed(motion.t, motion.coordinates), row)

    return read


def with_links(variant: Variant, outline: Outline) -> Variant:
    """Return a variant with the links, hinges and guides of its outline where it lists fewer: those of groups, carrier arms."""
    listed = {link.name for link in variant.links}
    slides = {block.at: slot.link for block in outline.blocks if block.open for slot in outline.slots if block.at in slot.riders}
    more = []
    for bar in outline.bars:
        corners = tuple(name for name in bar.corners if not name.startswith("~"))
        if bar.link not in listed and corners:
            own = next((slides[block.at] for block in outline.blocks if block.link == bar.link and block.at in slides), None)
            more.append(Link(bar.link, corners, bar.rate or None, None, None, own))
    rails = variant.frame.rails
    if not variant.links:
        points = dict(outline.points)
        rails = tuple((named(r.rider), points[r.toward].args[1].args[1]) for r in outline.rails if r.rider)
    hinges = tuple(name for name in outline.hinges if not name.startswith("~"))
    frame = replace(variant.frame, hinges=hinges, rails=rails)
    return replace(variant, links=(*variant.links, *more), frame=frame)


@dataclass(frozen=True, slots=True)
class _Values:
    """The numbers of one row, by key."""

    by_key: Mapping[str, float]

    def scalar(self, key: str) -> float:
        return self.by_key[key]

    def vector(self, key: str) -> complex:
        return complex(self.by_key[f"{key}.x"], self.by_key[f"{key}.y"])


class _Reader:
    """Puts names and numbers of one row together."""

    def __init__(self, variant: Variant, names: tuple[str, ...], first: _Values, here: _Values) -> None:
        self.variant, self.here = variant, here
        self.first = first
        self.names = names
        self.start = {name: first.vector(name) for name in names}
        self.bodies = [_body(link) for link in variant.links]
        self.near = INCIDENT * Pose(self.start, tuple(self.bodies), frozenset(), {}, {}, {}).size
        self.wheels = {link.name: (link.wheel, link.contact) for link in variant.links if link.wheel and link.contact}
        joints = linkage(variant, {})
        self.hinges = joints.points(lambda joint: joint.pins and FRAME in joint.bodies) if joints else ()
        self.contacts = set(joints.points(lambda joint: not joint.holders)) if joints else set()
        self.sliding = set(joints.points(lambda joint: joint.kind.slides and FRAME in joint.bodies)) if joints else set()
        self.notes: list[str] = []

    def sketch(self, outline: Outline, poses: Poses, row: int) -> Sketch:
        rails = self.rails()
        guided = {rail.point: rail.along for rail in rails if rail.point and not rail.rolls}
        tracks = self.tracks()
        resting = {r.point for r in rails if r.rolls} | {t.point for t in tracks} | self.on_plain_rails(rails)
        resting -= {contact for centre, contact in self.wheels.values() if centre in self.hinges}
        bodies = [replace(b, guide=guided[b.points[0]]) if _is_slider(b, guided) else b for b in self.bodies]
        racks = self.racks(bodies, resting)
        bodies = [replace(b, points=(*b.points, racks[b.name])) if b.name in racks else b for b in bodies]
        fixed = frozenset({*self.hinges, *resting})
        drive = {law.name: self.here.scalar(f"drive {law.name}") for law in self.variant.drive}
        driven = {name: v for name in self.names if (v := _driven(name, drive, guided)) is not None and name not in fixed}
        rates = {rate: drive[rate] for rate in self.variant.known_rates}
        positions = {name: self.here.vector(name) for name in self.names}
        moving = dict.fromkeys(name for body in self.bodies for name in body.points if name not in fixed | self.contacts)
        sliding = {block.at: block.link for block in outline.blocks if block.open}
        sleeves = {
            slot.link: (rider, complex(poses.along(slot.base, slot.toward)[row]), sliding[rider])
            for slot in outline.slots
            for rider in slot.riders
            if rider in sliding
        }
        pose = Pose(positions, tuple(bodies), fixed, guided, driven, rates, sleeves)
        return Sketch(
            pose, rails, tracks, self.hinges, self.variant.links, self.start, self.wheels, racks, tuple(moving),
            tuple(self.notes), outline, poses, row,
        )  # fmt: skip

    def rails(self) -> tuple[Rail, ...]:
        """Return the rails; what slides or rolls on one is the point it goes `through`."""
        known = self.sliding | self.contacts
        found = []
        for index, (through, _) in enumerate(self.variant.frame.rails):
            along = cmath.rect(1.0, self.here.scalar(f"angle {index}"))
            at, begin = self.here.vector(f"rail {index}"), self.first.vector(f"rail {index}")
            point = through.name if through.op == "name" and through.name in known else ""
            if not point:
                self.notes.append(say("drawing.empty_rail", rail=index + 1))
            found.append(Rail(at, along, point, point in self.contacts, cross(along, at - begin) if point else 0.0))
        return tuple(found)

    def on_plain_rails(self, rails: tuple[Rail, ...]) -> set[str]:
        """Return the contacts that lie on a rail which is given by a fixed point."""
        plain = [(self.first.vector(f"rail {index}"), rail.along) for index, rail in enumerate(rails) if not rail.point]
        return {name for name in self.contacts for at, along in plain if abs(cross(self.start[name] - at, along)) <= self.near}

    def tracks(self) -> tuple[Track, ...]:
        """Return the circles of the frame with the contact that lies on each."""
        found = []
        for index in range(len(self.variant.frame.circles)):
            centre, radius = self.here.vector(f"circle {index}"), abs(self.here.scalar(f"radius {index}"))
            for _, contact in self.wheels.values():
                if abs(abs(self.start[contact] - self.first.vector(f"circle {index}")) - radius) <= self.near:
                    off = abs(self.here.vector(contact) - centre) - radius
                    found.append(Track(centre, radius, contact, off))
        return tuple(found)

    def racks(self, bodies: list[Body], resting: set[str]) -> dict[str, str]:
        """Return the racks: a contact that lies on nothing fixed belongs to the one slider whose rail runs through it."""
        found: dict[str, str] = {}
        for link, (_, contact) in self.wheels.items():
            shared = sum(contact in body.points for body in bodies) > 1
            touching = [
                body for body in bodies
                if body.guide and abs(cross(self.start[contact] - self.start[body.points[0]], body.guide)) <= self.near
            ]  # fmt: skip
            if contact not in resting and not shared and len(touching) == 1:
                found[touching[0].name] = contact
                self.notes.append(say("drawing.drives", link=touching[0].name, wheel=link, contact=contact))
        return found


def _body(link: Link) -> Body:
    points = dict.fromkeys(name for name in (*link.points, link.wheel, link.contact) if name)
    return Body(link.name, tuple(points), link.rate)


def _is_slider(body: Body, guided: Mapping[str, complex]) -> bool:
    """Return whether a link is a block or rack: one point, in a straight guide, and no rate because it does not turn."""
    return body.rate is None and len(body.points) == 1 and body.points[0] in guided


def _driven(name: str, drive: Mapping[str, float], guided: Mapping[str, complex]) -> complex | None:
    """Return the velocity a drive gives to a point: both components, or one along its rail."""
    x, y = drive.get(f"V{name}x"), drive.get(f"V{name}y")
    if x is not None and y is not None:
        return complex(x, y)
    along = guided.get(name, 0j)
    if x is not None and abs(along.real) > STEEP:
        return along * (x / along.real)
    return along * (y / along.imag) if y is not None and abs(along.imag) > STEEP else None
