"""The report on paper: `reports/report.typ` filled with the model.

Enters: a `ReportModel`.  Leaves: the bytes of a tagged PDF (PDF/UA-1), the same in every process, and the letters for which
there is no font.  Used by `assigning/assign.py`, `commands/several.py` and `report/output/formats.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

from coursework.report.formulas.typesetting import refusal, typeset
from coursework.report.pages.model import ReportModel
from coursework.report.pages.packed import packed

# Tried in turn: (standard, whether to use the fonts of the machine).  The first serves all Latin, Greek and Cyrillic text; a
# name in another script needs the machine's fonts; if those lack the letter too, the page is printed without the standard.
WAYS = (("ua-1", False), ("ua-1", True), (None, True))
# Typst writes "/Suspects false", which is the default anyway; poppler takes the entry for a fault, so it is removed.
SAID, UNSAID = b"/MarkInfo<</Marked true/Suspects false>>", b"/MarkInfo<</Marked true>>"
_MISSING = re.compile(r'the text `"(.+?)"` could not be displayed')


class Paper(NamedTuple):
    """A PDF, and the letters printed as boxes in it, each once, because neither the tool nor the machine has a font for them."""

    content: bytes
    missing: str


def render_pdf(model: ReportModel) -> bytes:
    """Return the report as PDF.  Raises `OutputError` if Typst is missing or refuses the page."""
    return paper_of([model.plain()]).content


def paper_of(reports: Sequence[dict[str, Any]]) -> Paper:
    """Return several reports, each the plain form of a model, in one PDF, and the letters without a font.

    Raises `OutputError`.
    """
    return pdf_of("report.typ", list(reports))


def pdf_of(template: str, data: Any) -> Paper:
    """Return a template of `reports/` filled with `data` as PDF.

    Raises `OutputError`, or `InputError` if an error is in one of the instructor's own templates.
    """
    refused = RuntimeError(template)
    for standard, everything in WAYS:
        try:
            made = bytes(typeset(template, data, "pdf", standard=standard, everything=everything))
            content = made.replace(SAID, UNSAID.ljust(len(SAID)))  # of the same length, so that all objects keep their places
            return Paper(packed(content), "" if standard else _letters(refused))
        except RuntimeError as error:  # typst.TypstError, which cannot be named before Typst is loaded
            refused = error
            if not _letters(error):
                break
    raise refusal(refused) from refused


def _letters(refused: RuntimeError) -> str:
    """Return the letters, each once, that Typst found in no font, according to its error."""
    return "".join(dict.fromkeys("".join(_MISSING.findall(getattr(refused, "diagnostic", "") or str(refused)))))
