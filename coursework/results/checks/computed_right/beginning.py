"""STOP and START: the motion reaches its end; the start values close the mechanism.

Enters: `Evidence`.  Leaves: a `Finding` each.  Used by `check.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.motion.geometry.closure import closed_start
from coursework.motion.integration.integrate import TOO_LARGE
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, skipped
from coursework.words.sentences import joined, say

START_LIMIT = 1e-6  # of the largest length: five digits in the start values are enough to pass


def stopped(evidence: Evidence) -> Finding:
    """The mechanism can make the whole motion, and the scheme does not step out of it."""
    stop = evidence.motion.stop
    search = evidence.search
    given_up = search.given_up if search is not None and not search.goes_round else None
    if stop is None and given_up is not None:
        told = say("check.STOP.given_up", rows=len(evidence.motion.t), time=given_up)
        return replace(skipped(told), headline=told)
    if stop is None:
        return Finding("PASS", say("check.STOP.pass", rows=len(evidence.motion.t)))
    row = int(stop.row) + 1
    # A dead or change point is the mechanism's; a step too large is the scheme's, and a smaller one has all rows.
    own = stop.kind == TOO_LARGE and evidence.stop is None
    return Finding("COARSE" if own else "FAIL", stop.sentence, stop.time, evidence.variant.time.end, "s", None, row)


def start(evidence: Evidence) -> Finding:
    """The start values close the mechanism; where they do not, the nearest closed start is printed."""
    closure = evidence.closure
    if closure is None or all(position.target != "zero" for position in evidence.equations.positions):
        return skipped(say("check.START.skip"))
    residual, closed = closed_start(closure)
    worst = int(np.argmax(np.abs(residual)))
    value, name = float(np.abs(residual[worst])), closure.names[worst]
    limit = START_LIMIT * closure.scale
    if value <= limit:
        return Finding("PASS", say("check.START.pass"), value, limit, "m", name, 1)
    sentence = say("check.START.none", value=value)
    if closed is not None:
        names = [c.name for c in evidence.variant.coordinates]
        listed = [say("check.START.value", name=name, value=q) for name, q in zip(names, closed.tolist(), strict=True)]
        sentence = say("check.START.nearest", value=value, start=joined(listed, "join.numbers"))
    return Finding("FAIL", sentence, value, limit, "m", name, 1)
