"""INITIAL and RESIDUAL: the velocities of the first row, and of every row, satisfy every constraint equation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, Verdict, judged
from coursework.reduction.system import compile_system
from coursework.sentences import say

# Relative to the sum of the absolute terms of the equation: some hundred roundings, far below any slip of a hand.
LIMIT = 1e-11


def initial(evidence: Evidence) -> Check:
    """The velocities of row 1 satisfy every equation, also those not used for solving."""
    if evidence.restricted:
        return judged("INITIAL", "SKIP", say("check.only_some"))
    names, relative = residuals(evidence)
    worst = int(np.argmax(relative[0]))
    value = float(relative[0, worst])
    verdict: Verdict = "PASS" if value <= LIMIT else "FAIL"
    sentence = say(f"check.INITIAL.{verdict.lower()}", count=len(names), name=names[worst])
    return judged("INITIAL", verdict, sentence, value, LIMIT, say("unit.relative"))


def every_row(evidence: Evidence) -> Check:
    """The velocities of every row satisfy every equation they were solved from."""
    if evidence.restricted:
        return judged("RESIDUAL", "SKIP", say("check.only_some"))
    names, relative = residuals(evidence)
    places = [place for place, name in enumerate(names) if name in evidence.used]
    others = [place for place in range(len(names)) if place not in places]
    row, chosen = (int(i) for i in np.unravel_index(np.argmax(relative[:, places]), (len(relative), len(places))))
    value, name = float(relative[row, places[chosen]]), names[places[chosen]]
    # An equation left out as redundant may hold on closed positions only, so the scheme's drift shows in it: told, not judged.
    unit = say("unit.relative")
    rows = tuple((say("check.RESIDUAL.unused", name=names[k]), float(np.max(relative[:, k])), unit) for k in others)
    if value <= LIMIT:
        return judged("RESIDUAL", "PASS", say("check.RESIDUAL.pass", rows=len(relative)), value, LIMIT, unit, rows)
    sentence = say("check.RESIDUAL.fail", name=name, row=row + 1, time=float(evidence.motion.t[row]))
    return judged("RESIDUAL", "FAIL", sentence, value, LIMIT, unit, rows)


def residuals(evidence: Evidence) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Return names and |A u - b| of every equation and row, relative to the sum of the absolute terms."""
    equations, motion = evidence.equations, evidence.motion
    system = compile_system(equations, equations.equations)
    matrix, right, _ = system.matrices(motion.t, motion.coordinates)
    u = np.array([motion.column(name) for name in system.unknowns]).T.reshape(len(motion.t), len(system.unknowns))
    terms = matrix * u[:, None, :]
    scale = np.abs(terms).sum(axis=2) + np.abs(right)
    gap = np.abs(terms.sum(axis=2) - right)
    return system.names, np.where(scale > 0, gap / np.where(scale > 0, scale, 1.0), 0.0)
