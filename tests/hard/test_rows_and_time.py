"""H18, H19, H22, H23, H27, H30, H31: rows against periods, breaks and turns; what a grid of rows shows and hides."""

import itertools
import math
import re
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.extended_precision import march_in
from coursework.motion.integration.integrate import March
from coursework.motion.schemes import SCHEMES
from coursework.results.accuracy.trace import trace
from coursework.results.checks.close_to_motion.period import mismatch
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.variant import whole_steps
from coursework.words.errors import InputError
from tests.hard.drives import Law
from tests.hard.drives import four_bar as driven_four_bar
from tests.hard.edges import as_equations
from tests.hard.scenes import CASES, V31, check, expected, numbers, scene, solve

PERIOD = 2 * math.pi / 13.08


def test_h18_the_mismatch_is_split_into_scheme_period_and_round_off():
    run = coursework.solve("31", quantities=("table", "checks"))
    wanted = expected("H18")
    assert float(wanted["T"]) == pytest.approx(PERIOD, rel=1e-15)
    assert float(wanted["T/dt"]) == pytest.approx(PERIOD / 0.02, rel=1e-15)
    split = {one.name: one for one in mismatch(run.results.evidence)}
    for name, exact, euler in zip(
        ("phi1", "phi2", "phi3"), wanted["exact mismatch phi"], wanted["euler mismatch phi"], strict=True
    ):  # fmt: skip
        one = split[name]
        assert one.total == pytest.approx(float(euler), abs=1e-10)
        assert one.period == pytest.approx(float(exact), abs=1e-11)
        assert abs(one.roundoff) < 1e-14
        assert one.total == pytest.approx(one.scheme + one.period + one.roundoff, abs=1e-15)


def test_h19_a_drive_that_turns_half_a_period_a_step_is_refused():
    wanted = expected("H19")
    alias = float(wanted["alias_of_13.08"])
    assert alias == pytest.approx(13.08 + 2 * math.pi / 0.02, rel=1e-15)
    for frequency in (alias, 2 * math.pi / 0.02, math.pi / 0.02):
        with pytest.raises(InputError, match="another, slower motion that is not there") as caught:
            _ = solve(V31.replace('"13.08 1/s"', f'"{frequency!r} 1/s"'), end=0.1).motion
        assert "20 rows per period" in str(caught.value)
    run = coursework.solve("31", quantities=("table", "checks"))
    assert 13.08 * run.step == pytest.approx(float(wanted["variant31 p*dt"]))
    assert check(run, "STEP").verdict == "PASS"
    assert check(run, "STEP").value == pytest.approx(float(wanted["steps_per_period"]), rel=1e-12)
    coarse = coursework.solve("31", step=0.03, quantities=("table", "checks"))
    assert check(coarse, "STEP").verdict == "COARSE"


def test_h22_a_turning_crank_is_continuous_and_its_turns_are_taken_off():
    case = CASES["H22"]
    text = scene(
        'theta = { start = "0 rad", rate = "w1" }\np = { rate = "wp", unit = "rad" }\ns = { rate = "u", unit = "m" }',
        given='r = "0.4 m"\nl = "1.2 m"',
        drive='w1 = "2"',
        step=math.pi / 120,
        end=3 * math.pi,
        time=f'period = "{math.pi!r} s"',
        more='[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["r"]\ncoordinates = ["theta"]\n'
        '[[group]]\nkind = "RRP"\nfrom = ["A"]\nguide = { through = "(0, 0)", angle = "0" }\nmeets = "B"\n'
        'lengths = ["l"]\ncoordinates = ["p", "s"]\nmode = "+1"',
    )
    run = solve(text, "rk4", quantities=("table", "checks"))
    theta = run.exact.column("theta")
    assert np.allclose(np.diff(theta), math.pi / 60, atol=1e-12)
    recorded = np.arctan2(np.sin(theta), np.cos(theta))
    jumps = [round(0.5 * (a + b), 7) for a, b, c in zip(theta / 2, theta[1:] / 2, np.diff(recorded), strict=False) if c < -3]
    assert np.allclose(jumps, [float(t) for t in case["expected"]["jumps_at"]], atol=math.pi / 120)
    found = check(run, "PERIOD-POSITION")
    assert found.verdict == "PASS"
    assert f"theta made {case['expected']['winding']} whole turn" in found.sentence
    assert check(run, "CONTINUITY").verdict == "PASS"
    ten = solve(text, "rk4", step=0.02, end=10.0)
    assert ten.exact.column("theta")[-1] == pytest.approx(float(case["expected"]["theta_end"]), abs=1e-12)


PULSE = scene(
    'phi = { start = "0 rad", rate = "w" }',
    given='r = "0.5 m"',
    drive='v = { pieces = [["0 s", "0"], ["0.1 s", "1"], ["0.35 s", "0"]] }',
    step=0.02,
    end=0.5,
    equations=["r*w = v"],
)


def test_h23_the_exact_motion_is_split_where_the_drive_breaks():
    run = solve(PULSE, quantities=("table", "checks"))
    wanted = expected("H23")
    assert run.table["phi"].iloc[-1] == pytest.approx(float(wanted["euler dt=0.02"]), abs=1e-15)
    assert run.exact.column("phi")[-1] == pytest.approx(float(wanted["phi_end_exact"]), abs=1e-12)
    assert run.exact.column("phi")[10] == pytest.approx(0.2, abs=1e-12)
    found = check(run, "STEP")
    assert found.verdict == "COARSE"
    assert "at t = 0.35 s, between rows 18 and 19" in found.sentence
    assert check(run, "CONTINUITY").verdict == "PASS"


@pytest.mark.parametrize("scheme", SCHEMES)
def test_h23_with_a_row_at_every_break_nothing_is_lost(scheme):
    run = solve(PULSE, scheme, step=0.05, quantities=("table", "checks"))
    # Only Euler asks no slope from beyond a row; the others still mix old and new formula in the step before a break.
    assert check(run, "STEP").verdict == "SKIP"
    if scheme in {"euler", "midpoint"}:
        assert run.table["phi"].iloc[-1] == pytest.approx(0.5, abs=1e-14)


def test_h23_a_row_that_misses_its_break_by_rounding_alone_stands_on_it():
    text = PULSE.replace('"0.1 s"', '"1.05 s"').replace('"0.35 s"', '"2.1 s"')
    assert 3 * 0.35 < 1.05
    run = solve(text, step=0.35, end=3.5)
    assert run.table["w"].tolist() == [0, 0, 0, 2, 2, 2, 0, 0, 0, 0, 0]
    assert run.exact.column("phi")[-1] == pytest.approx(2.1, abs=1e-11)


def test_h23_a_short_pulse_is_not_stepped_over_by_the_search_for_dead_points():
    """A pulse of 1 ms drives a slider to its dead point: a search with long steps would never see it."""
    text = scene(
        f'theta = {{ start = "{math.pi / 2!r} rad", rate = "w" }}\ns = {{ start = "{math.sqrt(8)!r} m", rate = "u" }}',
        given='r = "1 m"\nl = "3 m"',
        drive='u = { pieces = [["0 s", "0"], ["0.5 s", "2000"], ["0.501 s", "0"]] }',
        step=0.01,
        end=1.0,
        closures=["(s - r*cos(theta))^2 + (r*sin(theta))^2 = l^2"],
    )
    run = solve(text)
    assert run.stop.kind == "dead point"
    assert abs(run.stop.time - (0.5 + (4 - math.sqrt(8)) / 2000)) < 1e-8


def test_h27_more_than_a_drive_period_a_step_is_refused():
    data, wanted = CASES["H27"]["data"], expected("H27")
    assert "dt=0.6" in data["variant31"]
    with pytest.raises(InputError, match="too large for this drive"):
        _ = coursework.solve("31", step=0.6, end=0.6).motion
    with pytest.raises(InputError) as caught:
        _ = solve(V31.replace('"0.02 s"', '"0.3 s"').replace('"0.48 s"', '"1.2 s"')).motion
    line = V31[: V31.index("\nstep ")].count("\n") + 2
    assert str(caught.value).startswith(f"C021 variant:{line}  The step 0.3 s is too large for this drive")
    with pytest.raises(InputError, match=r"^C021 .*31\.toml  The step 0.3 s"):  # a step of the command line stands in no file
        _ = coursework.solve("31", step=0.3).motion
    # Without that guard the width of the first step speaks.
    scene = coursework.solve("31").scene
    found = March(scene.rates, SCHEMES["euler"], 0.6, guarded=[0, 1, 2]).until(scene.start, 0.6)
    assert found.stop.kind == "step too large"
    assert len(found.t) == 1
    alone = March(scene.rates, SCHEMES["euler"], 0.6, guarded=[2]).until(scene.start, 0.6)
    assert any(abs(value - float(wanted["dphi3"])) < 5e-3 for value in numbers(alone.stop.sentence))
    after = 2 * math.cos(2.87 + float(wanted["dphi3"])) + math.sin(2.87 + float(wanted["dphi3"]))
    assert 0.457 * after == pytest.approx(float(wanted["det_after_value"]), abs=1e-9)  # the sign that nobody would have seen


RIPPLES = {
    "n + n/2*sin(k*t)": lambda n, k, t: n * (t + (1 - math.cos(k * t)) / k / 2),
    "n*abs(sin(k*t))": lambda n, k, t: n / k * (2 * (k * t // math.pi) + 1 - math.cos(k * t % math.pi)),
}
SWINGS = [(700.0, "exact"), (200 * math.pi, "rk4"), (1e4, "euler")]


@pytest.mark.parametrize(
    ("formula", "swing", "scheme"),
    [
        pytest.param(formula, *swing, marks=() if (first + second) % 2 == 0 else pytest.mark.long)
        for first, formula in enumerate(RIPPLES)
        for second, swing in enumerate(SWINGS)
    ],
)
def test_h27_a_ripple_on_a_larger_motion_is_followed(formula, swing, scheme):
    """Of whatever has less than two rows a period: the rows are the motion, and STEP says that they do not show the drive."""
    law = Law("ripple", formula, {"n": "3 rad/s", "k": f"{swing!r} 1/s"}, lambda t: t)
    run = coursework.solve(parse_variant(driven_four_bar(law, scheme=scheme)), quantities=("table", "checks"))
    assert run.exact.column("phi1")[-1] == pytest.approx(RIPPLES[formula](3.0, swing, 1.0), abs=1e-12)
    verdicts = {one.code: one.verdict for one in run.checks}
    assert verdicts["STEP"] == "COARSE"
    off = abs(run.motion.column("phi1") - run.exact.column("phi1")).max() / run.results.evidence.scale["phi1"]
    assert verdicts["ACCURACY"] == "COARSE" or off <= 0.05
    with pytest.raises(InputError, match=r"^C021"):
        _ = coursework.solve(parse_variant(driven_four_bar(replace(law, drive="n*sin(k*t)"), scheme=scheme))).motion


@pytest.mark.parametrize(("share", "is_refused"), [(0.019, False), (0.0215, True)])
def test_a_ripple_is_one_up_to_a_fiftieth_of_the_way(share, is_refused):
    """What it may turn within two rows, its height times step/pi, beside the whole turn of n*end; the step is 0.01 of the end."""
    given = {"n": "3 rad/s", "a": f"{share * 3 * 100 * math.pi / 2!r} rad/s", "k": "400 1/s"}
    law = Law("ripple", "n + a*sin(k*t)", given, lambda t: t)
    variant = parse_variant(driven_four_bar(law))
    with pytest.raises(InputError, match=r"^C021") if is_refused else nullcontext():
        _ = coursework.solve(variant, quantities=("table",)).motion


def test_a_ripple_that_cannot_be_followed_is_told_first():
    """Nothing but velocity equations, 1600 ripples: sixteen to a row."""
    law = Law("ripple", "n + n/2*sin(k*t)", {"n": "3 rad/s", "k": "1e4 1/s"}, lambda t: t)
    begin = coursework.solve(parse_variant(driven_four_bar(law))).table.iloc[0]
    run = coursework.solve(parse_variant(as_equations(driven_four_bar(law, scheme="rk4"), begin)))
    assert check(run, "ACCURACY").verdict == "SKIP"
    assert check(run, "ACCURACY").sentence.startswith("The exact motion is not known: it makes more moves")
    assert str(check(run, "ACCURACY").sentence) in run.summary
    assert run.summary.count("not known") == 2  # both within that sentence


def test_h30_time_is_a_multiple_of_the_step_never_a_sum():
    run = coursework.solve("31", step=1e-4, quantities=("table",))
    assert np.array_equal(run.motion.t, np.arange(4801) * 1e-4)
    assert abs(run.motion.t[-1] - 0.48) < 1e-16
    summed = 0.0
    for _ in range(24):
        summed += 0.02
    assert summed > 0.48  # so a loop "while t <= T" would lose the last row
    assert whole_steps(0.02, 0.48) == 24


def test_h30_round_off_never_limits_euler_and_a_running_sum_spoils_single_precision():
    scene = coursework.solve("31").scene
    rates, start = scene.rates, scene.start
    steps = 24 * 2**8
    double = march_in(np.float64, rates, "euler", start, PERIOD / steps, steps, every=steps)[-1]
    wide = march_in(np.longdouble, rates, "euler", start, PERIOD / steps, steps, every=steps)[-1]
    truncation = expected("H30")["float64 Euler truncation"]
    assert re.fullmatch(r"2\.323/N", truncation)
    assert np.max(np.abs(double - start)) == pytest.approx(2.323 / steps, rel=0.05)
    assert np.max(np.abs(double - wide)) < 1e-12
    # Single precision, small version: with 6144 steps t += h has lost what the scheme gained.
    exact = scene.exact.coordinates[-1]
    fine = march_in(np.float64, rates, "euler", start, 0.48 / steps, steps, every=steps)[-1]
    plain, running = (
        march_in(np.float32, rates, "euler", start, 0.48 / steps, steps, every=steps, running_time=summed)[-1]
        for summed in (False, True)
    )
    assert np.max(np.abs(plain - exact)) == pytest.approx(2.323 / steps, rel=0.2)
    assert np.max(np.abs(running - exact)) == pytest.approx(expected("H30")["float32 t+=dt best (N=6144)"], rel=2.0)
    assert np.max(np.abs(running - plain)) > 5 * np.max(np.abs(plain - fine))


def grid_and_end(scheme: str, steps: int) -> tuple[float, float]:
    variant = coursework.load("31")
    run = coursework.solve(variant.timed(0.48 / steps, 0.48), scheme, quantities=("table",))
    gaps = np.abs(run.motion.coordinates - run.exact.coordinates)
    every = steps // 24
    return float(np.max(gaps[::every])), float(np.max(gaps[-1]))


@pytest.mark.parametrize(("scheme", "order", "key"), [("heun", 2, "Heun"), ("rk4", 4, "RK4")])
def test_h31_the_order_shows_over_the_whole_grid_not_at_the_end(scheme, order, key):
    wanted = expected("H31")
    found = [grid_and_end(scheme, 24 * 2**k) for k in range(4)]
    grid, end = [row[0] for row in found], [row[1] for row in found]
    assert grid == pytest.approx(wanted[f"{key} grid-max errors N=24..192"], rel=1e-3)
    ratios = [a / b for a, b in itertools.pairwise(end)]
    assert ratios == pytest.approx(wanted[f"{key} end ratios"][:3], rel=5e-3)
    assert round(math.log2(ratios[-1])) == order + 1  # the trap
    assert round(math.log2(grid[-2] / grid[-1])) == order


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("step", [0.02, 0.03])
def test_a_break_on_a_row_is_met_by_every_scheme(scheme, step):
    """The last slope of the step before the break sees the old drive: a constant rate is integrated exactly by all of them.

    0.33 s is 11 steps of 0.03 s, which as a product of doubles lies below it.
    """
    at = round(11 * step, 10)
    text = scene(
        'p = { start = "0 rad", rate = "w1" }\nq = { start = "0 rad", rate = "w2" }',
        drive=f'w1 = {{ pieces = [["0 s", "6"], ["{at} s", "-2"]] }}', step=step, end=round(22 * step, 10),
        equations=["w2 = 2*w1"],
    )  # fmt: skip
    run = solve(text, scheme=scheme, quantities=("table", "checks"))
    t = run.motion.t
    assert np.max(np.abs(run.motion.column("p") - (6 * np.minimum(t, at) - 2 * np.maximum(t - at, 0)))) < 1e-12
    assert np.max(np.abs(run.results.extended_precision[:, 0].astype(float) - run.motion.column("p"))) < 1e-12
    rates = run.scene.rates
    rows = trace(SCHEMES[scheme], rates, run.scene.start, step, range(23), 3)
    assert np.max(np.abs(rows[:, 0] - run.motion.column("p"))) < 1e-12
