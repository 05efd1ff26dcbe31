"""The rows of a sheet before they are interpreted.

Enters: nothing.  Leaves: `Cell`, `Sheet`.  Used by the readers of this room.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from coursework.grading.reading.limits import BLANK_ROWS
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence


class Cell(NamedTuple):
    """One cell as in the file; a "number" was stored by a spreadsheet, a "formula" was never computed."""

    text: str
    kind: Literal["text", "number", "formula", "error", "date"] = "text"


@frozen
class Sheet:
    """Rows of cells, of different lengths; `name` is that of a spreadsheet's sheet, `place` that of a table in a document."""

    name: str | None
    rows: tuple[tuple[Cell, ...], ...]
    place: Sentence | None = None


class BlankRows:
    """Counts consecutive blank rows; a table ends where there are more than `BLANK_ROWS`."""

    def __init__(self) -> None:
        self.seen = 0

    def too_many(self, is_blank: bool, times: int = 1) -> bool:
        """Count a row, or `times` equal rows; return whether reading stops here."""
        self.seen = self.seen + times if is_blank else 0
        return self.seen > BLANK_ROWS
