"""Beside further tables stand their formulas and one row in numbers, against derivatives by differences of closed forms."""

from __future__ import annotations

import cmath
import math
import re
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.symbolic import expanded
from coursework.motion.geometry.time_derivatives import acceleration_rest
from coursework.report.sections.derivation import worked as module
from coursework.report.sections.derivation.worked import _points, _slopes, _solved, _values, worked
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.scene.scene_run import SceneRun
from coursework.variant.formula.tree import evaluate
from tests.mechanisms.library import mechanism
from tests.report.made import model_of
from tests.report.own import BOOM, FIVE_BAR, SHAPER
from tests.solved import solved as catalogued

ROW = 4
H = 1e-4


def solved(text: str, *more: str) -> SceneRun:
    return coursework.solve(coursework.parse_variant(text), quantities=("table", "checks", *more))


@cache
def shaper_with_points() -> SceneRun:
    return solved(SHAPER, "points")


def equations(run: SceneRun, section: str) -> list[str]:
    """Return the displayed equations of a section as plain text."""
    (found,) = (one for one in model_of(run).sections if one.name == section)
    return [item.text for part in found.parts if part.kind == "equations" for item in part.items]


def sentences(run: SceneRun, section: str) -> str:
    (found,) = (one for one in model_of(run).sections if one.name == section)
    told = [run for part in found.parts if part.kind == "paragraph" for run in part.text]
    return "".join(one.get("t", one.get("v", "") + one.get("s", "")) for one in told)


def result(line: str) -> float:
    return float(line.rpartition("= ")[2].replace("−", "-"))


def lever(t: float) -> tuple[float, float]:
    """Return the angle of the shaper's lever and the place of its slider F, from the triangle alone."""
    pin = 0.25j + 0.10 * cmath.exp(4j * math.pi * t)
    angle = cmath.phase(pin)
    drop = 0.48 - 0.50 * math.sin(angle)
    return angle, 0.50 * math.cos(angle) + math.sqrt(0.30**2 - drop**2)


def second(values: Any, t: float) -> float:
    return float((values(t + H) - 2 * values(t) + values(t - H)) / H**2)


def test_accelerations_name_coriolis_and_work_a_row_through() -> None:
    run = solved(SHAPER, "accelerations")
    shown = equations(run, "accelerations")
    assert "ω̇₃" in shown[0] and "ω₃" in shown[0] and len(shown) == 6
    assert "Coriolis" in sentences(run, "accelerations") and "2\u202fω3\u202fu" in sentences(run, "accelerations")
    assert "with ω̇3 = d\u202fω3/d\u202ft, u̇ = d\u202fu/d\u202ft" in sentences(run, "accelerations"), "each dot is told"
    t = (ROW - 1) * 0.5 / 48
    assert shown[-1].startswith("ω̇₃ = ")
    assert result(shown[-1]) == pytest.approx(second(lambda at: lever(at)[0], t), rel=1e-4)


@pytest.mark.parametrize("name", ["31", "v102", "example-1", "stephenson", "watt", "oscillating-cylinder"])
def test_each_acceleration_that_can_be_worked_through_is_the_slope_of_its_velocity(name: str) -> None:
    """Under a drive that is not steady, and in blocks that depend on others: the derivatives of those stand in the formula."""
    text = mechanism(name).replace('w1 = "w0"', 'w1 = "w0 + 3*sin(5*t)"')
    run = coursework.solve(coursework.parse_variant(text), "exact", quantities=("table", "accelerations"))
    context, symbols = PageContext(run, load_words("en")), run.scene.equations
    used = [one for one in symbols.equations if one.name in run.reduction.used]
    rests = {one.name: expanded(acceleration_rest(symbols, one)) for one in used}
    t, slopes = float(run.motion.t[ROW]), {}
    for rate in run.motion.velocity_names:
        before, after = (float(run.exact.at(t + side * H).column(rate)[0]) for side in (-1, 1))
        slopes[f"d{rate}"] = (after - before) / (2 * H)
    values = {**_slopes(context, list(rests.values()), ROW), **_values(context, ROW), **slopes}
    found = dict(_solved(context, rests))
    assert found
    largest = max(map(abs, slopes.values()))
    for rate, formula in found.items():
        assert evaluate(formula, values) == pytest.approx(slopes[rate], rel=1e-4, abs=1e-6 * largest), rate


@pytest.mark.long
@pytest.mark.parametrize("language", ["ru", "uk"])
def test_where_a_language_has_letters_for_them_accelerations_have_no_dot(language: str) -> None:
    run = solved(SHAPER, "accelerations", "analogs")
    shown = str([section for section in model_of(run, language).sections if section.name in {"accelerations", "analogs"}])
    assert "ε₃" in shown and "u̇" not in shown and "ω̇" not in shown and "dot(ω)" not in shown and "dot(u)" not in shown
    taken = solved(SHAPER.replace('n = "120 rpm"', 'n = "120 rpm"\neps3 = "1 m"\na = "1 m"'), "accelerations")
    dotted = str(model_of(taken, language).sections)
    assert "ω̇₃" in dotted and "u̇" in dotted


def boom(t: float) -> float:
    """Return the angle of the boom on its cylinder, by the law of cosines from AB, AC and the length of the cylinder."""
    length, foot = 1.5 + 0.06 / 0.6 * (1 - math.cos(0.6 * t)), complex(0.5, -0.4)
    return cmath.phase(foot) + math.acos((1.3**2 + abs(foot) ** 2 - length**2) / (2 * 1.3 * abs(foot)))


def test_the_slope_of_a_driven_length_has_its_number_too() -> None:
    shown = equations(solved(BOOM, "accelerations"), "accelerations")
    assert "∂u_s/∂t" in shown[-2].replace(" ", "") and "∂" not in shown[-1]
    assert result(shown[-1]) == pytest.approx(second(boom, 1.9), rel=1e-4)


def test_a_zero_is_put_in_as_zero_and_not_as_what_rounding_leaves_of_it() -> None:
    """At p t = pi/2 the boom's drive is at its largest: its slope is 2e-18 m/s^2 in the computer, 0 on paper."""
    largest = BOOM.replace('step = "0.1 s"', 'step = "pi/(20*p)"').replace("check_row = 20", "check_row = 11")
    shown = equations(solved(largest, "accelerations"), "accelerations")
    assert "10⁻" not in shown[-1] and "e-" not in shown[-1]


def test_without_a_slide_no_coriolis_is_named() -> None:
    assert "Coriolis" not in sentences(solved(FIVE_BAR, "accelerations"), "accelerations")


def test_points_are_placed_and_differentiated_in_numbers() -> None:
    long = 'H = "F + (b*sin(phi1)*sin(phi3)*sin(phi4) + r1*cos(phi3)*sin(phi1)*cos(phi4), 0)"'  # its rates would fill a page
    run = solved(SHAPER.replace("[points]", f"[points]\n{long}"), "accelerations", "points")
    x, v, a = (result(line) for line in equations(run, "points")[-3:])
    t = (ROW - 1) * 0.5 / 48
    assert x == pytest.approx(lever(t)[1], rel=1e-4)
    assert v == pytest.approx((lever(t + H)[1] - lever(t - H)[1]) / (2 * H), rel=1e-4)
    assert a == pytest.approx(second(lambda at: lever(at)[1], t), rel=1e-4)
    assert len(equations(shaper_with_points(), "points")) == 4, "no acceleration where none is asked for"


def test_analogs_and_invariants_follow_from_their_formulas() -> None:
    run = solved(SHAPER, "analogs", "invariants")
    table = run.extra_tables
    first, twice = (result(line) for line in equations(run, "analogs")[-2:])
    assert (first, twice) == pytest.approx(table["analogs"].rows[ROW - 1, 1:3], rel=1e-4)
    middle = table["invariants"].rows[len(table["invariants"].rows) // 2]
    assert [result(line) for line in equations(run, "invariants")[-3:]] == pytest.approx(middle[1:], rel=1e-4)


def test_what_is_too_long_to_read_is_left_out() -> None:
    assert equations(coursework.solve(coursework.load("prp"), quantities=("table", "accelerations")), "accelerations") == []


@pytest.mark.parametrize(("wheels", "shown"), [(6, True), (7, False)])
def test_more_than_six_equations_are_not_differentiated_on_a_page(wheels: int, shown: bool) -> None:
    text = mechanism("ten-wheels").partition(f'[[constraint]]\nname = "{wheels + 1}"')[0]
    text = re.sub(r"(?m)^phi(\d+) .*\n", lambda line: line[0] if int(line[1]) <= wheels else "", text)
    run = coursework.solve(coursework.parse_variant(text), quantities=("accelerations",))
    (extra,) = run.extra_tables.values()
    assert bool(worked(PageContext(run, load_words("en")), "accelerations", extra)) is shown


def test_determinants_have_the_number_of_their_block() -> None:
    """Variant 31 is solved for w3, for w4, then for w1 and w2 together: the third block is the one with a determinant of two."""
    shown = [line.partition(" = ")[0] for line in equations(catalogued("31"), "solution")]
    assert [name for name in shown if name.startswith("Δ")] == ["Δ₃", "Δ₃₁", "Δ₃₂"]
    alone = [line.partition(" = ")[0] for line in equations(catalogued("example-1"), "solution")]
    assert [name for name in alone if name.startswith("Δ")] == ["Δ", "Δ₁", "Δ₂"]  # one block has no number


def test_the_point_worked_through_moves_and_the_pivot_in_which_a_contour_ends_has_no_round_off() -> None:
    text = mechanism("four-bar-loop", ('A = "a @ phi1"', 'A = "a @ phi1"\nZ = "A + b @ phi2 - c @ phi3"'))
    run = coursework.solve(coursework.parse_variant(text), "exact", quantities=("table", "points"))
    assert equations(run, "points")[0].startswith("x_A = ")
    (section,) = (one for one in model_of(run).sections if one.name == "points")
    rows = [row for part in section.parts if part.kind == "table" for row in part.rows]
    assert rows and all(row[-3:] == ["0", "0", "0"] for row in rows), "y, vx and vy of Z"
    assert 0 < abs(run.points["Z"].velocity).to_numpy().max() < 1e-12


def test_a_slider_whose_place_is_a_coordinate_gives_way_to_a_point_with_a_formula() -> None:
    run = solved(mechanism("trammel", ("[links]", 'X = "(x, 0)"\n[links]')), "points")
    assert equations(run, "points")[0].startswith("x_E = ")


def test_an_acceleration_that_is_always_zero_is_not_worked_through() -> None:
    shown = equations(solved(mechanism("gears-and-crank"), "accelerations"), "accelerations")
    assert not any(line.endswith("= 0 = 0") or line.endswith("ω̇₂ = 0") for line in shown[-2:])


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "moves"), [(0.98e-9, False), (1.02e-9, True)])
def test_a_point_that_rests_but_for_round_off_gives_way_to_the_one_before_it(size: float, part: float, moves: bool) -> None:
    """Of the shaper the pin of the crank and the end of the lever are left, both along x only."""
    names = ("B.vx", "B.vy", "D.vx", "D.vy")
    extra: Any = SimpleNamespace(names=names, units=("m/s",) * 4, rows=np.array([[-size, 0.0, part * size, 0.0]] * 3))
    told = _points(PageContext(shaper_with_points(), load_words("en")), extra)
    assert ("D" in str(told[0])) is moves, told[0]


def test_formulas_of_more_than_160_letters_are_not_written_out(monkeypatch: pytest.MonkeyPatch) -> None:
    run = solved(FIVE_BAR, "accelerations")
    for letters, is_shown in ((160, True), (161, False)):
        monkeypatch.setattr(module, "spelled", lambda _, letters=letters: "x" * letters)
        found = worked(PageContext(run, load_words("en")), "accelerations", run.extra_tables["accelerations"])
        assert bool(found) is is_shown
