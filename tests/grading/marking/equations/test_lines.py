"""Lines of a student at the points of a probe: what round-off makes of them, which say the same, which are near enough."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.equations.linear import Linear, _holds, is_same, rank


def line(*slopes, rest=0.0, size=1.0, points=1):
    """Return a line with the same slopes at every point, in velocities of 1."""
    probe = SimpleNamespace(scale=np.ones(len(slopes)), velocities=np.ones((points, len(slopes))))
    return Linear(np.tile(np.array(slopes, dtype=float), (points, 1)), np.full(points, rest), np.full(points, size), probe)


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        (line(1, 2, rest=3), line(-2, -4, rest=-6), True), (line(1, 2, rest=3), line(1, 2, rest=-3), False),
        (line(1, 1), line(1, 1 + 1.2e-8), True), (line(1, 1), line(1, 1 + 2.2e-8), False),
        (line(1e-12, 0), line(0, 1e-12), False), (line(1e12, 0), line(1, 0), True), (line(0, 0), line(1, 2), True),
        (line(np.nan, 1), line(np.nan, 1), False),
    ],
)  # fmt: skip
def test_lines_say_the_same_that_are_each_other_times_a_number(one, other, same):
    assert is_same(one, other) == same


@pytest.mark.parametrize(("left", "says"), [(0.9e-12, False), (1.1e-12, True), (-1.1e-12, True)])
def test_a_line_of_which_round_off_is_left_says_nothing(left, says):
    assert bool(line(left, 0).directions.any()) == says
    assert rank([line(left, 0), line(0, 1)]) == 1 + says


@pytest.mark.parametrize(
    ("lines", "independent"), [((), 0), ((line(1, 1), line(1, 1 + 1.2e-8)), 1), ((line(1, 1), line(1, 2)), 2)]
)
def test_rank(lines, independent):
    assert rank(lines) == independent


@pytest.mark.parametrize(
    ("rest", "size", "near"),
    [(0.9e-3, 1.0, True), (1.1e-3, 1.0, False), (4.9e-3, 10.0, True), (5.1e-3, 10.0, False), (-1.1e-3, 1.0, False)],
)
def test_what_rounding_explains(rest, size, near):
    """A residual of a part 1e-3 of the terms as written, and of five times that of what is collected of them."""
    assert line(0.5, -0.5, rest=rest, size=size).is_near(1e-3) == near


def test_a_few_points_may_nearly_cancel_and_most_may_not():
    for many, near in ((1, True), (2, False)):
        rest = np.where(np.arange(3) < many, 8e-3, 0.0)
        lines = line(0.5, -0.5, size=10.0, points=3)
        assert Linear(lines.slopes, rest, lines.size, lines.probe).is_near(1e-3) == near


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "holds"), [(0.98e-6, True), (-0.98e-6, True), (1.02e-6, False), (-1.02e-6, False)])
def test_an_equation_holds_within_a_millionth_of_its_terms(size, part, holds):
    """Two terms of opposite sign, each half of their sum but for a part, at the second of two points."""
    slopes, rest = np.array([[size], [size]]), -size * np.array([1.0, 1.0 + 2 * part])
    line = Linear(slopes, rest, np.ones(2), None)
    assert _holds(line, np.ones((2, 1))) is holds
