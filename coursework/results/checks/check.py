"""Every kind of check as one record, in the order of the page.

Enters: `Evidence` about any motion.  Leaves: a `Finding` of each kind.  Used by `motion_results.py`; page, run.json and command
line show whatever is found.  To add one: write its judging function, put a `Check` here, and its words under
[check.CODE] in the words file: `title` and the sentences.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from coursework.results.checks import advice
from coursework.results.checks.close_to_motion import closeness, continuity, drift, long_run, period, rows, sinusoid
from coursework.results.checks.computed_right import beginning, conditioning, digits, equations, quotes
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.needs import CLOSURE, DIGITS, EXACT, RESOLVED, ROW, SOLVED, WHOLE, Need
from coursework.results.checks.result import Finding, Group, judged
from coursework.system.frozen import frozen


@frozen
class Check:
    """`code` is stable; `needs` are met, or the first that is not says what is skipped; `judge` then finds a verdict.

    `is_least`: its limit is the least that passes, not the most.
    """

    code: str
    group: Group
    judge: Callable[[Evidence], Finding]
    needs: tuple[Need, ...] = (ROW,)
    is_least: bool = False


CHECKS: tuple[Check, ...] = (
    Check("STOP", "computation", beginning.stopped, ()),
    Check("START", "computation", beginning.start),
    Check("INITIAL", "computation", equations.initial, (ROW, WHOLE, SOLVED)),
    Check("RESIDUAL", "computation", equations.every_row, (ROW, WHOLE, SOLVED)),
    Check("CONDITION", "computation", conditioning.condition, (ROW, WHOLE), is_least=True),
    Check("AGREEMENT", "computation", equations.agreement, (), is_least=True),
    Check("QUOTE", "computation", quotes.quote),
    Check("TABLE-DIGITS", "computation", digits.table_digits),
    Check("ACCURACY", "motion", closeness.accuracy, (ROW, RESOLVED, EXACT, DIGITS)),
    Check("PERIOD-POSITION", "motion", period.position, (ROW, RESOLVED, EXACT, DIGITS)),
    Check("PERIOD-VELOCITY", "motion", period.velocity, (ROW, RESOLVED, EXACT, DIGITS)),
    Check("PERIOD-ASSEMBLY", "motion", period.assembly, (ROW, RESOLVED, SOLVED)),
    Check("CONTINUITY", "motion", continuity.continuity, (ROW, RESOLVED, EXACT, DIGITS)),
    Check("SINUSOID", "motion", sinusoid.sinusoid, (ROW, RESOLVED, EXACT), is_least=True),
    Check("STEP", "motion", rows.enough, is_least=True),
    Check("PEAK", "motion", conditioning.peak, (ROW, RESOLVED, SOLVED)),
    Check("DRIFT", "motion", drift.drift, (ROW, RESOLVED, CLOSURE, WHOLE)),
    Check("DRIFT-PER-PERIOD", "motion", long_run.per_period, (ROW, RESOLVED, EXACT)),
)


def check_motion(evidence: Evidence) -> tuple[Finding, ...]:
    """Return what every check finds, with the step advised where a finer one would do."""
    found = [_judged(check, evidence) for check in CHECKS]
    return tuple(advice.with_advice(evidence, found, motion_findings))


def motion_findings(evidence: Evidence) -> Sequence[Finding]:
    """Return the findings about closeness alone: what a run with another step is judged by."""
    return [_judged(check, evidence) for check in CHECKS if check.group == "motion"]


def _judged(check: Check, evidence: Evidence) -> Finding:
    lacking = next((need for need in check.needs if not need.met(evidence)), None)
    judge = check.judge if lacking is None else lacking.skipped
    return judged(judge, evidence, code=check.code, group=check.group, is_least=check.is_least)
