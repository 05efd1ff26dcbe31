"""The vectors of plans of velocities and accelerations, as they are drawn one after the other.

Enters: `Kinematics` and which points are joined.  Leaves: `Segment`s and, of each image, how it was `Found`.
Used by `polygons.py`, `polygon_sheet.py`, `steps.py`, `plans.py`, `check_plan.py` and `readings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from coursework.drawing.outline.outline import Bar
from coursework.drawing.plans.moving import Complex, Kinematics, Moving
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
    """A line on which a point's image lies: `kind` "bar", "rail", "wheel" or "slot"; drawn from the image of `base`.

    On a slot `base` is the point of its link under the one that slides, or that one where the former is sought; of a rail
    `link` is the point that runs in it.
    """

    kind: str
    base: str
    link: str = ""


@dataclass(frozen=True, slots=True)
class Found:
    """How the image of a point was found: `rule` and the lines that meet in it; `rider` slides over what a "slide" finds."""

    rule: str
    point: str
    lines: tuple[Line, ...] = ()
    rider: str = ""


@dataclass(frozen=True, slots=True)
class Polygons:
    """All vectors of one motion at times `t` (s), and how each point was `found`, in the order of drawing."""

    t: Array
    segments: tuple[Segment, ...]
    found: tuple[Found, ...]


@dataclass(slots=True)
class Vectors:
    """What is drawn so far: vectors, the `images` of points, and how each was found.  Points in `hinges` are at the pole."""

    kinematics: Kinematics
    hinges: tuple[str, ...]
    stretching: frozenset[frozenset[str]] = frozenset()
    segments: dict[tuple[str, str, str, str], Segment] = field(default_factory=dict)
    images: list[str] = field(default_factory=list)
    found: list[Found] = field(default_factory=list)

    def place(self, name: str, rule: str, lines: Sequence[Line] = ()) -> None:
        """Draw the image of a point from the pole."""
        moving = self.kinematics.points[name]
        self.segment(VELOCITY, "absolute", POLE, name, moving.velocity)
        self.segment(ACCELERATION, "absolute", POLE, name, moving.acceleration)
        self.images.append(name)
        self.found.append(Found(rule, name, tuple(lines)))

    def along_bar(self, bar: Bar, base: str, name: str) -> None:
        """Draw the motion of a point about another of its link."""
        if frozenset((base, name)) in self.stretching:
            self.over(bar, base, name)
        else:
            self.about(bar, base, name, self.kinematics.points[name])

    def about(self, bar: Bar, base: str, name: str, moving: Moving) -> None:
        """Draw how a point moves about the point `base` of its link."""
        start = self.kinematics.points[base]
        fixed = base in self.hinges
        omega, _ = self.kinematics.turning[bar.link]
        relative = moving.acceleration - start.acceleration
        normal = -omega * omega * (moving.at - start.at)
        begin = POLE if fixed else base
        if not fixed:
            self.segment(VELOCITY, "relative", base, name, moving.velocity - start.velocity)
        self.segment(ACCELERATION, "normal", begin, name, normal)
        self.segment(ACCELERATION, "tangential", begin, name, relative - normal)
        if not fixed:
            self.segment(ACCELERATION, "relative", base, name, relative)

    def over(self, bar: Bar, base: str, rider: str, joined: bool = True) -> str:
        """Draw the point of a link under one that slides on it, and the way of that one from it; return its name.

        It is `joined` to the point `base` of the link, unless it is found without it.
        """
        point = rider.rstrip("'")
        marks = [segment.end for segment in self.segments.values() if segment.end.startswith(f"{point}'")]
        under = point + "'" * (1 + len(max(marks, default=point, key=len)) - len(point))
        moving = self.kinematics.points[rider]
        below = self.kinematics.points[under] = self.kinematics.carried(bar, base, moving.at)
        omega, _ = self.kinematics.turning[bar.link]
        if joined and (np.any(omega) or base in self.hinges):
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
