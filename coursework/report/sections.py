"""The sections of the report, one function each; the function's name is the section's name.

Enters: a `PageContext`.  Leaves: parts, none where there is nothing to say.
To add one: write the function, put it into `OPENING` or `CLOSING` with the quantity that must be asked for,
give it a title in `reports/words.en.toml`; it appears in its place, in HTML and PDF alike.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from coursework.page_text import clean
from coursework.quantities import ACCURACY, CHECKS, GRAPH_CHECK, PLOTS, TABLE, Quantity
from coursework.report import lecture
from coursework.report.accuracy import accuracy
from coursework.report.checks import checks, counts
from coursework.report.derivation import constraints, derivation, drive
from coursework.report.figures import drawn, true_to_scale
from coursework.report.numbers import with_unit
from coursework.report.page_context import PageContext
from coursework.report.parts import (
    Bullets,
    Cell,
    Column,
    Display,
    Equations,
    Facts,
    Paragraph,
    Part,
    Runs,
    Section,
    Table,
)
from coursework.report.plots import plots
from coursework.report.tables import extra_parts, motion_parts, row_at
from coursework.report.text_runs import LONGEST_NAME, numeral, runs

STOP_DIGITS = 8  # a dead point is located to 1e-8 s
MOST_REMARKS = 12  # on the first page, on which the results begin

Writer = Callable[[PageContext], list[Part]]


def title(context: PageContext) -> list[Part]:
    """Whose work it is, what it is about, and how it came out."""
    run, say = context.run, context.words
    lines = [
        ("student", run.student),
        ("group", run.group),
        ("variant", run.variant.name),
        ("source", run.variant.source),
        ("teaches", run.variant.teaches),
        ("date", run.date),
    ]
    facts = [(say(f"title.{key}"), _plain(value)) for key, value in lines if value]
    result = [
        *(context.rich(run.summary) if run.summary else []),
        *runs(f" {_result(context)}" if run.summary else _result(context)),
        *runs("".join(f" {told}" for told in _lesson(context))),
    ]
    facts += [(say("title.method"), runs(method_line(context))), (say("title.result"), result)]
    plausibility = run.variant.plausibility
    told = [(remark.line, context.told(remark.sentence)) for remark in plausibility[:MOST_REMARKS]]
    notes = [say("remark.line", line=line, sentence=sentence) for line, sentence in told]
    if len(plausibility) > MOST_REMARKS:
        notes.append(say("remark.more", number=len(plausibility) - MOST_REMARKS))
    return [Facts(facts), *(Paragraph(runs(note), style="note") for note in notes)]


def method_line(context: PageContext) -> str:
    """Return scheme, step and end in one line."""
    run = context.run
    step, end = context.quantity(run.step, "s"), context.quantity(run.end, "s")
    return context.words("title.method_text", scheme=context.told(run.scheme_title), step=step, end=end)


def remarks(context: PageContext) -> list[Part]:
    """What the author of the variant has to say about it."""
    return [Paragraph(context.rich(text)) for text in context.run.variant.remarks]


def _plain(text: str) -> Runs:
    return [{"t": clean(text, LONGEST_NAME)}]


def _result(context: PageContext) -> str:
    run, say = context.run, context.words
    values = {
        "rows": say.count("count.rows", len(run.motion.t)),
        "checks": say("result.checks", counts=counts(context)) if run.asks(CHECKS) and run.checks else "",
    }
    if run.stop is None:
        return say("result.complete", end=context.quantity(float(run.motion.t[-1]), "s"), **values)
    time = context.quantity(run.stop.time, "s", STOP_DIGITS)
    return say("result.stopped", time=time, kind=context.event(run.stop.kind), **values)


def mechanism(context: PageContext) -> list[Part]:
    """The mechanism as it starts: what is spoken of on every later page."""
    found = context.run.mechanism()
    return [drawn(context, found)] if found is not None else []


def given(context: PageContext) -> list[Part]:
    """The data of the task sheet as written and in SI, the start, the times."""
    variant, say, numbers = context.run.variant, context.words, context.numbers
    rows: list[list[Cell]] = [
        [context.symbol_runs([g.name]), with_unit(_written(g.text), g.unit), numeral(with_unit(numbers.plain(g.value), g.si))]
        for g in variant.given
    ]
    for c in variant.coordinates:
        head = context.symbol_runs([c.name], say("given.at_start"))
        if c.start is None:
            rows.append([head, say("given.from_groups" if c.near is None else "given.follows"), _first(context, c.name, c.unit)])
        else:
            rows.append([head, with_unit(_written(c.text), c.written), context.quantity(c.start, c.unit)])
    columns = [Column(context.say(f"given.{key}"), words=key == "quantity") for key in ("quantity", "written", "si")]
    caption = context.say("given.data" if variant.given else "given.coordinates")
    time = variant.time
    sentences = [say("given.time", step=context.quantity(time.step, "s"), end=context.quantity(time.end, "s"))]
    if time.period is not None:
        sentences.append(say("given.period", period=context.quantity(time.period, "s")))
    if time.check_row is not None:
        when = context.quantity((time.check_row - 1) * time.step, "s")
        sentences.append(say("given.check_row", row=time.check_row, time=when))
    told: list[Part] = [Table(columns, rows, caption), Paragraph(runs(" ".join(sentences)))]
    if variant.set_values:
        pairs = [f"{name} = {_written(text)}" for name, text in variant.set_values.items()]
        told.append(Paragraph(context.lettered(say("given.set", listed=context.words.listing(pairs)))))
    return told


def _first(context: PageContext, name: str, unit: str) -> str:
    """Return a coordinate of the first row; a restricted table may not have it."""
    motion = context.run.motion
    known = name in motion.coordinate_names and len(motion.t) > 0
    return context.quantity(float(motion.column(name)[0]), unit) if known else context.words("none")


def _written(text: str) -> str:
    return clean(text, LONGEST_NAME).replace("-", "−")


def table(context: PageContext) -> list[Part]:
    """Every row of the motion, or enough of them to read."""
    return motion_parts(context)


def dead_point(context: PageContext) -> list[Part]:
    """When, where and why the motion stops, and what it means for the mechanism."""
    stop, say = context.run.stop, context.words
    if stop is None:
        return []
    time = context.quantity(stop.time, "s", STOP_DIGITS)
    facts = [(say("stop.row"), runs(row_at(context, stop.row)))]
    if stop.block:
        facts.append((say("stop.block"), context.symbol_runs(stop.block)))
    if stop.coordinates:
        facts.append((say("stop.configuration"), runs(_values(context, stop.coordinates))))
    facts += [(say("stop.branches"), runs(_values(context, branch))) for branch in stop.branches]
    facts += [
        (say(f"stop.{key}"), context.rich(text)) for key, text in (("cause", stop.cause), ("meaning", stop.meaning)) if text
    ]
    if context.run.phases:
        facts.append((say("stop.phases"), context.rich(context.run.phases)))
    kept = say("stop.kept", row=len(context.run.motion.t))
    kind = context.event(stop.kind)
    lead = say("stop.lead", kind=kind[:1].upper() + kind[1:], time=time)
    return [Paragraph(runs(kept), "callout", lead), Facts(facts)]


def _values(context: PageContext, values: Mapping[str, float]) -> str:
    unit_of = context.run.variant.unit_of
    return ", ".join(f"{context.symbol(name).text} = {context.quantity(value, unit_of(name))}" for name, value in values.items())


def graph_check(context: PageContext) -> list[Part]:
    """The drawing by which the table is checked, true to scale, and both results side by side."""
    graph, numbers = context.run.graph, context.numbers
    if graph is None:
        return []
    row = context.run.variant.time.check_row
    figure = true_to_scale(
        graph.drawn(context.words.written), context.words("graph.alt", row=row or ""), context.say("graph.caption")
    )
    heads = [
        Column(context.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "measured", "tabled", "difference")
    ]
    rows: list[list[Cell]] = [
        [context.rich(name), *(numeral(with_unit(numbers.scalar(value), unit)) for value in values)]
        for name, *values, unit in ((r[0], r[1], r[2], r[3], r[4]) for r in graph.rows)
    ]
    parts: list[Part] = [figure, *([Table(heads, rows)] if rows else [])]
    if graph.exact:
        errors: list[list[Cell]] = [
            [context.rich(name), *(numeral(with_unit(numbers.scalar(value), unit)) for value in (exact, gap))]
            for name, exact, gap, unit in graph.exact
        ]
        names = [Column(context.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "exact", "error")]
        parts.append(Table(names, errors))
    return [*parts, *([Bullets([context.rich(note) for note in graph.notes])] if graph.notes else [])]


def method(context: PageContext) -> list[Part]:
    """By which formula, with which step and which programs the numbers came about."""
    run, say = context.run, context.words
    coordinates = run.motion.coordinate_names
    rates = [c.rate for c in run.variant.coordinates if c.name in coordinates]
    if run.tableau is None:
        label = clean(context.words.written(run.motion.label)).rstrip(".")
        told = [say("method.rows_exact", step=context.quantity(run.step, "s"), label=label)]
        return [Paragraph(context.lettered(" ".join([*told, *_lesson(context)]))), *_versions(context)]
    intro = context.say("method.intro", title=context.told(run.scheme_title), order=run.tableau.order)
    formula = Equations([Display(math, text) for math, text in lecture.lines(run.tableau)])
    parts: list[Part] = [Paragraph(intro), formula]
    sentences = [
        say("method.meaning", coordinates=context.symbol_list(coordinates), rates=context.symbol_list(rates)),
        say("method.time", step=context.quantity(run.step, "s"), evaluations=context.numbers.whole(run.motion.evaluations)),
    ]
    if run.settings.project:
        sentences.append(say.count("method.project", run.settings.project))
    if run.settings.gain:
        product = context.numbers.plain(run.settings.gain * run.step)
        sentences.append(say("method.gain", gain=context.quantity(run.settings.gain, "1/s"), product=product))
    if context.exact is not None:
        label = context.words.written(context.exact.label) or say("plots.exact_label")
        sentences.append(say("method.exact", label=clean(label).rstrip(".")))
    parts.append(Paragraph(context.lettered(" ".join(sentences))))
    if run.motion.notes:
        parts.append(Bullets([context.rich(note) for note in run.motion.notes]))
    return [*parts, *_versions(context)]


def _lesson(context: PageContext) -> list[str]:
    """Return how far the coursework's scheme is from an exact table."""
    lesson = context.run.lesson
    return [] if lesson is None else [context.told(lesson.sentence)]


def _versions(context: PageContext) -> list[Part]:
    versions = ", ".join(f"{clean(name)} {clean(version)}" for name, version in context.run.versions.items())
    return [Paragraph(runs(context.words("method.versions", versions=versions)), "note")] if versions else []


# Each writer with the quantity that must be asked for; None: always there.
OPENING: tuple[tuple[Writer, Quantity[Any] | None], ...] = (
    (title, None),
    (mechanism, None),
    (remarks, None),
    (given, None),
    (drive, None),
    (constraints, None),
    (derivation, None),
    (table, TABLE),
    (plots, PLOTS),
    (dead_point, None),
    (checks, CHECKS),
    (graph_check, GRAPH_CHECK),
)
CLOSING: tuple[tuple[Writer, Quantity[Any] | None], ...] = (
    (accuracy, ACCURACY),
    (method, None),
)


def all_sections(context: PageContext) -> Iterator[Section]:
    """Yield the sections in order: the opening, a table or figure for each further quantity, the closing."""
    yield from _written_by(OPENING, context)
    for quantity, extra in context.run.extra_tables.items():
        yield Section(quantity, _heading(context, quantity, extra.title), extra_parts(context, extra))
    for quantity, drawings in context.run.figures(context.words.written).items():
        if drawings:
            yield Section(quantity, _heading(context, quantity, quantity), [drawn(context, drawing) for drawing in drawings])
    yield from _written_by(CLOSING, context)


def _heading(context: PageContext, quantity: str, named: str) -> str:
    key = f"section.{quantity}"
    return context.words(key) if context.words.has(key) else context.told(named, LONGEST_NAME)


def _written_by(writers: tuple[tuple[Writer, Quantity[Any] | None], ...], context: PageContext) -> Iterator[Section]:
    for write, quantity in writers:
        if quantity is not None and not context.run.asks(quantity):
            continue
        if parts := write(context):
            heading = context.words(f"section.{write.__name__}") if write is not title else ""
            yield Section(write.__name__, heading, parts)
