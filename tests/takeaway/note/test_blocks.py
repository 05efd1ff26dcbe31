"""How wide the columns of a table are in a note, and how large its letters."""

from __future__ import annotations

import re

import pytest

from coursework.report.text.parts import Column, Table
from coursework.takeaway.note.blocks import _widths
from coursework.takeaway.note.styles import HOUSES, House, word_styles
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


# Lines (240ths of one), size (half points), indent (20ths of a point): GOST 7.32-2017 and DSTU 3008:2015 ask for one and a
# half lines, 14 pt and 12.5 mm; GB/T 7713 for small four, 12 pt, and an indent of two letters.
@pytest.mark.parametrize(("language", "lines", "size", "indent"), [
    ("en", 276, 24, 0), ("ru", 360, 28, 709), ("uk", 360, 28, 709), ("zh", 300, 24, 482),
])  # fmt: skip
def test_text_in_word_is_set_as_the_standards_ask_and_only_headings_are_in_the_outline(
    language: str, lines: int, size: int, indent: int
) -> None:
    """What has a level stands in the pane beside the text; Word counts it from 0."""
    styles = word_styles(HOUSES.get(language, House()))
    levels = {name: re.findall(r'outlineLvl w:val="([^"]*)"', text) for name, text in styles.items()}
    assert {name: found for name, found in levels.items() if found} == {
        "Heading1": ["0"], "Heading2": ["1"], "HeadingStructural": ["0"],
    }  # fmt: skip
    text = styles["BodyText"]
    assert re.findall(r'w:line="(\d+)"', text) == [str(lines)]
    assert re.findall(r'w:firstLine="(\d+)"', text) == [str(indent)]
    assert f'w:sz w:val="{size}"' in text
