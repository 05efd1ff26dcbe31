"""The graph-analytical check: the drawing, and both results side by side.

Enters: a `PageContext`.  Leaves: parts.  Used by `sections.py`.
"""

from __future__ import annotations

from coursework.report.figures import true_to_scale
from coursework.report.page_context import PageContext
from coursework.report.parts import Bullets, Cell, Column, Part, Table
from coursework.report.text_runs import numeral


def graph_check(context: PageContext) -> list[Part]:
    """The drawing by which the table is checked, true to scale, and both results side by side."""
    graph, numbers = context.run.graph, context.numbers
    if graph is None:
        return []
    row = context.run.variant.time.check_row
    figure = true_to_scale(
        graph.drawn(context.words.written), context.words("graph.alt", row=row or ""), context.say("graph.caption")
    )
    heads = [
        Column(context.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "measured", "tabled", "difference")
    ]
    rows: list[list[Cell]] = [
        [context.rich(name), *(numeral(context.with_unit(numbers.scalar(value), unit)) for value in values)]
        for name, *values, unit in ((r[0], r[1], r[2], r[3], r[4]) for r in graph.rows)
    ]
    parts: list[Part] = [figure, *([Table(heads, rows)] if rows else [])]
    if graph.exact:
        errors: list[list[Cell]] = [
            [context.rich(name), *(numeral(context.with_unit(numbers.scalar(value), unit)) for value in (exact, gap))]
            for name, exact, gap, unit in graph.exact
        ]
        names = [Column(context.say(f"graph.{key}"), words=key == "quantity") for key in ("quantity", "exact", "error")]
        parts.append(Table(names, errors))
    return [*parts, *([Bullets([context.rich(note) for note in graph.notes])] if graph.notes else [])]
