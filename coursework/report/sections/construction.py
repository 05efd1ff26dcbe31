"""The graph-analytical check: the drawing, and both results side by side.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

import math

from coursework.drawing.plans.readings import Reading
from coursework.report.graphs.figures import drawn_parts
from coursework.report.text.numbers import NOTHING
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Bullets, Cell, Column, Part, Table
from coursework.report.text.text_runs import numeral

READ_DECIMALS = 1  # of a length in mm that is read to 0.5
RULER = 300.0  # mm: longer than the sheet and the ruler; such a length nobody reads
PERCENT_DECIMALS = 2  # of a difference in percent, in every row alike


def graph_check(context: PageContext) -> list[Part]:
    """The drawing by which the table is checked, true to scale, and both results side by side."""
    graph = context.run.graph_check
    if graph is None:
        return []
    sheet: list[Part] = [*drawn_parts(context, graph.drawing(context.words.written, blank=context.run.blank))]
    if context.run.blank:
        return sheet
    parts: list[Part] = []
    keys = ("quantity", "read", "relation", "measured", "tabled", "difference")
    heads = [Column(context.say(f"graph.{key}"), words=key in {"quantity", "relation"}) for key in keys]
    rows = [_row(context, one) for one in graph.readings]
    if rows:
        parts.append(Table(heads, rows, context.say("graph.table")))
    told = [context.rich(note) for note in graph.notes]
    if far := [one.length for one in graph.readings if _is_far(one)]:
        told.append(context.rich(context.words("graph.beyond", lengths=context.words.listing(far))))
    notes = [Bullets(told)] if told else []
    return [*parts, *notes, *sheet]


def _is_far(one: Reading) -> bool:
    return one.read is not None and one.read > RULER


def _row(context: PageContext, one: Reading) -> list[Cell]:
    """Return one line of the table: the length, what was read, how the value follows, both values, how far they are apart."""
    numbers, words = context.numbers, context.words
    if one.read is None:
        read = words("graph.given", length=one.length) if one.length else ""
    else:
        length = numbers.fixed(one.read, READ_DECIMALS)
        read = words("graph.computed", length=one.length, mm=length) if _is_far(one) else f"{one.length} = {length}"
    apart = numbers.dressed(_percent(one.difference)) if math.isfinite(one.difference) else NOTHING
    explained = f" (±{numbers.dressed(_percent(one.explained))})" if one.explained else ""
    values = [numeral(context.with_unit(numbers.scalar(one.found), one.unit)), NOTHING]
    if math.isfinite(one.table):
        values[1] = numeral(context.with_unit(numbers.scalar(one.table), one.unit))
    return [context.rich(one.name), context.rich(read), context.rich(one.relation), *values, f"{apart}{explained}"]


def _percent(share: float) -> str:
    """Return a share in percent; what rounds to nought has no sign."""
    return f"{round(100 * share, PERCENT_DECIMALS) + 0.0:.{PERCENT_DECIMALS}f}"
