"""The section of graphs: a small panel for each coordinate, then for each velocity, with the rows over the exact curve.

Enters: a `PageContext`.  Leaves: figures of panels.  Used by `sections.py` and `notebook.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.motion.schemes import DEFAULT_SCHEME, title_of
from coursework.report.graphs import graph_paper
from coursework.report.graphs.graph_paper import EXACT_PEN, SCHEME_INK, SCHEME_PEN, STOP_PEN, STOP_WORDS, smooth, sparse
from coursework.report.text.numbers import shown_column
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Panel, Panels, Part, Runs
from coursework.scene.motion_results import given_constants
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.vocabulary import EXACT
from coursework.words.html_table import escaped

SIZE = (82.0, 34.0)  # mm; two stand side by side in 170 mm
MOST_PANELS = 8  # of one figure: as many as fit a page
SAMPLE = (10.0, 3.0)  # mm, width and height of a sample in the key


@frozen
class Rows:
    """One column in a panel: the rows of a table as dots, and a smooth exact curve; either may be empty."""

    name: str
    t: Array
    values: Array
    curve_t: Array
    curve: Array


def graphs(context: PageContext) -> list[Part]:
    """Return the panels of coordinates, then of velocities, without those that the drive keeps constant."""
    motion = context.run.motion
    if not len(motion.t):
        return []
    curve = _curves(context)
    constant = given_constants(context.run.variant, motion.names, motion.rows)
    named = [_rows(context, name, curve) for name in motion.names if name not in constant]
    firsts = range(0, len(named), MOST_PANELS)
    return [_figure(context, named[first : first + MOST_PANELS], number) for number, first in enumerate(firsts, start=1)]


def dotted(context: PageContext) -> Motion | None:
    """Return the rows shown as dots: those of the run's scheme, or, if the table is exact, of the scheme beside it."""
    return context.run.motion if context.run.tableau else context.run.scene.scheme_rows


def _curves(context: PageContext) -> Callable[[str], tuple[Array, Array]]:
    """Return a function from a column's name to times and values of its smooth exact curve, empty if it is not known."""
    exact = context.exact
    if exact is None or not len(exact.t):
        return lambda name: (np.zeros(0), np.zeros(0))
    between = {name: _smoothed(context, exact, name) for name in exact.coordinate_names}
    if (motion := smooth_motion(context, exact)) is not None:
        found = zip(motion.velocity_names, motion.velocities.T, strict=True)
        between |= {name: (motion.t, column) for name, column in found if np.isfinite(column).all()}

    def curve(name: str) -> tuple[Array, Array]:
        if name not in exact.names:
            return np.zeros(0), np.zeros(0)
        return between.get(name) or (sparse(exact.t), sparse(exact.column(name)))

    return curve


def _smoothed(context: PageContext, exact: Motion, name: str) -> tuple[Array, Array]:
    rate = next(one.rate for one in context.run.variant.coordinates if one.name == name)
    return smooth(exact.t, exact.column(name), exact.column(rate))


def smooth_motion(context: PageContext, exact: Motion) -> Motion | None:
    """Return an exact motion with rows between its rows, None where laws alone do not give it.

    Coordinates are interpolated from values and rates; velocities follow from the equations at them.
    """
    scene = context.run.scene
    if not scene.follows_laws:
        return None
    rates = scene.passing(scene.rates)
    curves = [_smoothed(context, exact, name) for name in rates.coordinates]
    if not curves or len({len(t) for t, _ in curves}) > 1:
        return None
    return rates.motion(curves[0][0], np.column_stack([values for _, values in curves]), EXACT, exact.step)


def _rows(context: PageContext, name: str, curve: Callable[[str], tuple[Array, Array]]) -> Rows:
    rows = dotted(context)
    known = rows is not None and name in rows.names
    t = rows.t if rows is not None and known else np.zeros(0)
    values = shown_column(rows, name, context.run.variant) if rows is not None and known else np.zeros(0)
    times, smoothed = curve(name)
    if (
        context.exact is not None
        and name in context.exact.names
        and not shown_column(context.exact, name, context.run.variant).any()
    ):
        smoothed = 0 * smoothed
    return Rows(name, t, values, times, smoothed)


def _figure(context: PageContext, shown: Sequence[Rows], number: int) -> Panels:
    run, words = context.run, context.words
    legend = key(context, dotted=any(len(rows.t) for rows in shown), exact=any(len(rows.curve) for rows in shown))
    names = [rows.name for rows in shown]
    caption = words("graphs.caption", symbols=context.symbol_list(names))
    if len(legend) == 2:
        caption = words.sentences([caption, words("graphs.seen")])
    if run.stop is not None:
        stop = words("graphs.stop", kind=context.event(run.stop.kind), time=context.quantity(run.stop.time, "s"))
        caption = words.sentences([caption, stop])
    panels = [_panel(context, rows) for rows in shown]
    return Panels(f"panels-{number}", *SIZE, legend, panels, context.lettered(caption))


def key(context: PageContext, *, dotted: bool, exact: bool) -> list[tuple[str, Runs]]:
    """Return the key: what the dots of the scheme mean if they are shown (`dotted`), and the line of the motion (`exact`)."""
    run = context.run
    scheme = context.told(title_of(DEFAULT_SCHEME) if run.tableau is None else run.scheme_title)
    told = []
    if dotted:
        told.append((_sample(dotted=True), context.say("graphs.rows", scheme=scheme, step=context.step)))
    if exact:
        told.append((_sample(dotted=False), context.say("graphs.exact")))
    return told


def _panel(context: PageContext, rows: Rows) -> Panel:
    run, words = context.run, context.words
    unit = context.unit(run.variant.unit_of(rows.name))
    symbol = context.symbol(rows.name)
    stop = [np.array([run.stop.time])] if run.stop is not None else []
    field = graph_paper.field_for(SIZE, [rows.t, rows.curve_t, *stop], [rows.values, rows.curve], context.numbers)
    inside = graph_paper.framed(context, field, symbol, unit)
    if run.stop is not None:
        x = field.x(run.stop.time)
        inside += f'<path {STOP_PEN} d="M{x:.2f} {graph_paper.TOP:g}V{field.height - graph_paper.BOTTOM:g}"/>'
        # The stop is named above the end of its line, on the side that has room.
        side = "end" if x > field.width / 2 else "start"
        inside += graph_paper.words(x, graph_paper.TOP - 2.2, escaped(context.event(run.stop.kind)), side, STOP_WORDS)
    inside += graph_paper.lines(field, (rows.curve_t, rows.curve), (rows.t, rows.values))
    is_known = rows.curve.any() and rows.name in (extremes := run.scene.extremes)
    ends = extremes[rows.name] if is_known else (float(rows.values.min()), float(rows.values.max()))
    low, high = (context.quantity(value, unit, 4) for value in ends)
    spread = "graphs.alt" if is_known else "graphs.alt_rows"
    alt = words(spread if low != high else "graphs.alt_constant", symbol=symbol.text, low=low, high=high)
    return Panel(rows.name, graph_paper.sheet(field, inside), alt)


def _sample(*, dotted: bool) -> str:
    """Return the sample of a line for the key."""
    width, height = SAMPLE
    if dotted:
        r = graph_paper.RADIUS
        inside = f'<path {SCHEME_PEN} d="M0 1.5H{width:g}"/>'
        inside += "".join(f'<circle cx="{x}" cy="1.5" r="{r}" fill="{SCHEME_INK}"/>' for x in (2, 5, 8))
    else:
        inside = f'<path {EXACT_PEN} d="M0 1.5H{width:g}"/>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="0 0 {width:g} {height:g}" aria-hidden="true">{inside}</svg>'
    )
