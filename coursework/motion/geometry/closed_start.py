"""The closed position nearest to the start values of a file, and the refusal of a start that is far from closed.

Enters: a `Closure`.  Leaves: the residual of the start and a closed position.
Used by `scene/way_to_motion.py`, `open_loops.py`, START, `analysis.py` and `grading/marking/key/branches.py`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress

import numpy as np

from coursework.motion.geometry.closure import CLOSED, MAX_NEWTON, Closure
from coursework.system.arrays import Array
from coursework.variant.formula.units import size_of
from coursework.variant.record.variant import Coordinate, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

SLIPS = {"ANGLE", "LENGTH", "NO-UNIT"}  # remarks on values with which a right start does not close
TYPED = 9  # digits of a start to be typed: START asks for six
OPEN = 0.01  # share of the largest length; a larger residual means a wrong start, not a rounded one


def require_start(closure: Closure | None) -> None:
    """Raise `InputError`, with the nearest closed start, if the start values leave the mechanism far from closed."""
    if closure is None or not closure.names:
        return
    residual, closed = closed_start(closure)
    worst = int(np.argmax(np.abs(residual)))
    if abs(residual[worst]) <= OPEN * closure.scale:
        return
    variant = closure.equations.variant
    off = {
        name: value for name, value in zip(closure.names, residual.tolist(), strict=True) if abs(value) > CLOSED * closure.scale
    }
    listed = ", ".join(f"{name}: {value:.6g}" for name, value in off.items())
    unit = ", ".join(dict.fromkeys(one.unit for one in closure.equations.positions if one.name in off))
    told = {"residuals": listed, "unit": unit, "hint": likelier(variant)}
    sentence = say("fault.V312", **told) if closed is None else say("fault.V313", nearest=typed_start(variant, closed), **told)
    raise InputError([Fault(sentence, variant.file, variant.line_of("coordinates"))])


def likelier(variant: Variant) -> Sentence | str:
    """Return which values of a file look like the slip for which its right start does not close; "" if none does."""
    slips = joined(remark.sentence for remark in variant.plausibility if remark.code in SLIPS)
    return say("remark.instead", slips=slips) if slips else ""


def typed_start(variant: Variant, start: Array, digits: int = TYPED) -> str:
    """Return start values (m,) as a user would type them into the file."""
    return ", ".join(f"{c.name} = {_typed(c, q, digits)}" for c, q in zip(variant.coordinates, start.tolist(), strict=True))


def _typed(coordinate: Coordinate, value: float, digits: int) -> str:
    """Return a value (rad, m) in the unit that the file uses for it; without a unit if the file has none."""
    size = 0.0 if coordinate.start_has_no_unit else size_of(coordinate.written)
    return f"{value / size:.{digits}g} {coordinate.written}" if size else f"{value:.{digits}g}"


def closed_start(closure: Closure) -> tuple[Array, Array | None]:
    """Return the residual of the written start (k,) and the nearest closed position (m,), None if there is none nearby."""
    residual, _ = closure.residual(0.0, closure.start, closure.origin)
    found = closure.newton(0.0, closure.start, closure.origin)
    if found is None or np.max(np.abs(found - closure.start)) > 1:
        found = closure.newton(0.0, _downhill(closure), closure.origin)
    if found is None or not _is_closed(closure, found):  # what keeps its start value, whatever that is, may hold it back
        found = _without_holds(closure)
    return residual, None if found is None else _without_turns(closure, found)


def _is_closed(closure: Closure, q: Array, rows: Sequence[int] | slice = slice(None)) -> bool:
    """Return whether some of the equations hold; where they are too many, a correction settles although they do not."""
    return bool(np.max(np.abs(closure.residual(0.0, q, closure.origin)[0][rows]), initial=0.0) <= CLOSED * closure.scale)


def _without_holds(closure: Closure) -> Array | None:
    """Return a position near the start that closes all that must be zero, None if there is none."""
    rows = [place for place, one in enumerate(closure.equations.positions) if one.target != "start"]
    q, free = closure.start.copy(), list(closure.free)
    with suppress(ArithmeticError, ValueError, np.linalg.LinAlgError):
        for _ in range(MAX_NEWTON):
            residual, jacobian = closure.residual(0.0, q, closure.origin)
            q[free] -= np.linalg.pinv(jacobian[rows]) @ residual[rows]
        return q if rows and np.max(np.abs(q - closure.start)) <= 1 and _is_closed(closure, q, rows) else None
    return None


def _downhill(closure: Closure) -> Array:
    """Return a position from which Newton's method should converge: corrections are shortened until each reduces the residual."""
    q, part = closure.start, 1.0
    with suppress(ArithmeticError, ValueError, np.linalg.LinAlgError):  # a root or arccosine may be undefined at a trial position
        size = np.linalg.norm(closure.residual(0.0, q, closure.origin)[0])
        for _ in range(2 * MAX_NEWTON):
            step = closure.linear(0.0, q, closure.origin)
            part = min(part, 1.0 / max(float(np.max(np.abs(step), initial=0.0)), 1.0))
            left = np.linalg.norm(closure.residual(0.0, q + part * step, closure.origin)[0])
            q, size, part = (q + part * step, left, 2 * part) if left < size else (q, size, part / 2)
    return q


def _without_turns(closure: Closure, q: Array) -> Array:
    """Return a closed position with whole turns from the start removed from each angle for which the closure still holds."""
    for place in closure.free:
        turns = round((q[place] - closure.start[place]) / math.tau)
        if turns and closure.equations.variant.coordinates[place].unit == "rad":
            nearer = q.copy()
            nearer[place] -= turns * math.tau
            if np.max(np.abs(closure.residual(0.0, nearer, closure.origin)[0])) <= CLOSED * closure.scale:
                q = nearer
    return q
