"""What a check must have before it can judge, and the sentence where it has not.

Enters: `Evidence`.  Leaves: whether it is there.  Used by the records of `check.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.motion.geometry.drive import resolution
from coursework.results.checks.close_to_motion.stiffness import stiff
from coursework.results.checks.computed_right.conditioning import condition
from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Finding, floored
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say


@frozen
class Need:
    """`met` by the evidence, or skipped with the sentence `otherwise`; `headline` then begins the summary."""

    met: Callable[[Evidence], bool]
    otherwise: Callable[[Evidence], Sentence]
    headline: Callable[[Evidence], str] = lambda evidence: ""

    def skipped(self, evidence: Evidence) -> Finding:
        """Return the finding of a check that lacks it."""
        return Finding("SKIP", self.otherwise(evidence), headline=self.headline(evidence))


def _open_integral(evidence: Evidence) -> Sentence:
    found = resolution(evidence.equations)
    return say("check.unresolved", time=found.place)


def _not_known(evidence: Evidence) -> Sentence:
    if evidence.stop is not None:
        return say("check.unknown")
    found = stiff(evidence)
    return say("check.out_of_reach") if found is None else joined([say("check.too_stiff"), found.sentence])


def _why_not_known(evidence: Evidence) -> Sentence | str:
    """Return what a summary begins with: a motion that ends early is told there anyhow."""
    if (found := stiff(evidence)) is not None:
        return found.sentence
    return _not_known(evidence) if evidence.stop is None else ""


def _too_few(evidence: Evidence) -> float | None:
    """Return the digits that the equations leave where the exact motion itself is not known to 5 % with them, else None."""
    if evidence.restricted:
        return None
    digits = condition(evidence).value
    exact, names = evidence.exact, evidence.names
    if digits is None or exact is None:
        return None
    way = [float(np.ptp(exact.column(name)) / evidence.scale[name]) for name in names if name in exact.coordinate_names]
    return digits if max(way, default=0.0) * 10.0**-digits > LIMIT else None


ROW = Need(lambda evidence: len(evidence.motion.t) > 0, lambda _: say("check.no_row"))
WHOLE = Need(lambda evidence: not evidence.restricted, lambda _: say("check.only_some"))
# A crank alone has its motion given.
SOLVED = Need(lambda evidence: bool(evidence.equations.equations), lambda _: say("check.CONDITION.nothing"))
EXACT = Need(
    lambda evidence: evidence.exact is not None and len(evidence.exact.t) > 0,
    lambda evidence: _not_known(evidence),
    _why_not_known,
)
CLOSURE = Need(lambda evidence: evidence.closure is not None, lambda _: say("check.DRIFT.skip"))
RESOLVED = Need(lambda evidence: resolution(evidence.equations).met, _open_integral, _open_integral)
DIGITS = Need(
    lambda evidence: _too_few(evidence) is None,
    lambda evidence: say("check.ACCURACY.few_digits", digits=floored(_too_few(evidence) or 0.0, 1)),
)
