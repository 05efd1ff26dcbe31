"""A `SceneRun` -> one report model -> a page to read (HTML), a page to print (PDF); and the form of a run in a notebook.

Enters: a `SceneRun`.  Leaves: text and bytes.  Used by `report/output/`, `run.py` and the commands.
"""

from coursework.report.pages.html import render_html
from coursework.report.pages.model import ReportModel, build_model
from coursework.report.pages.notebook import notebook_html
from coursework.report.pages.pdf import render_pdf

__all__ = ["ReportModel", "build_model", "notebook_html", "render_html", "render_pdf"]
