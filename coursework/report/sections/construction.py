"""The section on the graph-analytical check: the drawing, and both results side by side.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from coursework.drawing.check_sheet.readings import Reading
from coursework.report.graphs.figures import drawn_parts
from coursework.report.text.numbers import NOTHING
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Bullets, Cell, Column, Paragraph, Part, Runs, Table
from coursework.report.text.text_runs import ITALIC, numeral, printed
from coursework.report.text.words import Words

COLUMN = 171.0  # mm: a wider sheet has a turned page to itself on paper, after all readings
READING_HEADS = ("quantity", "read", "relation", "measured", "tabled", "difference")
READ_DECIMALS = 1  # of a length in mm, which is read to 0.5 mm
PERCENT_DECIMALS = 2  # of a difference in percent, the same in every row


def graph_check(context: PageContext) -> list[Part]:
    """Return both results side by side, and the drawing by which the table is checked, true to scale."""
    graph = context.run.graph_check
    if graph is None:
        return []
    if graph.unread:
        return [Paragraph(context.rich(graph.unread))]
    sheets = graph.sheets(context.words.written, blank=context.run.blank)
    drawn = [drawn_parts(context, sheet) for sheet in sorted(sheets, key=lambda sheet: sheet.width > COLUMN)]
    drawings = [part for parts in drawn for part in parts]
    if context.run.blank:
        return drawings
    heads = [Column(context.say(f"graph.{key}"), words=key in {"quantity", "relation"}) for key in READING_HEADS]
    table = Table(heads, [_row(context, one) for one in graph.readings], context.say("graph.table"))
    told = [context.rich(note) for note in graph.notes]
    if far := [one.length for one in graph.readings if one.computed is not None]:
        told.append(context.rich(context.words("graph.beyond", lengths=context.words.listing(far))))
    return [table, *([Bullets(told)] if told else []), *drawings]


def _row(context: PageContext, one: Reading) -> list[Cell]:
    return reading_row(context.words, one, context.rich, lambda text: context.lettered(printed(text), data=False))


def reading_row(words: Words, one: Reading, rich: Callable[[str], Runs], plan: Callable[[str], Runs]) -> list[Cell]:
    """Return one line of the table: the quantity, the length read, the relation, both values, their difference.

    `rich` turns a sentence into runs with symbols, `plan` does so for a sentence about images of points on a plan.
    """
    numbers = words.numbers
    read = words("graph.given", length=one.length) if one.length else ""
    if one.read is not None:
        read = f"{one.length} = {numbers.fixed(one.read, READ_DECIMALS)}"
    elif one.computed is not None:
        read = words("graph.computed", length=one.length, mm=numbers.fixed(one.computed, READ_DECIMALS))
    judged = math.isfinite(one.difference) and one.rests  # a value that rests on no reading checks nothing
    apart = f"{numbers.dressed(_percent(one.difference))} (±{numbers.dressed(_percent(one.explained))})" if judged else NOTHING
    values = [numeral(words.amount(numbers.scalar(one.found), one.unit)), NOTHING]
    if math.isfinite(one.table):
        values[1] = numeral(words.amount(numbers.scalar(one.table), one.unit))
    lengths = "".join(f"{ITALIC[0]}{letter}{ITALIC[1]}" if letter.isalpha() else letter for letter in one.images)
    own = rf"(?:^|(?<=[ \u00a0])){re.escape(one.images)}(?!_)"  # only the image in "p_v p·0.02 (m/s)/mm"

    def put(text: str) -> Runs:
        return plan(re.sub(own, lengths, words.written(text), count=1)) if one.images else rich(text)

    return [rich(one.name), put(read), put(one.relation), *values, apart]


def _percent(share: float) -> str:
    """Return a share in percent; a value that rounds to zero has no sign."""
    return f"{round(100 * share, PERCENT_DECIMALS) + 0.0:.{PERCENT_DECIMALS}f}"
