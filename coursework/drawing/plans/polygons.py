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
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace

import numpy as np

from coursework.drawing.outline.ground import touched
from coursework.drawing.outline.outline import Bar, Outline, Slot
from coursework.drawing.plans.moving import Kinematics
from coursework.drawing.plans.special_points import PARALLEL, Leg, special_name, special_points
from coursework.drawing.plans.vectors import POLE, Found, Line, Polygons, Vectors
from coursework.system.arrays import Complex
from coursework.system.frozen import frozen

OnSheet = Callable[[complex, tuple[str, ...]], bool]


@frozen
class Driven:
    """What the drive gives: the motion of `points`, links with known `rates`, and (link, rider) whose sliding has a law.

    `stretching` are pairs of points of a link whose distance changes, because one of them slides.
    """

    points: Sequence[str]
    rates: Sequence[str]
    lengths: Collection[tuple[str, str]] = ()
    stretching: frozenset[frozenset[str]] = frozenset()


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


class _Plan:
    """The polygons being drawn: which images there are, and which links turn in a known way."""

    def __init__(self, outline: Outline, kinematics: Kinematics, driven: Driven, row: int, on_sheet: OnSheet) -> None:
        self.outline, self.kinematics, self.row, self.on_sheet = outline, kinematics, row, on_sheet
        self.lengths = driven.lengths
        self.paper = Vectors(kinematics, outline.hinges, driven.stretching, images=[*outline.hinges])
        self.images = self.paper.images
        self.bars = [bar for bar in outline.bars if bar.corners]
        self.rails = {rail.rider: rail for rail in outline.rails if rail.rider and not rail.rolls}
        self.driven = {bar.link for bar in self.bars if bar.rate and bar.rate in driven.rates}
        unturned = {bar.link for bar in self.bars if not bar.rate}
        self.still = {block.link for block in outline.blocks if block.link in unturned and not block.open}  # in fixed guides
        self.turning = {*self.driven, *self.still}
        self.names = [name for bar in self.bars for name in bar.corners]
        self.under: set[tuple[str, str]] = set()
        self.slots: dict[tuple[str, str], str] = {}  # (point, link) -> the drawn point of the link under it
        self.specials: dict[str, str] = {}  # link -> its special point

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

    def guided(self) -> Iterator[tuple[Slot, str]]:
        """Yield each slot with each block that slides in it."""
        for slot, block in itertools.product(self.outline.slots, self.outline.blocks):
            if block.open and block.at in slot.riders and (block.base, block.toward) == (slot.base, slot.toward):
                yield slot, block.link

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

    def lines(self, name: str) -> Iterator[Line]:
        """Yield the lines on which the image of a point lies."""
        if name in self.rails:
            yield Line("rail", POLE, name)
        for slot in self.outline.slots:
            if name in slot.riders and self.settled(slot.link):
                yield Line("slot", name, slot.link)
            elif (slot.link, name) in self.lengths and slot.at in self.images:
                yield Line("driven", slot.at, slot.link)
        for wheel in self.outline.wheels:
            if name == wheel.centre and self.rests(wheel.contact):
                yield Line("wheel", wheel.contact, wheel.link)
        for bar in self.bars:
            base = self.base(bar)
            if name not in bar.corners:
                continue
            if base and bar.link not in self.turning:
                if frozenset((base, name)) not in self.paper.stretching:  # else the point also moves along the link
                    yield Line("bar", base, bar.link)
            elif not base and bar.link in self.turning and (way := self.way(bar)) is not None and way[0] != name:
                yield way[1]

    def way(self, bar: Bar) -> tuple[str, Line] | None:
        """Return a point of a link that runs in a guide with known motion, and its line; None if the link has none."""
        for name in bar.corners:
            if name in self.rails:
                return name, Line("rail", POLE, name)
            for slot in self.outline.slots:
                if slot.link != bar.link and name in slot.riders and self.settled(slot.link):
                    return name, Line("slot", name, slot.link)
        return None

    def settled(self, link: str) -> bool:
        """Return whether both the rotation of a link and the image of one of its points are known."""
        return link in self.turning and bool(self.base(self.bar(link)))

    def direction(self, line: Line, name: str) -> Complex:
        """Return the direction (n,) of a line on which the image of the point `name` lies."""
        points = self.kinematics.points
        if line.kind == "rail":
            rail = self.rails[line.link]
            return points[rail.toward].at - points[rail.base].at
        if line.kind == "slot":
            return self.slot_way(next(one for one in self.outline.slots if one.link == line.link and line.base in one.riders))
        return 1j * (points[name].at - points[line.base].at)

    def slot_way(self, slot: Slot) -> Complex:
        """Return the direction (n,) of the straight part of a link."""
        return self.kinematics.points[slot.toward].at - self.kinematics.points[slot.base].at

    def crosses(self, bar: Bar, base: str, rider: str, slot: Slot) -> bool:
        """Return whether the line across a link meets that along its slot; from a special point they can be the same line."""
        points = self.kinematics.points
        return base in bar.corners or self.meet(1j * (points[rider].at - points[base].at), self.slot_way(slot))

    @staticmethod
    def meet(one: Complex, other: Complex) -> bool:
        """Return whether two directions differ in some row."""
        return bool(np.max(np.abs((one.conjugate() * other).imag) - PARALLEL * np.abs(one) * np.abs(other), initial=0.0) > 0)

    def rests(self, contact: str) -> bool:
        """Return whether a contact rolls on something fixed."""
        wheel = next(wheel for wheel in self.outline.wheels if wheel.contact == contact)
        moving = self.kinematics.carried(self.bar(wheel.link), wheel.centre, self.kinematics.points[contact].at)
        speed = np.max(np.abs(self.kinematics.points[wheel.centre].velocity), initial=0.0)
        return bool(np.max(np.abs(moving.velocity), initial=0.0) <= 1e-9 * speed)

    def bar(self, link: str) -> Bar:
        return next(bar for bar in self.bars if bar.link == link)

    def base(self, bar: Bar) -> str:
        """Return the point of a link from which others are drawn: a fixed hinge, else its first image, else its special point."""
        there = [name for name in bar.corners if name in self.images]
        first = there[0] if there else self.specials.get(bar.link, "")
        return next((name for name in there if name in self.outline.hinges), first)

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
