"""Turning points and strokes of the exact motion against closed forms; nothing is told where there is no stroke."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.results.checks.evidence import Evidence
from coursework.results.kinematics import turning_points as module
from coursework.results.kinematics.turning_points import TurningPoint, stroke, turning_points
from tests.mechanisms.library import mechanism
from tests.report.own import FIVE_BAR, SHAPER


def slider_crank(start: float, turns: float = 1, drive: str = "n") -> str:
    return mechanism("slider-crank", ('"0 deg"', f'"{start} deg"'), w1=drive, end=f"{turns}*2*pi/n")


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
    found = stroke(evidence(slider_crank(start)), "s", "u", "phi1")
    assert found is not None
    r, long, e = 0.12, 0.41, 0.07
    assert found.length == pytest.approx(math.sqrt((long + r) ** 2 - e**2) - math.sqrt((long - r) ** 2 - e**2), rel=1e-9)
    part = math.pi + math.asin(e / (long - r)) - math.asin(e / (long + r))
    assert found.slow_angle == pytest.approx(part, rel=1e-8)


def test_where_the_crank_makes_no_whole_turn_there_is_no_stroke() -> None:
    assert stroke(evidence(slider_crank(0)), "s", "u", "phi1") is not None
    assert stroke(evidence(slider_crank(0, turns=0.95)), "s", "u", "phi1") is None
    assert stroke(evidence(slider_crank(0, turns=2)), "s", "u", "phi1") is not None
    assert stroke(evidence(slider_crank(0, drive="0.5*n*cos(n*t)")), "s", "u", "phi1") is None


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
    judged = evidence(slider_crank(start))
    found = turning_points(judged, "s", "u")
    assert found is not None
    assert [0 <= point.time <= judged.period for point in found] == [True, True]


def turned(angle: float = 2 * math.pi, own: float = 0.0, period: float = 1.0, second: float = 1.0) -> Any:
    """A second of a motion in eleven rows: a crank that turns by an angle, and what ends so far from where it began."""
    columns = {"phi": np.linspace(0, angle, 11), "q": np.linspace(0, own, 11), "w": np.ones(11)}
    exact = SimpleNamespace(
        t=np.linspace(0, second, 11), step=second / 10, scheme="", column=columns.__getitem__, coordinate_names=("q", "phi"),
        velocity_names=("w",), coordinates=np.zeros((11, 2)),
    )  # fmt: skip
    rates = SimpleNamespace(motion=lambda *_: exact)
    return SimpleNamespace(exact=exact, rates=rates, period=period, once=lambda _, made: made())


def turning_at(monkeypatch: pytest.MonkeyPatch, *times: float) -> None:
    found = SimpleNamespace(t=np.array(times), coordinates=np.array([[time, time] for time in times]))
    monkeypatch.setattr(module, "samples_of", lambda *_: None)
    monkeypatch.setattr(module, "dead_positions", lambda *_: found)


@pytest.mark.parametrize("count", [24, 25])
def test_at_most_24_turning_points_are_told(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    turning_at(monkeypatch, *np.linspace(0.1, 0.9, count).tolist())
    found = turning_points(turned(), "q", "w")
    assert (None if found is None else len(found)) == (count if count <= 24 else None)


@pytest.mark.parametrize("second", [0.01, 1.0, 40.0])
@pytest.mark.parametrize(
    ("period", "times", "left"),
    [
        (1.0, (0.0, 0.4, 1.0), 2), (1 + 0.9e-9, (0.0, 0.4, 1.0), 2), (1 + 1.1e-9, (0.0, 0.4, 1.0), 3),
        (1.0, (1.1e-9, 0.4, 1.0), 3), (1.0, (0.9e-9, 0.4, 1.0), 2), (1.0, (1.0,), 1),
    ],
)  # fmt: skip
def test_the_end_of_a_period_is_its_beginning(
    monkeypatch: pytest.MonkeyPatch, period: float, times: tuple[float, ...], left: int, second: float
) -> None:
    turning_at(monkeypatch, *(second * time for time in times))
    found = turning_points(turned(period=second * period, second=second), "q", "w")
    assert found is not None and len(found) == left


@pytest.mark.parametrize(
    ("angle", "own", "is_stroke"),
    [
        (2 * math.pi + 0.9e-6, 0.9e-6, True), (-2 * math.pi + 0.9e-6, -0.9e-6, True), (2 * math.pi + 1.1e-6, 0.0, False),
        (2 * math.pi - 1.1e-6, 0.0, False), (2 * math.pi, 1.1e-6, False), (2 * math.pi, -1.1e-6, False),
    ],
)  # fmt: skip
def test_a_stroke_is_of_one_turn_that_returns(monkeypatch: pytest.MonkeyPatch, angle: float, own: float, is_stroke: bool) -> None:
    points = (TurningPoint(0.2, 1.0, (1.0, 0.5)), TurningPoint(0.8, 3.0, (3.0, 4.0)))
    monkeypatch.setattr(module, "turning_points", lambda *_: points)
    found = stroke(turned(angle, own), "q", "w", "phi")
    assert (found is not None) == is_stroke
    if found is not None:
        assert (found.begin, found.length) == (points[0], 2.0)
        assert (found.slow, found.fast) == pytest.approx((0.6, 0.4))
        assert (found.slow_angle, found.fast_angle) == pytest.approx((3.5, 2 * math.pi - 3.5))


def test_the_slow_way_may_be_the_one_over_the_end_of_the_period(monkeypatch: pytest.MonkeyPatch) -> None:
    points = (TurningPoint(0.3, 1.0, (1.0, 0.5)), TurningPoint(0.7, 3.0, (3.0, 4.0)))
    monkeypatch.setattr(module, "turning_points", lambda *_: points)
    found = stroke(turned(), "q", "w", "phi")
    assert found is not None and found.begin == points[1]
    assert (found.slow, found.slow_angle) == pytest.approx((0.6, 2 * math.pi - 3.5))
