"""One position and the driven velocity -> instantaneous centres, angular velocities, velocities of points, as on paper.

Enters: a `Pose` in SI, points and vectors as complex numbers x + iy.  Leaves: `Findings`.
It uses only positions and known velocities, none of the velocity equations, so it is an independent check of them.
Source: Ponomarev, coursework guide, graph-analytical check (mathematics.md section 3); Aronhold's construction link by link.
Used by `check_plan.py`, `drawing.py`, `graph_check.py`, `graph_words.py`, `layout.py` and `readings.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import field

from coursework.drawing.check_sheet.sketch import Body, Pose
from coursework.system.angles import cross, dot
from coursework.system.frozen import changing, frozen

# Sine of the angle below which two lines count as parallel.  Positions of an Euler row are good to 1e-15, so lines that
# are parallel by construction stay far below it, and a centre 1e9 times farther off than the mechanism is a translation.
PARALLEL = 1e-9
FAR = 100.0  # times the size of the mechanism: a centre farther away fits on no paper, so the link translates


@frozen
class Centre:
    """An instantaneous centre at `at` (m), None for one at infinity (translation); lines from the points `lines` lead to it.

    `lines` is empty for a centre that need not be constructed: a hinge or a contact, named by `point`.
    """

    at: complex | None
    lines: tuple[str, ...] = ()
    point: str = ""


@frozen
class Findings:
    """What the drawing yields, by name: `centres` and `omegas` (rad/s) of links, `velocities` (m/s) of points.

    Links in `planned` have no constructible centre, the centres of links in `beyond` are off the sheet: both follow from the
    plan of velocities.  The geometry does not determine the links in `missing`.  `specials` are the special points of links,
    by name, that the plan of velocities needs.
    """

    centres: Mapping[str, Centre]
    omegas: Mapping[str, float]
    velocities: Mapping[str, complex]
    missing: tuple[str, ...]
    planned: tuple[str, ...] = ()
    beyond: tuple[str, ...] = ()
    specials: Mapping[str, Centre] = field(default_factory=dict)

    @property
    def drawn(self) -> dict[str, Centre]:
        """Return the centres that are drawn: those found without a plan."""
        return {name: centre for name, centre in self.centres.items() if name not in self.planned}


def construct(pose: Pose) -> Findings:
    """Return all that follows from the known velocities and directions; nothing is guessed."""
    paper = _Paper(pose)
    paper.draw()
    planned: tuple[str, ...] = ()
    if any(not paper.finished(body) for body in pose.bodies):
        from coursework.drawing.check_sheet.by_plan import solve_plan

        solved = solve_plan(pose, paper.velocities)
        planned = tuple(body.name for body in pose.bodies if not paper.finished(body) and body.name in solved.omegas)
        paper.take(solved.velocities, {name: solved.omegas[name] for name in planned})
        paper.draw()
    missing = tuple(
        body.name
        for body in pose.bodies
        if (body.name not in paper.omegas and len(body.points) > 1) or not paper.velocities.keys() >= {*body.points}
    )  # nobody asks for the rotation of a block, which has one point
    centres = {name: paper.within_reach(centre) for name, centre in paper.centres.items()}
    return Findings(centres, paper.omegas, paper.velocities, missing, planned)


@changing
class _Paper:
    """What is on the paper so far; every step adds to it and removes nothing."""

    pose: Pose
    centres: dict[str, Centre] = field(default_factory=dict)
    omegas: dict[str, float] = field(default_factory=dict)
    velocities: dict[str, complex] = field(default_factory=dict)
    directions: dict[str, complex] = field(default_factory=dict)
    rates: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.rates.update(self.pose.rates)
        self.directions.update(self.pose.guided)
        for name in sorted(self.pose.fixed):
            self.velocities[name] = 0j
        for name, velocity in self.pose.velocities.items():
            self._move(name, velocity)

    def draw(self) -> None:
        """Repeat the constructions until nothing new is found."""
        known = -1
        while known != (known := self.known()):
            for body in self.pose.bodies:
                self.find_centre(body)
                self.find_omega(body)
                self.carry_on(body)

    def finished(self, body: Body) -> bool:
        """Return whether the angular velocity of a link and the velocities of all its points are known."""
        return body.name in self.omegas and all(name in self.velocities for name in body.points)

    def take(self, velocities: Mapping[str, complex], omegas: Mapping[str, float]) -> None:
        """Write down velocities and angular velocities that were solved elsewhere."""
        for name, velocity in velocities.items():
            self._move(name, velocity)
        for body in self.pose.bodies:
            if body.name in omegas:
                self._turn(body, omegas[body.name])

    def within_reach(self, centre: Centre) -> Centre:
        """Return the centre, at infinity if it is too far away to be found on paper."""
        if centre.at is None or not centre.lines or abs(centre.at - self._at(centre.lines[0])) <= FAR * self.pose.size:
            return centre
        return Centre(None, centre.lines)

    def known(self) -> int:
        return len(self.centres) + len(self.omegas) + len(self.velocities) + len(self.directions)

    def _move(self, name: str, velocity: complex) -> None:
        """Write down the velocity of a point unless it is already known."""
        if name not in self.velocities:
            self.velocities[name] = velocity
            if velocity:
                self.directions.setdefault(name, velocity / abs(velocity))

    def _turn(self, body: Body, omega: float) -> None:
        """Write down the angular velocity of a link, and of all links that have the same rate."""
        self.omegas[body.name] = omega
        if body.rate:
            self.rates.setdefault(body.rate, omega)

    def _at(self, name: str) -> complex:
        return self.pose.positions[name]

    def find_centre(self, body: Body) -> None:
        """Find the centre: a point at rest, or the intersection of the perpendiculars to two known directions."""
        if body.name in self.centres:
            return
        if body.guide:
            self.centres[body.name] = Centre(None)
        elif resting := [name for name in body.points if self.velocities.get(name) == 0]:
            held = [name for name in resting if name in self.pose.fixed]
            self.centres[body.name] = Centre(self._at((held or resting)[0]), point=(held or resting)[0])
        elif centre := self._by_rate(body) or self._by_directions(body) or self._by_proportion(body):
            self.centres[body.name] = centre

    def _by_rate(self, body: Body) -> Centre | None:
        """Return the centre of a link from its known rate and the known velocity of a point, None if either is unknown."""
        moving = [name for name in body.points if name in self.velocities]
        omega = self.rates.get(body.rate or "")
        if omega is None or not moving:
            return None
        return Centre(self._at(moving[0]) + 1j * self.velocities[moving[0]] / omega, (moving[0],)) if omega else Centre(None)

    def _by_directions(self, body: Body) -> Centre | None:
        ways = {name: self.directions[name] for name in body.points if name in self.directions}
        for slide in self.pose.slides:  # the point of a bar inside a sleeve at rest moves along the bar
            if slide.link == body.name and self.velocities.get(slide.rider) == 0:
                ways[slide.rider] = slide.along
        pairs = list(itertools.combinations(ways, 2))
        pairs.sort(key=lambda pair: -abs(cross(ways[pair[0]], ways[pair[1]])))
        for a, b in pairs:
            along_a, along_b = ways[a], ways[b]
            between = self._at(b) - self._at(a)
            if abs(sine := cross(along_a, along_b)) > PARALLEL:
                return Centre(self._at(a) + 1j * along_a * cross(between, 1j * along_b) / sine, (a, b))
            if abs(dot(along_a, between)) > PARALLEL * abs(between):
                return Centre(None, (a, b))
        return None

    def _by_proportion(self, body: Body) -> Centre | None:
        """Return the centre on the common perpendicular of two parallel known velocities, None if there are none."""
        moving = [name for name in body.points if name in self.velocities]
        for a, b in itertools.combinations(moving, 2):
            gap = self.velocities[a] - self.velocities[b]
            between = self._at(b) - self._at(a)
            if abs(gap) <= PARALLEL * abs(self.velocities[a]):
                return Centre(None, (a, b))
            if between:
                return Centre(self._at(a) + between * dot(gap, self.velocities[a]) / abs(gap) ** 2, (a, b))
        return None

    def find_omega(self, body: Body) -> None:
        """Find the angular velocity: velocity over distance from the centre, positive counter-clockwise."""
        centre = self.centres.get(body.name)
        if body.name in self.omegas:
            return
        omega = self.rates.get(body.rate or "")
        if omega is None and centre is not None:
            omega = 0.0 if centre.at is None else self._over_distance(body, centre.at, centre.point)
        for slide in self.pose.slides:
            if slide.block == body.name and slide.link in self.omegas:
                omega = self.omegas[slide.link]
        if omega is not None:
            self._turn(body, omega)

    def _over_distance(self, body: Body, centre: complex, point: str) -> float | None:
        arms = {name: self._at(name) - centre for name in body.points if name in self.velocities}
        far = max(arms, key=lambda name: abs(arms[name]), default="")
        if far and abs(arms[far]) > PARALLEL * self.pose.size:
            return cross(arms[far], self.velocities[far]) / abs(arms[far]) ** 2
        return 0.0 if point and point not in self.pose.fixed and self._held(body, centre) else None

    def _held(self, body: Body, centre: complex) -> bool:
        """Return whether a point's known direction is not across its arm: then a link whose driven point rests does not turn."""
        arms = ((self._at(name) - centre, self.directions[name]) for name in body.points if name in self.directions)
        return any(abs(dot(arm, along)) > PARALLEL * abs(arm) for arm, along in arms)

    def carry_on(self, body: Body) -> None:
        """Write down what the link now determines of its points: the direction and, if ω is known, the velocity."""
        if body.name not in self.centres:
            return
        at = self.centres[body.name].at
        moving = next((name for name in body.points if name in self.velocities), None)
        along = body.guide or next((self.directions[name] for name in body.points if name in self.directions), 0j)
        for name in body.points:
            arm = 0j if at is None else 1j * (self._at(name) - at)
            if at is not None and body.name in self.omegas:
                self._move(name, self.omegas[body.name] * arm)
            elif at is None and moving is not None:
                self._move(name, self.velocities[moving])
            if (towards := along if at is None else arm) and name not in self.pose.fixed:
                self.directions.setdefault(name, towards / abs(towards))
