"""The sections of the report, one function each; the function's name is the section's name.

Enters: a `Desk`.  Leaves: parts, none where there is nothing to say.
To add one: write the function, put it into `OPENING` or `CLOSING` with the quantity that must be asked for ("" = always),
give it a title in `reports/words.en.toml`; it appears in its place, in HTML and PDF alike.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from coursework.report.accuracy import accuracy
from coursework.report.checks import checks, counts
from coursework.report.derivation import constraints, derivation, drive
from coursework.report.desk import Desk
from coursework.report.figures import true_to_scale
from coursework.report.lecture import LINES
from coursework.report.lettering import LONGEST_NAME, clean, numeral, runs
from coursework.report.numbers import with_unit
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

STOP_DIGITS = 8  # a dead point is located to 1e-8 s

Writer = Callable[[Desk], list[Part]]


def title(desk: Desk) -> list[Part]:
    """Whose work it is, what it is about, and how it came out."""
    run, say = desk.run, desk.words
    method = say(
        "title.method_text",
        scheme=desk.told(run.scheme_title),
        step=desk.quantity(run.step, "s"),
        end=desk.quantity(run.end, "s"),
    )
    lines = [
        ("student", run.student),
        ("group", run.group),
        ("variant", run.variant.name),
        ("source", run.variant.source),
        ("teaches", run.variant.teaches),
        ("date", run.date),
    ]
    facts = [(say(f"title.{key}"), _plain(value)) for key, value in lines if value]
    facts += [(say("title.method"), runs(method)), (say("title.result"), runs(_result(desk)))]
    return [Facts(facts)]


def remarks(desk: Desk) -> list[Part]:
    """What the author of the variant has to say about it."""
    return [Paragraph(desk.rich(text)) for text in desk.run.variant.remarks]


def _plain(text: str) -> Runs:
    return [{"t": clean(text, LONGEST_NAME)}]


def _result(desk: Desk) -> str:
    run, say = desk.run, desk.words
    values = {
        "rows": say.count("count.rows", len(run.motion.t)),
        "checks": say("result.checks", counts=counts(desk)) if "checks" in run.asked and run.checks else "",
    }
    if run.stop is None:
        return say("result.complete", end=desk.quantity(float(run.motion.t[-1]), "s"), **values)
    time = desk.quantity(run.stop.time, "s", STOP_DIGITS)
    return say("result.stopped", time=time, kind=desk.event(run.stop.kind), **values)


def given(desk: Desk) -> list[Part]:
    """The data of the task sheet as written and in SI, the start, the times."""
    variant, say, numbers = desk.run.variant, desk.words, desk.numbers
    rows: list[list[Cell]] = [
        [desk.symbol_runs([g.name]), with_unit(_written(g.text), g.unit), numeral(with_unit(numbers.plain(g.value), g.si))]
        for g in variant.given
    ]
    for c in variant.coordinates:
        head = desk.symbol_runs([c.name], say("given.at_start"))
        if c.start is None:
            rows.append([head, say("given.from_groups"), _first(desk, c.name, c.unit)])
        else:
            rows.append([head, with_unit(_written(c.text), c.written), desk.quantity(c.start, c.unit)])
    columns = [Column(desk.say(f"given.{key}"), words=key == "quantity") for key in ("quantity", "written", "si")]
    caption = desk.say("given.data" if variant.given else "given.coordinates")
    time = variant.time
    sentences = [say("given.time", step=desk.quantity(time.step, "s"), end=desk.quantity(time.end, "s"))]
    if time.period is not None:
        sentences.append(say("given.period", period=desk.quantity(time.period, "s")))
    if time.check_row is not None:
        when = desk.quantity((time.check_row - 1) * time.step, "s")
        sentences.append(say("given.check_row", row=time.check_row, time=when))
    return [Table(columns, rows, caption), Paragraph(runs(" ".join(sentences)))]


def _first(desk: Desk, name: str, unit: str) -> str:
    """Return a coordinate of the first row; a restricted table may not have it."""
    motion = desk.run.motion
    known = name in motion.coordinate_names and len(motion.t) > 0
    return desk.quantity(float(motion.column(name)[0]), unit) if known else desk.words("none")


def _written(text: str) -> str:
    return clean(text, LONGEST_NAME).replace("-", "−")


def table(desk: Desk) -> list[Part]:
    """Every row of the motion, or enough of them to read."""
    return motion_parts(desk)


def dead_point(desk: Desk) -> list[Part]:
    """When, where and why the motion stops, and what it means for the mechanism."""
    stop, say = desk.run.stop, desk.words
    if stop is None:
        return []
    time = desk.quantity(stop.time, "s", STOP_DIGITS)
    facts = [(say("stop.row"), runs(row_at(desk, stop.row)))]
    if stop.block:
        facts.append((say("stop.block"), desk.symbol_runs(stop.block)))
    if stop.coordinates:
        facts.append((say("stop.configuration"), runs(_values(desk, stop.coordinates))))
    facts += [(say("stop.branches"), runs(_values(desk, branch))) for branch in stop.branches]
    facts += [(say(f"stop.{key}"), desk.rich(text)) for key, text in (("cause", stop.cause), ("meaning", stop.meaning)) if text]
    if desk.run.phases:
        facts.append((say("stop.phases"), desk.rich(desk.run.phases)))
    kept = say("stop.kept", row=len(desk.run.motion.t))
    kind = desk.event(stop.kind)
    lead = say("stop.lead", kind=kind[:1].upper() + kind[1:], time=time)
    return [Paragraph(runs(kept), "callout", lead), Facts(facts)]


def _values(desk: Desk, values: Mapping[str, float]) -> str:
    unit_of = desk.run.variant.unit_of
    return ", ".join(f"{desk.symbol(name).text} = {desk.quantity(value, unit_of(name))}" for name, value in values.items())


def graph_check(desk: Desk) -> list[Part]:
    """The drawing by which the table is checked, true to scale, and both results side by side."""
    graph, numbers = desk.run.graph, desk.numbers
    if graph is None:
        return []
    row = desk.run.variant.time.check_row
    figure = true_to_scale(graph.drawn(desk.words.written), desk.words("graph.alt", row=row or ""), desk.say("graph.caption"))
    heads = [
        Column(desk.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "measured", "tabled", "difference")
    ]
    rows: list[list[Cell]] = [
        [desk.rich(name), *(numeral(with_unit(numbers.scalar(value), unit)) for value in values)]
        for name, *values, unit in ((r[0], r[1], r[2], r[3], r[4]) for r in graph.rows)
    ]
    parts: list[Part] = [figure, *([Table(heads, rows)] if rows else [])]
    if graph.exact:
        errors: list[list[Cell]] = [
            [desk.rich(name), *(numeral(with_unit(numbers.scalar(value), unit)) for value in (exact, gap))]
            for name, exact, gap, unit in graph.exact
        ]
        names = [Column(desk.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "exact", "error")]
        parts.append(Table(names, errors))
    return [*parts, *([Bullets([desk.rich(note) for note in graph.notes])] if graph.notes else [])]


def method(desk: Desk) -> list[Part]:
    """By which formula, with which step and which programs the numbers came about."""
    run, say = desk.run, desk.words
    coordinates = run.motion.coordinate_names
    rates = [c.rate for c in run.variant.coordinates if c.name in coordinates]
    lines = LINES.get(run.scheme, ())
    intro = desk.say("method.intro" if lines else "method.plain", title=desk.told(run.scheme_title), order=run.scheme_order)
    parts: list[Part] = [Paragraph(intro)]
    if lines:
        parts.append(Equations([Display(math, text) for math, text in lines]))
    sentences = [
        say("method.meaning", coordinates=desk.symbol_list(coordinates), rates=desk.symbol_list(rates)),
        say("method.time", step=desk.quantity(run.step, "s"), evaluations=desk.numbers.whole(run.motion.evaluations)),
    ]
    if run.settings.project:
        sentences.append(say.count("method.project", run.settings.project))
    if run.settings.gain:
        product = desk.numbers.plain(run.settings.gain * run.step)
        sentences.append(say("method.gain", gain=desk.quantity(run.settings.gain, "1/s"), product=product))
    if desk.exact is not None:
        label = desk.words.written(desk.exact.label) or say("plots.exact_label")
        sentences.append(say("method.exact", label=clean(label).rstrip(".")))
    parts.append(Paragraph(desk.lettered(" ".join(sentences))))
    if run.motion.notes:
        parts.append(Bullets([desk.rich(note) for note in run.motion.notes]))
    versions = ", ".join(f"{clean(name)} {clean(version)}" for name, version in run.versions.items())
    return [*parts, Paragraph(runs(say("method.versions", versions=versions)), "note")] if versions else parts


OPENING: tuple[tuple[Writer, str], ...] = (
    (title, ""),
    (remarks, ""),
    (given, ""),
    (drive, ""),
    (constraints, ""),
    (derivation, ""),
    (table, "table"),
    (plots, "plots"),
    (dead_point, ""),
    (checks, "checks"),
    (graph_check, "graph_check"),
)
CLOSING: tuple[tuple[Writer, str], ...] = (
    (accuracy, "accuracy"),
    (method, ""),
)


def all_sections(desk: Desk) -> Iterator[Section]:
    """Yield the sections in order: the opening, a table for each further quantity, the closing."""
    yield from _written_by(OPENING, desk)
    for quantity, extra in desk.run.extra_tables.items():
        if quantity in desk.run.asked:
            known = f"section.{quantity}"
            heading = desk.words(known) if desk.words.has(known) else clean(extra.title, LONGEST_NAME)
            yield Section(quantity, heading, extra_parts(desk, extra))
    yield from _written_by(CLOSING, desk)


def _written_by(writers: tuple[tuple[Writer, str], ...], desk: Desk) -> Iterator[Section]:
    for write, quantity in writers:
        if quantity and quantity not in desk.run.asked:
            continue
        if parts := write(desk):
            heading = desk.words(f"section.{write.__name__}") if write is not title else ""
            yield Section(write.__name__, heading, parts)
