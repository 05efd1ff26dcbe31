"""A singular position through which one motion only goes on is gone through; where two motions meet the run ends.

A bar slides through a sleeve that turns about (r, 0); its end A on a crank r goes through that pivot.  The angle at the
circumference is half of that at the centre: phi = theta/2 + pi/2, and s = 2 r sin(theta/2) with its sign.
"""

import math

import numpy as np
import pytest

from coursework.commands.check import check_variant
from coursework.motion.integration.passage import FLANKS, Passage, State
from coursework.report.output.gate import pass_gate
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from tests.hard.scenes import four_bar, scene, solve
from tests.report.reading import html_text

R = 0.3
PHI, S = -0.25 + math.pi / 2, 2 * R * math.sin(-0.25)
BY_CLOSURE = (
    f'phi = {{ start = "{PHI!r} rad", rate = "w" }}\ns = {{ start = "{S!r} m", rate = "u" }}',
    {"closures": ["r @ theta = (r, 0) + s @ phi"]},
)
BY_GROUPS = (
    'phi = { rate = "w", unit = "rad" }\ns = { rate = "u", unit = "m" }',
    {
        "more": '[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["r"]\ncoordinates = ["theta"]\n'
        '[[group]]\nkind = "RPR"\nfrom = ["A", "(r, 0)"]\nlengths = []\ncoordinates = ["phi", "s"]\nmode = "+1"\n'
    },
)


def past_its_pivot(way, step=0.02, end=1.0, speed="1"):
    coordinates, geometry = way
    return scene(
        f'theta = {{ start = "-0.5 rad", rate = "w1" }}\n{coordinates}', given=f'r = "{R} m"', drive=f'w1 = "{speed}"',
        step=step, end=end, **geometry,
    )  # fmt: skip


def errors(motion):
    """Largest errors of s, w and u; the sign with which s begins is that of the assembly."""
    theta = motion.column("theta")
    sign = -np.sign(motion.column("s")[0])
    wanted = {
        "s": sign * 2 * R * np.sin(theta / 2), "w": motion.column("w1") / 2,
        "u": sign * R * np.cos(theta / 2) * motion.column("w1"),
    }  # fmt: skip
    return {name: float(np.max(np.abs(motion.column(name) - values))) for name, values in wanted.items()}


@pytest.mark.parametrize("way", [BY_CLOSURE, BY_GROUPS], ids=["closure", "groups"])
@pytest.mark.parametrize("step", [0.02, 0.03, 0.0137])
def test_the_exact_motion_goes_through(way, step):
    """At t = 0.5 s; with 0.02 s a row stands there, and its accelerations come from beside it."""
    run = solve(past_its_pivot(way, step), "exact", ("table", "checks", "accelerations", "plots"))
    assert run.stop is None
    found = errors(run.motion)
    assert found["s"] < 1e-12
    assert found["w"] < 1e-8
    names, rows = run.columns()
    theta = run.motion.column("theta")
    sign = -np.sign(run.motion.column("s")[0])
    assert np.max(np.abs(rows[:, names.index("du")] + sign * R / 2 * np.sin(theta / 2))) < 1e-9
    assert np.max(np.abs(rows[:, names.index("dw")])) < 1e-5
    assert {one.code for one in run.checks if one.verdict not in {"PASS", "SKIP"}} == set()
    pass_gate(run, pages=True)


@pytest.mark.parametrize("speed", ["1", "1 + 0.5*sin(3*t)"])
def test_a_scheme_goes_through_with_its_own_error(speed):
    runs = {name: solve(past_its_pivot(BY_CLOSURE, speed=speed), name, ("table", "checks")) for name in ("euler", "heun", "rk4")}
    found = {name: errors(run.motion)["s"] for name, run in runs.items()}
    assert all(run.stop is None and len(run.motion.t) == 51 for run in runs.values())
    assert found["rk4"] < 1e-8 < min(found["heun"], found["euler"])
    assert max(found.values()) < 0.02
    assert errors(runs["euler"].exact)["s"] < 1e-11
    verdicts = {one.code: one.verdict for one in runs["rk4"].checks}
    assert verdicts["PERIOD-ASSEMBLY"] == verdicts["ACCURACY"] == "PASS"
    assert "FAIL" not in {one.verdict for one in runs["euler"].checks}


def test_every_passage_of_a_long_run_is_known():
    """The first is at 0.5 s, then one a turn: at 2 pi k + 0.5; the period stated is two turns, and the run lasts for five."""
    text = past_its_pivot(BY_GROUPS, 0.1, 10 * math.pi + 1).replace("[time]", '[time]\nperiod = "4*pi"')
    run = solve(text, "exact")
    assert run.stop is None
    times = [passage.middle.time for passage in run.scene.search.passages]
    assert times == pytest.approx([0.5 + 2 * math.pi * turn for turn in range(6)], abs=1e-9)
    assert errors(run.motion)["s"] < 1e-11


def test_the_page_says_what_it_goes_through():
    run = solve(past_its_pivot(BY_CLOSURE), "euler", ("table", "plots", "checks", "accuracy"))
    page = html_text(render_html(build_model(run)))
    assert "At t = 0.5 s the equations do not give" in page
    assert "Only one motion continues there" in page


def test_a_check_says_what_it_goes_through(folder, capsys):
    (folder / "through.toml").write_text(past_its_pivot(BY_CLOSURE), encoding="utf-8")
    assert check_variant("through") == 0
    assert "is possible: no dead point.\nAt t = 0.5 s the equations do not give" in capsys.readouterr().out


def test_where_two_motions_meet_the_run_still_ends():
    """The flat parallelogram: two motions that differ go on."""
    run = solve(four_bar(1, 2, 1, 2, (math.pi - 0.3, 0.0, math.pi - 0.3), end=1.0))
    assert run.stop.kind == "change point"
    assert len(run.stop.branches) == 2
    assert run.scene.search.passages == ()


@pytest.mark.parametrize("size", [1.0, 2e-6, 3e3])
@pytest.mark.parametrize("closed", [True, False])
def test_position_equations_tell_which_motion_goes_on_where_a_factor_of_an_equation_vanishes(closed, size):
    """The end of a crank, by d/dt(x^2 + y^2) = 0 and vx = -w y: at y = 0 any vy will do, but x = r cos(a), y = r sin(a)."""
    x, y = size * math.cos(2.5), size * math.sin(2.5)
    start = f'x = {{ start = "{x!r} m", rate = "vx" }}\ny = {{ start = "{y!r} m", rate = "vy" }}'
    text = scene(
        f'a = {{ start = "2.5 rad", rate = "w" }}\n{start}', given=f'r = "{size} m"', drive='w = "2"', step=0.05, end=1.0,
        equations=["vx = -y*w", "vy = -x*vx/y"], more='[closure]\nholds = ["x - r*cos(a)", "y - r*sin(a)"]' if closed else "",
    )  # fmt: skip
    run = solve(text, "rk4")
    middle = (math.pi - 2.5) / 2
    if closed:
        assert [one.middle.time for one in run.scene.search.passages] == pytest.approx([middle], abs=1e-12)
        assert np.max(np.abs(run.motion.column("y") / size - np.sin(run.motion.column("a")))) < 1e-5
    else:
        assert run.stop.time == pytest.approx(middle, abs=1e-8)
        assert len(run.stop.branches) == 2


@pytest.mark.parametrize(("lost", "told"), [("y", None), ("(x+0.999)*y^2", "0.999 + x = 0")])
def test_a_row_just_at_a_passage_follows_from_the_row_before(lost, told):
    """y = 0 after 1.25 s, in row 26; a table of Runge-Kutta 4 was called changed there.  A second zero beside ends the motion."""
    text = scene(
        'a = { start = "2.5 rad", rate = "w" }\n'
        f'x = {{ start = "{math.cos(2.5)!r} m", rate = "vx" }}\ny = {{ start = "{math.sin(2.5)!r} m", rate = "vy" }}',
        drive=f'w = "{2 if told else -2}"', step=0.05, end=30.0 if told else 1.5,
        equations=["vx = -y*w", f"{lost}*vy = -{lost}*x*vx/y"],
        more='[closure]\nholds = ["x - cos(a)", "y - sin(a)"]',
    )  # fmt: skip
    run = solve(text, "rk4", ("table", "checks"))
    assert "was changed" not in run.summary and np.abs(run.exact.column("y") - np.sin(run.exact.column("a"))).max() < 1e-9
    assert told in run.stop.cause if told else [one.middle.time for one in run.scene.search.passages] == pytest.approx([1.25])


def test_a_double_factor_of_an_equation_is_gone_through_though_its_determinant_keeps_its_sign():
    """y^2 (vy - x w) = 0 says nothing at y = 0, where vy = -2 by y = sin(a), after (pi - 2.5)/2 s."""
    text = scene(
        'a = { start = "2.5 rad", rate = "w" }\n'
        f'x = {{ start = "{math.cos(2.5)!r} m", rate = "vx" }}\ny = {{ start = "{math.sin(2.5)!r} m", rate = "vy" }}',
        drive='w = "2"', step=0.05, end=1.5, equations=["vx = -y*w", "y^2*vy = y^2*x*w"],
        more='[closure]\nholds = ["x - cos(a)", "y - sin(a)"]',
    )  # fmt: skip
    run = solve(text, "rk4", ("table", "checks"))
    (passed,) = run.scene.search.passages
    assert passed.middle.time == pytest.approx((math.pi - 2.5) / 2, abs=1e-12) and run.stop is None
    assert passed.middle.velocities["vy"] == pytest.approx(-2, rel=1e-9)
    assert np.abs(run.motion.column("y") - np.sin(run.motion.column("a"))).max() < 1e-5
    assert {one.verdict for one in run.checks} <= {"PASS", "SKIP"}


def test_a_position_equation_that_says_nothing_at_a_change_point_tells_no_motion():
    """A slider on a rod as long as its crank: x (x - 2 r cos(a)) = 0, so at 90 degrees it may stay on the pivot."""
    text = scene(
        f'a = {{ start = "1.2 rad", rate = "w" }}\nx = {{ start = "{0.4 * math.cos(1.2)!r} m", rate = "u" }}',
        given='r = "0.2 m"', drive='w = "1"',
        equations=["x*u - r*u*cos(a) + r*x*w*sin(a) = 0"], more='[closure]\nholds = ["x^2 - 2*x*r*cos(a)"]',
    )  # fmt: skip
    stop = solve(text).stop
    assert stop.time == pytest.approx(math.pi / 2 - 1.2, abs=1e-8)
    assert sorted(branch["u"] for branch in stop.branches) == pytest.approx([-0.4, 0.0], abs=1e-6)


@pytest.mark.parametrize("end", [0.5, 0.501, 0.7])
def test_a_passage_at_the_end_of_the_run_is_gone_through(end):
    run = solve(past_its_pivot(BY_CLOSURE, end / 50, end), "exact")
    assert (run.stop, len(run.motion.t), len(run.scene.search.passages)) == (None, 51, 1)
    assert errors(run.motion)["w"] < 1e-6


@pytest.mark.parametrize(("time", "passed"), [(0.49, True), (0.5, False), (0.51, True)])
def test_a_passage_at_a_break_of_the_drive_is_told_and_not_guessed(time, passed):
    """The two sides of the passage belong to two formulas there, and nothing says that they fit."""
    text = past_its_pivot(BY_CLOSURE, 0.01)
    pieces = f'w1 = {{ pieces = [["0 s", "1"], ["{time} s", "1 + 5*(t - {time})"]] }}'
    run = solve(text.replace('w1 = "1"', pieces))
    assert (run.stop is None) is passed
    if run.stop is None:
        assert errors(run.exact)["s"] < 1e-9
    else:
        assert run.stop.kind == "change point"
        assert "removable" in run.stop.sentence


@pytest.mark.parametrize(("time", "flank"), [(0.002, 1e-4), (1.0, 0.01), (500.0, 2.0)])
def test_between_the_flanks_the_motion_is_known_to_the_ninth_power_and_the_point_to_a_billionth(time, flank):
    """Five states with their rates determine ten coefficients; two coordinates, one of them the other's mirror image."""
    way = np.polynomial.Polynomial([0.3, -1.0, 0.5, 2.0, -0.7, 0.1, 0.9, -0.4, 0.2, 0.6])

    def state(x):
        places, slope = way(x), way.deriv()(x) / flank
        return State(time + x * flank, np.array([places, -places]), {"u": slope, "v": -slope, "other": 9.0})

    passage = Passage(0, state(0.0), tuple(map(state, FLANKS)), flank, ("u", "v"))
    x = np.linspace(-2, 2, 17)
    found = passage.positions(time + x * flank)
    assert found == pytest.approx(np.column_stack([way(x), -way(x)]), abs=1e-7)
    near = time * (1 + np.array([0.0, 0.9e-9, -0.9e-9, 1.1e-9, -1.1e-9]))
    assert passage.is_at(near).tolist() == [True, True, True, False, False]
