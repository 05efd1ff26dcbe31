"""Small graphs: true curves, round ticks, words that are never parsed, the same bytes."""

from __future__ import annotations

import re
from itertools import accumulate, pairwise
from types import ModuleType
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework.drawing.paper.ways import way
from coursework.report.graphs.graph_paper import BETWEEN, field_for, round_ticks, smooth, sparse, tick_texts
from coursework.report.pages import build_model
from coursework.report.text.numbers import Numbers
from coursework.report.text.parts import Figure
from tests.drawing import measured
from tests.report.made import model_of, solved

T = np.linspace(0, 0.48, 25)


def test_the_exact_curve_has_eight_points_a_row_and_follows_the_motion() -> None:
    t, curve = smooth(T, np.sin(13 * T), 13 * np.cos(13 * T))
    assert len(t) == BETWEEN * 24 + 1
    assert BETWEEN >= 8
    # Cubic Hermite: h^4/384 of the fourth derivative.
    assert np.max(np.abs(curve - np.sin(13 * t))) < 0.02**4 / 384 * 13**4 * 1.01
    assert np.all(np.diff(t) > 0)


def test_many_rows_take_no_more_points_than_a_printer_sees() -> None:
    t = np.linspace(0, 1, 100_000)
    assert len(smooth(t, t, np.ones(100_000))[0]) <= 2001
    kept = sparse(np.arange(100_000.0), 2000)
    assert len(kept) <= 2001
    assert kept[-1] == 99_999
    assert sparse(np.zeros(0), 10).size == 0


@pytest.mark.parametrize(("low", "high"), [(-2.4, 1.5), (0.0, 0.48), (1.5, 1.7), (-16.7, 13.6), (3e-7, 4e-7), (99_990, 100_030)])
def test_ticks_are_round_numbers_inside(low: float, high: float) -> None:
    ticks, decimals = round_ticks(low, high, 5)
    assert 2 <= len(ticks) <= 6
    assert low - 1e-9 <= min(ticks)
    assert max(ticks) <= high + 1e-9 * abs(high)
    texts = tick_texts(ticks, decimals, Numbers(","))
    assert len(set(texts)) == len(ticks)
    assert all("." not in text for text in texts)


def test_constant_and_single_points_have_room() -> None:
    for t, values in ((np.zeros(1), np.ones(1)), (T, np.zeros(25)), (T, np.full(25, np.nan)), (T, np.full(25, 1e-300))):
        field = field_for((82, 42), [t], [values])
        assert field.high > field.low
        assert field.last > field.first
        assert "nan" not in field.path(t, values)


def test_a_panel_for_every_column_with_unit_and_symbol(real: ModuleType) -> None:
    panels = real.parts(real.full(), "graphs")[0]
    assert [item["name"] for item in panels["items"]] == ["phi1", "phi2", "phi3", "w1", "w2", "w3", "w4"]
    first = panels["items"][3]["svg"]
    assert 'width="82mm" height="34mm"' in first
    assert re.search(r">ω</tspan><tspan[^>]*>1</tspan>.*, rad/s</text>", first)
    assert "stop" not in first
    assert [real.text_of(words) for _, words in panels["legend"]] == ["explicit Euler, h = 0.02\u00a0s", "exact motion"]
    (dots,) = re.findall(r'class="dots"[^>]* d="([^"]*)"', first)
    assert dots.count("h0") == 25


def test_a_stop_is_a_broken_line_in_every_panel(real: ModuleType) -> None:
    for panels in real.parts(real.stopped(), "graphs"):
        assert all(item["svg"].count('class="stop"') == 1 for item in panels["items"])


def test_more_than_eight_panels_take_another_figure(real: ModuleType) -> None:
    figures = real.parts(solved("jansen", quantities=["table", "plots"]), "graphs")
    assert [len(part["items"]) for part in figures] == [8, 5], "the crank turns evenly, which is no graph"


def test_the_same_model_twice_is_the_same_bytes(real: ModuleType) -> None:
    first = build_model(real.full()).plain()
    build_model(real.stopped())
    assert build_model(real.full()).plain() == first


def test_a_curve_that_does_not_bend_has_no_picture_of_its_bend(real: ModuleType) -> None:
    run = solved("cardan", quantities=["table", "checks"])
    parts = real.parts(run, "results")
    assert not [part for part in parts if part.get("id") == "tangent"]
    told = " ".join(real.text_of(part["text"]) for part in parts if part["kind"] == "paragraph")
    assert "its own tangent" in told and "at most" not in told
    bent = real.parts(solved("31", quantities=["table", "checks"]), "results")
    assert [part for part in bent if part.get("id") == "tangent"]


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "whitworth", "watt", "v107"])
def test_the_words_of_the_gap_touch_no_line(name: str) -> None:
    parts = [part for s in model_of(solved(name, quantities=["table", "checks"])).sections for part in s.parts]
    (figure,) = [part for part in parts if isinstance(part, Figure) and part.id == "tangent"]
    drawing = ElementTree.fromstring(figure.svg)
    x = re.search(r"M([\d.]+) [\d.]+h2M", paths(drawing, "gap")[0])
    assert x
    label = next(one for one in drawing.iter(f"{measured.SVG}text") if abs(float(one.get("x", "0")) - float(x[1]) - 2.8) < 0.01)
    wide, up, _ = measured.size(label.text or "", 2.9)
    left, bottom = float(label.get("x", "0")), float(label.get("y", "0"))
    middle = bottom - up / 2
    assert left + wide < figure.width
    assert bottom < figure.height - 7, "the words stand above the axis"
    for drawn in (*paths(drawing, "exact"), *paths(drawing, "rows")):
        for a, b in pairwise(points(drawn)):
            for k in range(21):
                at = a + (b - a) * k / 20
                assert not (left < at.real < left + wide and abs(at.imag - middle) < up / 2 + 0.3), (name, at)


def points(way: str) -> list[complex]:
    """Return the points of a line: the first, and those of the steps behind it."""
    first, _, steps = way.removeprefix("M").partition("l")
    numbers = [float(number) for number in re.findall(r"-?[\d.]+", f"{first} {steps}")]
    return [*accumulate(complex(x, y) for x, y in zip(numbers[::2], numbers[1::2], strict=True))]


def test_a_line_is_told_in_steps_that_do_not_add_up_their_rounding() -> None:
    chance = np.random.default_rng(5)
    x, y = np.cumsum(chance.uniform(-1, 1, (2, 400)), axis=1)
    drawn = np.array(points(way([x, y])))
    assert np.abs(drawn.real - x).max() < 0.00501 and np.abs(drawn.imag - y).max() < 0.00501


def test_a_value_that_is_no_number_interrupts_a_line() -> None:
    field = field_for((82, 34), [np.arange(5.0)], [np.arange(5.0)])
    assert [piece.count("l") for piece in field.path(np.arange(5.0), np.array([0, 1, np.nan, 3, 4])).split("M")] == [0, 1, 1]
    assert field.path(np.arange(2.0), np.full(2, np.nan)) == ""


def test_a_smooth_curve_is_told_in_cubics_and_a_kink_in_it_in_steps() -> None:
    t = np.linspace(0.0, 2.0, 24 * BETWEEN + 1)
    field = field_for((82, 34), [t], [np.array([-1.0, 1.0])])
    kinked = np.where(t < 1, 0.5 * t - 0.5, np.abs(t - 1.43) - 0.43)
    for values, lines in ((t**3 / 4 - t**2 / 2, 0), (kinked, 1), (np.cos(t), 0)):
        told = field.curve(t, values)
        assert (told.count("c") + told.count("s"), told.count("l")) == (24 - lines, lines)
        handle = 0j
        at = complex(*map(float, re.findall(r"[\d.]+", told)[:2]))
        seen = [at]
        for kind, numbers in re.findall(r"([csl])([^csl]+)", told):
            steps = [float(number) for number in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers)]
            ends = [complex(x, y) for x, y in zip(steps[::2], steps[1::2], strict=True)]
            if kind == "l":
                seen += [at + sum(ends[: k + 1]) for k in range(BETWEEN)]
            else:
                a, b, c = ends if kind == "c" else (handle, *ends)
                handle = c - b
                parts = np.arange(1, BETWEEN + 1) / BETWEEN
                seen += [at + 3 * s * (1 - s) ** 2 * a + 3 * s**2 * (1 - s) * b + s**3 * c for s in parts]
            at = seen[-1]
        assert np.abs(np.array(seen) - (field.x(t) + 1j * field.y(values))).max() < 0.02


def paths(drawing: ElementTree.Element, kind: str) -> list[str]:
    """Return the d of the paths of a class."""
    return [one.get("d", "") for one in drawing.iter(f"{measured.SVG}path") if one.get("class") == kind]
