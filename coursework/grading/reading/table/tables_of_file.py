"""One file's bytes -> the table in it, whatever program wrote it.

Enters: name and bytes of a file, the `Grid`.  Leaves: `Table`, or `Trouble`; never raises for what a student hands in.
Used by `read_submission.py` and by whoever reads a single file (`precheck`).
"""

from __future__ import annotations

from collections.abc import Iterable

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files import ods, xlsx
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.files.encoding import Decoded, decode
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import Refused, columns_read, rows_read, unreadable
from coursework.grading.reading.student_work import Table, Trouble
from coursework.grading.reading.submission import Note, note
from coursework.grading.reading.table.table import Origin, read_sheets


def read_table(content: bytes, name: str, grid: Grid) -> Table | Trouble:
    r"""Return the table of one file, or why there is none that can be marked.

    >>> from coursework.grading.reading.expected import Grid, GridColumn
    >>> grid = Grid(0.1, 3, (GridColumn("phi1", "rad", (1.0, 1.1, 1.2)), GridColumn("w1", "1/s", (1.0, 1.0, 1.0))))
    >>> table = read_table(b"t;phi1;w1\n0;1,0;1,0\n0,1;1,1;1,0\n0,2;1,2;1,0\n", "mine.csv", grid)
    >>> table.column("phi1").values
    (1.0, 1.1, 1.2)
    """
    try:
        table = _read(content, name, grid)
        if table is None:
            raise unreadable("no_table", name=name)
    except Refused as refused:
        return refused.trouble
    return table


def _read(content: bytes, name: str, grid: Grid) -> Table | None:
    if content.startswith(b"PK"):
        table, _ = read_spreadsheet(Archive(content), name, grid)
        if table is None:
            raise unreadable("no_sheet_table", name=name)
        return table
    return table_of_text(decode(content), name, grid)


def is_spreadsheet(archive: Archive) -> bool:
    """Return whether an archive is an xlsx or ods file."""
    return xlsx.WORKBOOK in archive.parts or ods.CONTENT in archive.parts


def read_spreadsheet(archive: Archive, name: str, grid: Grid) -> tuple[Table | None, list[Sheet]]:
    """Return the table of a spreadsheet, None where no sheet has one, and its sheets.  Raises `Refused`."""
    bounds = rows_read(grid.rows), columns_read(grid.rows)
    given: Iterable[Sheet]
    if xlsx.WORKBOOK in archive.parts:
        given, kind = xlsx.sheets_of(archive, *bounds), "xlsx"
    elif ods.CONTENT in archive.parts:
        given, kind = ods.sheets_of(archive, *bounds), "ods"
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
    found = split(decoded.text, rows_read(grid.rows), columns_read(grid.rows))
    if found is None:
        return None
    if found.has_pairs:
        raise unreadable("comma_twice")
    sheet = Sheet(None, tuple(tuple(map(Cell, row)) for row in found.rows))
    notes = (note("encoding"),) if decoded.had_nuls else ()
    return read_sheets([sheet], Origin(name, decoded.encoding, found.separator, notes), grid)


def _told(sheet: Sheet, before: list[Sheet]) -> tuple[Note, ...]:
    return (note("ignored_file", "sheet", sheet=sheet.name or ""),) if before else ()
