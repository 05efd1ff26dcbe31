"""A text file -> its one sheet of cells, for whichever program wrote it.

Enters: a decoded text.  Leaves: `Sheet` and its separator, None where there is no table.  Raises `Refused`.
Used by `tables_of_file.py`.
"""

from __future__ import annotations

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import columns_read, rows_read, unreadable


def sheet_of_text(text: str, rows: int) -> tuple[Sheet, str] | None:
    """Return the cells of a text and the name of its separator; `rows` is the number of rows of the grid."""
    found = split(text, rows_read(rows), columns_read(rows))
    if found is None:
        return None
    if found.has_pairs:
        raise unreadable("comma_twice")
    return Sheet(None, tuple(tuple(Cell(text) for text in row) for row in found.rows)), found.separator
