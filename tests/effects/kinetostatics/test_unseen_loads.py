"""Poles and jumps of loads between rows, at times known from the formulas alone."""

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics.kinetostatics import least
from coursework.effects.kinetostatics.unseen_loads import unseen_loads
from tests.effects.massed import of_text
from tests.mechanisms.library import mechanism


def loaded(force):
    """Return the four-bar linkage whose crank turns by 10 rad/s, with this force instead of F0; its rows are 10 degrees apart."""
    return mechanism("example-1-forces", ("(F0, 0)", f"({force}, 0)"))


@pytest.mark.parametrize(("force", "time", "is_pole"), [
    ("F0*0.001/(w0*t - 3.3)", 0.33, True), ("F0*0.001/(w0*t - 3.3)^2", 0.33, True), ("F0*1e-4/(theta1 - 5.5)^2", 0.55, True),
    ("F0*1e-12/(w0*t - 3.3)", 0.33, True), ("F0*0.1/sqrt(abs(w0*t - 3.3))", 0.33, True),
    ("F0*log(abs(theta1 - 3.3) + 1)/(theta1 - 3.3)^2", 0.33, True),
    ("F0*abs(theta1 - 3.3)/(theta1 - 3.3)", 0.33, False), ("F0*(1 + 0.006*atan2(sin(w0*t - 1), cos(w0*t - 1)))", 0.41416, False),
])  # fmt: skip
def test_a_load_that_breaks_between_two_rows_is_found_at_its_time(force, time, is_pole):
    (found,) = unseen_loads(of_text(loaded(force), scheme="exact"))
    assert (found.name, found.is_pole, found.row) == ("F1", is_pole, int(time / 0.0174533))
    assert found.time == pytest.approx(time, abs=1e-5)


@pytest.mark.long
@pytest.mark.parametrize("force", [
    "F0", "F0*sin(20*w0*t)", "F0*exp(-(9*(w0*t - 3.3))^2)", "F0*sqrt(abs(w0*t - 3.3))", "F0*1e-3/(1e-3 + abs(w0*t - 3.3))",
    "F0*(1 + 0.001*atan2(sin(w0*t - 1), cos(w0*t - 1)))", "F0*abs(theta1 - pi/2)/(theta1 - pi/2 + 1e-9)",
    "F0*sin(36*w0*t)", "F0*exp(-(300*(w0*t - 3.3))^2)", "F0*1e-9*exp(-(300*(w0*t - 3.3))^2)", "F0/(1 + (1000*(w0*t - 3.3))^2)",
])  # fmt: skip
def test_a_load_that_is_only_quick_or_breaks_at_a_row_is_none(force):
    assert not unseen_loads(of_text(loaded(force), scheme="exact"))


def test_a_pole_fails_and_a_jump_is_told_first_of_all():
    found = {}
    for force in ("F0*0.001/(w0*t - 3.3)", "F0*abs(theta1 - 3.3)/(theta1 - 3.3)"):
        run = coursework.solve(coursework.parse_variant(loaded(force)))
        found[next(one.verdict for one in run.checks if one.code == "POWER")] = run.summary
    assert found["FAIL"].startswith(
        "Between rows 19 and 20, near t = 0.33 s, the load F1 grows beyond all bounds, and the forces"
    )
    assert found["COARSE"].startswith("Between rows 19 and 20, near t = 0.33 s, the load F1 jumps: the rows show the forces")


def test_of_very_many_rows_those_are_looked_into_that_tell_most(monkeypatch):
    monkeypatch.setattr("coursework.effects.kinetostatics.unseen_loads._MOST", 2)
    for force, is_pole in (("F0*0.001/(w0*t - 3.3)", True), ("F0*abs(w0*t - 3.3)/(w0*t - 3.3)", False)):
        (found,) = unseen_loads(of_text(loaded(force), scheme="exact"))
        assert (found.is_pole, found.row) == (is_pole, 18)


@pytest.mark.parametrize("size", [1e-6, 250.0])
@pytest.mark.parametrize(("part", "rank"), [(0.98e-11, 1), (1.02e-11, 2)])
def test_forces_that_equations_of_any_size_hardly_tell_apart_are_not(size, part, rank):
    """Two forces, the second with a small lever: it is left at 0 where nothing tells it."""
    found, null = least(size * np.diag([1.0, part]), size * np.array([3.0, 0.0]))
    assert found == pytest.approx([3.0, 0.0]) and len(null) == 2 - rank
