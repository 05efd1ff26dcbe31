"""One fact about a motion, judged.

Leaves the rooms of `checks/`; read by run, report and the command line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from coursework.sentences import say

Verdict = Literal["PASS", "FAIL", "SKIP", "ERROR"]


@dataclass(frozen=True, slots=True)
class Check:
    """`code` is stable; `title` names it; `sentence` says what was found; `value` and `limit` in `unit` (None where skipped).

    SKIP: the scene gives nothing to judge; ERROR: the tool itself could not judge, never the student's fault.
    `rows` are further lines for a small table, (label, value, unit) each.
    """

    code: str
    title: str
    verdict: Verdict
    sentence: str
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    rows: tuple[tuple[str, float, str], ...] = ()


def judged(
    code: str, verdict: Verdict, sentence: str, value: float | None = None, limit: float | None = None, unit: str = "",
    rows: tuple[tuple[str, float, str], ...] = (),
) -> Check:  # fmt: skip
    """Return a check under the title that its code has in the words file."""
    return Check(code, say(f"check.{code}.title"), verdict, sentence, value, limit, unit, rows)
