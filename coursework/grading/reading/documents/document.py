"""The content extracted from a document before it is interpreted: tables of cells and lines of text, each with its place.

Enters: nothing.  Leaves: `Document`, `DocumentLine`, limited in size while they are filled.
Used by the readers of this room.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from coursework.grading.reading.documents.signs import plain_signs
from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.limits import LINE_CHARACTERS
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Kinds of formatted documents, with their names for people.
FORMATTED = {"docx": "Word", "odt": "OpenDocument text", "rtf": "RTF", "pdf": "PDF"}
MOST_TABLES, MOST_LINES, MOST_CELLS = 100, 20_000, 100_000
MOST_CHARACTERS = 4_000_000  # of all lines together


def place_of(kind: str, /, **values: object) -> Sentence:
    """Return the description of a place, for a person; its key is `reading.place.<kind>`."""
    return say(f"reading.place.{kind}", **values)


@frozen
class DocumentLine:
    """One line of text; `is_formula` is True if the document marks it as a formula."""

    text: str
    place: Sentence
    is_formula: bool = False


@dataclass(slots=True)
class Document:
    """Tables and lines in the order in which they are read; `kind` is the encoding in grades.json.

    `texts` are pieces of plain text that may contain a table.  With `first_counts`, the first of several tables with equally many
    cells is used.  `is_whole` is False if the text may contain a table without any markup; `is_code` if
    the lines are those of a program, which hold no table.
    """

    kind: str
    tables: list[Sheet] = field(default_factory=list)
    lines: list[DocumentLine] = field(default_factory=list)
    texts: list[tuple[str, Sentence]] = field(default_factory=list)
    first_counts: bool = False
    is_whole: bool = True
    is_code: bool = False
    characters: int = 0
    cells: int = 0

    def add_line(self, text: str, place: Sentence, is_formula: bool = False) -> None:
        """Add a line unless it is blank or the document already has the most lines or characters allowed."""
        text = plain_signs(text[:LINE_CHARACTERS]).replace("{,}", ",").strip()
        self.characters += len(text)
        if text and len(self.lines) < MOST_LINES and self.characters <= MOST_CHARACTERS:
            self.lines.append(DocumentLine(text, place, is_formula))

    def add_table(self, rows: Iterable[Sequence[Cell]], place: Sentence) -> None:
        """Add a table with at least two columns; a single row is kept too, as it may continue the table before it."""
        kept = tuple(tuple(row) for row in rows)
        self.cells += sum(map(len, kept))
        if max(map(len, kept), default=0) > 1 and len(self.tables) < MOST_TABLES and self.cells <= MOST_CELLS:
            self.tables.append(Sheet(None, kept, place))
