"""STEP: enough rows for the drive and for every turn of a crank, a row at each break, nothing hidden between two rows.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`, `advice.py`, `study.py`,
`step_rules.py`, `closeness.py`, and `checks.py` of the forces.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.drives.drive import breaks, drive_values, resolution
from coursework.motion.geometry.drives.swings import turning_cranks
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, percent, skipped
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import joined

# Explicit Euler needs at least twenty rows in a period of the drive and in a turn of a crank.
ROWS_A_PERIOD = 20
# A break within this share of its time from a row is at the row.
AT_ROW = 1e-9
# Limit for the deviation from a line between two rows, as a share of the range; |sin| at a fold, with twenty rows a period: 1/6.
FOLD = 0.2
# Stretches of the drive below 1/_SUDDEN of a step are evaluated at `_LOOKS` places; `_RANGE` places give the range of the drive.
_SUDDEN, _LOOKS, _RANGE = 2, 9, 1001
_AT_ROW = 1e-12
# Largest number of parts of a step that is tried to put a row at each break.
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
    """Return the drive that deviates most from a line between rows a step (s) apart, when (s), and by what share of its range.

    None if the share is at most `FOLD`.  Only stretches shorter than a step are examined; breaks between rows are reported
    elsewhere.
    """
    variant, (begin, end) = equations.variant, resolution(equations).shorter(step / _SUDDEN)
    names = [law.name for law in variant.drive]
    if not len(begin) or not names:
        return None
    times = (begin[:, None] + (end - begin)[:, None] * (np.arange(_LOOKS) + 0.5) / _LOOKS).reshape(-1)
    row = np.floor(times / step)
    # Behind the last row nothing lies between two rows, and a table of measured points may end there.
    kept = ((row + 1) * step <= variant.time.end * (1 + _AT_ROW)) & ~np.isin(
        row, [int(at / step) for at in off_row(variant, step)]
    )
    times, row = times[kept], row[kept]
    if not len(times):
        return None
    # A row at a break of the drive is the end of the old formula and the beginning of the new one.
    first, last = (drive_values(equations, names, at) for at in (row * step * (1 + _AT_ROW), (row + 1) * step * (1 - _AT_ROW)))
    values, part = drive_values(equations, names, times), (times / step - row)[:, None]
    rows = drive_values(equations, names, np.linspace(0.0, variant.time.end, _RANGE))
    seen = np.concatenate([values, first, last, rows])
    off = np.abs(values - first - part * (last - first)) / np.maximum(np.ptp(seen, axis=0), np.finfo(float).tiny)
    place, column = np.unravel_index(np.argmax(np.where(np.isfinite(off), off, 0.0)), off.shape)
    share = float(off[place, column])
    return (names[column], float(times[place]), share) if share > FOLD else None


def off_row(variant: Variant, step: float) -> list[float]:
    """Return the breaks of the drive (s) that fall on no row of a run with this step (s)."""
    return between(breaks(variant), step, variant.time.end)


def between(times: Iterable[float], step: float, end: float) -> list[float]:
    """Return the times (s) before the end that fall on no row of a run with this step (s)."""
    return [time for time in times if time < end and not math.isclose(time / step, round(time / step), rel_tol=AT_ROW)]


def parts_at_breaks(evidence: Evidence, least: int = 1) -> int:
    """Return the fewest parts of the step, at least `least`, that put a row at each break of the drive; 0 if none do."""
    step = evidence.motion.step
    return next((parts for parts in range(least, least + _MOST_PARTS) if not off_row(evidence.variant, step / parts)), 0)
