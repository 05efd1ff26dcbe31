"""The formulas of an HTML page, <math>…</math> as browsers, KaTeX and ChatGPT keep them -> text in their place.

Enters: a page as text.  Leaves: the page; a formula that is damaged or refused stays as it was.  Nothing is fetched.
Used by `read_submission.py`.
"""

from __future__ import annotations

import html
import re
from itertools import islice

from coursework.grading.reading.documents.formulas.formula_tree import FormulaTree
from coursework.grading.reading.documents.formulas.mathml import text_of_mathml
from coursework.grading.reading.files.xml_events import stream
from coursework.grading.reading.limits import Refused

_FORMULA = re.compile(r"<((?:\w{1,9}:)?math)\b[^<>]{0,500}>(?:[^<]|<(?!/?\1\b))*+</\1\s*>", re.IGNORECASE)
_SOURCE = re.compile(r"<annotation\b[^<>]{0,200}x-tex[^<>]{0,200}>([^<]{1,4000})</annotation\s*>", re.IGNORECASE)
_ENTITY = re.compile(r"&(?!(?:lt|gt|amp|quot|apos);)([A-Za-z]\w{1,30});")
_HIDDEN = re.compile(r"(?:\s|</span>)*(?=<span\b[^<>]{0,300}(?:katex-html|aria-hidden)[^<>]{0,300}>)", re.IGNORECASE)
_SPAN = re.compile(r"<(/?)span\b[^<>]{0,2000}>", re.IGNORECASE)
_MOST, _MOST_SPANS = 400, 2000  # formulas of a page, spans that draw one


def with_formulas(page: str) -> str:
    """Return a page with its formulas as text.

    >>> with_formulas("<p><math><msub><mi>w</mi><mn>3</mn></msub><mo>=</mo><mfrac><mi>a</mi><mn>2</mn></mfrac></math></p>")
    '<p> w_3 = ((a)/(2)) </p>'
    """
    pieces: list[str] = []
    end = 0
    for found in islice(_FORMULA.finditer(page), _MOST):
        if found.start() >= end:
            pieces += [page[end : found.start()], _said(found[0])]
            end = _behind_drawing(page, found.end())
    return "".join([*pieces, page[end:]])


def _said(formula: str) -> str:
    if source := _SOURCE.search(formula):
        return f" {' '.join(source[1].split())} "
    tree = FormulaTree("math")
    try:
        stream([_ENTITY.sub(lambda found: html.unescape(found[0]), formula).encode()], tree)
    except Refused:
        return formula
    lines = (" ".join(line.split()) for line in text_of_mathml(tree.top).split("\n"))
    return f" {'<br>'.join(html.escape(line, quote=False) for line in lines)} "


def _behind_drawing(page: str, end: int) -> int:
    """Return the place behind the drawing of a formula, which KaTeX sets beside it in a span that is hidden from readers."""
    begun = _HIDDEN.match(page, end)
    depth = 0
    for span in islice(_SPAN.finditer(page, begun.end()), _MOST_SPANS) if begun else ():
        depth += -1 if span[1] else 1
        if depth == 0:
            return span.end()
    return end
