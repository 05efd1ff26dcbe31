"""What is put on a sheet of paper: an arrow has a head that is alike on both sides; a word fills the room it takes."""

from __future__ import annotations

import re

import pytest

from coursework.drawing.paper.sheet import ITALIC, Sheet


@pytest.mark.parametrize("tip", [10 + 0j, 10j, 6 + 8j, -6 + 8j, 0.6 - 0.8j])
def test_the_head_of_an_arrow_is_alike_on_both_sides(tip: complex) -> None:
    """2.6 mm long, or as long as the arrow itself."""
    sheet, begin = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0)), 40 + 40j
    sheet.arrow(begin, begin + tip, "thin")
    (end, left), (_, right) = list(sheet.segments)[-2:]
    assert end == begin + tip
    assert abs(left - end) == pytest.approx(abs(right - end))
    neck = (left + right) / 2
    assert (end - neck) / tip * abs(tip) == pytest.approx(min(2.6, abs(tip)))
    assert ((left - right) / tip).real == pytest.approx(0.0)
    assert 0.5 < abs(left - right) / 2.6 < 1.0


@pytest.mark.parametrize("turn", [0, 1, -1])
@pytest.mark.parametrize("word", [("ω", "", ""), ("ω", "12", " = 2")])
def test_a_word_fills_its_room_behind_the_arc_of_its_sense(word: tuple[str, str, str], turn: int) -> None:
    """The arc of 2.3 mm and its head, 0.9 mm to each side, stand within the first 6.6 mm; others keep off the whole."""
    sheet = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0))
    sheet.label(word, [(40 + 40j, 1 + 0j, 1.0)], ITALIC, turn=turn)
    ((left, top, right, bottom),) = sheet.words
    begin, base = (float(one) for one in re.findall(r'[xy]="([\d.]+)"', sheet.items[-1])[:2])
    assert begin == pytest.approx(left + 6.6 * abs(turn), abs=0.01)
    assert top < base < bottom and begin < right
    sense = [float(one) for item in sheet.items[:-1] for one in re.findall(r"[Mm]([\d.]+)[ ,]", item)]
    assert len(sense) == 2 * abs(turn) and all(left < one < begin for one in sense)
