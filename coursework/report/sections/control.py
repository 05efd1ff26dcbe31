"""The control of the solution: one line a check, in plain words, with one number.

Enters: a `PageContext`.  Leaves: `Claims`.  Used by `sections.py`; codes and limits stand in the appendix (`checks.py`).
"""

from __future__ import annotations

from coursework.report.sections.checks import counted
from coursework.report.text.numbers import ROUND_OFF
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Claims, Paragraph, Part
from coursework.report.text.text_runs import numeral
from coursework.results.checks.result import OF_POWER, Finding
from coursework.words.sentence import Sentence

DIGITS = 3
ROWS = "unit.rows"  # 24.02 of them are 24 rows
SHARES = {"unit.of_the_scale", "unit.of_the_shortest", "unit.relative"}  # parts of a whole are told in percent


def control(context: PageContext) -> list[Part]:
    """Return a line for every check that could be judged, and where the details stand."""
    judged = [finding for finding in context.run.checks if finding.verdict != "SKIP"]
    if not judged:
        return []
    lines = [
        (
            context.words(f"checks.mark.{finding.verdict}"),
            context.words(f"checks.word.{finding.verdict}"),
            context.lettered(_claim(context, finding)),
            _number(context, finding),
        )
        for finding in judged
    ]
    return [Paragraph(context.say("control.intro"), style="note"), Claims(lines)]


def _claim(context: PageContext, finding: Finding) -> str:
    words = context.words
    key = f"control.{finding.code}.{'right' if finding.verdict == 'PASS' else 'wrong'}"
    if finding.verdict == "PASS" and finding.value == 0 and words.has(same := f"control.{finding.code}.same"):
        key = same
    if not words.has(key):
        return context.told(finding.title)
    symbol = context.lettering(finding.column) if finding.column in context.run.variant.columns else ""
    return words(key, symbol=symbol or words("control.column"), row=finding.row or 1)


def _number(context: PageContext, finding: Finding) -> Cell:
    """Return the one number of a line; what is round-off of nought is 0."""
    numbers, value = context.numbers, finding.value
    if value is None:
        return ""
    value = counted(value, finding.unit) if abs(value) > ROUND_OFF else 0.0
    key = finding.unit.key if isinstance(finding.unit, Sentence) else ""
    if key == "unit.equations" and finding.limit is not None and value < finding.limit:
        return context.words("control.of", part=numbers.whole(int(value)), whole=numbers.whole(int(finding.limit)))
    if key == OF_POWER:
        return context.with_unit(numbers.plain(100 * value), "%")
    if key in SHARES:
        return context.with_unit(numbers.scalar(100 * value, DIGITS), "%")
    if key == ROWS:
        value = float(f"{value:.{DIGITS}g}")  # the word behind the number is that of the number shown
    is_count = key == ROWS or (value.is_integer() and abs(value) >= 1)
    shown = numbers.plain(value, DIGITS) if is_count else numbers.scalar(value, DIGITS)
    return numeral(context.with_unit(shown, context.unit_beside(value, finding.unit)))
