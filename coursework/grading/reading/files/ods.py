"""An ods file -> its sheets, read with `zipfile` and `expat`; repeated rows and cells are limited.

Enters: an `Archive`.  Leaves: `Sheet`s.  Raises `Refused`.
Used by `tables_of_file.py` and, for what is common to all OpenDocument files, `odt.py` and `read_submission.py`.
"""

from __future__ import annotations

from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import BlankRows, Cell, Sheet
from coursework.grading.reading.files.xml_events import Enough, stream, whole
from coursework.grading.reading.limits import CELL_CHARACTERS, SHEETS, Room, unreadable

CONTENT = "content.xml"
_MANIFEST = "META-INF/manifest.xml"
_NUMBERS = {"float", "percentage", "currency"}


def sheets_of(archive: Archive, room: Room) -> list[Sheet]:
    """Return the sheets of a spreadsheet, at most `SHEETS`; cells beyond the `room` are left out."""
    refuse_encrypted(archive)
    reader = _Reader(room)
    stream(archive.chunks(CONTENT), reader)
    return reader.sheets


def refuse_encrypted(archive: Archive) -> None:
    """Raise `Refused` if a document is protected by a password."""
    if _MANIFEST in archive.parts and b"encryption-data" in archive.read(_MANIFEST, 1024 * 1024):
        raise unreadable("password")


class _Reader:
    """Collects the rows of the sheets; a repeated row or cell is written out up to the limits."""

    def __init__(self, room: Room) -> None:
        self.room = room
        self.sheets: list[Sheet] = []
        self.name = ""
        self.rows: list[tuple[Cell, ...]] = []
        self.row: list[Cell] = []
        self.cell: dict[str, str] = {}
        self.text_of_cell: list[str] = []
        self.repeats = self.paragraphs = self.depth = 0
        self.is_inside = self.is_full = False
        self.blank = BlankRows()

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if name == "table":
            self.depth += 1
            if self.depth == 1:
                self.name, self.rows, self.is_full, self.blank = attributes.get("name", ""), [], False, BlankRows()
        elif name == "table-row":
            self.row, self.repeats = [], whole(attributes.get("number-rows-repeated"), 1)
        elif name in {"table-cell", "covered-table-cell"}:
            self.cell, self.text_of_cell, self.paragraphs, self.is_inside = attributes, [], 0, True
        elif name == "p" and self.is_inside:
            self.paragraphs += 1
            if self.paragraphs > 1:
                self.text_of_cell.append(" ")
        elif name == "annotation":
            self.is_inside = False

    def text(self, text: str) -> None:
        if self.is_inside and self.paragraphs and len(self.text_of_cell) < CELL_CHARACTERS:
            self.text_of_cell.append(text[:CELL_CHARACTERS])

    def end(self, name: str) -> None:
        if name in {"table-cell", "covered-table-cell"}:
            self.is_inside = False
            times = min(whole(self.cell.get("number-columns-repeated"), 1), self.room.columns - len(self.row))
            self.row += [self._cell()] * max(times, 0)
        elif name == "annotation":
            self.is_inside = True
        elif name == "table-row" and self.depth == 1 and not self.is_full:
            self._add_row()
        elif name == "table":
            self.depth -= 1
            if self.depth == 0:
                self.sheets.append(Sheet(self.name, tuple(self.rows)))
                if len(self.sheets) >= SHEETS:
                    raise Enough

    def _add_row(self) -> None:
        while self.row and not self.row[-1].text and self.row[-1].kind == "text":
            self.row.pop()
        between = self.blank.seen  # blank rows are kept only if a filled row follows them
        self.is_full = self.blank.too_many(not self.row, self.repeats)
        if self.row:
            rows = [()] * between + [tuple(self.row)] * min(self.repeats, self.room.rows)
            self.rows += rows[: self.room.rows - len(self.rows)]
            self.is_full = len(self.rows) >= self.room.rows

    def _cell(self) -> Cell:
        text = "".join(self.text_of_cell)[:CELL_CHARACTERS].strip()
        kind, value = self.cell.get("value-type", ""), self.cell.get("value", "")
        if kind in _NUMBERS and value:
            return Cell(value[:CELL_CHARACTERS], "number")
        if kind in {"date", "time"}:
            return Cell(text, "date")
        if self.cell.get("formula") and not kind and not text:
            return Cell("", "formula")
        return Cell(text)
