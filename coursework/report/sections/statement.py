"""The first page: the author, what is given, what is sought, and the answer in a box.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

import re

from coursework.mechanism.mechanism import Mechanism
from coursework.report.graphs.figures import drawn
from coursework.report.sections.laws import laws_shown, moved_by_forces
from coursework.report.sections.remarks import as_written, remarks
from coursework.report.sections.verdict.answer import answer
from coursework.report.text.numbers import NOTHING, aligned, first_of
from coursework.report.text.page_context import STOP_DIGITS, PageContext
from coursework.report.text.parts import Cell, Column, Paragraph, Part, Runs, Table, TitleBlock
from coursework.report.text.text_runs import LONGEST_NAME, runs
from coursework.report.wording.data_meanings import coordinate_meanings, meanings
from coursework.report.wording.sought import sought
from coursework.variant.formula.tree import Formula, constant, terms
from coursework.variant.record.entries import reached
from coursework.variant.record.held import followed
from coursework.variant.record.variant import Variant
from coursework.words.templates import clean

WHOLE = 12  # rows of data that are kept on one page; more begin beside the box with the result, below the figure
MEASURED = 8  # most digits of a measured datum; one with more has been computed
_DECIMAL, _POWER = re.compile(r"-?\d+\.\d+"), re.compile(r"-?[\d.]+e[-+]?\d+")
GAP = "\ue002"  # marks the place in a sentence where a text of the file goes; it occurs in no text


def statement(context: PageContext) -> list[Part]:
    """Return title block, task, mechanism, data beside the answer, masses and loads, remarks."""
    data = _data(context)
    return [
        _title_block(context),
        *_bar(context),
        *([] if context.is_about_accuracy else [answer(context)]),
        *_task(context),
        *_mechanism(context),
        *([data] if data.rows else []),
        *_acting(context),
        *[Paragraph(context.in_its_language(text, context.rich(text)), style="note") for text in context.variant.remarks],
        *remarks(context),
    ]


def _acting(context: PageContext) -> list[Part]:
    """Return the masses and loads; empty if the file has no forces."""
    forces = context.variant.forces
    if forces is None:
        return []
    from coursework.report.sections.effects.masses_and_loads import masses_and_loads

    return masses_and_loads(context, forces)


def _bar(context: PageContext) -> list[Part]:
    """Return the bar on a stop of the motion: when, how many rows there are, and phases with which it would not stop."""
    run, say, stop = context.run, context.words, context.run.stop
    if stop is None:
        return []
    time, all_rows = context.quantity(stop.time, "s", STOP_DIGITS), run.variant.time.steps + 1
    kept = say("stop.bar_rows", kept=say.count("count.rows", len(run.motion.t)), rows=say.numbers.whole(all_rows))
    phases = [{"t": say("join.sentences")}, *context.rich(run.scene.phases)] if run.scene.phases else []
    lead = say("stop.bar", mark=say("checks.mark.FAIL"), time=time, kind=context.event(stop.kind))
    return [Paragraph([*runs(kept), *phases], "bar", lead)]


def _mechanism(context: PageContext) -> list[Part]:
    found = context.run.mechanism()
    return [drawn(context, found)] if found is not None else []


def _title_block(context: PageContext) -> TitleBlock:
    run, say = context.run, context.words
    lines = [
        ("institution", run.institution), ("student", run.student), ("group", run.group), ("teacher", run.teacher),
        ("date", run.date), ("mark", None), ("signature", None),
    ]  # fmt: skip
    return TitleBlock([(say(f"title.{key}"), _plain(value or "")) for key, value in lines if value or key != "date"])


def _plain(text: str) -> Runs:
    return [{"t": clean(text, LONGEST_NAME)}] if text else []


def _task(context: PageContext) -> list[Part]:
    """Return the drives and their laws, the points fixed to the frame, and what is sought."""
    variant, say = context.variant, context.words
    parts: list[Part] = []
    if variant.source:
        parts.append(Paragraph(_source(context), style="note"))
    if variant.motor is not None:
        parts += moved_by_forces(context, variant.motor)
    elif variant.drive:
        parts += _driven_laws(context)
    else:
        parts.append(Paragraph(context.say("drive.none")))
    if variant.functions:
        parts += [Paragraph(context.say("drive.functions")), *laws_shown(context, variant.functions)]
    return [*parts, Paragraph(context.lettered(say.sentences([*_held(context), *sought(context)])))]


def _driven_laws(context: PageContext) -> list[Part]:
    """Return the laws of each driven point, then those of other drives."""
    variant = context.variant
    points = {law: point for law, (point, _) in followed(variant).items()}
    parts: list[Part] = []
    for point in dict.fromkeys(points.values()):
        of_point = tuple(law for law in variant.drive if points.get(law.name) == point)
        parts += [Paragraph(context.say("drive.point", point=clean(point))), *laws_shown(context, of_point)]
    if others := tuple(law for law in variant.drive if law.name not in points):
        parts += [Paragraph(context.say("drive.besides" if points else "drive.rates")), *laws_shown(context, others)]
    return parts


def _source(context: PageContext) -> Runs:
    """Return the source of the task: our words around those of the file."""
    before, _, behind = context.words("statement.source", source=GAP).partition(GAP)
    return [*runs(before), *context.quoted(context.variant.source), *runs(behind)]


def _held(context: PageContext) -> list[str]:
    """Return the sentences on fixed hinges, wheels, sliding links and guided points."""
    variant, say = context.run.variant, context.words
    told = []
    if hinges := [clean(name) for name in variant.frame.hinges]:
        told.append(say.count("statement.hinges", len(hinges), points=say.listing(hinges)))
    for link in variant.links:
        if link.wheel and link.contact:
            wheel = {"link": clean(link.name), "centre": clean(link.wheel), "point": clean(link.contact)}
            middle = _rolled_on(variant, link.contact)
            if link.wheel in variant.frame.hinges:
                told.append(say("statement.gear", **wheel))
            elif middle:
                told.append(say("statement.wheel_on_circle", middle=clean(middle), **wheel))
            else:
                told.append(say("statement.wheel", **wheel))
        if link.slides:
            key = "sleeve" if {*link.points} & {*variant.frame.hinges} else "slides"  # on a pivot, or on a moving link
            told.append(say(f"statement.{key}", link=clean(link.name), bar=clean(link.slides)))
    contacts = {link.contact for link in variant.links}
    mechanism = context.run.scene.mechanism
    rails = _rails(mechanism)
    riders = [_rider(mechanism, through) for through, _ in rails]
    guided = [clean(name) for name in dict.fromkeys(riders) if name and name not in contacts]
    if guided:
        told.append(say.count("statement.guided", len(guided), points=say.listing(guided)))
    for rider, (through, angle) in zip(riders, rails, strict=True):
        if rider in guided and (point := _leads_through(mechanism, rider, through, angle)):
            told.append(say("statement.leads_through", rider=clean(rider), point=clean(point)))
    return told


def _rails(mechanism: Mechanism) -> list[tuple[Formula, Formula]]:
    """Return a point and the angle of each fixed guide: those of [frame], then those that only a group has."""
    rails = list(mechanism.variant.frame.rails)
    for group in mechanism.variant.groups:
        for guide in group.guides:
            names = {*guide.through.names(), *guide.angle.names()}
            if group.meets not in {_rider(mechanism, t) for t, _ in rails} and not any(_moves(mechanism, n) for n in names):
                rails.append((guide.through, guide.angle))
    return rails


def _rolled_on(variant: Variant, contact: str) -> str:
    """Return the centre of the fixed circle that a wheel rolls on; "" if it rolls on a rail or there are several."""
    on_rail = any(through.op == "name" and through.name == contact for through, _ in variant.frame.rails)
    middles = [centre.name for centre, _ in variant.frame.circles if centre.op == "name"]
    return middles[0] if len(middles) == len(variant.frame.circles) == 1 and not on_rail else ""


def _rider(mechanism: Mechanism, through: Formula) -> str:
    """Return the point that moves on a guide: the guide's own point if that moves, else the point of its group, else ""."""
    if through.op == "name" and _moves(mechanism, through.name):
        return through.name
    held = (group.meets for group in mechanism.variant.groups for guide in group.guides if guide.through == through)
    return next((name for name in held if name), "")


def _moves(mechanism: Mechanism, name: str) -> bool:
    """Return whether a point or value changes with time, or is defined by something that does."""
    variant, points = mechanism.variant, dict(mechanism.points)
    changing = {*variant.columns, *(law.name for law in variant.laws), "t"}
    return not changing.isdisjoint(reached([name], points))


def _leads_through(mechanism: Mechanism, rider: str, through: Formula, angle: Formula) -> str:
    """Return the fixed point through which the line of a guide leads, "" if none is known.

    It is the guide's own point, unless the guide has an offset.  If that point is the rider itself, it is the point from
    which the rider is placed: K in A = K + s @ beta on a guide along beta.
    """
    variant, points = mechanism.variant, dict(mechanism.points)
    if through.op == "name" and through.name != rider:
        guides = [guide for group in variant.groups for guide in group.guides if guide.through == through]
        return "" if any(constant(guide.offset) != 0 for guide in guides) else through.name
    parts = [*terms(points[rider])] if rider in points else []
    is_along = [part.op for part in parts] == ["name", "@"] and parts[1].args[1] == angle
    return parts[0].name if is_along and not _moves(mechanism, parts[0].name) else ""


def _data(context: PageContext) -> Table:
    """Return the table of the data as the file writes them, and of the coordinates at the start."""
    variant = context.variant
    means = meanings(context.run.scene.mechanism)
    measured = coordinate_meanings(context.run.scene.mechanism)
    listed: list[tuple[Runs, Runs, tuple[str, str]]] = [
        (
            context.symbol_runs([g.name]),
            context.quoted(g.means) if g.means else context.lettered(context.told(means[g.name])),
            (_given(context, g.text), context.unit(g.unit)),
        )
        for g in variant.given
    ]
    for c in variant.coordinates:
        head = context.symbol_runs([c.name])
        if c.start is None:
            how = context.words("given.from_groups" if c.start_guess is None else "given.follows")
            listed.append((head, _between(context, measured[c.name], how), (_first(context, c.name), context.unit(c.unit))))
        else:
            how = context.words("given.at_start")
            listed.append((head, _between(context, measured[c.name], how), (_given(context, c.text), context.unit(c.written))))
    values = aligned([value for _, _, (value, _) in listed], context.numbers.mark)
    rows: list[list[Cell]] = [[head, means, value, unit] for (head, means, (_, unit)), value in zip(listed, values, strict=True)]
    heads = ("quantity", "meaning", "written", "unit")
    columns = [Column(context.say(f"given.{key}"), words=key != "written") for key in heads]
    return Table(columns, rows, context.say("given.data" if variant.given else "given.coordinates"), whole=len(rows) <= WHOLE)


def _between(context: PageContext, measured: str, how: str) -> Runs:
    """Return what a coordinate measures, followed by how its start is known."""
    return context.lettered(context.words("given.between", ends=context.told(measured), how=how) if measured else how)


def _first(context: PageContext, name: str) -> str:
    """Return a coordinate in the first row, or "–" if the table is restricted to other columns."""
    motion = context.run.motion
    known = name in motion.coordinate_names and len(motion.t) > 0
    return context.numbers.plain(first_of(motion, name)) if known else NOTHING


def _given(context: PageContext, text: str) -> str:
    """Return a value as the file gives it, with the signs of the page; a number with too many digits is rounded."""
    if _POWER.fullmatch(text.lower()):
        return context.numbers.dressed(text.lower())
    computed = _DECIMAL.fullmatch(text) and len(text.strip("-0.").replace(".", "")) > MEASURED
    return context.numbers.plain(float(text)) if computed else as_written(context, text)
