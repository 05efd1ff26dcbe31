"""The section on motion under forces: the equation of motion, cost and error of the schemes, and their energy.

Enters: a `PageContext` of a run with a motor.  Leaves: parts.  Used by the list of sections, by name.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.effects.dynamics.dynamics_lesson import Row, lesson
from coursework.effects.dynamics.regime import Regime
from coursework.report.graphs.graph_paper import EXACT_PEN, field_for, framed, line_of_rows, sheet
from coursework.report.sections.graphs import SIZE, key
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Column, Display, Equations, Panel, Panels, Paragraph, Part, Table
from coursework.report.text.symbols import symbol
from coursework.report.text.tables import extra_parts
from coursework.report.text.text_runs import numeral
from coursework.scene.motor_scene import MotorScene
from coursework.scene.quantities import DYNAMICS

_ONE = ("J(q) dot(v) = Q(t, q, v) - 1/2 J'(q) v^2", "J(q)·dv/dt = Q(t, q, v) − ½·J′(q)·v²")
_SEVERAL = ("M(q) dot(v) = Q(t, q, v) - c(q, v)", "M(q)·dv/dt = Q(t, q, v) − c(q, v)")


def dynamics(context: PageContext) -> list[Part]:
    """Return the equation of motion, a comparison of schemes, the graph of energy, and the rows."""
    table, scene = context.run.of(DYNAMICS), context.run.scene
    if not len(table.rows) or not isinstance(scene, MotorScene):
        return []
    parts = _equation(context, is_one=len(scene.free_equations.free) == 1)
    if scene.free_equations.rubbing is not None:
        parts.append(Paragraph(context.say("dynamics.friction")))
    if scene.stop is not None and context.run.motion.stop is None:
        parts.append(Paragraph(context.rich(scene.stop.sentence)))
    if lines := lesson(scene.moved):
        parts.append(_compared(context, lines, scene.unit_of_rates))
    if scene.regime is not None:
        parts.append(_regime(context, scene.regime, table.names[1 + len(context.run.motion.coordinate_names)]))
    *tables, last = extra_parts(context, table, "dynamics.csv")
    assert isinstance(last, Table)
    head = replace(last.columns[-1], head=context.say("dynamics.energy_head"))
    return [*parts, _energy(context, scene), *tables, replace(last, columns=[*last.columns[:-1], head])]


def _equation(context: PageContext, *, is_one: bool) -> list[Part]:
    """Return the equation of motion, the meaning of its letters, and how the other coordinates follow."""
    free, names = context.stepped, context.run.motion.coordinate_names
    named = {"free": context.symbol_list(name for name in free if name in names)}
    named["rates"] = context.symbol_list(name for name in free if name not in names)
    told = [context.words("dynamics.of_one" if is_one else "dynamics.of_several", **named)]
    if {*names} - {*free}:
        told.append(context.words("dynamics.closed"))
    equation = Equations([Display(*(_ONE if is_one else _SEVERAL))])
    return [Paragraph(context.say("dynamics.equation")), equation, Paragraph(context.lettered(context.words.sentences(told)))]


def _regime(context: PageContext, found: Regime, rate: str) -> Paragraph:
    """Return the sentence on the steady motion."""
    speed, least, largest = (context.quantity(value, "rad/s", 5) for value in (found.speed, found.least, found.largest))
    delta = context.numbers.scalar(found.delta, 4)
    told = context.words(
        "dynamics.regime", rate=context.lettering(rate), speed=speed, least=least, largest=largest, delta=delta,
        period=context.quantity(found.period, "s", 5),
    )  # fmt: skip
    return Paragraph(context.lettered(told))


def _compared(context: PageContext, lines: list[Row], unit: str) -> Table:
    """Return `table#dynamics-lesson`: for each scheme its slopes, the largest error of the rates, the energy gained."""
    numbers, cells = context.numbers, list[list[Cell]]()
    for one in lines:
        shown = [numbers.whole(one.slopes), numbers.scalar(one.error, 3), numbers.scalar(one.gained, 3)]
        cells.append([context.told(one.title), *map(numeral, shown)])
    units = ("", context.unit(context.words.written(unit)), context.unit("J"))
    keys = ("dynamics.slopes", "accuracy.head.max_error", "dynamics.gained")
    heads = [Column(context.say("dynamics.method"), words=True)]
    heads += [Column(context.say(key), unit) for key, unit in zip(keys, units, strict=True)]
    return Table(heads, cells, context.say("dynamics.lesson"), id="dynamics-lesson")


def _energy(context: PageContext, scene: MotorScene) -> Panels:
    """Return the graph of energy against time, of the rows and of the exact motion."""
    rows, exact = scene.motion, scene.exact
    own, true = scene.energy_of(rows), scene.energy_of(exact)
    own = np.where(np.abs(own) < 3 * max(float(np.abs(true).max(initial=0.0)), 1e-12), own, np.nan)
    field = field_for(SIZE, [rows.t, exact.t], [own, true], context.numbers)
    inside = framed(context, field, symbol("E"), context.unit("J"))
    inside += f'<path {EXACT_PEN} d="{field.path(exact.t, true)}"/>{line_of_rows(field, rows.t, own)}'
    ends = [context.quantity(float(np.nanmax(values)), "J", 4) for values in (own, true)]
    panel = Panel("energy", sheet(field, inside), context.words("dynamics.energy_alt", own=ends[0], true=ends[1]))
    legend = key(context, dotted=True, exact=True)
    return Panels("dynamics-energy", *SIZE, legend, [panel], context.say("dynamics.energy"))
