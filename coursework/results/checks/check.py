"""Every kind of check as one record, in the order of the page, with what it needs before it can judge.

Enters: `Evidence` about any motion.  Leaves: a `Finding` of each kind.  Used by `motion_results.py`; page, run.json and command
line show whatever is found.  To add one: write its judging function, put a `Check` here, and its words under
[check.CODE] in the words file: `title` and the sentences.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.motion.geometry.drives.drive import resolution
from coursework.results.checks import advice
from coursework.results.checks.close_to_motion import closeness, continuity, drift, period, rows, sinusoid
from coursework.results.checks.close_to_motion.stiffness import stiff
from coursework.results.checks.computed_right import beginning, conditioning, digits, equations, quotes
from coursework.results.checks.computed_right.conditioning import condition
from coursework.results.checks.computed_right.divided import Division, divisions
from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Check, Finding, Need, floored
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


def _open_integral(evidence: Evidence) -> Sentence:
    found = resolution(evidence.equations)
    return say("check.unresolved", time=found.place)


def _not_known(evidence: Evidence) -> Sentence:
    if evidence.stop is not None:
        return say("check.unknown")
    found = stiff(evidence)
    return say("check.out_of_reach") if found is None else joined([say("check.too_stiff"), found.sentence])


def _why_not_known(evidence: Evidence) -> Sentence | str:
    """Return what a summary begins with if the exact motion is unknown; an early end of the motion is reported elsewhere."""
    if (found := stiff(evidence)) is not None:
        return found.sentence
    return _not_known(evidence) if evidence.stop is None else ""


def _too_few(evidence: Evidence) -> float | None:
    """Return the digits left by the equations if they are too few to know the exact motion to 5 %, else None."""
    if evidence.restricted:
        return None
    digits = condition(evidence).value
    exact, names = evidence.exact, evidence.names
    if digits is None:
        return None
    way = [float(np.ptp(exact.column(name)) / evidence.scale[name]) for name in names if name in exact.coordinate_names]
    return digits if max(way, default=0.0) * 10.0**-digits > LIMIT else None


def _many_motions(evidence: Evidence) -> Division | None:
    """Return the first division by zero at which many motions of an equation may meet; None without any or with a closure."""
    closed = evidence.closure is not None and evidence.closure.complete
    found = () if evidence.restricted or closed else (one for one in divisions(evidence) if one.is_own)
    return min(found, key=lambda one: one.time, default=None)


def _not_told(evidence: Evidence) -> Sentence:
    found = _many_motions(evidence)
    assert found is not None
    return say("check.ACCURACY.divided", name=found.equation, by=found.by, time=found.time)


ROW = Need(lambda evidence: len(evidence.motion.t) > 0, lambda _: say("check.no_row"))
WHOLE = Need(lambda evidence: not evidence.restricted, lambda _: say("check.only_some"))
# A crank alone has no equations: its motion is given.
SOLVED = Need(lambda evidence: bool(evidence.equations.equations), lambda _: say("check.CONDITION.nothing"))
EXACT = Need(lambda evidence: len(evidence.exact.t) > 0, _not_known, _why_not_known)
CLOSURE = Need(
    lambda evidence: evidence.closure is not None and bool(evidence.closure.names),
    lambda evidence: say("check.DRIFT.skip" if evidence.closure is None else "check.DRIFT.driven"),
)
RESOLVED = Need(lambda evidence: resolution(evidence.equations).met, _open_integral, _open_integral)
DIGITS = Need(
    lambda evidence: _too_few(evidence) is None,
    lambda evidence: say("check.ACCURACY.few_digits", digits=floored(_too_few(evidence) or 0.0, 1)),
)
UNDIVIDED = Need(lambda evidence: _many_motions(evidence) is None, _not_told)


CHECKS: tuple[Check, ...] = (
    Check("STOP", "computation", beginning.stopped, (), is_least=True),
    Check("START", "computation", beginning.start, (ROW,)),
    Check("INITIAL", "computation", equations.initial, (ROW, WHOLE, SOLVED)),
    Check("RESIDUAL", "computation", equations.every_row, (ROW, WHOLE, SOLVED)),
    Check("CONDITION", "computation", conditioning.condition, (ROW, WHOLE), is_least=True),
    Check("AGREEMENT", "computation", equations.agreement, (), is_least=True),
    Check("QUOTE", "computation", quotes.quote, (ROW,)),
    Check("TABLE-DIGITS", "computation", digits.table_digits, (ROW,)),
    Check("ACCURACY", "motion", closeness.accuracy, (ROW, RESOLVED, EXACT, DIGITS, UNDIVIDED)),
    Check("PERIOD-POSITION", "motion", period.position, (ROW, RESOLVED, EXACT, DIGITS, UNDIVIDED)),
    Check("PERIOD-VELOCITY", "motion", period.velocity, (ROW, RESOLVED, EXACT, DIGITS, UNDIVIDED)),
    Check("PERIOD-ASSEMBLY", "motion", period.assembly, (ROW, RESOLVED, SOLVED)),
    Check("CONTINUITY", "motion", continuity.continuity, (ROW, RESOLVED, EXACT, DIGITS, UNDIVIDED)),
    Check("SINUSOID", "motion", sinusoid.sinusoid, (ROW, RESOLVED, EXACT, UNDIVIDED), is_least=True),
    Check("STEP", "motion", rows.enough, (ROW,), is_least=True),
    Check("PEAK", "motion", conditioning.peak, (ROW, RESOLVED, SOLVED)),
    Check("DRIFT", "motion", drift.drift, (ROW, RESOLVED, CLOSURE, WHOLE)),
    Check("DRIFT-PER-PERIOD", "motion", drift.per_period, (ROW, RESOLVED, EXACT, UNDIVIDED)),
)


def check_motion(evidence: Evidence) -> tuple[Finding, ...]:
    """Return the findings of all checks, with advice on the step if a finer one would do."""
    found = [check.finding(evidence) for check in CHECKS]
    return tuple(advice.with_advice(evidence, found, motion_findings))


def motion_findings(evidence: Evidence) -> Sequence[Finding]:
    """Return the findings about closeness alone, by which a run with another step is judged."""
    return [check.finding(evidence) for check in CHECKS if check.group == "motion"]
