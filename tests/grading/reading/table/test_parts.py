"""Which sign is the decimal mark of a sheet, when it cannot be told, and what parentheses mean."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.limits import Refused
from coursework.grading.reading.table.parts import _decimal_mark, _with_minus


@pytest.mark.parametrize(("cells", "separator", "mark"), [
    ("1.5 2.25 3", ";", (".", False)), ("1,5 2,25 3", ";", (",", False)), ("1,5 2,25 3.5", ";", (",", True)),
    ("1,5 2.25 3.5", "tab", (".", True)),
    ("1 2 3", ",", (".", False)), ("1,234 5", ";", (",", False)), ("1,234 5.5", ";", (".", False)),
    ("1,234 5,5", "tab", (",", False)),
    ("1,234 5", "tab", "thousands"), ("1,234 5.678", ";", "thousands"), ("1,5 2.5", ";", "two_marks"),
    ("1.234 5", "tab", (".", False)),
    ("w1,5 a.5", ";", (".", False)),
])  # fmt: skip
def test_the_mark_that_most_cells_can_only_have(cells: str, separator: str, mark: object) -> None:
    sheet = Sheet(None, (tuple(Cell(cell) for cell in cells.split()), (Cell("7,7", "number"),)))
    try:
        found: object = _decimal_mark(sheet, separator)
    except Refused as refused:
        found = refused.trouble.code
    assert found == mark


@pytest.mark.parametrize(("rows", "shown"), [
    ("0 (1.5)|1 (2.5)", "0 -1.5|1 -2.5"), ("(0) (1.5)|(1) 2.5|(2) (3)", "(0) -1.5|(1) 2.5|(2) -3"),
    ("0 (1.5)|1 2.5", "0 (1.5)|1 2.5"), ("0 (1.5)|1 (2.5)|2 -3", "0 (1.5)|1 (2.5)|2 -3"),
    ("(t) (a1)|0 (1.5)|1 (w)", "(t) (a1)|0 (1.5)|1 (w)"),
])  # fmt: skip
def test_parentheses_are_a_minus_where_no_minus_stands_and_several_rows_have_them(rows: str, shown: str) -> None:
    made = _with_minus([[Cell(text) for text in row.split()] for row in rows.split("|")])
    assert "|".join(" ".join(cell.text for cell in row) for row in made) == shown
