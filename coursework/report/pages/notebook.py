"""A run as a notebook shows it: values that were set, remarks on likely slips, the drawing if there is one, plots, checks.

Enters: a `SceneRun`.  Leaves: a piece of HTML that fetches nothing and whose styles do not affect the page around it.
Used through `notebook_html` of the package, by `Run._repr_html_` and by authors of their own pages.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from coursework.report.graphs.figures import drawn
from coursework.report.pages.model import heading_of
from coursework.report.sections.dead_point import dead_point
from coursework.report.sections.graphs import graphs
from coursework.report.sections.remarks import remarks
from coursework.report.sections.sections import Writer
from coursework.report.sections.verdict.checks import checks
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Part
from coursework.report.text.text_runs import runs
from coursework.report.text.words import load_words
from coursework.scene.quantities import CHECKS, GRAPH_CHECK, Quantity
from coursework.scene.scene_run import SceneRun
from coursework.words.templates import filled


def drawing(context: PageContext) -> list[Part]:
    """Return the sheets of the graph-analytical check as figures that fit the width of the notebook."""
    graph, words = context.run.graph_check, context.words
    if graph is None:
        return []
    return [replace(drawn(context, sheet), exact=False) for sheet in graph.sheets(words.written)]


def method_line(context: PageContext) -> str:
    """Return scheme, step and end in one line."""
    run = context.run
    step, end = context.step, context.quantity(run.end, "s")
    return context.words("title.method_text", scheme=context.told(run.scheme_title), step=step, end=end)


SHOWN: tuple[tuple[Writer, Quantity[Any] | None], ...] = (
    (remarks, None), (dead_point, None), (drawing, GRAPH_CHECK), (graphs, None), (checks, CHECKS),
)  # fmt: skip


def notebook_html(run: SceneRun, language: str = "en") -> str:
    """Return a run as a notebook shows it: the requested quantities, and always the plots of its rows.

    Raises `InputError` if there is no such language.

    >>> import coursework
    >>> page = coursework.notebook_html(coursework.solve("31", quantities=["table", "checks"]))
    >>> page.count("<svg"), "PERIOD-POSITION" in page
    (8, True)
    """
    context = PageContext(run, load_words(language))
    parts = [part for write, quantity in SHOWN if quantity is None or run.asks(quantity) for part in write(context)]
    page = {"language": language, "heading": heading_of(context), "method": runs(method_line(context)), "parts": parts}
    return filled("notebook.html.j2", page=page, pictures={}, live=None)
