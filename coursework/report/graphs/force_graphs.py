"""Graphs of forces: the driving forces or moments against time with their mean, and the reaction in each pin as a polar curve.

Enters: a `PageContext`, a `ForceAnalysis`.  Leaves: figures of panels.  Used by `report/sections/effects/forces.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.report.graphs import graph_paper
from coursework.report.graphs.graph_paper import BOTTOM, FAINT, INK, LEFT, RIGHT, SCHEME_INK, TOP, Field
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Panel, Panels, Part, Runs
from coursework.system.arrays import Array
from coursework.words.html_table import escaped

SIZE, SQUARE = (82.0, 34.0), (82.0, 66.0)  # mm
MOST = 6  # polar curves in one figure
_ROUND_OFF = 1e-12  # parts of the largest force: a drive that stays below (or is unknown in every row) has no graph
MEAN_PEN = f'stroke="{INK}" stroke-width="0.2" stroke-dasharray="2 1"'


def force_graphs(
    context: PageContext, found: ForceAnalysis, exact: ForceAnalysis | None, legend: list[tuple[str, Runs]]
) -> list[Part]:
    """Return the drives against time, then the polar curves of the reactions, under a `legend`; empty for less than 3 rows.

    Rows of a scheme are dots over the curve of the `exact` motion; the rows of an exact table are that curve.
    """
    if found.rows.count < 3:
        return []
    dotted = context.run.results.exact_forces is not found
    parts: list[Part] = []
    least = _ROUND_OFF * found.reactions.largest
    acting = [name for name in found.drive_names if np.nanmax(np.abs(found.column(name)), initial=0.0) > least]
    panels = [_over_time(context, found, exact, name, dotted=dotted) for name in acting]
    if panels:
        caption = context.words("forces.graph", symbols=context.symbol_list(acting))
        parts.append(Panels("forces-drive", *SIZE, legend, panels, context.lettered(caption)))
    pairs = [name[:-1] for name in found.reactions.names if name[0] == "R" and name.endswith("x")]
    curves = [curve for pair in pairs if (curve := _polar(context, found, exact, pair, dotted=dotted)) is not None]
    for first in range(0, len(curves), MOST):
        shown = curves[first : first + MOST]
        parts.append(
            Panels(f"forces-polar-{first // MOST + 1}", *SQUARE, [] if panels else legend, shown, context.say("forces.polar"))
        )
    return parts


def _over_time(context: PageContext, found: ForceAnalysis, exact: ForceAnalysis | None, name: str, *, dotted: bool) -> Panel:
    t, values = found.rows.motion.t, found.column(name)
    true_t, true = (exact.rows.motion.t, exact.column(name)) if exact is not None else (np.zeros(0), np.zeros(0))
    unit = context.unit(found.units[found.names.index(name)])
    field = graph_paper.field_for(SIZE, [t, true_t], [values, true], context.numbers)
    symbol = context.symbol(name)
    inside = graph_paper.framed(context, field, symbol, unit)
    inside += graph_paper.lines(field, (true_t, true), (t, values) if dotted else None)
    mean = float(np.nanmean(true if len(true) else values))
    inside += f'<path {MEAN_PEN} d="M{field.left:g} {field.y(mean):.2f}H{field.width - RIGHT:g}"/>'
    low, high = (context.quantity(float(end), unit, 4) for end in (np.nanmin(values), np.nanmax(values)))
    alt = context.words("graphs.alt_rows", symbol=symbol.text, low=low, high=high)
    return Panel(name, graph_paper.sheet(field, inside), alt)


def _polar(context: PageContext, found: ForceAnalysis, exact: ForceAnalysis | None, pair: str, *, dotted: bool) -> Panel | None:
    """Return the curve of the tip of a reaction drawn from the origin, x and y to one scale; None if it is no curve."""
    x, y = _tips(found, pair)
    if len(x) < 3 or not (np.ptp(x) or np.ptp(y)):
        return None
    true_x, true_y = _tips(exact, pair) if exact is not None else (np.zeros(0), np.zeros(0))
    field = _square(np.append(x, true_x), np.append(y, true_y))
    unit = context.unit("N")
    symbol = context.symbol(pair)
    at_x, at_y = field.x(x), field.y(y)
    inside = f'<path stroke="{FAINT}" stroke-width="0.2" d="M{field.x(0):.2f} {TOP:g}V{field.height - BOTTOM:g}"/>'
    inside += f'<path stroke="{FAINT}" stroke-width="0.2" d="M{field.left:g} {field.y(0):.2f}H{field.width - RIGHT:g}"/>'
    for value, text in graph_paper.ticks(field.first, field.last, 5, context.numbers):
        inside += graph_paper.words(field.x(value), field.height - BOTTOM + 3.6, text, "middle")
    for value, text in graph_paper.ticks(field.low, field.high, 5, context.numbers):
        if field.y(value) < field.height - BOTTOM - 1.5:  # one in the corner would touch the first number below
            inside += graph_paper.words(field.left - 0.8, field.y(value) + 1.0, text, "end")
    inside += graph_paper.lines(field, (true_x, true_y), (x, y) if dotted else None)
    inside += f'<circle cx="{at_x[0]:.2f}" cy="{at_y[0]:.2f}" r="1.2" fill="{SCHEME_INK}"/>'
    inside += graph_paper.words(field.left + 1.2, TOP - 2.2, graph_paper.letters(symbol) + escaped(context.words.behind(unit)))
    largest = context.quantity(float(np.hypot(x, y).max()), "N", 4)
    alt = context.words("forces.polar_alt", symbol=symbol.text, size=largest)
    return Panel(pair, graph_paper.picture(*SQUARE, inside), alt)


def _tips(found: ForceAnalysis, pair: str) -> tuple[Array, Array]:
    """Return x and y of a reaction in the rows in which it is known."""
    x, y = found.column(f"{pair}x"), found.column(f"{pair}y")
    known = np.isfinite(x) & np.isfinite(y)
    return x[known], y[known]


def _square(x: Array, y: Array) -> Field:
    """Return a field that contains the origin and a curve, with the same scale for x and y."""
    wide, high = SQUARE[0] - LEFT - RIGHT, SQUARE[1] - TOP - BOTTOM
    low, top = min(0.0, float(y.min())), max(0.0, float(y.max()))
    first, last = min(0.0, float(x.min())), max(0.0, float(x.max()))
    unit = 1.1 * max((last - first) / wide, (top - low) / high) or 1.0
    middle, centre = (first + last) / 2, (low + top) / 2
    return Field(
        *SQUARE, middle - unit * wide / 2, middle + unit * wide / 2, centre - unit * high / 2, centre + unit * high / 2, LEFT
    )
