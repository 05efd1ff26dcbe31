"""Which formula of the file is to blame for an error on the way to a motion: the first that has no value somewhere on it.

Enters: the error, the `Variant`, and what of its motion is known.  Leaves: an `InputError`.
Used by `way_to_motion.py`, which loads it once an error is there.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.equations.codegen.programs import in_formula
from coursework.equations.codegen.straight_line import FormulaRefused
from coursework.equations.codegen.tabulated import OutsideTable
from coursework.motion.integration.exact_motion import NoVelocities
from coursework.motion.integration.motion import Motion
from coursework.motion.singular.event import NotFollowed
from coursework.variant.record.no_value import law_without_value, without_value
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

MOST_LOOKED_AT = 4096  # number of times at which a formula without a value is searched for


def formula_charged(error: Exception, variant: Variant, start: Sequence[float] | None, kept: Motion | None) -> InputError | None:
    """Return the fault of a formula without a value somewhere on the way; None if all have one where the mechanism is known.

    That is at its `start`, at the places that the error names, and in the rows `kept`; laws of time are looked at everywhere.
    """
    if isinstance(error, FormulaRefused):
        return InputError([Fault(error.faults[0].message, variant.file, 1)])
    if isinstance(error, OutsideTable):
        return InputError([Fault(error.faults[0].message, variant.file, variant.line_of(*variant.path_of(error.name)))])
    time = variant.time
    rows = (place * time.step for place in range(min(time.steps, MOST_LOOKED_AT) + 1))
    between = (place * time.end / MOST_LOOKED_AT for place in range(MOST_LOOKED_AT + 1))
    fault = law_without_value(variant, (*getattr(error, "times", ()), *rows, *between))
    positions = [] if start is None else [(0.0, start)]
    if isinstance(error, NoVelocities):
        positions.append((error.times[0], error.position))
    if isinstance(error, NotFollowed):
        positions += [(t, position) for *position, t in error.ahead]
    if kept is not None and kept.coordinates.shape[1] == len(variant.coordinates):
        positions += zip(kept.t.tolist(), kept.coordinates.tolist(), strict=True)
    for t, position in () if fault else positions:
        fault = fault or without_value(variant, t, dict(zip(variant.columns, position, strict=False)))
    if not fault and in_formula(error):
        fault = Fault(say("fault.V527"), variant.file, variant.nearest_line("drive"))
    return InputError([fault]) if fault else None
