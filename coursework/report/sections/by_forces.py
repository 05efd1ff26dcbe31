"""The sections about forces, each imported when a run has asked for it: a page without forces imports nothing of them.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Part


def dynamics(context: PageContext) -> list[Part]:
    """Motion under forces."""
    from coursework.report.sections.dynamics import dynamics as written

    return written(context)


def forces(context: PageContext) -> list[Part]:
    """Reactions and drive."""
    from coursework.report.sections.forces import forces as written

    return written(context)


def energy(context: PageContext) -> list[Part]:
    """Energies and powers."""
    from coursework.report.sections.forces import energy as written

    return written(context)
