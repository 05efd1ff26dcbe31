"""Variant -> Mechanism: points in the order of computation, groups written as closures, joints and mobility.

Enters: a `Variant`.  Leaves: a frozen `Mechanism`, still in formulas.  Raises `InputError`.
Used by `equations/reduction/structure.py` and `equations/reduction/equations.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from graphlib import TopologicalSorter

from coursework.mechanism.groups import group_kind
from coursework.mechanism.joints import Linkage, Mobility, linkage
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula
from coursework.variant.judging.broken import Broken
from coursework.variant.judging.groups import faults_of_groups
from coursework.variant.record.variant import Constraint, Group, Variant
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Points defined by points defined by points grow like powers of two; no real mechanism needs more parts than this.
MAX_EXPANDED = 20_000


@frozen
class Mechanism:
    """`points`, each after the points it needs; `constraints`, those written in the file and those of the groups.

    `linkage` holds bodies and joints, None if the file does not show them.
    """

    variant: Variant
    points: tuple[tuple[str, Formula], ...]
    constraints: tuple[Constraint, ...]
    linkage: Linkage | None

    @property
    def mobility(self) -> Mobility | None:
        """Return the mobility of the linkage, None if there is no linkage."""
        return self.linkage.mobility if self.linkage is not None else None


def build(variant: Variant) -> Mechanism:
    """Return the mechanism of a variant.  Raises `InputError` if points or groups cannot be ordered or are too large."""
    written = dict(variant.points)
    constraints = list(variant.constraints)
    unknown = {group.kind: group_kind(group.kind).shape for group in variant.groups if group.kind not in GROUP_SHAPES}
    if unknown and (faults := faults_of_groups(variant, unknown, Broken())):
        raise InputError(faults)
    for index, group in enumerate(variant.groups, start=1):
        constraint, met = _as_closure(group, index)
        if constraint:
            constraints.append(constraint)
        if group.meets and met:
            written[group.meets] = met
    points, sizes = _in_order(written, variant)
    shown = [(say("place.constraint", name=c.name), c.line, side) for c in constraints for side in c.sides]
    shown += [(say("place.holds"), variant.line_of("closure", "holds", i), hold) for i, hold in enumerate(variant.holds)]
    for what, line, formula in shown:
        if _expanded(formula, sizes) > MAX_EXPANDED:
            raise _fault(variant, say("fault.V342", what=what, most=MAX_EXPANDED), line)
    return Mechanism(variant, points, tuple(constraints), linkage(variant, dict(points)))


def _fault(variant: Variant, message: Sentence, line: int) -> InputError:
    return InputError([Fault(message, variant.file, line)])


def _as_closure(group: Group, index: int) -> tuple[Constraint | None, Formula | None]:
    """Return the vector closure of a group (None for a crank), and the formula of its meeting point."""
    sides, met = group_kind(group.kind).closure(group)
    if not sides:
        return None, met
    because = say("equation.closes", kind=group.kind, number=index)
    return Constraint(f"G{index}", because, sides[0], sides[1], True, group.line), met


def _expanded(formula: Formula, sizes: Mapping[str, int]) -> int:
    """Return the number of nodes of a formula after every point is replaced by its formula."""
    return sum(sizes.get(node.name, 1) if node.op == "name" else 1 for node in formula.walk())


def _in_order(written: dict[str, Formula], variant: Variant) -> tuple[tuple[tuple[str, Formula], ...], dict[str, int]]:
    """Return the points in file order, but each after those it needs, and the expanded size of each."""
    sorter = TopologicalSorter({name: [n for n in formula.names() if n in written] for name, formula in written.items()})
    sorter.prepare()
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
