"""Which sign is the decimal mark of a sheet, and when it cannot be told."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.limits import Refused
from coursework.grading.reading.table.parts import _decimal_mark


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
