"""An xlsx file -> its sheets, read with `zipfile` and `expat` within limits.

Enters: an `Archive`.  Leaves: an iterator over `Sheet`s in the order of the workbook.  Raises `Refused`.
Used by `tables_of_file.py`.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Literal

from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import BlankRows, Cell, Sheet
from coursework.grading.reading.files.xml_events import Enough, stream, whole
from coursework.grading.reading.limits import CELL_CHARACTERS, SHEETS, Room

WORKBOOK = "xl/workbook.xml"
_MOST_ELEMENTS = 10_000
_PLACE = re.compile(r"([A-Z]{1,3})([0-9]{1,7})")
_DATES = {*range(14, 23), *range(27, 37), *range(45, 48), *range(50, 59)}  # numbers of the built-in date formats
_KINDS: dict[str, Literal["number", "error", "date"]] = {"n": "number", "e": "error", "d": "date"}


def sheets_of(archive: Archive, room: Room) -> Iterator[Sheet]:
    """Yield the sheets of a workbook, at most `SHEETS`; cells beyond the `room` are left out."""
    related = _attributes(archive, "xl/_rels/workbook.xml.rels", {"Relationship"})
    targets = {found.get("Id", ""): posixpath.join("/xl", found.get("Target", "")) for _, found in related}
    for _, found in _attributes(archive, WORKBOOK, {"sheet"})[:SHEETS]:
        part = posixpath.normpath(targets.get(found.get("id", ""), "")).lstrip("/")
        if part not in archive.parts:
            continue
        reader = _SheetReader(room)
        stream(archive.chunks(part), reader)
        yield Sheet(found.get("name", ""), _resolved(archive, reader))


def _resolved(archive: Archive, reader: _SheetReader) -> tuple[tuple[Cell, ...], ...]:
    """Return the rows with shared texts filled in and cells in date formats marked as dates."""
    wanted = {
        int(cell.text) for row in reader.rows.values() for cell, kind, _ in row.values() if kind == "s" and cell.text.isdecimal()
    }
    texts = _shared(archive, wanted) if wanted else {}
    styles = {style for row in reader.rows.values() for _, kind, style in row.values() if style and kind == "n"}
    dates = _date_styles(archive) if styles else set()
    rows: list[tuple[Cell, ...]] = []
    for number in range(1, max(reader.rows, default=0) + 1):
        row = reader.rows.get(number, {})
        cells = [Cell("")] * (max(row, default=0))
        for place, (cell, kind, style) in row.items():
            if kind == "s":
                cells[place - 1] = Cell(texts.get(int(cell.text), "") if cell.text.isdecimal() else "")
            elif kind == "n" and style in dates and cell.kind == "number":
                cells[place - 1] = Cell(cell.text, "date")
            else:
                cells[place - 1] = cell
        rows.append(tuple(cells))
    return tuple(rows)


def _attributes(archive: Archive, part: str, wanted: set[str]) -> list[tuple[str, dict[str, str]]]:
    """Return (name, attributes) of the elements of a part whose names are `wanted`; empty if there is no such part."""
    reader = _Attributes(wanted)
    if part in archive.parts:
        stream(archive.chunks(part), reader)
    return reader.found


class _Attributes:
    """Collects the attributes of the elements whose names are `wanted`."""

    def __init__(self, wanted: set[str]) -> None:
        self.wanted = wanted
        self.found: list[tuple[str, dict[str, str]]] = []

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if name in self.wanted:
            self.found.append((name, attributes))
            if len(self.found) > _MOST_ELEMENTS:
                raise Enough

    def end(self, name: str) -> None:
        pass

    def text(self, text: str) -> None:
        pass


class _SheetReader:
    """Collects the cells of one sheet by row and column (from 1): the cell, its type (s, n …) and its style."""

    def __init__(self, room: Room) -> None:
        self.room = room
        self.rows: dict[int, dict[int, tuple[Cell, str, int]]] = {}
        self.blank = BlankRows()
        self.row = self.column = self.style = 0
        self.type = "n"
        self.is_formula = self.is_open = False
        self.value: list[str] = []
        self.length = 0

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if name == "row":
            self.row = whole(attributes.get("r"), self.row + 1)
            self.column = 0
            if self.row > self.room.rows:
                raise Enough
        elif name == "c":
            place = _PLACE.fullmatch(attributes.get("r", ""))
            self.column = _column(place[1]) if place else self.column + 1
            self.type, self.style = attributes.get("t", "n"), whole(attributes.get("s"), 0)
            self.is_formula, self.value, self.length = False, [], 0
        elif name == "f":
            self.is_formula = True
        elif name in {"v", "t"}:
            self.is_open = True

    def text(self, text: str) -> None:
        if self.is_open and self.length < CELL_CHARACTERS:
            self.value.append(text[:CELL_CHARACTERS])
            self.length += len(text)

    def end(self, name: str) -> None:
        if name in {"v", "t"}:
            self.is_open = False
        elif name == "c" and 0 < self.column <= self.room.columns and self.row > 0:
            text = "".join(self.value)
            if text or self.is_formula:
                self.rows.setdefault(self.row, {})[self.column] = _cell(text, self.type, self.is_formula), self.type, self.style
        elif (name == "row" and self.blank.too_many(self.row not in self.rows)) or name == "sheetData":
            raise Enough


def _cell(text: str, kind: str, is_formula: bool) -> Cell:
    if not text and is_formula and kind != "str":
        return Cell("", "formula")
    return Cell(text, _KINDS.get(kind, "text"))


@lru_cache(maxsize=64)
def _column(letters: str) -> int:
    number = 0
    for letter in letters:
        number = 26 * number + ord(letter) - 64
    return number


class _SharedTexts:
    """Collects the shared texts of a workbook with the `wanted` numbers; the pieces of rich text are joined."""

    def __init__(self, wanted: set[int]) -> None:
        self.wanted = wanted
        self.last = max(wanted)
        self.found: dict[int, str] = {}
        self.number = -1
        self.is_open = False
        self.phonetic = 0

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if name == "si":
            self.number += 1
            if self.number > self.last:
                raise Enough
        self.phonetic += name == "rPh"
        self.is_open = name == "t" and not self.phonetic

    def text(self, text: str) -> None:
        if self.is_open and self.number in self.wanted:
            self.found[self.number] = (self.found.get(self.number, "") + text)[:CELL_CHARACTERS]

    def end(self, name: str) -> None:
        self.phonetic -= name == "rPh"
        self.is_open = False


def _shared(archive: Archive, wanted: set[int]) -> dict[int, str]:
    part = next((name for name in archive.parts if name.lower() == "xl/sharedstrings.xml"), None)
    if part is None:
        return {}
    reader = _SharedTexts(wanted)
    stream(archive.chunks(part), reader)
    return reader.found


def _date_styles(archive: Archive) -> set[int]:
    """Return the cell styles that show a number as a date."""
    dates, formats, is_inside = {*_DATES}, list[int](), False
    for name, found in _attributes(archive, "xl/styles.xml", {"numFmt", "cellXfs", "xf", "cellStyles"}):
        number = whole(found.get("numFmtId"), -1)
        # Letters in colours, quoted words and currencies do not make a date format.
        code = re.sub(r'"[^"]*"|\[[^\]]*\]|\\.', "", found.get("formatCode", "")[:500]).lower()
        if name == "numFmt" and re.search("[dmyh]", code) and "general" not in code:
            dates.add(number)
        elif name == "xf" and is_inside:
            formats.append(number)
        elif name in {"cellXfs", "cellStyles"}:  # only the formats between these two are cell styles
            is_inside = name == "cellXfs"
    return {style for style, number in enumerate(formats) if number in dates}
