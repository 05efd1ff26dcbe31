"""Each check passes on the honest run of variant 31 and fails on one spoilt for it; a naive loop through a dead point fails."""

from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.checks.check import CHECKS, check_motion
from coursework.checks.period import mismatch
from coursework.integration.integrate import march
from coursework.variant.reader import parse_variant


def evidence_of(run, **changes):
    """Return the evidence of a run with some of it exchanged."""
    return replace(run.results.evidence, **changes)


@pytest.fixture(scope="module")
def run():
    return coursework.solve("31", quantities=["table", "checks"])


def spoil(motion, **columns):
    """Return the motion with single cells changed: column = (row, change)."""
    coordinates, velocities = motion.coordinates.copy(), motion.velocities.copy()
    for name, (row, change) in columns.items():
        rows = coordinates if name in motion.coordinate_names else velocities
        names = motion.coordinate_names if name in motion.coordinate_names else motion.velocity_names
        rows[row, names.index(name)] += change
    return replace(motion, coordinates=coordinates, velocities=velocities)


def verdict(code, evidence):
    return CHECKS[code](evidence).verdict


def test_the_honest_run_passes_every_check_that_applies(run):
    found = {check.code: check.verdict for check in check_motion(evidence_of(run))}
    assert set(found) == set(CHECKS)
    assert {code for code, verdict in found.items() if verdict not in {"PASS", "SKIP"}} == set()
    assert {code for code, verdict in found.items() if verdict == "SKIP"} == {"START", "DRIFT-PER-PERIOD"}


@pytest.mark.parametrize(
    ("code", "cells"),
    [
        ("INITIAL", {"w1": (0, 0.01)}),
        ("RESIDUAL", {"w2": (7, 1e-6)}),
        ("PERIOD-POSITION", {"phi1": (24, 0.5)}),
        ("PERIOD-VELOCITY", {"w3": (24, 3.0)}),
        ("CONTINUITY", {"phi2": (11, 0.3)}),
        ("CONTINUITY", {"w4": (9, 40.0)}),
        ("DRIFT", {"phi3": (6, 0.6)}),
    ],
    ids=lambda value: value if isinstance(value, str) else "-".join(value),
)
def test_a_changed_cell(run, code, cells):
    evidence = evidence_of(run)
    assert verdict(code, evidence) == "PASS"
    assert verdict(code, replace(evidence, motion=spoil(run.motion, **cells))) == "FAIL"


def test_assembly(run):
    determinants = run.motion.determinants.copy()
    determinants[10:, 0] *= -1
    assert verdict("PERIOD-ASSEMBLY", evidence_of(run, motion=replace(run.motion, determinants=determinants))) == "FAIL"


def test_sinusoid(run):
    saw = run.motion.velocities.copy()
    saw[:, 0] = np.where(np.arange(25) % 2, 3.0, -3.0)
    assert verdict("SINUSOID", evidence_of(run, motion=replace(run.motion, velocities=saw))) == "FAIL"


def test_step():
    coarse = coursework.solve("31", step=0.04, quantities=["checks"])
    assert {check.code: check.verdict for check in coarse.checks}["STEP"] == "FAIL"


def test_stop(run, tmp_path):
    text = run.variant.path.read_text(encoding="utf-8").replace('alpha = "4.35 rad"', 'alpha = "0.02 rad"')
    (tmp_path / "dead.toml").write_text(text, encoding="utf-8")
    dead = coursework.solve(tmp_path / "dead.toml", quantities=["checks"])
    found = {check.code: check for check in dead.checks}
    assert found["STOP"].verdict == "FAIL"
    assert found["STOP"].value == pytest.approx(0.116889254610302411, abs=1e-8)
    assert found["PERIOD-VELOCITY"].verdict == "SKIP"
    assert not dead.passed


def test_the_25_rows_of_a_naive_loop_do_not_pass(run, tmp_path):
    """Velocities alone repeat to 0.33 % of their peaks; positions and the sign of a determinant give the fraud away."""
    text = run.variant.path.read_text(encoding="utf-8").replace('alpha = "4.35 rad"', 'alpha = "0.02 rad"')
    (tmp_path / "dead.toml").write_text(text, encoding="utf-8")
    dead = coursework.solve(tmp_path / "dead.toml", quantities=["checks"])
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
    evidence = evidence_of(run, motion=naive)
    assert verdict("PERIOD-POSITION", evidence) == "FAIL"
    assert verdict("PERIOD-ASSEMBLY", evidence) == "FAIL"
    assert verdict("DRIFT", evidence) == "FAIL"


def test_a_turn_of_two_pi_is_no_jump_and_no_mismatch(run):
    wrapped = run.motion.coordinates.copy()
    wrapped[12:, 1] -= 2 * np.pi
    evidence = evidence_of(run, motion=replace(run.motion, coordinates=wrapped))
    assert verdict("CONTINUITY", evidence) == "PASS"
    position = CHECKS["PERIOD-POSITION"](evidence)
    assert position.verdict == "PASS"
    assert "whole turn" in position.sentence


def test_a_steep_slope_is_no_jump():
    """Close to the feasible edge the curves turn sharply; the half-step run shows that they are curves."""
    text = coursework.load("31").path.read_text(encoding="utf-8").replace('alpha = "4.35 rad"', 'alpha = "1.60 rad"')
    steep = coursework.solve(parse_variant(text), "rk4", step=0.01, quantities=["checks"])
    found = {check.code: check for check in steep.checks}
    assert found["CONTINUITY"].verdict == "PASS", found["CONTINUITY"]


def test_a_fault_inside_a_check_is_an_error_of_the_tool(run, monkeypatch):
    def broken(_evidence):
        raise ZeroDivisionError("by us")

    monkeypatch.setitem(CHECKS, "STEP", broken)
    found = {check.code: check for check in check_motion(evidence_of(run))}
    assert found["STEP"].verdict == "ERROR"
    assert "neither for nor against you" in found["STEP"].sentence


def test_limits_come_from_the_scheme(run):
    """A finer step has a smaller limit; with a better scheme it is smaller still."""

    def limits(scheme, step):
        splits = mismatch(evidence_of(coursework.solve("31", scheme, step=step, quantities=["checks"])))
        return np.array([split.limit for split in splits])

    assert np.all(limits("euler", 0.01) < 0.7 * limits("euler", 0.02))
    assert np.all(limits("rk4", 0.02) < 0.2 * limits("euler", 0.02))


def test_the_march_keeps_its_first_row_whatever_the_scheme(run):
    for scheme in ("euler", "midpoint", "heun", "rk4"):
        motion = march(run.scene.rates, scheme, run.scene.start, 0.02, 0.48)
        assert np.array_equal(motion.rows[0], run.motion.rows[0])
        assert len(motion.t) == 25
        assert motion.t[3] == 3 * 0.02


@pytest.mark.parametrize("period", ["0.40 s", "0.45 s", "0.2*2"])
def test_a_wrong_period_is_found_however_coarse_the_step(period):
    """The scheme's own error allows the mismatch of the rows; the true motion shows that it does not repeat."""
    variant = coursework.load("31")
    text = variant.path.read_text(encoding="utf-8").replace('"2*pi/p"', f'"{period}"')
    run = coursework.solve(parse_variant(text), quantities=["table", "checks"])
    found = {check.code: check for check in run.checks}
    for code in ("PERIOD-POSITION", "PERIOD-VELOCITY"):
        assert found[code].verdict == "FAIL"
        assert "does not repeat after" in found[code].sentence


def test_a_period_with_three_digits_passes():
    text = coursework.load("31").path.read_text(encoding="utf-8").replace('"2*pi/p"', '"0.480 s"')
    run = coursework.solve(parse_variant(text), quantities=["table", "checks"])
    assert {check.verdict for check in run.checks if check.code.startswith("PERIOD")} == {"PASS"}


CRANK = """
[given]
r = "0.1 m"
l = "0.4 m"
[drive]
w1 = "10"
[coordinates]
phi1 = { start = "0.5 rad", rate = "w1" }
phi2 = { start = "START rad", rate = "w2" }
[time]
step = "0.01 s"
end = "0.1 s"
[[constraint]]
name = "y"
closure = "r*sin(phi1) + l*sin(phi2) = 0"
"""


@pytest.mark.parametrize("options", [{}, {"project": 1}, {"scheme": "rk4"}])
@pytest.mark.parametrize("start", ["-0.120", "-0.12015", "-0.1201453", "-0.1201453472"])
def test_a_rounded_start_is_told_by_start_and_no_drift(start, options):
    """The velocity equations keep what the start leaves open; nobody is blamed for it twice."""
    run = coursework.solve(parse_variant(CRANK.replace("START", start)), quantities=["table", "checks"], **options)
    found = {check.code: check.verdict for check in run.checks}
    assert found["DRIFT"] == "PASS"
    assert found["START"] == ("FAIL" if len(start) < 10 else "PASS")


@pytest.mark.parametrize("columns", [["phi3"], ["w3"], ["phi1"], ["phi2", "phi3"], ["w4"]])
def test_a_restricted_table_can_be_judged_as_far_as_it_goes(columns):
    run = coursework.solve("31", quantities=columns)
    found = {check.code: check.verdict for check in run.checks}
    assert "ERROR" not in found.values()
    assert "FAIL" not in found.values()
    assert {code for code, verdict in found.items() if verdict == "SKIP"} >= {"INITIAL", "RESIDUAL", "CONDITION", "DRIFT"}


@pytest.mark.parametrize("step", [0.02, 0.001, 0.0004, 0.0001])
def test_the_period_is_judged_whatever_the_step(step):
    """0.48 s is the period 0.480366 s to the task sheet, also where a row lies nearer to it."""
    run = coursework.solve("31", step=step, quantities=["table", "checks"])
    found = {check.code: check.verdict for check in run.checks}
    assert {found[code] for code in ("PERIOD-POSITION", "PERIOD-VELOCITY", "PERIOD-ASSEMBLY", "SINUSOID")} == {"PASS"}
