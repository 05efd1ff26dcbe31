"""What a student reads off the drawing: lengths to half a millimetre, and the value that follows from each by one relation.

Enters: a `Sketch`, the `Findings`, the sheet's layout, the plan of velocities, the table.  Leaves: `Reading`s in order.
Used by `graph_check.py` and `construction.py`.  Source: Ponomarev, coursework guide, graph-analytical check.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from coursework.drawing.check_sheet.graph_words import centre_letter, lowered, omega_name
from coursework.drawing.check_sheet.instant_centres import Centre, Findings
from coursework.drawing.check_sheet.layout import Layout
from coursework.drawing.check_sheet.sketch import Body, Sketch
from coursework.drawing.paper.symbols import decimal, image
from coursework.drawing.plans.plan_scale import READ, read_length
from coursework.system.frozen import changing, frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.check_plan import CheckPlan
    from coursework.drawing.plans.vectors import Found


@frozen
class Reading:
    """One quantity of the check.

    `name` is ω₃ or V_C, a magnitude in `unit`; `length` names the distance that it needs, `read` is that distance in mm of paper.
    `read` is None if the distance is given, not needed or off the sheet; off the sheet it is `computed` (mm), to as many digits.
    `relation` says how the value follows, `found` is the value, `table` that of the table (nan if none).  `explained` is the
    relative error that half the last digit of every length used can cause at worst: the sum of their relative errors.
    `rests` says whether any of them was read; `images` are the small letters of a length in the plan.
    """

    name: str
    length: str
    read: float | None
    relation: str
    found: float
    table: float
    unit: str
    explained: float
    computed: float | None = None
    images: str = ""
    rests: bool = False

    @property
    def difference(self) -> float:
        """Return (drawing - table) / table, nan if the table has 0."""
        return (self.found - self.table) / self.table if self.table else float("nan")


def read_off(
    sketch: Sketch, findings: Findings, layout: Layout, table: Mapping[str, float], plan: CheckPlan | None
) -> tuple[Reading, ...]:  # fmt: skip
    """Return the readings of a sheet and of its plan; `table` maps names to magnitudes."""
    ruler = _Ruler(sketch, findings, layout, {**table}, plan)
    ruler.work()
    return tuple(ruler.readings)


@frozen
class _Length:
    """A length (m) in a relation: `read` or `computed` in mm of paper; both are None if it is given."""

    name: str
    metres: float
    read: float | None = None
    computed: float | None = None
    images: str = ""
    is_nothing: bool = False  # two images in one place: seen, not measured

    @property
    def part(self) -> float:
        """Return half the last digit as a part of the length, 0 if the length is given or nothing."""
        paper = self.computed if self.read is None else self.read
        return 0.0 if paper is None or self.is_nothing else unsure(paper)


NO_LENGTH = _Length("", 0.0)


def unsure(length: float) -> float:
    """Return half the last digit as a part of a length read (mm), at most 1; it is 1 if the length reads 0.

    >>> unsure(5.0), unsure(0.0)
    (0.05, 1.0)
    """
    return min(1.0, READ / 2 / length) if length else 1.0


@changing
class _Ruler:
    """The working: the speeds and angular velocities found so far from readings, and `parts`, their relative errors."""

    sketch: Sketch
    findings: Findings
    layout: Layout
    table: dict[str, float]
    plan: CheckPlan | None
    speeds: dict[str, float] = field(default_factory=dict)
    omegas: dict[str, float] = field(default_factory=dict)
    parts: dict[str, float] = field(default_factory=dict)
    resting: set[str] = field(default_factory=set)  # names of the values that rest on a reading
    images: dict[str, list[str]] = field(default_factory=dict)
    readings: list[Reading] = field(default_factory=list)

    def work(self) -> None:
        """Work link by link by centres, and image by image if a plan is needed."""
        pose = self.sketch.pose
        self.speeds.update((name, abs(velocity)) for name, velocity in pose.velocities.items())
        self.omegas.update((b.name, abs(pose.rates[b.rate])) for b in pose.bodies if b.rate and b.rate in pose.rates)
        waiting = [body for body in pose.bodies if body.name in self.findings.omegas]
        steps = [*self.plan.polygons.found] if self.plan else []
        while waiting or steps:
            ready = next((body for body in waiting if self.ready(body)), None)
            if ready is not None:
                waiting.remove(ready)
                self.body(ready)
            elif steps:
                self.step(steps.pop(0))
            else:
                self.planned(waiting.pop(0))

    @property
    def by_plan(self) -> tuple[str, ...]:
        """Return the links whose velocities come from the plan."""
        return (*self.findings.planned, *self.findings.beyond)

    # by instantaneous centres

    def ready(self, body: Body) -> bool:
        """Return whether a link can be worked: its centre is known, and so is its rotation or the speed of one of its points."""
        if body.name in self.by_plan or body.name not in self.findings.centres:
            return False
        return body.name in self.omegas or bool(self.carrier(body)) or not self.asked(body)

    def asked(self, body: Body) -> bool:
        """Return whether the angular velocity of a link is to be found: it is no slider and has several points."""
        return not body.guide and len(body.points) > 1

    def carrier(self, body: Body) -> str:
        """Return the point with a known speed that is farthest from the centre, "" if there is none or it lies on the centre."""
        centre = self.findings.centres[body.name]
        apart = {name: self.arm(centre, name) for name in body.points if name in self.speeds}
        farthest = max(apart, key=lambda name: apart[name], default="")
        return farthest if farthest and (centre.at is None or self.to_centre(body, farthest).metres > 0) else ""

    def arm(self, centre: Centre, name: str) -> float:
        return 0.0 if centre.at is None else abs(self.sketch.pose.positions[name] - centre.at)

    def to_centre(self, body: Body, name: str) -> _Length:
        """Return the distance of a point from the centre: given if the centre is named, computed if it is off the sheet."""
        centre = self.findings.centres[body.name]
        called = f"{centre.point or centre_letter(self.sketch) + lowered(body.name)}{name}"
        if centre.point:
            return _Length(called, self.arm(centre, name))
        return self.measured(called, self.arm(centre, name), body.name in self.layout.near)

    def measured(self, called: str, metres: float, on_sheet: bool = True) -> _Length:
        """Return a length as a ruler reads it on the sheet, or computed and rounded in the same way if it runs off the sheet."""
        paper = read_length(metres * 1000 / self.layout.scale)
        metres = paper * self.layout.scale / 1000
        return _Length(called, metres, paper) if on_sheet else _Length(called, metres, computed=paper)

    def body(self, body: Body) -> None:
        """Work one link: its angular velocity from a known speed, then the speeds of its other points."""
        centre = self.findings.centres[body.name]
        if body.name not in self.omegas and self.asked(body):
            known = self.carrier(body)
            if centre.at is None:
                self.omega(body, NO_LENGTH, say("drawing.read.translation"), 0.0)
            else:
                self.turn(body, self.to_centre(body, known), known)
        for name in body.points:
            if name in self.speeds or name in self.sketch.pose.fixed:
                continue
            known = self.carrier(body) if centre.at is None else ""
            if known:
                relation = say("drawing.read.same", point=known)
                self.speed(name, NO_LENGTH, relation, self.speeds[known], f"V_{known}")
            elif centre.at is not None and body.name in self.omegas:
                self.carry(body, self.to_centre(body, name), name)

    def turn(self, body: Body, length: _Length, known: str) -> None:
        """Write down a link's angular velocity from the speed of the point `known` and its distance from a point at rest."""
        relation = say("drawing.read.omega", point=known.replace("'", "′"), length=length.name)
        self.omega(body, length, relation, self.speeds[known] / length.metres, f"V_{known}")

    def carry(self, body: Body, length: _Length, name: str) -> None:
        """Write down the speed of a point from the angular velocity of its link and its distance from a point at rest."""
        relation = say("drawing.read.speed", omega=omega_name(body), length=length.name)
        self.speed(name, length, relation, self.omegas[body.name] * length.metres, omega_name(body))

    # by the plan of velocities

    def step(self, one: Found) -> None:
        """Read what one step of the plan gives: a velocity, the sliding velocity beside it, and rotations that follow now."""
        point, fixed = one.point, self.sketch.pose.fixed
        if one.rule in {"rolls", "meshes"}:
            return
        self.image(one)
        under = one.lines[-1].link if one.rule == "slide" else ""
        if under and one.rider not in fixed and (under, one.rider) not in self.sketch.pose.driven_lengths:
            self.vector(point, one.rider)
        steps = self.plan.polygons.found if self.plan else ()
        specials = [line for found in steps if found.rule == "special" for line in found.lines if line.at == point]
        for line in (*(one.lines if one.rule == "lines" else ()), *specials):
            if line.kind == "slot":
                self.vector(line.base, point)
        for body in self.sketch.pose.bodies:
            if point in body.points or body.name == under:
                there = self.images.setdefault(body.name, [name for name in body.points if name in fixed])
                there.append(point)
                asked = self.asked(body) or body.name == under
                if len(there) > 1 and body.name in self.by_plan and body.name not in self.omegas and asked:
                    self.rotation(body, there[0], point)

    def image(self, one: Found) -> None:
        """Read the velocity of a point from the pole to its image."""
        name, pose = one.point, self.sketch.pose
        if name in self.speeds or name in pose.fixed or (one.rule == "special" and self.plan and not self.plan.moves(name)):
            return
        if one.rule == "solved":
            self.speed(name, NO_LENGTH, say("drawing.read.plan"), abs(self.findings.velocities[name]))
        else:
            self.vector("", name)

    def vector(self, start: str, end: str) -> str:
        """Read the velocity between two images, "" for the pole; return its name."""
        assert self.plan is not None
        called, drawn = f"{end}{start}", self.plan.drawn
        if called not in self.speeds:
            size = abs(drawn[end] - drawn.get(start, 0j))
            length, scale = self.plan.scale.length(size, self.plan.has(start, end))
            read = read_length(length)
            images = f"{image(start)}{image(end)}"
            name = images if start else f"p_v\u00a0{images}"
            relation = say("drawing.read.scaled", length=name, scale=decimal(scale))
            tabled = self.plan.tabled
            if end in tabled:
                self.table.setdefault(f"V_{called}", abs(tabled[end] - tabled.get(start, 0j)))
            self.speed(called, _Length(name, size, read, images=images, is_nothing=not size), relation, read * scale)
        return called

    def rotation(self, body: Body, start: str, end: str) -> None:
        """Find the rotation of a link from the velocity of its point `end`, about a pivot or relative to the point `start`."""
        length = self.between(body, start, end)
        if length.metres:
            self.turn(body, length, end if start in self.sketch.pose.fixed else self.vector(start, end))

    def between(self, body: Body, start: str, end: str) -> _Length:
        """Return the distance of two points of a link: given, or read if one is the point of a guide under its slider."""
        at = self.sketch.pose.positions
        apart = abs(at[end.rstrip("'")] - at[start.rstrip("'")])
        given = start in body.points and end in body.points
        called = f"{start}{end}".replace("'", "")
        return _Length(called, apart) if given else self.measured(called, apart)

    def planned(self, body: Body) -> None:
        """Take the velocities of a link that only all links together determine, without a reading."""
        if self.asked(body) and body.name not in self.omegas:
            self.omega(body, NO_LENGTH, say("drawing.read.plan"), abs(self.findings.omegas[body.name]))
        for name in body.points:
            if name in self.findings.velocities and name not in self.speeds:
                self.speed(name, NO_LENGTH, say("drawing.read.plan"), abs(self.findings.velocities[name]))

    # what is written down

    def omega(self, body: Body, length: _Length, relation: Sentence, found: float, known: str = "") -> None:
        """Write down an angular velocity, found from the value named `known`."""
        name = omega_name(body)
        self.omegas[body.name] = found
        if all(one.name != name for one in self.readings):
            self.note(name, length, relation, found, "rad/s", known)

    def speed(self, point: str, length: _Length, relation: Sentence, found: float, known: str = "") -> None:
        """Write down a speed; it becomes a reading unless the point is at rest or a contact."""
        self.speeds[point] = found
        shown = point in self.sketch.moving or all(point not in body.points for body in self.sketch.pose.bodies)
        self.note(f"V_{point}", length, relation, found, "m/s", known, shown=shown)

    def note(
        self, name: str, length: _Length, relation: Sentence, found: float, unit: str, known: str, *, shown: bool = True
    ) -> None:
        """Write down what was `found` (in `unit`) from a length and the value `known`, with its error; a line if `shown`."""
        part = self.parts[name] = self.parts.get(known, 0.0) + length.part
        if length.read is not None or known in self.resting:
            self.resting.add(name)
        if shown:
            more = (part, length.computed, length.images, name in self.resting)
            tabled = self.table.get(name, float("nan"))
            self.readings.append(Reading(name.replace("'", "′"), length.name, length.read, relation, found, tabled, unit, *more))
