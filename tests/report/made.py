"""Models, pages and papers of runs of the catalogue, each made once a process; who looks at them leaves them as they are.

Not for tests of the making itself: those make anew, and under changed words, templates or fonts nothing of this is asked.
"""

from __future__ import annotations

from typing import Any

from coursework.report.pages import build_model, render_html, render_pdf
from coursework.report.pages.model import ReportModel
from coursework.scene.scene_run import SceneRun
from tests.solved import solved as solved

_models: dict[tuple[int, str, bool], tuple[SceneRun, ReportModel]] = {}


def model_of(run: SceneRun, language: str = "en", *, live: bool = False) -> ReportModel:
    """Return the model of a run; the run is kept, so that no other comes to its place."""
    key = (id(run), language, live)
    if key not in _models:
        _models[key] = (run, build_model(run, language, live=live))
    return _models[key][1]


_texts: dict[tuple[int, str], tuple[ReportModel, Any]] = {}


def _once(model: ReportModel, kind: str, make: Any) -> Any:
    key = (id(model), kind)
    if key not in _texts:
        _texts[key] = (model, make(model))
    return _texts[key][1]


def page_of(model: ReportModel) -> str:
    """Return the page of a model."""
    return str(_once(model, "html", render_html))


def paper_of(model: ReportModel) -> bytes:
    """Return the PDF of a model."""
    return bytes(_once(model, "pdf", render_pdf))
