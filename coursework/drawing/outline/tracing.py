"""Finds what a mechanism looks like: the outline that follows from its links, its groups or its points.

Enters: a `Mechanism`.  Leaves: its `Outline`, None if the file places no points.
Used by `drawing/figures.py`, `drawing/trajectories.py`, `plans/`, `report/live/drawn.py` and `moving_picture.py`.
If a file has [links], they are drawn as listed; else links follow from the joints of its groups, and, if it has neither,
from points such as "A = D + r1 @ phi1" and from squares of lengths.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from coursework.drawing.outline.lengths import Turning, arm_base, gaps_of, rigid_arm, squared_lengths, unnamed_joints
from coursework.drawing.outline.outline import Bar, Block, Outline, Rail, Slot, Track, Wheel
from coursework.mechanism.joints import FRAME, Linkage, chain_of_groups, led_by_law, link_names, riders
from coursework.mechanism.mechanism import Mechanism
from coursework.variant.formula.tree import Formula, named, number, terms
from coursework.variant.record.entries import reached
from coursework.variant.record.held import between_points, is_origin
from coursework.variant.record.variant import Variant


def read_outline(mechanism: Mechanism) -> Outline | None:
    """Return the outline of a mechanism, None if its file places no points.

    >>> from coursework.variant.catalogue import load
    >>> from coursework.mechanism.mechanism import build
    >>> outline = read_outline(build(load("example-4")))
    >>> [(bar.link, bar.corners) for bar in outline.bars], [(block.link, block.at) for block in outline.blocks]
    ([('1', ('A', 'B')), ('2', ('B',)), ('3', ('D', 'E'))], [('2', 'B')])
    """
    if not mechanism.points:
        return None
    pencil = _Pencil(mechanism)
    if mechanism.variant.links:
        pencil.links()
    elif mechanism.variant.groups:
        pencil.groups(chain_of_groups(mechanism.variant, dict(mechanism.points)))
    pencil.arms()
    if not (mechanism.variant.links or mechanism.variant.groups):
        pencil.rods([ends for ends, _ in squared_lengths(mechanism)])
    return pencil.outline()


class _Pencil:
    """Collects the parts of one outline."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.variant: Variant = mechanism.variant
        self.points = dict(mechanism.points) | {joint: sides[0] for joint, sides in unnamed_joints(mechanism).items()}
        self.closures = [one.sides for one in mechanism.constraints if one.is_closure]
        self.named = {formula: name for name, formula in reversed(self.points.items())}
        self.gaps = [*filter(None, map(between_points, gaps_of(self.variant)))]
        self.bars: list[Bar] = []
        self.slots: list[Slot] = []
        self.blocks: list[Block] = []
        self.rails: list[Rail] = []
        self.wheels: list[Wheel] = []
        self.hinges = [*self.variant.frame.hinges]
        self.drawn_rates: set[str] = set()

    def links(self) -> None:
        """Draw the links as listed, with the blocks and wheels on the rails of the frame."""
        variant = self.variant
        contacts = {link.contact for link in variant.links if link.contact}
        for link in variant.links:
            centre = (link.wheel,) if link.wheel else ()
            corners = (*centre, *(name for name in link.points if name not in centre))
            self.bars.append(Bar(link.name, corners, link.rate or ""))
            if link.wheel and link.contact:
                self.wheels.append(Wheel(link.name, link.wheel, link.contact))
            self.drawn_rates.update([link.rate] if link.rate else [])
        bars = {bar.link: bar for bar in self.bars}
        for link in variant.links:
            if link.slides and link.points:
                bar = bars[link.slides].corners
                turned = self.turning(bars[link.slides].rate or link.rate)  # a guide and its block turn together
                base, toward = (bar[0], bar[1]) if len(bar) > 1 else (bar[0], self.direction(bar[0], turned))
                self.blocks.append(Block(link.name, link.points[0], base, toward, open=True))
                self.slots.append(Slot(link.slides, bar[0], base, toward, (link.points[0],)))
        for rider, (through, angle) in zip(riders(variant), variant.frame.rails, strict=True):
            at = rider or self.name_of(through)
            held = next((bar.link for bar in self.bars if bar.corners == (at,)), "")
            on_link = any(at in bar.corners for bar in self.bars)
            rider = rider if on_link or at in contacts else ""
            toward = self.direction(at, angle)
            self.rails.append(Rail(at, at, toward, rider, at in contacts))
            if rider and at not in contacts:
                self.blocks.append(Block(held, at, at, toward))

    def groups(self, linkage: Linkage) -> None:
        """Draw the bodies of a chain of groups by their joints."""
        called = link_names(linkage, self.variant)
        corners: dict[str, list[str]] = {body: [] for body in linkage.bodies}
        for joint in linkage.joints:
            at = self.name_of(joint.where) if joint.where is not None else ""
            for body in joint.holders:
                if body != FRAME and at:
                    corners[body].append(at)
            if joint.pins and FRAME in joint.bodies and at and not led_by_law(named(at), self.variant, self.points):
                self.hinges.append(at)
        for body, names in linkage.holds.items():
            for name in names:  # beside the point from which it is placed, so that the given arm is drawn
                own, formula = linkage.coordinates[body], self.points[name]
                base = arm_base(formula, own)
                onward = base != "" and [*terms(formula)][1].args[1] == named(own)  # along the link, past its other joints
                if onward and name in corners[body]:
                    continue
                others = [one for one in dict.fromkeys(corners[body]) if one != name]
                ahead = len(others) > 1 and base == others[0] and not onward
                corners[body] = [name, *others] if ahead else [*others, name]
        for body in sorted(linkage.bodies, key=int):
            coordinate = next(c for c in self.variant.coordinates if c.name == linkage.coordinates[body])
            self.drawn_rates.add(coordinate.rate)
            rate = coordinate.rate if coordinate.unit == "rad" else ""
            self.bars.append(Bar(called[body], tuple(dict.fromkeys(corners[body])), rate))
        parallel = set()
        for joint in linkage.joints:
            if not joint.kind.slides or joint.where is None or joint.along is None:
                continue
            at = self.name_of(joint.where)
            block, guide = joint.bodies
            toward = self.direction(at, joint.along)
            self.blocks.append(Block(called[block], at, at, toward, open=guide != FRAME))
            if guide == FRAME:
                self.rails.append(Rail(at, at, toward, at))
                parallel.add(joint.along)
                continue
            through = [g.through.name for group in self.variant.groups for g in group.guides if g.angle == joint.along]
            anchor = next((name for name in (*through, *corners[guide]) if name in corners[guide] and name != at), "")
            if anchor:
                self.slots.append(Slot(called[guide], anchor, at, toward, (at,)))
        for place, angle in self.variant.frame.rails:
            if angle not in parallel:
                at = self.name_of(place)
                self.rails.append(Rail(at, at, self.direction(at, angle)))

    def arms(self) -> None:
        """Draw what turns with a coordinate that belongs to no link and no group: the arms between the points it places."""
        contacts = {wheel.contact for wheel in self.wheels}
        grouped = {name for group in self.variant.groups for name in group.coordinates}
        for coordinate in self.variant.coordinates:
            if coordinate.rate in self.drawn_rates or coordinate.name in grouped or coordinate.unit != "rad":
                continue
            for turning, arms in self.arms_of(coordinate.name).items():
                corners = [end for base, tip in arms if tip not in contacts for end in (base, tip)]
                if corners:
                    alone = [term for term, _ in turning] == [named(coordinate.name)]
                    added = {name for term, _ in turning for name in term.names()}
                    others = [one.rate for one in self.variant.coordinates if one.name in added - {coordinate.name}]
                    self.arm(corners, [coordinate.rate, *others[::-1]], coordinate.rate if alone else "")

    def arm(self, corners: list[str], called: list[str], rate: str) -> None:
        """Draw an arm that turns at a `rate`, "" if this has no name, unless a drawn link holds it.

        It has the first number, of the rates after which it may be `called`, that no other link has.
        """
        place = next((place for place, bar in enumerate(self.bars) if {*corners} <= {*bar.corners}), None)
        if place is not None:  # its angle is measured otherwise, or the file names no rate
            self.bars[place] = replace(self.bars[place], rate=self.bars[place].rate or rate)
            return
        taken = {bar.link for bar in self.bars}
        numbers = (found[0] for name in called if (found := re.search(r"\d+$", name)))
        link = next((number for number in numbers if number not in taken), called[0])
        self.bars.append(Bar(link, tuple(dict.fromkeys(corners)), rate))
        if reached(corners[:1], self.points).isdisjoint(c.name for c in self.variant.coordinates):
            self.hinges.append(corners[0])

    def rods(self, pairs: Sequence[frozenset[str]]) -> None:
        """Draw the links of which a file gives only the square of a length between two points."""
        moving = {coordinate.name for coordinate in self.variant.coordinates}
        for ends in pairs:
            corners = sorted(
                ends, key=lambda end: (not moving.isdisjoint(reached([end], self.points)), [*self.points].index(end))
            )
            self.arm(corners, [str(number) for number in range(1, len(self.bars) + 2)], "")

    def arms_of(self, coordinate: str) -> dict[Turning, list[tuple[str, str]]]:
        """Return the ends of the arms of a coordinate: A = D + r1 @ phi1, A + r2 @ phi2 = E, (E - A - r2 @ phi2).x held.

        They are of one link if their angles have the same terms that move.  An angle phi1 + phi2 is one of phi2, the later one.
        """
        written = [(name, formula) for name, formula in self.points.items() if not name.startswith("~")]
        origin = next((named(name) for name, formula in written if is_origin(formula)), None)  # where "A = r @ phi1" begins
        formulas = [(name, Formula("+", (origin, one)) if origin and one.op == "@" else one) for name, one in written]
        for left, right in self.closures:
            tip = next((side for side in (right, left) if side.op == "name" or side in self.named), left)
            formulas += [(self.name_of(tip), side) for side in (left, right) if arm_base(side, coordinate)]
        formulas += [(end, Formula("+", (named(start), arm))) for start, end, arm in self.gaps]
        moving = {one.name: place for place, one in enumerate(self.variant.coordinates)}
        found: dict[Turning, list[tuple[str, str]]] = {}
        for name, formula in sorted(formulas, key=lambda one: sum(1 for _ in terms(one[1]))):  # bars before bent ones
            base, turning = rigid_arm(formula, moving) or ("", frozenset())
            places = [moving[one] for term, _ in turning for one in term.names() if one in moving]
            if places and max(places) == moving[coordinate]:
                found.setdefault(turning, []).append((base, name))
        return found

    def outline(self) -> Outline:
        """Return the outline that was collected."""
        variant = self.variant
        laws = {law.name for law in variant.drive}
        driven = tuple(name for name in self.points if {f"V{name}x", f"V{name}y"} & laws)
        tracks = tuple(self.tracks())
        hinges = tuple(dict.fromkeys(self.hinges))
        cranks = tuple(
            (bar.rate, hinge) for bar in self.bars if bar.rate in variant.given_rates for hinge in hinges if hinge in bar.corners
        )
        return Outline(
            tuple(self.points.items()), tuple(self.bars), tuple(self.slots), tuple(self.blocks), tuple(self.rails),
            tuple(self.wheels), tracks, hinges, driven, cranks,
        )  # fmt: skip

    def tracks(self) -> Iterator[Track]:
        for centre, radius in self.variant.frame.circles:
            at = self.name_of(centre)
            yield Track(at, self.beside(at, radius, number(0)))

    def name_of(self, formula: Formula) -> str:
        """Return the name of the point with a formula; a new point is added if there is none."""
        if formula.op == "name":
            return formula.name
        return self.named.get(formula) or self.added(formula)

    def direction(self, at: str, angle: Formula) -> str:
        """Return a point that lies from `at` in the direction of an angle."""
        return self.beside(at, number(1), angle)

    def beside(self, at: str, length: Formula, angle: Formula) -> str:
        """Return a point at a length and angle from another; the formula of a new point contains that of its base in full."""
        base = self.points[at] if at.startswith("~") else named(at)
        return self.added(Formula("+", (base, Formula("@", (length, angle)))))

    def turning(self, rate: str | None) -> Formula:
        """Return the angle whose rate is given by name, 0 if there is none."""
        found = next((c.name for c in self.variant.coordinates if c.rate == rate), "")
        return named(found) if found else number(0)

    def added(self, formula: Formula) -> str:
        """Return the name of the point with a formula, added if it is new."""
        if formula not in self.named:
            name = f"~{sum(known.startswith('~') for known in self.points)}"
            self.points[name] = formula
            self.named[formula] = name
        return self.named[formula]
