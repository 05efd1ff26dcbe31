"""The ways to a PDF: with the page's own faces, with every face, and without its structure where a letter has no face at all."""

import pytest

from coursework.report.pages import pdf
from coursework.words.errors import CourseworkError

MISSING = RuntimeError('the text `"𓀀"` could not be displayed')


def made(monkeypatch, refusals):
    """Return the ways that were tried and the letters told as missing where Typst refuses the first ways so."""
    tried, left = [], list(refusals)

    def typeset(template, data, kind, *, standard, everything):
        tried.append((standard, everything))
        if left:
            raise left.pop(0)
        return b"%PDF"

    monkeypatch.setattr(pdf, "typeset", typeset)
    monkeypatch.setattr(pdf, "packed", lambda content: content)
    try:
        return tried, pdf.pdf_of("report.typ", []).missing
    except CourseworkError:
        return tried, None


@pytest.mark.parametrize(
    ("refusals", "tried", "missing"),
    [
        ([], [("ua-1", False)], ""),
        ([MISSING], [("ua-1", False), ("ua-1", True)], ""),
        ([MISSING] * 2, [("ua-1", False), ("ua-1", True), (None, True)], "𓀀"),
        ([MISSING] * 3, [("ua-1", False), ("ua-1", True), (None, True)], None),
        ([RuntimeError("unknown variable")], [("ua-1", False)], None),
    ],
)
def test_a_letter_without_a_face_is_looked_for_in_every_face_and_then_told(monkeypatch, refusals, tried, missing):
    assert made(monkeypatch, refusals) == (tried, missing)
