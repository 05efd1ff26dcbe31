"""The paragraphs, tables and formulas of a word processor's file, element by element -> a `Document`.

Enters: starts and ends of elements, text.  Leaves: the filled document.  A table inside a cell is a separate table.
Used by `docx.py`, `odt.py` and `rtf.py`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from coursework.grading.reading.documents.document import MOST_LINES, Document, place_of
from coursework.grading.reading.documents.formulas.formula_text import equations_in, on_one_line
from coursework.grading.reading.documents.signs import plain_signs
from coursework.grading.reading.equations.notation.signs import relates_two_sides
from coursework.grading.reading.files.cells import BlankRows, Cell
from coursework.grading.reading.limits import CELL_CHARACTERS, LINE_CHARACTERS, Room
from coursework.words.sentence import Sentence

_EXPONENT = re.compile(r"[-−–]?\d{1,3}")
HIDDEN = "hidden"  # the position of text that nobody sees


@dataclass(slots=True)
class _Paragraph:
    """Pieces (text, whether it is a formula) in their order; `is_below` is True after an index made by lowering the letters."""

    pieces: list[tuple[str, bool]] = field(default_factory=list)
    length: int = 0
    is_below: bool = False


@dataclass(slots=True)
class _Table:
    """An open table."""

    place: Sentence
    rows: list[list[Cell]] = field(default_factory=list)
    row: list[Cell] = field(default_factory=list)
    cell: list[str] = field(default_factory=list)
    blank: BlankRows = field(default_factory=BlankRows)


class DocumentBuilder:
    """Fills a document; rows and columns beyond the limits are left out."""

    def __init__(self, kind: str, room: Room) -> None:
        self.document = Document(kind)
        self._room = room
        self._paragraphs: list[_Paragraph] = []
        self._tables: list[_Table] = []
        self._number = self._table_number = 0

    @property
    def has_paragraph(self) -> bool:
        """Return whether a paragraph is open."""
        return bool(self._paragraphs)

    def open_paragraph(self) -> None:
        """Begin a paragraph; it may be inside another, as in a text box."""
        self._paragraphs.append(_Paragraph())

    def close_paragraph(self) -> None:
        """End the open paragraph."""
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
        if relates_two_sides(text):
            add_lines(self.document, pieces, table.place)

    def text(self, text: str, position: str = "") -> None:
        """Add text; `position` is "sub" or "super" if it is set lower or higher, `HIDDEN` if it is not shown."""
        if position == HIDDEN:
            return
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
        """Add a formula, with one line per row."""
        self.text(" ")
        self._paragraphs[-1].pieces.append((text[:LINE_CHARACTERS], True))

    def open_table(self) -> None:
        """Begin a table."""
        self._table_number += 1
        self._tables.append(_Table(place_of("table", number=self._table_number)))

    def open_row(self, skipped: int = 0) -> None:
        """Begin a row; its first `skipped` columns are empty."""
        if self._tables:
            self._tables[-1].row = [Cell("")] * min(max(skipped, 0), self._room.columns)

    def close_cell(self, columns: int = 1, continued: bool = False, beside: bool = False) -> None:
        """End a cell and repeat it over its `columns`; with `continued` or `beside` it repeats those above or before."""
        if not self._tables:
            return
        table = self._tables[-1]
        text = on_one_line(plain_signs(" ".join(table.cell)[:CELL_CHARACTERS])).strip()
        at = len(table.row)
        cells = [Cell(text)] * min(columns, self._room.columns - at)
        if continued and not text and table.rows:
            above = table.rows[-1][at : at + len(cells)]
            cells[: len(above)] = above
        if beside and not text and table.row:
            cells = table.row[-1:] * len(cells)
        table.row += cells
        table.cell = []

    def close_row(self, times: int = 1) -> None:
        """End a row and repeat it `times` times."""
        if not self._tables:
            return
        table = self._tables[-1]
        is_blank = not any(cell.text for cell in table.row)
        if not table.blank.too_many(is_blank, times):
            table.rows += [table.row] * min(times, self._room.rows - len(table.rows))
        table.row, table.cell = [], []

    def close_table(self) -> None:
        """End the open table."""
        if self._tables:
            table = self._tables.pop()
            self.document.add_table((row for row in table.rows if any(cell.text for cell in row)), table.place)

    def finished(self) -> Document:
        """Return the document, after closing everything that is still open."""
        while self._tables:
            self.close_cell()
            self.close_row()
            self.close_table()
        while self._paragraphs:
            self.close_paragraph()
        return self.document


def add_lines(document: Document, pieces: list[tuple[str, bool]], place: Sentence) -> None:
    """Add a paragraph: if its formulas have equations, these and the remaining text as separate lines, else one text."""
    formulas = [line for text, is_formula in pieces if is_formula for line in equations_in(text)]
    if any("=" in line for line in formulas):
        for line in formulas:
            document.add_line(line, place, "=" in line)
        pieces = [piece for piece in pieces if not piece[1]]
    only = bool(formulas) and not any(text.strip() for text, is_formula in pieces if not is_formula)
    for line in "".join(on_one_line(text) if is_formula else text for text, is_formula in pieces).split("\n"):
        document.add_line(line, place, only)
