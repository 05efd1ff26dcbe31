"""PERIOD-POSITION, PERIOD-VELOCITY, PERIOD-ASSEMBLY: the last row against the first, and what the difference is made of.

total = scheme error + (T is not a whole number of steps) + round-off, signed, per column.  The limit comes from the
scheme's own error at this step, so a coarse step is not blamed twice and a wrong table is not excused.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, Verdict, judged
from coursework.sentences import Sentence, joined, say

Array = NDArray[np.float64]
# The estimate from one halving of the step is right to its leading term; a factor of three covers the rest.
SAFETY = 3.0
# A column whose error happens to cross zero at the last row is still allowed this part of its largest error.
SHARE_OF_LARGEST = 0.3
_ROUND_OFF = 1e-12
# A period may be stated with three digits (T = 0.48 s): what the motion does in that part of it is no fault.
PERIOD_DIGITS = 2e-3


@dataclass(frozen=True, slots=True)
class Split:
    """The mismatch of one column, signed: `total` = `scheme` + `period` + `roundoff`; `turns` whole turns taken off.

    `explained`: how much of `period` comes from the row beside the period and from the digits the period is stated with.
    """

    name: str
    unit: str
    turns: int
    total: float
    scheme: float
    period: float
    roundoff: float
    limit: float
    explained: float


def mismatch(evidence: Evidence) -> tuple[Split, ...] | None:
    """Return the split of every column, None where the run does not reach a period or stopped before."""
    row = evidence.period_row
    motion = evidence.motion
    if row is None or row >= len(motion.t) or motion.stop is not None:
        return None
    rows = motion.rows
    total = rows[row] - rows[0]
    turns = _turns(evidence, total)
    total = total - 2 * np.pi * turns
    exact = _exact_part(evidence, row)
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
    rounding = _ROUND_OFF * (1 + np.max(np.abs(rows), axis=0))
    explained = _explained(evidence, row) + rounding
    limit = limit + np.minimum(np.abs(period), explained) + rounding
    columns = zip(motion.names, turns.astype(int).tolist(), *(
        part.tolist() for part in (total, scheme, period, roundoff, limit, explained)
    ), strict=True)  # fmt: skip
    return tuple(Split(name, evidence.unit(name), turned, *parts) for name, turned, *parts in columns)


def _turns(evidence: Evidence, differences: Array) -> Array:
    """Return the whole turns in each difference: none but in angles."""
    angles = np.array([evidence.unit(name) == "rad" for name in evidence.motion.names])
    return np.where(angles, np.round(differences / (2 * np.pi)), 0.0)


def _exact_part(evidence: Evidence, row: int) -> Array | None:
    if evidence.exact is None or row >= len(evidence.exact.t):
        return None
    moved = np.array([evidence.exact.column(n)[row] - evidence.exact.column(n)[0] for n in evidence.motion.names])
    return np.asarray(moved - 2 * np.pi * _turns(evidence, moved))


def _drift_of_period(evidence: Evidence, row: int) -> Array:
    """Return what the velocities of the last row make of the time between it and the period."""
    motion = evidence.motion
    late = _late(evidence, row)
    rates = [motion.column(c.rate)[row] for c in evidence.variant.coordinates if c.name in motion.coordinate_names]
    return np.array([*(rate * late for rate in rates), *np.zeros(len(motion.velocity_names))])


def _late(evidence: Evidence, row: int) -> float:
    """Return by how much (s) a row lies behind the whole period nearest to it."""
    time = float(evidence.motion.t[row])
    return time - round(time / evidence.period) * evidence.period


def _explained(evidence: Evidence, row: int) -> Array:
    """Return how far each column moves in the time between the row and the period, and in the period's last digits."""
    motion = evidence.exact or evidence.motion
    variant = evidence.variant
    rates = {c.name: c.rate for c in variant.coordinates}
    slopes = [
        motion.column(rates[name]) if name in rates else np.gradient(motion.column(name), motion.step)
        for name in evidence.motion.names
    ]
    time = abs(_late(evidence, row)) + PERIOD_DIGITS * float(evidence.motion.t[row])
    return np.array([time * float(np.max(np.abs(slope))) for slope in slopes])


def _judge(evidence: Evidence, code: str, names: tuple[str, ...]) -> Check:
    splits = mismatch(evidence)
    if splits is None:
        return judged(code, "SKIP", _why_skipped(evidence))
    chosen = [split for split in splits if split.name in names]
    is_stated = evidence.variant.time.period is not None
    if not is_stated and (reason := _no_period(evidence, chosen)):
        return judged(code, "SKIP", reason)
    may_stray = is_stated and evidence.exact is not None
    strayed = [split for split in chosen if may_stray and abs(split.period) > split.explained]
    worst = max(strayed or chosen, key=lambda split: abs(split.total) / split.limit)
    verdict: Verdict = "FAIL" if strayed or abs(worst.total) > worst.limit else "PASS"
    if strayed:
        sentence = say("check.PERIOD.period", period=evidence.period, name=worst.name)
    else:
        sentence = say(f"check.PERIOD.{verdict.lower()}", which=say(f"check.{code}.which", name=worst.name))
    turned = [say("check.PERIOD.turns", name=split.name, turns=split.turns) for split in chosen if split.turns]
    if turned:
        sentence = joined([sentence, say("check.PERIOD.taken_off", turned=joined(turned, "join.semicolon"))])
    rows = tuple(
        (say("check.line", name=split.name, part=say(f"check.PERIOD.part.{part}")), getattr(split, part), split.unit)
        for split in chosen
        for part in _PARTS
    )
    value, limit = (abs(worst.period), worst.explained) if strayed else (abs(worst.total), worst.limit)
    return judged(code, verdict, sentence, value, limit, worst.unit, rows)


_PARTS = ("total", "scheme", "period", "roundoff")


def _why_skipped(evidence: Evidence) -> Sentence:
    if evidence.motion.stop is not None:
        return say("check.PERIOD.stopped", time=evidence.motion.stop.time)
    return say("check.PERIOD.short", end=float(evidence.motion.t[-1]), period=evidence.period)


def _no_period(evidence: Evidence, chosen: list[Split]) -> str:
    spans = {split.name: float(np.ptp(evidence.motion.column(split.name))) for split in chosen}
    if any(abs(split.period) > 0.05 * spans[split.name] + _ROUND_OFF for split in chosen):
        return say("check.PERIOD.unstated")
    return ""


def position(evidence: Evidence) -> Check:
    """The last row repeats the first in every coordinate (whole turns taken off)."""
    return _judge(evidence, "PERIOD-POSITION", evidence.motion.coordinate_names)


def velocity(evidence: Evidence) -> Check:
    """The last row repeats the first in every velocity."""
    return _judge(evidence, "PERIOD-VELOCITY", evidence.motion.velocity_names)


def assembly(evidence: Evidence) -> Check:
    """Every determinant keeps its sign: the mechanism stays in one assembly over the whole run."""
    determinants = evidence.motion.determinants
    if len(determinants) < 2 or not determinants.shape[1]:
        return judged("PERIOD-ASSEMBLY", "SKIP", say("check.PERIOD-ASSEMBLY.skip"))
    signs = np.sign(determinants)
    changed = np.argwhere(signs != signs[0])
    smallest = float(np.min(np.abs(evidence.motion.scaled))) if evidence.motion.scaled.size else None
    if len(changed):
        sentence = say("check.PERIOD-ASSEMBLY.fail", row=int(changed[0][0]) + 1)
        return judged("PERIOD-ASSEMBLY", "FAIL", sentence, smallest, None, say("unit.relative"))
    return judged("PERIOD-ASSEMBLY", "PASS", say("check.PERIOD-ASSEMBLY.pass"), smallest, None, say("unit.relative"))
