"""PEAK: the fastest link is found between the rows and between the steps of the search, a constant rate has no moment."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import coursework
from coursework.motion.singular.peaks import Peaks
from coursework.variant.reading.reader import parse_variant
from tests.hard.drives import Law, four_bar
from tests.hard.scenes import scene
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
    gone = np.append(0.0, np.cumsum(np.abs(np.diff(fine.coordinates[:, fine.velocity_names.index(rate)]))))
    assert found.value == pytest.approx(np.max(gone[20:] - gone[:-20]), rel=1e-4)
    assert f"{-top.fun:.4g} rad/s" in found.sentence
    when = float(found.sentence.partition("t = ")[2].partition(" s")[0])
    assert when == pytest.approx(top.x, abs=2e-4)
    assert found.sentence.startswith(f"{rate} is largest at t = ")


@pytest.mark.parametrize(("name", "told"), [("example-1", "w1 is constant: 10 rad/s"), ("31", "w3 is largest at t = 0 s")])
def test_a_constant_rate_has_no_moment_and_one_at_the_start_has(name, told):
    assert peak(solved(name, quantities=["table", "checks"])).sentence.startswith(told)


@pytest.mark.parametrize(
    ("law", "told"),
    [
        ('"-2"', "w is constant: -2 rad/s"),
        ('{ pieces = [["0 s", "2"], ["0.5 s", "-2"]] }', "w is constant but for its sense: 2 rad/s"),
    ],
)
def test_a_constant_rate_is_told_with_its_sense(law, told):
    text = scene(
        'phi = { start = "0 rad", rate = "w" }\nx = { start = "0 m", rate = "u" }', given='r = "1 m"', drive=f"w = {law}",
        equations=["u = r*w*cos(phi)"],
    )  # fmt: skip
    assert peak(coursework.solve(parse_variant(text))).sentence.startswith(told)


def test_nothing_beyond_the_end_counts():
    """w3 of V107 grows up to 0.077 s: with an end before that its largest value is that of the last row."""
    run = coursework.solve("v107", end=0.045, quantities=["table", "checks"])
    assert run.exact.t[-1] == 0.045
    assert peak(run).value == pytest.approx(np.max(np.abs(np.diff(run.exact.coordinates, axis=0))), rel=1e-4)
    assert peak(run).value / run.step < np.max(np.abs(run.exact.rows[:, 3:6]))


@pytest.mark.parametrize(("way", "verdict"), [(0.499, "PASS"), (0.501, "COARSE")])
def test_a_pulse_between_two_rows_counts_by_its_way_to_and_fro(way, verdict):
    """A pulse and its reverse leave the angle where it was: 2 a T sqrt(pi), whatever the rate at its top."""
    width = 1e-5
    data = {"a": f"{way / width / math.pi**0.5!r} rad/s", "T": f"{width!r} s"}
    law = Law("twins", "a*exp(-((t - 0.0504)/T)^2) - a*exp(-((t - 0.0508)/T)^2)", data, lambda t: t)
    found = peak(coursework.solve(parse_variant(four_bar(law, scheme="rk4", end=0.2))))
    assert found.verdict == verdict
    assert found.value == pytest.approx(2 * way, rel=1e-4)


def test_the_tables_that_are_judged_share_what_was_sought_between_the_steps():
    """The own table, that of a finer step and that of a better scheme are judged by one search of the exact motion."""
    search = coursework.solve("31", quantities=["table", "checks"]).scene.search
    first = search.fastest([0, 1, 2])
    flow = search.peaks.last.clock.flow
    before = flow.evaluations
    assert search.fastest([0, 1, 2]) == first
    assert flow.evaluations == before


@pytest.mark.parametrize(
    ("repeats", "step", "way"), [(False, 0.4, 0.8), (False, 2.5, 2.0), (True, 0.4, 0.8), (True, 1.0, 2.0), (True, 2.5, 5.0)]
)
def test_only_where_the_motion_repeats_a_step_goes_on_behind_the_end(repeats, step, way):
    """An angle that grows by 2 rad in a second, which is the end."""
    slope = np.array([2.0, 1.0])
    clock = SimpleNamespace(step=lambda state, slope, length: (state + slope * length, None), slope=lambda state: slope)
    pairs = [(slope * time, slope) for time in (0.0, 0.5)]
    peaks = SimpleNamespace(way=pairs, last=SimpleNamespace(clock=clock, state=pairs[1][0], slope=slope, length=0.5))
    assert Peaks.way_within(peaks, 0, 1.0, repeats)(step) == pytest.approx(way)
