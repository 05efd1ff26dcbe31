"""Coordinates of a group in an order that cannot be meant: a distance where its angle stands.

Enters: groups and coordinates of a `Variant`.  Leaves: faults with the swap.  Used by `dimension_check.py`, where something in
the file measures them, and `whole_file.py`, where their names alone tell.
"""

from __future__ import annotations

import re

from coursework.variant.formula.alphabet import spell
from coursework.variant.record.variant import Group, Variant
from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say

# Names that textbooks give to angles: nobody calls a distance so.
_ANGLE = re.compile(r"(phi|fi|theta|psi|alpha|beta|gamma|delta)(_?[A-Za-z0-9]{0,3})\Z")


def is_angle_first(group: Group) -> bool:
    """Return whether a group has an angle and a distance as coordinates, in this order."""
    return GROUP_KINDS[group.kind] == 1 and len(group.coordinates) == 2


def fault_of_order(index: int, group: Group, source: Source) -> Fault:
    """Return the fault of a group (index from 0) whose coordinates stand in the other order."""
    first, second = group.coordinates
    return source.fault(("group", index, "coordinates"), say("fault.V156", kind=group.kind, first=first, second=second))


def faults_of_names(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each group that names its distance as an angle is named, and its angle otherwise."""
    units = {coordinate.name: coordinate.unit for coordinate in variant.coordinates if coordinate.unit_was_given}
    return [
        fault_of_order(index, group, source)
        for index, group in enumerate(variant.groups)
        if is_angle_first(group)
        and [_ANGLE.match(spell(name)) is not None for name in group.coordinates] == [False, True]
        and not units.keys() & {*group.coordinates}
    ]
