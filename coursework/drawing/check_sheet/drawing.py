"""The drawing of the graph-analytical check: mechanism, velocities, centres, true to scale, readable in black and white.

Enters: a `Sketch` and the `Findings`.  Leaves: SVG text, the same on every run, one user unit = 1 mm, size in mm.
All names from a file are escaped (`sheet.plain`).
Used by `graph_check.py`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import replace

from coursework.drawing.check_sheet.graph_words import centre_letter
from coursework.drawing.check_sheet.instant_centres import Centre, Findings
from coursework.drawing.check_sheet.layout import CROSS, Layout, lay_out
from coursework.drawing.check_sheet.sketch import Sketch
from coursework.drawing.lettering.naming import lies_on, link_owner, link_places, point_names
from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.placing import Owner, Place
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import AXIS, BOLD, ITALIC, Sheet, Word, inside, plain
from coursework.drawing.paper.symbols import decimal, lowered_name, name_word, powers, short
from coursework.drawing.plans.foot import draw_foot
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

VELOCITY = 'stroke="black" stroke-width="0.4"'
MOST_DECIMALS = 6
READ = 1e4  # 1/m: off a drawing 1:1 a position is read to 0.1 mm
FAR = 12.0  # mm of covered lines: price of a far centre's name where it could be taken for another's
MISTAKEN = 8.0  # mm of covered lines: the same price for any other name
AT_LINK = 6.0  # mm: a link's name with its rotation that stands farther off gets a thin line that leads to the link
CLOSE = 0.05  # relative to the size of the mechanism: a centre this near to a point lies almost on it
SHORTEST = 0.5  # mm: a shorter arrow is not drawn
SMALL = 4.0  # mm: the name of a shorter arrow stands farther off


def draw(
    sketch: Sketch, findings: Findings, row: int, time: float, written: Callable[[str], str] = str, *, blank: bool = False
) -> Drawing:
    """Return `figure#graph-check` of one `row` (from 1) at a `time` (s); `written` translates its sentences for a page.

    A `blank` sheet shows only the mechanism and its driven velocity, and leaves the construction to the student.
    """
    layout = lay_out(sketch, findings)
    if blank:
        given = {name: v for name, v in findings.velocities.items() if name in sketch.pose.velocities}
        findings = replace(findings, velocities=given, omegas={}, centres={}, specials={})
    svg = _Drawing(sketch, findings, layout, written).svg(say("drawing.title", row=row, time=time))
    alt = say("graph.alt", row=row)
    key, seen = "graph.blank" if blank else "graph.caption", _seen(sketch, findings)
    caption = say(key, row=row, time=time, scale=layout.scale_text, seen=seen)
    return Drawing("graph-check", svg, layout.width, layout.height, caption, alt, exact=True)


def _seen(sketch: Sketch, findings: Findings) -> str:
    """Return a sentence on what to look at: a centre near a point, which therefore hardly moves, or else the fastest point."""
    size, places = sketch.pose.size, sketch.pose.positions
    points = {body.name: body.points for body in sketch.pose.bodies}
    for link, centre in findings.drawn.items():
        for name in points[link]:
            if centre.at is not None and centre.lines and abs(places[name] - centre.at) < CLOSE * size:
                return say("graph.close", link=link, point=name)
    moving = {name: abs(v) for name, v in findings.velocities.items() if name in sketch.moving}
    fastest = max(moving, key=lambda name: moving[name], default="")
    return say("graph.fastest", point=fastest, speed=moving[fastest]) if fastest else ""


def place(at: complex, decimals: int) -> Sentence:
    """Return the coordinates of a place (m) with so many decimals, with a power of ten where nobody would count them."""
    x, y = (round(part, decimals) + 0.0 for part in (at.real, at.imag))
    return say("drawing.place" if decimals <= MOST_DECIMALS else "drawing.tiny_place", x=x, y=y)


class _Drawing:
    """One sheet being drawn, from the background to the foreground."""

    def __init__(self, sketch: Sketch, findings: Findings, layout: Layout, written: Callable[[str], str]) -> None:
        self.sketch, self.findings, self.layout, self.written = sketch, findings, layout, written
        self.bodies = {body.name: body for body in sketch.pose.bodies}
        self.sheet = Sheet(layout.width, layout.height, layout.field)
        self.painter = Painter(self.sheet, sketch.outline, sketch.poses, sketch.row, layout.put, 1000 / layout.scale)
        self.at = self.painter.at
        self.points = list(dict.fromkeys((*sketch.outline.names, *(name for body in sketch.pose.bodies for name in body.points))))
        self.letter = centre_letter(sketch)
        self.marks: list[tuple[Word, list[Place], Segment]] = []
        self.far: list[tuple[Word, list[Place], list[Segment]]] = []  # centres off the sheet: each arrow is named, one in full
        self.middle = self.painter.middle

    def svg(self, title: str) -> str:
        for centre in (*self.findings.drawn.values(), *self.findings.specials.values()):
            # Lines lead from two points to a centre, or to the border if it is off the sheet.
            if centre.at is not None:
                for name in centre.lines:
                    self.sheet.line(self.at[name], self.layout.put(centre.at), AXIS)
        self.painter.fixed()
        self.painter.moving()
        for name in self.points:
            self.velocity(name)
        for name, centre in self.findings.drawn.items():
            self.cross(name, centre)
        for name, special in self.findings.specials.items():
            if special.at is not None:
                self.marked(self.layout.put(special.at), name_word(name))
        self.names()
        self.foot(title)
        return self.sheet.svg()

    # what was found

    def velocity(self, name: str) -> None:
        """Draw the velocity of a point; if its arrow is too short to be seen, only write its value beside the point."""
        velocity = self.findings.velocities.get(name)
        if velocity is None or name in self.sketch.pose.fixed:
            return
        arrow = self.layout.arrow(velocity)
        tip = self.at[name] + arrow
        seen = abs(arrow) > SHORTEST
        if seen:
            self.sheet.vector(self.at[name], tip, VELOCITY, f' data-velocity="{plain(name)}"')
        value = powers(self.written(say("drawing.speed", speed=abs(velocity))))
        away = arrow or self.at[name] - self.middle
        places = [(tip, away, 1.0 if abs(arrow) > SMALL else 2.0), (tip - arrow / 4, 1j * away, 1.0)]
        self.marks.append((("V", lowered_name(name), value), places if seen else places[:1], (tip - arrow / 2, tip)))

    def cross(self, link: str, centre: Centre) -> None:
        """Mark a centre with a cross and its name; if it is off the sheet, with arrows at the border and its coordinates."""
        if centre.at is None or not centre.lines:
            return
        layout = self.layout
        at = layout.put(centre.at)
        if link in layout.near:
            self.marked(at, (self.letter, short(link), ""))
            return
        places, arrows = [], []
        for name in centre.lines:
            if part := inside(self.at[name], at, self.sheet.field):
                along = (at - self.at[name]) / abs(at - self.at[name])
                self.sheet.arrow(part[1] - 5 * along, part[1], AXIS, head=2.6)
                places.append((part[1] - 6 * along, self.middle - part[1], 1.4))
                arrows.append((part[1] - 8 * along, part[1]))
        decimals = max(0, math.ceil(math.log10(READ / layout.scale) - 1e-9))
        if places:
            where = powers(self.written(place(centre.at, decimals))).replace("-", "−")
            self.far.append(((self.letter, short(link), where), places, arrows))

    def marked(self, at: complex, word: Word) -> None:
        """Mark a place of the sheet (mm) with a cross and its name."""
        for arm in (complex(CROSS, CROSS), complex(CROSS, -CROSS)):
            self.sheet.line(at - arm, at + arm, 'stroke="black" stroke-width="0.4"')
        self.marks.append((word, [(at, at - self.middle, 2.2)], (at, at)))

    # words

    def names(self) -> None:
        """Write all labels: points, velocities, centres, links with the sense and size of their rotation."""
        point_names(self.painter)
        owned = [*(line for *_, line in self.marks), *itertools.chain(*(lines for *_, lines in self.far))]

        def owner(own: list[Segment], mistaken: float = MISTAKEN) -> Owner:
            return Owner(own, [line for line in owned if not any(line == mine or lies_on(line, mine) for mine in own)], mistaken)

        for word, places, line in self.marks:
            self.sheet.label(word, places, ITALIC, owner=owner([line]))
        for word, places, lines in self.far:
            chosen = self.sheet.label(word, places, ITALIC, owner=owner(lines, FAR))
            for place, line in zip(places, lines, strict=True):
                if place != chosen:
                    self.sheet.label((*word[:2], ""), [place], ITALIC, owner=owner([line], FAR))
        for bar in self.sketch.outline.bars:
            body, omega = self.bodies.get(bar.link), self.findings.omegas.get(bar.link)
            turning = 0 if body is None or body.guide or not omega else (1 if omega > 0 else -1)
            value = self.written(say("drawing.turning", omega=abs(omega))) if omega and turning else ""
            if bar.corners:
                belongs = replace(link_owner(self.painter, bar), lost=AT_LINK)
                self.sheet.label((short(bar.link), "", value), link_places(self.painter, bar), BOLD, turn=turning, owner=belongs)

    def foot(self, title: str) -> None:
        """Draw the bar for checking the scale of a print, and write the scales."""
        layout = self.layout
        moving = any(self.findings.velocities.values())
        speeds = say("drawing.speeds", speed=decimal(layout.speed)) if moving else ""
        scales = [say("drawing.scale", scale=layout.scale_text), speeds]
        draw_foot(self.sheet, scales, title, (layout.scale / 1000, "m"), self.written)
