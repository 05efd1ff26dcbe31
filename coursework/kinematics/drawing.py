"""The drawing of the graph-analytical check: mechanism, velocities, centres, true to scale, readable in black and white.

Enters: a `Sketch` and the `Findings`.  Leaves: SVG text, the same on every run, one user unit = 1 mm, size in mm.
Everything a file may name is escaped (`sheet.plain`).
"""

from __future__ import annotations

import cmath
import math

from coursework.kinematics.instant_centres import Body, Centre, Findings, cross, dot
from coursework.kinematics.layout import FOOT, Layout, lay_out
from coursework.kinematics.scene import Rail, Sketch
from coursework.kinematics.sheet import Sheet, inside, middle_of, plain
from coursework.variant.record import Link

BAR = 100.0  # mm, printed; a test reads it back from the PDF
BAR_PEN = 'stroke="#010101" stroke-width="0.5" stroke-linecap="butt"'  # a colour of its own, so that it can be found
BAR_WORDS = "must measure 100 mm; print at 100 %"
LINK = 'stroke="black" stroke-width="0.8"'
FRAME = 'stroke="black" stroke-width="0.35"'
VELOCITY = 'stroke="black" stroke-width="0.4"'
CONSTRUCTION = 'stroke="black" stroke-width="0.15" stroke-dasharray="2.4 1 0.4 1"'
OUTLINE = 'fill="none" stroke="black" stroke-width="0.35"'
RING = 'fill="white" stroke="black" stroke-width="0.35"'
DOT = 'fill="black" stroke="none"'
SHORTEST = 0.5  # mm: a shorter arrow would hide in the joint
GUIDE = 13.0  # mm of a rail to each side
BLOCK = (4.2, 2.4)  # mm, half length and half height of a slider


def draw(sketch: Sketch, findings: Findings, row: int, time: float) -> str:
    """Return the drawing of one row (from 1) at a time (s)."""
    layout = lay_out(sketch, findings)
    return _Drawing(sketch, findings, layout).svg(f"row {row}, t = {time:.6g} s")


class _Drawing:
    """One sheet being drawn, from what lies behind to what stands in front."""

    def __init__(self, sketch: Sketch, findings: Findings, layout: Layout) -> None:
        self.sketch, self.findings, self.layout = sketch, findings, layout
        self.bodies = {body.name: body for body in sketch.scene.bodies}
        self.at = {name: layout.put(z) for name, z in sketch.scene.positions.items()}
        self.sheet = Sheet(layout.width, layout.height, layout.field)
        self.points = list(dict.fromkeys(name for body in sketch.scene.bodies for name in body.points))
        self.middle = middle_of(self.at[name] for name in self.points)

    def svg(self, title: str) -> str:
        for name, centre in self.findings.centres.items():
            self.construction(name, centre)
        for centre, radius in self.sketch.circles:
            self.round_rail(centre, radius)
        for rail in self.sketch.rails:
            self.rail(rail)
        for name in self.sketch.hinges:
            self.hinge(name)
        for link in self.sketch.links:
            self.link(link)
        tips = [(name, tip) for name in self.points if (tip := self.velocity(name)) is not None]
        for name in self.points:
            self.joint(name)
        marked = [(name, at) for name, centre in self.findings.centres.items() if (at := self.cross(name, centre)) is not None]
        self.names(tips, marked)
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
        ends = [at - along * half, at + along * half]
        if part := inside(*ends, self.sheet.field):
            self.sheet.line(*part, FRAME)
            self.sheet.hatch(part, side)

    def _beside(self, rail: Rail, others: list[complex]) -> list[complex]:
        wheel = [self.at[centre] for centre, contact in self.sketch.wheels.values() if contact == rail.point]
        return wheel or others

    def round_rail(self, centre: complex, radius: float) -> None:
        """Draw the part of a fixed circle on which a wheel rolls."""
        mm = 1000 / self.layout.scale * radius
        middle = self.layout.put(centre)
        for wheel, contact in self.sketch.wheels.values():
            out = self.at[contact] - middle
            if not out or abs(abs(out) - mm) > 1.0:
                continue
            half = min(math.pi, 35.0 / mm)
            arc = [middle + out * cmath.exp(1j * half * (k / 24 - 1)) for k in range(49)]
            kept = [p for p in arc if inside(p - 0.01, p + 0.01, self.sheet.field)]
            self.sheet.path(kept, OUTLINE)
            inner = dot(self.at[wheel] - self.at[contact], out) > 0
            for a, b in zip(kept, kept[1:], strict=False):
                self.sheet.hatch((a, b), (middle - a) if inner else (a - middle))

    def hinge(self, name: str) -> None:
        """Draw a hinge of the frame: a triangle on hatched ground, on the side away from the links."""
        at = self.at[name]
        arms = [self.at[p] - at for b in self.bodies.values() if name in b.points for p in b.points if self.at[p] != at]
        lean = sum((arm / abs(arm) for arm in arms), 0j)
        down = min((1j, -1j, 1 + 0j, -1 + 0j), key=lambda d: (round(dot(lean, d), 6), d != 1j))
        side = 1j * down
        foot = at + 5.0 * down
        self.sheet.path([at, foot + 2.9 * side, foot - 2.9 * side], RING, closed=True)
        ground = [foot - 4.6 * side, foot + 4.6 * side]
        self.sheet.line(*ground, FRAME)
        self.sheet.hatch(ground, down)
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
        if body.guide:
            self.block(body)
        for a, b in zip(corners, corners[1:], strict=False):
            self.sheet.line(self.at[a], self.at[b], LINK, f'{data} data-from="{plain(a)}" data-to="{plain(b)}"')
        for a, b, c in zip(corners, corners[1:], corners[2:], strict=False):
            self.corner(a, b, c)

    def corner(self, a: str, b: str, c: str) -> None:
        """Fill the angle of a bent link: it is rigid there."""
        arms = [self.at[name] - self.at[b] for name in (a, c)]
        if all(arms) and abs(cross(*(arm / abs(arm) for arm in arms))) > 0.05:
            tips = [self.at[b] + arm / abs(arm) * min(5.0, abs(arm)) for arm in arms]
            self.sheet.path([self.at[b], *tips], 'fill="#999" stroke="none"', closed=True)

    def block(self, body: Body) -> None:
        """Draw the block of a slider, and the bar of a rack as far as its gear."""
        at, along = self.at[body.points[0]], body.guide.conjugate()
        long, high = BLOCK[0] * along, BLOCK[1] * 1j * along
        self.sheet.path([at + long + high, at - long + high, at - long - high, at + long - high], RING, closed=True)
        if contact := self.sketch.racks.get(body.name):
            way = self.at[contact] - at
            end = self.at[contact] + (along if dot(way, along) > 0 else -along) * 12
            self.sheet.line(at, end, LINK, f' data-link="{plain(body.name)}"')

    def joint(self, name: str) -> None:
        """Draw a joint as a ring, a mere point of a link as a dot."""
        wheels = self.sketch.wheels.values()
        members = sum(name in body.points for body in self.bodies.values())
        guided = name in self.sketch.scene.guided
        ring = members > 1 or guided or name in self.sketch.hinges or any(name == centre for centre, _ in wheels)
        if any(name == contact for _, contact in wheels):
            self.sheet.circle(self.at[name], 0.7, DOT)
        else:
            self.sheet.circle(self.at[name], 1.25 if ring else 1.0, RING if ring else DOT)

    # what was found

    def velocity(self, name: str) -> complex | None:
        """Draw the velocity of a point; return its tip."""
        arrow = self.layout.arrow(self.findings.velocities.get(name, 0j))
        if abs(arrow) < SHORTEST:
            return None
        tip = self.at[name] + arrow
        self.sheet.arrow(self.at[name], tip, VELOCITY, f' data-velocity="{plain(name)}"')
        return tip

    def construction(self, link: str, centre: Centre) -> None:
        """Draw the lines that lead from two points to a centre, or to where they leave the sheet."""
        if centre.at is not None:
            for name in centre.lines:
                self.sheet.line(self.at[name], self.layout.put(centre.at), CONSTRUCTION)

    def cross(self, link: str, centre: Centre) -> complex | None:
        """Mark a centre with a cross, a far one with an arrow at the border; return the place for its name."""
        if centre.at is None or not centre.lines:
            return None
        at = self.layout.put(centre.at)
        if link in self.layout.near:
            for arm in (1.5 + 1.5j, 1.5 - 1.5j):
                self.sheet.line(at - arm, at + arm, 'stroke="black" stroke-width="0.4"')
            return at
        start = self.at[centre.lines[0]]
        part = inside(start, at, self.sheet.field)
        if part is None:
            return None
        along = (at - start) / abs(at - start)
        self.sheet.arrow(part[1] - 6 * along, part[1], VELOCITY, head=2.2)
        return part[1] - 3 * along

    # words

    def names(self, tips: list[tuple[str, complex]], marked: list[tuple[str, complex]]) -> None:
        """Write all labels: points, tips of velocities, centres, links with the sense of their rotation."""
        for name in self.points:
            self.sheet.label((name, ""), self.at[name], self.at[name] - self.middle)
        for name, tip in tips:
            self.sheet.label(("V", name), tip, tip - self.at[name], 1.0)
        for link, at in marked:
            word = ("P", link)
            if link not in self.layout.near:
                centre = self.findings.centres[link].at or 0j
                word = (f"P{link} ({centre.real:.4g}; {centre.imag:.4g}) m".replace("-", "−"), "")
            self.sheet.label(word, at, at - self.middle, 2.2)
        for link in self.sketch.links:
            self.link_name(link)

    def link_name(self, link: Link) -> None:
        body, omega = self.bodies[link.name], self.findings.omegas.get(link.name)
        if link.name in self.sketch.wheels:
            near, gap = self.at[self.sketch.wheels[link.name][0]], 4.0
        elif len(link.points) > 1:
            a, b = max(zip(link.points, link.points[1:], strict=False), key=lambda p: abs(self.at[p[0]] - self.at[p[1]]))
            near, gap = (self.at[a] + self.at[b]) / 2, 1.5
        else:
            near, gap = self.at[link.points[0]], 4.0
        turn = 0 if body.guide or not omega else (1 if omega > 0 else -1)
        self.sheet.label((link.name, ""), near, near - self.middle, gap, bold=True, turn=turn)

    def foot(self, title: str) -> None:
        """Draw the bar by which a print is checked, and say the scales."""
        layout = self.layout
        left, base = 3.0, layout.height - 5.0
        bar = (complex(left, base), complex(left + BAR, base))
        self.sheet.field = (0.0, 0.0, layout.width, layout.height)
        self.sheet.line(*bar, BAR_PEN, ' data-bar="100"')
        for k in range(11):
            tick = 2.4 if k % 5 == 0 else 1.4
            self.sheet.line(complex(left + 10 * k, base), complex(left + 10 * k, base - tick), FRAME)
        self.sheet.text(complex(left, base - 4.2), plain(f"100 mm: {BAR_WORDS}", 99), size=2.9)
        lines = (f"scale {layout.scale_text}", f"velocities: 1 mm = {layout.speed:g} m/s", title)
        for k, line in enumerate(lines):
            self.sheet.text(complex(left + BAR + 7, layout.height - FOOT + 4.6 + 4.2 * k), plain(line, 99), size=2.9)
        self.axes(complex(layout.width - 12, layout.height - 4.5))

    def axes(self, at: complex) -> None:
        """Draw the directions of x and y."""
        for way, name, shift in ((8 + 0j, "x", 0.6 + 0.8j), (-8j, "y", -2.6 + 0.5j)):
            self.sheet.arrow(at, at + way, 'stroke="black" stroke-width="0.2"', head=1.6)
            self.sheet.text(at + way + shift, name, look='font-style="italic"', size=2.6)


def _around(at: complex, half: float) -> tuple[float, float, float, float]:
    return (at.real - half, at.imag - half, at.real + half, at.imag + half)
