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
from coursework.grading.reading.table.table import Origin, promised, read_sheets


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
    found: list[tuple[float, Table | Refused]] = []  # by what stands under the heads of the task
    sheets: list[Sheet] = []
    try:
        for sheet in given:
            found += _found_in(sheet, Origin(name, kind, "cells", _told(sheet, sheets)), grid)
            sheets.append(sheet)
    except Refused:  # of a sheet behind the table nothing need be read
        if not any(isinstance(table, Table) for _, table in found):
            raise
    # The first of equally good ones; what a person must look at or save again is never passed over for a worse sheet.
    best = max(found, key=lambda entry: (entry[0], _stands(entry[1])), default=(0.0, None))[1]
    if isinstance(best, Refused):
        raise best
    return best, sheets


def _found_in(sheet: Sheet, origin: Origin, grid: Grid) -> list[tuple[float, Table | Refused]]:
    """Return the table of a sheet, or why it was refused, with how much speaks for it; nothing where it has no table."""
    try:
        table = read_sheets([sheet], origin, grid)
    except Refused as refused:
        return [(promised(sheet, origin, grid), refused)]
    return [(table.weight, table)] if table else []


def _stands(found: Table | Refused) -> bool:
    """Return whether a sheet is looked at no further: a table, one that was never computed or that a person must look at."""
    return isinstance(found, Table) or found.trouble.code == "formulas" or found.trouble.state == "needs-review"


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
