"""The reader of a mechanism and its masses for Newton's laws, which reports all faults of the masses at once.

Enters: a `Mechanism` whose variant names masses or forces.  Leaves: `ForceScheme`, still in formulas.  Raises `InputError`.
Used by `analysis.py` and `draft.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from coursework.effects.force_scheme import Body, Direction, ForceScheme, Unknown, numbered
from coursework.effects.loose import Pairs, loose
from coursework.effects.slid_length import slid_length
from coursework.effects.turned_back import turned_back
from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.joints import FRAME, with_sliders
from coursework.mechanism.mechanism import Mechanism
from coursework.mechanism.structure import Bodies, driven_freedoms, fitting_linkage, in_order
from coursework.variant.formula.tree import Formula, named, number, signed, spelled
from coursework.variant.record.blocks import blocks_of
from coursework.variant.record.entries import reached
from coursework.variant.record.forces import DISC, POINT, ROD, Forces, Mass
from coursework.variant.record.held import followed, rates_without_angle, velocities_of_points
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say


def read_scheme(mechanism: Mechanism, instead: Forces | None = None, near: Callable[[], Pairs] | None = None) -> ForceScheme:
    """Return bodies and unknown forces, for the file's own masses or those given as `instead`.

    Raises `InputError` with every fault of the masses; where a joint is missing, `near` gives the points that may be hinges.
    """
    variant, forces = mechanism.variant, instead or mechanism.variant.forces
    if forces is None:
        raise InputError([Fault(say("fault.V721"), variant.file, 1)])
    found = fitting_linkage(mechanism)
    if found is None or rates_without_angle(variant):
        raise InputError([loose(mechanism, near)])
    weighed = {one.body for one in forces.masses} | {load.on for load in forces.loads}
    blocks = with_sliders(found, lambda joint: bool(variant.groups) or (joint.where is not None and joint.where.name in weighed))
    return _Reader(mechanism, Bodies(mechanism, blocks), forces).scheme()


@dataclass(slots=True)
class _Reader:
    mechanism: Mechanism
    bodies: Bodies
    forces: Forces
    faults: list[Fault] = field(default_factory=list)

    @property
    def variant(self) -> Variant:
        return self.mechanism.variant

    def scheme(self) -> ForceScheme:
        called = self.bodies.called
        masses: dict[str, Mass] = {}
        for mass in self.forces.masses:
            path = ("masses", mass.body)
            if (body := self.body_of(mass.body, path)) and masses.setdefault(body, mass) is not mass:
                self.fault(path, say("fault.V734", name=body, first=masses[body].body, second=mass.body))
        for load in (*self.forces.loads, *(self.forces.motor.torques if self.forces.motor else ())):
            path = ("forces" if load in self.forces.loads else "motor", load.name)
            on, base = self.body_of(load.on, path), load.source if load.source == FRAME else self.body_of(load.source, path)
            if on and on == base:
                self.fault(path, say("fault.V719", name=on))
        own = {called[body]: body for body in self.bodies.linkage.bodies}
        bodies = tuple(self.body(name, own[name], masses.get(name)) for name in in_order(own))
        pins, unknowns = self.joints()
        self.check_friction(unknowns)
        groups = tuple(tuple(in_order(called[body] for body in some)) for some, _ in self.bodies.sets())
        holds = {called[body]: points for body, points in self.bodies.points().items()}
        if self.faults:
            raise InputError(self.faults)
        return ForceScheme(bodies, pins, (*unknowns, *self.drives()), groups, self.forces, holds)

    def fault(self, path: tuple[str, ...], message: Sentence) -> None:
        self.faults.append(Fault(message, self.variant.file, self.variant.nearest_line(*path), 0, ".".join(path)))

    def body_of(self, name: str, path: tuple[str, ...]) -> str:
        """Return the name of the body meant by a key of the file (a link, or a block by its point); "" after noting a fault."""
        names = {self.bodies.called[body] for body in self.bodies.linkage.bodies}
        if name in names:
            return name
        sliding = {joint.bodies[0] for joint in self.bodies.linkage.joints if joint.kind.slides}
        for body, points in self.bodies.points().items():
            if name in points and body in sliding:
                return self.bodies.called[body]
        self.fault(path, say("fault.V723", name=name, hint=closest(name, sorted(names)), known=", ".join(in_order(names))))
        return ""

    def body(self, name: str, body: str, mass: Mass | None) -> Body:
        link = next((link for link in self.variant.links if link.name == body and not self.bodies.linkage.coordinates), None)
        points, rate, span = self.places(body), self.rate_of(body), self.span_of(body)
        if link is not None and link.wheel and link.contact:
            span = named(link.wheel), named(link.contact)
        centre, path = mass.centre if mass else None, ("masses", mass.body if mass else name)
        if centre is None:
            if link is not None and link.wheel:
                centre = named(link.wheel)
            elif mass is not None and len(points) > 2:
                self.fault(path, say("fault.V724", name=name, points=", ".join(point.name or spelled(point) for point in points)))
            elif len(points) == 2:
                centre = Formula("/", (Formula("+", (points[0], points[1])), number(2)))
        centre = centre or (points[0] if points else Formula("pair", (number(0), number(0))))
        nameless = link is not None and link.rate is None and link.name not in blocks_of(self.variant).values()
        turns = bool(rate) or (nameless and span is not None)
        inertia = mass.inertia if mass else None
        if mass is not None and inertia is None and turns:
            self.fault(path, say("fault.V725", name=name))
        is_shaped = len(points) == 2 if inertia == ROD else link is not None and bool(link.wheel)
        if inertia in {ROD, DISC} and (span is None or not is_shaped):
            self.fault(path, say("fault.V726", name=name, shape=inertia))
        return Body(name, rate, centre, mass.mass if mass else None, None if inertia == POINT else inertia, span, turns)

    def rate_of(self, body: str) -> str:
        """Return the rate a body turns with: its own, or that of the guide in which it cannot turn; "" for none."""
        rates, units = self.bodies.rates(), {c.rate: c.unit for c in self.variant.coordinates}
        rate = rates.get(body, "")
        if rate and units.get(rate, "rad") == "rad":
            return rate
        guide = self.guide_of(body)
        return self.rate_of(guide) if guide else ""

    def span_of(self, body: str) -> tuple[Formula, Formula] | None:
        """Return two points that turn as a body does: its own, or those of the guide in which it cannot turn; None for none."""
        points, guide = self.places(body), self.guide_of(body)
        return (points[0], points[1]) if len(points) > 1 else self.span_of(guide) if guide else None

    def places(self, body: str) -> list[Formula]:
        """Return the points of a body: those with a name, then its joints without one."""
        joints = (one for one in self.bodies.linkage.joints if body in one.holders and not self.bodies.point(one))
        return list(dict.fromkeys([*map(named, self.bodies.points()[body]), *(one.where for one in joints if one.where)]))

    def guide_of(self, body: str) -> str:
        """Return the moving body on which a body slides without turning, "" if there is none."""
        pairs = (one.bodies for one in self.bodies.linkage.joints if one.kind.slides and one.kind.takes > 1)
        return next((guide for block, guide in pairs if block == body and guide != FRAME), "")

    def check_friction(self, unknowns: list[Unknown]) -> None:
        """Note a fault for each friction entry that cannot rub: at a point that is no joint, or at a pin without a radius."""
        if not self.forces.friction:
            return
        from coursework.effects.friction.friction import rubbing

        known = ", ".join(dict.fromkeys(one.at.name for one in unknowns if one.at is not None and one.at.name))
        for rubs in self.forces.friction:
            if not any(True for _ in rubbing(unknowns, rubs)):
                self.fault(("friction", rubs.at), say("fault.V748", point=rubs.at, known=known))

    def joints(self) -> tuple[tuple[str, ...], list[Unknown]]:
        """Return the pins of more than two links, and the unknowns of all joints in the order of the joints."""
        pins: list[str] = []
        found: list[Unknown] = []
        for joint in self.bodies.linkage.joints:
            if (point := self.bodies.point(joint)) != "":
                joint = replace(joint, where=named(point))  # friction is given by the name of the point
            if not joint.pins:
                way = self.fixed if joint.kind.is_rigid else self.sliding if joint.kind.slides else self.rolling
                found += numbered([*way(joint)], found)
                continue
            held = self.bodies.hinges()[point] if point else set(joint.bodies)
            names = in_order(self.bodies.called[body] for body in held)
            if point in pins:
                continue
            if joint.where is None:
                self.fault(("points",), say("fault.V727", names=" – ".join(names)))
                continue
            pairs = [(f"R{_pair(*names[:2])}", names[1], names[0])]
            if len(names) > 2:
                pins.append(point)
                pairs = [(f"R{_pair(point, name)}", name, point) for name in names]
            found += [Unknown(f"{name}{axis}", on, off, joint.where, Direction(axis)) for name, on, off in pairs for axis in "xy"]
        return tuple(pins), found

    def fixed(self, joint: Joint) -> Iterator[Unknown]:
        off, on = in_order(self.bodies.called[body] for body in joint.bodies)
        yield from (Unknown(f"R{_pair(off, on)}{axis}", on, off, joint.where, Direction(axis)) for axis in "xy")
        yield Unknown(f"K{_pair(off, on)}", on, off, None, Direction("couple"))

    def sliding(self, joint: Joint) -> Iterator[Unknown]:
        block, guide = (self.bodies.called[body] for body in joint.bodies)
        yield Unknown(f"N{_pair(guide, block)}", block, guide, joint.where, Direction("across", *self.line_of(joint)))
        if joint.kind.takes > 1:  # a bare pin can turn in its guide
            yield Unknown(f"K{_pair(guide, block)}", block, guide, None, Direction("couple"))

    def line_of(self, joint: Joint) -> tuple[Formula | None, tuple[Formula, Formula] | None]:
        """Return the angle of a guide, or two points on it."""
        along = joint.along or (slid_length(self.bodies, joint) or ("", None))[1]
        points = [named(point) for point in self.bodies.points()[joint.bodies[1]]]
        if along is None and len(points) < 2:
            self.fault(("links", joint.bodies[1]), say("fault.V728", name=joint.bodies[1]))
            points = [named(self.variant.points[0][0])] * 2
        return along, None if along is not None else (points[0], points[1])

    def rolling(self, joint: Joint) -> Iterator[Unknown]:
        first, second = (self.bodies.called[body] for body in joint.bodies)
        off, on = in_order((first, second))
        contact = joint.where
        rail = next((angle for through, angle in self.variant.frame.rails if through == contact), None)
        along, across = Direction("along", rail), Direction("across", rail)
        if rail is None and contact is not None:
            wheels = {link.name: link.wheel for link in self.variant.links if link.wheel}
            to_centre = contact, named(wheels.get(on) or wheels[first])
            along, across = Direction("tangent", None, to_centre), Direction("along", None, to_centre)
        yield Unknown(f"T{_pair(off, on)}", on, off, contact, along)
        if joint.kind.takes > 1:  # meshing wheels only keep their speed ratio
            yield Unknown(f"N{_pair(off, on)}", on, off, contact, across)

    def drives(self) -> Iterator[Unknown]:
        """Yield the unknowns of the drives: a couple for a driven rate, a force for a slide or for an axis of a driven point."""
        variant, rates, called = self.variant, self.bodies.rates(), self.bodies.called
        units = {c.rate: c.unit for c in variant.coordinates}
        several = len(variant.known_rates) > 1
        sliding, opposite = {link.name for link in variant.links if link.slides}, turned_back(variant)
        for rate in variant.known_rates:
            alike = next(([rate, other] for other in rates.values() if {rate, other} in opposite), [rate])
            body = next((body for one in alike for body, own in rates.items() if own == one and body not in sliding), None)
            if body is None:
                yield self.arm(rate, f"{'F' if units[rate] == 'm' else 'M'}{rate if several else ''}")
                continue
            name = called[body]
            slide = next((j for j in self.bodies.linkage.joints if j.kind.slides and j.bodies[0] == body), None)
            if units[rate] == "m" and slide is not None:
                along = Direction("along", *self.line_of(slide))
                yield Unknown(f"F{name if several else ''}", name, called[slide.bodies[1]], slide.where, along, rate)
            else:
                couple = Direction("couple")
                yield Unknown(f"M{name if several else ''}", name, called[self.stands_on(body)], None, couple, rate)
        parts = followed(variant)
        if self.bodies.linkage.mobility.degrees == driven_freedoms(variant):  # whatever [closure] says of them
            parts |= velocities_of_points(variant)
        for velocity, (point, axis) in parts.items():
            if holders := [body for body, points in self.bodies.points().items() if point in points and body != FRAME]:
                yield Unknown(f"F{point}{axis}", called[holders[0]], FRAME, named(point), Direction(axis), velocity)

    def arm(self, rate: str, name: str) -> Unknown:
        """Return the drive of a driven rate that belongs to no link, at the point of a link that it moves.

        For an angle it is the couple that turns a link about a hinge, or else an arm; for a length it is the force along it.
        """
        variant = self.variant
        coordinate = next(c.name for c in variant.coordinates if c.rate == rate)
        wheels = [(link.name, link.wheel) for link in variant.links if link.wheel]
        held = wheels + [(body, point) for body, names in self.bodies.points().items() if body != FRAME for point in names]
        moved = [(body, point) for body, point in held if coordinate in self.moved_by(point)]
        for body, point in moved:
            base = self.turned_from(body, point, coordinate)
            if base is not None:
                return Unknown(name, self.bodies.called[body], self.bodies.called[base], None, Direction("couple"), rate)
        for joint in self.bodies.linkage.joints:
            if (length := slid_length(self.bodies, joint)) is not None and length[0] == coordinate:
                block, guide = (self.bodies.called[body] for body in joint.bodies)
                return Unknown(name, block, guide, joint.where, Direction("along", length[1]), rate)
        for body, point in moved:
            slope, carrier = Direction("slope", coordinate=coordinate), self.carrier(self.moved_by(point) - {coordinate})
            return Unknown(name, self.bodies.called[body], self.bodies.called[carrier], named(point), slope, rate)
        raise InputError([Fault(say("fault.V729", name=rate), variant.file, variant.nearest_line("drive", rate))])

    def moved_by(self, point: str) -> set[str]:
        """Return the coordinates from which a point is built."""
        return {c.name for c in self.variant.coordinates} & set(reached([point], dict(self.mechanism.points)))

    def turned_from(self, body: str, point: str, coordinate: str) -> str | None:
        """Return the link to which a body is hinged, if one coordinate alone turns a point of it about the hinge; else None."""
        points, others = dict(self.mechanism.points), self.moved_by(point) - {coordinate}
        nodes = [node for name in reached([point], points) if name in points for node in points[name].walk()]
        angles = [term for node in nodes if node.op == "@" for term, sign in signed(node.args[1]) if sign > 0]
        if angles.count(named(coordinate)) != nodes.count(named(coordinate)):  # it stands elsewhere, too, or counts clockwise
            return None
        bases = [
            base for joint in self.bodies.linkage.joints
            if joint.pins and body in joint.bodies and (pin := self.bodies.point(joint)) and self.moved_by(pin) == others
            for base in joint.bodies if base != body
        ]  # fmt: skip
        return FRAME if FRAME in bases else next(iter(bases), None)

    def carrier(self, others: set[str]) -> str:
        """Return the link that takes along a point moved by one coordinate and `others`: the one that only `others` move."""
        for body, held in self.bodies.points().items() if others else ():
            if body != FRAME and any(self.moved_by(point) == others for point in held):
                return body
        return FRAME

    def stands_on(self, body: str) -> str:
        """Return the body from which a turning body is driven: the frame if its shaft is hinged there, else its neighbour."""
        linkage = self.bodies.linkage
        shaft = {part for part, first in linkage.shafts.items() if first == linkage.shafts[body]}
        if any(FRAME in held and shaft & held for held in self.bodies.hinges().values()):
            return FRAME
        pins = (joint.bodies for joint in linkage.joints if joint.pins and shaft & {*joint.bodies})
        return next((other for pair in pins for other in pair if other not in shaft), FRAME)


def _pair(first: str, second: str) -> str:
    """Return the suffix for two links: 12, or 1_12 if a name is longer than one letter."""
    return first + second if len(first) == len(second) == 1 else f"{first}_{second}"
