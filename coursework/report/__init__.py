"""A `SceneRun` -> one report model -> a page to read (HTML) and a page to print (PDF).

Enters: a `SceneRun`.  Leaves: text and bytes.  Used by `output`, the notebook and the grader.
"""

from coursework.report.html import render_html
from coursework.report.model import ReportModel, build_model
from coursework.report.notebook import notebook_html
from coursework.report.pdf import render_pdf

__all__ = ["ReportModel", "build_model", "notebook_html", "render_html", "render_pdf"]
