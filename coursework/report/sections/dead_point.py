"""The section on a stop of the motion: when, why, and what it means for the mechanism; only here the cause is given.

Enters: a `PageContext`.  Leaves: parts, none if the motion does not stop.  Used by `sections.py` and `notebook.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

from coursework.report.graphs.figures import drawn
from coursework.report.text.page_context import STOP_DIGITS, PageContext
from coursework.report.text.parts import Facts, Paragraph, Part
from coursework.report.text.tables import row_at
from coursework.report.text.text_runs import begun, runs


def dead_point(context: PageContext) -> list[Part]:
    """Return when, where and why the motion stops, and what it means for the mechanism; empty if it does not stop."""
    stop, words = context.run.stop, context.words
    if stop is None:
        return []
    time = context.quantity(stop.time, "s", STOP_DIGITS)
    facts = [(words("stop.row"), runs(row_at(context, stop.row)))]
    if stop.block:
        facts.append((words("stop.block"), context.symbol_runs(stop.block)))
    if stop.coordinates:
        facts.append((words("stop.configuration"), runs(_values(context, stop.coordinates))))
    facts += [(words("stop.branches"), runs(_values(context, branch))) for branch in stop.branches]
    facts += [
        (words(f"stop.{key}"), context.rich(text)) for key, text in (("cause", stop.cause), ("meaning", stop.meaning)) if text
    ]
    if context.run.scene.phases:
        facts.append((words("stop.phases"), context.rich(context.run.scene.phases)))
    own = context.run.scene.stop is None  # the scheme stops where the mechanism does not
    # Under forces the links may move on or wait there; otherwise the scheme may have lost the motion before the stop.
    is_open = not context.run.scene.follows_laws or len(context.run.motion.t) < int(stop.row)
    kept = words("stop.kept_so_far" if own else "stop.kept_only" if is_open else "stop.kept", row=len(context.run.motion.t))
    lead = words("stop.lead", kind=begun(context.event(stop.kind)), time=time) + words("join.sentences")
    drawing = context.run.at_stop()
    figure = [drawn(context, drawing)] if drawing is not None else []
    return [Paragraph(runs(kept), "callout", lead), Facts(facts), *figure]


def _values(context: PageContext, values: Mapping[str, float]) -> str:
    unit_of = context.run.variant.unit_of
    listed = [f"{context.label(name)} = {context.quantity(value, unit_of(name))}" for name, value in values.items()]
    return context.words("join.comma").join(listed)
