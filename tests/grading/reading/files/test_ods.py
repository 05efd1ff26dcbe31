"""What stands in the cells of an OpenDocument sheet, case by case of its XML."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.ods import sheets_of
from coursework.grading.reading.limits import Room
from tests.grading.reading.table.dialects import document

NUMBER = '<table:table-cell office:value-type="{}" office:value="{}"><text:p>{}</text:p></table:table-cell>'


def cells(row: str, most: int = 40) -> list[tuple[str, str]]:
    (sheet,) = sheets_of(
        Archive(document(f"<table:table><table:table-row>{row}</table:table-row></table:table>")), Room(600, most)
    )
    return [(cell.text, cell.kind) for one in sheet.rows for cell in one]


@pytest.mark.parametrize(("row", "found"), [
    (NUMBER.format("float", "1.5", "1,50"), [("1.5", "number")]),
    (NUMBER.format("percentage", "0.25", "25 %"), [("0.25", "number")]),
    (NUMBER.format("currency", "3", "3 €"), [("3", "number")]), (NUMBER.format("string", "", "w1"), [("w1", "text")]),
    (NUMBER.format("float", "", "1,50"), [("1,50", "text")]),
    ('<table:table-cell office:value-type="date" office:date-value="2026-05-01"><text:p>01. Mai</text:p></table:table-cell>',
     [("01. Mai", "date")]),
    ('<table:table-cell office:value-type="time"><text:p>00:20</text:p></table:table-cell>', [("00:20", "date")]),
    ('<table:table-cell table:formula="of:=A1"/><table:table-cell><text:p>x</text:p></table:table-cell>',
     [("", "formula"), ("x", "text")]),
    ('<table:table-cell table:formula="of:=A1" office:value-type="string"/>' + NUMBER.format("float", "1", "1"),
     [("", "text"), ("1", "number")]),
    ("<table:table-cell><text:p>two</text:p><text:p>lines</text:p></table:table-cell>", [("two lines", "text")]),
    ("<table:table-cell><text:p>before</text:p><office:annotation><text:p>a note</text:p></office:annotation><text:p>behind"
     "</text:p></table:table-cell>", [("before behind", "text")]),
    ('<table:table-cell table:number-columns-repeated="3"><text:p>a</text:p></table:table-cell>', [("a", "text")] * 3),
    ("<table:table-cell><text:p>a</text:p></table:table-cell><table:covered-table-cell/><table:table-cell><text:p>b</text:p>"
     "</table:table-cell>", [("a", "text"), ("", "text"), ("b", "text")]),
])  # fmt: skip
def test_a_cell_is_its_number_or_its_text(row: str, found: list[tuple[str, str]]) -> None:
    assert cells(row) == found
    assert cells(row, 1) == ([] if found[0] == ("", "text") else found[:1])


@pytest.mark.parametrize(("tables", "kept"), [(10, 10), (11, 10)])
def test_ten_sheets_are_looked_at(tables: int, kept: int) -> None:
    one = "<table:table table:name='{}'><table:table-row>" + NUMBER.format("float", "{}", "") + "</table:table-row></table:table>"
    found = sheets_of(Archive(document("".join(one.format(k, k) for k in range(tables)))), Room(600, 40))
    assert [sheet.name for sheet in found] == [str(k) for k in range(kept)]
