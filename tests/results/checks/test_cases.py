"""Runs in which a table was far from the motion and nothing said so, or was close and called wrong; each as it must be told."""

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism
from tests.results.checks import closed_form
from tests.results.checks.scenes import V31, found, solve, verdicts

VARIANTS = Path(__file__).parents[3] / "variants"


def coarse(run) -> set[str]:
    return {code for code, verdict in verdicts(run).items() if verdict == "COARSE"}


def test_run_31_says_in_its_first_line_that_phi1_is_off_by_70_percent(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["run", "31", "--format", "csv"])
    assert done.exit_code == 0
    assert done.stdout.splitlines()[0] == (
        "The table is computed right: 5 of 5 checks of the computation; the start is not judged. It is not close to the motion: "
        "largest error 69.8 % of 0.2 rad (phi1, row 20); take --step h/18."
    )
    record = json.loads((tmp_path / "coursework-31" / "run.json").read_text(encoding="utf-8"))
    assert record["summary"] == done.stdout.splitlines()[0]
    accuracy = next(check for check in record["checks"] if check["code"] == "ACCURACY")
    assert (accuracy["column"], accuracy["row"], accuracy["verdict"], accuracy["unit"]) == ("phi1", 20, "COARSE", "of the scale")
    assert accuracy["value"] == pytest.approx(0.70, abs=0.005)
    assert accuracy["step"] == 0.02 / 18
    assert accuracy["sentence"].endswith("Take --step h/18 (0.00111 s), or --scheme rk4 at the old step (0.005 %).")
    again = CliRunner().invoke(main, ["run", "31", "--step", "h/18", "--strict", "--format", "csv"])
    assert again.exit_code == 0, again.output


def test_the_swing_of_phi1_by_the_closed_form():
    """The 70 % again from formulas typed by hand: error of Euler's phi1 over the range of the exact phi1."""
    truth = closed_form.exact().coordinates[:, 0]
    errors = np.abs(closed_form.euler().coordinates[:, 0] - truth) / np.ptp(truth)
    assert (int(np.argmax(errors)) + 1, float(np.max(errors))) == (20, pytest.approx(0.6976, abs=5e-5))


def test_stephenson_whose_last_row_was_said_to_repeat_the_first():
    run = solve("stephenson", step=0.03141592653589793)
    velocity = found(run, "PERIOD-VELOCITY")
    assert (velocity.verdict, velocity.column) == ("COARSE", "w7")
    assert (velocity.first, velocity.last) == (pytest.approx(-1.96, abs=0.005), pytest.approx(-22.92, abs=0.005))
    assert found(run, "ACCURACY").value == pytest.approx(1.36, abs=0.005)


@pytest.mark.parametrize("periods", range(2, 11))
def test_a_sine_is_a_sine_over_any_number_of_periods(periods):
    run = solve("31", "rk4", end=periods * 0.480366)
    sine = found(run, "SINUSOID")
    assert (sine.verdict, sine.value) == ("PASS", pytest.approx(0.993, abs=0.0015))


@pytest.mark.long
def test_31_to_ten_periods_with_m_half_a_metre_off():
    run = solve("31", end=4.8)
    drift = found(run, "DRIFT")
    assert (drift.verdict, drift.value) == ("COARSE", pytest.approx(1.16, abs=0.005))
    assert "0.531 m off" in drift.sentence
    assert "116.3 % of the shortest length (0.457 m)" in drift.sentence


def test_seven_rows_a_turn():
    run = solve("example-1", step=0.08975979010256552)
    assert coarse(run) >= {"ACCURACY", "STEP"}
    assert found(run, "STEP").value == pytest.approx(7)
    assert coarse(solve("example-1", step=2 * np.pi / 10 / 12)) >= {"ACCURACY", "STEP"}


@pytest.mark.parametrize(("name", "column", "value"), [("31", "phi1", 0.70), ("whitworth", "w3", 0.56), ("watt", "w6", 0.32)])
def test_as_shipped(name, column, value):
    accuracy = found(solve(name), "ACCURACY")
    assert (accuracy.verdict, accuracy.column, accuracy.value) == ("COARSE", column, pytest.approx(value, abs=0.005))


def test_an_arm_that_drifts_leaves_the_way_of_its_hand_and_no_link_another():
    judged = found(solve("robot-arm", step=0.1), "DRIFT")
    assert judged.verdict == "COARSE" and judged.column in {"M.x", "M.y"}
    assert "with this step M leaves the path along which it is driven" in judged.sentence


def test_passing_near_a_dead_point():
    run = solve(V31.replace('alpha = "4.35 rad"', 'alpha = "1.66 rad"'))
    assert coarse(run) >= {"ACCURACY", "PERIOD-VELOCITY", "DRIFT", "CONTINUITY"}
    assert verdicts(run)["SINUSOID"] == "PASS"
    assert "FAIL" not in verdicts(run).values()


@pytest.mark.parametrize("factor", [2, 1.5, 3])
def test_two_frequencies_are_sinusoidal_and_judged_by_the_slower(factor):
    text = (VARIANTS / "v105.toml").read_text(encoding="utf-8").replace("V2*cos(p*t + alpha)", f"V2*cos({factor}*p*t + alpha)")
    run = solve(text, "rk4", end=1.0)
    sine = found(run, "SINUSOID")
    if run.stop is None:
        assert (sine.verdict, sine.value > 0.9) == ("PASS", True), sine


def test_an_overflowing_motion_is_not_called_wrong_for_not_being_a_sine():
    sine = found(solve(V31.replace('alpha = "4.35 rad"', 'alpha = "1.60 rad"')), "SINUSOID")
    assert sine.verdict == "SKIP"
    assert "nothing is wrong with the table" in sine.sentence


@pytest.mark.parametrize("name", ["31", "v108", "v110", "variable-crank", "variable-crank-exact"])
def test_a_coarse_grid_of_a_good_scheme_has_no_jump(name):
    run = solve(name, "rk4", step=3 * coursework.load(name).time.step)
    assert verdicts(run)["CONTINUITY"] == "PASS"


@pytest.mark.parametrize("step", [0.02, 0.001, 0.0004, 0.0001])
def test_the_period_is_judged_whatever_the_step(step):
    """0.48 s is the period 0.480366 s to the task sheet, also where a row lies nearer to it."""
    judged = verdicts(solve("31", step=step))
    assert "SKIP" not in {judged[code] for code in ("PERIOD-POSITION", "PERIOD-VELOCITY", "PERIOD-ASSEMBLY", "SINUSOID")}
    assert "FAIL" not in judged.values()
    if step <= 0.001:
        assert coarse(solve("31", step=step)) == set()


def test_a_file_without_geometry_says_so_first():
    head, mark, tail = V31.partition("\n[points]")
    rest = tail[tail.index("\n[[constraint]]") :] if "\n[[constraint]]" in tail else ""
    bare = head + rest if mark else V31
    assert "[closure]" not in bare
    run = solve(bare)
    assert run.summary.startswith("Signs are not checked: no geometry judges the equations. The table is computed right: ")
    assert verdicts(run)["AGREEMENT"] == "SKIP"
    for code in ("INITIAL", "RESIDUAL"):
        assert "this tests the arithmetic only" in found(run, code).sentence
    assert found(run, "DRIFT").verdict == "SKIP"
    assert "this tests the arithmetic only" not in found(solve("31"), "RESIDUAL").sentence


def test_derived_equations_need_no_agreement():
    agreement = found(solve("example-1"), "AGREEMENT")
    assert agreement.verdict == "SKIP"
    assert "derived from the geometry" in agreement.sentence


def test_an_equation_that_alone_knows_a_velocity_is_not_said_to_be_checked():
    extra = '\n[[constraint]]\nname = "tail"\nbecause = "a counter"\nequation = "w9 = 3*w3"\n'
    text = V31.replace('w4 = "1/s"', 'w4 = "1/s"\nw9 = "1/s"') + extra
    agreement = found(solve(text), "AGREEMENT")
    assert (agreement.verdict, agreement.value, agreement.limit) == ("SKIP", None, None)
    assert agreement.sentence.startswith("4 of 5 equations agree; tail is not judged: nothing in the geometry gives w9.")


@pytest.mark.parametrize("scheme", ["rk4", "exact"])
def test_a_drive_that_fades_away_leaves_nothing_to_be_wrong(scheme):
    """Products of doubles below 1e-292 have no longer sixteen digits: their residual is none of the equations'."""
    text = (VARIANTS / "31.toml").read_text(encoding="utf-8").replace("V1*sin(p*t + alpha)", "V1*exp(-117*p*t)")
    faded = parse_variant("\n".join(line for line in text.splitlines() if not line.startswith("period")))
    run = coursework.solve(faded, scheme=scheme, step=0.02 / 8, quantities=["table", "checks"])
    assert np.min(np.abs(run.motion.column("w1")[1:])) < 1e-300
    assert next(check.verdict for check in run.checks if check.code == "RESIDUAL") == "PASS"


@pytest.mark.parametrize(("name", "radius", "periods"), [("cardan", "105 mm", 21), ("epicyclic", "42 mm", 7)])
def test_a_wheel_of_another_radius_does_not_make_the_period_wrong(name, radius, periods):
    run = coursework.solve(coursework.load(name).with_data(given={"R": radius}), quantities=["table", "checks"])
    for code in ("PERIOD-POSITION", "PERIOD-VELOCITY"):
        assert found(run, code).verdict == "SKIP"
        assert f"after {periods} periods of the drive" in found(run, code).sentence


def test_where_drives_place_everything_no_equation_is_judged_and_none_is_called_an_error():
    run = solve(mechanism("driven-wheel-on-a-line"))
    told = verdicts(run)
    assert "ERROR" not in told.values() and told["RESIDUAL"] == "SKIP"
    assert found(run, "RESIDUAL").sentence == "There is nothing to solve for."
