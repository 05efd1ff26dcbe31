"""A program and its block diagram for the appendix of a report.

Enters: a `PageContext`.  Leaves: parts.  Used by the list of sections, by name.
"""

from __future__ import annotations

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Code, Figure, Part
from coursework.takeaway.listing.chart import block_diagram, size_of
from coursework.takeaway.listing.listings import listing as written
from coursework.takeaway.listing.program import program_of

_PIXEL = 25.4 / 96  # mm


def listing(context: PageContext) -> list[Part]:
    """Return the program."""
    return [Code(written(program_of(context), "python", context.words))]


def flowchart(context: PageContext) -> list[Part]:
    """Return its block diagram."""
    program = program_of(context)
    width, height = size_of(program, context.words)
    told = context.words("listing.title", name=context.variant.name, title=context.variant.title)
    svg = block_diagram(program, context.words).strip()
    return [Figure(svg, width * _PIXEL, height * _PIXEL, told, [], id="flowchart")]
