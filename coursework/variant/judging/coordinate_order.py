"""Groups whose coordinates are in the wrong order: a distance in the place of the angle.

Enters: groups and coordinates of a `Variant`.  Leaves: faults that advise to swap them.  Used by `dimension_check.py`, if the
file shows what the coordinates measure, and `whole_file.py`, if only their names tell.
"""

from __future__ import annotations

import re

from coursework.variant.formula.alphabet import spell
from coursework.variant.record.variant import Group, Variant
from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say

# Names that textbooks give to angles, never to a distance.
_ANGLE = r"(phi|fi|theta|psi|alpha|beta|gamma|delta)(_?[A-Za-z0-9]{0,3})\Z"  # compiled when first needed


def is_angle_first(group: Group) -> bool:
    """Return whether the coordinates of a group are an angle and a distance, in this order."""
    return GROUP_KINDS[group.kind] == 1 and len(group.coordinates) == 2


def fault_of_order(index: int, group: Group, source: Source) -> Fault:
    """Return the fault of a group (index from 0) whose coordinates are in the wrong order."""
    first, second = group.coordinates
    return source.fault(("group", index, "coordinates"), say("fault.V156", kind=group.kind, first=first, second=second))


def faults_of_names(variant: Variant, source: Source) -> list[Fault]:
    """Return a fault for each group in which only the name of the distance looks like the name of an angle."""
    units = {coordinate.name: coordinate.unit for coordinate in variant.coordinates if coordinate.unit_was_given}
    return [
        fault_of_order(index, group, source)
        for index, group in enumerate(variant.groups)
        if is_angle_first(group)
        and [re.match(_ANGLE, spell(name)) is not None for name in group.coordinates] == [False, True]
        and not units.keys() & {*group.coordinates}
    ]
