"""The section of checks: each with a mark and a word for its verdict, its value and its limit.

Enters: a `PageContext`.  Leaves: the summary, and one part for each group of checks.  Used by `sections.py` and `control.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.report.text.numbers import NOTHING, ROUND_OFF, TIGHT
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Checks, Judged, Paragraph, Part, Runs
from coursework.report.text.tables import thinned
from coursework.report.text.text_runs import begun, numeral
from coursework.results.checks.evidence import NO_ERROR
from coursework.results.checks.result import (
    DIGITS_LEFT,
    GROUPS,
    OF_POWER,
    OF_THE_SCALE,
    VERDICTS,
    Finding,
    digits_apart,
    never_more,
)
from coursework.words.sentence import Sentence
from coursework.words.sentences import ENGLISH, joined
from coursework.words.templates import clean

NOTHING_AT_ALL = 1e-18  # SI: smaller than any round-off of a mechanism
BESIDE_A_LIMIT = 1e-9  # parts of its limit: a smaller value that passes is round-off of lengths that close
NEARLY_WHOLE = 5e-5  # parts of an amount: a smaller difference from a whole number does not show in four digits
SHARES = {OF_THE_SCALE, OF_POWER, "unit.of_the_shortest", "unit.relative"}  # units of shares, shown in per cent
LEAST_SHARE = 5e-4  # a smaller limit, and a smaller share beside it, are shown as powers of ten
MOST_LINES = 30  # further lines of one check; more are thinned
SHORT_UNIT = 12  # characters of a unit that stands after its number; a longer one stands below


def counts(context: PageContext) -> str:
    """Return "7 checks passed, one check failed"."""
    verdicts = [check.verdict for check in context.run.checks]
    if set(verdicts) == {"PASS"}:
        return context.words.count("count.all_passed", len(verdicts))
    kinds = [kind for kind in VERDICTS if kind in verdicts]
    return context.words("join.comma").join(context.words.count(f"count.{kind}", verdicts.count(kind)) for kind in kinds)


def checks(context: PageContext) -> list[Part]:
    """Return every check that was made, checks of the computation before checks of the motion."""
    findings = context.run.checks
    if not findings:
        return []
    heads = [context.words(f"checks.{key}") for key in ("verdict", "check", "value", "limit")]
    parts: list[Part] = [Paragraph(context.say("checks.counted", counts=begun(counts(context))))]
    for group in GROUPS:
        if chosen := [_judged(context, finding) for finding in findings if finding.group == group]:
            parts.append(Checks(context.words(f"checks.group.{group}"), heads, chosen))
    return parts


def _judged(context: PageContext, check: Finding) -> Judged:
    unit = context.told(check.unit)
    is_short = len(unit) <= SHORT_UNIT
    value = check.value if check.value is None else counted(check.value, check.unit)
    is_left = isinstance(check.unit, Sentence) and check.unit.key == DIGITS_LEFT  # 15.4 of 16 digits, never 15.40
    is_count = value is not None and value >= 1 and (value.is_integer() or is_left)
    left = left_of_nought(check)
    value = value if left is None else 0.0
    told = amount(context, value, check.unit, whole=is_count, limit=check.limit) if left is None else rounded_off(context, left)
    heads, lines = _lines(context, check)
    if check.verdict == "PASS" and value == 0:
        heads, lines = [], []  # if nothing deviates, lines of zeros add nothing
    return Judged(
        mark=context.words(f"checks.mark.{check.verdict}"),
        verdict=context.words(f"checks.word.{check.verdict}"),
        code=clean(check.code) if context.words.phrases.language == ENGLISH else "",  # codes are English words
        title=context.rich(check.title),
        sentence=context.rich(parted(check.sentence)[0]),
        value=numeral(told),
        limit=numeral(bound(context, check)),
        unit="" if is_short or check.value is None else context.unit(unit),
        heads=heads,
        lines=lines,
    )


def left_of_nought(check: Finding) -> float | None:
    """Return the value of a check that passes with only round-off in place of zero, else None."""
    passes = check.verdict == "PASS" and not check.is_least
    is_share = isinstance(check.unit, Sentence) and check.unit.key in SHARES
    nought = ROUND_OFF if is_share else BESIDE_A_LIMIT * (check.limit or 0.0)
    return check.value if check.value and passes and abs(check.value) < nought else None


def parted(sentence: str) -> tuple[str, str]:
    """Split the sentence of a check into its finding and its advice, which a page gives only once; "" if there is no advice."""
    parts = sentence.values.get("parts") if isinstance(sentence, Sentence) else None
    if not isinstance(parts, tuple):
        return sentence, ""
    advice = [part for part in parts if _advises(part)]
    found = [parted(part)[0] for part in parts if part not in advice]
    return (joined(found), joined(advice)) if advice else (sentence, "")


def _advises(sentence: object) -> bool:
    if not isinstance(sentence, Sentence):
        return False
    parts = sentence.values.get("parts")
    return sentence.key == "advice.take" or (isinstance(parts, tuple) and len(parts) > 0 and _advises(parts[0]))


def amount(context: PageContext, value: float | None, unit: str, *, whole: bool = False, limit: float | None = None) -> str:
    """Return a value with its unit: a share in per cent with one decimal, a tiny one with one digit, or as a power
    of ten where no limit in per cent stands beside it.

    `whole`: the value is a count, without trailing zeros.
    """
    if value is not None and isinstance(unit, Sentence) and unit.key in SHARES:
        if abs(value) < LEAST_SHARE:
            is_power = limit < LEAST_SHARE if limit is not None else value != 0
            return context.numbers.scalar(value) if is_power else context.with_unit(context.numbers.scalar(100 * value, 1), "%")
        decimals = digits_apart(100 * value, None if limit is None else 100 * limit, 1)
        return context.with_unit(context.numbers.fixed(100 * value, decimals), "%")
    if value is None:
        return NOTHING
    shown = context.numbers.limit(value) if whole else context.numbers.scalar(value)
    return context.with_unit(shown, context.unit_beside(value, unit) if len(context.told(unit)) <= SHORT_UNIT else "")


def rounded_off(context: PageContext, value: float) -> str:
    """Return the words for round-off in place of zero: "2·10⁻¹⁶ (round-off)"."""
    return context.words("control.round_off", value=context.numbers.power(value, 1))


def bound(context: PageContext, check: Finding) -> str:
    """Return the limit of a check as it is shown: "≤ 5 %"."""
    value, unit = check.limit, check.unit
    if value is None:
        return NOTHING
    is_share = isinstance(unit, Sentence) and unit.key in SHARES and value >= LEAST_SHARE
    is_tiny = isinstance(unit, Sentence) and unit.key in SHARES
    is_noun = isinstance(unit, Sentence) and unit.key == DIGITS_LEFT  # a bare number of digits says nothing
    behind = "" if is_tiny or (len(context.told(unit)) > SHORT_UNIT and not is_noun) else context.unit_beside(value, unit)
    if is_share:
        shown = context.with_unit(context.numbers.plain(100 * value), "%")
    else:
        shown = context.with_unit(context.numbers.limit(value), behind)
    return f"{'≥' if check.is_least else '≤'}{TIGHT}{shown}"


def _lines(context: PageContext, check: Finding) -> tuple[list[str], list[list[Cell]]]:
    """Return heads and further lines of a check; lines on several parts of a name become one row with a column per part."""
    parts = [_line(context, label) for label, _, _ in check.rows]
    columns = list(dict.fromkeys(tail for _, tail in parts))
    rows = list(dict.fromkeys(head for head, _ in parts))
    least = NO_ERROR if check.verdict == "PASS" and check.value == 0 else NOTHING_AT_ALL
    noise = max(ROUND_OFF * max((abs(row[1]) for row in check.rows), default=0.0), least)
    motion = context.run.motion
    sizes = {head: float(np.max(np.abs(motion.column(head)))) for head in rows if head in motion.names}
    values: dict[tuple[str, str], Cell] = {}
    for pair, row in zip(parts, check.rows, strict=True):
        values[pair] = numeral(context.numbers.scalar(_seen(row, max(noise, ROUND_OFF * sizes.get(pair[0], 0.0)))))
    units = {head: {row[2] for (own, _), row in zip(parts, check.rows, strict=True) if own == head} for head in rows}
    complete = len(columns) > 1 and all(columns) and len(values) == len(check.rows) == len(columns) * len(rows)
    if complete and all(len(found) == 1 for found in units.values()):
        table: list[list[Cell]] = []
        for head in rows:
            unit = context.unit(context.told(next(iter(units[head]))))
            label = [*_label(context, head), *([{"t": context.words.behind(unit)}] if unit else [])]
            table.append([label, *(values[head, tail] for tail in columns)])
        return ["", *(clean(column) for column in columns)], table
    kept = [check.rows[index] for index in thinned(len(check.rows), most=MOST_LINES)]
    return [], [[_label(context, row[0]), _amount(context, row, noise)] for row in kept]


def counted(value: float, unit: str) -> float:
    """Return an amount as it is shown: see `never_more`; a share that is only round-off is 0.

    An amount whose unit is a word is whole if it is so in the digits shown: 24 rows, not 23.9999.
    """
    if not isinstance(unit, Sentence):
        return value
    if unit.key in SHARES and abs(value) < ROUND_OFF:
        return 0.0
    least = never_more(value, unit)
    return float(round(value)) if least == value and abs(value - round(value)) < NEARLY_WHOLE * abs(value) else least


def _seen(row: tuple[str, float, str], noise: float) -> float:
    """Return the amount of a line, or 0 if it is below `noise`, unless the line is about round-off."""
    label, amount, _ = row
    part = label.values.get("part") if isinstance(label, Sentence) else None
    tells = isinstance(part, Sentence) and part.key.endswith(".roundoff")
    return 0.0 if abs(amount) < noise and not tells else amount


def _line(context: PageContext, label: str) -> tuple[str, str]:
    """Return the name that a line is about and the part of it that it gives, "" if it gives all."""
    if isinstance(label, Sentence) and label.key == "check.line":
        name, part = label.values["name"], label.values["part"]
        return str(name), context.words.written(part if isinstance(part, str) else str(part))
    return context.words.written(label), ""


def _label(context: PageContext, label: str) -> Runs:
    """Return the label of a line; the name of a column becomes its symbol."""
    known = label in context.run.motion.names
    return context.symbol_runs([label]) if known else context.rich(label)


def _amount(context: PageContext, row: tuple[str, float, str], noise: float) -> Cell:
    value = counted(_seen(row, noise), row[2])
    if isinstance(row[2], Sentence) and row[2].key in SHARES:
        return numeral(amount(context, value, row[2]))
    return numeral(context.with_unit(context.numbers.scalar(value), context.told(row[2])))
