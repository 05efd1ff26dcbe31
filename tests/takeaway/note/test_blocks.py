"""How wide the columns of a table are in a note, and how large its letters."""

from __future__ import annotations

import pytest

from coursework.report.text.parts import Column, Table
from coursework.takeaway.note.blocks import _widths
from coursework.takeaway.note.writer import MANY, _sized_tables


@pytest.mark.parametrize(("head", "cell", "as_wide"), [
    ("步数", "1", "12345"), ("t", "容差", "1234"), ("steps", "1", "123456"), ("h", "", "12"),
])  # fmt: skip
def test_a_chinese_letter_takes_the_room_of_two_digits(head: str, cell: str, as_wide: str) -> None:
    """A head is bold: a letter more."""
    columns = [Column([{"text": head}]), Column([{"text": "x"}])]
    first, second = (_widths(Table(columns, [[text, "0"]]), 160.0)[0] for text in (cell, as_wide))
    assert first == pytest.approx(second)


@pytest.mark.parametrize(("columns", "size"), [(2, "small"), (MANY, "small"), (MANY + 1, "scriptsize")])
def test_a_wide_table_of_latex_has_smaller_letters_and_what_follows_has_its_own(columns: int, size: str) -> None:
    table, words = {"t": "Table", "c": [None, None, [None] * columns]}, {"t": "Para", "c": []}
    begin, made, end, after = _sized_tables([table, words])
    assert (begin["c"][1], end["c"][1]) == (f"\\begingroup\\{size}", "\\endgroup")
    assert (made, after) == (table, words)
