"""The section of checks: each with its verdict in a mark and a word, its number, its limit.

Enters: a `Desk`.  Leaves: one part with all checks.
"""

from __future__ import annotations

from coursework.checks.result import Check
from coursework.report.desk import Desk
from coursework.report.lettering import clean, numeral, runs
from coursework.report.numbers import unit_text, with_unit
from coursework.report.parts import Cell, Checks, Judged, Paragraph, Part, Runs
from coursework.report.tables import thinned

MOST_LINES = 30  # further lines of one check; more are thinned
SHORT_UNIT = 12  # letters of a unit that stands behind its number; a longer one stands below
ORDER = ("PASS", "FAIL", "SKIP", "ERROR")


def counts(desk: Desk) -> str:
    """Return "7 checks passed, one check failed"."""
    verdicts = [check.verdict for check in desk.run.checks]
    if set(verdicts) == {"PASS"}:
        return desk.words.count("count.all_passed", len(verdicts))
    kinds = [kind for kind in ORDER if kind in verdicts]
    return ", ".join(desk.words.count(f"count.{kind}", verdicts.count(kind)) for kind in kinds)


def checks(desk: Desk) -> list[Part]:
    """Every check that was made."""
    if not desk.run.checks:
        return []
    heads = [desk.words(f"checks.{key}") for key in ("verdict", "check", "value", "limit")]
    total = counts(desk)
    lead = Paragraph(runs(f"{total[:1].upper()}{total[1:]}."))
    return [lead, Checks(heads, [_judged(desk, check) for check in desk.run.checks])]


def _judged(desk: Desk, check: Check) -> Judged:
    numbers = desk.numbers
    unit = desk.told(check.unit)
    is_short = len(unit) <= SHORT_UNIT
    behind = unit if is_short else ""
    heads, lines = _lines(desk, check)
    return Judged(
        mark=desk.words(f"checks.mark.{check.verdict}"),
        verdict=desk.words(f"checks.word.{check.verdict}"),
        code=clean(check.code),
        title=desk.rich(check.title),
        sentence=desk.rich(check.sentence),
        value=numeral(with_unit(numbers.scalar(check.value), behind)),
        limit=numeral(with_unit(numbers.limit(check.limit), behind)),
        unit="" if is_short or check.value is None else unit_text(unit),
        heads=heads,
        lines=lines,
    )


def _lines(desk: Desk, check: Check) -> tuple[list[str], list[list[Cell]]]:
    """Return the further lines; labels "phi1: scheme", "phi1: period" … become a row with a column for each part."""
    parts = [desk.words.written(label).partition(": ") for label, _, _ in check.rows]
    columns = list(dict.fromkeys(tail for _, _, tail in parts))
    rows = list(dict.fromkeys(head for head, _, _ in parts))
    values = {(head, tail): numeral(desk.numbers.scalar(row[1])) for (head, _, tail), row in zip(parts, check.rows, strict=True)}
    units = {head: {row[2] for (own, _, _), row in zip(parts, check.rows, strict=True) if own == head} for head in rows}
    complete = len(columns) > 1 and all(columns) and len(values) == len(check.rows) == len(columns) * len(rows)
    if complete and all(len(found) == 1 for found in units.values()):
        table: list[list[Cell]] = []
        for head in rows:
            unit = unit_text(next(iter(units[head])))
            label = [*_label(desk, head), *([{"t": f", {unit}"}] if unit else [])]
            table.append([label, *(values[head, tail] for tail in columns)])
        return ["", *(clean(column) for column in columns)], table
    kept = [check.rows[index] for index in thinned(len(check.rows), most=MOST_LINES)]
    return [], [[_label(desk, row[0]), _amount(desk, row)] for row in kept]


def _label(desk: Desk, label: str) -> Runs:
    """Return the label of a line; a name of the table is set as its symbol."""
    known = label in desk.run.motion.names
    return desk.symbol_runs([label]) if known else desk.rich(label)


def _amount(desk: Desk, row: tuple[str, float, str]) -> Cell:
    return numeral(with_unit(desk.numbers.scalar(row[1]), row[2]))
