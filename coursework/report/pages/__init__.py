"""A `SceneRun` -> one report model -> a page to read (HTML), a page to print (PDF).

Enters: a `SceneRun`.  Leaves: text and bytes.  Used by `report/output/`.
"""

from coursework.report.pages.html import render_html
from coursework.report.pages.model import ReportModel, build_model
from coursework.report.pages.pdf import render_pdf

__all__ = ["ReportModel", "build_model", "render_html", "render_pdf"]
