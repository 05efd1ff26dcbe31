"""Two cranks that push a slider up: what a page says of two arrows, of a point that moves upright, of a point called P."""

import re

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("own")
    with pytest.MonkeyPatch.context() as place:
        place.chdir(folder)
        assert CliRunner().invoke(main, ["new", "two", "--groups", "crank,crank,RRR,RRP"]).exit_code == 0
    text = (folder / "two.toml").read_text(encoding="utf-8").replace('"E"', '"P"')
    run = coursework.solve(coursework.parse_variant(text, "two.toml"), quantities=["table", "graph_check", "points"])
    return re.sub(r"\s+", " ", re.sub("<[^>]*>", "", render_html(build_model(run))))


@pytest.mark.long
def test_two_arrows_are_two(page):
    assert "The bent arrows are the given ω1 and ω2." in page


def test_a_slider_that_moves_upright_is_worked_through_along_its_way(page):
    assert "The place of G along y and its derivatives:" in page


def test_the_image_of_a_point_called_p_is_set_and_the_pole_is_left_alone(page):
    assert re.search(r"pv.p·0\.\d+ \(m/s\)/mm", page)
    assert "p_v" not in page
