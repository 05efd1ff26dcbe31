"""What a student reads off the drawing: lengths to half a millimetre, and what follows from them by one relation each.

Enters: a `Sketch`, the `Findings`, the scale of the drawing, the values of the table.  Leaves: `Reading`s, in order of working.
Used by `graph_check.py`.  Source: Ponomarev, coursework guide, graph-analytical check.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from coursework.drawing.plans.graph_words import centre_letter, lowered, omega_name
from coursework.drawing.plans.instant_centres import Centre, Findings
from coursework.drawing.plans.pose import Body
from coursework.drawing.plans.sketch import Sketch
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

READ = 0.5  # mm: what a ruler is read to; the error is half of it


@dataclass(frozen=True, slots=True)
class Reading:
    """One quantity of the check.

    `name` is ω₃ or V_C, a magnitude in `unit`; `length` the distance it needs, `read` that distance in mm of paper, None where
    it is given or not needed; `relation` how it follows; `found` its value from what was read, `table` that of the table (nan
    where it has none); `explained` is the part of the value that half the last digit of the ruler can change.
    """

    name: str
    length: str
    read: float | None
    relation: str
    found: float
    table: float
    unit: str
    explained: float

    @property
    def difference(self) -> float:
        """Return how much the drawing is above the table, as a part of the table."""
        return (self.found - self.table) / self.table if self.table else float("nan")


def read_off(sketch: Sketch, findings: Findings, scale: float, table: Mapping[str, float]) -> tuple[Reading, ...]:
    """Return the readings of a drawing 1:`scale`; `table` name -> value, signs aside."""
    ruler = _Ruler(sketch, findings, scale, table)
    ruler.work()
    return tuple(ruler.readings)


class _Ruler:
    """The working: speeds and angular velocities known so far, as read."""

    def __init__(self, sketch: Sketch, findings: Findings, scale: float, table: Mapping[str, float]) -> None:
        self.sketch, self.findings, self.scale, self.table = sketch, findings, scale, table
        self.letter = centre_letter(sketch)
        pose = sketch.pose
        self.speeds = {name: abs(velocity) for name, velocity in pose.velocities.items()}
        self.omegas = {body.name: abs(pose.rates[body.rate]) for body in pose.bodies if body.rate and body.rate in pose.rates}
        self.named: set[str] = set()
        self.readings: list[Reading] = []

    def work(self) -> None:
        """Go from link to link; what no length gives is taken from the plan of all links together."""
        bodies = [body for body in self.sketch.pose.bodies if body.name in self.findings.omegas]
        done: set[str] = set()
        while len(done) < len(bodies):
            ready = next((body for body in bodies if body.name not in done and self.ready(body)), None)
            if ready is not None:
                self.body(ready)
            else:
                ready = next(body for body in bodies if body.name not in done)
                self.planned(ready)
            done.add(ready.name)

    def ready(self, body: Body) -> bool:
        """Return whether a link can be worked: its centre is there and it or a point of it has a known velocity."""
        if body.name in self.findings.planned or body.name not in self.findings.centres:
            return False
        return body.name in self.omegas or bool(self.carrier(body)) or not self.asked(body)

    def asked(self, body: Body) -> bool:
        """Return whether a link has anything to be found."""
        return not body.guide and len(body.points) > 1

    def carrier(self, body: Body) -> str:
        """Return the point with a known speed that lies farthest from the centre, "" where none is apart from it."""
        centre = self.findings.centres[body.name]
        apart = {name: self.arm(centre, name) for name in body.points if name in self.speeds}
        farthest = max(apart, key=lambda name: apart[name], default="")
        return farthest if farthest and (centre.at is None or self.length(centre, farthest) > 0) else ""

    def arm(self, centre: Centre, name: str) -> float:
        return 0.0 if centre.at is None else abs(self.sketch.pose.positions[name] - centre.at)

    def length(self, centre: Centre, name: str) -> float:
        """Return a distance from a centre (m): as given where the centre is a point of the file, else as read."""
        arm = self.arm(centre, name)
        return arm if centre.point else self.read(centre, name) * self.scale / 1000

    def read(self, centre: Centre, name: str) -> float:
        return round(self.arm(centre, name) * 1000 / self.scale / READ) * READ

    def body(self, body: Body) -> None:
        """Work one link: its angular velocity from a known speed, then the speeds of its other points."""
        centre = self.findings.centres[body.name]
        called = f"{self.letter}{lowered(body.name)}" if not centre.point else centre.point
        if body.name not in self.omegas and self.asked(body):
            known = self.carrier(body)
            if centre.at is None:
                self.note(omega_name(body), "", None, say("drawing.read.translation"), 0.0, "rad/s", 0.0)
                self.omegas[body.name] = 0.0
            else:
                length = self.length(centre, known)
                read = None if centre.point else self.read(centre, known)
                self.omegas[body.name] = self.speeds[known] / length
                relation = say("drawing.read.omega", point=known, length=f"{called}{known}")
                self.note(omega_name(body), f"{called}{known}", read, relation, self.omegas[body.name], "rad/s", read or 0.0)
        for name in body.points:
            if name in self.speeds or name in self.sketch.pose.fixed:
                continue
            if centre.at is None:
                known = self.carrier(body)
                if known:
                    self.speeds[name] = self.speeds[known]
                    self.note(f"V_{name}", "", None, say("drawing.read.same", point=known), self.speeds[name], "m/s", 0.0)
            elif body.name in self.omegas:
                read = None if centre.point else self.read(centre, name)
                self.speeds[name] = self.omegas[body.name] * self.length(centre, name)
                relation = say("drawing.read.speed", omega=omega_name(body), length=f"{called}{name}")
                self.note(f"V_{name}", f"{called}{name}", read, relation, self.speeds[name], "m/s", read or 0.0)

    def planned(self, body: Body) -> None:
        """Take a link from the plan of all links together."""
        self.omegas[body.name] = abs(self.findings.omegas[body.name])
        if self.asked(body):
            self.note(omega_name(body), "", None, say("drawing.read.plan"), self.omegas[body.name], "rad/s", 0.0)
        for name in body.points:
            if name in self.findings.velocities and name not in self.speeds and name in self.sketch.moving:
                self.speeds[name] = abs(self.findings.velocities[name])
                self.note(f"V_{name}", "", None, say("drawing.read.plan"), self.speeds[name], "m/s", 0.0)

    def note(self, name: str, length: str, read: float | None, relation: Sentence, found: float, unit: str, ruled: float) -> None:
        """Write a quantity down, once."""
        if name in self.named or (name.startswith("V_") and name.removeprefix("V_") not in self.sketch.moving):
            return
        self.named.add(name)
        explained = min(1.0, READ / 2 / ruled) if ruled else float(read == 0)
        self.readings.append(Reading(name, length, read, relation, found, self.table.get(name, float("nan")), unit, explained))
