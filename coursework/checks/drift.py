"""STOP, START and DRIFT: the motion reaches its end; the start closes; positions stay closed as far as the scheme can."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import ONLY_SOME, Evidence
from coursework.checks.result import Check
from coursework.geometry.closure import closed_start

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
        return Check("STOP", "Whole motion", "PASS", f"All {rows} rows are computed; the motion meets no dead point.")
    return Check("STOP", "Whole motion", "FAIL", stop.sentence, stop.time, evidence.variant.time.end, "s")


def start(evidence: Evidence) -> Check:
    """The start values close the mechanism; where they do not, the nearest closed start is printed."""
    closure = evidence.closure
    if closure is None or all(position.kept != "zero" for position in evidence.equations.positions):
        return Check(
            "START", "Start values", "SKIP", "No position equation fixes the start; the start values define its constants."
        )
    residual, closed = closed_start(closure)
    value = float(np.max(np.abs(residual)))
    limit = START_LIMIT * closure.scale
    if value <= limit:
        return Check("START", "Start values", "PASS", "The start values close the mechanism.", value, limit, "m")
    names = [c.name for c in evidence.variant.coordinates]
    nearest = "there is no closed position near it"
    if closed is not None:
        nearest = "the nearest closed start is " + ", ".join(f"{n} = {q:.12g}" for n, q in zip(names, closed, strict=True))
    sentence = f"The start values leave the mechanism open by {value:.3g} m; {nearest}."
    return Check("START", "Start values", "FAIL", sentence, value, limit, "m")


def drift(evidence: Evidence) -> Check:
    """The position equations stay satisfied within what the scheme's own error explains."""
    closure = evidence.closure
    if closure is None:
        return Check(
            "DRIFT", "Closure drift", "SKIP", "The file gives no position equation ([closure]), so nothing can drift visibly."
        )
    if evidence.restricted:
        return Check("DRIFT", "Closure drift", "SKIP", ONLY_SOME)
    if evidence.scheme_error is None:
        return Check("DRIFT", "Closure drift", "SKIP", "The run is too short to tell the scheme's own error from a fault.")
    residual, allowed = drift_rows(evidence)
    row, equation = (int(i) for i in np.unravel_index(np.argmax(np.abs(residual) / allowed), residual.shape))
    value, limit = float(abs(residual[row, equation])), float(allowed[row, equation])
    largest = np.max(np.abs(residual), axis=0)
    rows = tuple((f"{name}: largest", float(size), "m") for name, size in zip(closure.names, largest, strict=True))
    name = closure.names[equation]
    if value <= limit:
        sentence = (
            f"The mechanism stays closed within the scheme's error; {name} drifts furthest for its limit, in row {row + 1}. "
            f"Largest drift of all: {float(np.max(largest)):.3g} m."
        )
        return Check("DRIFT", "Closure drift", "PASS", sentence, value, limit, "m", rows)
    sentence = (
        f"{name} is {value:.3g} m off in row {row + 1}, more than the scheme's own error explains: a row or an equation is wrong."
    )
    return Check("DRIFT", "Closure drift", "FAIL", sentence, value, limit, "m", rows)


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
