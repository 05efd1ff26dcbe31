"""Tables of the class as bytes, whole or with some cells spoilt, and how they are read or refused."""

from __future__ import annotations

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.encoding import decode
from coursework.grading.reading.limits import Refused, unreadable
from coursework.grading.reading.student_work import Table, Trouble
from coursework.grading.reading.table.tables_of_file import read_spreadsheet, table_of_text
from tests.grading.reading.table.dialects import written
from tests.grading.scenes import expected, times

GRID = expected().grid
COLUMNS = {column.name: (column.unit, column.values) for column in GRID.columns}
ROWS = written(times(GRID), COLUMNS, "fixed", 4, "rad")
HEAD = ["t", *GRID.names]


def read_table(content: bytes, name: str, grid: Grid) -> Table | Trouble:
    """Return the table of one file, or why there is none that can be marked."""
    try:
        is_archive = content.startswith(b"PK")
        found = read_spreadsheet(Archive(content), name, grid)[0] if is_archive else table_of_text(decode(content), name, grid)
    except Refused as refusal:
        return refusal.trouble
    return found[1] if found else unreadable("no_sheet_table" if is_archive else "no_table", name=name).trouble


def csv(rows: list[list[str]], sign: str = ";") -> bytes:
    return "\n".join(sign.join(row) for row in [HEAD, *rows]).encode()


def read(content: bytes, name: str = "table.csv") -> Table:
    found = read_table(content, name, GRID)
    assert isinstance(found, Table), found.text
    return found


def refused(content: bytes, name: str = "table.csv") -> Trouble:
    found = read_table(content, name, GRID)
    assert isinstance(found, Trouble), found.reading
    assert found.text[-1] in ".)"
    return found


def codes(table: Table) -> list[str]:
    return [note.code for note in table.notes]


def column(table: Table, name: str) -> tuple[float, ...]:
    found = table.column(name)
    assert found is not None
    return found.values


def cells(**changes: str) -> list[list[str]]:
    """Return the rows with some cells replaced: r11c3 = row 11 of the table, third column of the file, both from 1."""
    rows = [list(row) for row in ROWS]
    for place, text in changes.items():
        row, _, at = place[1:].partition("c")
        rows[int(row) - 1][int(at) - 1] = text
    return rows
