"""DRIFT-PER-PERIOD: what a scheme loses period after period; a table that repeats itself need not be the true motion."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, judged
from coursework.sentences import joined, say

Array = NDArray[np.float64]
_CODE = "DRIFT-PER-PERIOD"
# Part of a coordinate's own range by which the last period may lie beside the true one: nobody sees it in a drawing.
LIMIT = 0.05
# The table repeats itself where the last period changes by less than this part of what it is off.
REPEATS = 0.01
_SHOWN = (1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)


def per_period(evidence: Evidence) -> Check:
    """After many periods every coordinate is still where the true motion is."""
    motion, exact = evidence.motion, evidence.exact
    whole = int((motion.t[-1] + motion.step / 2) / evidence.period)
    if whole < 2 or motion.stop is not None:
        return judged(_CODE, "SKIP", say("check.DRIFT-PER-PERIOD.short"))
    if exact is None:
        return judged(_CODE, "SKIP", say("check.DRIFT-PER-PERIOD.unknown"))
    ends = np.minimum(np.rint(np.arange(1, whole + 1) * evidence.period / motion.step).astype(int), len(motion.t) - 1)
    names = motion.coordinate_names
    true = np.array([exact.column(name) for name in names]).T
    gaps = motion.coordinates[ends] - true[ends]
    spans = np.ptp(true, axis=0)
    spans = np.array([min(s, 2 * np.pi) if evidence.unit(n) == "rad" else s for s, n in zip(spans, names, strict=True)])
    parts = np.abs(gaps) / np.where(spans > 0, spans, np.inf)
    worst = int(np.argmax(parts[-1]))
    name, unit, value = names[worst], evidence.unit(names[worst]), float(parts[-1, worst])
    first, last = float(gaps[0, worst]), float(gaps[-1, worst])
    rows = tuple(
        (say("check.DRIFT-PER-PERIOD.after", name=name, periods=k), float(gaps[k - 1, worst]), unit) for k in _SHOWN if k <= whole
    )
    found = {"name": name, "unit": unit, "first": first, "last": last, "periods": whole, "each": last / whole}
    told = [say("check.DRIFT-PER-PERIOD.found", **found)]
    if value <= LIMIT:
        return judged(_CODE, "PASS", told[0], value, LIMIT, say("unit.of_its_range"), rows)
    moved = motion.coordinates[ends[-1]] - motion.coordinates[ends[-2]] - (true[ends[-1]] - true[ends[-2]])
    if float(np.max(np.abs(moved))) < REPEATS * abs(last):
        told.append(say("check.DRIFT-PER-PERIOD.repeats"))
    told.append(say("check.DRIFT-PER-PERIOD.advice"))
    return judged(_CODE, "FAIL", joined(told), value, LIMIT, say("unit.of_its_range"), rows)
