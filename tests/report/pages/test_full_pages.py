"""No page of a report is half empty, the last one excepted: tried with mechanisms that are in no file."""

from __future__ import annotations

from functools import cache

import pymupdf
import pytest

from coursework import parse_variant, solve
from coursework.commands.new import _chain
from coursework.report.pages import build_model, render_pdf
from tests.drawing.lettering.test_turns import FIVE_BAR
from tests.drawing.outline.test_clearest import SHAPER
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, paper_of, solved
from tests.report.own import STEPHENSON
from tests.report.pages.test_paper import filled

ASKED = ["table", "plots", "checks", "graph_check", "accelerations", "points", "plans", "trajectories"]
HALF = 0.5
SIX_BAR = mechanism("six-bar-with-sleeve")


@cache
def paper(text: str) -> bytes:
    return render_pdf(build_model(solve(parse_variant(text), quantities=ASKED)))


@pytest.mark.long
@pytest.mark.parametrize("text", [SHAPER, FIVE_BAR, SIX_BAR], ids=["shaper", "five-bar", "six-bar"])
def test_a_page_goes_on_where_a_drawing_no_longer_fits(text: str) -> None:
    assert min(filled(paper(text))[:-1]) >= HALF


@pytest.mark.long
@pytest.mark.parametrize("name", ["whitworth", "v107"])
def test_what_belongs_to_a_turned_drawing_fills_an_upright_page_with_others(name: str) -> None:
    """The construction of these is wider than a column, and its table does not fit beside it."""
    assert min(filled(paper_of(model_of(solved(name, quantities=ASKED))))[:-1]) >= HALF


@pytest.mark.long
def test_steps_of_a_plan_begin_no_page_of_their_own_before_a_turned_sheet() -> None:
    run = solve(parse_variant(STEPHENSON), quantities=["table", "plots", "checks", "graph_check"])
    assert min(filled(render_pdf(build_model(run)))[:-1]) >= HALF


def test_many_data_leave_the_result_on_the_first_page() -> None:
    """A table of thirty data does not fit below the figure: it begins there and goes on."""
    run = solve(parse_variant(_chain("own", "crank,RRR,RRR,RRR,RRP").decode()), quantities=["table", "checks"])
    pages = [page.get_text() for page in pymupdf.open(stream=render_pdf(build_model(run)))]
    assert ["Result: The table" in text.replace("\n", " ") for text in pages[:2]] == [True, False]
    assert min(filled(render_pdf(build_model(run)))[:-1]) >= HALF


@pytest.mark.long
def test_the_formula_of_a_turned_drawing_has_no_page_to_itself() -> None:
    """In Russian the page before the drawing of links 2 and 3 is full: their formula stood alone between both."""
    assert min(filled(paper_of(model_of(solved("whitworth-forces"), "ru")))[:-1]) >= HALF
