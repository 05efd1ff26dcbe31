"""No page of a report is half empty, the last one excepted: tried with mechanisms that are in no file."""

from __future__ import annotations

from functools import cache

import pytest

from coursework import parse_variant, solve
from coursework.report.pages import build_model, render_pdf
from tests.drawing.test_clearest import SHAPER
from tests.drawing.test_turns import FIVE_BAR
from tests.report.made import model_of, paper_of, solved
from tests.report.own import STEPHENSON
from tests.report.pages.test_paper import filled

ASKED = ["table", "plots", "checks", "graph_check", "accelerations", "points", "plans", "trajectories"]
HALF = 0.5
SIX_BAR = """format = 1
title = "Six-bar: a four-bar and a rod in a swinging sleeve"
[given]
n1 = "100 rpm"
r1 = "0.10 m"
r2 = "0.28 m"
r3 = "0.22 m"
d = "0.30 m"
f = "0.25 m"
L = "0.45 m"
[drive]
w1 = "n1"
[coordinates]
phi1 = { start = "0 deg", rate = "w1" }
phi2 = { rate = "w2", unit = "rad" }
phi3 = { rate = "w3", unit = "rad" }
phi5 = { rate = "w5", unit = "rad" }
s4 = { rate = "u4", unit = "m" }
[time]
step = "0.025 s"
end = "0.6 s"
period = "2*pi/n1"
[points]
A = "(0, 0)"
D = "(d, 0)"
F = "(d, -f)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r1"]
coordinates = ["phi1"]
[[group]]
kind = "RRR"
from = ["B", "D"]
meets = "C"
lengths = ["r2", "r3"]
coordinates = ["phi2", "phi3"]
mode = "+1"
[[group]]
kind = "RPR"
from = ["C", "F"]
meets = "E"
lengths = ["L"]
coordinates = ["phi5", "s4"]
mode = "+1"
[frame]
hinges = ["A", "D", "F"]
"""


@cache
def paper(text: str) -> bytes:
    return render_pdf(build_model(solve(parse_variant(text), quantities=ASKED)))


@pytest.mark.parametrize("text", [SHAPER, FIVE_BAR, SIX_BAR], ids=["shaper", "five-bar", "six-bar"])
def test_a_page_goes_on_where_a_drawing_no_longer_fits(text: str) -> None:
    assert min(filled(paper(text))[:-1]) >= HALF


@pytest.mark.parametrize("name", ["whitworth", "v107"])
def test_what_belongs_to_a_turned_drawing_fills_an_upright_page_with_others(name: str) -> None:
    """The construction of these is wider than a column, and its table does not fit beside it."""
    assert min(filled(paper_of(model_of(solved(name, quantities=ASKED))))[:-1]) >= HALF


def test_steps_of_a_plan_begin_no_page_of_their_own_before_a_turned_sheet() -> None:
    run = solve(parse_variant(STEPHENSON), quantities=["table", "plots", "checks", "graph_check"])
    assert min(filled(render_pdf(build_model(run)))[:-1]) >= HALF
