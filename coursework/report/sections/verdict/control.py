"""The control of the solution: one line per check, in plain words, with one number.

Enters: a `PageContext`.  Leaves: `Claims`, those that are not met first.
Used by `sections.py`; codes stand in the appendix (`checks.py`).
"""

from __future__ import annotations

from coursework.report.sections.verdict.checks import SHARES, amount, bound, counted, left_of_nought, rounded_off
from coursework.report.text.page_context import STOP_DIGITS, PageContext
from coursework.report.text.parts import Cell, Claims, Paragraph, Part
from coursework.report.text.text_runs import numeral
from coursework.results.checks.result import GROUPS, Finding
from coursework.words.sentence import Sentence

DIGITS = 3
ROWS = "unit.rows"  # a number of rows is shown whole: 24.02 as 24


def control(context: PageContext) -> list[Part]:
    """Return a line for every check that could be judged, after a note on where the details are."""
    judged = [finding for finding in context.run.checks if finding.verdict != "SKIP"]
    if not judged:
        return []
    heads = [context.words(f"checks.{key}") for key in ("verdict", "check", "value", "limit")]
    intro = "control.intro" if context.run.variant.motor is None else "control.intro_free"  # forces: other scales
    parts: list[Part] = [Paragraph(context.say(intro), style="note")]
    for group in GROUPS:
        chosen = sorted((one for one in judged if one.group == group), key=lambda one: one.verdict == "PASS")
        lines = [
            (
                context.words(f"checks.mark.{finding.verdict}"),
                context.words(f"checks.word.{finding.verdict}"),
                context.lettered(_claim(context, finding)),
                _number(context, finding),
                numeral(bound(context, finding)) if finding.limit is not None else "",
            )
            for finding in chosen
        ]
        if lines:
            met = sum(finding.verdict == "PASS" for finding in chosen)
            parts.append(Claims(context.words(f"checks.group.{group}"), heads, lines, len(lines) - met))
    return parts


def _claim(context: PageContext, finding: Finding) -> str:
    """Return the claim of a check: the words for the sentence that it found if there are any, else those for its verdict."""
    words, columns = context.words, context.run.variant.columns
    found = _first_sentence(finding.sentence)
    is_right = finding.verdict == "PASS"
    known = found.values if found else {}
    said = [found.key.removeprefix("check.")] if found else []
    said += [f"{finding.code}.same"] if is_right and finding.value == 0 else []
    verdict = f"{finding.code}.{'right' if is_right else 'wrong'}"
    said += [f"{finding.code}.{finding.verdict.lower()}", *([f"{verdict}_row"] if _is_inside(context, finding) else []), verdict]
    key = next((f"control.{name}" for name in said if words.has(f"control.{name}")), None)
    if key is None:
        return context.told(finding.title)
    values = {name: context.lettering(str(value)) if value in columns else value for name, value in known.items()}
    symbol = context.lettering(finding.column) if finding.column in columns else ""
    return words(key, **{**values, "symbol": symbol or words("control.column"), "row": finding.row or 1})


def _is_inside(context: PageContext, finding: Finding) -> bool:
    """Return whether a finding is about a row that is not the last of the table."""
    return finding.row is not None and finding.row < len(context.run.motion.t)


def _first_sentence(sentence: str) -> Sentence | None:
    """Return the first of the sentences that a finding consists of; None if it is plain text."""
    if not isinstance(sentence, Sentence):
        return None
    parts = sentence.values.get("parts")
    return _first_sentence(parts[0]) if isinstance(parts, tuple) and parts else sentence


def _number(context: PageContext, finding: Finding) -> Cell:
    """Return the one number of a line; a value that is only round-off is marked so."""
    numbers, value = context.numbers, finding.value
    if value is None:
        return ""
    if left_of_nought(finding) is not None:
        return numeral(rounded_off(context, value))
    value = counted(value, finding.unit)
    key = finding.unit.key if isinstance(finding.unit, Sentence) else ""
    if key in SHARES:
        return numeral(amount(context, value, finding.unit, limit=finding.limit))
    if finding.unit == "s":
        return context.quantity(value, "s", STOP_DIGITS)
    if key == ROWS:
        value = float(f"{value:.{DIGITS}g}")  # the word after the number has to fit the number shown
    is_count = key == ROWS or (value.is_integer() and abs(value) >= 1)
    shown = numbers.plain(value, DIGITS) if is_count else numbers.scalar(value, DIGITS)
    return numeral(context.with_unit(shown, context.unit_beside(value, finding.unit)))
