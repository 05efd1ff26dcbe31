"""The vectors of plans of velocities and accelerations, in the order in which they are drawn.

Enters: `Kinematics` and which points are joined.  Leaves: `Segment`s and, for each image, how it was `Found`.
Used by `polygons.py`, `polygon_sheet.py`, `steps.py`, `plans.py`, `special_points.py`, `check_plan.py` and `readings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

import numpy as np

from coursework.drawing.outline.outline import Bar
from coursework.drawing.plans.moving import Kinematics, Moving
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import changing, frozen

POLE = "pole"
VELOCITY, ACCELERATION = "velocity", "acceleration"
UNITS = {VELOCITY: "m/s", ACCELERATION: "m/s²"}


@frozen
class Segment:
    """One vector of a plan in every row: `kind` absolute, relative, normal, tangential, coriolis or sliding; `start` to `end`.

    `start` is "pole" or a point's name; "B'" is the point of the guide-carrying link under B.  The vector begins at the image of
    `start`, the last part of an acceleration at the tip of its normal or Coriolis part, or at the place `begins` if given.
    """

    plan: str
    kind: str
    start: str
    end: str
    vector: Complex
    begins: Complex | None = None


@frozen
class Line:
    """A line on which a point's image lies, drawn from the image of `base`.

    Its `kind` is "bar", "rail", "wheel", "slot", "sleeve", or "driven" for a length that begins at `base`.  For a slot `base` is
    the point of its link under the rider, or the rider if that point is sought; for a sleeve it is the rider on the link itself.
    For a rail `link` is the point that runs on it.  A line to a special point belongs to the point `at` of its link.
    """

    kind: str
    base: str
    link: str = ""
    at: str = ""


@frozen
class Found:
    """How the image of a point was found: the `rule` and the lines that meet in it; after "slide", `rider` slides over the point.

    `link` is the link of a "special" point.
    """

    rule: str
    point: str
    lines: tuple[Line, ...] = ()
    rider: str = ""
    link: str = ""


@frozen
class Polygons:
    """All vectors of one motion at times `t` (s), and how each image was `found`, in the order of drawing."""

    t: Array
    segments: tuple[Segment, ...]
    found: tuple[Found, ...]


@changing
class Vectors:
    """What is drawn so far: vectors, the `images` of points, and how each was found.  Points in `hinges` lie at the pole."""

    kinematics: Kinematics
    hinges: tuple[str, ...]
    stretching: frozenset[frozenset[str]] = frozenset()
    segments: dict[tuple[str, str, str, str], Segment] = field(default_factory=dict)
    images: list[str] = field(default_factory=list)
    found: list[Found] = field(default_factory=list)
    called: dict[tuple[str, str], str] = field(default_factory=dict)  # (link, rider) -> name of the point under it, not yet drawn

    def place(self, name: str, rule: str, lines: Sequence[Line] = (), link: str = "") -> None:
        """Draw the image of a point from the pole."""
        moving = self.kinematics.points[name]
        self.segment(VELOCITY, "absolute", POLE, name, moving.velocity)
        self.segment(ACCELERATION, "absolute", POLE, name, moving.acceleration)
        self.images.append(name)
        self.found.append(Found(rule, name, tuple(lines), link=link))

    def along_bar(self, bar: Bar, base: str, name: str) -> None:
        """Draw the motion of a point relative to the point `base` of its link."""
        if frozenset((base, name)) in self.stretching:
            self.over(bar, base, name)
        else:
            self.about(bar, base, name, self.kinematics.points[name])

    def about(self, bar: Bar, base: str, name: str, moving: Moving) -> None:
        """Draw the motion of a point about the point `base` of its link, at a fixed distance."""
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
        """Draw the point of a link under a rider, and the sliding of the rider relative to it; return the name of that point.

        If `joined`, it is drawn from the point `base` of the link; otherwise it was found without it.
        """
        under = self.called.pop((bar.link, rider), "") or self.under(rider)
        moving = self.kinematics.points[rider]
        omega, _ = self.kinematics.turning[bar.link]
        below = self.kinematics.carried(bar, base, moving.at)
        if known := self.kinematics.driven.get((bar.link, rider)):  # valid also in a row of a scheme that has drifted
            sliding, second = known
            below = Moving(moving.at, moving.velocity - sliding, moving.acceleration - second - 2j * omega * sliding)
        self.kinematics.points[under] = below
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

    def towards(self, bar: Bar, special: str, line: Line) -> Line:
        """Draw the line of a leg to the image of a special point of a link; return the line as drawn.

        The acceleration begins with the known normal or Coriolis part of the point `line.at`, and goes on with the
        normal part of the special point about that point: both lie on the line of the leg.
        """
        points, base = self.kinematics.points, line.base
        omega, _ = self.kinematics.turning[bar.link]
        start = POLE if line.kind == "rail" or base in self.hinges else base
        before = np.zeros_like(points[special].at)
        if line.kind == "bar":
            turning, _ = self.kinematics.turning[line.link]
            before = -turning * turning * (points[line.at].at - points[base].at)
            self.segment(ACCELERATION, "normal", start, line.at, before)
        elif line.kind == "slot":
            before = self.segments[ACCELERATION, "coriolis", base, line.at].vector
        elif line.kind == "sleeve":
            under = self.kinematics.carried(bar, special, points[base].at)
            line = Line("sleeve", base, line.link, self.called.setdefault((bar.link, base), self.under(base)))
            points[line.at] = under
            before = 2j * omega * (under.velocity - points[base].velocity)
            self.segment(ACCELERATION, "coriolis", start, line.at, before)
        there = points[base] if start != POLE else None
        if there is not None:
            self.segment(VELOCITY, "relative", start, special, points[special].velocity - there.velocity)
            self.segment(ACCELERATION, "relative", start, special, points[special].acceleration - there.acceleration)
        begins = before if there is None else there.acceleration + before
        own = -omega * omega * (points[special].at - points[line.at].at)
        self.segment(ACCELERATION, "normal", line.at, special, own, begins)
        rest = points[special].acceleration - begins - own
        self.segment(ACCELERATION, "tangential", start, special, rest, begins + own)
        return line

    def under(self, rider: str) -> str:
        """Return a name for the point of a link under a rider, with one prime more than those in use."""
        point = rider.rstrip("'")
        marks = [segment.end for segment in self.segments.values() if segment.end.startswith(f"{point}'")]
        return point + "'" * (1 + len(max(marks, default=point, key=len)) - len(point))

    def segment(self, plan: str, kind: str, start: str, end: str, vector: Complex, begins: Complex | None = None) -> None:
        """Record a vector, unless it is there already."""
        self.segments.setdefault((plan, kind, start, end), Segment(plan, kind, start, end, vector, begins))
