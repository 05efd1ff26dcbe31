"""An HTML page or a LaTeX file with tables -> its tables, the labels of its formulas, its lines of text.

Enters: text.  Leaves: `Document`, or the page with its <math> as text; nothing is executed or fetched.  The time is
proportional to the length of the text.
Used by `read_document.py`, `read_submission.py` and `markdown.py`.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from itertools import islice

from coursework.grading.reading.documents.document import MOST_LINES, MOST_TABLES, Document, place_of
from coursework.grading.reading.documents.formulas.formula_tree import FormulaTree
from coursework.grading.reading.documents.formulas.mathml import text_of_mathml
from coursework.grading.reading.equations.notation.signs import relates_two_sides
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.files.html_text import text_of
from coursework.grading.reading.files.xml_events import stream
from coursework.grading.reading.limits import CELL_CHARACTERS, Refused, Room

_TABLE = re.compile(r"<(/?)table\b[^<>]{0,2000}>", re.IGNORECASE)
# A drawn formula has its source in a label for screen readers or in a script; the mark identifies its line later.
_DRAWN = re.compile(
    r'<[a-z]{1,10}(?= )(?=[^<>]{0,500} role="math")[^<>]{0,500} aria-label="([^"<>]{1,2000})"[^"<>]{0,100}>'
    r'|<script type="math/tex[^"<>]{0,30}">([^<>]{1,2000})</script>'
)
_MARK = "\ue000"
_MOST_ENDS = 4 * MOST_TABLES  # starts and ends of tables
_TABULAR = re.compile(r"\\(begin|end)\s{0,9}\{(?:longtable|tabular[xy]?|supertabular|tblr)\*?\}")
_BODY = "\\begin{document}"
_TYPES = re.compile(r"\s*(?:\[[^\]]{0,20}\]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})")  # placement, width and columns
_ROW_END = re.compile(r"\\\\(?:\s{0,9}\[[^\]]{0,20}\])?|\\tabularnewline\b")
_MOST_TYPES, _TYPES_WITHIN = 3, 2000
_CELL_END = re.compile(r"(?<!\\)&")
_RULES = re.compile(
    r"\\(?:(?:top|mid|bottom|h)(?:rule|line)|c(?:mid)?rule|noalign|end(?:first|last)?(?:head|foot))\b(?:\{[^{}]{0,40}\})?"
)
_PER = re.compile(r"\\per(?![A-Za-z])\s*")
_TIMES = re.compile(r"\\(?:cdot|times)(?![A-Za-z])")
_MARKUP = re.compile(
    r"\\(?:num|ang|tablenum|SI|qty|si|unit|multi(?:column|row)\s*\{\d{1,3}\}\s*\{[^{}]{0,40}\})(?=\s*[{\[])"
    r"|\\(?:row|cell)color\s*(?:\[[^\]]{0,20}\])?\{[^{}]{0,40}\}|\\[()]|\$|\\(?:textbf|textit|emph|mathbf|mathrm|text|bm)\b"
    r"|[{}]|\\(?=[A-Za-z]{2,9}\b)|\\[,;:! ]|~"
)

_CELL = re.compile(r"<t[dh]\b[^<>]{0,2000}>", re.IGNORECASE)
_SPANS = re.compile(r"\b((?:col|row)span)\s*=\s*[\"']?([1-9]\d{0,2})\b", re.IGNORECASE)
_SPAN = re.compile(rf"\s*{_MARK}(\d+),(\d+){_MARK}")
_FORMULA = re.compile(r"<((?:\w{1,9}:)?math)\b[^<>]{0,500}>(?:[^<]|<(?!/?\1\b))*+</\1\s*>", re.IGNORECASE)
_SOURCE = re.compile(r"<annotation\b[^<>]{0,200}x-tex[^<>]{0,200}>([^<]{1,4000})</annotation\s*>", re.IGNORECASE)
_DISPLAY = re.compile(r"<[^<>]{0,500}\bdisplay\s*=\s*[\"']block", re.IGNORECASE)  # a formula in a line of its own
_ENTITY = re.compile(r"&(?!(?:lt|gt|amp|quot|apos);)([A-Za-z]\w{1,30});")
_HIDDEN = re.compile(r"(?:\s|</span>)*(?=<span\b[^<>]{0,300}(?:katex-html|aria-hidden)[^<>]{0,300}>)", re.IGNORECASE)
_DRAWN_SPAN = re.compile(r"<(/?)span\b[^<>]{0,2000}>", re.IGNORECASE)
_MOST_FORMULAS, _MOST_SPANS = 400, 2000  # formulas of a page, spans that draw one


def has_tables(text: str) -> bool:
    """Return whether a text contains tables of HTML."""
    return _TABLE.search(text) is not None


def has_latex_tables(text: str) -> bool:
    """Return whether a text contains tables of LaTeX."""
    return _TABULAR.search(text) is not None


def document_of_page(text: str, kind: str, room: Room) -> Document:
    """Return the tables and lines of an HTML page; a table inside another is a separate table."""
    document = Document(kind, is_whole=False)
    marked = _DRAWN.sub(lambda found: f"<p>{_MARK}{found[1] or found[2]}</p>", text)
    for piece, is_table, _ in pieces_of(marked):
        if is_table:
            add_table(document, piece, room)
        else:
            _add_text(document, piece)
    return document


def pieces_of(text: str) -> Iterator[tuple[str, bool, int]]:
    """Yield what stands inside and outside the tables of a page: text, whether it is a table, number of line breaks before it."""
    depth = end = lines = 0
    for found in (*islice(_TABLE.finditer(text), _MOST_ENDS), None):
        piece = text[end : found.start() if found else len(text)]
        yield piece, depth > 0 and found is not None, lines
        if found:
            lines += piece.count("\n") + found[0].count("\n")
            depth, end = max(0, depth - 1) if found[1] else depth + 1, found.end()


def _spanned(rows: list[list[str]], columns: int) -> list[list[str]]:
    """Return the rows with each cell repeated in all columns and rows that it spans."""
    out: list[list[str]] = []
    below: dict[int, tuple[int, str]] = {}  # column -> (number of further rows, text that spans them)
    for row in rows:
        cells: list[str] = []
        for text in (*row, None):
            while (at := len(cells)) in below:  # which has no column beyond the last
                left, above = below.pop(at)
                cells.append(above)
                if left > 1:
                    below[at] = (left - 1, above)
            if text is None:
                break
            found = _SPAN.match(text)
            wide, high = (int(found[1]), int(found[2])) if found else (1, 1)
            text = text[found.end() :] if found else text
            for _ in range(min(wide, columns - len(cells))):
                if high > 1:
                    below[len(cells)] = (high - 1, text)
                cells.append(text)
        out.append(cells[:columns])
    return out


def _span_mark(found: re.Match[str]) -> str:
    spans = {name.lower(): number for name, number in _SPANS.findall(found[0])}
    return f"{found[0]}{_MARK}{spans.get('colspan', 1)},{spans.get('rowspan', 1)}{_MARK}" if spans else found[0]


def add_table(document: Document, piece: str, room: Room) -> None:
    """Add the table whose cells and rows a piece of a page holds."""
    lines = text_of(_CELL.sub(_span_mark, piece)).split("\n")
    rows = _spanned([line.split("\t")[: room.columns] for line in lines if line.strip()][: room.rows], room.columns)
    place = place_of("table", number=min(len(document.tables) + 1, MOST_TABLES))
    document.add_table([[Cell(text.strip()[:CELL_CHARACTERS]) for text in row] for row in rows], place)
    for text in (text for line in lines for text in line.split("\t") if relates_two_sides(text)):
        document.add_line(text.replace(_MARK, ""), place, _MARK in text)


def _add_text(document: Document, piece: str) -> None:
    for line in text_of(piece).split("\n"):
        plain = html.unescape(line).strip()
        document.add_line(plain.replace(_MARK, ""), place_of("line", line=len(document.lines) + 1), plain.startswith(_MARK))


def document_of_latex(text: str, kind: str, room: Room) -> Document:
    """Return the tables of a LaTeX file and the lines of its body outside the tables."""
    document = Document(kind, is_whole=False)
    end = text.find(_BODY) + len(_BODY) if _BODY in text else 0
    number, is_table = text.count("\n", 0, end) + 1, False
    for found in (*islice(_TABULAR.finditer(text, end), _MOST_ENDS), None):
        piece = text[end : found.start() if found else len(text)].replace("\\end{document}", "")
        if is_table:
            document.add_table(_rows(piece, room), place_of("line", line=number))
            _add_formulas(document, piece, number)
        else:
            for line, content in enumerate(piece.split("\n", MOST_LINES)[:MOST_LINES], start=number):
                document.add_line(content, place_of("line", line=line))
        number += piece.count("\n")
        if found:
            is_table, end = found[1] == "begin", found.end()
    return document


def _add_formulas(document: Document, body: str, number: int) -> None:
    """Add the cells with a sign of equality as lines; the body begins in line `number`."""
    for row in _ROW_END.split(body, maxsplit=MOST_LINES)[:MOST_LINES]:
        for cell in _CELL_END.split(_RULES.sub(" ", row)):
            if relates_two_sides(cell):
                document.add_line(cell, place_of("line", line=number + cell[: len(cell) - len(cell.lstrip())].count("\n")))
            number += cell.count("\n")


def _rows(body: str, room: Room) -> list[list[Cell]]:
    """Return the rows of a table's body."""
    for _ in range(_MOST_TYPES):
        found = _TYPES.match(body, 0, _TYPES_WITHIN)
        body = body[found.end() :] if found else body
    lines = [_RULES.sub(" ", line) for line in _ROW_END.split(body, maxsplit=room.rows)[: room.rows]]
    cut = [_CELL_END.split(line, maxsplit=room.columns)[: room.columns] for line in lines]
    return [
        [Cell(" ".join(_MARKUP.sub("", _TIMES.sub("·", _PER.sub("/", cell))).split())[:CELL_CHARACTERS]) for cell in row]
        for row in cut
        if len(row) > 1
    ]


def with_formulas(page: str) -> str:
    """Return a page with its formulas as text.

    >>> with_formulas("<p><math><msub><mi>w</mi><mn>3</mn></msub><mo>=</mo><mfrac><mi>a</mi><mn>2</mn></mfrac></math></p>")
    '<p> w_3 = ((a)/(2)) </p>'
    """
    pieces: list[str] = []
    end = 0
    for number, found in enumerate(_FORMULA.finditer(page)):
        if number >= _MOST_FORMULAS:
            break
        if found.start() >= end:
            pieces += [page[end : found.start()], _said(found[0])]
            end = _behind_drawing(page, found.end())
    return "".join([*pieces, page[end:]])


def _said(formula: str) -> str:
    apart = "<br>" if _DISPLAY.match(formula) else " "
    if source := _SOURCE.search(formula):
        return apart + " ".join(source[1].split()) + apart
    tree = FormulaTree("math")
    try:
        stream([_ENTITY.sub(lambda found: html.unescape(found[0]), formula).encode()], tree)
    except Refused:
        return formula
    lines = (" ".join(line.split()) for line in text_of_mathml(tree.top).split("\n"))
    return apart + "<br>".join(html.escape(line, quote=False) for line in lines) + apart


def _behind_drawing(page: str, end: int) -> int:
    """Return the place behind the drawing of a formula, which KaTeX sets beside it in a span that is hidden from readers."""
    begun = _HIDDEN.match(page, end)
    depth = 0
    for span in islice(_DRAWN_SPAN.finditer(page, begun.end()), _MOST_SPANS) if begun else ():
        depth += -1 if span[1] else 1
        if depth == 0:
            return span.end()
    return end
