"""The sentences on what a student has to find: the unknown velocities, the rows, the period, the scheme, the row to construct.

Enters: a `PageContext`.  Leaves: sentences.  Used by `first_step.py`, `statement.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.geometry.time_derivatives import jets
from coursework.report.text.numbers import TIGHT
from coursework.report.text.page_context import PageContext
from coursework.variant.record.variant import Variant

PERIOD = "T"  # symbol of the period, unless a datum has this name
STEP = "h"  # symbol of the step, even if a datum has this name
SAME = 1e-7  # parts of the largest velocity: far above round-off, far below the difference of two velocities
_LINEAR = "m/s"


def sought(context: PageContext) -> list[str]:
    """Return the sentences on what is sought, over which time and how.

    No drawing shows a linear velocity, so its sentence says what moves with it: u = ds/dt or u = V_Sx.
    """
    run, words = context.run, context.words
    end, step = context.quantity(run.end, "s"), context.step
    free = run.variant.motor.rates if run.variant.motor else ()  # rates that the forces determine
    unknowns = words.listing([_explained(context, name) for name in dict.fromkeys((*free, *run.variant.sought))])
    told = [words("statement.find" if unknowns else "statement.find_nothing", unknowns=unknowns, end=end, step=step)]
    if STEP in run.variant.values:
        told.append(words("statement.two_meanings"))
    time = run.variant.time
    if time.period is not None:
        key = "statement.period_plain" if PERIOD in run.variant.values else "statement.period"
        key = key if _changes(run.variant) else "statement.period_is"  # a constant drive repeats after any time
        told.append(words(key, period=context.quantity(time.period, "s")))
    is_exact = run.tableau is None
    told.append(words("statement.method_exact") if is_exact else words("statement.method", scheme=context.told(run.scheme_title)))
    told += corrections(context)
    if time.check_row is not None and run.is_checked_by_drawing:
        when = context.quantity((time.check_row - 1) * time.step, "s")
        told.append(words("statement.check_row", row=time.check_row, time=when))
    return told


def corrections(context: PageContext) -> list[str]:
    """Return the sentences on the corrections against drift that a run applies besides its scheme."""
    run, words, told = context.run, context.words, []
    if run.settings.project:
        told.append(words.count("method.project", run.settings.project))
    if run.settings.gain:
        product = context.numbers.plain(run.settings.gain * run.step)
        told.append(words("method.gain", gain=context.quantity(run.settings.gain, "1/s"), product=product))
    return told


def _changes(variant: Variant) -> bool:
    """Return whether a drive changes in time."""
    moving = {"t", *(law.name for law in variant.functions)}
    return any(law.table or law.pieces or any(moving & set(part.names()) for part in law.formulas) for law in variant.drive)


def _explained(context: PageContext, name: str) -> str:
    """Return the symbol of an unknown; a linear velocity is followed by its meaning if that is found."""
    symbol = context.lettering(name)
    is_linear = context.run.variant.unit_of(name) == _LINEAR
    meaning = (_rate_of_length(context, name) or _velocity_of_point(context, name)) if is_linear else ""
    return f"{symbol}{TIGHT}={TIGHT}{meaning}" if meaning else symbol


def _rate_of_length(context: PageContext, name: str) -> str:
    lengths = (c.name for c in context.run.variant.coordinates if c.rate == name)
    return next((f"d\u202f{context.lettering(length)}/d\u202f{context.lettering('t')}" for length in lengths), "")


def _velocity_of_point(context: PageContext, name: str) -> str:
    """Return "V_Sx" if in all rows a point moves along x with this velocity, "V_A" if along an inclined guide, else ""."""
    run, known = context.run, set(context.run.variant.names)
    motion, equations = run.motion, run.scene.equations
    guided = [through.name for through, _ in run.variant.frame.rails if through.op == "name"]
    bound = [one.point for one in run.variant.bindings if one.name == name and one.point]  # as the file says
    points = list(dict.fromkeys([*bound, *guided, *equations.symbols.vectors]))
    whole = {*run.variant.sought} <= {*motion.velocity_names} and len(motion.coordinate_names) == len(run.variant.coordinates)
    if not whole or not len(motion.t) or not points:
        return ""
    wanted = [part for point in points for part in equations.symbols.vectors[point]]
    velocities = jets(equations, wanted, 1)[1](motion.t, motion.coordinates, motion.velocities, None)
    own = motion.column(name)
    most = SAME * float(np.max(np.abs(own)))
    for point, (x, y) in zip(points, velocities.T.reshape(len(points), 2, -1), strict=True):
        for label, size, across in ((f"V{point}x", x, y), (f"V{point}y", y, x), (f"V{point}", np.hypot(x, y), 0 * x)):
            compared = own if label[-1] in "xy" else np.abs(own)
            is_all = np.all(np.abs(across) <= most) or (point in bound and label[-1] in "xy")  # not a part of another velocity
            if label not in known and is_all and np.all(np.abs(size - compared) <= most):
                return context.lettering(f"V_{label[1:]}")  # VA alone would be the segment between V and A
    return ""
