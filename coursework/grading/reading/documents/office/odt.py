"""An OpenDocument text -> its tables, paragraphs and formulas, read with `zipfile` and `expat`.

Enters: an `Archive`.  Leaves: `Document`.  Raises `Refused`.  Of embedded objects only formulas are opened.
Used by `read_document.py`.
"""

from __future__ import annotations

import posixpath

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.formulas import mathml
from coursework.grading.reading.documents.formulas.formula_tree import FormulaTree
from coursework.grading.reading.documents.office.builder import HIDDEN, DocumentBuilder
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.ods import CONTENT, refuse_encrypted
from coursework.grading.reading.files.xml_events import stream, whole
from coursework.grading.reading.limits import Room

_MOST_FORMULAS = 300
_KIND = b"application/vnd.oasis.opendocument.text"
_SKIPPED = {"annotation", "note", "tracked-changes", "image"}  # outside a formula, `annotation` is a comment
_PARAGRAPHS = {"p", "h"}
_CELLS = {"table-cell", "covered-table-cell"}
_WITH_ATTRIBUTES = {
    "table-cell", "covered-table-cell", "table-row", "span", "object", "style", "text-properties", "annotation", "mfenced",
    "mspace", "mfrac",
}  # fmt: skip
_PLAIN = {*_SKIPPED, *_PARAGRAPHS, "s", "tab", "line-break", "table"}
_WANTED = dict.fromkeys(mathml.ELEMENTS | _PLAIN, False) | dict.fromkeys(_WITH_ATTRIBUTES, True)
_FORMULA = {name: name in _WITH_ATTRIBUTES for name in mathml.ELEMENTS}


def is_odt(archive: Archive) -> bool:
    """Return whether an archive is an OpenDocument text."""
    return {CONTENT, "mimetype"} <= archive.parts.keys() and archive.read("mimetype", 1000).strip().startswith(_KIND)


def document_of_odt(archive: Archive, room: Room) -> Document:
    """Return the tables, paragraphs and formulas of an OpenDocument text."""
    refuse_encrypted(archive)
    reader = _Reader(archive, DocumentBuilder("odt", room))
    stream(archive.chunks(CONTENT), reader, _WANTED)
    return reader.builder.finished()


class _Reader:
    """Handles the elements of `content.xml`."""

    def __init__(self, archive: Archive, builder: DocumentBuilder) -> None:
        self.archive, self.builder = archive, builder
        self.formula: FormulaTree | None = None
        self.skipping = self.paragraphs = self.formulas = self.covered = 0  # covered: following cells that the last one covers
        self.style = ""
        self.positions: dict[str, str] = {}  # style name -> "sub", "super" or `HIDDEN`
        self.spans: list[str] = []
        self.cells: list[tuple[str, dict[str, str]]] = []
        self.rows: list[int] = []

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if self.formula is not None:
            if name in mathml.ELEMENTS:
                self.formula.begin(name, attributes)
        elif self.skipping or name in _SKIPPED:
            self.skipping += name in _SKIPPED
        elif name in _PARAGRAPHS:
            self.paragraphs += 1
            self.builder.open_paragraph()
        elif name == "span":
            self.spans.append(self.positions.get(attributes.get("style-name", ""), ""))
        elif name in _CELLS:
            self.cells.append((name, attributes))
        elif name == "table-row":
            self.rows.append(_times(attributes, "number-rows-repeated"))
            self.covered = 0
            self.builder.open_row()
        elif name == "table":
            self.builder.open_table()
        elif name == "math":
            self.formula = FormulaTree(name)
        else:
            self._detail(name, attributes)

    def _detail(self, name: str, attributes: dict[str, str]) -> None:
        if name == "style":
            self.style = attributes.get("name", "")
        elif name == "text-properties":
            height = attributes.get("text-position", "").split(" ")[0]
            position = (
                "sub" if height.startswith(("sub", "-")) else "super" if height.strip("0%") else ""
            )  # "0%" is the usual one
            position = HIDDEN if attributes.get("display") == "none" else position
            if position and len(self.positions) < 1000:
                self.positions[self.style] = position
        elif name == "object" and (href := attributes.get("href")):
            self._object(href)
        elif self.paragraphs and name in {"s", "tab", "line-break"}:
            self.builder.text({"s": " ", "tab": "\t"}.get(name, "\n"))

    def _object(self, href: str) -> None:
        """Read a formula that is stored in a part of its own; other embedded objects are not opened."""
        part = posixpath.normpath(posixpath.join(href.removeprefix("./"), CONTENT))
        self.formulas += 1
        if part in self.archive.parts and part != CONTENT and self.formulas <= _MOST_FORMULAS:
            found = FormulaTree("")
            stream(self.archive.chunks(part), found, _FORMULA)
            if found.top.inside:
                self.builder.formula(mathml.text_of_mathml(found.top))

    def text(self, text: str) -> None:
        if self.formula is not None:
            if text.strip():
                self.formula.text(text)
        elif self.paragraphs and not self.skipping:
            self.builder.text(text, self.spans[-1] if self.spans else "")

    def end(self, name: str) -> None:
        if self.formula is not None:
            if name == "math":
                self.builder.formula(mathml.text_of_mathml(self.formula.top))
                self.formula = None
            else:
                self.formula.end()
        elif self.skipping:
            self.skipping -= name in _SKIPPED
        elif name in _PARAGRAPHS:
            self.paragraphs -= 1
            self.builder.close_paragraph()
        elif name == "span" and self.spans:
            self.spans.pop()
        elif name in _CELLS and self.cells:
            self._close_cell(*self.cells.pop())
        elif name == "table-row" and self.rows:
            self.builder.close_row(self.rows.pop())
        elif name == "table":
            self.builder.close_table()

    def _close_cell(self, name: str, cell: dict[str, str]) -> None:
        """Close a cell; the cells covered by a merged one are there already on its right, and repeat the one above below it."""
        if name == "covered-table-cell":
            repeated = _times(cell, "number-columns-repeated")
            beside = min(self.covered, repeated)
            self.covered -= beside
            if repeated > beside:
                self.builder.close_cell(repeated - beside, continued=True)
            return
        spanned = _times(cell, "number-columns-spanned")
        self.covered = spanned - 1
        self.builder.close_cell(max(spanned, _times(cell, "number-columns-repeated")))


def _times(attributes: dict[str, str], name: str) -> int:
    return min(whole(attributes.get(name), 1), 1000)
