"""The section of graphs: velocities and coordinates over time, one figure for each unit.

Enters: a `PageContext`.  Leaves: figures.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.report.figures import HEIGHT, WIDTH, Curve, time_plot
from coursework.report.numbers import unit_text
from coursework.report.page_context import PageContext
from coursework.report.parts import Figure, Part
from coursework.schemes import DEFAULT_SCHEME
from coursework.sentences import title_of

MOST_CURVES = 7  # curves in one figure; as many as there are line styles


def plots(context: PageContext) -> list[Part]:
    """Velocities first, then coordinates: the rows as marked lines, what they are compared with thin behind."""
    motion, variant = context.run.motion, context.run.variant
    if not len(motion.t):
        return []
    figures: list[Part] = []
    for names in (motion.velocity_names, motion.coordinate_names):
        for unit in dict.fromkeys(variant.unit_of(name) for name in names):
            family = [name for name in names if variant.unit_of(name) == unit]
            for first in range(0, len(family), MOST_CURVES):
                figures.append(_figure(context, family[first : first + MOST_CURVES], unit, len(figures) + 1))
    return figures


def _curve(context: PageContext, name: str) -> Curve:
    motion, beside = context.run.motion, context.beside
    if beside is None or name not in beside.names:
        return Curve(context.symbol(name), motion.t, motion.column(name))
    return Curve(context.symbol(name), motion.t, motion.column(name), beside.t, beside.column(name))


def _figure(context: PageContext, names: Sequence[str], unit: str, number: int) -> Figure:
    run, say = context.run, context.words
    known = unit if say.has(f"plots.axis.{unit}") else "other"
    stop = run.stop.time if run.stop else None
    curves = [_curve(context, name) for name in names]
    svg = time_plot(
        f"plot-{number}",
        curves,
        x_label=say("plots.time"),
        y_label=say(f"plots.axis.{known}", unit=unit_text(unit)),
        thin_label=say("plots.exact_legend") if run.tableau else context.told(title_of(DEFAULT_SCHEME)),
        stop=stop,
        stop_label=context.event(run.stop.kind) if run.stop else "",
    )
    what, symbols = say(f"plots.what.{known}"), context.symbol_list(names)
    step = context.quantity(run.step, "s")
    caption = say("plots.caption", what=what, symbols=symbols, scheme=context.told(run.scheme_title), step=step)
    if run.lesson is not None:
        caption += " " + say(
            "plots.lesson", scheme=context.told(title_of(DEFAULT_SCHEME)), sentence=context.told(run.lesson.sentence)
        )
    elif context.exact is not None and any(curve.thin.size for curve in curves):
        label = context.told(context.exact.label) or say("plots.exact_label")
        caption += " " + say("plots.exact", label=label.rstrip("."))
    if run.stop is not None:
        caption += " " + say("plots.stop", kind=context.event(run.stop.kind), time=context.quantity(run.stop.time, "s"))
    first, last = context.quantity(float(run.motion.t[0]), "s"), context.quantity(float(run.motion.t[-1]), "s")
    alt = say("plots.alt", what=what, symbols=symbols, start=first, end=last)
    return Figure(svg, WIDTH, HEIGHT, alt, context.lettered(caption))
