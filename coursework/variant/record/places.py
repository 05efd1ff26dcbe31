"""Every place of a variant whose dimension is known or must agree with others, in the order of checking.

Enters: a `Variant` as read.  Leaves: the dimensions of its names, and `Place`s.  Used by `dimension_check.py`, and where
lines of students are read and judged.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from coursework.system.frozen import frozen
from coursework.variant.dimensions.exponents import LENGTH, NUMBER, TIME, Dimension, added, dimension_of
from coursework.variant.dimensions.formulas import Clash, Measurer
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.variant import Constraint, Group, Variant
from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentences import say

_LENGTH: Dimension = {LENGTH: 1}
_TIME: Dimension = {TIME: 1}
_SPEED: Dimension = {LENGTH: 1, TIME: -1}


@frozen
class Place:
    """The formulas of one key of the file: all must have the dimension `wanted` (None: only the same dimension).

    `label` names what the formula defines ("VMy" in VMy = …); `velocity` tells that it is a velocity equation.
    """

    path: KeyPath
    formulas: tuple[Formula, ...]
    wanted: Dimension | None = None
    label: str = ""
    velocity: bool = False


def measures(variant: Variant, free: Collection[KeyPath] = ()) -> dict[str, Dimension]:
    """Return the dimension of every name; names without a unit, and the data at the paths `free`, are unknowns."""
    names: dict[str, Dimension] = {"t": _TIME, "pi": NUMBER}
    for given in variant.given:
        unknown = not given.si or ("given", given.name) in free
        names[given.name] = {given.name: 1} if unknown else dimension_of(given.si)
    for law in variant.laws:
        names[law.name] = {law.name: 1}
    for coordinate in variant.coordinates:
        # A bare number may be a length or an angle: the reader's guess does not decide this here.
        unknown = not coordinate.unit_was_given or ("coordinates", coordinate.name) in free
        names[coordinate.name] = {coordinate.name: 1} if unknown else dimension_of(coordinate.unit)
        names[coordinate.rate] = added(names[coordinate.name], _TIME, -1)
    for name, unit in variant.unknowns:
        names[name] = {name: 1} if not unit or ("unknowns", name) in free else dimension_of(unit)
    if variant.driven:
        names |= {f"V{variant.driven}{part}": _SPEED for part in "xy"}
    points = [name for name, _ in variant.points] + [group.meets for group in variant.groups if group.meets]
    return names | dict.fromkeys(points, _LENGTH)


def has_one_dimension(tree: Formula, variant: Variant, *, plainly: bool = False) -> bool:
    """Return whether all terms of a formula may have one dimension; with `plainly`, a number beside any name has none itself."""
    names = measures(variant)
    try:
        Measurer(names, frozenset(names if plainly else (one.name for one in variant.given if one.si))).measure(tree)
    except Clash:
        return False
    return True


def places(variant: Variant, names: Mapping[str, Dimension], times: Mapping[KeyPath, Formula]) -> Iterator[Place]:
    """Yield constraints, geometry, drive, functions, forces and times; `times` are the formulas of [time] and of pieces."""
    for constraint in variant.constraints:
        # An equation that is not linear is refused for that reason later, by the code that solves it.
        if constraint.is_closure or max(_degree(side, variant.sought) for side in constraint.sides) <= 1:
            yield _constraint(constraint)
    yield from _geometry(variant)
    for path, formula in variant.formulas_of_laws():
        yield Place(path, (formula,), names[str(path[1])], str(path[1]))
    for path, formula, si in variant.forces.measured() if variant.forces is not None else ():
        yield Place(path, (formula,), dimension_of(si), ".".join(map(str, path)))
    for path, formula in times.items():
        yield Place(path, (formula,), _TIME, str(path[1]))


def lengths_of(variant: Variant) -> Iterator[Formula]:
    """Yield the length of every vector, L of `L @ angle`, and the lengths of the groups."""
    yield from (node.args[0] for _, formula in variant.formulas() for node in formula.walk() if node.op == "@")
    yield from (length for group in variant.groups for length in group.lengths)


def _constraint(constraint: Constraint) -> Place:
    return Place(
        constraint.path, constraint.sides, None, say("place.constraint", name=constraint.name), not constraint.is_closure
    )


def _degree(tree: Formula, velocities: Collection[str]) -> int:
    """Return the degree of a formula in the velocities; 2 also stands for formulas that are not polynomials."""
    if tree.op == "name":
        return int(tree.name in velocities)
    degrees = [_degree(arg, velocities) for arg in tree.args]
    if tree.op in {"call", "^"} or (tree.op == "/" and degrees[1]):
        return 2 * max(degrees)
    return sum(degrees) if tree.op == "*" else max(degrees, default=0)


def _geometry(variant: Variant) -> Iterator[Place]:
    for name, formula in variant.points:
        yield Place(("points", name), (formula,), _LENGTH, name)
    for index, formula in enumerate(variant.holds):
        yield Place(("closure", "holds", index), (formula,), None, "[closure]")
    for binding in variant.bindings:
        if binding.along is not None:
            yield Place(("unknowns", binding.name, "along"), (binding.along,), NUMBER, say("place.along", name=binding.name))
    for index, group in enumerate(variant.groups):
        yield from _group(("group", index), group)
    for index, (through, angle) in enumerate(variant.frame.rails):
        yield Place(("frame", "rails", index, "through"), (through,), _LENGTH, say("place.rail.through", number=index + 1))
        yield Place(("frame", "rails", index, "angle"), (angle,), NUMBER, say("place.rail.angle", number=index + 1))
    for index, (center, radius) in enumerate(variant.frame.circles):
        yield Place(("frame", "circles", index, "center"), (center,), _LENGTH, say("place.circle.center", number=index + 1))
        yield Place(("frame", "circles", index, "radius"), (radius,), _LENGTH, say("place.circle.radius", number=index + 1))


def _group(path: KeyPath, group: Group) -> Iterator[Place]:
    number = int(path[1]) + 1

    def place(key: KeyPath, formula: Formula, wanted: Dimension) -> Place:
        index = next((part + 1 for part in key if isinstance(part, int)), 0)
        return Place((*path, *key), (formula,), wanted, say(f"place.group.{key[0]}", number=index, group=number))

    for index, point in enumerate(group.start_points):
        yield place(("from", index), point, _LENGTH)
    for index, length in enumerate(group.lengths):
        yield place(("lengths", index), length, _LENGTH)
    for index, coordinate in enumerate(group.coordinates):
        wanted = NUMBER if index < GROUP_KINDS[group.kind] else _LENGTH
        yield place(("coordinates", index), named(coordinate), wanted)
    for index, guide in enumerate(group.guides):
        yield place(("guides", index, "through"), guide.through, _LENGTH)
        yield place(("guides", index, "angle"), guide.angle, NUMBER)
        yield place(("guides", index, "offset"), guide.offset, _LENGTH)
    yield place(("offset",), group.offset, _LENGTH)
    if group.angle is not None:
        yield place(("angle",), group.angle, NUMBER)
