"""Paragraphs, tables and formulas as a word processor's file meets them -> a `Document`.

Enters: what begins and ends, text.  Leaves: the document, filled.  A table inside a cell is a table of its own.
Used by `docx.py`, `odt.py` and `rtf.py`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from coursework.grading.reading.documents.document import MOST_LINES, Document, place_of
from coursework.grading.reading.documents.formulas.formula_text import equations_in, on_one_line
from coursework.grading.reading.documents.signs import plain_signs
from coursework.grading.reading.files.cells import BlankRows, Cell
from coursework.grading.reading.limits import CELL_CHARACTERS, LINE_CHARACTERS
from coursework.words.sentence import Sentence

_EXPONENT = re.compile(r"[-−–]?\d{1,3}")


@dataclass(slots=True)
class _Paragraph:
    """Pieces of text and formulas in their order; `is_below` after an index that was only set lower."""

    pieces: list[tuple[str, bool]] = field(default_factory=list)
    length: int = 0
    is_below: bool = False


@dataclass(slots=True)
class _Table:
    """A table that is open."""

    place: Sentence
    rows: list[list[Cell]] = field(default_factory=list)
    row: list[Cell] = field(default_factory=list)
    cell: list[str] = field(default_factory=list)
    blank: BlankRows = field(default_factory=BlankRows)


class DocumentBuilder:
    """Fills a document; rows and columns beyond the bounds are left out."""

    def __init__(self, kind: str, most_rows: int, most_columns: int) -> None:
        self.document = Document(kind)
        self._most_rows, self._most_columns = most_rows, most_columns
        self._paragraphs: list[_Paragraph] = []
        self._tables: list[_Table] = []
        self._number = self._table_number = 0

    @property
    def has_paragraph(self) -> bool:
        """Return whether a paragraph is open."""
        return bool(self._paragraphs)

    def open_paragraph(self) -> None:
        """Begin a paragraph, perhaps one of a text box inside another."""
        self._paragraphs.append(_Paragraph())

    def close_paragraph(self) -> None:
        """End the paragraph that is open."""
        if not self._paragraphs:
            return
        pieces = self._paragraphs.pop().pieces
        if not pieces:
            return
        if not self._tables:
            self._number += 1
            if self._number > MOST_LINES:
                return
            add_lines(self.document, pieces, place_of("paragraph", number=self._number))
            return
        table = self._tables[-1]
        text = "".join([text for text, _ in pieces])
        table.cell.append(text)
        if "=" in text:
            add_lines(self.document, pieces, table.place)

    def text(self, text: str, position: str = "") -> None:
        """Add text; `position` is "sub" or "super" where it is set lower or higher."""
        if not self._paragraphs:
            self.open_paragraph()
        paragraph = self._paragraphs[-1]
        paragraph.length += len(text)
        if not text or paragraph.length > LINE_CHARACTERS:
            return
        if position == "super" and _EXPONENT.fullmatch(text.strip()):
            text = f"^{text.strip()}"
        elif paragraph.is_below and position != "sub" and text[0].isalnum():
            text = f" {text}"
        paragraph.is_below = position == "sub"
        paragraph.pieces.append((text, False))

    def formula(self, text: str) -> None:
        """Add a formula, its rows apart."""
        self.text(" ")
        self._paragraphs[-1].pieces.append((text[:LINE_CHARACTERS], True))

    def open_table(self) -> None:
        """Begin a table."""
        self._table_number += 1
        self._tables.append(_Table(place_of("table", number=self._table_number)))

    def open_row(self, skipped: int = 0) -> None:
        """Begin a row; the first `skipped` columns are left free."""
        if self._tables:
            self._tables[-1].row = [Cell("")] * min(max(skipped, 0), self._most_columns)

    def close_cell(self, columns: int = 1, continued: bool = False, beside: bool = False) -> None:
        """End a cell: it is repeated over the `columns` it spans, and is the one above or beside it where that goes on."""
        if not self._tables:
            return
        table = self._tables[-1]
        text = on_one_line(plain_signs(" ".join(table.cell)[:CELL_CHARACTERS])).strip()
        at = len(table.row)
        cell = Cell(text)
        if continued and not text and table.rows and at < len(table.rows[-1]):
            cell = table.rows[-1][at]
        if beside and not text and table.row:
            cell = table.row[-1]
        table.row += [cell] * min(columns, self._most_columns - at)
        table.cell = []

    def close_row(self, times: int = 1) -> None:
        """End a row, which may stand there several times."""
        if not self._tables:
            return
        table = self._tables[-1]
        is_blank = not any(cell.text for cell in table.row)
        if not table.blank.too_many(is_blank, times):
            table.rows += [table.row] * min(times, self._most_rows - len(table.rows))
        table.row, table.cell = [], []

    def close_table(self) -> None:
        """End the table that is open."""
        if self._tables:
            table = self._tables.pop()
            self.document.add_table((row for row in table.rows if any(cell.text for cell in row)), table.place)

    def finished(self) -> Document:
        """Return the document, with what was still open."""
        while self._tables:
            self.close_cell()
            self.close_row()
            self.close_table()
        while self._paragraphs:
            self.close_paragraph()
        return self.document


def add_lines(document: Document, pieces: list[tuple[str, bool]], place: Sentence) -> None:
    """Add a paragraph's lines: each equation in it that stands as a formula, and what is left; else all of it as one text."""
    formulas = [line for text, is_formula in pieces if is_formula for line in equations_in(text)]
    if any("=" in line for line in formulas):
        for line in formulas:
            document.add_line(line, place, "=" in line)
        pieces = [piece for piece in pieces if not piece[1]]
    only = bool(formulas) and not any(text.strip() for text, is_formula in pieces if not is_formula)
    for line in "".join(on_one_line(text) if is_formula else text for text, is_formula in pieces).split("\n"):
        document.add_line(line, place, only)
