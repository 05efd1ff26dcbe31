"""PERIOD-POSITION, PERIOD-VELOCITY, PERIOD-ASSEMBLY: the last row against the first, and what the difference is made of.

total = scheme error + (T is not a whole number of steps) + round-off, signed, per column.  The limit comes from the
scheme's own error at this step, so a coarse step is not blamed twice and a wrong table is not excused.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, Verdict

Array = NDArray[np.float64]
# The estimate from one halving of the step is right to its leading term; a factor of three covers the rest.
SAFETY = 3.0
# A column whose error happens to cross zero at the last row is still allowed this part of its largest error.
SHARE_OF_LARGEST = 0.3
_ROUND_OFF = 1e-12


@dataclass(frozen=True, slots=True)
class Split:
    """The mismatch of one column, signed: `total` = `scheme` + `period` + `roundoff`; `turns` whole turns taken off."""

    name: str
    unit: str
    total: float
    scheme: float
    period: float
    roundoff: float
    limit: float
    turns: int


def mismatch(evidence: Evidence) -> tuple[Split, ...] | None:
    """Return the split of every column, None where the run does not reach a period or stopped before."""
    row = evidence.period_row
    motion = evidence.motion
    if row is None or row >= len(motion.t) or motion.stop is not None:
        return None
    rows = motion.rows
    total = rows[row] - rows[0]
    turns = np.zeros(len(total))
    for place, name in enumerate(motion.names):
        if evidence.unit(name) == "rad":
            turns[place] = np.round(total[place] / (2 * np.pi))
    total = total - 2 * np.pi * turns
    exact = _exact_part(evidence, row, turns)
    period = exact if exact is not None else _drift_of_period(evidence, row)
    roundoff = np.zeros(len(total))
    if evidence.wide is not None:
        count = len(motion.coordinate_names)
        roundoff[:count] = (rows[row, :count] - evidence.wide[row, :count]).astype(float)
    scheme = total - period - roundoff
    estimate = evidence.scheme_error
    limit = np.full(len(total), np.inf) if estimate is None else SAFETY * np.maximum(
        np.abs(estimate[row]), SHARE_OF_LARGEST * np.max(np.abs(estimate), axis=0)
    )  # fmt: skip
    limit = limit + np.abs(period) + _ROUND_OFF * (1 + np.max(np.abs(rows), axis=0))
    columns = zip(motion.names, total, scheme, period, roundoff, limit, turns, strict=True)
    return tuple(
        Split(name, evidence.unit(name), float(a), float(b), float(c), float(d), float(e), int(k))
        for name, a, b, c, d, e, k in columns
    )


def _exact_part(evidence: Evidence, row: int, turns: Array) -> Array | None:
    if evidence.exact is None or row >= len(evidence.exact.t):
        return None
    names = evidence.motion.names
    return np.array([evidence.exact.column(n)[row] - evidence.exact.column(n)[0] for n in names]) - 2 * np.pi * turns


def _drift_of_period(evidence: Evidence, row: int) -> Array:
    """Return what the velocities of the last row make of the time between it and the period."""
    motion = evidence.motion
    late = float(motion.t[row] - round(motion.t[row] / evidence.period) * evidence.period)
    rates = [motion.column(c.rate)[row] for c in evidence.variant.coordinates if c.name in motion.coordinate_names]
    return np.array([*(rate * late for rate in rates), *np.zeros(len(motion.velocity_names))])


def _judge(evidence: Evidence, code: str, title: str, names: tuple[str, ...], what: str) -> Check:
    splits = mismatch(evidence)
    if splits is None:
        return Check(code, title, "SKIP", _why_skipped(evidence))
    chosen = [split for split in splits if split.name in names]
    if evidence.variant.time.period is None and (reason := _no_period(evidence, chosen)):
        return Check(code, title, "SKIP", reason)
    worst = max(chosen, key=lambda split: abs(split.total) / split.limit)
    verdict: Verdict = "PASS" if abs(worst.total) <= worst.limit else "FAIL"
    turned = [f"{split.name} made {split.turns} whole turn(s)" for split in chosen if split.turns]
    which = f"{what} {worst.name}"
    note = f" {'; '.join(turned)}, taken off." if turned else ""
    if verdict == "PASS":
        sentence = f"The last row repeats the first within the error of the scheme; {which} differs most for its limit.{note}"
    elif abs(worst.period) > 0.5 * abs(worst.total):
        sentence = (
            f"The true motion itself does not repeat after {evidence.period:.6g} s: {worst.name} differs. Check the period.{note}"
        )
    else:
        sentence = f"The last row does not repeat the first: {which} differs by more than the scheme's error explains.{note}"
    rows = tuple((f"{split.name}: {part}", getattr(split, part), split.unit) for split in chosen for part in _PARTS)
    return Check(code, title, verdict, sentence, abs(worst.total), worst.limit, worst.unit, rows)


_PARTS = ("total", "scheme", "period", "roundoff")


def _why_skipped(evidence: Evidence) -> str:
    if evidence.motion.stop is not None:
        return f"The motion stopped at t = {evidence.motion.stop.time:.6g} s, so there is no last row to compare."
    return f"The run ends at {evidence.motion.t[-1]:.6g} s, before one period of {evidence.period:.6g} s."


def _no_period(evidence: Evidence, chosen: list[Split]) -> str:
    spans = {split.name: float(np.ptp(evidence.motion.column(split.name))) for split in chosen}
    if any(abs(split.period) > 0.05 * spans[split.name] + _ROUND_OFF for split in chosen):
        return "The file states no period and the true motion does not repeat at the end of the run."
    return ""


def position(evidence: Evidence) -> Check:
    """The last row repeats the first in every coordinate (whole turns taken off)."""
    return _judge(evidence, "PERIOD-POSITION", "Period, positions", evidence.motion.coordinate_names, "coordinate")


def velocity(evidence: Evidence) -> Check:
    """The last row repeats the first in every velocity."""
    return _judge(evidence, "PERIOD-VELOCITY", "Period, velocities", evidence.motion.velocity_names, "velocity")


def assembly(evidence: Evidence) -> Check:
    """Every determinant keeps its sign: the mechanism stays in one assembly over the whole run."""
    determinants = evidence.motion.determinants
    if len(determinants) < 2 or not determinants.shape[1]:
        return Check("PERIOD-ASSEMBLY", "Period, assembly", "SKIP", "There are no two rows to compare.")
    signs = np.sign(determinants)
    changed = np.argwhere(signs != signs[0])
    smallest = float(np.min(np.abs(evidence.motion.scaled))) if evidence.motion.scaled.size else None
    if len(changed):
        row = int(changed[0][0])
        sentence = f"A determinant changes its sign at row {row + 1}: the rows from there belong to another assembly."
        return Check("PERIOD-ASSEMBLY", "Period, assembly", "FAIL", sentence, smallest, None, "relative")
    sentence = "Every determinant keeps its sign: one assembly over the whole run. The value is the smallest determinant met."
    return Check("PERIOD-ASSEMBLY", "Period, assembly", "PASS", sentence, smallest, None, "relative")
