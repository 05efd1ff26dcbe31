"""How wide the columns of a table are in a note, how large its letters, and how large drawings and graphs."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any, cast

import pytest

from coursework.report.text.parts import Column, Equations, Figure, Panel, Panels, Paragraph, Table
from coursework.report.text.text_runs import runs
from coursework.report.text.words import load_words
from coursework.takeaway.note.blocks import Blocks, _widths
from coursework.takeaway.note.sections import _referred
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


def sizes(blocks: object) -> list[tuple[float, float]]:
    """The sizes of the pictures in blocks, which stand there as text in place of the pictures themselves."""
    found = re.findall(r"size (\d+(?:\.\d+)?) (\d+(?:\.\d+)?)", str(blocks))
    return [(float(width), float(height)) for width, height in found]


@pytest.fixture
def blocks() -> Any:
    """Blocks on a page 100 mm wide, in a format that turns what it is given."""
    dialect = SimpleNamespace(
        picture=lambda place, alt, size: {"t": f"size {size[0]:g} {size[1]:g}"},
        caption=lambda kind, label, mark, said: [{"t": kind, "c": ["".join(label), mark]}],
        turned=lambda made: [{"t": "turned"}, *made],
    )
    return Blocks(cast("Any", dialect), {}, str, 100.0)


def test_words_that_lead_to_formulas_stay_on_their_page(blocks: Blocks) -> None:
    made = list(
        _referred([Paragraph(runs("With")), Equations([]), Paragraph(runs("All are independent."))], blocks, load_words())
    )
    assert [one["t"] for one in made] == ["Div", "Para"] and "Lead" in str(made[0])
    styles = word_styles(House())
    assert ["keepNext" in styles[name] for name in ("Lead", "BodyText")] == [True, False]


@pytest.mark.parametrize(
    ("width", "exact", "size", "style", "turned"),
    [
        (80.0, False, (80, 40), "Figure", False), (100.0, False, (100, 40), "Figure", False),
        (200.0, False, (100, 20), "Figure", False),
        (104.0, True, (104, 40), "Wide Figure", False), (106.0, True, (106, 40), "Wide Figure", True),
        (80.0, True, (80, 40), "Figure", False),
    ],
)  # fmt: skip
def test_a_drawing_is_shrunk_to_the_page_but_one_true_to_scale_is_turned(blocks, width, exact, size, style, turned) -> None:
    """It may reach 5 mm into the margin before it is turned."""
    made = blocks.of(Figure("svg", width, 40.0, "alt", [{"t": "a caption"}], exact, "Fig. 7 "))
    assert sizes(made) == [size]
    assert f"'{style}'" in str(made) and ({"t": "turned"} in made) is turned
    assert {"t": "figure", "c": ["Fig. 7  ", "figure_7"]} in made


@pytest.mark.parametrize(
    ("width", "size", "rows"), [(40.0, 40, [2, 2, 1]), (49.0, 48, [2, 2, 1]), (50.0, 48, [2, 2, 1]), (51.0, 51, [1] * 5),
    (120.0, 98, [1] * 5)]
)  # fmt: skip
def test_small_graphs_stand_side_by_side_with_a_millimetre_on_either_side(blocks, width, size, rows) -> None:
    panels = Panels("id", width, width / 2, [], [Panel("w1", "svg", "alt")] * 5, [{"t": "a caption"}], "Fig. 3\u3000")
    made = blocks.of(panels)
    assert sizes(made) == [(size, size / 2)] * 5
    (_, *shown), *_ = [one["c"][1] for one in made if one["t"] == "Div"]
    assert [len(one["c"]) for one in shown] == rows
    assert {"t": "figure", "c": ["Fig. 3\u3000", "figure_3"]} in made
