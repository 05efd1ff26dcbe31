"""A Word file -> its tables, paragraphs and native equations, read with `zipfile` and `expat`.

Enters: an `Archive`.  Leaves: `Document`.  Raises `Refused`.  Pictures, macros, embedded objects and other parts are not opened.
Used by `read_document.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.formulas import omml
from coursework.grading.reading.documents.formulas.formula_tree import FormulaTree
from coursework.grading.reading.documents.office.builder import HIDDEN, DocumentBuilder
from coursework.grading.reading.documents.signs import symbol_font
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.xml_events import stream, whole
from coursework.grading.reading.limits import Room

_MAIN = re.compile(r"word/document\d*\.xml")
_SKIPPED = {"Fallback", "del", "moveFrom"}  # copies of other content, and deleted or moved text
_WITH_ATTRIBUTES = {
    "tab", "br", "cr", "gridSpan", "vMerge", "gridBefore", "vertAlign", "vanish", "sym", "begChr", "endChr", "chr", "type",
}  # fmt: skip
_WANTED = dict.fromkeys(omml.ELEMENTS | _SKIPPED | {"p", "tbl", "tr", "tc", "noBreakHyphen"}, False)
_WANTED |= dict.fromkeys(_WITH_ATTRIBUTES, True)
_ONE = (1, False)  # a cell that spans one column and does not continue the one above
_POSITIONS, _OFF = {"superscript": "super", "subscript": "sub"}, {"0", "false", "off"}


def main_part(archive: Archive) -> str | None:
    """Return the name of the part with the text of a Word file, None if the archive is no Word file."""
    return next((name for name in sorted(archive.parts) if _MAIN.fullmatch(name)), None)


def document_of_docx(archive: Archive, part: str, room: Room) -> Document:
    """Return the tables, paragraphs and equations of a Word file."""
    reader = _Reader(DocumentBuilder("docx", room))
    stream(archive.chunks(part), reader, _WANTED)
    return reader.builder.finished()


class _Reader:
    """Handles the elements of `word/document.xml`."""

    def __init__(self, builder: DocumentBuilder) -> None:
        self.builder = builder
        self.formula: FormulaTree | None = None
        self.skipping = self.formulas = 0
        self.is_text = False
        self.position = ""
        self.cells: list[tuple[int, bool]] = []  # per open cell: columns it spans, whether it continues the one above
        # The most frequent elements are looked up here, as a table has a thousand of each.
        self.begins: dict[str, Callable[[], None]] = {
            "t": partial(setattr, self, "is_text", True), "r": partial(setattr, self, "position", ""),
            "p": builder.open_paragraph, "tc": partial(self.cells.append, _ONE), "tr": builder.open_row,
            "tbl": builder.open_table,
        }  # fmt: skip
        self.ends: dict[str, Callable[[], None]] = {
            "t": partial(setattr, self, "is_text", False), "p": builder.close_paragraph, "tc": self._end_cell,
            "tr": builder.close_row, "tbl": builder.close_table,
        }  # fmt: skip

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if self.skipping or self.formula is not None:
            self._begin_inside(name, attributes)
        elif act := self.begins.get(name):
            act()
        elif name in _SKIPPED:
            self.skipping = 1
        elif name == "oMath":
            self.formula, self.formulas = FormulaTree(name), 1
        else:
            self._detail(name, attributes)

    def _begin_inside(self, name: str, attributes: dict[str, str]) -> None:
        """Handle the start of an element inside a formula or inside skipped content."""
        if self.skipping or name in _SKIPPED:
            self.skipping += name in _SKIPPED
        elif self.formula is not None and name in omml.ELEMENTS:
            self.is_text = name == "t"
            self.formulas += name == "oMath"
            self.formula.begin(name, attributes)

    def _detail(self, name: str, attributes: dict[str, str]) -> None:
        value = attributes.get("val", "")
        if name == "vanish" and value not in _OFF:
            self.position = HIDDEN
        elif name == "vertAlign" and self.position != HIDDEN:
            self.position = _POSITIONS.get(value, "")
        elif name == "gridSpan" and self.cells:
            self.cells[-1] = whole(value, 1), self.cells[-1][1]
        elif name == "vMerge" and self.cells:
            self.cells[-1] = self.cells[-1][0], value != "restart"
        elif name == "gridBefore":
            self.builder.open_row(whole(value, 0))
        elif name == "tab" and not attributes:  # with attributes it defines a tab stop
            self.builder.text("\t")
        elif name in {"br", "cr"} and attributes.get("type") is None:
            self.builder.text("\n")
        elif name == "noBreakHyphen":
            self.builder.text("-")
        elif name == "sym":
            self.builder.text(_symbol(attributes))

    def text(self, text: str) -> None:
        if self.is_text and not self.skipping:
            if self.formula is not None:
                self.formula.text(text)
            else:
                self.builder.text(text, self.position)

    def end(self, name: str) -> None:
        if self.skipping or self.formula is not None:
            self._end_inside(name)
        elif act := self.ends.get(name):
            act()

    def _end_inside(self, name: str) -> None:
        if self.skipping:
            self.skipping -= name in _SKIPPED
            return
        assert self.formula is not None
        self.is_text = False
        self.formulas -= name == "oMath"
        if not self.formulas:
            self.builder.formula(omml.text_of_omml(self.formula.top))
            self.formula = None
        elif name in omml.ELEMENTS:
            self.formula.end()

    def _end_cell(self) -> None:
        if self.cells:
            self.builder.close_cell(*self.cells.pop())


def _symbol(attributes: dict[str, str]) -> str:
    """Return the letter of a symbol element, which gives a font and a code."""
    code = attributes.get("char", "")
    if not re.fullmatch("[0-9A-Fa-f]{4}", code):
        return ""
    letter = chr(int(code, 16) & 0xFF) if code.upper().startswith("F0") else chr(int(code, 16))
    return symbol_font(letter) if attributes.get("font", "Symbol") == "Symbol" else letter
