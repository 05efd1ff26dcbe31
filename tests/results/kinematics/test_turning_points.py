"""Turning points and strokes of the exact motion against closed forms; nothing is told where there is no stroke."""

from __future__ import annotations

import math

import numpy as np
import pytest

import coursework
from coursework.results.checks.evidence import Evidence
from coursework.results.kinematics.turning_points import stroke, turning_points
from tests.report.own import FIVE_BAR, SHAPER

SLIDER_CRANK = """\
format = 1
title = "Slider-crank with an offset"
[given]
r = "0.12 m"
l = "0.41 m"
e = "0.07 m"
n = "90 rpm"
[drive]
w1 = "n"
[coordinates]
phi1 = {{ start = "{start} deg", rate = "w1" }}
phi2 = {{ rate = "w2", unit = "rad" }}
s = {{ rate = "u", unit = "m" }}
[time]
step = "pi/(18*n)"
end = "{turns}*2*pi/n"
period = "2*pi/n"
[points]
A = "(0, 0)"
[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r"]
coordinates = ["phi1"]
[[group]]
kind = "RRP"
from = ["B"]
guide = {{ through = "A", angle = "0", offset = "e" }}
meets = "C"
lengths = ["l"]
coordinates = ["phi2", "s"]
mode = "+1"
"""


def evidence(text: str) -> Evidence:
    return coursework.solve(coursework.parse_variant(text), quantities=("table", "checks")).results.by_scheme.evidence


def test_the_stroke_of_the_shaper_by_its_geometry() -> None:
    """The lever turns back where the crank stands at right angles to it: 2 asin(r1/d) beside half a turn."""
    found = stroke(evidence(SHAPER), "x", "vx", "phi1")
    assert found is not None
    beyond = 2 * math.asin(0.10 / 0.25)
    assert found.length == pytest.approx(2 * 0.50 * 0.10 / 0.25, rel=1e-9)
    assert (found.slow_angle, found.fast_angle) == pytest.approx((math.pi + beyond, math.pi - beyond), rel=1e-8)
    assert found.ratio == pytest.approx((math.pi + beyond) / (math.pi - beyond), rel=1e-8)
    assert found.slow + found.fast == pytest.approx(0.5, rel=1e-12)


@pytest.mark.parametrize("start", [0.0, 12.5, math.degrees(math.asin(0.07 / 0.53)), 200.0])
def test_the_stroke_of_a_slider_crank_with_an_offset(start: float) -> None:
    """S = sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2), wherever the first row stands, in an end position too."""
    found = stroke(evidence(SLIDER_CRANK.format(start=start, turns=1)), "s", "u", "phi1")
    assert found is not None
    r, long, e = 0.12, 0.41, 0.07
    assert found.length == pytest.approx(math.sqrt((long + r) ** 2 - e**2) - math.sqrt((long - r) ** 2 - e**2), rel=1e-9)
    part = math.pi + math.asin(e / (long - r)) - math.asin(e / (long + r))
    assert found.slow_angle == pytest.approx(part, rel=1e-8)


def test_where_the_crank_makes_no_whole_turn_there_is_no_stroke() -> None:
    assert stroke(evidence(SLIDER_CRANK.format(start=0, turns=1)), "s", "u", "phi1") is not None
    assert stroke(evidence(SLIDER_CRANK.format(start=0, turns=0.95)), "s", "u", "phi1") is None
    assert stroke(evidence(SLIDER_CRANK.format(start=0, turns=2)), "s", "u", "phi1") is not None
    swings = SLIDER_CRANK.format(start=0, turns=1).replace('w1 = "n"', 'w1 = "0.5*n*cos(n*t)"')
    assert stroke(evidence(swings), "s", "u", "phi1") is None


def test_turning_points_lie_where_a_fine_table_has_them() -> None:
    """The five-bar by the cosine rule on a hundred thousand positions: the extremes of both angles of the dyad."""
    t = np.linspace(0, 2, 100_001)
    b = 0.20 * np.exp(1j * (math.pi / 6 + 2 * math.pi * t))
    d = 0.50 + 0.15 * np.exp(1j * (2 * math.pi / 3 + math.pi * t))
    apart = np.abs(d - b)
    along = (0.45**2 + apart**2 - 0.40**2) / (2 * apart)
    c = b + (along + 1j * np.sqrt(0.45**2 - along**2)) * (d - b) / apart
    for name, rate, angle in (("phi2", "w2", np.angle(c - b)), ("phi3", "w3", np.angle(c - d))):
        points = turning_points(evidence(FIVE_BAR), name, rate)
        assert points is not None
        inner = [k for k in range(1, len(t) - 1) if (angle[k] - angle[k - 1]) * (angle[k + 1] - angle[k]) < 0]
        assert [point.time for point in points] == pytest.approx(t[inner], abs=4e-5)
        assert [point.value for point in points] == pytest.approx(angle[inner], abs=1e-8)


def test_what_turns_round_has_no_turning_point() -> None:
    assert turning_points(evidence(SHAPER), "phi1", "w1") == ()
    assert turning_points(evidence(SHAPER), "nothing", "w1") is None


@pytest.mark.parametrize("past", [-0.05, 0.05])
def test_a_turn_a_little_before_the_rows_or_behind_them_is_told_where_it_is_within(past: float) -> None:
    start = math.degrees(math.asin(0.07 / 0.53)) + past
    judged = evidence(SLIDER_CRANK.format(start=start, turns=1))
    found = turning_points(judged, "s", "u")
    assert found is not None
    assert [0 <= point.time <= judged.period for point in found] == [True, True]
