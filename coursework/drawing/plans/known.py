"""What a plan knows while it is drawn: the images there are, the links that turn in a known way, the lines of further images.

Enters: an `Outline`, the motion of its points and what the drive gives.  Leaves: `Known`.
Used by `polygons.py`, whose rules find the images, `plans.py` and `check_plan.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Sequence

import numpy as np

from coursework.drawing.outline.outline import Bar, Outline, Slot
from coursework.drawing.plans.moving import Kinematics
from coursework.drawing.plans.special_points import PARALLEL
from coursework.drawing.plans.vectors import POLE, Line, Vectors
from coursework.system.arrays import Complex
from coursework.system.frozen import frozen


@frozen
class Driven:
    """What the drive gives: the motion of `points`, links with known `rates`, and (link, rider) whose sliding has a law.

    `stretching` are pairs of points of a link whose distance changes, because one of them slides.
    """

    points: Sequence[str]
    rates: Sequence[str]
    lengths: Collection[tuple[str, str]] = ()
    stretching: frozenset[frozenset[str]] = frozenset()


class Known:
    """The images that are drawn, and what follows from them; `row` (from 0) is the row on paper."""

    def __init__(self, outline: Outline, kinematics: Kinematics, driven: Driven, row: int) -> None:
        self.outline, self.kinematics, self.row = outline, kinematics, row
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
        self.specials: dict[str, str] = {}  # link -> its special point

    def guided(self) -> Iterator[tuple[Slot, str]]:
        """Yield each slot with each block that slides in it."""
        for slot, block in itertools.product(self.outline.slots, self.outline.blocks):
            if block.open and block.at in slot.riders and (block.base, block.toward) == (slot.base, slot.toward):
                yield slot, block.link

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
