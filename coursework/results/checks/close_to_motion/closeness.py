"""ACCURACY: how far the table is from the motion of the mechanism, and whether its rows follow from each other.

Enters: `Evidence`.  Leaves: a `Finding`.  Used by `check.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.results.checks.evidence import LIMIT, Evidence, worst
from coursework.results.checks.result import Finding, percent, skipped
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.sentences import say

# Rows made by the scheme follow from each other to round-off (5e-13 of the scale at most in the tool's own runs).
SPOILT = 1e-9


def accuracy(evidence: Evidence) -> Finding:
    """Every column of every row is within 5 % of its scale of the exact motion."""
    motion, names = evidence.motion, evidence.names
    unit = evidence.say("unit.of_the_scale")
    beyond = evidence.compared
    if evidence.stop is not None and len(motion.t) > beyond:
        sentence = evidence.say("check.ACCURACY.beyond", row=beyond + 1, time=evidence.stop.time)
        return Finding("FAIL", sentence, row=beyond + 1)
    if len(motion.t) > beyond or not names:
        return skipped(evidence.say("check.unknown"))
    if len(motion.t) == 1 and motion.stop is not None:
        return skipped(evidence.say("check.ACCURACY.one_row"))
    shares = np.abs(evidence.errors)
    row, place = worst(shares)
    name, value = names[place], float(shares[row, place])
    known = {"name": name, "row": row + 1, "scale": evidence.scale[name], "unit": evidence.unit(name)}
    found = evidence.say("check.ACCURACY.found", share=percent(value, LIMIT), **known)
    lines = tuple(
        (evidence.say("check.largest", name=name), float(size), unit)
        for name, size in zip(names, np.max(shares, axis=0), strict=True)
    )
    if (spoilt := _spoilt(evidence)) is not None:
        at, where, gap = spoilt
        key = "check.ACCURACY.first" if at == 0 else "check.ACCURACY.spoilt"
        sentence = evidence.say(key, name=where, row=at + 1, before=at, gap=percent(gap), found=found)
        return Finding("FAIL", sentence, value, LIMIT, unit, where, at + 1, rows=lines)
    if value == 0:
        sentence = evidence.say("check.ACCURACY.same")
    else:
        sentence = evidence.say("check.ACCURACY.pass" if value <= LIMIT else "check.ACCURACY.coarse", found=found)
    return Finding("PASS" if value <= LIMIT else "COARSE", sentence, value, LIMIT, unit, name, row + 1, rows=lines)


@frozen
class Distance:
    """The distance of a scheme's rows from the motion: a `share` of the scale of `column`, largest in `row` (from 1)."""

    scheme: str
    share: float
    column: str
    row: int
    sentence: str


def distance(evidence: Evidence) -> Distance | None:
    """Return how far the rows are from the exact motion, None if there is nothing to compare."""
    if not evidence.names or evidence.compared < 2:
        return None
    row, place = worst(evidence.errors)
    share, column = float(abs(evidence.errors[row, place])), evidence.names[place]
    scale, unit = evidence.scale[column], evidence.unit(column)
    sentence = say("exact.lesson", share=percent(share), name=column, row=row + 1, scale=scale, unit=unit)
    return Distance(evidence.motion.scheme, share, column, row + 1, sentence)


def _spoilt(evidence: Evidence) -> tuple[int, str, float] | None:
    """Return (row from 0, column, share) of the first row that does not follow from the row before, None if all do."""
    motion, replay = evidence.motion, evidence.replay
    if replay is None or evidence.restricted:
        return None
    angles = np.array([evidence.unit(name) == "rad" for name in motion.names])
    scales = np.array([evidence.scale[name] for name in motion.names])

    def shares(made: Array, rows: Array) -> Array:
        gaps = rows - made
        return np.asarray(np.abs(gaps - np.where(angles, whole_turns(gaps), 0.0)) / scales)

    suspicious = ~(np.max(shares(replay.rows(motion), motion.rows), axis=1) <= SPOILT)
    for row in np.flatnonzero(suspicious).tolist():
        # Near a dead point round-off grows: there the scalar arithmetic of the march itself decides.
        found = np.nan_to_num(shares(replay.row(motion, row), motion.rows[row]), nan=np.inf)
        place = int(np.argmax(found))
        if found[place] > SPOILT:
            return row, motion.names[place], float(found[place])
    return None
