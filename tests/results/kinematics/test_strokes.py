"""Strokes, swings and extremes of mechanisms that are in no file, beside closed forms: nothing is read at rows."""

from __future__ import annotations

import csv
import io
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.report.output.tables import run_tables
from coursework.results.kinematics import strokes
from coursework.variant.reading.reader import parse_variant
from tests.results.kinematics.mechanisms import ROCKER, ROUND, SHAPER, TWO_CRANKS, slider_crank

EXACT = 1e-9


def solved(text: str, **named: Any) -> Any:
    return coursework.solve(parse_variant(text), quantities=["table", "invariants"], **named)


def stroke(run: Any) -> tuple[float, float, np.ndarray[Any, np.dtype[np.float64]]]:
    """Return S, Φ and the rows of invariants.csv."""
    extra = run.extra_tables["invariants"]
    values = extra.title.values
    head, *rows = csv.reader(io.StringIO(dict(run_tables(run))["invariants.csv"]))
    assert head == ["k", "a_k", "b_k", "c_k"]
    return values["stroke"].values["value"], values["angle"], np.array(rows, dtype=float)


def assert_whole(rows: np.ndarray[Any, np.dtype[np.float64]]) -> None:
    """The table begins and ends at dead positions, and says so to the last digit."""
    assert rows[0, :3].tolist() == [0.0, 0.0, 0.0]
    assert not np.any(np.signbit(rows[[0, -1], :3]))
    assert rows[-1, :3].tolist() == [1.0, 1.0, 0.0]
    assert np.all(np.diff(rows[:, 0]) > 0)
    assert np.all(rows[1:-1, 2] > 0)


@pytest.mark.parametrize("parts", [37, 100, 720])
def test_a_shaper_has_its_stroke_whatever_the_step(parts: int) -> None:
    run = solved(SHAPER.replace("100*n", f"{parts}*n"))
    length, angle, rows = stroke(run)
    assert length == pytest.approx(2 * 0.50 * 0.10 / 0.25, abs=EXACT)
    assert angle == pytest.approx(2 * math.acos(0.10 / 0.25), abs=EXACT)
    assert_whole(rows)
    assert "*S* = 0.400000 m, *Φ* = 2.318559 rad" in run.extra_tables["invariants"].title


def test_of_two_turns_the_working_stroke_is_taken() -> None:
    length, angle, rows = stroke(solved(SHAPER.replace('end = "2*pi/n"', 'end = "4*pi/n"')))
    assert (length, angle) == pytest.approx((0.4, 2 * math.pi - 2 * math.acos(0.4)), abs=EXACT)
    assert_whole(rows)


# One that begins at a dead position, one that does not, one that begins a hair beside it; the drive as it likes.
STARTS = (0.0, 0.7, 1e-5, math.pi - 2e-4)
DRIVES = ("n", "n*(1 + 0.4*sin(n*t))", "-n", "n + 3*t")


@pytest.mark.long
@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("drive", DRIVES)
@pytest.mark.parametrize("offset", [0.0, 0.06])
def test_an_offset_slider_crank_under_any_drive(start: float, drive: str, offset: float) -> None:
    length, angle, rows = stroke(solved(slider_crank(offset, start - math.asin(offset / 0.6), drive)))
    far, near = (math.sqrt(way**2 - offset**2) for way in (0.5 + 0.1, 0.5 - 0.1))
    assert length == pytest.approx(far - near, abs=EXACT)
    inward = math.pi + math.asin(offset / 0.4) - math.asin(offset / 0.6)
    assert min(abs(angle - one) for one in (inward, 2 * math.pi - inward)) < EXACT
    assert_whole(rows)


def test_the_invariants_of_a_centric_slider_are_those_of_any_drive() -> None:
    tables = [stroke(solved(slider_crank(0.0, 0.0, drive)))[2] for drive in DRIVES[:2]]
    for k, a, b, c in np.concatenate(tables).tolist():
        phi, length = math.pi * k, 0.2
        root = math.sqrt(0.25 - (0.1 * math.sin(phi)) ** 2)
        assert a == pytest.approx((0.6 - 0.1 * math.cos(phi) - root) / length, abs=EXACT)
        first = 0.1 * math.sin(phi) * (1 + 0.1 * math.cos(phi) / root)
        assert b == pytest.approx(first * math.pi / length, abs=1e-8)
        turned = 0.01 * math.cos(2 * phi) / root + 0.0001 * math.sin(2 * phi) ** 2 / 4 / root**3
        assert c == pytest.approx((0.1 * math.cos(phi) + turned) * math.pi**2 / length, abs=1e-7)


def test_a_rocker_swings_between_the_crank_stretched_and_folded() -> None:
    a, b, c, d = 0.1, 0.35, 0.25, 0.4
    length, angle, rows = stroke(solved(ROCKER))

    def inner(side: float) -> float:
        return math.acos((c * c + d * d - side * side) / (2 * c * d))

    def crank(side: float) -> float:
        return math.acos((side * side + d * d - c * c) / (2 * side * d))

    assert length == pytest.approx(inner(b + a) - inner(b - a), abs=EXACT)
    onward = math.pi + crank(b - a) - crank(b + a)
    assert min(abs(angle - one) for one in (onward, 2 * math.pi - onward)) < EXACT
    assert_whole(rows)


def test_a_run_without_two_dead_positions_says_that_its_stroke_is_that_of_the_rows() -> None:
    run = solved(slider_crank(0.0, 0.3, "n", end="0.1 s"))
    title = run.extra_tables["invariants"].title
    assert "which contain no whole stroke from dead position to dead position" in title
    _, angle, rows = stroke(run)
    assert angle == pytest.approx(6 * 2 * math.pi / 40, abs=EXACT)  # whole steps in 0.1 s
    assert rows[0, 2] > 0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (ROUND, "invariants need a slider (a coordinate that is a length) or a rocker"),
        (TWO_CRANKS, "analogs and invariants need one driven crank (its rate in [drive]); this variant has 2"),
        (slider_crank(0.0, 0.3, "n*cos(n*t)"), "the crank stands still at t = 0.157"),
    ],
)
def test_what_has_no_stroke_is_refused(text: str, words: str) -> None:
    with pytest.raises(coursework.InputError) as refused:
        _ = solved(text).extra_tables
    assert words in str(refused.value)


def test_extremes_lie_between_the_rows() -> None:
    found = solved(SHAPER.replace("100*n", "37*n")).scene.extremes
    half = math.asin(0.4)
    assert found["phi3"] == pytest.approx((math.pi / 2 - half, math.pi / 2 + half), abs=EXACT)
    assert found["s"] == pytest.approx((0.15, 0.35), abs=EXACT)
    omega = 4 * math.pi
    assert found["w3"] == pytest.approx((-omega * 0.1 / 0.15, omega * 0.1 / 0.35), abs=1e-8)
    assert found["phi1"] == pytest.approx((math.pi / 2, math.pi / 2 + 2 * math.pi), abs=EXACT)
    assert found["w1"] == pytest.approx((omega, omega), abs=EXACT)


def test_extremes_of_a_mechanism_with_two_cranks() -> None:
    """The links meet on the axis of the mirror, 0.3 m - r cos(phi1) beside each tip."""
    found = coursework.solve(parse_variant(TWO_CRANKS)).scene.extremes
    assert found["phi2"] == pytest.approx((math.acos(0.4 / 0.5), math.acos(0.2 / 0.5)), abs=EXACT)
    turning = np.linspace(0, 2 * math.pi, 2_000_001)
    rate = -np.sin(turning) / np.sqrt(0.25 - (0.3 - 0.1 * np.cos(turning)) ** 2)
    assert found["w2"] == pytest.approx((rate.min(), rate.max()), abs=EXACT)


@pytest.mark.parametrize(("second", "chosen"), [(1.009, 0), (1.012, 1)])
def test_the_first_of_two_strokes_is_taken_that_differ_by_less_than_a_hundredth(
    monkeypatch: pytest.MonkeyPatch, second: float, chosen: int
) -> None:
    columns = {"w": np.ones(3), "phi": np.array([0.0, 1.0, 1.0 + second])}
    samples = SimpleNamespace(motion=SimpleNamespace(column=columns.__getitem__, t=np.arange(3.0)))
    monkeypatch.setattr(strokes, "samples_of", lambda *_: samples)
    monkeypatch.setattr(strokes, "_brackets", lambda *_: [(place, place) for place in range(3)])
    monkeypatch.setattr(strokes, "_dead", lambda exact, rates, rate, bracket: bracket[0])
    monkeypatch.setattr(strokes, "at_times", lambda exact, rates, times: times[0])
    monkeypatch.setattr(strokes, "_stroke", lambda exact, rates, slider, *ends: ends)
    none: Any = None
    crank: Any = SimpleNamespace(name="phi", rate="w")
    assert strokes.longest_way(none, none, crank, crank) == (chosen, chosen + 1)


def test_a_dead_position_is_looked_for_a_tenth_of_a_step_around_the_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []
    monkeypatch.setattr(strokes, "at_times", lambda exact, rates, times: asked.extend(times))
    monkeypatch.setattr(strokes, "closer", lambda exact, rates: exact)
    monkeypatch.setattr(strokes, "_together", lambda exact, rates, parts: parts)
    exact: Any = SimpleNamespace(t=np.array([1.0, 1.5, 2.0]), step=0.5)
    none: Any = None
    found = strokes.samples_of(exact, none)
    assert asked == pytest.approx([0.95, 2.05])
    assert (found.motion, found.begins, found.ends) == ([exact], True, True)


@pytest.mark.parametrize(("slopes", "begins", "ends", "brackets"), [
    ([0, 1, 2], True, True, [(0, 0)]), ([0, 1, 2], False, True, []), ([1, 0, 2], True, True, []),
    ([1, 2, 0], True, True, [(2, 2)]), ([1, 2, 0], True, False, []), ([1, 0, -2], True, True, [(0, 2)]),
    ([0, 1, -1, 0], True, True, [(0, 0), (1, 2), (3, 3)]),
])  # fmt: skip
def test_a_motion_that_cannot_be_followed_further_may_begin_and_end_at_a_dead_position(slopes, begins, ends, brackets) -> None:  # type: ignore[no-untyped-def]
    motion = SimpleNamespace(column=lambda rate: np.array(slopes, dtype=float))
    assert strokes._brackets(strokes.Samples(motion, begins, ends), "w") == brackets  # type: ignore[arg-type]
