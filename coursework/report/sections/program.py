"""The coursework as a program of one's own and its block diagram, in the appendix where they are asked for.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
What writes a program stands above this floor, in `takeaway/listing/`, and is named here by its module and function.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Code, Figure, Part

_PLACE = "coursework.takeaway.listing.appendix"


def listing(context: PageContext) -> list[Part]:
    """Return the program."""
    return [Code(_appendix().program_text(context))]


def flowchart(context: PageContext) -> list[Part]:
    """Return its block diagram."""
    svg, width, height, told = _appendix().diagram(context)
    return [Figure(svg, width, height, told, [], id="flowchart")]


def _appendix() -> Any:
    return import_module(_PLACE)
