"""Plans of velocities and accelerations: which image is found next, and by which lines, for all rows at once.

Enters: an `Outline` and the motion of its points.  Leaves: `Polygons`, vectors in m/s and m/s².
Used by `plans.py` and `check_plan.py`.
A dyad needs no rule of its own: a point is found where two known lines meet, each across a link, along a guide or along a
link on which it slides.  A link that turns with its guide needs only one line, through any of its points.  A link held by
three legs (a group of class III) has one line at each of three points: a special point of it is found first.
Source: Ponomarev, coursework guide; theory of mechanisms, method of plans.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from coursework.drawing.outline.ground import touched
from coursework.drawing.outline.outline import Bar, Outline
from coursework.drawing.plans.known import Driven, Known
from coursework.drawing.plans.moving import Kinematics
from coursework.drawing.plans.special_points import Leg, special_name, special_points
from coursework.drawing.plans.vectors import Found, Line, Polygons

OnSheet = Callable[[complex, tuple[str, ...]], bool]


def polygons(
    outline: Outline, kinematics: Kinematics, driven: Driven, row: int = 0, on_sheet: OnSheet = lambda place, ends: True
) -> Polygons:
    """Return the plans of every row.

    Of a link's special points the nearest in `row` (from 0, the one on paper) is taken for which `on_sheet` is true; its
    arguments are the place (m) and the points from which lines lead there.
    """
    plan = _Plan(outline, kinematics, driven, row, on_sheet)
    if len(kinematics.t):  # a motion may stop before its first row
        plan.draw(driven.points)
    return Polygons(kinematics.t, tuple(plan.paper.segments.values()), tuple(plan.paper.found))


class _Plan(Known):
    """The polygons being drawn, by rules that each find one image more."""

    def __init__(self, outline: Outline, kinematics: Kinematics, driven: Driven, row: int, on_sheet: OnSheet) -> None:
        super().__init__(outline, kinematics, driven, row)
        self.on_sheet = on_sheet
        self.under: set[tuple[str, str]] = set()
        self.slots: dict[tuple[str, str], str] = {}  # (point, link) -> the drawn point of the link under it

    def draw(self, given: Sequence[str]) -> None:
        """Apply the rules until every point has its image."""
        for name in given:
            self.paper.place(name, "given")
        rules = (self.turned, self.carried, self.rolled, self.slid, self.met, self.special)
        while any(rule() for rule in rules) or self.rolled(at_last=True) or self.solved():
            pass

    # how images are found, the simplest way first

    def turned(self) -> bool:
        """Let blocks turn with their guides, and guides with their blocks."""
        before = len(self.turning)
        for slot, block in self.guided():
            if self.turning & {slot.link, block}:
                self.turning |= {slot.link, block}
        return len(self.turning) > before

    def carried(self) -> bool:
        """Place a point of a link whose rotation is known, or settle the rotation of a link with two images."""
        for bar in self.bars:
            if len([name for name in bar.corners if name in self.images]) > 1 and bar.link not in self.turning:
                self.turning.add(bar.link)
                return True
            base = self.base(bar)
            if base and bar.link in self.turning:
                for name in bar.corners:
                    if name not in self.images:
                        self.paper.along_bar(bar, base, name)
                        rule = "turned" if bar.link in self.driven and base in self.outline.hinges else "similar"
                        if frozenset((base, name)) in self.paper.stretching:
                            rule = "stretches"
                        self.paper.place(name, rule, (Line("bar", base, bar.link),))
                        return True
        return False

    def rolled(self, at_last: bool = False) -> bool:
        """Place the contact of a wheel with a known centre, if it touches something fixed or known or, `at_last`, in any case."""
        for wheel in self.outline.wheels:
            if wheel.centre not in self.images or wheel.contact in self.images:
                continue
            places = {name: complex(point.at[self.row]) for name, point in self.kinematics.points.items()}
            is_due = at_last or self.rests(wheel.contact) or any(map(self.settled, touched(self.outline, places, wheel)))
            if is_due:
                bar = self.bar(wheel.link)
                self.turning.add(bar.link)
                contact = self.kinematics.carried(bar, wheel.centre, self.kinematics.points[wheel.contact].at)
                self.kinematics.points[wheel.contact] = contact
                self.paper.along_bar(bar, wheel.centre, wheel.contact)
                rule = "rolls" if self.rests(wheel.contact) else "meshes"
                self.paper.place(wheel.contact, rule, (Line("wheel", wheel.centre, wheel.link),))
                return True
        return False

    def slid(self) -> bool:
        """Place the point of a link under a rider that slides on it, which settles the link."""
        for slot in self.outline.slots:
            bar = self.bar(slot.link)
            for rider in slot.riders:
                if rider not in self.images or (rider, bar.link) in self.under:
                    continue
                base, way = self.base(bar), self.way(bar)
                if bar.link in self.turning and way is not None and not base:
                    name, line = way
                elif bar.link not in self.turning and base and self.crosses(bar, base, rider, slot):
                    name, line = base, Line("bar", base, bar.link)
                else:
                    continue
                self.turning.add(bar.link)
                self.under.add((rider, bar.link))
                under = self.paper.over(bar, name, rider, joined=bool(base))
                line = self.along(line, under)
                self.paper.found.append(Found("slide", under, (line, Line("slot", rider, bar.link)), rider))
                if not base and bar.link in self.still:
                    self.paper.place(name, "translates", (line,))
                elif not base:
                    self.paper.about(bar, under, name, self.kinematics.points[name])
                    self.paper.place(name, "similar", (Line("bar", under, bar.link),))
                return True
        return False

    def met(self) -> bool:
        """Place a point where two known lines meet."""
        for name in dict.fromkeys(self.names):
            if name in self.images:
                continue
            pairs = itertools.combinations(self.lines(name), 2)
            crossing = next((pair for pair in pairs if self.meet(*(self.direction(line, name) for line in pair))), ())
            if crossing:
                self.paper.place(name, "lines", tuple([self.along(line, name) for line in crossing]))
                return True
        return False

    def special(self) -> bool:
        """Place a special point of a link that three legs hold and of which no image is known."""
        for bar in self.bars:
            legs = [] if bar.link in self.turning or self.base(bar) else [*self.legs(bar)]
            for found in special_points(legs, self.row) if len(legs) > 2 else ():
                if not self.on_sheet(complex(found.at[self.row]), tuple(leg.point for leg in found.legs)):
                    continue
                name = special_name([*self.kinematics.points])
                self.kinematics.points[name] = self.kinematics.carried(bar, bar.corners[0], found.at)
                lines = [leg.line if leg.line.kind == "bar" else self.along(leg.line, leg.point) for leg in found.legs]
                lines = [replace(line, at=leg.point) for line, leg in zip(lines, found.legs, strict=True)]
                drawn = [self.paper.towards(bar, name, line) for line in lines]
                self.paper.place(name, "special", drawn, bar.link)
                self.specials[bar.link] = name
                return True
        return False

    def legs(self, bar: Bar) -> Iterator[Leg]:
        """Yield the legs that hold a link at its points, and at riders that slide on it."""
        points = self.kinematics.points
        for name in bar.corners:
            for line in self.lines(name):
                if line.kind == "wheel" or (line.kind != "bar" and name not in {line.base, line.link}):
                    continue
                yield Leg(name, line, points[name].at, self.direction(line, name))
        for slot in self.outline.slots:
            for rider in slot.riders if slot.link == bar.link else ():
                if rider in self.images:
                    yield Leg(rider, Line("sleeve", rider, bar.link), points[rider].at, self.slot_way(slot))

    def solved(self) -> bool:
        """Place a point that no two lines give: its velocity is solved from the same geometry."""
        for bar in self.bars:
            base = self.base(bar)
            for name in bar.corners:
                if base and name not in self.images:
                    self.paper.along_bar(bar, base, name)
                    self.paper.place(name, "solved", (Line("bar", base, bar.link),))
                    return True
        rest = next((name for name in self.names if name not in self.images), "")
        if rest:
            self.paper.place(rest, "solved")
        return bool(rest)

    def along(self, line: Line, name: str) -> Line:
        """Draw what leads along a line to the image of a point; return the line as drawn."""
        if line.kind == "bar" and name in self.names:
            self.paper.along_bar(self.bar(line.link), line.base, name)
        elif line.kind == "slot":
            bar = self.bar(line.link)
            if (name, line.link) not in self.slots:
                self.slots[name, line.link] = self.paper.over(bar, self.base(bar), name)
            return Line("slot", self.slots[name, line.link], line.link)
        elif line.kind == "driven" and name in self.bar(line.link).corners:  # a bar that stretches is its own guide
            self.paper.over(self.bar(line.link), line.base, name)
        return line
