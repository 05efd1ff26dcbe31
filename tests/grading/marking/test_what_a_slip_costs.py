"""What one slip costs by the place where it is made: a cell, a start value, an equation; as the example of a rubric says it."""

import numpy as np
import pytest

from coursework.grading.marking.rubric import Rubric
from tests.grading.batch.classroom import EQUATIONS, hand_in
from tests.grading.batch.test_batch import grade, submissions
from tests.grading.marking import students

SLIP = (*EQUATIONS[:3], EQUATIONS[3].replace("- r1", "+ r1"))


def of_the_slip(t, q):
    """Velocities that solve the equations with the slip: w3 and w4 as before, then 0.5*r3*w4 and so on for w1 and w2."""
    d, (phi1, phi2, phi3) = students.DATA, q
    *_, w3, w4 = students.velocities(t, q)
    a = [[d["r1"] * np.sin(phi1), d["r2"] * np.sin(phi2)], [d["r1"] * np.cos(phi1), -d["r2"] * np.cos(phi2)]]
    b = [0.5 * d["r3"] * w4 - d["r3"] * w3 * np.cos(phi3), -d["r3"] * w3 * np.sin(phi3)]
    return np.array([*np.linalg.solve(a, b), w3, w4])


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    folder = tmp_path_factory.mktemp("slips")
    mistyped = students.table()
    mistyped[9, 4] += 0.3
    for name, table, equations in (
        ("cell", mistyped, EQUATIONS), ("carried", students.slip(9, 1, 1.05), EQUATIONS),
        ("start", students.table(start=(1.73, 3.37, 2.87)), EQUATIONS),
        ("starts", students.table(start=(1.73, 3.37, 2.78)), EQUATIONS),
        ("equations", None, SLIP), ("both", students.table(printed=of_the_slip), SLIP),
        ("table", students.table(printed=of_the_slip), EQUATIONS),
        ("method", students.table(lambda t, q: students.H * students.velocities(t - students.H, q)[:3]), EQUATIONS),
    ):  # fmt: skip
        hand_in(folder / "in" / name, table, equations)
    assert grade(folder / "in", folder / "out").exit_code == 0
    pages = {page.stem: page.read_text(encoding="utf-8") for page in (folder / "out" / "feedback").iterdir()}
    return {name: one["score"] for name, one in submissions(folder / "out").items()}, pages


@pytest.fixture
def scores(found):
    return found[0]


def test_a_slip_costs_by_the_place_where_it_is_made(scores):
    """A cell and what is made from it: one cell of 172. A rule: what the rubric gives for all that follows from it."""
    rubric, cell = Rubric(), 60 / 172
    assert scores["cell"] == scores["carried"] == pytest.approx(100 - cell, abs=0.005)
    assert scores["start"] == pytest.approx(40 + 60 * rubric.start_floor)
    assert scores["starts"] == pytest.approx(40 + 60 * rubric.start_floor_several)
    assert (scores["equations"], scores["both"]) == pytest.approx((90, 30 + 60 * rubric.own_equations_floor))
    assert 40 + 60 * rubric.misconception_floor <= scores["method"] < scores["start"]


def test_a_line_is_called_a_slip_only_where_it_is_one(found):
    """The table is the same; once the line is handed in right."""
    assert "In your list of equations that is line 4;" in found[1]["both"]
    assert "Your own line 4 is right; the table was made with a slip in it that is not in your list." in found[1]["table"]
    assert "that is line 4" not in found[1]["table"]
