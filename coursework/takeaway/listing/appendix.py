"""A program and its block diagram for the appendix of a report.

Enters: a `PageContext`.  Leaves: the listing in Python; SVG with its size in mm.  Used by the report, by name.
"""

from __future__ import annotations

from coursework.report.text.page_context import PageContext
from coursework.takeaway.listing.chart import block_diagram, size_of
from coursework.takeaway.listing.listings import listing
from coursework.takeaway.listing.program import program_of

_PIXEL = 25.4 / 96  # mm


def program_text(context: PageContext) -> str:
    """Return the listing."""
    return listing(program_of(context), "python", context.words)


def diagram(context: PageContext) -> tuple[str, float, float, str]:
    """Return the block diagram, its width and height (mm), and what it is."""
    program = program_of(context)
    width, height = size_of(program, context.words)
    told = context.words("listing.title", name=context.variant.name, title=context.variant.title)
    return block_diagram(program, context.words).strip(), width * _PIXEL, height * _PIXEL, told
