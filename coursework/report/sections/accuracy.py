"""The section on accuracy: one sentence, error against cost in a figure and a table, conclusions, where the time goes.

Enters: a `PageContext` whose run carries an accuracy study.  Leaves: figures, tables, sentences.
Running times differ from run to run, so only in this section the bytes differ too (unless the study hides seconds).
Used by `sections.py`.
"""

from __future__ import annotations

import math

from coursework.report.graphs.accuracy_figures import SMALLEST, Chart, Method, chart
from coursework.report.graphs.figures import WIDTH
from coursework.report.text.numbers import NOTHING
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Bullets, Cell, Column, Figure, Paragraph, Part, Table
from coursework.report.text.tables import MARK, ONE_PAGE
from coursework.report.text.text_runs import LONGEST_NAME, begun, numeral, printed, runs
from coursework.results.accuracy.record import AccuracyStudy, StudyRow

RATIO_DIGITS = 2  # significant digits of a ratio of times, which differs from run to run
MOST_LINES = 12  # of the table; the figure shows every setting
ERROR_DIGITS = 3  # significant digits of an error


def accuracy(context: PageContext) -> list[Part]:
    """Return cost and error of each method, in a figure, a table and sentences."""
    study = context.run.study
    if study is None:
        return []
    first, *others = [context.rich(begun(context.told(sentence))) for sentence in study.sentences] or [[]]
    parts: list[Part] = [Paragraph(first)] if first else []
    if study.rows:
        parts += [error_figure(context, study), _table(context, study)]
    parts += [Bullets(others)] if others else []
    parts += [Paragraph(context.rich(sentence), "note") for sentence in study.left_out]
    parts += _failures(context, study)
    return [*parts, *_overhead(context, study)]


def _is_energy(study: AccuracyStudy) -> bool:
    """Return whether the errors are errors of energy, because forces move the mechanism."""
    return any(row.unit == "J" for row in study.rows)


def _unit(context: PageContext, study: AccuracyStudy) -> str:
    if _is_energy(study):
        return context.unit("J")
    units = dict.fromkeys(context.unit(c.unit) for c in context.run.variant.coordinates)
    return context.words.listing(list(units)) if len(units) < 2 else f" {context.words('or')} ".join(units)


def _finished(study: AccuracyStudy) -> list[StudyRow]:
    return [row for row in study.rows if not row.failed]


def _told(study: AccuracyStudy) -> list[StudyRow]:
    """Return the settings shown in the table: the cheapest of each method, and the finest of as many as fit `MOST_LINES`."""
    finished = _finished(study)
    first = {row.method: row for row in reversed(finished)}
    last = {row.method: row for row in finished}
    kept = [*first.values(), *(row for method, row in last.items() if row is not first[method])][:MOST_LINES]
    return [row for row in finished if any(row is one for one in kept)]


def error_figure(context: PageContext, study: AccuracyStudy) -> Figure:
    words = context.words
    finished = _finished(study)
    timed = study.seconds_shown and any(row.seconds is not None for row in finished)
    methods = []
    for name in dict.fromkeys(row.method for row in finished):
        rows = sorted((row for row in finished if row.method == name), key=lambda row: (row.evaluations, row.max_error))
        costs = [(row.seconds if timed else row.evaluations, max(abs(row.max_error), SMALLEST)) for row in rows]
        points = tuple((cost, error) for cost, error in costs if cost is not None and math.isfinite(error))
        methods.append(Method(context.told(name, LONGEST_NAME), points, study.orders.get(name)))
    labels = {key: words(f"accuracy.{key}") for key in ("seconds", "own_legend", "floor_legend")}
    of = "energy_" if _is_energy(study) else ""
    labels["evaluations"] = words("accuracy.slopes" if of else "accuracy.evaluations")
    own_cost = study.own and study.own[3 if timed else 1]
    own = (float(own_cost), max(abs(study.own[2]), SMALLEST)) if study.own and own_cost is not None else None
    label = words("accuracy.error", unit=_unit(context, study))
    page = Chart(tuple(methods), own, study.floor, label, labels, timed, words.listing)
    floor = context.with_unit(context.numbers.scalar(study.floor, 2), _unit(context, study))
    caption = words("accuracy.caption_timed" if timed else f"accuracy.{of}caption_one")
    reference = words("accuracy.reference", label=printed(context.told(study.reference_label)).rstrip(".。"))
    ring = words("accuracy.caption_own") if own else ""
    caption = words.sentences([caption, ring, words("accuracy.caption_rest", floor=floor), reference])
    alt = words("accuracy.alt", methods=words.listing([method.name for method in methods]))
    svg, height = chart(page)
    return Figure(svg, WIDTH, height, alt, context.lettered(caption))


def _table(context: PageContext, study: AccuracyStudy) -> Table:
    numbers = context.numbers
    keys = ["method", "steps", "evaluations", "max_error"] + (["time", "ratio"] if study.seconds_shown else [])
    units = {"max_error": _unit(context, study)}
    columns = [
        Column(context.say(f"accuracy.head.{key}"), units.get(key, ""), words=key == "method")
        for key in keys
    ]  # fmt: skip
    rows: list[list[Cell]] = []
    strong, rules = [], []
    before = ""
    for row in _told(study):
        if rows and row.method != before:
            rules.append(len(rows) - 1)
        before = row.method
        own = study.own is not None and (row.method, row.evaluations) == (study.own[0], study.own[1])
        if own:
            strong.append(len(rows))
        cells: list[Cell] = [
            f"{MARK} {context.told(row.method, LONGEST_NAME)}" if own else context.told(row.method, LONGEST_NAME),
            _steps(context, row.steps_or_tolerance),
            numbers.whole(row.evaluations),
            numeral(numbers.scalar(row.max_error, ERROR_DIGITS)),
        ]
        if study.seconds_shown:
            cells.append(NOTHING if row.seconds is None else numbers.duration(row.seconds))
            cells.append(NOTHING if row.time_ratio is None else numbers.plain(row.time_ratio, RATIO_DIGITS))
        rows.append(cells)
    notes = [context.words("accuracy.own_mark", mark=MARK)] if strong else []
    if study.orders:
        orders = context.words("join.numbers").join(
            context.words("accuracy.order", method=context.told(name, LONGEST_NAME), order=context.numbers.fixed(order, 2))
            for name, order in study.orders.items()
        )
        notes.append(context.words("accuracy.orders", orders=orders))
    return Table(
        columns,
        rows,
        context.say("accuracy.study"),
        strong,
        rules,
        runs(context.words.sentences(notes)),
        whole=len(rows) <= ONE_PAGE,
    )


def _steps(context: PageContext, text: str) -> Cell:
    """Return a number of steps in groups of three, or a tolerance."""
    return context.numbers.whole(int(text)) if text.isdigit() else numeral(printed(context.told(text, LONGEST_NAME)))


def _failures(context: PageContext, study: AccuracyStudy) -> list[Part]:
    told = context.told
    failed = [
        context.say("accuracy.failure", method=told(row.method), steps=told(row.steps_or_tolerance), why=told(row.failed))
        for row in study.rows
        if row.failed
    ]
    return [Paragraph(context.say("accuracy.failures")), Bullets(failed)] if failed else []


def _overhead(context: PageContext, study: AccuracyStudy) -> list[Part]:
    words = context.words
    if not study.overhead or not study.seconds_shown:
        return []
    told = [f"{context.told(label, LONGEST_NAME)} {context.numbers.duration(seconds)}" for label, seconds in study.overhead]
    where = [words("accuracy.machine", **study.machine)] if study.machine else []
    return [Paragraph(runs(words.sentences([words("accuracy.overhead", parts=words.listing(told)), *where])), "note")]
