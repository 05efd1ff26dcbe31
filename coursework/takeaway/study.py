"""The study of accuracy for a person: a plot by matplotlib on request, the page's drawing in a notebook.

Enters: an `AccuracyStudy` and its run.  Leaves: `Study`.  Used by `run.py`.
"""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from coursework.results.accuracy.record import AccuracyStudy
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.words.html_table import html_table

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@frozen
class Study(AccuracyStudy):
    """An `AccuracyStudy` that can be plotted."""

    run: SceneRun | None = None

    __repr__ = AccuracyStudy.__repr__

    def plot(self, ax: Axes | None = None) -> Axes:
        """Return Axes with the largest error of every method against evaluations, both logarithmic.

        >>> import coursework
        >>> coursework.solve("31", quantities=["table"]).accuracy.plot().get_xlabel()
        'evaluations'
        """
        from coursework.takeaway.plots import plot_study

        return plot_study(self, ax)

    def _repr_html_(self) -> str:
        assert self.run is not None
        from coursework.report.sections.accuracy import error_figure
        from coursework.report.text.page_context import PageContext
        from coursework.report.text.words import load_words

        svg = error_figure(PageContext(self.run, load_words("en")), self).svg
        rows = [(row.method, row.steps_or_tolerance, row.evaluations, f"{row.max_error:.3g} {row.unit}") for row in self.rows]
        return svg + html_table("", ("method", "steps", "evaluations", "largest error"), rows)


def study_of(study: AccuracyStudy, run: SceneRun) -> Study:
    """Return a study that has its run."""
    return Study(**{one.name: getattr(study, one.name) for one in fields(AccuracyStudy)}, run=run)
