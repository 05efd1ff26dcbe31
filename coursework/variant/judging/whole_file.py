"""Faults that only the whole file shows: nothing to derive velocities from, missing starts or drives, the cost of a run.

Enters: a `Variant`, its `Source`, the times that follow from data.  Leaves: faults.  Used by `reader.py` only.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from coursework.variant.judging.bounds import exceeded
from coursework.variant.judging.broken import Broken
from coursework.variant.judging.coordinate_order import faults_of_names
from coursework.variant.judging.groups import faults_of_groups
from coursework.variant.judging.lengths import faults_of_lengths
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import GROUP_SHAPES
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say


def faults_of_the_whole(variant: Variant, source: Source, times: Iterable[KeyPath], broken: Broken) -> list[Fault]:
    """Return the faults that no single key shows, those of lengths last; nothing more is reported about `broken` parts."""
    faults = []
    written = broken.has("constraint") or broken.has("group") or broken.has("closure")
    if variant.sought and not (written or variant.constraints or variant.groups or variant.driven or variant.holds):
        if variant.motor is None:
            faults.append(source.fault((), say("fault.V072")))
        else:
            told = say("fault.V746", names=variant.sought, free=variant.motor.rates)
            faults.append(source.fault(("motor", "rates"), told))
    # A period that follows from the drive is checked with the drive, because its speed is the clearer message.
    derived = {"period"} & {str(path[-1]) for path in times}
    if not broken.has("time") and math.isfinite(variant.time.step + variant.time.end):
        faults += [source.fault(("time", key), text) for key, text in exceeded(variant) if key not in derived]
    # The start of a dyad follows from its closure; a crank starts where the file says.
    dyads = [group for group in variant.groups if not (group.kind in GROUP_SHAPES and GROUP_SHAPES[group.kind].driven)]
    in_groups = {name for group in dyads for name in group.coordinates}
    of_groups = faults_of_groups(variant, GROUP_SHAPES, broken)
    for coordinate in () if broken.has("group") or of_groups else variant.coordinates:
        if coordinate.start is None and not (coordinate.name in in_groups or broken.has("coordinates", coordinate.name)):
            message = say("fault.V073", unit=coordinate.unit)
            faults.append(source.fault(("coordinates", coordinate.name), message))
    laws = {law.name for law in variant.drive}
    if variant.driven and (missing := [law for law in (f"V{variant.driven}{part}" for part in "xy") if law not in laws]):
        turned = tuple(rate for rate in variant.rates if rate in laws)
        hint = say("hint.not_driven", rates=turned) if turned and len(missing) == 2 else ""
        if len(missing) == 1:
            hint = say("hint.one_axis", law=next(iter({f"V{variant.driven}{part}" for part in "xy"} - {*missing})))
        message = say("fault.V048", point=variant.driven, missing=tuple(missing), hint=hint)
        faults.append(source.fault(("closure", "driven"), message))
    faults += faults_of_names(variant, source) + of_groups
    return faults + faults_of_lengths(broken.sound(variant), source)
