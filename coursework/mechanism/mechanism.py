"""Variant -> Mechanism: points in the order they can be computed, chains of groups written as closures, mobility.

Enters: a `Variant`.  Leaves: a frozen `Mechanism`, still in formulas.  Raises `InputError`.
Used by `equations/reduction/structure.py` and `equations/reduction/equations.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

from coursework.mechanism.groups import group_kind
from coursework.mechanism.joints import Linkage, Mobility, linkage
from coursework.variant.formula.tree import Formula
from coursework.variant.record.variant import Constraint, Group, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# A point built from points built from points grows like a power of two; beyond this no mechanism is meant.
MAX_EXPANDED = 20_000


@dataclass(frozen=True, slots=True)
class Mechanism:
    """`points` in an order in which each needs only earlier ones; `constraints` written and from the chain.

    `linkage` holds bodies and joints, None where the file does not show them.
    """

    variant: Variant
    points: tuple[tuple[str, Formula], ...]
    constraints: tuple[Constraint, ...]
    linkage: Linkage | None

    @property
    def mobility(self) -> Mobility | None:
        """Return how many freedoms the joints leave the links."""
        return self.linkage.mobility if self.linkage is not None else None


def build(variant: Variant) -> Mechanism:
    """Return the mechanism of a variant.  Raises `InputError` where points or groups cannot be put in order."""
    written = dict(variant.points)
    constraints = list(variant.constraints)
    known: set[str] = {c.name for c in variant.coordinates} - {n for g in variant.groups for n in g.coordinates}
    for index, group in enumerate(variant.groups, start=1):
        constraint, met = _as_closure(group, index, variant)
        if late := _later(group, written, known | set(group.coordinates), variant):
            raise _fault(
                variant,
                say("fault.V341", number=index, kind=group.kind, late=late),
                group.line,
            )
        known.update(group.coordinates)
        if constraint:
            constraints.append(constraint)
        if group.meets and met:
            written[group.meets] = met
    points, sizes = _in_order(written, variant)
    shown = [(say("place.constraint", name=c.name), c.line, side) for c in constraints for side in (c.left, c.right)]
    shown += [(say("place.holds"), variant.line_of("closure", "holds", i), hold) for i, hold in enumerate(variant.holds)]
    for what, line, formula in shown:
        if _expanded(formula, sizes) > MAX_EXPANDED:
            raise _fault(variant, say("fault.V342", what=what, most=MAX_EXPANDED), line)
    return Mechanism(variant, points, tuple(constraints), linkage(variant, dict(points)))


def _fault(variant: Variant, message: Sentence, line: int = 0) -> InputError:
    return InputError([Fault(message, variant.file, line)])


def _as_closure(group: Group, index: int, variant: Variant) -> tuple[Constraint | None, Formula | None]:
    """Return the vector closure of a group and the formula of the point it meets in."""
    _check_shape(group, index, variant)
    sides, met = group_kind(group.kind).closure(group)
    if not sides:
        return None, met
    because = say("equation.closes", kind=group.kind, number=index)
    return Constraint(f"G{index}", because, sides[0], sides[1], True, group.line), met


def _check_shape(group: Group, index: int, variant: Variant) -> None:
    shape = group_kind(group.kind).shape
    wrong = [
        say(f"fault.shape.{what}", wanted=wanted, found=found)
        for wanted, what, found, right in (
            (shape.points, "points", len(group.start_points), len(group.start_points) == shape.points),
            (shape.lengths[-1], "lengths", len(group.lengths), len(group.lengths) in shape.lengths),
            (shape.guides, "guides", len(group.guides), len(group.guides) == shape.guides),
            (shape.coordinates, "coordinates", len(group.coordinates), len(group.coordinates) == shape.coordinates),
        )
        if not right
    ]
    if wrong:
        raise _fault(variant, say("fault.V343", number=index, kind=group.kind, wanted=tuple(wrong)), group.line)
    rate = next(c.rate for c in variant.coordinates if c.name == group.coordinates[0])
    if group_kind(group.kind).driven and rate not in variant.known_rates:
        raise _fault(variant, say("fault.V344", number=index, kind=group.kind, rate=rate), group.line)


def _later(group: Group, written: dict[str, Formula], known: set[str], variant: Variant) -> str:
    """Return the point or coordinate a group needs before the chain has it, or an empty string."""
    coordinates = {c.name for c in variant.coordinates}
    formulas = [*group.start_points, *group.lengths, *(f for g in group.guides for f in (g.through, g.angle, g.offset))]
    todo = [name for formula in formulas for name in formula.names()]
    seen: set[str] = set()
    while todo:
        name = todo.pop()
        if name in seen:
            continue
        seen.add(name)
        if name in written:
            todo.extend(written[name].names())
        elif (name in coordinates and name not in known) or any(name == other.meets for other in variant.groups):
            return name
    return ""


def _expanded(formula: Formula, sizes: Mapping[str, int]) -> int:
    """Return the parts of a formula with every point written out."""
    return sum(sizes.get(node.name, 1) if node.op == "name" else 1 for node in formula.walk())


def _in_order(written: dict[str, Formula], variant: Variant) -> tuple[tuple[tuple[str, Formula], ...], dict[str, int]]:
    """Return the points in the order of the file, but each after those it needs, and how many parts each has written out."""
    sorter = TopologicalSorter({name: [n for n in formula.names() if n in written] for name, formula in written.items()})
    try:
        sorter.prepare()
    except CycleError as error:
        circle = error.args[1][::-1]
        told = say("fault.V345" if len(circle) > 2 else "fault.V346", circle=" → ".join(circle))
        raise _fault(variant, told, variant.line_of("points", circle[0])) from None
    places = {name: place for place, name in enumerate(written)}
    order: list[str] = []
    sizes: dict[str, int] = {}
    ready: list[str] = []
    while sorter.is_active():
        ready = sorted([*ready, *sorter.get_ready()], key=places.__getitem__)
        name = ready.pop(0)
        sorter.done(name)
        order.append(name)
        sizes[name] = _expanded(written[name], sizes)
        if sizes[name] > MAX_EXPANDED:
            raise _fault(variant, say("fault.V347", name=name, most=MAX_EXPANDED), variant.line_of("points", name))
    return tuple((name, written[name]) for name in order), sizes
