"""The structure of a mechanism as in a textbook: links, pairs, mobility, Assur groups with class and order.

Enters: a `Mechanism`.  Leaves: `Structure`, None if the file does not show all links and pairs.
Used by `report/sections/structure.py` and `effects/scheme.py`.

A pin that slides in a guide of the frame (one pair of class 4) is shown with its slider, a link with two pairs of class 5: the
mobility is the same, and Assur groups have lower pairs only.  A hinge of three links is shown as one hinge that all three
hold, not as two hinges between pairs of links.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace

from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.joints import FRAME, Linkage, chain_of_groups, link_names, with_sliders
from coursework.mechanism.mechanism import Mechanism
from coursework.mechanism.structure_record import AssurGroup, KinematicPair, Member, Structure
from coursework.system.frozen import changing
from coursework.variant.formula.tree import Formula
from coursework.variant.record.held import driving_laws, rates_without_angle, velocities_of_points
from coursework.variant.record.variant import Variant

PLUS = "+"  # joins the names of links that turn as one: 2+3
DRIVE = "~"  # stands for the drive of a driven point
MOST_LINKS = 12  # the groups of larger mechanisms are not searched, because the search tries all sets of links
FIRST, SECOND = "I", "II"
CLASSES = (FIRST, SECOND, "III", "IV", "V", "VI", "VII", "VIII")


def read_structure(mechanism: Mechanism) -> Structure | None:
    """Return the structure, None if the file shows no links or no drive, or the mobility exceeds the driven freedoms.

    >>> from coursework.mechanism.mechanism import build
    >>> from coursework.variant.catalogue import load
    >>> found = read_structure(build(load("31")))
    >>> found.mobility.degrees, [(group.group_class, group.links) for group in found.groups]
    (2, [('II', ('3', '4')), ('II', ('1', '2'))])
    """
    found = fitting_linkage(mechanism)
    if found is None:
        return None
    bodies, drives = Bodies(mechanism, as_one(with_sliders(found))), driven_freedoms(mechanism.variant)
    return Structure(
        tuple(bodies.members()), tuple(bodies.pairs()), bodies.linkage.mobility, found.mobility, drives, bodies.driven,
        tuple(bodies.groups()) if found.mobility.degrees == drives else (),
    )  # fmt: skip


def as_one(found: Linkage) -> Linkage:
    """Return a linkage in which links that turn as one are one body, called after the first of them."""
    first = {FRAME: FRAME, **found.shafts}
    joints = (
        replace(joint, bodies=(first[joint.bodies[0]], first[joint.bodies[1]]))
        for joint in found.joints
        if not joint.kind.is_rigid
    )
    parts = {body: own for body, own in first.items() if body != own}
    return replace(found, bodies=tuple(body for body in found.bodies if body not in parts), joints=tuple(joints), parts=parts)


def fitting_linkage(mechanism: Mechanism) -> Linkage | None:
    """Return links and joints with as many freedoms as are driven, else with fewer; None if the file shows none such."""
    variant = mechanism.variant
    ways = [mechanism.linkage] if mechanism.linkage is not None else []
    if ways and variant.links and variant.groups:
        ways.append(chain_of_groups(variant, dict(mechanism.points)))
    drives = driven_freedoms(variant)
    fitting = [way for way in ways if way.mobility.degrees == drives] or [way for way in ways if way.mobility.degrees < drives]
    return fitting[0] if fitting and drives else None


def driven_freedoms(variant: Variant) -> int:
    """Return how many freedoms are driven: rates, and components of point velocities."""
    return len(driving_laws(variant))


def in_order(names: Iterable[str]) -> list[str]:
    """Return names of links sorted by number; names that are not numbers come last.

    >>> in_order(["10", "2+3", "rod"])
    ['2+3', '10', 'rod']
    """

    def place(name: str) -> tuple[bool, int, str]:
        first = name.partition(PLUS)[0]
        return (not first.isdigit(), int(first) if first.isdigit() else 0, name)

    return sorted(names, key=place)


@changing
class Bodies:
    """The bodies of one linkage and their names on a page."""

    mechanism: Mechanism
    linkage: Linkage
    named: Mapping[Formula, str] = field(init=False)
    called: dict[str, str] = field(init=False)
    driven: str = field(init=False, default="")

    def __post_init__(self) -> None:
        variant = self.mechanism.variant
        self.named = {formula: name for name, formula in reversed(self.mechanism.points)}
        is_chain = bool(self.linkage.coordinates)
        self.called = link_names(self.linkage, variant) if is_chain else {body: body for body in self.linkage.bodies}
        for part, body in self.linkage.parts.items():
            self.called[body] += PLUS + part
        self.called[FRAME] = FRAME
        self.driven = next((point for point, _ in velocities_of_points(variant).values()), "")

    def point(self, joint: Joint) -> str:
        """Return the name of the point of a joint, "" if it has none."""
        if joint.where is None:
            return ""
        return joint.where.name if joint.where.op == "name" else self.named.get(joint.where, "")

    def points(self) -> dict[str, tuple[str, ...]]:
        """Return the named points that each body holds."""
        held: dict[str, list[str]] = {body: [] for body in self.called}
        for link in () if self.linkage.coordinates else self.mechanism.variant.links:
            body = self.linkage.parts.get(link.name, link.name)
            held[body] += [name for name in (link.wheel, link.contact) if name]
            held[body] += link.points
        for joint in self.linkage.joints:
            for body in joint.holders:
                held[body].append(self.point(joint))
        for body, names in self.linkage.holds.items():
            held[body] += names
        return {body: tuple(dict.fromkeys(name for name in names if name)) for body, names in held.items()}

    def rates(self) -> dict[str, str]:
        """Return the rate of each body."""
        variant = self.mechanism.variant
        if not self.linkage.coordinates:
            return {link.name: link.rate for link in variant.links if link.rate}
        rate_of = {coordinate.name: coordinate.rate for coordinate in variant.coordinates}
        return {body: rate_of[name] for body, name in self.linkage.coordinates.items()}

    def members(self) -> Iterator[Member]:
        """Yield the moving links in the order of their names."""
        points, rates = self.points(), self.rates()
        bodies = {name: body for body, name in self.called.items()}
        for name in in_order(self.called[body] for body in self.linkage.bodies):
            yield Member(name, points[bodies[name]], rates.get(bodies[name], ""), self.kind(bodies[name]))

    def kind(self, body: str) -> str:
        """Return the kind of link of a body: "wheel", "sleeve", "slider", "lever", "pivoted", "coupler" or "link"."""
        own = [joint for joint in self.linkage.joints if body in joint.bodies]
        pivoted = any(FRAME in hinge and body in hinge for hinge in self.hinges().values())
        wheels = (link.name for link in self.mechanism.variant.links if link.wheel)
        if any(self.linkage.parts.get(wheel, wheel) == body for wheel in wheels):
            return "wheel"
        if any(joint.kind.slides and joint.bodies[0] == body for joint in own):
            return "sleeve" if pivoted else "slider"
        if pivoted:
            return "lever" if any(joint.kind.slides for joint in own) else "pivoted"
        return "coupler" if len(own) > 1 else "link"

    def pairs(self) -> Iterator[KinematicPair]:
        """Yield the pairs; in a pair with the frame, the frame comes first."""
        for joint in self.linkage.joints:
            first, second = in_order(self.called[body] for body in joint.bodies)
            yield KinematicPair(joint.kind, (first, second), self.point(joint))

    def hinges(self) -> dict[object, set[str]]:
        """Return the bodies that each hinge joins, keyed by its point, or by the number of its joint if it has no named point."""
        found: dict[object, set[str]] = {}
        for number, joint in enumerate(self.linkage.joints):
            if joint.pins:
                found.setdefault(self.point(joint) or number, set()).update(joint.bodies)
        return found

    def groups(self) -> Iterator[AssurGroup]:
        """Yield driven links and groups in the order of assembly; nothing if this order is not known."""
        for bodies, placed in self.sets():
            yield self._group(bodies, placed)

    def sets(self) -> list[tuple[tuple[str, ...], set[str]]]:
        """Return the bodies of each driven link and group, with those placed before it; empty if the order is not known."""
        found = [*self._found()]
        return found if sum(len(bodies) for bodies, _ in found) == len(self.linkage.bodies) else []

    def _contacts(self) -> list[tuple[set[str], int]]:
        """Return for each joint the bodies that it joins, and the number of freedoms that each body beyond the first loses."""
        hinges, first = self.hinges(), self.linkage.shafts
        if self.driven:
            hinges.setdefault(self.driven, set()).update(
                {DRIVE, *(first.get(b, b) for b, names in self.points().items() if self.driven in names)}
            )
        others = [(set(joint.bodies), joint.kind.takes) for joint in self.linkage.joints if not joint.pins]
        return [*((bodies, 2) for bodies in hinges.values()), *others]

    def _driven_bodies(self) -> list[str] | None:
        """Return the body of each driven rate; None if a rate has no body, or a point is not driven as a whole, alone."""
        variant, rates = self.mechanism.variant, self.rates()
        sliding = {link.name for link in variant.links if link.slides}
        found = []
        for rate in (*variant.known_rates, *rates_without_angle(variant)):
            bodies = [body for body, own in rates.items() if own == rate and body not in sliding]
            if not bodies:
                return None
            found.append(bodies[0])
        parts = [point for point, _ in velocities_of_points(variant).values()]
        return found if parts == 2 * [self.driven] or not parts else None

    def _found(self) -> Iterator[tuple[tuple[str, ...], set[str]]]:
        """Yield the smallest sets of bodies that the placed ones and their drives leave no freedom, each with those placed."""
        driven, contacts, rest = self._driven_bodies(), self._contacts(), [*self.linkage.bodies]
        placed = {FRAME, DRIVE}
        if driven is None or len(rest) > MOST_LINKS:
            return
        while rest:
            sets = (some for size in range(1, len(rest) + 1) for some in itertools.combinations(rest, size))
            held = next((some for some in sets if not _freedoms(some, placed, contacts, driven)), None)
            if held is None or (len(held) > 1 and set(held) & set(driven)):
                return
            yield held, set(placed)
            placed.update(held)
            rest = [body for body in rest if body not in held]

    def _group(self, bodies: tuple[str, ...], placed: set[str]) -> AssurGroup:
        names = in_order(self.called[body] for body in bodies)
        outer, inner = [], []
        for joined, _ in self._contacts():
            own = [body for body in bodies if body in joined]
            outer += [own[0]] if own and joined & placed else []
            inner += [*itertools.pairwise(own)]
        if len(bodies) == 1 and bodies[0] in (self._driven_bodies() or ()):
            stands_on = next(
                (body for joined, _ in self._contacts() if bodies[0] in joined for body in sorted(joined & placed)), FRAME
            )
            return AssurGroup((self.called.get(stands_on, FRAME), *names), FIRST)
        held = [sum(bodies_of.count(body) for bodies_of in (outer, *inner)) for body in bodies]
        number = max(*held, _longest_contour(bodies, inner), 2)
        return AssurGroup(tuple(names), CLASSES[min(number, len(CLASSES)) - 1], len(outer), self._dyad(bodies, placed))

    def _dyad(self, bodies: tuple[str, ...], placed: set[str]) -> str:
        """Return a name such as "RRP" for a dyad of revolute and prismatic pairs, "" for any other group."""
        if len(bodies) != 2:
            return ""
        first, second = bodies
        kinds: dict[object, str] = {}
        if self.driven:
            kinds[first if self.driven in self.points()[first] else second] = "R"
        for joint in self.linkage.joints:
            inside = [body for body in joint.bodies if body in bodies]
            key: object = "inner" if len(inside) == 2 else inside[0] if inside else ""
            if key and (key == "inner" or set(joint.bodies) & placed):
                kinds[key] = joint.kind.letter
        if len(kinds) != 3 or not all(kinds.values()):
            return ""
        word = kinds[first] + kinds["inner"] + kinds[second]
        return max(word, word[::-1]) if word[0] != word[2] else word


def _freedoms(some: Iterable[str], placed: set[str], contacts: list[tuple[set[str], int]], driven: list[str]) -> int:
    """Return the freedoms that the bodies `some` keep when `placed` bodies and their own drives are given."""
    own = set(some)
    free = 3 * len(own) - sum(driven.count(body) for body in own)
    for joined, takes in contacts:
        here, before = len(joined & (own | placed)), len(joined & placed)
        if joined & own:
            free -= takes * (here - 1 - max(before - 1, 0))
    return free


def _longest_contour(bodies: tuple[str, ...], joined: list[tuple[str, str]]) -> int:
    """Return how many links the longest closed contour without a shortcut has, 0 if there is no closed contour."""
    beside = {body: {a if b == body else b for a, b in joined if body in {a, b}} for body in bodies}
    longest = 0
    ways: list[tuple[str, ...]] = [(body,) for body in bodies]
    while ways:
        way = ways.pop()
        for following in beside[way[-1]]:
            across = beside[following].intersection(way[:-1])
            if following not in way and not across:
                ways.append((*way, following))
            elif following not in way and across == {way[0]} and len(way) > 1:
                longest = max(longest, len(way) + 1)
    return longest
