"""QUOTE: the numbers that the remarks of a file quote equal those of its table.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import SCHEMES, title_of
from coursework.motion.settings import scheme_for
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, skipped
from coursework.variant.record.variant import Quote
from coursework.variant.record.vocabulary import EXACT
from coursework.words.sentences import say

# A number printed with every digit of a double may be off in its last two.
_LAST_DIGITS = 4 * float(np.finfo(float).eps)


def quote(evidence: Evidence) -> Finding:
    """Every number that a remark quotes from a row is that of the table, rounded to the digits of the remark."""
    quotes = evidence.variant.quotes
    if not quotes:
        return skipped(say("check.QUOTE.none"))
    if evidence.variant.set_values:
        return skipped(say("check.QUOTE.set"))
    judged = 0
    for one in quotes:
        motion = _rows(evidence, one)
        if motion is None or one.row > len(motion.t) or one.column not in motion.names:
            continue
        judged += 1
        found = float(motion.column(one.column)[one.row - 1])
        decimals = len(one.value.partition(".")[2])
        if abs(found - float(one.value)) > 0.5 * 10.0**-decimals + _LAST_DIGITS * abs(found):
            printed = f"{found:.{decimals}f}"
            sentence = say("check.QUOTE.fail", row=one.row, name=one.column, said=one.value, found=printed)
            return Finding("FAIL", sentence, found, float(one.value), evidence.unit(one.column), one.column, one.row)
    if not judged:
        scheme = SCHEMES.get(evidence.motion.scheme)
        return skipped(say("check.QUOTE.other", scheme=title_of(scheme) if scheme else say("exact.title")))
    return Finding("PASS", say("check.QUOTE.pass", count=judged))


def _rows(evidence: Evidence, one: Quote) -> Motion | None:
    """Return the rows that a quote refers to: the table's own, or those of a scheme beside an exact table; None without any."""
    time, motion = evidence.variant.time, evidence.motion
    wanted = one.scheme or scheme_for(evidence.variant)
    if time.own_step not in {None, motion.step}:
        return None
    if motion.scheme == wanted:
        return motion
    return evidence.rerun(wanted, motion.step) if motion.scheme == EXACT and evidence.rerun else None
