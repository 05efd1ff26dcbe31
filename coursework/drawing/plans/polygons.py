"""Plans of velocities and accelerations: every vector of the polygons of a mechanism, for all rows at once.

Enters: an `Outline`, velocity equations, a motion and its accelerations.  Leaves: `Polygons`, vectors in m/s and m/s².
Used by `plans.py`, `polygon_sheet.py` and `steps.py`.
A dyad needs no rule of its own: a point is found where two known lines meet, each across a link, along a guide or along a
link on which it slides.  Source: Ponomarev, coursework guide; theory of mechanisms, method of plans.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from coursework.drawing.outline.outline import Bar, Outline
from coursework.drawing.plans.moving import Complex, Kinematics, Moving
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array

POLE = "pole"
VELOCITY, ACCELERATION = "velocity", "acceleration"
UNITS = {VELOCITY: "m/s", ACCELERATION: "m/s²"}


@dataclass(frozen=True, slots=True)
class Segment:
    """One vector of a plan in every row: `kind` absolute, relative, normal, tangential, coriolis or sliding; `start` to `end`.

    `start` is "pole" or a point's name; "B'" is the point of the guide-carrying link under B.
    """

    plan: str
    kind: str
    start: str
    end: str
    vector: Complex


@dataclass(frozen=True, slots=True)
class Line:
    """A line on which a point's image lies: `kind` "bar", "rail", "wheel" or "slot"; drawn from the image of `base`."""

    kind: str
    base: str
    link: str = ""


@dataclass(frozen=True, slots=True)
class Found:
    """How the image of a point was found: `rule` and the lines that meet in it."""

    rule: str
    point: str
    lines: tuple[Line, ...] = ()


@dataclass(frozen=True, slots=True)
class Polygons:
    """All vectors of one motion at times `t` (s), and how each point was `found`, in the order of drawing."""

    t: Array
    segments: tuple[Segment, ...]
    found: tuple[Found, ...]


def polygons(
    outline: Outline, equations: VelocityEquations, motion: Motion, accelerations: Array,
    stretching: frozenset[frozenset[str]] = frozenset(),
) -> Polygons:  # fmt: skip
    """Return the plans of every row of a motion; `accelerations` (n, k) as its velocities.

    `stretching` are pairs of points of a link whose distance changes: there one slides on the link.
    """
    plan = _Plan(outline, Kinematics(outline, equations, motion, accelerations), stretching)
    plan.draw()
    return Polygons(motion.t, tuple(plan.segments.values()), tuple(plan.found))


class _Plan:
    """The polygons while they are drawn: which images there are, which links turn in a known way."""

    def __init__(self, outline: Outline, kinematics: Kinematics, stretching: frozenset[frozenset[str]]) -> None:
        self.outline, self.kinematics, self.stretching = outline, kinematics, stretching
        self.segments: dict[tuple[str, str, str, str], Segment] = {}
        self.found: list[Found] = []
        self.images: list[str] = [*outline.hinges]
        self.turning: set[str] = set()
        self.rails = {rail.rider: rail for rail in outline.rails if rail.rider and not rail.rolls}
        self.bars = [bar for bar in outline.bars if bar.corners]
        self.wheels = {wheel.link: wheel for wheel in outline.wheels}
        self.names = [name for bar in self.bars for name in bar.corners]

    def draw(self) -> None:
        driven = {rate for rate, _ in self.outline.cranks}
        for name in self.outline.driven:
            self.place(name, "given")
        self.turning.update(bar.link for bar in self.bars if bar.rate in driven)
        while self.carried() or self.rolled() or self.slid() or self.met() or self.solved():
            pass

    # how images are found, the simplest way first

    def carried(self) -> bool:
        """Place the points of a link whose turning is known."""
        for bar in self.bars:
            if len([name for name in bar.corners if name in self.images]) > 1 and bar.link not in self.turning:
                self.turning.add(bar.link)
                return True
            base = self.base(bar)
            if base and bar.link in self.turning:
                for name in bar.corners:
                    if name not in self.images:
                        self.along_bar(bar, base, name)
                        crank = bar.rate in {rate for rate, _ in self.outline.cranks}
                        rule = "turned" if crank else "similar"
                        if frozenset((base, name)) in self.stretching:
                            rule = "stretches"
                        self.place(name, rule, (Line("bar", base, bar.link),))
                        return True
        return False

    def rolled(self) -> bool:
        """Place the contact of a wheel whose centre is known."""
        for wheel in self.outline.wheels:
            if wheel.centre in self.images and wheel.contact not in self.images:
                bar = next(bar for bar in self.bars if bar.link == wheel.link)
                self.turning.add(bar.link)
                contact = self.kinematics.carried(bar, wheel.centre, self.kinematics.points[wheel.contact].at)
                self.kinematics.points[wheel.contact] = contact
                self.along_bar(bar, wheel.centre, wheel.contact)
                self.place(wheel.contact, "rolls", (Line("wheel", wheel.centre, wheel.link),))
                return True
        return False

    def slid(self) -> bool:
        """Place the point of a link under what slides on it, and with it the link."""
        for slot in self.outline.slots:
            bar = next(bar for bar in self.bars if bar.link == slot.link)
            for rider in slot.riders:
                if rider not in self.images or bar.link in self.turning:
                    continue
                base = self.base(bar)
                guided = next((name for name in bar.corners if name in self.rails), "")
                if not base and not (guided and not bar.rate):
                    continue
                self.turning.add(bar.link)
                under = self.over(bar, base or guided, rider)
                across = Line("bar", base, bar.link) if base else Line("rail", POLE, bar.link)
                self.found.append(Found("slide", under, (across, Line("slot", rider, bar.link))))
                if not base:
                    self.place(guided, "translates", (Line("rail", POLE, bar.link),))
                return True
        return False

    def met(self) -> bool:
        """Place a point where two known lines meet."""
        for name in dict.fromkeys(self.names):
            if name in self.images:
                continue
            lines = [*self.lines(name)]
            if len(lines) > 1:
                for line in lines[:2]:
                    self.along(line, name)
                self.place(name, "lines", tuple(lines[:2]))
                return True
        return False

    def solved(self) -> bool:
        """Place what no two lines give: its velocity is solved from the same geometry."""
        for bar in self.bars:
            base = self.base(bar)
            for name in bar.corners:
                if base and name not in self.images:
                    self.along_bar(bar, base, name)
                    self.place(name, "solved", (Line("bar", base, bar.link),))
                    return True
        rest = next((name for name in self.names if name not in self.images), "")
        if rest:
            self.place(rest, "solved")
        return bool(rest)

    def lines(self, name: str) -> Iterator[Line]:
        """Yield the lines on which the image of a point lies."""
        if name in self.rails:
            yield Line("rail", POLE)
        for slot in self.outline.slots:
            if name in slot.riders and slot.link in self.turning and self.base(self.bar(slot.link)):
                yield Line("slot", name, slot.link)
        for wheel in self.outline.wheels:
            if name == wheel.centre and self.rests(wheel.contact):
                yield Line("wheel", wheel.contact, wheel.link)
        for bar in self.bars:
            base = self.base(bar)
            if name in bar.corners and base and bar.link not in self.turning:
                yield Line("bar", base, bar.link)

    def rests(self, contact: str) -> bool:
        """Return whether a contact rolls on what is fixed."""
        wheel = next(wheel for wheel in self.outline.wheels if wheel.contact == contact)
        moving = self.kinematics.carried(self.bar(wheel.link), wheel.centre, self.kinematics.points[contact].at)
        speed = np.max(np.abs(self.kinematics.points[wheel.centre].velocity), initial=0.0)
        return bool(np.max(np.abs(moving.velocity), initial=0.0) <= 1e-9 * speed)

    def bar(self, link: str) -> Bar:
        return next(bar for bar in self.bars if bar.link == link)

    def base(self, bar: Bar) -> str:
        """Return the point of a link from which the others are drawn: a pivot of the frame, else the first image."""
        there = [name for name in bar.corners if name in self.images]
        return next((name for name in there if name in self.outline.hinges), there[0] if there else "")

    # what is drawn

    def place(self, name: str, rule: str, lines: Sequence[Line] = ()) -> None:
        """Draw the image of a point from the pole."""
        moving = self.kinematics.points[name]
        self.segment(VELOCITY, "absolute", POLE, name, moving.velocity)
        self.segment(ACCELERATION, "absolute", POLE, name, moving.acceleration)
        self.images.append(name)
        self.found.append(Found(rule, name, tuple(lines)))

    def along(self, line: Line, name: str) -> None:
        """Draw what leads along a line to the image of a point."""
        if line.kind == "bar":
            self.along_bar(self.bar(line.link), line.base, name)
        elif line.kind == "slot":
            bar = self.bar(line.link)
            self.over(bar, self.base(bar), name)

    def along_bar(self, bar: Bar, base: str, name: str) -> None:
        """Draw the motion of a point about another of its link."""
        if frozenset((base, name)) in self.stretching:
            self.over(bar, base, name)
        else:
            self.about(bar, base, name, self.kinematics.points[name])

    def about(self, bar: Bar, base: str, name: str, moving: Moving) -> None:
        start = self.kinematics.points[base]
        fixed = base in self.outline.hinges
        omega, _ = self.kinematics.turning(bar)
        relative = moving.acceleration - start.acceleration
        normal = -omega * omega * (moving.at - start.at)
        begin = POLE if fixed else base
        if not fixed:
            self.segment(VELOCITY, "relative", base, name, moving.velocity - start.velocity)
        self.segment(ACCELERATION, "normal", begin, name, normal)
        self.segment(ACCELERATION, "tangential", begin, name, relative - normal)
        if not fixed:
            self.segment(ACCELERATION, "relative", base, name, relative)

    def over(self, bar: Bar, base: str, rider: str) -> str:
        """Draw the point of a link under one that slides on it, and the way of that one from it; return its name."""
        marks = [segment.end for segment in self.segments.values() if segment.end.startswith(f"{rider}'")]
        under = rider + "'" * (1 + len(max(marks, default=rider, key=len)) - len(rider))
        moving = self.kinematics.points[rider]
        below = self.kinematics.carried(bar, base, moving.at)
        omega, _ = self.kinematics.turning(bar)
        if np.any(omega) or base in self.outline.hinges:
            self.about(bar, base, under, below)
        self.segment(VELOCITY, "absolute", POLE, under, below.velocity)
        self.segment(ACCELERATION, "absolute", POLE, under, below.acceleration)
        sliding = moving.velocity - below.velocity
        coriolis = 2j * omega * sliding
        self.segment(VELOCITY, "sliding", under, rider, sliding)
        self.segment(ACCELERATION, "coriolis", under, rider, coriolis)
        self.segment(ACCELERATION, "sliding", under, rider, moving.acceleration - below.acceleration - coriolis)
        return under

    def segment(self, plan: str, kind: str, start: str, end: str, vector: Complex) -> None:
        """Write a vector down, once."""
        self.segments.setdefault((plan, kind, start, end), Segment(plan, kind, start, end, vector))
