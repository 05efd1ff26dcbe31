"""The drawing of the graph-analytical check: mechanism, velocities, centres, true to scale, readable in black and white.

Enters: a `Sketch` and the `Findings`.  Leaves: SVG text, the same on every run, one user unit = 1 mm, size in mm.
Everything a file may name is escaped (`sheet.plain`).
Used by `graph_check.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable
from dataclasses import replace

from coursework.drawing.sheet import BOLD, PITCH, Place, Sheet, Word, inside, middle_of, plain
from coursework.drawing.symbols import decimal
from coursework.plans.foot import draw_foot
from coursework.plans.graph_words import centre_letter
from coursework.plans.instant_centres import Body, Centre, Findings, cross, dot
from coursework.plans.layout import Layout, lay_out
from coursework.plans.sketch import Rail, Sketch, Track
from coursework.sentences import say
from coursework.variant.record import Link

LINK = 'stroke="black" stroke-width="0.8"'
FRAME = 'stroke="black" stroke-width="0.35"'
VELOCITY = 'stroke="black" stroke-width="0.4"'
CONSTRUCTION = 'stroke="black" stroke-width="0.15" stroke-dasharray="2.4 1 0.4 1"'
OUTLINE = 'fill="none" stroke="black" stroke-width="0.35"'
RING = 'fill="white" stroke="black" stroke-width="0.35"'
DOT = 'fill="black" stroke="none"'
READ = 1e4  # 1/m: a place is read off a drawing 1:1 to 0.1 mm
LONGEST_NAME = 12  # letters in a label
SHORTEST = 0.5  # mm: a shorter arrow is none
SMALL = 4.0  # mm: a shorter arrow hides in the joint, so its value is written
GUIDE = 13.0  # mm of a rail to each side
BLOCK = (4.2, 2.4)  # mm, half length and half height of a slider


def draw(
    sketch: Sketch, findings: Findings, row: int, time: float, written: Callable[[str], str] = str, *, upright: bool = False
) -> str:
    """Return the drawing of one row (from 1) at a time (s); `written` puts its sentences into the language of a page.

    On paper a wide sheet stands on its left side; `upright`, as a screen shows it, it does not.
    """
    layout = lay_out(sketch, findings)
    layout = replace(layout, turned=layout.turned and not upright)
    return _Drawing(sketch, findings, layout, written).svg(say("drawing.title", row=row, time=time))


class _Drawing:
    """One sheet being drawn, from what lies behind to what stands in front."""

    def __init__(self, sketch: Sketch, findings: Findings, layout: Layout, written: Callable[[str], str]) -> None:
        self.sketch, self.findings, self.layout, self.written = sketch, findings, layout, written
        self.bodies = {body.name: body for body in sketch.pose.bodies}
        self.at = {name: layout.put(z) for name, z in sketch.pose.positions.items()}
        self.sheet = Sheet(layout.width, layout.height, layout.field)
        self.points = list(dict.fromkeys(name for body in sketch.pose.bodies for name in body.points))
        self.letter = centre_letter(sketch)
        self.marks: list[tuple[Word, list[Place]]] = []
        self.middle = middle_of(self.at[name] for name in self.points)

    def svg(self, title: str) -> str:
        for name, centre in self.findings.centres.items():
            self.construction(name, centre)
        for track in self.sketch.tracks:
            self.track(track)
        for rail in self.sketch.rails:
            self.rail(rail)
        for name in self.sketch.hinges:
            self.hinge(name)
        for rail in self.sketch.rails:
            if rail.point and not rail.rolls:
                self.block(self.at[rail.point], rail.along.conjugate())
        for link in self.sketch.links:
            self.link(link)
        for name in self.points:
            self.joint(name)
        for name in self.points:
            self.velocity(name)
        for name, centre in self.findings.centres.items():
            self.cross(name, centre)
        self.names()
        self.foot(title)
        return self.sheet.svg(turned=self.layout.turned)

    # what is fixed

    def rail(self, rail: Rail) -> None:
        """Draw a rail, hatched on the side where nothing is."""
        along, at = rail.along.conjugate(), self.layout.put(rail.at)
        side = 1j * along
        others = [self.at[name] for name in self.points if name != rail.point]
        if dot(side, middle_of(self._beside(rail, others)) - at) > 0:
            side = -side
        if rail.point and not rail.rolls:
            at += side * BLOCK[1]
        half = max([GUIDE, *(1.25 * abs(self.at[p] - self.at[c]) for c, p in self.sketch.wheels.values() if p == rail.point)])
        if part := inside(at - along * half, at + along * half, self.sheet.field):
            self.sheet.line(*part, FRAME)
            self.sheet.hatch(*part, side)

    def _beside(self, rail: Rail, others: list[complex]) -> list[complex]:
        wheel = [self.at[centre] for centre, contact in self.sketch.wheels.values() if contact == rail.point]
        return wheel or others

    def track(self, track: Track) -> None:
        """Draw the part of a fixed circle near its contact, hatched inside the solid."""
        middle, out = self.layout.put(track.centre), self.at[track.point] - self.layout.put(track.centre)
        radius = track.radius * 1000 / self.layout.scale
        if not out or not radius:
            return
        half = min(math.pi, max(35.0 / radius, 0.5))
        steps = math.ceil(2 * half * radius / PITCH)
        arc = [middle + radius * out / abs(out) * cmath.exp(1j * half * (2 * k / steps - 1)) for k in range(steps + 1)]
        kept = [p for p in arc if inside(p - 0.01, p + 0.01, self.sheet.field)]
        self.sheet.path(kept, OUTLINE)
        wheel = next(self.at[centre] for centre, contact in self.sketch.wheels.values() if contact == track.point)
        inward = 1 if abs(wheel - middle) > radius else -1
        for a, b in itertools.pairwise(kept):
            self.sheet.hatch(a, b, inward * (middle - a))

    def hinge(self, name: str) -> None:
        """Draw a hinge of the frame: a triangle on hatched ground, on the side away from the links."""
        at = self.at[name]
        arms = [self.at[p] - at for b in self.bodies.values() if name in b.points for p in b.points if self.at[p] != at]
        lean = sum((arm / abs(arm) for arm in arms), 0j)
        down = min((1j, -1j, 1 + 0j, -1 + 0j), key=lambda d: (round(dot(lean, d), 6), d != 1j))
        side = 1j * down
        foot = at + 5.0 * down
        self.sheet.path([at, foot + 2.9 * side, foot - 2.9 * side], RING, closed=True)
        self.sheet.line(foot - 4.6 * side, foot + 4.6 * side, FRAME)
        self.sheet.hatch(foot - 4.6 * side, foot + 4.6 * side, down)
        self.sheet.boxes.append(_around(at + 3.5 * down, 4.0))

    # what moves

    def link(self, link: Link) -> None:
        """Draw a link: a line through its points, a wheel, a sliding block or a rack."""
        body = self.bodies[link.name]
        data = f' data-link="{plain(link.name)}"'
        if link.name in self.sketch.wheels:
            centre, contact = self.sketch.wheels[link.name]
            self.sheet.circle(self.at[centre], abs(self.at[contact] - self.at[centre]), OUTLINE, data, rim=True)
            self.sheet.line(self.at[centre], self.at[contact], 'stroke="black" stroke-width="0.2"')
            corners = [centre, *(name for name in link.points if name != centre)]
        else:
            corners = list(link.points)
        if body.name in self.sketch.racks:
            self.rack(body)
        for a, b in itertools.pairwise(corners):
            self.sheet.line(self.at[a], self.at[b], LINK, f'{data} data-from="{plain(a)}" data-to="{plain(b)}"')
        for a, b, c in zip(corners, corners[1:], corners[2:], strict=False):
            self.corner(a, b, c)

    def corner(self, a: str, b: str, c: str) -> None:
        """Fill the angle of a bent link: it is rigid there."""
        arms = [self.at[name] - self.at[b] for name in (a, c)]
        if all(arms) and abs(cross(*(arm / abs(arm) for arm in arms))) > 0.05:
            tips = [self.at[b] + arm / abs(arm) * min(5.0, abs(arm)) for arm in arms]
            self.sheet.path([self.at[b], *tips], 'fill="#999" stroke="none"', closed=True)

    def block(self, at: complex, along: complex) -> None:
        """Draw the block of a slider."""
        long, high = BLOCK[0] * along, BLOCK[1] * 1j * along
        self.sheet.path([at + long + high, at - long + high, at - long - high, at + long - high], RING, closed=True)

    def rack(self, body: Body) -> None:
        """Draw a rack as a bar from its joint beyond its gear, on the side away from the gear."""
        contact = self.sketch.racks[body.name]
        at, touch = self.at[body.points[0]], self.at[contact]
        along = body.guide.conjugate() * (1 if dot(touch - at, body.guide.conjugate()) > 0 else -1)
        gear = next(self.at[centre] for centre, other in self.sketch.wheels.values() if other == contact)
        side = 1j * along * BLOCK[1] * (1 if dot(1j * along, gear - touch) < 0 else -1)
        end = touch + 12 * along
        self.sheet.path([at, end, end + side, at + side], RING, closed=True)

    def joint(self, name: str) -> None:
        """Draw a joint as a ring, a mere point of a link as a dot."""
        wheels = self.sketch.wheels.values()
        members = sum(name in body.points for body in self.bodies.values())
        guided = name in self.sketch.pose.guided
        ring = members > 1 or guided or name in self.sketch.hinges or any(name == centre for centre, _ in wheels)
        if any(name == contact for _, contact in wheels):
            self.sheet.circle(self.at[name], 0.7, DOT)
        else:
            self.sheet.circle(self.at[name], 1.25 if ring else 1.0, RING if ring else DOT)

    # what was found

    def velocity(self, name: str) -> None:
        """Draw the velocity of a point; one too short to be seen is written beside its point."""
        velocity = self.findings.velocities.get(name)
        if velocity is None or name in self.sketch.pose.fixed:
            return
        arrow = self.layout.arrow(velocity)
        tip = self.at[name] + arrow
        if abs(arrow) > SHORTEST:
            self.sheet.arrow(self.at[name], tip, VELOCITY, f' data-velocity="{plain(name)}"', head=min(2.6, 0.6 * abs(arrow)))
        value = f" = {abs(velocity):#.3g} m/s" if abs(arrow) < SMALL else ""
        away = arrow or self.at[name] - self.middle
        self.marks.append((("V", _short(name), value), [(tip, away, 1.0 if abs(arrow) > SMALL else 2.0)]))

    def construction(self, link: str, centre: Centre) -> None:
        """Draw the lines that lead from two points to a centre, or to where they leave the sheet."""
        if centre.at is not None:
            for name in centre.lines:
                self.sheet.line(self.at[name], self.layout.put(centre.at), CONSTRUCTION)

    def cross(self, link: str, centre: Centre) -> None:
        """Mark a centre with a cross and its name; a far one with arrows at the border and its coordinates."""
        if centre.at is None or not centre.lines:
            return
        layout = self.layout
        at = layout.put(centre.at)
        if link in layout.near:
            for arm in (1.5 + 1.5j, 1.5 - 1.5j):
                self.sheet.line(at - arm, at + arm, 'stroke="black" stroke-width="0.4"')
            self.marks.append(((self.letter, _short(link), ""), [(at, at - self.middle, 2.2)]))
            return
        places = []
        for name in centre.lines:
            if part := inside(self.at[name], at, self.sheet.field):
                along = (at - self.at[name]) / abs(at - self.at[name])
                self.sheet.arrow(part[1] - 5 * along, part[1], CONSTRUCTION, head=2.6)
                places.append((part[1] - 6 * along, self.middle - part[1], 1.4))
        decimals = max(0, math.ceil(math.log10(READ / layout.scale) - 1e-9))
        where = f" ({centre.at.real:.{decimals}f}; {centre.at.imag:.{decimals}f}) m".replace("-", "−")
        self.marks.append(((self.letter, _short(link), where), places))

    # words

    def names(self) -> None:
        """Write all labels: points, velocities, centres, links with the sense of their rotation."""
        for name in self.points:
            self.sheet.label((_short(name), "", ""), [(self.at[name], self.at[name] - self.middle, 1.6)])
        for word, places in self.marks:
            if places:
                self.sheet.label(word, places)
        for link in self.sketch.links:
            self.link_name(link)

    def link_name(self, link: Link) -> None:
        """Write the name of a link beside its longest part, with the sense in which it turns."""
        body, omega = self.bodies[link.name], self.findings.omegas.get(link.name)
        if link.name in self.sketch.wheels:
            centre, contact = (self.at[name] for name in self.sketch.wheels[link.name])
            near, gap = centre, 4.0 if abs(contact - centre) > 12 else abs(contact - centre) + 1.0
        elif len(link.points) > 1:
            a, b = max(zip(link.points, link.points[1:], strict=False), key=lambda p: abs(self.at[p[0]] - self.at[p[1]]))
            near, gap = (self.at[a] + self.at[b]) / 2, 1.5
        else:
            near, gap = self.at[link.points[0]], 4.0
        turn = 0 if body.guide or not omega else (1 if omega > 0 else -1)
        self.sheet.label((_short(link.name), "", ""), [(near, near - self.middle, gap)], BOLD, turn=turn)

    def foot(self, title: str) -> None:
        """Draw the bar by which a print is checked, and say the scales."""
        layout = self.layout
        moving = any(self.findings.velocities.values())
        speeds = say("drawing.speeds", speed=decimal(layout.speed)) if moving else ""
        draw_foot(self.sheet, [say("drawing.scale", scale=layout.scale_text), speeds, title], self.written)


def _around(at: complex, half: float) -> tuple[float, float, float, float]:
    return (at.real - half, at.imag - half, at.real + half, at.imag + half)


def _short(name: str) -> str:
    return name if len(name) <= LONGEST_NAME else name[: LONGEST_NAME - 1] + "…"
