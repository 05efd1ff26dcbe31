"""Which sign is the decimal mark of a sheet, when it cannot be told, and what parentheses mean."""

from __future__ import annotations

from typing import Any

import pytest

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.limits import Refused
from coursework.grading.reading.table.layout import Layout
from coursework.grading.reading.table.parts import Origin, Part, _decimal_mark, _whole, _with_minus


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


@pytest.mark.parametrize(("one", "other", "whole"), [
    (("a.x", "utf-8", "tab", "xy", "A"), ("b.x", "utf-8", "tab", "yz", "B"), ("a.x + b.x", "utf-8", "tab", "xyz", "A + B")),
    (("a", "utf-8", ";", "x", "A"), ("a", "cp1251", "tab", "", "A"), ("a", "utf-8 + cp1251", "cells", "x", "A")),
    (("a + b", "utf-8", ";", "", None), ("b", "utf-8", ";", "zx", "B"), ("a + b", "utf-8", ";", "zx", None)),
    (("a", "utf-8", ";", "xx", "A"), ("ab", "utf-8", ";", "x", None), ("a + ab", "utf-8", ";", "xx", "A")),
])  # fmt: skip
def test_two_parts_of_a_table_are_told_with_what_each_has_of_its_own(one: Any, other: Any, whole: Any) -> None:
    layout = Layout((), False, (), False, ".")
    first, second = (
        Part(layout, Origin(file, coded, sign, tuple(notes)), sheet) for file, coded, sign, notes, sheet in (one, other)
    )
    made = _whole(first, second, (), ())
    assert (made.origin.file, made.origin.encoding, made.origin.separator, "".join(made.origin.notes), made.sheet) == whole
