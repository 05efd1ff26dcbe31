"""Motion under forces against references of other methods, what a step costs in energy, hard cases told.

`tests/reference/forces/dynamics_*.json`: Lagrange in free coordinates and body coordinates with multipliers; the angles of
Andrews' squeezer at 0.03 s: test set for IVP solvers (F. Mazzia, C. Magherini), reference by PSIDE.
"""

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics.dynamics import Dynamics
from coursework.effects.dynamics.dynamics_checks import Evidence, _advised, stiffness
from coursework.effects.dynamics.dynamics_lesson import lesson
from coursework.motion.schemes import SCHEMES, SEMI_IMPLICIT
from coursework.results.checks.result import Finding
from tests.commands.test_cli import call
from tests.effects.moved import free_31
from tests.mechanisms.library import mechanism
from tests.solved import solved

REFERENCE = Path(__file__).parents[1] / "reference" / "forces"
ALL = {**SCHEMES, "semi-implicit": SEMI_IMPLICIT}


@cache
def reference(name):
    return json.loads((REFERENCE / f"dynamics_{name}.json").read_text(encoding="utf-8"))


def dynamics(run):
    places, state = run.scene.begin_of_forces
    return Dynamics(run.scene.free_equations, places), state


def test_the_run_up_of_the_slider_crank():
    motion, columns = solved("example-2-motor", scheme="exact").motion, reference("example-2")["columns"]
    for name in ("theta1", "w1", "s3"):
        assert np.abs(motion.column(name) - columns[name]).max() < 1e-9, name
    assert np.abs(motion.scaled).max(axis=0) == pytest.approx(1.0)
    assert motion.scaled * motion.determinants[0] == pytest.approx(motion.determinants * motion.scaled[0])
    second = solved("example-2-motor", scheme="exact").results.accelerations[:, 0]
    assert np.abs(second - columns["dw1"]).max() < 1e-8


def test_the_arm_that_falls_keeps_its_energy():
    run, columns = solved("falling-arm", scheme="exact"), reference("arm")["free"]["columns"]
    for name in ("phi1", "phi2", "w1", "w2"):
        assert np.abs(run.motion.column(name) - columns[name]).max() < 1e-9, name
    energy = run.scene.energy_of(run.motion)
    assert energy[0] == pytest.approx(17.93975828425486, rel=1e-14)
    assert np.ptp(energy) < 1e-9
    low, high = run.scene.extremes["phi1"]
    assert low < columns["phi1"][0] <= high  # it falls from where it was let go
    assert (low, high) == pytest.approx((min(columns["phi1"]), max(columns["phi1"])), abs=1e-9)


def test_the_rows_of_euler_are_those_of_the_reference():
    rows = solved("example-2-motor", scheme="euler").motion
    wanted = reference("example-2")["euler rows"]
    assert np.abs(rows.column("w1") - wanted["w1"]).max() < 1e-12
    free = np.array(reference("arm")["free"]["euler rows, h = 0.01"])
    arm = solved("falling-arm", scheme="euler")
    assert np.abs(np.column_stack([arm.motion.column(n) for n in ("phi1", "phi2", "w1", "w2")]) - free).max() < 1e-11
    energy = arm.scene.energy_of(arm.motion)
    assert np.abs(energy - reference("arm")["free"]["euler energy"]).max() < 1e-10
    assert energy[-1] == pytest.approx(21.015, abs=1e-3)


@pytest.mark.parametrize("name", ["example-2", "arm"])
@pytest.mark.parametrize("scheme", ["euler", "semi-implicit", "heun", "rk4"])
def test_work_against_precision(name, scheme):
    run = solved("example-2-motor" if name == "example-2" else "falling-arm", scheme="exact")
    listed = reference(name)["work-precision"] if name == "example-2" else reference(name)["free"]["work-precision"]
    key = {"semi-implicit": "semi-implicit euler"}.get(scheme, scheme)
    rates = [run.motion.velocity_names[place] for place in run.scene.free_equations.free]
    for one in listed[key][:3]:
        parts = one["slopes"] // (200 * ALL[scheme].slopes)
        made, state = dynamics(run)
        rows = made.rows(ALL[scheme], state, 0.01 / parts, 200 * parts)
        assert rows.slopes == one["slopes"]
        error = max(np.abs(rows.rates[::parts, k] - run.motion.column(rate)).max() for k, rate in enumerate(rates))
        assert error == pytest.approx(one.get("max error w1", one.get("error of rates")), rel=0.01)


def test_two_free_rates_with_a_closed_loop_keep_energy_and_length():
    run = coursework.solve(coursework.parse_variant(free_31()), scheme="exact", step=0.001, end=0.05)
    energy = run.scene.energy_of(run.motion)
    assert np.ptp(energy) < 1e-10 * abs(energy[0])
    q = run.motion
    height = 0.953 * np.sin(q.column("phi1")) + 0.847 * np.sin(q.column("phi2")) + 0.457 * np.cos(q.column("phi3"))
    assert np.ptp(height) < 1e-12
    forces = run.results.forces
    assert np.abs(forces.column("M1")).max() < 1e-8 * forces.reactions.largest  # nothing drives it


@pytest.mark.long
def test_a_limit_of_the_free_coordinates_stops_the_rows():
    run = coursework.solve(coursework.parse_variant(free_31()), scheme="exact", step=0.001, end=0.2)
    assert run.stop.kind == "dead point"
    # There C stands below B, so that phi3 is pi and C.y does not change with it.
    last = {name: run.motion.column(name)[-1] for name in ("phi3", "w3")}
    assert run.stop.time == pytest.approx(0.05 + (math.pi - last["phi3"]) / last["w3"], abs=1e-7)
    assert len(run.motion.t) == 51
    assert "turns back" in run.stop.sentence and "such as w2" not in run.stop.sentence
    assert np.isfinite(run.motion.rows).all()


def test_andrews_squeezer_at_the_end_of_its_test():
    text = mechanism("andrews-forces", ('w1 = "a0*t"                    # from rest\n', ""), ("[drive]\n", ""))
    text = text.split("# --- texts of the page")[0].replace('["table", "checks", "forces", "energy"]', '["dynamics"]')
    text = text.replace("[ask]", '[motor]\nrates = ["w1"]\n1 = { torque = "0.033 N*m" }\n\n[ask]')
    run = coursework.solve(coursework.parse_variant(text), scheme="exact")
    last = dict(zip(run.motion.coordinate_names, run.motion.coordinates[-1].tolist(), strict=True))
    beta, theta, gamma, phi, delta, omega, epsilon = (
        15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304,
        0.5347301163226948, 1.048080741042263,
    )  # fmt: skip
    wanted = {
        "beta": beta, "phi2": beta + theta, "phi3": gamma - np.pi / 2, "phi4": phi + delta - np.pi / 2, "phi5": delta,
        "phi6": omega + epsilon, "phi7": epsilon - np.pi / 2,
    }  # fmt: skip
    assert run.motion.t[-1] == 0.03
    for name, value in wanted.items():
        assert last[name] == pytest.approx(value, abs=1e-8), name


# ---- told


def test_energy_and_error_are_told_with_the_step_that_would_do():
    told = {one.code: one for one in solved("falling-arm", scheme="euler").results.checks}
    assert (told["ENERGY"].verdict, told["MOTION"].verdict, told["STABLE"].verdict) == ("COARSE", "COARSE", "PASS")
    assert "J that nothing gave it" in str(told["ENERGY"].sentence)
    assert "order of the scheme" not in str(told["ENERGY"].sentence)  # one step is advised, where the error is larger
    assert "With an error as large as this, the order of the scheme does not tell which step is needed" in str(
        told["MOTION"].sentence
    )
    assert told["MOTION"].value == pytest.approx(
        13.03 / np.abs(solved("falling-arm", scheme="exact").motion.column("w1")).max(), rel=1e-2
    )
    exact = {one.code: one for one in solved("falling-arm", scheme="exact").results.checks}
    assert exact["ENERGY"].verdict == "PASS" and exact["ENERGY"].value < 1e-9
    driven = {one.code: one for one in solved("example-2-motor", scheme="exact").results.checks}
    assert driven["ENERGY"].verdict == "PASS" and driven["ENERGY"].value < 1e-5


def test_two_rows_are_enough_to_tell_how_close_the_motion_is():
    """From rest Euler's first step moves nothing where the motion moves w h/2, a fortieth of what twenty steps turn."""
    run = coursework.solve("falling-arm", "euler", end="10 ms")
    (told,) = [one for one in run.results.checks if one.code == "MOTION"]
    assert (told.verdict, told.row, told.value) == ("PASS", 2, pytest.approx(1 / 40, rel=1e-2))


@pytest.mark.parametrize(("share", "stable", "told"), [
    (0.5, "PASS", "a step of about 0.0005 s would do"), (0.51, "PASS", "does not tell which step is needed"), (0.4, "COARSE", ""),
])  # fmt: skip
def test_a_step_is_advised_from_errors_that_still_tell_one(share, stable, told):
    run = solved("falling-arm", scheme="euler")
    evidence = Evidence(run.results.forces, run.scene.exact_analysis, run.scene.free_equations, SCHEMES["euler"], 0.01)
    found = [Finding("COARSE", "Energy.", 0.06), Finding("COARSE", "Motion.", share), Finding(stable, "Step.")]
    energy, motion, _ = (str(one.sentence) for one in _advised(evidence, found, lambda _: False))
    assert energy == "Energy." and told in motion and (told != "" or motion == "Motion.")


def test_a_steep_motor_is_told_and_its_explosion_shown():
    text = mechanism("example-2-motor", ('"35 N*m*s"', '"3500 N*m*s"'), ('"600 N*m"', '"35000 N*m"'))
    run = coursework.solve(coursework.parse_variant(text), scheme="euler")
    told = {one.code: one for one in run.results.checks}["STABLE"]
    assert told.verdict == "COARSE" and told.value > 2
    assert "explodes: h·561.5 = 5.62" in str(told.sentence), "a k or a J the page does not have"
    assert np.isfinite(run.motion.rows).all()
    assert run.stop is not None and run.stop.kind == "not finite"
    assert len(run.motion.t) < 201
    damped, _ = stiffness_of(run)
    assert run.step * damped == pytest.approx(told.value)


def stiffness_of(run):
    from coursework.effects.dynamics.dynamics_checks import Evidence

    scene = run.scene
    return stiffness(Evidence(run.results.forces, scene.exact_analysis, scene.free_equations, scene.scheme, run.step))


def test_a_motor_between_two_links_and_a_spring():
    arm = mechanism("falling-arm", ('rates = ["w1", "w2"]', 'rates = ["w1", "w2"]\n2 = { from = 1, torque = "-0.5*(w2 - w1)" }'))
    run = coursework.solve(coursework.parse_variant(arm), scheme="exact")
    energy = run.results.forces.energy
    assert energy.drive.max() <= 1e-12  # the joint only brakes
    found = run.results.forces
    assert found.column("M2") == pytest.approx(-0.5 * (run.motion.column("w2") - run.motion.column("w1")), abs=1e-9)
    held = mechanism(
        "falling-arm", ('gravity = "9.81 m/s^2"', 'k1 = { spring = ["D", "M"], stiffness = "200 N/m", free = "0.7 m" }')
    )
    run = coursework.solve(coursework.parse_variant(held), scheme="exact")
    assert np.ptp(run.scene.energy_of(run.motion)) < 1e-9


def test_semi_implicit_is_a_scheme_of_motion_under_forces_alone():
    with pytest.raises(coursework.InputError, match=r"no scheme .* is for motion under forces"):
        coursework.solve("31", scheme="semi-implicit")
    for asked in ({"project": 1}, {"gain": 5.0}):  # they changed nothing, and nothing said so
        with pytest.raises(coursework.InputError, match="C078"):
            coursework.solve("falling-arm", **asked)
    assert "semi-implicit" not in SCHEMES
    run = coursework.solve("falling-arm", scheme="semi-implicit")
    assert run.motion.scheme == "semi-implicit"
    energy = run.scene.energy_of(run.motion)
    assert np.ptp(energy) < 0.3 * abs(energy[0])


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('rates = ["w1"]', 'rates = ["w9"]', "V714"),
        ('rates = ["w1"]', 'rates = ["w1", "w2", "u3"]', "V715"),
        ('rates = ["w1"]', "", "V710"),
        ('1 = { torque = "M0 - k*w1" }', 'start = { w2 = "1 rad/s" }', 'V712 .*"w2" is no free rate; w1 is[.]'),
        ("[motor]", '[drive]\nw2 = "0"\n\n[motor]', "V711"),
    ],
)
def test_faults_of_a_motor(old, new, code):
    with pytest.raises(coursework.InputError, match=code):
        coursework.parse_variant(mechanism("example-2-motor", (old, new)), "bad.toml")


def test_dynamics_of_a_driven_mechanism_are_refused():
    with pytest.raises(coursework.InputError, match="forces do not move this mechanism"):
        coursework.solve("example-2-forces", quantities=["dynamics"])


@pytest.mark.parametrize(("rows", "lines"), [(1, 0), (2, 12)])
def test_one_step_shows_what_it_costs_and_no_step_costs_nothing(rows, lines):
    scene = solved("falling-arm", scheme="euler").scene
    way = scene.exact
    short = replace(way, t=way.t[:rows], coordinates=way.coordinates[:rows], velocities=way.velocities[:rows])
    assert len(lesson(replace(scene.moved, exact=short))) == lines


def test_the_steady_motion_of_the_motor():
    found, wanted = solved("example-2-motor", scheme="exact").scene.regime, reference("example-2")["steady state"]
    assert found.speed == pytest.approx(wanted["w1 at theta1=0"], rel=1e-11)
    assert found.period == pytest.approx(wanted["period"], rel=1e-11)
    assert found.mean == pytest.approx(wanted["w_mean"], rel=1e-11)
    assert (found.largest, found.least) == (pytest.approx(wanted["w_max"], rel=1e-9), pytest.approx(wanted["w_min"], rel=1e-9))
    assert found.delta == pytest.approx(wanted["delta"], rel=1e-9)
    assert solved("falling-arm", scheme="exact").scene.regime is None


def test_what_has_no_mass_is_refused():
    text = mechanism(
        "falling-arm", ('1 = { mass = "3 kg", inertia = "rod" }\n', ""), ('2 = { mass = "2 kg", inertia = "rod" }\n', "")
    )
    text = text.replace("[masses]\n", "")
    with pytest.raises(coursework.InputError, match="V744"):
        _ = coursework.solve(coursework.parse_variant(text), scheme="exact").motion


@pytest.mark.parametrize(
    ("force", "told"),
    [
        ("(-M0/r1/(w1*t), 0)", "V086 .*forces.F1.force, column 8: there is no value at t = 0: .* is a division by zero"),
        ("(-M0/r1*sqrt(w1*t - 1), 0)", r"V086 .*sqrt\(w1\*t - 1\)"),
        ("(-M0/(C.x - r1 - r2), 0)", "V749 .*the forces have no value in the position at the start"),
        ("(-M0/r1*ln((C.x - r1 - r2)/r1), 0)", "V749 "),
    ],
)
def test_forces_without_a_value_at_the_start_are_not_told_as_masses_that_are_missing(force, told):
    text = mechanism("example-2-motor", ('"(-c*u3, 0)"', f'"{force}"'))
    with pytest.raises(coursework.InputError, match=told):
        _ = coursework.solve(coursework.parse_variant(text), scheme="exact").motion


def test_a_search_for_a_step_of_drives_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = call("run", "falling-arm", "--step", "auto", "--error", "0.01")
    assert told.exit_code == 2
    assert "C077" in told.stderr


@pytest.mark.parametrize(("name", "rate"), [("example-2-motor", "w1"), ("falling-arm", "w2"), ("block-on-a-spring", "u")])
def test_the_motion_is_known_between_rows_too(name, rate):
    """There the law was followed that stands in for the forces."""
    run, finer = (coursework.solve(coursework.parse_variant(mechanism(name)), "exact", end=0.6, step=h) for h in (0.15, 0.05))
    found = run.exact.at([0.0, 0.05, 0.5, 0.1, 0.6])
    assert found.column(rate) == pytest.approx(finer.table[rate].to_numpy()[[0, 1, 10, 2, 12]], rel=1e-9, abs=1e-9)
    assert np.ptp(found.coordinates, axis=0).min() > 1e-3
