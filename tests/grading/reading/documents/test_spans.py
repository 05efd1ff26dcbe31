"""Cells that span rows and columns, in every format that has them: a table laid with areas at random reads as it was laid."""

from __future__ import annotations

import io
import random
from collections.abc import Callable

import docx
import pytest

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.office.docx import document_of_docx
from coursework.grading.reading.documents.office.odt import document_of_odt
from coursework.grading.reading.documents.office.rtf import document_of_rtf
from coursework.grading.reading.documents.page import document_of_page
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.limits import Room
from tests.grading.reading.documents.test_parts_of_formulas import ODT
from tests.grading.reading.table.dialects import archive

ROWS, COLUMNS = 5, 6
Laid = list[list[tuple[str, int, int, int, int]]]  # a place: text, row and column where its area begins, how high, how wide


def laid(seed: int) -> Laid:
    """Areas that cover a table but for its last column, whose cells stand alone; some of one place are empty."""
    chance = random.Random(seed)
    places: dict[tuple[int, int], tuple[str, int, int, int, int]] = {}
    for row in range(ROWS):
        for column in range(COLUMNS):
            if (row, column) in places:
                continue
            free = next((k for k in range(column, COLUMNS - 1) if (row, k) in places), COLUMNS - 1)
            wide = chance.choice((1, 1, 2, 3))
            high, wide = min(chance.choice((1, 1, 2, 4)), ROWS - row), max(1, min(wide, free - column))
            high = 1 if column == COLUMNS - 1 else high
            is_empty = high * wide == 1 and column < COLUMNS - 1 and chance.random() < 0.4
            area = ("" if is_empty else f"c{row}{column}", row, column, high, wide)
            places |= {(row + i, column + k): area for i in range(high) for k in range(wide)}
    return [[places[row, column] for column in range(COLUMNS)] for row in range(ROWS)]


def page(table: Laid, most_rows: int, most_columns: int) -> Document:
    rows = "".join(
        "<tr>" + "".join(
            f"<td rowspan={high} colspan={wide}>{text}</td>" if (row, column) == (r, c) else ""
            for column, (text, r, c, high, wide) in enumerate(cells)
        ) + "</tr>"
        for row, cells in enumerate(table)
    )  # fmt: skip
    return document_of_page(f"<table>{rows}</table>", "html", Room(most_rows, most_columns))


def rich_text(table: Laid, most_rows: int, most_columns: int) -> Document:
    rows = ""
    for row, cells in enumerate(table):
        begun = [(r == row, c == column) for column, (_, r, c, _, _) in enumerate(cells)]
        rows += r"\trowd" + "".join(
            ("" if above else r"\clvmrg") + ("" if left else r"\clmrg") + rf"\cellx{column}"
            for column, (above, left) in enumerate(begun)
        )
        rows += r"\intbl " + "".join(
            (cell[0] if all(new) else "") + r"\cell " for cell, new in zip(cells, begun, strict=True)
        ) + r"\row"  # fmt: skip
    return document_of_rtf(f"{{\\rtf1{rows}\\pard}}".encode(), Room(most_rows, most_columns))


def word(table: Laid, most_rows: int, most_columns: int) -> Document:
    written = docx.Document()
    made = written.add_table(ROWS, COLUMNS)
    for text, row, column, high, wide in dict.fromkeys(cell for cells in table for cell in cells):
        made.cell(row, column).merge(made.cell(row + high - 1, column + wide - 1)).text = text
    written.save(packed := io.BytesIO())
    return document_of_docx(Archive(packed.getvalue()), "word/document.xml", Room(most_rows, most_columns))


def open_document(table: Laid, most_rows: int, most_columns: int) -> Document:
    rows = "".join(
        "<table:table-row>" + "".join(
            f'<table:table-cell table:number-rows-spanned="{high}" table:number-columns-spanned="{wide}">'
            f"<text:p>{text}</text:p></table:table-cell>" if (row, column) == (r, c) else "<table:covered-table-cell/>"
            for column, (text, r, c, high, wide) in enumerate(cells)
        ) + "</table:table-row>"
        for row, cells in enumerate(table)
    )  # fmt: skip
    body = ODT.format(f"<table:table>{rows}</table:table>")
    packed = archive({"mimetype": "application/vnd.oasis.opendocument.text", "content.xml": body})
    return document_of_odt(Archive(packed), Room(most_rows, most_columns))


@pytest.mark.parametrize(("most_rows", "most_columns"), [(20, 20), (3, 4)])
@pytest.mark.parametrize("form", [page, rich_text, word, open_document])
def test_each_place_of_an_area_holds_its_text(
    form: Callable[[Laid, int, int], Document], most_rows: int, most_columns: int
) -> None:
    for seed in range(1 if form is word else 8):
        table = laid(seed)
        (read,) = form(table, most_rows, most_columns).tables
        wanted = [[cell[0] for cell in cells[:most_columns]] for cells in table[:most_rows]]
        assert [[cell.text for cell in row] for row in read.rows] == [row for row in wanted if any(row)], seed
