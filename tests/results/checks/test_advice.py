"""The step advised is a whole part of the run's, was run, and is spelled as the command line reads it; else a scheme is named."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.api import load, step_of
from coursework.motion.integration.finer import finer
from coursework.results.checks import advice
from coursework.results.checks.advice import with_advice
from coursework.results.checks.check import motion_findings
from coursework.results.checks.result import Finding
from tests.hard.scenes import scene
from tests.results.checks.scenes import V31, found, solve, verdicts


def motion_verdicts(run) -> set[str]:
    return {one.verdict for one in run.checks if one.group == "motion"}


@pytest.mark.long
@pytest.mark.parametrize(("name", "options"), [
    ("31", {}), ("watt", {"step": 0.03}), ("example-6", {}), ("31", {"gain": 10.0}), ("v108", {"scheme": "heun", "step": 0.06}),
])  # fmt: skip
def test_every_nth_row_is_a_row_of_the_old_table(name, options):
    run = solve(name, **options)
    step = found(run, "ACCURACY").step
    assert step is not None
    parts = round(run.step / step)
    again = solve(name, **{**options, "step": step})
    assert motion_verdicts(again) <= {"PASS", "SKIP"}
    assert np.allclose(again.motion.t[::parts][: len(run.motion.t)], run.motion.t, rtol=1e-15, atol=0)


@pytest.mark.parametrize(("step", "option"), [(None, "h/18"), (0.02 / 2, "h/20"), (0.03, "3h/62"), (0.0137, None)])
def test_the_step_is_a_part_of_the_files_own_where_it_can_be(step, option):
    run = solve("31", step=step)
    accuracy = found(run, "ACCURACY")
    if option:
        assert accuracy.option == f"--step {option}"
        assert accuracy.step == step_of(option, load("31"))
    else:
        assert accuracy.option == f"--step {accuracy.step!r}"
        assert float(accuracy.option.split()[1]) == accuracy.step


def test_a_step_that_leaves_a_row_at_every_break():
    text = scene(
        'phi = { start = "0 rad", rate = "w" }', given='r = "0.5 m"', step=0.02, end=0.5, equations=["r*w = v"],
        drive='v = { pieces = [["0 s", "0"], ["0.13 s", "1"], ["0.35 s", "0"]] }',
    )  # fmt: skip
    run = solve(text)
    assert found(run, "STEP").option == "--step h/2"
    assert verdicts(solve(text, step=0.01))["STEP"] == "SKIP"
    never = solve(text.replace("0.13 s", f"{0.1 * math.sqrt(2)!r} s"))
    assert (found(never, "STEP").verdict, found(never, "STEP").step) == ("COARSE", None)


def test_beyond_the_most_rows_only_a_scheme_is_named(monkeypatch):
    monkeypatch.setattr(advice, "MAX_ROWS", 300)
    run = solve("31")
    accuracy = found(run, "ACCURACY")
    assert (accuracy.step, accuracy.option) == (None, "--scheme rk4")
    assert accuracy.sentence.endswith("Take --scheme rk4 at the old step (0.005 %).")
    assert run.summary.endswith("; take --scheme rk4.")
    assert "FAIL" not in motion_verdicts(run)


def test_a_thousand_periods_of_euler():
    run = solve("31", end=100 * 0.480366)
    accuracy = found(run, "ACCURACY")
    assert accuracy.verdict == "COARSE"
    assert accuracy.step is None or run.end / accuracy.step <= 200_000


@pytest.mark.parametrize(("name", "rows"), [("31", 7), ("example-1", 11), ("robot-arm", 19), ("v110", 5)])
def test_exact_rows_too_far_apart_are_told_a_step_that_does(name, rows):
    """So few rows a run are exact and too far apart; the step advised passes when run, and no scheme is named."""
    end = coursework.load(name).time.end
    run = solve(name, "exact", step=end / rows)
    told = [one for one in run.checks if one.verdict == "COARSE"]
    assert {"STEP"} <= {one.code for one in told} <= {"STEP", "PEAK", "SINUSOID"}
    assert all(one.step and f"Take {one.option}" in one.sentence and "--scheme" not in one.sentence for one in told)
    again = solve(name, "exact", step=told[0].step)
    assert motion_verdicts(again) <= {"PASS", "SKIP"}
    parts = round(run.step / told[0].step)
    assert np.allclose(again.motion.rows[::parts][: len(run.motion.t)], run.motion.rows, rtol=1e-9, atol=1e-9)


def test_the_best_scheme_has_no_better_one():
    run = solve("31", "rk4", step=0.06)
    told = found(run, "STEP")
    assert told.verdict == "COARSE"
    assert "--scheme" not in told.sentence
    assert motion_verdicts(solve("31", "rk4", step=told.step)) <= {"PASS", "SKIP"}


def test_a_period_with_two_digits_over_many_periods_is_cured_by_no_step():
    run = solve(V31.replace('"2*pi/p"', '"0.48 s"'), "rk4", end=30 * 0.48)
    late = found(run, "PERIOD-POSITION")
    assert (late.verdict, late.step) == ("COARSE", None)
    assert "no step makes up for that" in late.sentence


def test_a_trial_that_ends_early_too_leads_to_a_finer_one():
    """A crank of 0.2 m in a sleeve 0.205 m away: the sleeve turns at 126 rad/s when they pass, and h/3 stops there as h does."""
    text = scene(
        'phi = { start = "0 rad", rate = "w1" }\npsi = { start = "0 rad", rate = "w3" }\ns = { start = "0.405 m", rate = "u" }',
        given='r = "0.2 m"', drive='w1 = "pi"', step=1 / 12, end=2.0,
        equations=["u*cos(psi) - s*w3*sin(psi) = -r*w1*sin(phi)", "u*sin(psi) + s*w3*cos(psi) = r*w1*cos(phi)"],
        more='[closure]\nholds = ["s*cos(psi) - r*cos(phi)", "s*sin(psi) - r*sin(phi)"]',
    )  # fmt: skip
    run = solve(text, "rk4")
    assert (verdicts(run)["STOP"], verdicts(run)["PEAK"]) == ("COARSE", "COARSE")
    assert verdicts(solve(text, "rk4", step=1 / 36))["STOP"] == "COARSE"
    advised = found(run, "PEAK").step
    assert advised is not None
    again = solve(text, "rk4", step=advised)
    assert verdicts(again)["STOP"] == "PASS"
    assert motion_verdicts(again) <= {"PASS", "SKIP"}


def test_nothing_is_advised_for_a_mechanism_that_stops():
    dead = solve(V31.replace('alpha = "4.35 rad"', 'alpha = "0.02 rad"'))
    assert not any(one.option for one in dead.checks)


def test_what_passes_is_left_as_it_is():
    run = solve("31", "rk4")
    assert with_advice(run.results.evidence, run.checks, motion_findings) == list(run.checks)


@pytest.mark.parametrize("name", ["31", "example-6", "engine-start", "robot-arm", "variable-crank-table"])
@pytest.mark.parametrize("parts", [2, 3, 7])
def test_the_exact_motion_between_its_rows(name, parts):
    """Followed by a few steps from each row it is the one found on finer rows the usual way."""
    run = coursework.solve(name, quantities=["table"])
    close = coursework.solve(name, step=run.step / parts, quantities=["table"]).exact
    made = finer(run.exact, run.scene.rates, parts, len(close.t))
    assert made is not None
    scale = np.ptp(close.rows, axis=0) + 0.1 * np.max(np.abs(close.rows), axis=0)
    assert np.max(np.abs(made.rows - close.rows) / np.where(scale > 0, scale, 1.0)) < 1e-4
    assert finer(run.exact, run.scene.rates, parts, 10 * len(close.t)) is None


@pytest.mark.parametrize(("shares", "looked_at", "told"), [
    ({10: 0.04, 15: 0.04}, [10, 15], None), ({10: 0.04, 15: 0.06}, [10, 15], (15, 0.06)), ({10: 0.06}, [10], (10, 0.06)),
])  # fmt: skip
def test_a_half_and_a_third_of_an_advised_step_have_to_do_as_well(shares, looked_at, told, monkeypatch):
    tried = []
    monkeypatch.setattr(advice, "_affordable", lambda *_: True)
    monkeypatch.setattr(advice, "_spelled", lambda evidence, parts: ("", parts))
    monkeypatch.setattr(advice, "_glanced", lambda evidence, motion, parts: shares[parts])
    judged = SimpleNamespace(rerun=lambda own, parts: tried.append(parts) or "rows")
    assert (advice._worse(judged, "euler", 5, 1), tried) == (told, looked_at)


@pytest.mark.parametrize(
    ("code", "value", "limit", "order", "times"),
    [
        ("ACCURACY", 0.4, 0.05, 1, 10.0), ("ACCURACY", 0.16, 0.05, 2, 2.0), ("ACCURACY", 50.0, 0.05, 1, 250.0),
        ("ACCURACY", 9.0, 0.05, 1, 225.0), ("DRIFT", 0.4, 0.01, 1, 2.0), ("ACCURACY", None, 0.05, 1, 2.0),
        ("STEP", 4.0, 12.0, 1, 3.0), ("PEAK", 0.3, 0.1, 4, 3.0), ("PEAK", 0.3, None, 4, 2.0),
    ],
)  # fmt: skip
def test_how_many_times_finer_a_step_is_asked_for(code, value, limit, order, times):
    """Four fifths of the 5 % are aimed at; of an error beyond ten times the scale no more is believed."""
    assert advice._growth(Finding("COARSE", "Told.", value, limit, code=code), order) == pytest.approx(times)


@pytest.mark.parametrize(("weight", "rows", "is_had"), [(1.0, 1e6, False), (300.0, 1e4, True), (301.0, 1e4, False)])
def test_a_step_is_tried_that_costs_no_more_than_three_million_slopes(weight, rows, is_had, monkeypatch):
    monkeypatch.setattr(advice, "MAX_ROWS", 20_000)
    evidence = SimpleNamespace(
        variant=SimpleNamespace(time=SimpleNamespace(end=rows / 2 * 0.1)), motion=SimpleNamespace(step=0.1),
        rates=SimpleNamespace(weight=weight),
    )  # fmt: skip
    assert advice._affordable(evidence, 2, 1) == is_had


@pytest.mark.parametrize(("share", "is_doubted"), [(0.0101, False), (0.0099, True)])
def test_an_error_four_times_smaller_than_the_order_foretells_may_be_luck(share, is_doubted, monkeypatch):
    """Of 40 % with the run's own step a tenth of it makes 4 % by Euler's scheme."""
    doubted = []
    for name, stands in {
        "_affordable": lambda *_: True, "_spelled": lambda evidence, parts: ("", parts), "parts_at_breaks": lambda *_: None,
        "_glanced": lambda *_: share, "_tried": lambda *_: "tried", "_worse": lambda *given: doubted.append(given[2]),
    }.items():  # fmt: skip
        monkeypatch.setattr(advice, name, stands)
    coarse = [Finding("COARSE", "", 0.4, 0.05, code="ACCURACY")]
    found = advice._step(SimpleNamespace(rerun=lambda *_: "rows"), "euler", coarse, lambda tried: [], 1)
    assert (found, doubted) == ((10, None), [10] * is_doubted)


@pytest.mark.parametrize(("step", "own", "time_step", "parts", "told"), [
    (0.02, None, 0.02, 4, ("h/4", 0.005)), (0.02, None, 0.02, 1, ("0.02", 0.02)), (0.02, 0.04, 0.02, 1, ("h/2", 0.02)),
    (0.03, 0.02, 0.03, 3, ("h/2", 0.01)), (0.02, 0.03, 0.02, 1, ("0.02", 0.02)),
    (0.02, 0.03, 0.02, 3, ("2h/9", 0.03 * 2 / 9)), (0.015, 0.02, 0.015, 7, ("3h/28", 0.02 * 3 / 28)),
    (0.019997, 0.02, 0.019997, 3, ("0.006665666666666667", 0.019997 / 3)),
    (0.0375, 0.0125, 0.0375, 3, ("0.0125", 0.0125)), (0.075, 0.0125, 0.075, 3, ("0.025", 0.025)),
    (0.02, 0.02 * (1 + 0.9e-12), 0.02, 2, ("h/2", 0.01 * (1 + 0.9e-12))), (0.02, 0.02 * (1 + 1.1e-12), 0.02, 2, ("0.01", 0.01)),
])  # fmt: skip
def test_a_step_is_told_as_a_part_of_that_of_the_file_if_it_is_one(step, own, time_step, parts, told):
    time = SimpleNamespace(own_step=own, step=time_step)
    evidence = SimpleNamespace(motion=SimpleNamespace(step=step), variant=SimpleNamespace(time=time))
    assert advice._spelled(evidence, parts) == told


@pytest.mark.parametrize(("option", "told"), [
    ("h/26", "Take --step h/26 (0.00123 s)."), ("5h/104", "Take --step 5h/104 (0.00123 s)."), ("0.00123", "Take --step 0.00123."),
])  # fmt: skip
def test_a_part_of_the_step_is_told_in_seconds_too(option, told):
    assert str(advice.Advice(option, 0.00123, "", 0.0).sentence) == told
