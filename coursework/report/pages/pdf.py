"""The report on paper: `reports/report.typ` filled with the model.

Enters: a `ReportModel`.  Leaves: the bytes of a tagged PDF (PDF/UA-1), the same in every process, and the letters that no
face here has.  Used by `assigning/assign.py`, `commands/several.py` and `report/output/formats.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

from coursework.report.formulas.typesetting import refusal, typeset
from coursework.report.pages.model import ReportModel
from coursework.report.pages.packed import packed

# Tried in turn: (standard, fonts of the machine).  The first serves all Latin, Greek and Cyrillic text; a name in
# another script takes the machine's fonts; where those lack the sign too, the page is printed without the standard.
WAYS = (("ua-1", False), ("ua-1", True), (None, True))
# Typst says of a tagged page that nothing in it is suspect, which is so where nothing is said; poppler takes that for a fault.
SAID, UNSAID = b"/MarkInfo<</Marked true/Suspects false>>", b"/MarkInfo<</Marked true>>"
_MISSING = re.compile(r'the text `"(.+?)"` could not be displayed')


class Paper(NamedTuple):
    """A PDF, and the letters that stand as boxes in it, each once: neither the tool nor this machine has a face with them."""

    content: bytes
    missing: str


def render_pdf(model: ReportModel) -> bytes:
    """Return the report as PDF.  Raises `OutputError` where Typst is missing or refuses the page."""
    return render_pages([model.plain()])


def render_pages(reports: Sequence[dict[str, Any]]) -> bytes:
    """Return reports, each as its model says it in plain data, one behind the other in one PDF.  Raises `OutputError`."""
    return paper_of(reports).content


def paper_of(reports: Sequence[dict[str, Any]]) -> Paper:
    """Return reports as `render_pages` does, with the letters that no face has.  Raises `OutputError`."""
    return pdf_of("report.typ", list(reports))


def pdf_of(template: str, data: Any) -> Paper:
    """Return what a template of `reports/` makes of data as PDF.  Raises `OutputError`; `InputError` for an own piece."""
    refused = RuntimeError(template)
    for standard, everything in WAYS:
        try:
            made = bytes(typeset(template, data, "pdf", standard=standard, everything=everything))
            content = made.replace(SAID, UNSAID.ljust(len(SAID)))  # as long as before: the places of its objects stay
            return Paper(packed(content), "" if standard else _letters(refused))
        except RuntimeError as error:  # typst.TypstError, which cannot be named before Typst is loaded
            refused = error
            if not _letters(error):
                break
    raise refusal(refused) from refused


def _letters(refused: RuntimeError) -> str:
    """Return the letters that Typst has found in no face."""
    return "".join(dict.fromkeys("".join(_MISSING.findall(getattr(refused, "diagnostic", "") or str(refused)))))
