"""Offsets of guides from the points they belong to: drawn as a part of a link, or as a dimension across the guide.

Enters: a `Painter` whose mechanism is drawn, and the `Mechanism`.  Leaves: `Offset`.
Used by `naming.py` and `dimensions.py`.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.drawing.paper.cover import Segment
from coursework.drawing.paper.painter import Painter
from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named

NOWHERE = 1e-9  # mm: two points this near to each other define no direction
SAME = 1e-6  # relative to the distance of the block: a measured and a given offset agree within this


@frozen
class Offset:
    """A datum `length` from a `point`, in direction `across`, to the guide of a `rider`; `stub`: its drawn part, or None."""

    length: Formula
    point: str
    rider: str
    across: complex
    stub: Segment | None


def offsets(painter: Painter, mechanism: Mechanism) -> Iterator[Offset]:
    """Yield the offsets that are data, each if a block really slides at that distance."""
    given = {datum.name for datum in mechanism.variant.given}
    for group in mechanism.variant.groups:
        sides = [(guide.through, guide.offset, named(group.meets or "")) for guide in group.guides]
        if group.start_points:
            sides.append((group.start_points[-1], group.offset, group.start_points[0]))
        for through, offset, rider in sides:
            known = through.op == offset.op == rider.op == "name" and {through.name, rider.name} <= painter.at.keys()
            if known and offset.name in given:
                size = abs(mechanism.variant.values[offset.name]) * painter.mm
                yield from _beside(painter, offset, size, through.name, rider.name)


def _beside(painter: Painter, length: Formula, size: float, point: str, rider: str) -> Iterator[Offset]:
    way = painter.at[rider] - painter.at[point]
    for block in painter.outline.blocks:
        along = painter.at[block.toward] - painter.at[block.base]
        across = 1j * along / max(abs(along), NOWHERE)
        if block.at == rider and abs(abs((across.conjugate() * way).real) - size) <= SAME * abs(way):
            yield Offset(length, point, rider, across, _stub(painter, point, rider))
            return


def _stub(painter: Painter, point: str, rider: str) -> Segment | None:
    slots = (slot for slot in painter.outline.slots if slot.at == point and rider in slot.riders)
    return next(((line[2], line[1]) for line in map(painter.slot_line, slots) if len(line) > 2), None)
