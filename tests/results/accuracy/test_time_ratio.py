"""The time of a method is told as a multiple of Euler's with the table's own step, where it is measured at all."""

import itertools
import math

import pytest

import coursework
from coursework.commands import accuracy as command
from coursework.results.accuracy import study as making
from coursework.results.accuracy.study import make_study as study_of
from coursework.results.accuracy.timing import QUICK_REPEAT, REPEATS, seconds
from coursework.scene.quantities import problem_of
from tests.command import call


@pytest.fixture
def problem_and_run():
    run = coursework.solve("31", quantities=("accuracy",))
    scene = run.scene
    return problem_of(scene.variant, scene.rates, scene.start, scene.exact, scene.closure), run


def test_the_first_time_is_one_and_the_others_are_measured_by_it(problem_and_run, monkeypatch):
    problem, run = problem_and_run
    ticks = itertools.count(2, 2)
    monkeypatch.setattr(making, "QUICK_REPEAT", math.inf)  # no trial is so long that its one run is its time
    monkeypatch.setattr(making, "seconds", lambda work, **_: next(ticks) / 1000)
    rows = making.make_study(problem, run.exact, "euler", timed=True).rows
    assert (rows[0].method, rows[0].evaluations) == ("explicit Euler", 24)
    assert [row.time_ratio for row in rows] == pytest.approx([*range(1, len(rows) + 1)])


def test_nothing_is_told_where_nothing_is_timed(problem_and_run):
    problem, run = problem_and_run
    assert {row.time_ratio for row in making.make_study(problem, run.exact, "euler").rows} == {None}


def test_what_is_long_is_timed_by_the_run_that_is_made_anyhow(problem_and_run, monkeypatch):
    """A study that repeats forty trials, each for a third of a second, takes a quarter of a minute."""
    problem, run = problem_and_run
    clock, calls = itertools.count(), []
    monkeypatch.setattr("coursework.results.accuracy.timing.time.perf_counter", lambda: next(clock) / 10)
    monkeypatch.setattr(making, "seconds", lambda work, **_: calls.append(work))
    rows = making.make_study(problem, run.exact, "euler", timed=True).rows
    assert not calls
    assert {round(row.seconds, 6) for row in rows} == {0.1}


def test_what_is_short_is_repeated_no_more_than_tells_its_time(monkeypatch):
    now, calls = [0.0], []
    monkeypatch.setattr("coursework.results.accuracy.timing.time.perf_counter", lambda: now[0])

    def work():
        calls.append(None)
        now[0] += 0.001 if len(calls) > 3 else 0.002  # what is new to a machine takes longer

    assert seconds(work, shortest=QUICK_REPEAT) == pytest.approx(0.001)
    assert now[0] < 2 * REPEATS * QUICK_REPEAT


def test_the_command_studies_once(tmp_path, monkeypatch):
    """The study with times has all that the one without has: that would be made in vain."""
    studies = []
    for place in (making, command):
        monkeypatch.setattr(place, "make_study", lambda *given, **wish: studies.append(1) or study_of(*given, **wish))
    monkeypatch.setattr(making, "REPEATS", 0)  # one run of each trial is its time
    done = call("accuracy", "31", "--out", tmp_path / "out", "--format", "csv")
    assert done.exit_code == 0, done.output
    assert len(studies) == 1
    assert len((tmp_path / "out" / "accuracy.csv").read_text(encoding="utf-8").splitlines()) > 40
