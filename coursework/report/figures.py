"""Drawings that print to scale, as figures of a page.

Enters: a `PageContext` and drawings.  Leaves: parts.
Used by `accuracy_figures.py` and the sections that show a drawing.
"""

from __future__ import annotations

from coursework.drawing import record
from coursework.report.page_context import PageContext
from coursework.report.parts import Figure, Paragraph, Part
from coursework.report.text_runs import printed

WIDTH = 170.0  # mm; the text width of A4 with margins of 20 mm


def drawn(context: PageContext, drawing: record.Drawing) -> Figure:
    """Return a drawing as a figure of the page, its words in the page's language."""
    caption, alt = context.rich(drawing.caption), context.told(drawing.alt)
    return Figure(drawing.svg, drawing.width, drawing.height, alt, caption, drawing.exact, id=drawing.id)


def drawn_parts(context: PageContext, drawing: record.Drawing) -> list[Part]:
    """Return a drawing with the steps in which it was made."""
    figure = drawn(context, drawing)
    # A small letter in a step is the image of a point, whatever datum is called so.
    told = [printed(f"{number}. {context.told(step)}") for number, step in enumerate(drawing.steps, start=1)]
    numbered = [context.lettered(step, data=False) for step in told]
    return [figure, *(Paragraph(step, "note") for step in numbered)]
