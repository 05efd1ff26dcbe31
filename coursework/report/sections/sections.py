"""The sections of the report in their order; a section's name is its id and the name of the function that writes it.

Enters: a `PageContext`.  Leaves: sections; those without content are left out.  Used by `model.py`.
To add one: write the function, put it into `PAPER` or `APPENDIX` with the quantity that must be asked for, give it a title
`section.NAME` in the words files; it appears in its place, in HTML and PDF alike.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from coursework.report.graphs.figures import drawn_parts
from coursework.report.sections.accuracy import accuracy
from coursework.report.sections.construction import graph_check
from coursework.report.sections.dead_point import dead_point
from coursework.report.sections.derivation.motion_equations import equations
from coursework.report.sections.derivation.solution import solution
from coursework.report.sections.graphs import graphs
from coursework.report.sections.method import method
from coursework.report.sections.results import results
from coursework.report.sections.statement import statement
from coursework.report.sections.structure import structure
from coursework.report.sections.verdict.checks import checks
from coursework.report.sections.verdict.conclusion import conclusion
from coursework.report.sections.verdict.control import control
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Part, Section
from coursework.report.text.tables import TABLE_FILE, extra_parts
from coursework.report.text.text_runs import LONGEST_NAME
from coursework.scene.quantities import (
    ACCURACY,
    CHECKS,
    DYNAMICS,
    ENERGY,
    FLOWCHART,
    FORCES,
    GRAPH_CHECK,
    LISTING,
    PLOTS,
    TABLE,
    Quantity,
)
from coursework.system.late import late

Writer = Callable[[PageContext], list[Part]]
Writers = Sequence[tuple[Writer, Quantity[Any] | None]]


# Most pages do without these; the writers of a program are in `takeaway/`, a layer above this one.
dynamics = late("report.sections.effects.dynamics", "dynamics")
forces, energy = (late("report.sections.effects.forces", name) for name in ("forces", "energy"))
worked = late("report.sections.derivation.worked", "worked")
listing, flowchart = (late("takeaway.listing.appendix", name) for name in ("listing", "flowchart"))

# Each writer with the quantity that must be asked for; None: always written.
FIRST: Writers = ((statement, None), (dead_point, None), (structure, None), (equations, None), (solution, None))
PAPER: Writers = (
    (results, TABLE), (graphs, PLOTS), (control, CHECKS), (graph_check, GRAPH_CHECK), (dynamics, DYNAMICS), (forces, FORCES),
    (energy, ENERGY),
)  # fmt: skip
LAST: Writers = ((conclusion, CHECKS),)
APPENDIX: Writers = ((checks, CHECKS), (accuracy, ACCURACY), (method, None), (listing, LISTING), (flowchart, FLOWCHART))
# Sections after the table and the graphs: the desk, which writes a page again and again, makes them only when they are opened.
BEHIND: Writers = ((graph_check, GRAPH_CHECK), *LAST, *APPENDIX)


def all_sections(context: PageContext) -> Iterator[Section]:
    """Yield the sections in order, numbered: up to the results, then each further quantity, the conclusion, the appendix."""
    apart = context.is_about_accuracy
    if apart:
        yield from _written_by(((accuracy, ACCURACY),), context)
    for number, section in enumerate(_body(context), start=1):
        yield section.labelled(str(number))
    for place, section in enumerate(_written_by([one for one in APPENDIX if not apart or one[0] is not accuracy], context)):
        yield section.labelled(context.words("section.appendix", letter=context.words("section.letters")[place]))


def _body(context: PageContext) -> Iterator[Section]:
    yield from _written_by(FIRST, context)
    yield from _written_by(PAPER, context)
    for quantity, extra in context.run.extra_tables.items():
        file = f"{quantity}.csv" if quantity in context.run.own_tables else TABLE_FILE
        parts = [*worked(context, quantity, extra), *extra_parts(context, extra, file)]
        yield Section(quantity, _heading(context, quantity, extra.title), parts)
    for quantity, drawings in context.run.figures(context.words.written).items():
        if drawings:
            yield Section(
                quantity, _heading(context, quantity, quantity), [part for one in drawings for part in drawn_parts(context, one)]
            )
    yield from _written_by(LAST, context)


def _heading(context: PageContext, quantity: str, named: str) -> str:
    key = f"section.{quantity}"
    return context.words(key) if context.words.has(key) else context.told(named, LONGEST_NAME)


def _written_by(writers: Writers, context: PageContext) -> Iterator[Section]:
    for write, quantity in writers:
        name = write.__name__
        parts: list[Part] = []
        if name not in context.later and (quantity is None or context.run.asks(quantity)):
            parts = write(context)
        if parts or name in context.later:
            yield Section(name, context.words(f"section.{name}"), parts)
