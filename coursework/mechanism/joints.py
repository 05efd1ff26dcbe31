"""The joints of a mechanism, made once: from [links] and [frame] if the file has them, else from its chain of groups.

Enters: a `Variant` and its points as formulas.  Leaves: `Linkage`, the moving bodies and every `Joint` between them.
Used by `mechanism.py` (mobility), `structure.py`, `equations/reduction/meaning.py` and `tracing.py`.
"""

from __future__ import annotations

import cmath
import itertools
import math
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import field, replace

from coursework.mechanism.groups import group_kind
from coursework.mechanism.groups.joint import MESHING, ONE_SHAFT, PIN_IN_GUIDE, PRISMATIC, REVOLUTE, ROLLING, Joint
from coursework.mechanism.one_shaft import first_parts, fixed_links
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate_any, named, with_points
from coursework.variant.record.blocks import blocks_of
from coursework.variant.record.entries import reached
from coursework.variant.record.variant import Coordinate, Group, Link, Variant

FRAME = "0"
_BESIDE = 0.01  # share of the radius of a wheel: a start of few digits is not farther from the line of its rack


@frozen
class Mobility:
    """W = 3 n - 2 p5 - p4 of the links as listed (n moving links; those of one shaft are one)."""

    links: int
    lower_pairs: int
    higher_pairs: int

    @property
    def degrees(self) -> int:
        """Return W."""
        return 3 * self.links - 2 * self.lower_pairs - self.higher_pairs


@frozen
class Linkage:
    """The moving `bodies` by name, and the `joints` between them and with the frame "0".

    In a chain of groups, `coordinates` gives the coordinate of each body and `holds` its named points; both are empty for links,
    which list these themselves.  `parts` gives the body of each link that is no body, as it turns as one with an earlier link.
    """

    bodies: tuple[str, ...]
    joints: tuple[Joint, ...]
    coordinates: Mapping[str, str] = field(default_factory=dict)
    holds: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    parts: Mapping[str, str] = field(default_factory=dict)

    @property
    def shafts(self) -> dict[str, str]:
        """Return for each body the first of those that turn as one with it, itself if there are no others."""
        return first_parts(self.bodies, [joint.bodies for joint in self.joints if joint.kind.is_rigid])

    @property
    def mobility(self) -> Mobility:
        """Return the number of links, and of lower and higher pairs."""
        takes = [joint.kind.takes for joint in self.joints]
        return Mobility(len(self.bodies) - takes.count(3), takes.count(2), takes.count(1))


def with_sliders(found: Linkage, wanted: Callable[[Joint], bool] = lambda joint: True) -> Linkage:
    """Return a linkage in which each pin in a guide gets a slider, a body with two joints that take two freedoms each.

    Only joints for which `wanted` returns True get one.

    >>> from coursework.variant.catalogue import load
    >>> variant = load("example-2")
    >>> with_sliders(linkage(variant, dict(variant.points))).bodies
    ('1', '2', '3')
    """
    bodies, joints = [*found.bodies], []
    for joint in found.joints:
        if not joint.kind.slides or joint.kind.takes > 1 or not wanted(joint):
            joints.append(joint)
            continue
        bodies.append(str(1 + max((int(name) for name in bodies if name.isdecimal()), default=0)))
        joints.append(Joint(REVOLUTE, (joint.bodies[0], bodies[-1]), joint.where))
        joints.append(Joint(PRISMATIC, (bodies[-1], joint.bodies[1]), joint.where, joint.along))
    return replace(found, bodies=tuple(bodies), joints=tuple(joints))


def linkage(variant: Variant, points: Mapping[str, Formula]) -> Linkage | None:
    """Return bodies and joints, None if the file names neither links nor groups, or moves something that these do not show.

    >>> from coursework.variant.catalogue import load
    >>> variant = load("example-2")
    >>> [(joint.kind, joint.bodies) for joint in linkage(variant, dict(variant.points)).joints]
    [(revolute, ('1', '0')), (revolute, ('1', '2')), (pin in guide, ('2', '0'))]
    """
    if variant.links:
        return Linkage(tuple(link.name for link in variant.links), tuple(_of_links(variant)))
    if not variant.groups:
        return None
    beside = _beside_groups(variant)
    if any(c.rate not in variant.known_rates for c in beside):
        return None
    chain = chain_of_groups(variant, points)
    bases = (point for group in variant.groups for point in group.start_points)
    is_whole = {c.name for c in beside} <= {*chain.coordinates.values()} and not any(
        led_by_law(b, variant, points) for b in bases
    )
    return chain if is_whole else None


def led_by_law(formula: Formula, variant: Variant, points: Mapping[str, Formula]) -> bool:
    """Return whether a point, such as a follower, moves by a law of time or of a coordinate only: no listed body carries it."""
    names = reached(formula.names(), points)
    is_carried = not names.isdisjoint(c.name for c in variant.coordinates)
    return not is_carried and not names.isdisjoint(("t", *(law.name for law in variant.functions)))


def _beside_groups(variant: Variant) -> list[Coordinate]:
    in_groups = {name for group in variant.groups for name in group.coordinates}
    return [c for c in variant.coordinates if c.name not in in_groups]


def _of_links(variant: Variant) -> Iterator[Joint]:
    holds: dict[str, list[str]] = {}
    for link in variant.links:
        for name in dict.fromkeys((*link.points, *((link.wheel,) if link.wheel else ()))):
            holds.setdefault(name, []).append(link.name)
    fixed = [*fixed_links(variant.links, dict(variant.points), {c.rate: c.name for c in variant.coordinates})]
    first = first_parts((link.name for link in variant.links), ((one, other) for one, other, _ in fixed))
    for name, holders in holds.items():
        bodies = [body for place, body in enumerate(holders) if first[body] not in {first[one] for one in holders[:place]}]
        if name in variant.frame.hinges:
            yield Joint(REVOLUTE, (bodies[0], FRAME), named(name))
        for pair in itertools.pairwise(bodies):
            yield Joint(REVOLUTE, pair, named(name))
    contacts = {link.contact for link in variant.links}
    racks = blocks_of(variant)
    pins = Counter(racks.get(rider) for rider in riders(variant))  # a rack on two rails runs on a pin in each of them
    for rider, (_, angle) in zip(riders(variant), variant.frame.rails, strict=True):
        if rider in holds and rider not in contacts:
            if rider in racks and pins[racks[rider]] == 1:
                yield Joint(PRISMATIC, (racks[rider], FRAME), named(rider), angle)
            else:
                yield Joint(PIN_IN_GUIDE, (racks.get(rider, holds[rider][0]), FRAME), named(rider), angle)
    yield from _contacts(variant, holds, racks)
    sleeves = {frozenset((link.name, link.slides)): (link.name, link.slides) for link in variant.links if link.slides}
    for sleeve, bar in sleeves.values():
        own = next((name for name, bodies in holds.items() if sleeve in bodies), "")
        yield Joint(PRISMATIC, (sleeve, bar), named(own) if own else None)
    yield from (Joint(ONE_SHAFT, (one, other), named(point)) for one, other, point in fixed)


def riders(variant: Variant) -> tuple[str, ...]:
    """Return for each rail the point that slides on it, "" if none: a guide may be drawn through a pivot at which it begins."""
    pins = {guide.through: group.meets for group in variant.groups for guide in group.guides if group.meets}
    named_in = [(through, through.name if through.op == "name" else "") for through, _ in variant.frame.rails]
    return tuple(pins.get(through) or ("" if name in variant.frame.hinges else name) for through, name in named_in)


def _contacts(variant: Variant, holds: Mapping[str, list[str]], racks: Mapping[str, str]) -> Iterator[Joint]:
    """Yield each contact of a wheel once: with another wheel, the body that holds the point, a rack, or the frame.

    Only a wheel on a pivot of the frame touches a rack.  If a pivot or a carrier holds the centre of the wheel, the contact is a
    meshing one: it only makes both bodies roll alike.
    """
    met: set[str] = set()
    for link in variant.links:
        if not link.contact or link.name in met:
            continue
        on_pivot = link.wheel in variant.frame.hinges
        beside = [other for other in variant.links if other.contact == link.contact and other is not link]
        wheels = [other.name for other in beside]
        middles = {*(other.wheel for other in beside), *(c.name for c, _ in variant.frame.circles if c.op == "name")}
        carriers = [one for one in variant.links if link.wheel in one.points and not middles.isdisjoint(one.points)]
        rack = rack_of(link, variant)
        blocks = [racks[rack]] if rack is not None else [*dict.fromkeys(racks.values())]
        touched = [*wheels, *(body for body in holds.get(link.contact, ()) if body != link.name), *(blocks if on_pivot else ())]
        met.update(wheels)
        kind = MESHING if (on_pivot and touched) or carriers else ROLLING
        yield Joint(kind, (link.name, touched[0] if touched else FRAME), named(link.contact))


def rack_of(wheel: Link, variant: Variant) -> str | None:
    """Return the point of the block that a wheel on a pivot drives as a rack, None if the file does not show which.

    Its line passes through the contact at the start.

    >>> from coursework.variant.catalogue import load
    >>> variant = load("v112")
    >>> [rack_of(link, variant) for link in variant.links if link.wheel]
    ['C']
    """
    if wheel.wheel not in variant.frame.hinges or wheel.contact is None:
        return None
    blocks = blocks_of(variant)
    start = {c.name: c.start_or_guess for c in variant.coordinates}
    known = {"pi": math.pi, "t": 0.0, **variant.values, **{name: value for name, value in start.items() if value is not None}}
    found = []
    with suppress(FormulaFault, KeyError):  # a place that follows from the motion only
        at = with_points(known, variant.points)
        for rider, (_, angle) in zip(riders(variant), variant.frame.rails, strict=True):
            if rider in blocks:
                beside = ((at[wheel.contact] - at[rider]) * cmath.exp(-1j * evaluate_any(angle, at))).imag
                found += [rider] if abs(beside) <= _BESIDE * abs(at[wheel.contact] - at[wheel.wheel]) else []
    return found[0] if len({blocks[rider] for rider in found}) == 1 else None


def chain_of_groups(variant: Variant, points: Mapping[str, Formula]) -> Linkage:
    """Return the linkage of a chain, its bodies named 1, 2, … in order; a coordinate outside the groups has a body of its own.

    A length that places no point has no body until a crank is found that has this length: then it is a slider on that crank.
    """
    numbers = map(str, itertools.count(1))
    carried: dict[str, str] = {}
    joints: list[Joint] = []
    lengths = set()
    for coordinate in _beside_groups(variant):
        moved = next((name for name, formula in variant.points if coordinate.name in formula.names()), "")
        turns = coordinate.unit == "rad"
        if not (turns or moved):
            lengths.add(coordinate.name)
            continue
        base = _carrier(points[moved], carried, points) if moved else FRAME
        carried[coordinate.name] = next(numbers)
        bodies = (carried[coordinate.name], base)
        joints.append(_driven_turn(coordinate, variant, bodies) if turns else _driven_slide(moved, variant, bodies))
    for group in variant.groups:
        own = [next(numbers) for _ in group.coordinates]
        outer = [_carrier(formula, carried, points) for formula in group.start_points]
        joints += group_kind(group.kind).joints(
            group, outer, [_guide(group, i, carried, points) for i in range(len(group.guides))], own
        )
        for coordinate_name, index in reversed([*zip(group.coordinates, group_kind(group.kind).carries, strict=True)]):
            carried[coordinate_name] = own[index]
        for name in sorted(lengths.intersection(group.lengths[0].names())) if group_kind(group.kind).driven else ():
            carried[name] = next(numbers)
            pin = named(group.meets) if group.meets else None
            joints.append(Joint(PRISMATIC, (carried[name], own[0]), pin, named(group.coordinates[0])))
    holds: dict[str, list[str]] = {body: [] for body in carried.values()}
    for name, formula in points.items():
        if (body := _carrier(formula, carried, points)) != FRAME:
            holds[body].append(name)
    coordinates = {body: coordinate for coordinate, body in carried.items()}
    return Linkage(
        tuple(sorted(coordinates, key=int)), tuple(joints), coordinates, {body: tuple(names) for body, names in holds.items()}
    )


def _driven_turn(coordinate: Coordinate, variant: Variant, bodies: tuple[str, str]) -> Joint:
    """Return the pivot of a body turned by an angle outside the groups: at the start of its arm, or on the guide it turns."""
    arms = (formula.args[0] for _, formula in variant.points if formula.op == "+" and coordinate.name in formula.names())
    guides = (g.through for group in variant.groups for g in group.guides if coordinate.name in g.angle.names())
    return Joint(REVOLUTE, bodies, next((base for base in (*arms, *guides) if base.op == "name"), None))


def _driven_slide(moved: str, variant: Variant, bodies: tuple[str, str]) -> Joint:
    """Return the joint by which a length outside the groups moves a point along the guide of the frame through this point."""
    along = next((angle for through, angle in variant.frame.rails if through == named(moved)), None)
    return Joint(PRISMATIC, bodies, named(moved), along)


def link_names(chain: Linkage, variant: Variant) -> dict[str, str]:
    """Return the name of each body of a chain: the number of its rate (w3: 3), turning bodies first; else the next free number.

    >>> from coursework.variant.catalogue import load
    >>> variant = load("walschaerts")
    >>> chain = chain_of_groups(variant, dict(variant.points))
    >>> {chain.coordinates[body]: name for body, name in link_names(chain, variant).items()}
    {'phi1': '1', 'phi2': '2', 'phi3': '3', 'phi4': '4', 's4': '6', 'phi5': '5', 's5': '7'}
    """
    coordinates = {c.name: c for c in variant.coordinates}
    carried = {body: coordinates[name] for body, name in chain.coordinates.items()}
    wanted = dict.fromkeys(chain.bodies, "")
    for body in sorted(chain.bodies, key=lambda body: carried[body].unit != "rad"):
        digits = re.search(r"[1-9]\d*$", carried[body].rate)  # 0 is the frame
        wanted[body] = digits[0] if digits and digits[0] not in wanted.values() else ""
    free = (str(k) for k in range(1, 2 * len(wanted) + 1) if str(k) not in wanted.values())
    return {body: name or next(free) for body, name in wanted.items()}


def _guide(group: Group, index: int, carried: Mapping[str, str], points: Mapping[str, Formula]) -> str:
    """Return the body that carries a guide: the one it turns with, or else the one that holds its point."""
    guide = group.guides[index]
    turning = _carrier(guide.angle, carried, points)
    return turning if turning != FRAME else _carrier(guide.through, carried, points)


def _carrier(formula: Formula, carried: Mapping[str, str], points: Mapping[str, Formula]) -> str:
    """Return the body that a formula moves with: that of the latest coordinate in the formula and in the points it refers to."""
    names = reached(formula.names(), points)
    return next((body for coordinate, body in reversed([*carried.items()]) if coordinate in names), FRAME)
