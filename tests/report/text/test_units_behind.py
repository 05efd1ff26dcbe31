"""What stands at an axis: a comma and the unit, in Chinese a stroke; for a slider crank with an offset, which no file has."""

from __future__ import annotations

import re

import pytest

from coursework.report.text.words import load_words
from coursework.variant.reading.reader import parse_variant
from tests.command import call
from tests.mechanisms.library import mechanism

OFFSET = mechanism("slider-crank")


@pytest.mark.parametrize(
    ("language", "rad", "rate"), [("en", ", rad", ", rad/s"), ("zh", "/rad", "/(rad/s)"), ("ru", ", рад", ", рад/с")]
)
def test_the_words_know_how_a_unit_stands_behind_a_symbol(language, rad, rate):
    words = load_words(language)
    assert [words.behind(words.unit(unit)) for unit in ("rad", "rad/s", "")] == [rad, rate, ""]


@pytest.mark.parametrize(
    ("language", "shown"), [("zh", {"t/s", "φ1/rad", "ω2/(rad/s)", "s/m", "u/(m/s)"}), ("uk", {"t, с", "s, м"})]
)
def test_axes_of_a_page(tmp_path, language, shown):
    parse_variant(OFFSET)
    (tmp_path / "own.toml").write_text(OFFSET, encoding="utf-8")
    told = call("run", tmp_path / "own.toml", "--language", language, "--format", "html", "--out", tmp_path / "out")
    assert told.exit_code in (0, 1), told.output
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    texts = {re.sub("<[^>]*>|\u200a", "", text) for text in re.findall(r"<text[^>]*>(.*?)</text>", page, re.DOTALL)}
    assert shown <= texts
    assert not texts & {"t, s", "t, с" if language == "zh" else "t/с"}


@pytest.mark.parametrize(("language", "shown"), [("en", "rev/min"), ("ru", "об/мин"), ("uk", "об/хв"), ("zh", "r/min")])
def test_a_unit_is_in_the_letters_of_the_page_whatever_the_file_is_typed_in(language, shown):
    words = load_words(language)
    assert words.unit("об/мин") == words.unit("rev/min") == shown
    assert words.amount("3", "кг*м^2") == words.amount("3", "kg*m^2")
    assert words.amount("15", "град") == "15°"
