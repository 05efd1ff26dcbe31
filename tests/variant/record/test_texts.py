"""Texts of a variant in other languages: shown where the file has them, else as the author wrote them and marked so."""

from __future__ import annotations

import pytest

import coursework
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.variant.reading.reader import parse_variant
from tests.report.real import text_of

FILE = """
title = "A crank"
remarks = ["It turns."]
[given]
r = { value = "0.4 m", means = "OA" }
[drive]
w1 = "3"
[coordinates]
phi = { start = "0 rad", rate = "w1" }
[unknowns]
u = "m/s"
[time]
step = "0.1 s"
end = "1 s"
[[constraint]]
name = 7
because = "the pin is on the crank"
equation = "u = r*w1"
[text.uk]
title = "Кривошип"
because = { 7 = "палець на кривошипі" }
means = { r = "радіус" }
"""


def test_a_language_that_the_file_has_is_spoken_and_what_it_lacks_is_as_written() -> None:
    variant = parse_variant(FILE)
    spoken = variant.in_language("uk")
    assert (spoken.title, spoken.given[0].means, spoken.constraints[0].because) == ("Кривошип", "радіус", "палець на кривошипі")
    assert spoken.remarks == ("It turns.",)
    assert variant.in_language("ru") is variant


def test_the_page_speaks_it_and_marks_a_title_as_written() -> None:
    run = coursework.solve(parse_variant(FILE), quantities=["table"])
    pages = {language: build_model(run, language) for language in ("en", "ru", "uk")}
    told = {language: text_of(page.plain()) for language, page in pages.items()}
    assert "палець на кривошипі" in told["uk"]
    assert "the pin is on the crank" in told["ru"]
    assert '<h1 lang="">' in render_html(pages["ru"])
    assert "<h1>" in render_html(pages["uk"])
    assert "<h1>" in render_html(pages["en"])


def test_a_key_that_a_text_does_not_have_is_a_fault() -> None:
    with pytest.raises(coursework.InputError) as caught:
        parse_variant(FILE.replace("means =", "meanings ="))
    assert "V011 variant:" in str(caught.value)
    assert 'text.uk.meanings: the key "meanings" is not known here. Did you mean "means"?' in str(caught.value)
