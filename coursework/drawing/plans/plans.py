"""The quantity `plans`: plans of velocities and accelerations of every row, one row of them on paper.

Enters: a mechanism, its equations, the rows of a table and the exact rows with their accelerations.  Leaves: `Plans`.
Used by `quantities.py`; the sheets are drawn only when they are asked for (`polygon_sheet.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from coursework.drawing.outline.lengths import stretching
from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.record import Drawing
from coursework.drawing.plans.given import DrivenLengths, driven_lengths, given_points
from coursework.drawing.plans.known import Driven
from coursework.drawing.plans.moving import Kinematics, kinematics_of
from coursework.drawing.plans.polygons import polygons
from coursework.drawing.plans.vectors import ACCELERATION, UNITS, VELOCITY, Polygons
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


@frozen
class Plans:
    """The polygons of the student's rows (`table`) and of the `exact` motion; `row` (from 1) is the one on paper.

    A chain of groups is drawn in its exact position, any other mechanism in that of the table, where the student checks it.
    """

    outline: Outline
    row: int
    table: Polygons
    exact: Polygons
    chain: bool

    @property
    def shown(self) -> Polygons:
        """Return the polygons that are drawn."""
        return self.exact if self.chain else self.table

    def rows(self) -> Iterator[tuple[object, ...]]:
        """Yield the lines of `polygons.csv` row by row, in SI."""
        for name, found in (("table", self.table), ("exact", self.exact)):
            for row, t in enumerate(found.t.tolist()):
                for one in found.segments:
                    vector = complex(one.vector[row])
                    yield row + 1, t, name, one.plan, one.kind, one.start, one.end, vector.real, vector.imag, UNITS[one.plan]

    def drawings(self, written: Callable[[str], str]) -> tuple[Drawing, ...]:
        """Return `figure#velocity-plan` and `figure#acceleration-plan`; `written` translates words for a page."""
        from coursework.drawing.plans.polygon_sheet import draw_plan

        if not len(self.shown.t):
            return ()
        return tuple(draw_plan(self.shown, plan, self.outline.hinges, self.row, written) for plan in (VELOCITY, ACCELERATION))


def make_plans(
    mechanism: Mechanism, equations: VelocityEquations, table: tuple[Motion, Array], exact: tuple[Motion, Array]
) -> Plans:
    """Return the plans of a mechanism; `table` and `exact` are a motion and its accelerations each.

    Raises `InputError` if the file places no points.
    """
    variant = equations.variant
    outline = read_outline(mechanism)
    if outline is None or not outline.bars:
        raise InputError([Fault(say("fault.V523"), variant.file)])
    lengths = driven_lengths(outline, equations, exact[0])
    driven = Driven(given_points(outline, variant), variant.known_rates, lengths, stretching(mechanism))
    row = min(variant.time.row_of_check, max(1, min(len(table[0].t), len(exact[0].t))))
    rows, true = (
        polygons(outline, _kinematics(outline, equations, motion, second, lengths), driven, row - 1)
        for motion, second in (table, exact)
    )
    return Plans(outline, row, rows, true, chain=bool(variant.groups))


def _kinematics(
    outline: Outline, equations: VelocityEquations, motion: Motion, second: Array, driven: DrivenLengths
) -> Kinematics:
    """Return the motion of all points; driven lengths change at the rate of the drive, even in rows that have drifted."""
    found = kinematics_of(outline, equations, motion, second)
    ways = {}
    for slot in outline.slots:
        way = found.points[slot.toward].at - found.points[slot.base].at
        for rider in slot.riders:
            if rate := driven.get((slot.link, rider)):
                place = motion.velocity_names.index(rate)
                along = way / np.abs(way)
                ways[slot.link, rider] = (along * motion.velocities[:, place], along * second[:, place])
    return replace(found, driven=ways)
