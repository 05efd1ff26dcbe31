"""What a check must have before it can judge, and the sentence where it has not.

Enters: `Evidence`.  Leaves: whether it is there.  Used by the records of `check.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from coursework.results.checks.evidence import Evidence


@dataclass(frozen=True, slots=True)
class Need:
    """`met` by the evidence, or the check is skipped with the sentence of the key `otherwise`."""

    met: Callable[[Evidence], bool]
    otherwise: str


ROW = Need(lambda evidence: len(evidence.motion.t) > 0, "check.no_row")
WHOLE = Need(lambda evidence: not evidence.restricted, "check.only_some")
EXACT = Need(lambda evidence: evidence.exact is not None and len(evidence.exact.t) > 0, "check.unknown")
CLOSURE = Need(lambda evidence: evidence.closure is not None, "check.DRIFT.skip")
