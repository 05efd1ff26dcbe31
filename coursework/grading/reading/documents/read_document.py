"""One file -> the document in it, and its contents: tables on the assigned grid, equations, answers.

Enters: bytes, an `Archive` or a decoded text.  Leaves: `Document`, and its `Table`s and `Lines`.  Raises `Refused`.
Used by `read_submission.py` and `opened.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

from coursework.grading.reading.documents.document import Document, DocumentLine, place_of
from coursework.grading.reading.documents.json_data import document_of_json
from coursework.grading.reading.documents.json_text import is_json
from coursework.grading.reading.documents.markdown import document_of_markdown, is_markdown
from coursework.grading.reading.documents.notebook import document_of_notebook, is_notebook
from coursework.grading.reading.documents.office.docx import document_of_docx, main_part
from coursework.grading.reading.documents.office.odt import document_of_odt, is_odt
from coursework.grading.reading.documents.office.rtf import document_of_rtf, is_rtf
from coursework.grading.reading.documents.page import document_of_latex, document_of_page, has_latex_tables, has_tables
from coursework.grading.reading.documents.pdf.pdf import document_of_pdf, is_pdf
from coursework.grading.reading.equations.formulas.equations import Names, names_for, names_of
from coursework.grading.reading.equations.formulas.names_in_text import BUILT_IN
from coursework.grading.reading.equations.lines import Lines, read_lines
from coursework.grading.reading.equations.notation.signs import ARROW, relates_two_sides
from coursework.grading.reading.expected import Expected, Grid
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import Sheet
from coursework.grading.reading.files.encoding import Decoded
from coursework.grading.reading.files.kinds import is_html
from coursework.grading.reading.limits import Refused, room_for
from coursework.grading.reading.student_work import EquationLine, Table
from coursework.grading.reading.table.parts import Origin, Part, parts_of
from coursework.grading.reading.table.table import read_parts, weight
from coursework.grading.reading.table.tables_of_file import parts_of_text

_MOST_TEXTS = 200
_SAID = re.compile(":|→|->")  # signs before an answer and before what a calculator stores
_CONTINUES = re.compile(r"\s*[-+*/−–&]")
_GOES_ON = re.compile(r"(?:[*·+(]|\s[-−])\s*$|(?:\.{3}|…|\s_|&)\s*$")  # and ends in a later line
_OF_PROGRAM = re.compile(
    r"\s*(?:def\b.*:|return\b|(?:[a-z]{2,9}\s+){0,2}(?:double|float|function|fn|func|subroutine)\s+\w+\s*[(=])"
)
_OPERATION = re.compile(r"[*·×^+]|(?:sin|cos)\b|[)\]]\s*=", re.IGNORECASE)
_WORD = re.compile(r"[^\W\d_]{3,}")
_FEWEST_WORDS = 4  # so many words that are not names make a sentence
_DOTTED = re.compile(r"([^\W\d_])\u0307_?([0-9₀-₉]{0,2})|\\dot\s?\{?\s?\\?([A-Za-z]{1,9})\s?\}{0,2}_?\{?(\d{0,2})")


def document_of_bytes(content: bytes, grid: Grid) -> Document | None:
    """Return the document of an RTF file or a PDF, None for any other file."""
    if is_rtf(content):
        return document_of_rtf(content, room_for(grid.rows))
    return document_of_pdf(content, room_for(grid.rows)) if is_pdf(content) else None


def document_of_archive(archive: Archive, grid: Grid) -> Document | None:
    """Return the document of a Word file or an OpenDocument text, None for any other archive."""
    if part := main_part(archive):
        return document_of_docx(archive, part, room_for(grid.rows))
    return document_of_odt(archive, room_for(grid.rows)) if is_odt(archive) else None


def is_document(archive: Archive) -> bool:
    """Return whether an archive is a Word file or an OpenDocument text."""
    return main_part(archive) is not None or is_odt(archive)


def document_of_text(decoded: Decoded, grid: Grid) -> Document | None:
    """Return the document of a notebook, JSON, HTML or LaTeX with tables, or Markdown; None for any other text."""
    if is_notebook(decoded.text):
        return document_of_notebook(decoded.text, decoded.encoding)
    if is_json(decoded.text):
        return document_of_json(decoded.text, decoded.encoding, room_for(grid.rows))
    if has_latex_tables(decoded.text) or (is_html(decoded.text) and has_tables(decoded.text)):
        kind = document_of_page if is_html(decoded.text) else document_of_latex
        return kind(decoded.text, decoded.encoding, room_for(grid.rows))
    return document_of_markdown(decoded.text, decoded.encoding) if is_markdown(decoded.text) else None


def document_of_sheets(sheets: Sequence[Sheet]) -> Document:
    """Return the text cells of a spreadsheet that may contain an equation or answer, as lines."""
    document = Document("cells")
    for sheet in sheets:
        for number, row in enumerate(sheet.rows, start=1):
            for cell in row:
                for line in cell.text.split("\n") if cell.kind == "text" else ():
                    if ":" in line or relates_two_sides(line):
                        document.add_line(line, place_of("sheet", sheet=sheet.name or "", row=number))
    return document


def tables_of_document(document: Document, name: str, grid: Grid) -> tuple[list[tuple[Part, Table]], Refused | None]:
    """Return the tables read on the grid, and the refusal of the largest unreadable table, None if there is none.

    If a document has no tables of cells, its lines are searched for a table in plain text.
    """
    parts: list[Part] = []
    refused: list[tuple[float, Refused]] = []
    texts = document.texts[:_MOST_TEXTS]
    if not texts and not document.tables and document.lines and not document.is_code:
        texts = [("\n".join(line.text for line in document.lines), document.lines[0].place)]
    todo = [partial(parts_of, one, Origin(name, document.kind, "cells", place=one.place), grid) for one in document.tables]
    todo += [partial(parts_of_text, Decoded(text, document.kind, False), name, grid, place) for text, place in texts]
    for read in todo:
        try:
            parts += read()
        except Refused as error:
            refused.append((0.0, error))
    found = []
    for part, table in read_parts(parts, grid):
        if isinstance(table, Table):
            found.append((part, table))
        else:
            refused.append((weight(part, table, grid), table))
    if document.first_counts:
        found = sorted(found, key=lambda entry: -entry[1].weight)[:1]
    return found, max(refused, key=lambda entry: entry[0])[1] if refused else None


def lines_of_document(document: Document, name: str, expected: Expected) -> Lines:
    """Return the equations and answers of a document; its prose is skipped.

    Lines are numbered in the order of extraction.  As "=" is frequent in a report, a readable line counts as an equation only if
    it names a sought velocity; if it names nothing else, it may be a datum.  An unreadable line counts if it names two symbols of
    the variant and is a formula or names a sought velocity.
    """
    names = names_for(expected)

    def placed(line: EquationLine) -> EquationLine | None:
        at = document.lines[line.line - 1]
        # What only continues, and continues nothing, is the item of a list.
        is_item = not is_program and not at.is_formula and _CONTINUES.match(at.text) and not relates_two_sides(line.text)
        return None if is_item else _placed(line, at, names)

    is_program = document.is_code or any(_OF_PROGRAM.match(line.text) for line in document.lines)
    lines = read_lines("\n".join(_tried(document.lines, is_program)), name, expected, kept=placed)
    if all(line.may_be_datum for line in lines.equations):
        lines.equations = []  # data alone, such as those of a program, are not student equations
    return lines


def _tried(lines: Sequence[DocumentLine], is_program: bool) -> Iterator[str]:
    r"""Yield the lines that may contain an equation, "" for the others; all lines between \begin and \end are kept.

    Where a line is the head of a function or returns something, a formula without a sign of equality may be an equation too.
    """
    depth = 0
    for line in lines:
        begun = depth + line.text.count("\\begin")
        goes_on = _CONTINUES.match(line.text) or (_OPERATION.search(line.text) and _GOES_ON.search(line.text))
        of_program = is_program and (_OPERATION.search(line.text) or _OF_PROGRAM.match(line.text))
        is_one = (
            line.is_formula
            or goes_on
            or of_program
            or _SAID.search(line.text)
            or relates_two_sides(line.text)
            or ARROW in line.text
        )
        yield line.text.replace("\n", " ") if begun > 0 or is_one else ""  # a cell of LaTeX may have several lines
        depth = max(0, begun - line.text.count("\\end"))


def _placed(line: EquationLine, at: DocumentLine, names: Names) -> EquationLine | None:
    """Return an equation with its place, None if the line is no equation."""
    named, sought = names_of(line, names) - {*BUILT_IN}, {*names.expected.variant.sought}
    if line.tree is None:
        if _is_told(line.text, at, names) or _is_of_accelerations(line.text, names):
            return None
        is_one = line.relates and (at.is_formula or bool(named & sought))
        return replace(line, place=at.place) if is_one else None
    return replace(line, place=at.place, may_be_datum=line.may_be_datum or len(named) < 2) if named & sought else None


def _is_told(text: str, at: DocumentLine, names: Names) -> bool:
    """Return whether an unreadable line is a sentence that contains a number: "Find w2 and w3 from t = 0 to 0.6 s"."""
    if at.is_formula or _OPERATION.search(text):
        return False
    return sum(not names.is_name(word) for word in _WORD.findall(text)) >= _FEWEST_WORDS


def _is_of_accelerations(text: str, names: Names) -> bool:
    """Return whether a line has a dot over a velocity, as an equation of accelerations has."""
    dotted = (names.spellings.canonical("".join(part or "" for part in found.groups())) for found in _DOTTED.finditer(text))
    return any(name in names.expected.variant.sought for name in dotted)
