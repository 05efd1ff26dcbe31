"""STEP: rows enough for the drive, for every turn of a crank, one at each break of the drive, nothing hidden between two.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`, `advice.py`, `study.py`,
`step_rules.py`, `closeness.py`, and `checks.py` of the forces.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.drive import breaks, drive_values, resolution
from coursework.motion.geometry.swings import turning_cranks
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, percent, skipped
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import joined

# Explicit Euler wants at least twenty rows a period of the drive, and a turn of a crank.
ROWS_A_PERIOD = 20
# A break of the drive this part of its time from a row is at the row.
AT_ROW = 1e-9
# The part of its range by which |sin| leaves the line between two of twenty rows a period, at a fold, is a sixth.
FOLD = 0.2
# A stretch of the drive that is this part of a step is looked into, at so many places; so many tell the range of the drive.
_SUDDEN, _LOOKS, _RANGE = 2, 9, 1001
_AT_ROW = 1e-12
# Parts of a step after which a break counts as one that no whole part of the step meets.
_MOST_PARTS = 1000


def enough(evidence: Evidence) -> Finding:
    """At least twenty rows a period of the drive and a turn of a crank, a row at each break, no pulse between two rows.

    Exact rows have no error from a break between them, so they are judged by the rows a period and a turn alone.
    """
    step, variant = evidence.motion.step, evidence.variant
    listed = joined([evidence.say("check.STEP.time", time=time) for time in breaks(variant)], "join.numbers")
    missed = off_row(variant, step)
    is_exact = evidence.motion.scheme == EXACT
    if missed and not is_exact:
        time = missed[0]
        row = int(time / step)
        late = float(row + 1 - time / step)
        sentence = evidence.say("check.STEP.break", time=time, row=row + 1, next=row + 2, late=late, breaks=listed)
        return Finding(
            "COARSE", sentence, late, None, evidence.say("unit.of_a_step"), None, row + 1, cured=parts_at_breaks(evidence) > 0
        )
    if (hidden := evidence.once(f"hidden at {step!r} s", lambda: between_rows(evidence.equations, step))) is not None:
        name, time, share = hidden
        row = int(time / step) + 1
        sentence = evidence.say("check.STEP.sudden", name=name, time=time, row=row, next=row + 1, share=percent(share))
        return Finding("COARSE", sentence, share, None, evidence.say("unit.of_its_range"), None, row)
    between = [evidence.say("check.STEP.exact", breaks=listed)] if missed else []
    cranks = evidence.once("turning", lambda: turning_cranks(evidence.equations))
    speeds = {"": evidence.drive_frequency, **{name: cranks[name] for name in cranks if name in evidence.motion.names}}
    name = max(speeds, key=lambda key: speeds[key])
    if not speeds[name] > 0:
        return Finding("PASS", between[0]) if between else skipped(evidence.say("check.STEP.skip"))
    rows = float(2 * np.pi / (speeds[name] * step))
    verdict = "pass" if rows >= ROWS_A_PERIOD * (1 - 1e-9) else "coarse"
    most = float(2 * np.pi / ROWS_A_PERIOD / speeds[name])
    key = f"check.STEP.turn.{verdict}" if name else f"check.STEP.{verdict}"
    sentence = joined([evidence.say(key, name=name, frequency=speeds[name], rows=rows, step=most), *between])
    unit = evidence.say("unit.rows", number=rows)
    return Finding("PASS" if verdict == "pass" else "COARSE", sentence, rows, float(ROWS_A_PERIOD), unit, name or None)


def between_rows(equations: VelocityEquations, step: float) -> tuple[str, float, float] | None:
    """Return the drive that leaves the line between two rows a step (s) apart the most, when (s), and by what part of its range.

    None where none does by more than `FOLD`.  Looked at is what takes less than a step; a break between rows is told otherwise.
    """
    variant, (begin, end) = equations.variant, resolution(equations).shorter(step / _SUDDEN)
    names = [law.name for law in variant.drive]
    if not len(begin) or not names:
        return None
    times = (begin[:, None] + (end - begin)[:, None] * (np.arange(_LOOKS) + 0.5) / _LOOKS).reshape(-1)
    row = np.floor(times / step)
    kept = ~np.isin(row, [int(time / step) for time in off_row(variant, step)])
    times, row = times[kept], row[kept]
    if not len(times):
        return None
    # A row at a break of the drive is the end of its old formula, and the begin of the new one.
    first, last = (drive_values(equations, names, at) for at in (row * step * (1 + _AT_ROW), (row + 1) * step * (1 - _AT_ROW)))
    values, part = drive_values(equations, names, times), (times / step - row)[:, None]
    rows = drive_values(equations, names, np.linspace(0.0, variant.time.end, _RANGE))
    seen = np.concatenate([values, first, last, rows])
    off = np.abs(values - first - part * (last - first)) / np.maximum(np.ptp(seen, axis=0), np.finfo(float).tiny)
    place, column = np.unravel_index(np.argmax(np.where(np.isfinite(off), off, 0.0)), off.shape)
    share = float(off[place, column])
    return (names[column], float(times[place]), share) if share > FOLD else None


def off_row(variant: Variant, step: float) -> list[float]:
    """Return the breaks of the drive (s) that no row of a run with this step (s) is at."""
    return between(breaks(variant), step, variant.time.end)


def between(times: Iterable[float], step: float, end: float) -> list[float]:
    """Return the times (s) before the end that no row of a run with this step (s) is at."""
    return [time for time in times if time < end and abs(time / step - round(time / step)) > AT_ROW * (1 + time / step)]


def parts_at_breaks(evidence: Evidence, least: int = 1) -> int:
    """Return the fewest parts of the step, at least `least`, that leave a row at each break of the drive; 0 where none do."""
    step = evidence.motion.step
    return next((parts for parts in range(least, least + _MOST_PARTS) if not off_row(evidence.variant, step / parts)), 0)
