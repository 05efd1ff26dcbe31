"""One file -> the table in it, whatever program wrote it.

Enters: the name of a file, an `Archive` or a decoded text, the `Grid`.  Leaves: `Table`.  Raises `Refused`.
Used by `read_submission.py` and `read_document.py`.
"""

from __future__ import annotations

from collections.abc import Iterable

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files import ods, xlsx
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.files.encoding import Decoded
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import Refused, bounds, unreadable
from coursework.grading.reading.student_work import Table
from coursework.grading.reading.submission import Note, note
from coursework.grading.reading.table.table import Origin, read_sheets


def is_spreadsheet(archive: Archive) -> bool:
    """Return whether an archive is an xlsx or ods file."""
    return xlsx.WORKBOOK in archive.parts or ods.CONTENT in archive.parts


def read_spreadsheet(archive: Archive, name: str, grid: Grid) -> tuple[Table | None, list[Sheet]]:
    """Return the table of a spreadsheet, None where no sheet has one, and its sheets.  Raises `Refused`."""
    given: Iterable[Sheet]
    if xlsx.WORKBOOK in archive.parts:
        given, kind = xlsx.sheets_of(archive, *bounds(grid.rows)), "xlsx"
    elif ods.CONTENT in archive.parts:
        given, kind = ods.sheets_of(archive, *bounds(grid.rows)), "ods"
    else:
        raise unreadable("damaged")
    table: Table | None = None
    sheets: list[Sheet] = []
    try:
        for sheet in given:
            table = table or read_sheets([sheet], Origin(name, kind, "cells", _told(sheet, sheets)), grid)
            sheets.append(sheet)
    except Refused:  # of a sheet behind the table nothing need be read
        if table is None:
            raise
    return table, sheets


def table_of_text(decoded: Decoded, name: str, grid: Grid) -> Table | None:
    """Return the table of a text, None for a text that holds none.  Raises `Refused`."""
    found = split(decoded.text, *bounds(grid.rows))
    if found is None:
        return None
    if found.has_pairs:
        raise unreadable("comma_twice")
    sheet = Sheet(None, tuple(tuple(map(Cell, row)) for row in found.rows))
    notes = (note("encoding"),) if decoded.had_nuls else ()
    return read_sheets([sheet], Origin(name, decoded.encoding, found.separator, notes), grid)


def _told(sheet: Sheet, before: list[Sheet]) -> tuple[Note, ...]:
    return (note("ignored_file", "sheet", sheet=sheet.name or ""),) if before else ()
