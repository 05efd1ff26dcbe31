"""The report on paper: `reports/report.typ` filled with the model.

Enters: a `ReportModel`.  Leaves: the bytes of a tagged PDF (PDF/UA-1), the same in every process.
Used by `assigning/sheet.py`, `commands/several.py` and `report/output/formats.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from coursework.report.formulas.typesetting import refusal, typeset
from coursework.report.pages.model import ReportModel

# Tried in turn: (standard, fonts of the machine).  The first serves all Latin, Greek and Cyrillic text; a name in
# another script takes the machine's fonts; where those lack the sign too, the page is printed without the standard.
WAYS = (("ua-1", False), ("ua-1", True), (None, True))
# Typst says of a tagged page that nothing in it is suspect, which is so where nothing is said; poppler takes that for a fault.
SAID, UNSAID = b"/MarkInfo<</Marked true/Suspects false>>", b"/MarkInfo<</Marked true>>"


def render_pdf(model: ReportModel) -> bytes:
    """Return the report as PDF.  Raises `OutputError` where Typst is missing or refuses the page."""
    return render_pages([model.plain()])


def render_pages(reports: Sequence[dict[str, Any]]) -> bytes:
    """Return reports, each as its model says it in plain data, one behind the other in one PDF.  Raises `OutputError`."""
    return pdf_of("report.typ", list(reports))


def pdf_of(template: str, data: Any) -> bytes:
    """Return what a template of `reports/` makes of data as PDF.  Raises `OutputError`; `InputError` for an own piece."""
    refused = RuntimeError(template)
    for standard, everything in WAYS:
        try:
            made = bytes(typeset(template, data, "pdf", standard=standard, everything=everything))
            return made.replace(SAID, UNSAID.ljust(len(SAID)))  # as long as before: the places of its objects stay
        except RuntimeError as error:  # typst.TypstError, which cannot be named before Typst is loaded
            refused = error
            if "could not be displayed" not in str(error):
                break
    raise refusal(refused) from refused
