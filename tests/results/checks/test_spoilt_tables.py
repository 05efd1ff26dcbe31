"""A table that nobody has changed is never called wrong, a changed one always; a crash is the tool's own fault."""

from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.integrate import March
from coursework.motion.schemes import scheme_of
from coursework.results.checks import check as records
from coursework.results.checks.check import check_motion
from tests.mechanisms.library import mechanism
from tests.results.checks.scenes import CODES, V31, evidence_of, finding, found, solve, spoil, verdicts

DEAD = V31.replace('alpha = "4.35 rad"', 'alpha = "0.02 rad"')


@pytest.fixture(scope="module")
def run():
    return solve("31")


def test_the_honest_run_is_computed_right_and_not_close(run):
    expected = dict.fromkeys(CODES, "PASS")
    expected |= dict.fromkeys(("START", "TABLE-DIGITS", "QUOTE", "DRIFT-PER-PERIOD"), "SKIP")
    expected |= dict.fromkeys(("ACCURACY", "PERIOD-POSITION", "PERIOD-VELOCITY", "CONTINUITY", "DRIFT"), "COARSE")
    assert verdicts(run) == expected
    assert run.passed
    assert (run.status(), run.status(strict=True)) == (0, 1)


@pytest.mark.long
@pytest.mark.parametrize("options", [{}, {"scheme": "rk4"}, {"project": 1}, {"project": 2, "scheme": "heun"}, {"gain": 20.0}])
@pytest.mark.parametrize("column", ["phi1", "phi3", "w1", "w4"])
def test_a_changed_cell_is_found_beyond_round_off_and_only_there(options, column):
    run = solve("31", **options)
    scale = run.results.evidence.scale[column]
    for change, verdict in ((0.5e-9, found(run, "ACCURACY").verdict), (2e-9, "FAIL"), (-0.3, "FAIL")):
        judged = finding("ACCURACY", evidence_of(run, motion=spoil(run.motion, **{column: (7, change * scale)})))
        assert judged.verdict == verdict, change
        if verdict == "FAIL":
            assert judged.row == 8
            assert "the table was changed" in judged.sentence


def test_a_changed_start_and_a_changed_last_row_are_found(run):
    for row in (0, 24):
        judged = finding("ACCURACY", evidence_of(run, motion=spoil(run.motion, phi2=(row, 1e-4))))
        assert (judged.verdict, judged.column, judged.row) == ("FAIL", "phi2", row + 1)
    assert (
        "Row 1 of phi2 is not the start"
        in finding("ACCURACY", evidence_of(run, motion=spoil(run.motion, phi2=(0, 1e-4)))).sentence
    )


def test_rows_of_somebody_else_are_judged_by_closeness_alone(run):
    exact = replace(run.exact, scheme="theirs")
    assert finding("ACCURACY", evidence_of(run, motion=exact, replay=None)).verdict == "PASS"
    rounded = replace(exact, coordinates=np.round(exact.coordinates, 3), velocities=np.round(exact.velocities, 2))
    judged = finding("ACCURACY", evidence_of(run, motion=rounded, replay=None))
    assert judged.verdict == "PASS"
    assert 0 < judged.value < 0.01


@pytest.mark.parametrize(("code", "cells"), [("INITIAL", {"w1": (0, 0.01)}), ("RESIDUAL", {"w2": (7, 1e-6)})])
def test_velocities_that_satisfy_no_equation(run, code, cells):
    assert finding(code, evidence_of(run)).verdict == "PASS"
    judged = finding(code, evidence_of(run, motion=spoil(run.motion, **cells)))
    assert (judged.verdict, judged.row) == ("FAIL", next(iter(cells.values()))[0] + 1)


def test_another_assembly_in_the_table_is_coarse_and_in_the_exact_motion_wrong(run):
    def turned(motion):
        determinants = motion.determinants.copy()
        determinants[10:, 0] *= -1
        return replace(motion, determinants=determinants)

    for verdict, changes in (("COARSE", {"motion": turned(run.motion)}), ("FAIL", {"exact": turned(run.exact)})):
        judged = finding("PERIOD-ASSEMBLY", evidence_of(run, **changes))
        assert (judged.verdict, judged.row, judged.sentence.values["row"]) == (verdict, 11, 11)


def test_a_motion_that_stops():
    dead = solve(DEAD)
    stop = found(dead, "STOP")
    assert (stop.verdict, stop.row) == ("FAIL", 6)
    assert stop.value == pytest.approx(0.116889254610302411, abs=1e-8)
    assert found(dead, "PERIOD-VELOCITY").verdict == "SKIP"
    assert all(one.step is None for one in dead.checks)
    assert dead.status() == 1
    assert dead.summary.startswith("The motion stops at t = 0.116889 s.")


@pytest.mark.parametrize("name", ["peaucellier", "watt", "whitworth"])
def test_a_step_that_is_too_large_stops_the_table_and_not_the_mechanism(name):
    run = solve(name, step=3 * coursework.load(name).time.step)
    stop = found(run, "STOP")
    assert run.motion.stop is not None
    assert "the step is too large" in run.summary
    assert stop.verdict == "COARSE"
    assert run.status() == 1
    assert run.scene.stop is None
    again = solve(name, step=stop.step)
    assert again.stop is None
    assert {one.verdict for one in again.checks} <= {"PASS", "SKIP"}


def test_the_25_rows_of_a_naive_loop_do_not_pass(run):
    """Velocities alone repeat to 0.33 % of their peaks; where the mechanism stops gives the fraud away."""
    dead = solve(DEAD)
    rates, start = dead.scene.rates, dead.scene.start
    q, rows = np.array(start), []
    for i in range(25):
        rows.append((q, rates.evaluate(i * 0.02, *q)))
        q = q + 0.02 * np.array(rows[-1][1][:3])
    table = np.array([row for _, row in rows])
    naive = replace(
        run.motion, coordinates=np.array([q for q, _ in rows]), velocities=table[:, :4].copy(), determinants=table[:, 4:].copy()
    )
    gap = np.abs(naive.velocities[24] - naive.velocities[0]) / np.max(np.abs(naive.velocities), axis=0)
    assert np.max(gap) < 0.0034
    evidence = evidence_of(dead, motion=naive)
    accuracy = finding("ACCURACY", evidence)
    assert (accuracy.verdict, accuracy.row) == ("FAIL", 7)
    assert "The mechanism stops at t = 0.116889 s: row 7" in accuracy.sentence
    assert finding("PERIOD-ASSEMBLY", evidence).verdict == "COARSE"
    assert finding("DRIFT", evidence).verdict == "COARSE"
    assert finding("PERIOD-POSITION", evidence).verdict == "SKIP"


def test_a_turn_of_two_pi_is_no_jump_and_no_error(run):
    wrapped = run.motion.coordinates.copy()
    wrapped[12:, 1] -= 2 * np.pi
    evidence = evidence_of(run, motion=replace(run.motion, coordinates=wrapped))
    for code in ("ACCURACY", "CONTINUITY", "PERIOD-POSITION"):
        before, after = finding(code, evidence_of(run)), finding(code, evidence)
        assert (after.verdict, after.value) == (before.verdict, pytest.approx(before.value))
    assert "whole turn" in finding("PERIOD-POSITION", evidence).sentence


@pytest.mark.parametrize("broken", [ZeroDivisionError("by us"), TypeError("by us"), RuntimeError("by us")])
@pytest.mark.parametrize("place", range(0, len(CODES), 5))
def test_a_check_that_crashes_is_an_error_of_the_tool_and_the_others_go_on(run, monkeypatch, broken, place):
    def judge(_evidence):
        raise broken

    whole = verdicts(run)
    checks = list(records.CHECKS)
    checks[place] = replace(checks[place], judge=judge, needs=())
    monkeypatch.setattr(records, "CHECKS", tuple(checks))
    judged = check_motion(evidence_of(run))
    assert [one.code for one in judged if one.verdict == "ERROR"] == [CODES[place]]
    assert "neither for nor against you" in judged[place].sentence
    others = {one.code: one.verdict for one in judged if one.code != CODES[place]}
    assert others == {code: verdict for code, verdict in whole.items() if code != CODES[place]}


def test_the_march_keeps_its_first_row_whatever_the_scheme(run):
    for scheme in ("euler", "midpoint", "heun", "rk4"):
        motion = March(run.scene.rates, scheme_of(scheme), 0.02).until(run.scene.start, 0.48)
        assert np.array_equal(motion.rows[0], run.motion.rows[0])
        assert len(motion.t) == 25
        assert motion.t[3] == 3 * 0.02


@pytest.mark.parametrize("options", [{}, {"project": 1}, {"scheme": "rk4"}])
@pytest.mark.parametrize("start", ["-0.120", "-0.12015", "-0.1201453", "-0.1201453472"])
def test_a_rounded_start_is_told_by_start_and_no_drift(start, options):
    """The velocity equations keep what the start leaves open; nobody is blamed for it twice."""
    judged = verdicts(solve(mechanism("slider-crank-loop", ("-0.1201453472", start)), **options))
    assert judged["DRIFT"] == "PASS"
    assert judged["START"] == ("COARSE" if len(start) < 10 else "PASS")


@pytest.mark.parametrize("columns", [["phi3"], ["w3"], ["phi1"], ["phi2", "phi3"], ["w4"]])
def test_a_restricted_table_can_be_judged_as_far_as_it_goes(columns):
    judged = verdicts(coursework.solve("31", quantities=columns))
    assert "ERROR" not in judged.values()
    assert "FAIL" not in judged.values()
    assert {code for code, verdict in judged.items() if verdict == "SKIP"} >= {"INITIAL", "RESIDUAL", "CONDITION", "DRIFT"}
