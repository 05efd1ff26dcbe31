"""STOP, START and DRIFT: the motion reaches its end; the start closes; positions stay closed as far as the scheme can."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, judged
from coursework.geometry.closure import closed_start
from coursework.sentences import joined, say

Array = NDArray[np.float64]
# A start that is off stays off: the velocity equations keep every residual as it is, up to the scheme's own error.
KEPT = 1.01
# The drift follows from the position error to first order; a factor of three covers the curvature.
SAFETY = 3.0
START_LIMIT = 1e-6  # of the largest length: five digits in the start values are enough to pass
_ROUND_OFF = 1e-12


def stopped(evidence: Evidence) -> Check:
    """The mechanism can make the whole motion."""
    stop = evidence.motion.stop
    rows = len(evidence.motion.t)
    if stop is None:
        return judged("STOP", "PASS", say("check.STOP.pass", rows=rows))
    return judged("STOP", "FAIL", stop.sentence, stop.time, evidence.variant.time.end, "s")


def start(evidence: Evidence) -> Check:
    """The start values close the mechanism; where they do not, the nearest closed start is printed."""
    closure = evidence.closure
    if closure is None or all(position.kept != "zero" for position in evidence.equations.positions):
        return judged("START", "SKIP", say("check.START.skip"))
    residual, closed = closed_start(closure)
    value = float(np.max(np.abs(residual)))
    limit = START_LIMIT * closure.scale
    if value <= limit:
        return judged("START", "PASS", say("check.START.pass"), value, limit, "m")
    sentence = say("check.START.none", value=value)
    if closed is not None:
        names = [c.name for c in evidence.variant.coordinates]
        start = [say("check.START.value", name=name, value=q) for name, q in zip(names, closed.tolist(), strict=True)]
        sentence = say("check.START.nearest", value=value, start=joined(start, "join.comma"))
    return judged("START", "FAIL", sentence, value, limit, "m")


def drift(evidence: Evidence) -> Check:
    """The position equations stay satisfied within what the scheme's own error explains."""
    closure = evidence.closure
    if closure is None:
        return judged("DRIFT", "SKIP", say("check.DRIFT.skip"))
    if evidence.restricted:
        return judged("DRIFT", "SKIP", say("check.only_some"))
    if evidence.scheme_error is None:
        return judged("DRIFT", "SKIP", say("check.DRIFT.short"))
    residual, allowed = drift_rows(evidence)
    row, equation = (int(i) for i in np.unravel_index(np.argmax(np.abs(residual) / allowed), residual.shape))
    value, limit = float(abs(residual[row, equation])), float(allowed[row, equation])
    largest = np.max(np.abs(residual), axis=0)
    rows = tuple((say("check.largest", name=name), float(size), "m") for name, size in zip(closure.names, largest, strict=True))
    name = closure.names[equation]
    if value <= limit:
        sentence = say("check.DRIFT.pass", name=name, row=row + 1, largest=float(np.max(largest)))
        return judged("DRIFT", "PASS", sentence, value, limit, "m", rows)
    return judged("DRIFT", "FAIL", say("check.DRIFT.fail", name=name, value=value, row=row + 1), value, limit, "m", rows)


def drift_rows(evidence: Evidence) -> tuple[Array, Array]:
    """Return the residual of every position equation and row (n, k), and what is allowed there."""
    closure, motion = evidence.closure, evidence.motion
    assert closure is not None
    kept, _ = closure.targets(motion.t)
    error = evidence.scheme_error
    count = len(motion.coordinate_names)
    sizes = np.zeros((len(motion.t), count)) if error is None else np.abs(error[:, :count])
    # The estimate may pass through zero; what was reached once is allowed from then on.
    sizes = np.maximum.accumulate(sizes, axis=0)
    residuals, allowed = [], []
    for index, t in enumerate(motion.t.tolist()):
        residual, jacobian = closure.residual(t, motion.coordinates[index], kept[index])
        residuals.append(residual)
        scale = 1 + np.max(np.abs(kept[index]), initial=0.0)
        driven = _driven_part(evidence, index, t, residual, kept[index], sizes[index])
        allowed.append(SAFETY * np.abs(jacobian) @ sizes[index, list(closure.free)] + SAFETY * driven + _ROUND_OFF * scale)
    open_at_start, _ = closure.residual(0.0, closure.start, kept[0])
    return np.array(residuals), np.array(allowed) + KEPT * np.abs(open_at_start)


def _driven_part(evidence: Evidence, index: int, t: float, residual: Array, kept: Array, sizes: Array) -> Array:
    """Return what the error of the driven coordinates (a crank that speeds up) does to the position equations (k,)."""
    closure = evidence.closure
    assert closure is not None
    part = np.zeros(len(residual))
    for place in closure.driven:
        shifted = evidence.motion.coordinates[index].copy()
        shifted[place] -= sizes[place]
        part += np.abs(closure.residual(t, shifted, kept)[0] - residual)
    return part
