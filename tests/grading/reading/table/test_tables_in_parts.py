"""A table in parts is read as one: columns in blocks, rows beside each other, rows over pages; other tables stay apart."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.numbers import looks_numeric
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.grading.reading.table.parts import Origin, joined, parts_of
from tests.grading.reading.documents.test_hostile_documents import one_page
from tests.grading.reading.table.dialects import workbook
from tests.grading.reading.table.misread import GRID, HEAD, ROWS
from tests.grading.scenes import expected

Rows = list[list[str]]
HALF = len(ROWS) // 2
ANGLES = [0, *(at for at, name in enumerate(HEAD) if name.startswith("phi"))]
SPEEDS = [0, *(at for at, name in enumerate(HEAD) if name.startswith("w"))]

BLANK = [""] * len(HEAD)


def of(columns: list[int], rows: Rows = ROWS) -> Rows:
    return [[row[at] for at in columns] for row in [HEAD, *rows]]


def numbered(rows: Rows, first: int = 1) -> Rows:
    """Rows with their number instead of their time."""
    return [["№", *rows[0][1:]], *([str(first + k), *row[1:]] for k, row in enumerate(rows[1:]))]


def page(*tables: Rows) -> bytes:
    written = ("".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows) for rows in tables)
    return f"<html><body>{''.join(f'<p>Part</p><table>{rows}</table>' for rows in written)}</body></html>".encode()


def read(content: bytes) -> StudentWork:
    return read_submission(Submission("x", None, (submitted_file("work", content),)), expected())


WHOLE = [HEAD, *ROWS]
PARTS: dict[str, list[Rows]] = {
    "columns in two blocks": [of(ANGLES), of(SPEEDS)],
    "columns told by the number of the row": [numbered(of(ANGLES)), numbered(of(SPEEDS))],
    "each block over two pages": [of(columns, rows) for rows in (ROWS[:HALF], ROWS[HALF:]) for columns in (ANGLES, SPEEDS)],
    "blocks below each other in one table": [[*of(ANGLES), *of(SPEEDS)]],
    "rows beside each other": [[a + b for a, b in zip([HEAD, *ROWS[:HALF]], [HEAD, *ROWS[HALF : 2 * HALF]], strict=True)]]
    + [[HEAD, *ROWS[2 * HALF :]]] * (len(ROWS) % 2),
    "with a gap between, the last block shorter": [
        [[*row, "", *more] for row, more in zip([HEAD, *ROWS[: HALF + 1]], [HEAD, *ROWS[HALF + 1 :], BLANK], strict=True)]
    ],
    "units in a row of their own": [[of(ANGLES)[0], ["s", "rad", "rad", "rad"], *of(ANGLES)[1:]], of(SPEEDS)],
}  # fmt: skip


@pytest.mark.parametrize("case", PARTS)
def test_a_table_in_parts_is_one(case: str) -> None:
    table, whole = read(page(*PARTS[case])).table, read(page(WHOLE)).table
    assert table is not None and whole is not None and all(table.rows_present)
    assert {column.name: column.values for column in table.columns} == {column.name: column.values for column in whole.columns}


def test_other_tables_stay_apart() -> None:
    def count(*tables: Rows) -> int:
        sheets = [Sheet(None, tuple(tuple(map(Cell, row)) for row in rows)) for rows in tables]
        return len(joined([part for sheet in sheets for part in parts_of(sheet, Origin("x", "x", "cells"), GRID)], GRID))

    later = [HEAD, *([str(float(row[0]) + 0.005), *row[1:]] for row in ROWS)]
    speeds = [[row[at] for at in SPEEDS] for row in later]
    assert count(of(ANGLES), speeds) == 2  # other times
    assert count(of(ANGLES), of(SPEEDS, ROWS[:3])) == 2  # a few rows, as of a check
    assert count(WHOLE, WHOLE) == count(of(ANGLES), of(ANGLES)) == 2  # two schemes
    assert count(of(ANGLES), of(SPEEDS), of(ANGLES), of(SPEEDS)) == 2 == count(of(ANGLES), of(ANGLES), of(SPEEDS), of(SPEEDS))
    assert count([a + b for a, b in zip(WHOLE, WHOLE, strict=True)]) == 1  # two schemes beside each other


def test_columns_of_a_pdf_in_blocks_are_one() -> None:
    speeds = [*of(SPEEDS[:4]), ["And", "the", "last"], *of([0, SPEEDS[4]])]  # as many columns as before, then fewer
    texts = [b"BT /F 8 Tf 1 0 0 1 %d %d Tm (%s) Tj ET" % (40 + 60 * at, 960 - 11 * line, cell.encode())
             for line, row in enumerate([*of(ANGLES), *speeds]) for at, cell in enumerate(row)]  # fmt: skip
    table = read(one_page(b"\n".join(texts))).table
    assert table is not None and len(table.columns) == len(GRID.columns) and all(table.rows_present)


@pytest.mark.parametrize("side", [0, 5, 10])
def test_heads_of_a_pdf_that_nearly_touch_stay_apart(side: int) -> None:
    """Numbers begin where their heads do, in the middle of them or end with them; a title over all is no head."""
    heads = ["t, s", *(f"{name}, {'rad' if name.startswith('p') else 'rad/s'}" for name in HEAD[1:])]
    rows = [["Table", "of", "angles"], heads, *ROWS]
    texts = [b"BT /F 8 Tf 1 0 0 1 %d %d Tm (%s) Tj ET" % (40 + 42 * at + (line > 1) * side, 760 - 11 * line, cell.encode())
             for line, row in enumerate(rows) for at, cell in enumerate(row)]  # fmt: skip
    table = read(one_page(b"\n".join(texts))).table
    assert table is not None and {column.by for column in table.columns} == {"header"}
    assert len(table.columns) == len(GRID.columns) and all(table.rows_present)


def test_merged_heads_of_a_page_stand_over_their_columns() -> None:
    """The time over two rows, a title over several columns: without them every column would be read as the one before."""
    content = (
        page(WHOLE)
        .decode()
        .replace("<td>t</td>", '<td rowspan="2">t</td><td colspan=3>Angles</td><td COLSPAN="4">w</td></tr><tr>', 1)
    )
    table, whole = read(content.encode()).table, read(page(WHOLE)).table
    assert table is not None and whole is not None
    assert [column.values for column in table.columns] == [column.values for column in whole.columns]


def _csv(rows: Rows) -> bytes:
    return "\n".join(";".join(row) for row in rows).encode()


def _sheet(rows: Rows) -> Rows:
    return [[f"{'n' if looks_numeric(cell) else 't'}:{cell}" for cell in row] for row in rows]


def _pipes(rows: Rows) -> str:
    return "\n".join("| " + " | ".join(row) + " |" for row in (rows[0], ["---"] * len(rows[0]), *rows[1:]))


WRITTEN: dict[str, Callable[[list[Rows]], dict[str, bytes]]] = {
    "files": lambda tables: {f"{at}.csv": _csv(rows) for at, rows in enumerate(tables)},
    "transposed files": lambda tables: {f"{k}.csv": _csv([*map(list, zip(*rows, strict=True))]) for k, rows in enumerate(tables)},
    "sheets": lambda tables: {"t.xlsx": workbook({f"part {at}": _sheet(rows) for at, rows in enumerate(tables)})},
    "one csv": lambda tables: {"t.csv": b"\n\n".join(map(_csv, tables))},
    "blanks": lambda tables: {"t.txt": "\n\n".join("\n".join("  ".join(row) for row in rows) for rows in tables).encode()},
    "markdown": lambda tables: {"t.md": "\n\n## More\n\n".join(map(_pipes, tables)).encode()},
    "page": lambda tables: {"t.html": page(*tables)},
}  # fmt: skip
CUT: dict[str, list[Rows]] = {
    "columns in blocks": [of(ANGLES), of(SPEEDS)],
    "columns in three blocks": [of(ANGLES), of(SPEEDS[:3]), of([0, *SPEEDS[3:]])],
    "the second block without the time": [of(ANGLES), of(SPEEDS[1:])],
    "rows in halves": [of([*range(len(HEAD))], ROWS[:HALF]), of([*range(len(HEAD))], ROWS[HALF:])],
    "the second half without heads": [[HEAD, *ROWS[:HALF]], ROWS[HALF:]],
    "a column that both have": [of(ANGLES), of([0, ANGLES[1], *SPEEDS[1:]])],
}


# Where the first row is the heads there is no half without.
HEADED = {(kind, "the second half without heads") for kind in ("markdown", "transposed files")}


@pytest.mark.parametrize(("kind", "case"), [(kind, case) for kind in WRITTEN for case in CUT if (kind, case) not in HEADED])
def test_parts_are_put_together_in_every_kind_of_file(kind: str, case: str) -> None:
    files = tuple(submitted_file(name, content) for name, content in WRITTEN[kind](CUT[case]).items())
    table, whole = read_submission(Submission("x", None, files), expected()).table, read(page(WHOLE)).table
    assert table is not None and whole is not None and all(table.rows_present)
    assert {column.name: column.values for column in table.columns} == {column.name: column.values for column in whole.columns}
    assert {*table.reading.file.split(" + ")} == {file.name for file in files}


@pytest.mark.parametrize("kind", WRITTEN)
def test_two_schemes_are_no_parts_of_one(kind: str) -> None:
    other = [HEAD, *([row[0], *(f"{float(cell) + 1:.4f}" for cell in row[1:])] for row in ROWS)]
    summary = [HEAD, *([str(row), *["1.5"] * (len(HEAD) - 1)] for row in (25, 0.2, 3))]  # of a data frame, under the same heads
    for second in (other, summary):
        files = tuple(submitted_file(name, content) for name, content in WRITTEN[kind]([WHOLE, second]).items())
        table = read_submission(Submission("x", None, files), expected()).table
        assert table is None or {column.values for column in table.columns} == {c.values for c in read(page(WHOLE)).table.columns}  # type: ignore[union-attr]
