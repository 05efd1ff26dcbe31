"""H20, H21: a thousand periods with and without projection, and the limits of Baumgarte's gain."""

import math
from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.following import NotReached, follow_closure
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.hard.drives import STEP, Law, four_bar, with_sides
from tests.hard.scenes import CASES, check, expected, scene, solve

PERIOD = 2 * math.pi / 13.08
START = np.array([1.63, 3.37, 2.87])


def long_run(periods: int, scheme: str = "euler", **options):
    variant = coursework.load("31").timed(PERIOD / 24, periods * PERIOD * (1 + 1e-12))
    return coursework.solve(variant, scheme, quantities=("table", "checks"), **options)


def off(run) -> np.ndarray:
    """Return the error at the end of each period: the exact motion repeats itself."""
    return np.max(np.abs(run.motion.coordinates[24::24] - START), axis=1)


@pytest.mark.long
def test_h20_one_projection_a_step_holds_for_a_thousand_periods():
    run = long_run(1000, project=1)
    found = off(run)
    wanted = expected("H20")["euler_proj1"]
    assert len(found) == 1000
    assert np.max(found) < 1e-4
    assert np.max(found) == pytest.approx(wanted["max"], rel=1e-3)


def test_h20_two_projections_are_as_good_as_exact():
    assert np.max(off(long_run(30, project=2))) == pytest.approx(expected("H20")["euler_proj2"]["max"], rel=2e-2)


@pytest.mark.parametrize(("scheme", "key"), [("euler", "euler_proj0"), ("heun", "heun_proj0"), ("rk4", "rk4_proj0")])
def test_h20_without_projection_the_error_grows_period_by_period(scheme, key):
    rows = expected("H20")[key]["end_of_period_error"]
    found = off(long_run(100, scheme))
    for period, error, _ in rows:
        if period <= 100:
            assert found[period - 1] == pytest.approx(error, rel=2e-3)


def test_h20_eulers_false_cycle_is_found_out():
    """After 1000 periods the table repeats itself to five digits, 2.7 rad beside the mechanism."""
    run = coursework.solve(
        coursework.load("31").timed(PERIOD / 24, 1000 * PERIOD * (1 + 1e-12)), quantities=("table", "checks")
    )  # fmt: skip
    found = off(run)
    row = expected("H20")["euler_proj0"]["end_of_period_error"][-1]
    assert found[-1] == pytest.approx(row[1], rel=1e-3)
    assert run.motion.coordinates[24000] == pytest.approx(row[2], abs=2e-5)
    assert abs(found[-1] - found[-2]) < 1e-9  # compared with the period before it, nothing is wrong
    drift = check(run, "DRIFT-PER-PERIOD")
    assert drift.verdict == "COARSE"
    assert "has settled on a cycle that the mechanism does not make" in drift.sentence
    labels = {label: value for label, value, _ in drift.rows}
    assert labels["phi2 after 1000 periods"] == pytest.approx(row[2][1] - 3.37, abs=1e-4)


def test_h20_drift_per_period_is_told():
    euler, projected = long_run(5), long_run(5, project=1)
    found = check(euler, "DRIFT-PER-PERIOD")
    assert found.verdict == "COARSE"
    assert "per period" in found.sentence
    assert check(projected, "DRIFT-PER-PERIOD").verdict == "PASS"
    assert check(projected, "PERIOD-POSITION").verdict == "PASS"
    one = coursework.solve("31", quantities=("table", "checks"))
    assert check(one, "DRIFT-PER-PERIOD").verdict == "SKIP"


@pytest.mark.long
@pytest.mark.parametrize("share", [0.25, 0.5, 1.0, 1.5, 1.9])
def test_h20_baumgarte_keeps_the_error_but_not_as_well_as_projection(share):
    run = long_run(150, gain=share / (PERIOD / 24))
    wanted = expected("H20")[f"baumgarte_gdt_{share}"]
    assert np.max(off(run)) == pytest.approx(wanted["max"], rel=1e-8)
    assert np.max(off(run)) > 100 * expected("H20")["euler_proj1"]["max"]


@pytest.mark.parametrize("share", [2.0, 2.05, 2.1])
def test_h20_from_two_on_the_gain_is_refused(share):
    assert expected("H20")[f"baumgarte_gdt_{share}"]["max"] > 1e4
    with pytest.raises(InputError, match="so it grows"):
        long_run(1, gain=share / (PERIOD / 24))


def slide(start: float) -> str:
    """A slide that rests at 1 m and begins a little beside it: the start is open by e0."""
    return scene(
        f'x = {{ start = "{start!r} m", rate = "w" }}', given='l = "2 m"', step=0.02, end=1.2, closures=["x = l/2"]
    )  # fmt: skip


@pytest.mark.parametrize("gain", CASES["H21"]["data"]["g"])
def test_h21_the_error_is_multiplied_by_one_minus_gain_times_step(gain):
    e0 = CASES["H21"]["data"]["e0"]
    last, largest = (float(number) for number in expected("H21")[str(gain)])
    if gain * 0.02 >= 2:
        assert largest >= e0
        with pytest.raises(InputError) as caught:
            solve(slide(1 + e0), gain=gain)
        assert f"The gain {gain} 1/s with the step 0.02 s" in str(caught.value)
        assert f"{1 - gain * 0.02:.3g}" in str(caught.value)
        assert "Take a gain between 0 and 100 1/s; 50 1/s removes the error in one step" in str(caught.value)
        return
    run = solve(slide(1 + e0), gain=gain)
    errors = run.motion.column("x") - 1
    assert np.allclose(errors, e0 * (1 - gain * 0.02) ** np.arange(len(errors)), atol=1e-15)
    assert abs(errors[60]) == pytest.approx(last, rel=1e-3, abs=1e-15)
    assert np.max(np.abs(errors)) == pytest.approx(largest, rel=1e-12)


def test_h21_gain_and_projection_need_position_equations():
    text = scene('x = { start = "0 rad", rate = "w" }', equations=["w = 1"], step=0.1)
    for options in ({"gain": 5.0}, {"project": 1}):
        with pytest.raises(InputError, match="position equations"):
            _ = solve(text, **options).motion
    with pytest.raises(InputError, match="not both"):
        solve(slide(1.0), gain=5.0, project=1)


def test_a_closure_that_cannot_be_followed_gives_up_in_time():
    scene = coursework.solve("31", quantities=["table"]).scene
    closure, rates = scene.closure, scene.rates
    calls = []

    def counted(t, *q):
        calls.append(t)
        return closure.function(t, *q)

    def wrong(t, *q):
        found = rates.evaluate(t, *q)
        return (*[-4e5 * value for value in found[:4]], *found[4:])

    def doubtful(t, *q):
        return tuple(-np.asarray(value) for value in rates.rows(t, *q))

    wrong_rates = replace(rates, evaluate=wrong, rows=doubtful)
    with pytest.raises(NotReached, match=r"beyond t = 0\.02 s"):
        follow_closure(replace(closure, function=counted), wrong_rates, np.arange(25) * 0.02)
    assert len(calls) < 30_000


def uneven(
    turns: float, *, lengths: tuple[float, ...] = (0.4, 1.0, 0.7, 1.2), swings: bool = False, scheme: str = "exact"
) -> str:
    """A crank that turns, or swings by half a radian, so many times in 100 s, and not evenly."""
    law = "n*cos(2*n*t) + 0.1*k*sin(k*t)" if swings else "n + 0.3*n*sin(k*t)"
    text = four_bar(
        Law("uneven", law, {"n": f"{2 * math.pi * turns / 100!r} rad/s", "k": "1.7 1/s"}, float), scheme=scheme, end=100.0
    )
    return with_sides(text, lengths)


@pytest.mark.parametrize("turns", [1000, pytest.param(1e5, marks=pytest.mark.long)])
def test_a_crank_that_can_be_turned_right_round_meets_no_dead_point_in_however_many_turns(turns):
    run = coursework.solve(parse_variant(uneven(turns).replace(f"{STEP!r} s", "0.1 s")))
    n = 2 * math.pi * turns / 100
    assert run.scene.search.given_up < 50
    assert check(run, "STOP").verdict == "PASS"
    assert run.summary.startswith("The table is computed right")
    angle = n * (100 + 0.3 * (1 - math.cos(170)) / 1.7)
    assert run.motion.column("phi1")[-1] == pytest.approx(angle, rel=1e-13)
    assert check(run, "PEAK").verdict != "PASS"  # the fastest moment of all is not known
    assert "V324" not in run.summary


def test_where_it_cannot_be_turned_right_round_nothing_is_said_of_what_was_not_followed():
    run = coursework.solve(parse_variant(uneven(1000, lengths=(0.9, 0.5, 0.6, 1.2), swings=True)))
    assert run.scene.search.given_up < 100
    assert not run.scene.search.goes_round
    assert check(run, "STOP").verdict == "SKIP"
    assert "Whether it meets one after that is not known" in run.summary
