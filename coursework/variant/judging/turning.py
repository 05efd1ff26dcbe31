"""Links that are given the rate of another: in "C = B + l3 @ a3" the link that holds B and C turns as a3 does.

Enters: a `Variant`, its `Source`.  Leaves: faults.  Used by `whole_file.py`.
Read from the text alone, so told before anything moves; a rate that no coordinate has is judged by the geometry instead.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.variant.formula.tree import Formula, named, signed, spelled
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say

_Arm = tuple[str, str, str, str]  # two points, the coordinate that their line turns with, where the file says so
# Kinds of groups with a rod for each point that they hang on: their coordinates begin with the angles of the rods.
_RODS = {kind for kind, shape in GROUP_SHAPES.items() if shape.counts["from"] == shape.counts["lengths"] != (0,)}


def faults_of_rates(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each link whose rate is that of another coordinate than the one its points turn with."""
    rates = {c.name: c.rate for c in variant.coordinates if c.unit == "rad"}
    arms = [*_arms(variant, {*rates})]
    faults = []
    for link in variant.links:
        own = {*link.points, *([link.wheel] if link.wheel else [])}
        turns = [arm for arm in arms if own.issuperset(arm[:2])]
        if link.rate in rates.values() and turns and all(rates[arm[2]] != link.rate for arm in turns):
            *_, coordinate, said = turns[0]
            told = say("fault.V157", link=link.name, rate=link.rate, own=rates[coordinate], said=said)
            faults.append(source.fault(("links", link.name, "rate"), told))
    return faults


def _arms(variant: Variant, angles: set[str]) -> Iterator[_Arm]:
    """Yield the lines between two points that turn with one coordinate."""
    moving = {c.name for c in variant.coordinates} | {law.name for law in (*variant.drive, *variant.functions)} | {"t"}
    for end, formula in variant.points:
        begin, *arms = (term for term, _ in signed(formula))
        if begin.op != "name" or not arms or any(arm.op != "@" or moving & {*arm.args[0].names()} for arm in arms):
            continue
        turned = {_coordinate(arm.args[1], moving) for arm in arms}
        if len(turned) == 1 and (coordinate := turned.pop()) in angles:
            yield begin.name, end, coordinate, f"{end} = {spelled(formula)}"
    for number, group in enumerate(variant.groups, start=1):
        for start, coordinate in zip(group.start_points if group.kind in _RODS else (), group.coordinates, strict=False):
            if start.op == "name" and group.meets and coordinate in angles:
                yield start.name, group.meets, coordinate, f"[[group]] {number}, {group.kind}"


def _coordinate(angle: Formula, moving: set[str]) -> str:
    """Return the one coordinate that an angle follows, beside constants; "" for any other angle."""
    found = [term for term, _ in signed(angle) if moving & {*term.names()}]
    return found[0].name if len(found) == 1 and found[0] == named(found[0].name) else ""
