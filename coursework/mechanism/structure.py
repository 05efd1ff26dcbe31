"""The structure of a mechanism as a textbook tells it: links, pairs, mobility, Assur groups with class and order.

Enters: a `Mechanism`.  Leaves: `Structure`, None where a file does not show all links and pairs.
Used by `report/sections/structure.py` and `effects/scheme.py`.

A pin that slides in a guide of the frame (one pair of class 4) is shown with its slider, a link with two pairs of class 5: the
mobility is the same, and groups are made of lower pairs.  Of two ways to name a hinge of three links none is taken: it is one
hinge that all of them hold.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.joints import FRAME, Linkage, chain_of_groups, link_names, with_sliders
from coursework.mechanism.mechanism import Mechanism
from coursework.mechanism.structure_record import AssurGroup, KinematicPair, Member, Structure
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Variant

DRIVE = "~"  # stands for what moves a driven point
MOST_LINKS = 12  # of a mechanism whose groups are looked for among all sets of its links
FIRST, SECOND = "I", "II"
CLASSES = (FIRST, SECOND, "III", "IV", "V", "VI", "VII", "VIII")


def read_structure(mechanism: Mechanism) -> Structure | None:
    """Return the structure; None where a file names no links, or leaves the mechanism more mobility than is driven.

    >>> from coursework.mechanism.mechanism import build
    >>> from coursework.variant.catalogue import load
    >>> found = read_structure(build(load("31")))
    >>> found.mobility.degrees, [(group.group_class, group.links) for group in found.groups]
    (2, [('II', ('3', '4')), ('II', ('1', '2'))])
    """
    found = fitting_linkage(mechanism)
    if found is None:
        return None
    bodies, drives = Bodies(mechanism, with_sliders(found)), _drives(mechanism.variant)
    return Structure(
        tuple(bodies.members()), tuple(bodies.pairs()), bodies.linkage.mobility, found.mobility, drives, bodies.driven,
        tuple(bodies.groups()) if found.mobility.degrees == drives else (),
    )  # fmt: skip


def fitting_linkage(mechanism: Mechanism) -> Linkage | None:
    """Return the links and joints whose freedoms are those that are driven, or fewer; None where a file does not show them."""
    variant = mechanism.variant
    ways = [mechanism.linkage] if mechanism.linkage is not None else []
    if ways and variant.links and variant.groups:
        ways.append(chain_of_groups(variant, dict(mechanism.points)))
    drives = _drives(variant)
    fitting = [way for way in ways if way.mobility.degrees == drives] or [way for way in ways if way.mobility.degrees < drives]
    return fitting[0] if fitting and drives else None


def _drives(variant: Variant) -> int:
    """Return how many freedoms are driven: rates, and velocities of points along the axes."""
    laws = {law.name for law in variant.drive}
    return len(variant.known_rates) + len(laws.intersection(_axes(variant)))


def _axes(variant: Variant) -> dict[str, str]:
    """Return the names of velocities along the axes, such as VMx, with their points."""
    return {f"V{name}{axis}": name for name, _ in variant.points for axis in "xy"}


def in_order(names: Iterable[str]) -> list[str]:
    """Return names of links by their numbers, others behind.

    >>> in_order(["10", "2", "rod"])
    ['2', '10', 'rod']
    """
    return sorted(names, key=lambda name: (not name.isdigit(), int(name) if name.isdigit() else 0, name))


@dataclass(slots=True)
class Bodies:
    """The bodies of one linkage and what a page calls them."""

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
        self.called[FRAME] = FRAME
        laws, axes = {law.name for law in variant.drive}, _axes(variant)
        self.driven = next((point for velocity, point in axes.items() if velocity in laws), "")

    def point(self, joint: Joint) -> str:
        """Return the name of the point of a joint."""
        if joint.where is None:
            return ""
        return joint.where.name if joint.where.op == "name" else self.named.get(joint.where, "")

    def points(self) -> dict[str, tuple[str, ...]]:
        """Return the named points that each body holds."""
        held: dict[str, list[str]] = {body: [] for body in self.called}
        for link in () if self.linkage.coordinates else self.mechanism.variant.links:
            held[link.name] += [name for name in (link.wheel, link.contact) if name]
            held[link.name] += link.points
        for joint in self.linkage.joints:
            for body in joint.holders:
                held[body].append(self.point(joint))
        for body, names in self.linkage.holds.items():
            held[body] += names
        return {body: tuple(dict.fromkeys(name for name in names if name)) for body, names in held.items()}

    def rates(self) -> dict[str, str]:
        """Return the rate that each body goes with."""
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
        """Return what kind of link a body is."""
        own = [joint for joint in self.linkage.joints if body in joint.bodies]
        pivoted = any(FRAME in hinge and body in hinge for hinge in self.hinges().values())
        if any(link.name == body and link.wheel for link in self.mechanism.variant.links):
            return "wheel"
        if any(joint.kind.slides and joint.bodies[0] == body for joint in own):
            return "sleeve" if pivoted else "slider"
        if pivoted:
            return "lever" if any(joint.kind.slides for joint in own) else "pivoted"
        return "coupler" if len(own) > 1 else "link"

    def pairs(self) -> Iterator[KinematicPair]:
        """Yield the pairs, those of the frame with it in the first place."""
        for joint in self.linkage.joints:
            first, second = in_order(self.called[body] for body in joint.bodies)
            yield KinematicPair(joint.kind, (first, second), self.point(joint))

    def hinges(self) -> dict[object, set[str]]:
        """Return the bodies that each hinge joins, by its point, or by its number where it has none."""
        found: dict[object, set[str]] = {}
        for number, joint in enumerate(self.linkage.joints):
            if joint.pins:
                found.setdefault(self.point(joint) or number, set()).update(joint.bodies)
        return found

    def groups(self) -> Iterator[AssurGroup]:
        """Yield driven links and groups in the order in which they can be put together; nothing where that is not known."""
        for bodies, placed in self.sets():
            yield self._group(bodies, placed)

    def sets(self) -> list[tuple[tuple[str, ...], set[str]]]:
        """Return the bodies of each driven link and group, with what was placed before it; none where that is not known."""
        found = [*self._found()]
        return found if sum(len(bodies) for bodies, _ in found) == len(self.linkage.bodies) else []

    def _contacts(self) -> list[tuple[set[str], int]]:
        """Return what joins bodies: which, and how many freedoms each beyond the first loses."""
        hinges = self.hinges()
        if self.driven:
            hinges.setdefault(self.driven, set()).update(
                {DRIVE, *(b for b, names in self.points().items() if self.driven in names)}
            )
        others = [(set(joint.bodies), joint.kind.takes) for joint in self.linkage.joints if not joint.pins]
        return [*((bodies, 2) for bodies in hinges.values()), *others]

    def _driven_bodies(self) -> list[str] | None:
        """Return the body of each rate that is driven; None where a drive is none of a body, or of half a point."""
        variant, rates = self.mechanism.variant, self.rates()
        sliding = {link.name for link in variant.links if link.slides}
        found = []
        for rate in variant.known_rates:
            bodies = [body for body, own in rates.items() if own == rate and body not in sliding]
            if not bodies:
                return None
            found.append(bodies[0])
        halves = _drives(variant) - len(variant.known_rates)
        return found if halves == (2 if self.driven else 0) else None

    def _found(self) -> Iterator[tuple[tuple[str, ...], set[str]]]:
        """Yield the smallest sets of bodies that what is placed already and their drives hold, with what was placed."""
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
        """Return "RRP" for a dyad of turning and sliding pairs, "" for another group."""
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
    """Return the freedoms that bodies keep beside placed ones and their drives."""
    own = set(some)
    free = 3 * len(own) - sum(driven.count(body) for body in own)
    for joined, takes in contacts:
        here, before = len(joined & (own | placed)), len(joined & placed)
        if joined & own:
            free -= takes * (here - 1 - max(before - 1, 0))
    return free


def _longest_contour(bodies: tuple[str, ...], joined: list[tuple[str, str]]) -> int:
    """Return how many links the longest closed contour without a shorter way across has, 0 where none closes."""
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
