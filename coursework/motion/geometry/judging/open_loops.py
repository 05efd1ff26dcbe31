"""Whether written equations contradict the geometry only because the start leaves open what [closure] holds.

Enters: velocity equations that disagree with the geometry, and their closure.  Leaves: the closure where it closes.
Raises `InputError` naming the start.  Used by `unseen_signs.py`, `rigid.py`, `turning.py`.
A held quantity keeps its start value: a slot whose pin starts beside it becomes a slot with an offset, and equations written for
no offset contradict it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.closed_start import OPEN, closed_start, likelier, typed_start
from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.judging.agreement import agrees
from coursework.motion.geometry.start import START_TOLERANCE
from coursework.system.arrays import Array
from coursework.variant.formula.tree import on_axes
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


def require_loops_closed(equations: VelocityEquations, closure: Closure, accused: Sequence[Fault]) -> None:
    """Raise `InputError` if the equations agree with the geometry once its loops are closed at the start.

    Of several `accused` those that still disagree then are named alone: the others are right.  Closed means that everything held
    is zero, except single components of points.
    """
    if not closure.names:
        return
    near, residual = with_closed_loops(closure)
    worst = int(np.argmax(np.abs(residual)))
    if near is None or abs(residual[worst]) <= START_TOLERANCE * closure.scale:
        return
    try:
        agrees(equations, near)
    except InputError as closed:
        if {one.line for one in closed.faults} < {one.line for one in accused}:
            raise
        return
    variant, held = equations.variant, equations.positions[worst]
    known = {
        "value": float(residual[worst]),
        "unit": held.unit,
        "nearest": typed_start(variant, near.start),
        "hint": likelier(variant),
    }
    told = say("fault.V310", held=held.written or held.name, **known)
    raise InputError([Fault(told, variant.file, variant.line_of("coordinates"))])


def where_judged(closure: Closure) -> Closure | None:
    """Return the closure moved to where it closes, what is far from zero kept as intended; None if a loop cannot be closed.

    Whatever the points do there comes from a start, or from lengths, of which START tells.
    """
    near = with_closed_loops(closure)[0]
    far = OPEN * closure.scale
    values = zip(closure.equations.positions, closure.origin.tolist(), strict=True)
    if near is not None or any(one.closes and one.unit == "m" and abs(value) > far for one, value in values):
        return near
    return with_closed_loops(closure, far)[0]


def with_closed_loops(closure: Closure, most: float = math.inf) -> tuple[Closure | None, Array]:
    """Return the closure moved to the nearest closed start (None if there is none), and the residual (k,) of its own start.

    A residual larger than `most` is taken as intended, like the angle between two gears, and is kept.
    """
    equations, holds = closure.equations, iter(closure.equations.variant.holds)
    held = np.array([one.target == "start" and on_axes(next(holds)).op != "part" for one in equations.positions], dtype=bool)
    left = closure.residual(0.0, closure.start, np.where(held, 0.0, closure.origin))[0]
    near = closure.at_zero((held & (np.abs(left) <= most)).tolist())
    residual, start = closed_start(near)
    return None if start is None else replace(near, start=start, asked={}), residual
