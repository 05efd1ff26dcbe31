"""DRIFT-PER-PERIOD: what a scheme loses period after period; a table that repeats itself need not be the true motion."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check

Array = NDArray[np.float64]
_CODE, _TITLE = "DRIFT-PER-PERIOD", "Drift per period"
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
        return Check(_CODE, _TITLE, "SKIP", "The run covers less than two periods.")
    if exact is None:
        return Check(_CODE, _TITLE, "SKIP", "The true motion is not known on these rows.")
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
    rows = tuple((f"{name} after {k} period(s)", float(gaps[k - 1, worst]), unit) for k in _SHOWN if k <= whole)
    sentence = (
        f"{name} is off the true motion by {first:.3g} {unit} after one period and by {last:.3g} {unit} after {whole}, "
        f"{last / whole:.3g} {unit} a period."
    )
    if value <= LIMIT:
        return Check(_CODE, _TITLE, "PASS", sentence, value, LIMIT, "of its range", rows)
    moved = motion.coordinates[ends[-1]] - motion.coordinates[ends[-2]] - (true[ends[-1]] - true[ends[-2]])
    if float(np.max(np.abs(moved))) < REPEATS * abs(last):
        sentence += " The table repeats itself all the same: the scheme has settled on a cycle that the mechanism does not make."
    sentence += " For a run this long take a better scheme, or the projection."
    return Check(_CODE, _TITLE, "FAIL", sentence, value, LIMIT, "of its range", rows)
