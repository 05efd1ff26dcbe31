"""What is told of a motion under forces: on its page, by the study of what a step costs, where it stops and where it rests."""

import math
from dataclasses import replace
from unittest.mock import MagicMock

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.report.sections.effects.dynamics import _equation
from tests.commands.test_cli import call
from tests.mechanisms.library import mechanism
from tests.report.made import model_of
from tests.solved import solved


def test_the_page_shows_what_a_step_costs():
    from coursework.report.pages import build_model

    run = solved("falling-arm", scheme="euler")
    section = next(one for one in build_model(run, "en", "", live=False).sections if one.name == "dynamics")
    table = next(part for part in section.parts if part.kind == "table" and part.id == "dynamics-lesson")
    assert len(table.rows) == 12
    assert any(part.kind == "panels" and part.id == "dynamics-energy" for part in section.parts)


@pytest.mark.parametrize(("is_one", "inertia"), [(True, "J(q)·dv/dt = "), (False, "M(q)·dv/dt = ")])
def test_the_equation_of_motion_has_a_number_or_a_matrix_for_the_inertia(is_one, inertia):
    """A single rate v has the reduced inertia J and ½·J′·v² from its change; several have a matrix."""
    _, equation, _ = _equation(MagicMock(), is_one=is_one)
    assert equation.items[0].text.startswith(inertia) and ("½·J′(q)·v²" in equation.items[0].text) is is_one


def test_accuracy_shows_the_error_of_the_energy_against_slopes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = call("accuracy", "falling-arm", "--out", "out", "--format", "html,csv")
    assert told.exit_code == 0, told.stderr
    assert "200 steps of explicit Euler: the energy is 3.33 J off at worst" in told.stdout
    rows = [row.split(",") for row in (tmp_path / "out" / "accuracy.csv").read_text(encoding="utf-8").splitlines()[1:]]
    assert {row[4] for row in rows} == {"J"}
    found = {(row[0], int(row[2])): float(row[3]) for row in rows}
    assert found["explicit Euler", 200] == pytest.approx(3.334, abs=0.001)
    assert found["Runge-Kutta 4", 6400] < 1e-6 * found["semi-implicit Euler", 6400] * 10
    page = (tmp_path / "out" / "accuracy.html").read_text(encoding="utf-8")
    assert "What a step costs in motion under forces: variant falling-arm" in page
    study = solved("falling-arm", scheme="euler").scene.energy_study()
    assert study.orders["Runge-Kutta 4"] == pytest.approx(4, abs=0.2)
    # The energy is that of the start; all of it and the whole depth below is motion where both links hang (1.75 and 0.4 kg*m).
    most = 9.81 * (1.75 * (math.sin(1.6) + 1) + 0.4 * (math.sin(0.2) + 1))
    assert 0.99 * most < study.floor / (64 * 2.0**-52) < most
    # Those of two links are not: a march by numpy alone loses 29 J of such an arm in 40 s with h = 0.005 s.
    assert "where nothing drives or brakes and the masses of the equation of motion are constant" in study.sentences[1]
    name, slopes, error, seconds = study.own
    assert (str(name), slopes, seconds) == ("explicit Euler", 200, None) and error == pytest.approx(3.334, abs=0.001)


def test_a_step_with_which_a_scheme_leaves_the_paper_is_told_in_the_study():
    steep = mechanism("example-2-motor", ('k = { value = "35 N*m*s"', 'k = { value = "3000 N*m*s"'))
    run = coursework.solve(coursework.parse_variant(steep), scheme="euler", step=0.02, end=1.6)
    study = run.scene.energy_study()
    assert str(study.rows[0].failed).startswith("it came to row")
    assert "do not reach the end" in study.sentences[0] and study.own is None


@pytest.mark.parametrize(("rows", "left_out"), [(5001, False), (5002, True)])
def test_a_study_of_too_many_rows_is_left_out(rows, left_out):
    from coursework.effects.dynamics.energy_study import energy_study

    class Begun(Exception):
        pass

    def begin(_):
        raise Begun

    scene = solved("falling-arm", scheme="euler").scene
    first = {name: np.repeat(getattr(scene.exact, name)[:1], rows, axis=0) for name in ("t", "coordinates", "velocities")}
    given = replace(scene.moved, exact=replace(scene.exact, **first)), SCHEMES["euler"], "", begin
    if left_out:
        (why,) = energy_study(*given).left_out
        assert "The study is left out: 5002 rows with every scheme take too long" in str(why)
    else:
        with pytest.raises(Begun):
            energy_study(*given)


# Stages of a scheme beyond all numbers: they were told as a point without a place, refused as a row without forces, or crashed.
@pytest.mark.parametrize(("name", "torque", "scheme", "rows"), [
    ("falling-arm", "1*exp((w1*T)^8)", "rk4", 23),
    ("falling-arm", "1*exp(w1^2*T^2)", "euler", 59),
    ("example-2-motor", "600*exp((w1*T)^8)", "rk4", 2),
    ("example-2-motor", "600*exp((w1*T)^8)", "exact", 2),
])  # fmt: skip
def test_forces_beyond_all_numbers_end_the_rows(name, torque, scheme, rows):
    cut = ('rates = ["w1", "w2"]', 'rates = ["w1", "w2"]\n1 = { torque = "?" }'), ('"M0 - k*w1"', '"?"')
    text = mechanism(name, cut[name == "example-2-motor"], ("[given]", '[given]\nT = "1 s"')).replace("?", torque)
    run = coursework.solve(coursework.parse_variant(text), scheme=scheme, end=0.64)
    assert len(run.table) == rows and np.isfinite(run.scene.accelerations_of(run.motion)).all()
    assert run.stop.kind == ("too steep" if scheme == "exact" else "not finite")
    assert run.stop.time == pytest.approx(0.0104094 if scheme == "exact" else 0.01 * rows, rel=1e-5)


def test_the_page_of_a_motor_sets_its_law_as_a_formula_and_says_what_the_lines_of_its_energy_are():
    sections = {section.name: section.parts for section in model_of(solved("example-2-motor", scheme="exact")).sections}
    (told,) = (str(part) for part in sections["statement"] if part.kind == "paragraph" and "exerts the moment" in str(part))
    assert "·" in told and "−" in told and "*" not in told
    (panels,) = (part for part in sections["dynamics"] if part.kind == "panels")
    assert len(panels.legend) == 2 and panels.width == 82


def test_what_falls_freely_is_driven_by_nothing_on_its_page_and_has_no_power_of_a_drive():
    run = solved("falling-arm", scheme="exact")
    sections = {section.name: str(section.parts) for section in model_of(run).sections}
    assert run.summary == "The rows are the motion itself; they depend on no step."
    assert "as many freedoms as rates that forces or laws move" in sections["structure"]
    assert "driven" not in sections["structure"]
    assert "0 in every row: drive, loads, friction and dampers." in sections["energy"]
    assert 0 < np.abs(run.results.energy.drive).max() < 1e-12  # W: what round-off leaves of it
    checked = call("check", "falling-arm").stdout
    assert "Every coordinate is free: there are no position equations." in checked and "Dormand" not in checked
    assert "unknown velocit" not in checked and "driven" not in checked


PENDULUM = mechanism("pendulum")


@pytest.mark.parametrize(("old", "new"), [
    ('"4 kg"', '"0.001 g"'),  # stiff: dies out in 6e-8 s, of which nobody makes 3000 steps to reach 20 ms
    ('"(0.5, -0.7)"', '"(0.5638155724715451, -0.20521208599540124)"'),  # the ends meet, so a spring has no direction
])  # fmt: skip
def test_forces_that_nobody_can_follow_are_no_dead_point_of_links_that_are_not_there(old, new):
    run = coursework.solve(coursework.parse_variant(PENDULUM.replace(old, new)), scheme="exact")
    assert run.stop.kind == "too steep" and "too stiff for what it moves, or its two ends meet" in run.stop.sentence
    euler = coursework.solve(coursework.parse_variant(PENDULUM.replace(old, new)), scheme="euler")
    told = {one.code: str(one.sentence) for one in euler.results.checks}
    assert len(euler.motion.t) > 1 and told["MOTION"].startswith("The exact motion is not known on these rows")


def test_what_hangs_at_rest_is_told_so_and_no_energy_of_round_off():
    hanging = PENDULUM.replace('"200 N/m"', '"0 N/m"').replace("-20 deg", "-90 deg")
    hanging = hanging.replace("[forces]", '[forces]\ngravity = "9.81 m/s^2"')
    assert coursework.solve(coursework.parse_variant(hanging), scheme="euler").summary.startswith(
        "Nothing moves: the forces hold"
    )


@pytest.mark.parametrize(("scheme", "told"), [
    ("exact", "The rows are the motion itself; they depend on no step."), ("rk4", "The table is close to the motion: w2 is "),
    ("euler", "Not close to the motion: "),
])  # fmt: skip
def test_where_forces_are_asked_too_the_summary_says_how_close_the_motion_under_forces_is(scheme, told):
    """Reactions of the rows are right in every row, whatever the step; how close the rows are is another question."""
    run = coursework.solve("example-2-motor", scheme, end="0.5 s", step="0.025 s", quantities=["table", "checks", "forces"])
    assert run.summary.startswith("The table is computed right: ") and told in run.summary and "not known" not in run.summary
