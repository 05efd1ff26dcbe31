"""A long table is studied with bounded work: fewer rows looked at, fewer runs, and the page says which are left out."""

from dataclasses import replace

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.results.accuracy import study
from coursework.results.accuracy.methods import left_out, trials
from coursework.results.accuracy.problem import PAGE, TIMED, Bounds, Problem
from coursework.results.accuracy.trace import trace
from tests.hard.scenes import scene, solve
from tests.mechanisms.library import mechanism
from tests.report.reading import html_text


@pytest.fixture(scope="module")
def run():
    return coursework.solve("31", quantities=["table"])


@pytest.fixture
def problem(run):
    return Problem(run.scene.rates, run.scene.start, 0.02, 24, run.scene.closure, ("rad",) * 3)


def steps(problem, bounds, method):
    return [int(trial.setting) // problem.rows for trial in trials(problem, bounds) if trial.method == method]


def work(problem, bounds):
    """Operations of all the runs that end no step at a row looked at."""
    slopes = {scheme.title: scheme.slopes for scheme in SCHEMES.values()}
    counts = [(slopes[trial.method], int(trial.setting)) for trial in trials(problem, bounds) if trial.method in slopes]
    return sum(slopes * steps * problem.operations for slopes, steps in counts)


def test_a_usual_table_is_studied_whole(problem):
    assert (problem.pace, problem.marks) == (1, tuple(range(25)))
    assert steps(problem, TIMED, "explicit Euler") == [1, 2, 4, 8, 16, 64, 256, 1024, 4096]
    assert steps(problem, PAGE, "Runge-Kutta 4") == [1, 2, 4, 8, 16, 64]
    assert left_out(problem, TIMED) == left_out(problem, PAGE) == []


def test_from_2001_rows_on_some_are_looked_at(problem):
    whole, thinned = replace(problem, rows=2000), replace(problem, rows=2001)
    assert (whole.pace, len(whole.marks)) == (1, 2001)
    assert thinned.pace == 2
    assert thinned.marks == (*range(0, 2001, 2), 2001)
    assert "The table has 2002 rows: errors are looked for in 1002 of them, one in 2." in left_out(thinned, PAGE)


@pytest.mark.parametrize(("operations", "pace"), [(99, 500), (100, 504), (1983, 9995), (1985, 10_000), (10_000, 10_000)])
def test_of_a_long_program_fewer_rows_are_looked_at_down_to_a_hundred(problem, monkeypatch, operations, pace):
    """126 evaluations a row looked at, 25 million operations in all, at most 2000 rows and at least 100."""
    monkeypatch.setattr(Problem, "operations", operations)
    assert replace(problem, rows=999_999).pace == pace


@pytest.mark.parametrize("bounds", [PAGE, TIMED])
def test_runs_end_where_their_work_does(problem, bounds):
    """A run of twice the table's steps, and one with two Newton corrections a step, just inside their bound and just outside."""
    for slopes, method in ((1, "explicit Euler"), (4, "Runge-Kutta 4")):
        most = int(bounds.work / (2 * slopes * problem.operations))
        assert steps(replace(problem, rows=most), bounds, method) == [1, 2]
        assert steps(replace(problem, rows=most + 1), bounds, method) == [1]
    inside, outside = (replace(problem, rows=rows) for rows in (int(bounds.work / 5000), int(bounds.work / 5000) + 1))
    assert steps(inside, bounds, "Euler + 2 Newton projections") == [1]
    assert steps(outside, bounds, "Euler + 2 Newton projections") == []
    told = f"Newton projections are left out: {outside.rows} of them would take too long."
    assert told not in left_out(inside, bounds)
    assert told in left_out(outside, bounds)


@pytest.mark.parametrize("rows", [24, 500, 5000, 50_000, 200_000])
def test_all_runs_together_grow_no_faster_than_the_table(problem, rows):
    long = replace(problem, rows=rows)
    assert work(long, PAGE) <= long.work + 2 * len(SCHEMES) * PAGE.work
    assert len(long.marks) <= 2001
    assert work(replace(long, rows=10), Bounds(1, 0.0)) == replace(long, rows=10).work


@pytest.mark.long
def test_the_largest_error_is_found_among_the_rows_looked_at(run):
    """Of 4801 rows every third is looked at: the largest error is that of all rows to a thousandth, the last row's exactly."""
    fine = coursework.solve("31", step=0.48 / 4800, quantities=["table", "accuracy"])
    found = fine.accuracy.rows[0]
    all_rows = np.abs(fine.motion.coordinates - fine.exact.coordinates)
    assert found.steps_or_tolerance == "4800"
    assert found.max_error <= np.max(all_rows)
    assert found.max_error == pytest.approx(np.max(all_rows), rel=1e-3)
    assert found.end_error == pytest.approx(np.max(all_rows[-1]), rel=1e-9)
    told = html_text(render_html(build_model(fine)))
    assert "errors are looked for in 1601 of them, one in 3." in told


def test_a_break_is_a_row_looked_at():
    """At 0.003*1001 s the drive changes its formula; the fourth order is exact on both sides, and stays so in a long table."""
    text = scene(
        'p = { start = "0 rad", rate = "w1" }\nq = { start = "0 rad", rate = "w2" }',
        drive='w1 = { pieces = [["0 s", "6"], ["3.003 s", "-2"]] }', step=0.003, end=0.003 * 4001, equations=["w2 = 2*w1"],
    )  # fmt: skip
    rates = solve(text, quantities=("table",)).scene.rates
    long = Problem(rates, (0.0, 0.0), 0.003, 4001, None, ("rad", "rad"))
    assert long.pace == 3
    assert 1001 in long.marks
    rows = trace(SCHEMES["rk4"], rates, long.start, long.step, long.marks, 1)
    exact = 6 * np.minimum(long.times, 3.003) - 2 * np.maximum(long.times - 3.003, 0)
    assert np.max(np.abs(rows[:, 0] - exact)) < 1e-11


def test_a_table_beyond_every_bound_keeps_its_page_and_says_why_there_is_no_study(problem, monkeypatch):
    monkeypatch.setattr(study, "MOST_WORK", problem.work)
    inside = coursework.solve("31", quantities=["table", "accuracy"])
    assert inside.accuracy.rows
    monkeypatch.setattr(study, "MOST_WORK", problem.work - 1)
    outside = coursework.solve("31", quantities=["table", "accuracy"])
    assert outside.accuracy.rows == ()
    told = html_text(render_html(build_model(outside)))
    assert "The runs of this study are left out: 25 rows of this mechanism with every scheme take" in told
    assert "Positions and velocities by" in told


def test_a_break_that_falls_between_rows_costs_no_order_of_a_step_that_ends_there():
    """Rows 0.1 s, breaks at 0.45 s: half a row.  With 20 steps Heun is exact for a rate that is linear on either side."""
    text = mechanism("crank", ('w1 = "w0"', 'w1 = { pieces = [["0 s", "2*t"], ["0.45 s", "5 - t"]] }'))
    study = coursework.solve(coursework.parse_variant(text), quantities=["accuracy"]).accuracy
    errors = {row.steps_or_tolerance: row.max_error for row in study.rows if row.method == "Heun"}
    assert errors["10"] > 1e-3 and errors["20"] < 1e-12
