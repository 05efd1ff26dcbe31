"""All checks in the order of the page; to add one, write a function in its family's file and a line here."""

from __future__ import annotations

from collections.abc import Callable

from coursework.checks import conditioning, curves, drift, equations, long_run, period
from coursework.checks.evidence import Evidence
from coursework.checks.result import Check, judged
from coursework.sentences import say

CHECKS: dict[str, Callable[[Evidence], Check]] = {
    "STOP": drift.stopped,
    "START": drift.start,
    "INITIAL": equations.initial,
    "RESIDUAL": equations.every_row,
    "CONDITION": conditioning.condition,
    "PERIOD-POSITION": period.position,
    "PERIOD-VELOCITY": period.velocity,
    "PERIOD-ASSEMBLY": period.assembly,
    "CONTINUITY": curves.continuity,
    "SINUSOID": curves.sinusoid,
    "STEP": curves.rows_enough,
    "PEAK": conditioning.peak,
    "DRIFT": drift.drift,
    "DRIFT-PER-PERIOD": long_run.per_period,
}


def check_motion(evidence: Evidence) -> tuple[Check, ...]:
    """Return every check; a fault inside one is an ERROR of the tool, never of the student."""
    found = []
    for code, rule in CHECKS.items():
        if not len(evidence.motion.t) and code != "STOP":
            found.append(judged(code, "SKIP", say("check.no_row")))
            continue
        try:
            found.append(rule(evidence))
        except (ArithmeticError, ValueError, KeyError, IndexError) as error:
            found.append(judged(code, "ERROR", say("check.error", kind=type(error).__name__, error=str(error))))
    return tuple(found)
