"""The forces: what each joint carries and what drives the mechanism, row by row.

Enters: a `PageContext` of a run that was asked for forces.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Paragraph, Part
from coursework.report.text.tables import extra_parts
from coursework.scene.quantities import ENERGY, FORCES


def forces(context: PageContext) -> list[Part]:
    """The convention of signs, then the reactions and the drive of every row."""
    found = context.run.of(FORCES)
    if not found.rows.count:
        return []
    names = found.reactions.names
    rows = np.column_stack([found.rows.motion.t, found.reactions.rows])
    table = replace(found.as_table(), names=("t", *names), units=("s", *found.units[: len(names)]), rows=rows)
    convention = [context.words("forces.convention")]
    if any(name[0] in "NKT" for name in names):
        convention.append(context.words("forces.guides"))
    if pins := found.rows.scheme.pins:
        convention.append(context.words("forces.pins", points=tuple(pins)))
    if np.isnan(found.reactions.rows).any():
        convention.append(context.words("forces.blank"))
    return [Paragraph(context.lettered(context.words.sentences(convention))), *extra_parts(context, table, "forces.csv")]


def energy(context: PageContext) -> list[Part]:
    """Energies and powers of every row."""
    table = context.run.of(ENERGY).as_table(context.run.motion.t)
    return extra_parts(context, table, "energy.csv") if len(table.rows) else []
