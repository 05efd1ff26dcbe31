"""PEAK: the fastest link is found between the rows and between the steps of the search, a constant rate has no moment."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import coursework
from tests.solved import solved


def peak(run):
    return next(check for check in run.checks if check.code == "PEAK")


@pytest.mark.parametrize(("name", "rate"), [("v107", "w3"), ("jansen", "wc")])
def test_the_largest_rate_is_that_of_a_fine_exact_motion(name, rate):
    """An independent way: exact rows twenty times as dense, then a parabola through the three about the largest."""
    run = solved(name, quantities=["table", "checks"])
    fine = coursework.solve(name, step=run.step / 20, quantities=["table"]).exact
    sizes = np.abs(fine.column(rate))
    place = int(np.argmax(sizes))
    assert 0 < place < len(sizes) - 1
    through = np.polynomial.Polynomial.fit(fine.t[place - 1 : place + 2], sizes[place - 1 : place + 2], 2)
    top = minimize_scalar(lambda t: -through(t), bounds=(fine.t[place - 1], fine.t[place + 1]))
    found = peak(run)
    assert found.value / run.step == pytest.approx(-top.fun, rel=1e-6)
    when = float(found.sentence.partition("t = ")[2].partition(" s")[0])
    assert when == pytest.approx(top.x, abs=2e-4)
    assert found.sentence.startswith(f"{rate} is largest at t = ")


@pytest.mark.parametrize(("name", "told"), [("example-1", "w1 is constant: 10 rad/s"), ("31", "w3 is largest at t = 0 s")])
def test_a_constant_rate_has_no_moment_and_one_at_the_start_has(name, told):
    assert peak(solved(name, quantities=["table", "checks"])).sentence.startswith(told)


def test_nothing_beyond_the_end_counts():
    """w3 of V107 grows up to 0.077 s: with an end before that its largest value is that of the last row."""
    run = coursework.solve("v107", end=0.045, quantities=["table", "checks"])
    assert run.exact.t[-1] == 0.045
    assert peak(run).value / run.step == pytest.approx(np.max(np.abs(run.exact.rows[:, 3:6])), rel=1e-4)
