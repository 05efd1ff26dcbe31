"""The plans of forces of a run, group by group, with what a ruler reads off them.

Enters: a `ForceAnalysis` and a row.  Leaves: `ForcePlans`: drawings, readings, the lines of `polygons.csv`.
Used by `report/sections/effects/forces.py`, which draws them when a page is made.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from coursework.drawing.force_plans.group_sheet import Figure, draw_group, scale_of
from coursework.drawing.force_plans.lever import Lever, draw_lever, levers_of
from coursework.drawing.force_plans.vectors import KNOWN, GroupPlan, group_plans
from coursework.drawing.paper.record import Drawing
from coursework.drawing.plans.plan_scale import read_length
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import named


@frozen
class Reading:
    """A force in N: `computed`, and `read` off its polygon, where it is `mm` long (to half a mm), with `unit` N per mm."""

    name: str
    computed: float
    mm: float
    unit: float

    @property
    def read(self) -> float:
        """Return what the ruler says (N)."""
        return self.mm * self.unit


@frozen
class ForcePlans:
    """`plans` of the groups, the last group first; `levers` of the drives; `row` (from 0) is the one on paper."""

    analysis: ForceAnalysis
    row: int
    plans: tuple[GroupPlan, ...]
    levers: tuple[Lever, ...]

    def readings(self) -> list[Reading]:
        """Return the forces that each polygon gives, as computed and as read."""
        found = []
        for plan in self.plans:
            unit = scale_of(plan, self.row)
            sizes = [(vector.name, vector.size(self.row)) for vector in plan.vectors if vector.role != KNOWN]
            if plan.inner is not None:
                sizes.append((plan.inner[0], float(abs(plan.inner[1][self.row]))))
            found += [Reading(name, size, read_length(size / unit), unit) for name, size in sizes]
        return found

    def group_drawing(self, number: int, written: Callable[[str], str]) -> Drawing:
        """Return the drawing of a group (from 0) with its forces and their polygon."""
        rows, plan = self.analysis.rows, self.plans[number]
        links = []
        for body in plan.bodies:
            held = [name for name in rows.scheme.holds[body] if (named(name), True, 0) in rows.values]
            links.append(tuple((name, complex(rows.vector(named(name))[self.row])) for name in held))
        figure = Figure(tuple(links), self.row, float(rows.motion.t[self.row]))
        return draw_group(plan, figure, number + 1, written)

    def lever_drawings(self, written: Callable[[str], str]) -> list[Drawing]:
        """Return the drawing of the lever of each drive."""
        time = float(self.analysis.rows.motion.t[self.row])
        return [draw_lever(lever, self.row, time, written) for lever in self.levers]

    def rows(self) -> Iterator[tuple[object, ...]]:
        """Yield the lines of `polygons.csv`, row by row: the sides of each polygon (SI)."""
        for row, t in enumerate(self.analysis.rows.motion.t.tolist()):
            for plan in self.plans:
                group = "-".join(plan.bodies)
                for vector in plan.vectors:
                    force = complex(vector.force[row])
                    yield row + 1, t, "table", "force", "force", group, vector.name, force.real, force.imag, "N"


def make_force_plans(analysis: ForceAnalysis, row: int) -> ForcePlans:
    """Return the plans of forces; `row` (from 0) is the one drawn on paper."""
    return ForcePlans(analysis, row, group_plans(analysis), levers_of(analysis, row) if analysis.rows.count else ())
