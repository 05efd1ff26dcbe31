"""The graph-analytical check: one row drawn to scale, angular velocities by instantaneous centres, beside the table.

Enters: velocity equations, the rows of a scheme and the exact rows.  Leaves: `GraphCheck`.  Computed on request only.
The check takes only the positions and the driven velocity from the row (`instant_centres.py`); the drawing is made when
it is asked for (`drawing.py`).
Used by `assigning/handout.py`, `quantities.py` and `scene_run.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from coursework.drawing.check_sheet.graph_words import centre_letter, drift, how_found, omega_name, why_unread
from coursework.drawing.check_sheet.instant_centres import Findings, construct
from coursework.drawing.check_sheet.lacking import lacking
from coursework.drawing.check_sheet.layout import lay_out
from coursework.drawing.check_sheet.readings import Reading, read_off
from coursework.drawing.check_sheet.sketch import Body, Sketch, read_sketch
from coursework.drawing.outline.lengths import stretching
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.symbols import decimal
from coursework.drawing.plans.given import driven_lengths
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.geometry.time_derivatives import jets
from coursework.motion.integration.motion import Motion
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.check_plan import CheckPlan


@frozen
class GraphCheck:
    """The check of one `row` (from 1) at `time` (s).

    `rows` (name, measured, table value, measured - table, unit): angular velocities, speeds of joints, centres; nan if the
    table has no such value.  `true()` measures the same in the exact row: name -> (value, unit), empty without an exact row.
    `notes` are sentences: how each centre was found, what the drawing does not determine, by how much links and rails are off.
    `plan` is the plan of velocities, None if centres on the sheet give everything.
    """

    row: int
    time: float
    sketch: Sketch
    findings: Findings
    rows: tuple[tuple[str, float, float, float, str], ...]
    true: Callable[[], dict[str, tuple[float, str]]]
    notes: tuple[str, ...]
    readings: tuple[Reading, ...] = ()
    plan: CheckPlan | None = None

    def __repr__(self) -> str:
        return f"<GraphCheck of row {self.row}: {', '.join(name for name, *_ in self.rows)}>"

    @property
    def exact(self) -> tuple[tuple[str, float, float, str], ...]:
        """Return (name, exact value, table - exact, unit) of each quantity: the error of the scheme in that row."""
        true = self.true()
        return tuple((name, true[name][0], table - true[name][0], unit) for name, _, table, _, unit in self.rows if name in true)

    @property
    def centres(self) -> dict[str, complex | None]:
        """Return the constructed centres (m) by link, None for a link that translates."""
        return {name: centre.at for name, centre in self.findings.centres.items() if centre.lines}

    def drawing(self, written: Callable[[str], str] = str, *, blank: bool = False) -> Drawing:
        """Return the drawing; `written` translates its sentences for a page, `blank` leaves the construction out."""
        from coursework.drawing.check_sheet.drawing import draw

        return draw(self.sketch, self.findings, self.row, self.time, written, blank=blank)

    def sheets(self, written: Callable[[str], str] = str, *, blank: bool = False) -> tuple[Drawing, ...]:
        """Return all sheets: `figure#graph-check` and, if needed, `figure#check-plan`; none if nothing can be read off."""
        if self.unread:
            return ()
        position = self.drawing(written, blank=blank)
        return (position,) if self.plan is None else (position, self._plan_sheet(self.plan, written, blank=blank))

    def _plan_sheet(self, plan: CheckPlan, written: Callable[[str], str], *, blank: bool) -> Drawing:
        from coursework.drawing.plans.polygon_sheet import draw_plan
        from coursework.drawing.plans.vectors import UNITS, VELOCITY

        hinges = self.sketch.outline.hinges
        drawn = draw_plan(plan.polygons, VELOCITY, hinges, self.row, written, index=0, blank=blank)
        scale = decimal(plan.scale.unit)
        bare = say("graph.blank_plan", row=self.row, time=self.time, scale=scale, unit=UNITS[VELOCITY])
        return replace(drawn, id="check-plan", caption=bare if blank else drawn.caption)

    @property
    def unread(self) -> str:
        """Return a sentence on why nothing can be read off and there is no sheet, "" if something was read."""
        if any(self.findings.velocities.values()) and any(one.read is not None for one in self.readings):
            return ""
        return say("graph.unread", row=self.row, time=self.time, why=why_unread(self.sketch, self.findings, self.plan))

    @property
    def scale(self) -> float:
        """Return the denominator of the drawing's scale: 10 for 1:10."""
        return lay_out(self.sketch, self.findings).scale


def check_graph(mechanism: Mechanism, equations: VelocityEquations, motion: Motion, exact: Motion) -> GraphCheck | None:
    """Return the check of the variant's check row, None if the table ends before it.

    Raises `InputError` if the file lacks what a drawing needs.
    """
    variant = equations.variant
    if missing := lacking(variant):
        raise _refused(variant, missing)
    row = variant.time.row_of_check
    if row > len(motion.t):
        return None
    outline = read_outline(mechanism)
    assert outline is not None
    rigid = [set(bar.corners) for bar in outline.bars]
    if sides := tuple("".join(sorted(pair)) for pair in stretching(mechanism) if any(pair <= corners for corners in rigid)):
        raise _refused(variant, say("fault.V525", sides=sides))
    read = read_sketch(mechanism, outline, equations, driven_lengths(outline, equations, exact))
    sketch = read(motion, row - 1)
    findings = construct(sketch.pose)
    measured = _measured(sketch, findings)
    only = slice(row - 1, row)
    here = replace(motion, t=motion.t[only], coordinates=motion.coordinates[only], velocities=motion.velocities[only])
    tabled = _tabled(equations, here, sketch, findings)
    rows = tuple(
        (name, value, tabled.get(name, math.nan), value - tabled.get(name, math.nan), unit)
        for name, (value, unit) in measured.items()
    )

    def true() -> dict[str, tuple[float, str]]:
        perfect = read(exact, row - 1) if row <= len(exact.t) else None
        return _measured(perfect, construct(perfect.pose)) if perfect else {}

    values = {name: abs(value) for name, value in tabled.items()}
    layout, plan = lay_out(sketch, findings), None
    readings = read_off(sketch, findings, layout, values, None)
    moves = any(findings.velocities.values())
    if moves and (findings.planned or any(one.computed and not one.rests for one in readings)):
        from coursework.drawing.check_sheet.check_plan import plan_of
        from coursework.drawing.plans.moving import kinematics_of

        # If a plan is needed anyway, or a row would rest on no reading, the plan serves all links whose centre is off the sheet.
        seen = {name for name, centre in findings.drawn.items() if centre.at is None or not centre.lines or name in layout.near}
        far = tuple(body.name for body in sketch.pose.bodies if body.name in findings.drawn and body.name not in seen)
        findings = replace(findings, beyond=far)
        plan = plan_of(sketch, findings, kinematics_of(outline, equations, here, np.zeros_like(here.velocities)))
        if plan is not None and plan.specials:
            findings = replace(findings, specials=plan.specials)
            layout = lay_out(sketch, findings)
        readings = read_off(sketch, findings, layout, values, plan)
    notes = (*how_found(sketch, findings, plan), *sketch.notes, *drift(sketch))
    return GraphCheck(row, float(motion.t[row - 1]), sketch, findings, rows, true, notes, readings, plan)


def _refused(variant: Variant, message: Sentence) -> InputError:
    """Return the error at the line that asks for the check; line 0 if the command line asked for it."""
    line = variant.nearest_line("ask", "quantities") if "graph_check" in variant.ask else 0
    return InputError([Fault(message, variant.file, line)])


def _sought(sketch: Sketch, findings: Findings) -> list[Body]:
    """Return the links whose angular velocity the drawing gives: no sliders, no driven cranks, one link for each rate."""
    named: dict[str, Body] = {}
    for body in sketch.pose.bodies:
        if body.name in findings.omegas and not body.guide and body.rate not in sketch.pose.rates:
            named.setdefault(omega_name(body), body)
    return list(named.values())


def _drawn_centres(sketch: Sketch, findings: Findings) -> dict[str, tuple[str, complex]]:
    """Return the centres that had to be constructed, link -> (name, position in m)."""
    letter = centre_letter(sketch)
    return {name: (letter + name, c.at) for name, c in findings.centres.items() if c.lines and c.at is not None}


def _measured(sketch: Sketch, findings: Findings) -> dict[str, tuple[float, str]]:
    """Return what is read off the drawing: name -> (value, unit)."""
    found = {
        omega_name(body): (sketch.as_counted(body, findings.omegas[body.name]), "rad/s") for body in _sought(sketch, findings)
    }
    for name in sketch.moving:
        if name in findings.velocities and name not in sketch.pose.velocities:
            found[f"V_{name}"] = (abs(findings.velocities[name]), "m/s")
    for name, at in _drawn_centres(sketch, findings).values():
        found[f"{name}.x"], found[f"{name}.y"] = (at.real, "m"), (at.imag, "m")
    return found


def _tabled(equations: VelocityEquations, here: Motion, sketch: Sketch, findings: Findings) -> dict[str, float]:
    """Return the same quantities from one row of the table: its rates, and the speeds and centres that follow from them."""
    names = list(sketch.moving)
    components = [part for name in names for part in equations.symbols.vectors[name]]
    flat = jets(equations, components, 1)[1](here.t, here.coordinates, here.velocities)[0] if components else np.zeros(0)
    velocities = {name: complex(x, y) for name, x, y in zip(names, flat[::2], flat[1::2], strict=True)}
    found = {f"V_{name}": abs(velocity) for name, velocity in velocities.items()}
    centres = _drawn_centres(sketch, findings)
    for body in sketch.pose.bodies:
        if body.rate not in here.velocity_names or body.guide:
            continue
        omega = float(here.column(body.rate or "")[0])
        found[omega_name(body)] = omega
        carried = next((name for name in body.points if name in velocities), None)
        if body.name in centres and carried and omega:
            centre = sketch.pose.positions[carried] + 1j * velocities[carried] / sketch.as_counted(body, omega)
            name, _ = centres[body.name]
            found[f"{name}.x"], found[f"{name}.y"] = centre.real, centre.imag
    return found
