"""PERIOD-POSITION, PERIOD-VELOCITY, PERIOD-ASSEMBLY: the last row against the first, and the parts of the difference.

Enters: `Evidence`.  Leaves: a `Finding` each, and `Split`, which the page shows.
total = scheme error + (T is not a whole number of steps) + round-off, signed, per column.
Used by `check.py`, `closeness.py`, `conclusion.py` and `results.py`.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from coursework.motion.geometry.drives.drive import drive_values
from coursework.motion.integration.finer import prolonged
from coursework.motion.integration.motion import Motion
from coursework.results.checks.close_to_motion.several_periods import (
    FURTHEST,
    MOST,
    RETURNS,
    Later,
    after,
    ends,
    later,
    missed,
    share_of,
)
from coursework.results.checks.evidence import LIMIT, NEAR_PERIOD, Evidence
from coursework.results.checks.result import Finding, percent, skipped
from coursework.system.angles import whole_turns
from coursework.system.frozen import frozen
from coursework.variant.record.held import followed
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

POSITION = "PERIOD-POSITION"
# If the exact motion alone misses its start by this share of the limit, a finer step cannot bring the row within the limit.
NEARLY = 0.9
# Share of the scale by which a motion may miss its start after several periods: five digits of the period.
AGAIN = 1e-4


@frozen
class Split:
    """The mismatch of one column, signed: `total` = `scheme` + `period` + `roundoff` = `last` - `first` without `turns`."""

    name: str
    unit: str
    turns: int
    first: float
    last: float
    total: float
    scheme: float
    period: float
    roundoff: float


def mismatch(evidence: Evidence) -> tuple[Split, ...] | None:
    """Return the split of every column, None if the run does not reach a period or stopped before."""
    row, motion, exact = evidence.period_row, evidence.motion, evidence.exact
    if row is None or motion.stop is not None or row >= evidence.compared:
        return None
    rows = motion.rows
    angles = np.array([evidence.unit(name) == "rad" for name in motion.names])
    turned = np.where(angles, whole_turns(rows[row] - rows[0]), 0.0)
    last = rows[row] - turned
    true = np.array([exact.column(name)[row] - exact.column(name)[0] for name in motion.names])
    period = true - np.where(angles, whole_turns(true), 0.0)
    roundoff = np.zeros(len(last))
    if evidence.extended_precision is not None:
        count = len(motion.coordinate_names)
        roundoff[:count] = (rows[row, :count] - evidence.extended_precision[row, :count]).astype(float)
    total = last - rows[0]
    scheme = total - period - roundoff
    columns = zip(
        motion.names, np.round(turned / (2 * np.pi)).astype(int).tolist(),
        *(part.tolist() for part in (rows[0], last, total, scheme, period, roundoff)), strict=True,
    )  # fmt: skip
    return tuple(Split(name, evidence.unit(name), *parts) for name, *parts in columns)


def position(evidence: Evidence) -> Finding:
    """The last row repeats the first in every coordinate (whole turns taken off)."""
    return _judge(evidence, POSITION, evidence.motion.coordinate_names)


def velocity(evidence: Evidence) -> Finding:
    """The last row repeats the first in every velocity."""
    return _judge(evidence, "PERIOD-VELOCITY", evidence.motion.velocity_names)


def _judge(evidence: Evidence, code: str, names: tuple[str, ...]) -> Finding:
    splits = evidence.once("mismatch", lambda: mismatch(evidence), of_rows=True)
    if splits is None:
        return _behind_the_end(evidence, [name for name in names if name in evidence.names], code)
    scale, unit = evidence.scale, evidence.say("unit.of_the_scale")
    judged = {split.name: split for split in splits if split.name in evidence.names}
    chosen = [split for name, split in judged.items() if name in names]
    if not chosen:
        return skipped(evidence.say("check.PERIOD.driven"))
    if evidence.variant.time.period is None:
        if any(abs(split.period) > RETURNS * scale[name] for name, split in judged.items()):
            return skipped(evidence.say("check.PERIOD.unstated"))
    elif (wrong := _wrong(evidence, [split.name for split in chosen])) is not None:
        return _judged_later(evidence, code, names) or replace(wrong, is_news=wrong.verdict == "SKIP" and code == POSITION)
    shares = {split.name: share_of(split.total, scale[split.name], evidence.least(split.name)) for split in chosen}
    worst = max(chosen, key=lambda split: shares[split.name])
    value, row = shares[worst.name], evidence.period_row
    assert row is not None
    first, last = (0.0 if abs(end) < evidence.least(worst.name) else end for end in (worst.first, worst.last))
    found = {
        "which": evidence.say(f"check.{code}.which", name=worst.name), "share": percent(value, LIMIT), "row": row + 1,
        "first": first, "last": last, "gap": abs(worst.total), "unit": worst.unit, "scale": scale[worst.name],
    }  # fmt: skip
    if value == 0:
        told = [evidence.say("check.PERIOD.same", row=row + 1)]
    else:
        alike = "near" if f"{first:.6g}" == f"{last:.6g}" else "pass"  # two numbers that read alike are not called different
        told = [evidence.say(f"check.PERIOD.{alike if value <= LIMIT else 'coarse'}", **found)]
    late = share_of(worst.period, scale[worst.name], evidence.least(worst.name))
    if cannot_return := value > LIMIT and late > NEARLY * LIMIT and _is_beyond(evidence, worst.name):
        told.append(evidence.say("check.PERIOD.due", share=percent(late), period=evidence.period))
    if turned := [evidence.say("check.PERIOD.turns", number=split.turns, name=split.name) for split in chosen if split.turns]:
        told.append(evidence.say("check.PERIOD.taken_off", turned=joined(turned, "join.semicolon")))
    lines = tuple((_label(split.name, part), getattr(split, part), split.unit) for split in chosen for part in _PARTS)
    return Finding(
        "PASS" if value <= LIMIT else "COARSE", joined(told), value, LIMIT, unit, worst.name, row + 1, worst.first, worst.last,
        rows=lines, cured=not cannot_return,
    )  # fmt: skip


@cache
def _label(name: str, part: str) -> Sentence:
    """Return the label of one part of a column's mismatch; cached, because every step tried for an advice needs it."""
    return say("check.line", name=name, part=say(f"check.PERIOD.part.{part}"))


_PARTS = ("first", "last", "total", "scheme", "period", "roundoff")


def _behind_the_end(evidence: Evidence, names: list[str], code: str) -> Finding:
    """Return the finding for a period that no row reaches: if it ends after the run, the exact motion is followed there.

    If that is too far, the drive alone, as a function of time, may show that the motion is not back then.
    """
    exact, period = evidence.exact, evidence.period
    stated = evidence.variant.time.period is not None and not evidence.restricted
    judged = stated and evidence.motion.stop is None and evidence.stop is None and evidence.period_row is None
    if not (judged and names and len(exact.t) > 1):
        return skipped(_why_skipped(evidence))
    if period > FURTHEST * float(exact.t[-1]):
        return (_drive_strayed(evidence) if code == "PERIOD-VELOCITY" else None) or skipped(_why_skipped(evidence))
    longer = evidence.once(f"exact up to {period!r}", lambda: prolonged(exact, evidence.rates, period))
    if longer is None:
        return skipped(_why_skipped(evidence))
    # The scale must be that of a whole period, of which the run covers only a part.
    wrong = _wrong(replace(evidence, exact=longer), names)
    return wrong or skipped(evidence.say("check.PERIOD.due_later", end=float(evidence.motion.t[-1]), period=period))


def _judged_later(evidence: Evidence, code: str, names: tuple[str, ...]) -> Finding | None:
    """Return the finding after several periods, None if the mechanism is not back then or the run does not reach them."""
    back = later(evidence)
    near = max(evidence.motion.step / 2, NEAR_PERIOD * evidence.period)
    if back is None or back.periods is None or float(evidence.motion.t[-1]) < back.time - near:
        return None
    time = replace(evidence.variant.time, period=back.time)
    found = _judge(replace(evidence, variant=replace(evidence.variant, time=time)), code, names)
    told = evidence.say("check.PERIOD.later", after=_periods(evidence, back), time=back.time)
    return replace(found, sentence=joined([told, found.sentence]))


def _periods(evidence: Evidence, back: Later) -> str:
    return evidence.say("check.PERIOD.drive", number=back.periods)


def _wrong(evidence: Evidence, names: list[str]) -> Finding | None:
    """Return that the stated period, or that of the drive alone, is wrong; None if the exact motion is back after it."""
    if _strayed(evidence, list(evidence.names)) is None:
        return None
    if (back := later(evidence)) is not None:  # if a wheel is nearly back, only its velocities show it
        if back.periods is None:
            return skipped(evidence.say("check.PERIOD.never", period=evidence.period, most=MOST))
        end = float(evidence.motion.t[-1])
        return skipped(evidence.say("check.PERIOD.later_end", after=_periods(evidence, back), time=back.time, end=end))
    if (strayed := _strayed(evidence, names)) is None or (found := _not_back(evidence, *strayed)) is None:
        return None
    number = evidence.once(f"back after a multiple of {evidence.period!r}", lambda: _multiple(evidence))
    told = evidence.say("check.PERIOD.multiple", number=number, time=number * evidence.period) if number else ""
    return replace(found, sentence=joined([found.sentence, told]))


def _multiple(evidence: Evidence) -> int:
    """Return the number of stated periods after which, in the run or as long after it, the exact motion is back; 0 if none.

    This happens if two cranks turn at 3 : 5 and the period of one is stated.
    """
    most = min(MOST, int(FURTHEST * float(evidence.motion.t[-1]) / evidence.period * (1 + NEAR_PERIOD)))
    rows = ((number, after(evidence, number * evidence.period)) for number in range(2, most + 1))
    back = (k for k, row in rows if row is not None and all(missed(evidence, row, name) <= AGAIN for name in evidence.names))
    return next(back, 0)


def _drive_strayed(evidence: Evidence) -> Finding | None:
    """Return that the drive after the stated period differs from the start; None if it does not, or if it is unknown."""
    laws = [law.name for law in evidence.variant.drive if not law.table]
    values = drive_values(evidence.equations, laws, np.append(evidence.exact.t, evidence.period))
    if not laws or not np.isfinite(values).all():
        return None
    scale = np.ptp(values[:-1], axis=0)
    shares = np.abs(values[-1] - values[0]) / np.where(scale > 0, scale, np.inf)
    worst = int(np.argmax(shares))
    return _not_back(evidence, laws[worst], *map(float, (shares[worst], values[0, worst], values[-1, worst])))


def _not_back(evidence: Evidence, name: str, share: float, first: float, last: float) -> Finding | None:
    """Return that a column has another value after the stated period; None if the difference is within the limit."""
    if share <= RETURNS:
        return None
    variant = evidence.variant
    # A drive may measure anything.
    unit = "m/s" if name in followed(variant) else evidence.unit(name) if name in variant.columns else ""
    known = {"name": name, "unit": unit, "share": percent(share), "first": first, "last": last}
    sentence = evidence.say("check.PERIOD.period", period=evidence.period, **known)
    return Finding("FAIL", sentence, share, RETURNS, evidence.say("unit.of_the_scale"), name, None, first, last)


def _strayed(evidence: Evidence, names: list[str]) -> tuple[str, float, float, float] | None:
    """Return (column, share, start, value after the stated period) if the exact motion is not back; None if it is."""
    if evidence.restricted or (then := after(evidence, evidence.period)) is None:
        return None
    worst = max(names, key=lambda name: missed(evidence, then, name))
    share = missed(evidence, then, worst)
    return (worst, share, *ends(evidence, then, worst)) if share > RETURNS else None


def is_a_period(evidence: Evidence) -> bool:
    """Return whether the file states a period and the exact motion is not known to miss its start after it."""
    return evidence.variant.time.period is not None and _strayed(evidence, list(evidence.names)) is None


def _is_beyond(evidence: Evidence, name: str) -> bool:
    """Return whether the exact motion misses its start even at the time nearest to a whole period that any step can reach."""
    row = evidence.period_row
    assert row is not None
    whole = round(float(evidence.motion.t[row]) / evidence.period) * evidence.period
    then = after(evidence, min(whole, evidence.variant.time.end))
    return then is None or missed(evidence, then, name) > NEARLY * LIMIT


def _why_skipped(evidence: Evidence) -> str:
    motion = evidence.motion
    if motion.stop is not None:
        return evidence.say("check.PERIOD.stopped", time=float(motion.t[-1]))
    if evidence.compared < len(motion.t):
        return evidence.say("check.unknown")
    return evidence.say("check.PERIOD.short", end=float(motion.t[-1]), period=evidence.period)


def assembly(evidence: Evidence) -> Finding:
    """Every determinant keeps its sign: the mechanism stays in one assembly over the whole run."""
    motion, determinants = evidence.motion, evidence.motion.determinants
    if len(determinants) < 2 or not determinants.shape[1]:
        return skipped(evidence.say("check.PERIOD-ASSEMBLY.skip"))
    unit = evidence.say("unit.relative")
    smallest = float(np.min(np.abs(motion.scaled)))
    row = _changed(motion, evidence)
    if (true := _changed(evidence.exact, evidence)) is not None:
        return Finding("FAIL", evidence.say("check.PERIOD-ASSEMBLY.fail", row=true + 1), smallest, None, unit, None, true + 1)
    if row is not None:
        return Finding("COARSE", evidence.say("check.PERIOD-ASSEMBLY.coarse", row=row + 1), smallest, None, unit, None, row + 1)
    how = "through" if evidence.passages else "pass"
    return Finding("PASS", evidence.say(f"check.PERIOD-ASSEMBLY.{how}"), smallest, None, unit)


def _changed(motion: Motion, evidence: Evidence) -> int | None:
    """Return the first row (from 0) whose signs differ from the first row's, apart from passages; None if there is none."""
    if not motion.determinants.size:
        return None
    signs = np.sign(motion.determinants)
    for passage in evidence.passages:
        own = np.flatnonzero(np.array(evidence.rates.blocks) == passage.block)
        # A slightly inaccurate scheme passes a row early or late.
        near = np.abs(motion.t - passage.middle.time) < motion.step
        signs[np.ix_(motion.t > passage.middle.time, own)] *= (-1) ** passage.order
        signs[np.ix_(near, own)] = signs[0, own]
    changed = np.flatnonzero(np.any(signs != signs[0], axis=1))
    return int(changed[0]) if len(changed) else None
