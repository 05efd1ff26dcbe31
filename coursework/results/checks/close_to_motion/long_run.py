"""DRIFT-PER-PERIOD: what a scheme loses period after period; a table that repeats itself need not be the true motion.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Finding, Verdict, skipped
from coursework.words.sentences import joined

# The table repeats itself where the last period changes by less than this part of what it is off.
REPEATS = 0.01
_SHOWN = (1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)


def per_period(evidence: Evidence) -> Finding:
    """After many periods every coordinate is still where the true motion is."""
    motion, period = evidence.motion, evidence.period
    whole = int((motion.t[-1] + motion.step / 2) / period)
    if whole < 2 or motion.stop is not None:
        return skipped(evidence.say("check.DRIFT-PER-PERIOD.short"))
    if evidence.compared < len(motion.t):
        return skipped(evidence.say("check.unknown"))
    names = [name for name in motion.coordinate_names if name in evidence.names]
    listed = [k for k in _SHOWN if k < whole - 1] + [whole - 1, whole]
    ends = np.minimum(np.rint(np.array(listed) * period / motion.step).astype(int), len(motion.t) - 1)
    gaps = evidence.errors[ends][:, [evidence.names.index(name) for name in names]]
    worst = int(np.argmax(np.abs(gaps[-1])))
    name = names[worst]
    unit, scale = evidence.unit(name), evidence.scale[name]
    value, last = float(abs(gaps[-1, worst])), float(gaps[-1, worst] * scale)
    rows = tuple(
        (evidence.say("check.DRIFT-PER-PERIOD.after", number=k, name=name), float(gap * scale), unit)
        for k, gap in zip(listed, gaps[:, worst].tolist(), strict=True)
    )
    found = {"name": name, "unit": unit, "first": rows[0][1], "last": last, "periods": whole, "each": last / whole}
    told = [evidence.say("check.DRIFT-PER-PERIOD.found", **found)]
    scales = np.array([evidence.scale[name] for name in names])
    if value > LIMIT and float(np.max(np.abs(gaps[-1] - gaps[-2]) * scales)) < REPEATS * abs(last):
        told.append(evidence.say("check.DRIFT-PER-PERIOD.repeats"))
    verdict: Verdict = "PASS" if value <= LIMIT else "COARSE"
    return Finding(verdict, joined(told), value, LIMIT, evidence.say("unit.of_the_scale"), name, int(ends[-1]) + 1, rows=rows)
