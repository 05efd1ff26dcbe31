"""One finding about a motion (the verdict of a check and its reasons), and the record of a check.

Enters: numbers and sentences from the rooms of `checks/`.  Leaves: `Finding`, `Check`, `Need`.
Used by `check.py`, effects, scene, output, report and the command line.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Literal

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say

Group = Literal["computation", "motion"]
GROUPS: tuple[Group, ...] = ("computation", "motion")
Verdict = Literal["PASS", "COARSE", "FAIL", "SKIP", "ERROR"]
# Units of amounts that are rounded down when shown (a share of the power, digits left of sixteen), and their decimals.
OF_THE_SCALE = "unit.of_the_scale"
OF_POWER, DIGITS_LEFT = "unit.of_power", "unit.digits"
_DECIMALS = {OF_POWER: 3, DIGITS_LEFT: 1}
# From `_MANY` percent on a share is shown without decimals, from `_MOST` on as "more than": nobody compares such numbers.
_MANY, _MOST = 1000.0, 1e4
_FINEST = 6  # most digits that tell an amount from its limit
# The order in which verdicts are counted and shown.
VERDICTS: tuple[Verdict, ...] = ("PASS", "COARSE", "FAIL", "SKIP", "ERROR")


@frozen
class Finding:
    """The `verdict` and `sentence` of one check; `value` and `limit` in `unit`, None if there is no number.

    PASS: the claim holds; COARSE: computed right, but this step, or these digits, are too coarse for the claim; FAIL: wrong;
    SKIP: nothing to judge; ERROR: the tool itself could not judge, never the student's fault.
    `column` and `row` (from 1) are where the largest number stands; `first` and `last` the values that a period check compares
    (SI).  `step` (s) is a step with which every claim about the motion holds, `option` the command-line option for it, `scheme` a
    scheme that is accurate enough at the same step, `advised` the sentence about both.  `rows` are further lines (label, value,
    unit).  `cured`: whether a finer step can turn COARSE into PASS.  `headline`: with what the summary begins; `unjudged`: what
    the summary adds to "computed right"; `is_news`: whether a reader should hear why a check was skipped.  `code`, `group` and
    `is_least` (whether the limit is a minimum) are those of the check.
    """

    verdict: Verdict
    sentence: str
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    column: str | None = None
    row: int | None = None
    first: float | None = None
    last: float | None = None
    step: float | None = None
    rows: tuple[tuple[str, float, str], ...] = ()
    cured: bool = True
    option: str = ""
    scheme: str = ""
    advised: str = ""
    headline: str = ""
    unjudged: str = ""
    is_news: bool = False
    code: str = ""
    group: Group = "computation"
    is_least: bool = False

    @property
    def says_more(self) -> bool:
        """Return whether the sentence says more than mark and summary do; a skipped START is reported in the summary."""
        unsure = bool(self.unjudged) and self.code != "START"
        return self.code != "STOP" and (unsure or self.is_news or self.verdict in {"COARSE", "FAIL", "ERROR"})

    @property
    def title(self) -> str:
        """Return the title of the check in the words file, or its code if there is none."""
        key = f"check.{self.code}.title"
        return say(key) if load_phrases().has(key) else self.code


def skipped(sentence: str) -> Finding:
    """Return the finding of a check that has nothing to judge; the sentence says what therefore remains unknown."""
    return Finding("SKIP", sentence)


@frozen
class Need:
    """A condition on the evidence: if it is not `met`, the check is skipped with the sentence `otherwise`.

    `headline` is what the summary then begins with.
    """

    met: Callable[..., bool]
    otherwise: Callable[..., Sentence]
    headline: Callable[..., str] = lambda *_: ""

    def skipped(self, *evidence: Any) -> Finding:
        """Return the finding of a check whose condition is not met."""
        return Finding("SKIP", self.otherwise(*evidence), headline=self.headline(*evidence))


@frozen
class Check:
    """One check with a stable `code`: if all `needs` are met, `judge` gives the finding; else the check is skipped.

    `group`: "computation" asks whether what was written was computed right, "motion" whether it is close to the mechanism's
    motion.  `is_least`: its limit is a minimum, not a maximum.
    """

    code: str
    group: Group
    judge: Callable[..., Finding]
    needs: tuple[Need, ...] = ()
    is_least: bool = False

    def finding(self, *evidence: Any) -> Finding:
        """Return the finding.  A fault inside the check is an ERROR of the tool, never of the student, and other checks go on."""
        lacking = next((need for need in self.needs if not need.met(*evidence)), None)
        try:
            found = self.judge(*evidence) if lacking is None else lacking.skipped(*evidence)
        except Exception as error:
            found = Finding("ERROR", say("check.error", kind=type(error).__name__, error=str(error)))
        return replace(found, code=self.code, group=self.group, is_least=self.is_least)


def floored(share: float, decimals: int = 4) -> float:
    """Return a share rounded down to `decimals` decimals: 0.99987 -> 0.9998."""
    scale = 10.0**decimals
    return math.floor(share * scale) / scale


def never_more(value: float, unit: str, decimals: int = 4) -> float:
    """Return an amount, rounded down if it is a share of the power or digits left; any other amount unchanged."""
    own = _DECIMALS.get(unit.key) if isinstance(unit, Sentence) else None
    return value if own is None else floored(value, min(own, decimals))


def beside(unit: str, value: float) -> str:
    """Return a unit in the form that goes with a printed number: "1 row", "24 rows"."""
    if isinstance(unit, Sentence) and "number" in unit.values:
        return say(unit.key, **{**unit.values, "number": int(value) if float(value).is_integer() else value})
    return unit


def digits_apart(value: float, limit: float | None, digits: int, form: str = "f") -> int:
    """Return with how many digits a value is printed: more where it would read like a limit that it is not.

    >>> digits_apart(5.004, 5.0, 1), digits_apart(5.06, 5.0, 1), digits_apart(5.0, 5.0, 1)
    (3, 1, 1)
    """
    while limit not in (None, value) and digits < _FINEST and f"{value:.{digits}{form}}" == f"{limit:.{digits}{form}}":
        digits += 1
    return digits


def percent(share: float, limit: float | None = None) -> Sentence:
    """Return a share in percent: with one decimal, small ones with two digits, large ones with no decimals.

    One that is judged by a `limit` never reads like it on its other side.
    """
    value = 100 * share
    if limit is not None and (decimals := digits_apart(value, 100 * limit, 1)) > 1:
        return say("amount.share_near", value=round(value, decimals))
    if value >= _MOST:
        return say("amount.share_beyond", value=_MOST)
    if value >= _MANY:
        return say("amount.share_many", value=value)
    if 0 < value < 1e-4:
        return say("amount.share_below", value=1e-4)
    return say("amount.share" if value >= 0.05 else "amount.share_two", value=value)
