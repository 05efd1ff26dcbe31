"""All checks in the order of the page; to add one, write a function in its family's file and a line here."""

from __future__ import annotations

from collections.abc import Callable

from coursework.checks import curves, drift, equations, long_run, period, trust
from coursework.checks.evidence import Evidence
from coursework.checks.result import Check

CHECKS: dict[str, Callable[[Evidence], Check]] = {
    "STOP": drift.stopped,
    "START": drift.start,
    "INITIAL": equations.initial,
    "RESIDUAL": equations.every_row,
    "CONDITION": trust.condition,
    "PERIOD-POSITION": period.position,
    "PERIOD-VELOCITY": period.velocity,
    "PERIOD-ASSEMBLY": period.assembly,
    "CONTINUITY": curves.continuity,
    "SINUSOID": curves.sinusoid,
    "STEP": curves.rows_enough,
    "PEAK": trust.peak,
    "DRIFT": drift.drift,
    "DRIFT-PER-PERIOD": long_run.per_period,
}


def check_motion(evidence: Evidence) -> tuple[Check, ...]:
    """Return every check; a fault inside one is an ERROR of the tool, never of the student."""
    found = []
    for code, rule in CHECKS.items():
        if not len(evidence.motion.t) and code != "STOP":
            found.append(Check(code, _title(code), "SKIP", "There is no row to judge: the motion stops at the first one."))
            continue
        try:
            found.append(rule(evidence))
        except (ArithmeticError, ValueError, KeyError, IndexError) as error:
            sentence = f"The tool could not judge this ({type(error).__name__}: {error}); it counts neither for nor against you."
            found.append(Check(code, _title(code), "ERROR", sentence))
    return tuple(found)


def _title(code: str) -> str:
    return code.replace("-", " ").capitalize()
