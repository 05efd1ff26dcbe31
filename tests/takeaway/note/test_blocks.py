"""How wide the columns of a table are in a note."""

from __future__ import annotations

import pytest

from coursework.report.text.parts import Column, Table
from coursework.takeaway.note.blocks import _widths


@pytest.mark.parametrize(("head", "cell", "as_wide"), [
    ("步数", "1", "12345"), ("t", "容差", "1234"), ("steps", "1", "123456"), ("h", "", "12"),
])  # fmt: skip
def test_a_chinese_letter_takes_the_room_of_two_digits(head: str, cell: str, as_wide: str) -> None:
    """A head is bold: a letter more."""
    columns = [Column([{"text": head}]), Column([{"text": "x"}])]
    first, second = (_widths(Table(columns, [[text, "0"]]), 160.0)[0] for text in (cell, as_wide))
    assert first == pytest.approx(second)
