"""STEP: rows enough for the drive, for every turn of a crank, and one at each break of the drive.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.geometry.drive import breaks
from coursework.motion.geometry.swings import turning_cranks
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, skipped
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import joined

# Explicit Euler wants at least twenty rows a period of the drive, and a turn of a crank.
ROWS_A_PERIOD = 20
# A break of the drive this part of its time from a row is at the row.
AT_ROW = 1e-9
# Parts of a step after which a break counts as one that no whole part of the step meets.
_MOST_PARTS = 1000


def enough(evidence: Evidence) -> Finding:
    """At least twenty rows a period of the drive and a turn of a crank, and a row at each break.

    Exact rows have no error from a break between them, so they are judged by the rows a period and a turn alone.
    """
    step, variant = evidence.motion.step, evidence.variant
    listed = joined([evidence.say("check.STEP.time", time=time) for time in breaks(variant)], "join.numbers")
    missed = off_row(evidence, step)
    is_exact = evidence.motion.scheme == EXACT
    if missed and not is_exact:
        time = missed[0]
        row = int(time / step)
        late = float(row + 1 - time / step)
        sentence = evidence.say("check.STEP.break", time=time, row=row + 1, next=row + 2, late=late, breaks=listed)
        return Finding(
            "COARSE", sentence, late, 0.0, evidence.say("unit.of_a_step"), None, row + 1, cured=parts_at_breaks(evidence) > 0
        )
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


def off_row(evidence: Evidence, step: float) -> list[float]:
    """Return the breaks of the drive (s) that no row of a run with this step (s) is at."""
    return [time for time in breaks(evidence.variant) if abs(time / step - round(time / step)) > AT_ROW * (1 + time / step)]


def parts_at_breaks(evidence: Evidence, least: int = 1) -> int:
    """Return the fewest parts of the step, at least `least`, that leave a row at each break of the drive; 0 where none do."""
    step = evidence.motion.step
    return next((parts for parts in range(least, least + _MOST_PARTS) if not off_row(evidence, step / parts)), 0)
