"""The time of a method is told as a multiple of Euler's with the table's own step, where it is measured at all."""

import itertools

import pytest

import coursework
from coursework.results.accuracy import study as making
from coursework.results.accuracy.problem import Problem


@pytest.fixture
def problem_and_run():
    run = coursework.solve("31", quantities=("accuracy",))
    scene = run.scene
    units = tuple(coordinate.unit for coordinate in run.variant.coordinates)
    return Problem(scene.rates, scene.start, run.step, len(run.exact.t) - 1, scene.closure, units), run


def test_the_first_time_is_one_and_the_others_are_measured_by_it(problem_and_run, monkeypatch):
    problem, run = problem_and_run
    ticks = itertools.count(2, 2)
    monkeypatch.setattr(making, "seconds", lambda work: next(ticks) / 1000)
    rows = making.make_study(problem, run.exact, "euler", timed=True).rows
    assert (rows[0].method, rows[0].evaluations) == ("explicit Euler", 24)
    assert [row.time_ratio for row in rows] == pytest.approx([*range(1, len(rows) + 1)])


def test_nothing_is_told_where_nothing_is_timed(problem_and_run):
    problem, run = problem_and_run
    assert {row.time_ratio for row in making.make_study(problem, run.exact, "euler").rows} == {None}
