"""Sections whose modules are imported when a run has asked for them: a page without forces or a program imports nothing of them.

Enters: module and function.  Leaves: a writer of that name.  Used by `sections.py`.
What writes a program stands above this floor, in `takeaway/listing/`.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Part


def late(module: str, name: str) -> Callable[[PageContext], list[Part]]:
    """Return the writer of a module of the package."""

    def write(context: PageContext) -> list[Part]:
        parts: list[Part] = getattr(import_module(f"coursework.{module}"), name)(context)
        return parts

    write.__name__ = name
    return write


dynamics = late("report.sections.dynamics", "dynamics")
forces, energy = (late("report.sections.forces", name) for name in ("forces", "energy"))
listing, flowchart = (late("takeaway.listing.appendix", name) for name in ("listing", "flowchart"))
