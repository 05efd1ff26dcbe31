"""What cells should be by those they were made from, and how coarse work may be, in numbers small enough for a calculator."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.ways import _coarse, _steps, _true_steps, clear, rows_above, velocity_tolerance

NAN, H = math.nan, 0.1
ALLOWED = 0.505 * 3e-6  # of the step by its digits: u_phi + u_phi + h*u_w
USUAL = ALLOWED / 3


def coarse_of(off, gap=1.0, unit=1e-6):
    """Return what steps that are off by so much say of one angle printed to 1e-6 and its velocity to 1e-5."""
    count = len(off) + 1
    values = np.column_stack([np.zeros(count), np.ones(count)])
    expected = np.full((count, 2), NAN)
    expected[1:, 0] = off
    student = SimpleNamespace(values=values, units=np.column_stack([np.full(count, unit), np.full(count, 1e-5)]))
    return _coarse(SimpleNamespace(coordinates=("phi",), m=1, gap=gap, stride=H), student, SimpleNamespace(expected=expected))


@pytest.mark.parametrize(("middle", "rung", "decimals"), [
    (0.0, 0, None), (USUAL, 0, None), (USUAL * 1.001, 1, None), (USUAL * 1.25**3, 3, 6), (USUAL * 1.25**3 * 1.001, 4, 6),
    (0.449 * ALLOWED, 2, None), (0.451 * ALLOWED, 2, 6), (USUAL * 1.25**11, 11, 5), (-USUAL * 1.25**3, 3, 6),
    (USUAL * 1.25 ** (3 + 0.95e-6), 3, 6), (USUAL * 1.25 ** (3 + 1.05e-6), 4, 6),
])  # fmt: skip
def test_the_floor_of_coarse_work_goes_in_rungs_above_what_the_digits_allow(middle, rung, decimals):
    floor, told = coarse_of(np.full(9, middle))
    assert floor == pytest.approx(4.2 * USUAL * 1.25**rung, rel=1e-9)
    assert told == decimals


@pytest.mark.parametrize(("middle", "gap", "is_coarse"), [
    (2.9e-4, 1.0, True), (3.1e-4, 1.0, False), (0.9e-5, 21e-5, True), (1.1e-5, 21e-5, False), (13e-4, 1.0, False),
])  # fmt: skip
def test_work_is_no_coarser_than_a_part_of_the_gap_to_the_motion(middle, gap, is_coarse):
    assert (coarse_of(np.full(9, middle), gap)[0] > 0) is is_coarse


@pytest.mark.parametrize(("good", "is_coarse"), [(75, True), (74, False)])
def test_three_of_four_steps_must_be_explained(good, is_coarse):
    assert (coarse_of(np.array([USUAL] * good + [1.0] * (100 - good)))[0] > 0) is is_coarse


@pytest.mark.parametrize(("runs", "is_coarse"), [([3, 4], True), ([4, 5], False)])
def test_deviations_that_resemble_those_of_the_row_before_are_no_rounding(runs, is_coarse):
    off = np.tile(np.repeat([1.0, -1.0], runs), 50)  # of 7 (9) neighbours 2 differ in sign: 3/7 (5/9) resemble each other
    assert (coarse_of(USUAL * 1.25**6 * off)[0] > USUAL * 4.3) is is_coarse


def test_no_steps_and_no_digits_say_nothing():
    assert coarse_of(np.array([])) == coarse_of(np.full(9, USUAL), unit=NAN) == coarse_of(np.full(9, NAN)) == (0.0, None)


@pytest.mark.parametrize(("filled", "above"), [
    ("xxxx", [0, 1, 2]), ("x--xx", [0, 0, 0, 3]), ("-xx", [0, 1]), ("--x-x", [0, 1, 2, 2]), ("x", []),
])  # fmt: skip
def test_each_row_is_made_from_the_last_one_above_that_was_handed_in(filled, above):
    values = np.array([[1.0, NAN] if sign == "x" else [NAN, NAN] for sign in filled])
    assert rows_above(values).tolist() == above


def table(phi, w):
    return np.column_stack([phi, w])


KEY = SimpleNamespace(
    coordinates=("phi",), m=1, stride=H, t=H * np.arange(5.0), usual_ranges=np.array([1.0, 10.0]), table=np.array([[0.0, 8.0]]),
    velocities_at=lambda t, q: np.asarray(100 * t)[:, None] + 0 * q,
)  # fmt: skip


def test_a_step_is_the_row_above_and_h_times_its_velocity_within_the_digits_of_all_three():
    student = SimpleNamespace(values=table([1.0, 1.2, 1.5, 1.5, 2.0], [2.0, 3.0, 0.1, 5.0, 6.0]), units=np.full((5, 2), 1e-3))
    found = _steps(KEY, student)
    assert found.expected[1:, 0] == pytest.approx([1.2, 1.5, 1.51, 2.0]) and np.isnan(found.expected[0]).all()
    assert np.isnan(found.expected[:, 1]).all()
    slack = 2e-4 * H * np.array([2.0, 3.0, 0.5, 5.0])  # a twentieth of the usual range at least
    assert found.tolerance[1:, 0] == pytest.approx(0.505 * 2.1e-3 + slack)
    own = SimpleNamespace(
        expected=table([NAN] * 5, [7.0, 8.0, 9.0, 1.0, 2.0]), tolerance=table([NAN] * 5, [0.1, 0.2, 0.3, 0.4, 0.5])
    )
    true = _true_steps(KEY, student, own)
    assert true.expected[1:, 0] == pytest.approx([1.7, 2.0, 2.4, 1.6])
    assert true.tolerance[1:, 0] == pytest.approx(0.505 * 2e-3 + np.array([0.01, 0.02, 0.03, 0.04]))


def test_below_rows_that_are_missing_as_many_steps_are_made():
    """From row 0 with 2 rad/s, at 0.1 and 0.2 s with the reference's 10 and 20; with those alone the first is made with 0."""
    phi, w = [1.0, NAN, NAN, 9.0, 9.0], [2.0, NAN, NAN, 3.0, 4.0]
    student = SimpleNamespace(values=table(phi, w), units=np.full((5, 2), 1e-3))
    found = _steps(KEY, student)
    assert found.expected[3:, 0] == pytest.approx([1.0 + H * (2 + 10 + 20), 9.0 + H * 3])
    assert found.tolerance[3, 0] == pytest.approx(0.505 * (1e-3 + 1.1e-3) + 2e-4 * H * 3 * 2.0)
    own = SimpleNamespace(expected=np.full((5, 2), NAN), tolerance=np.full((5, 2), NAN))
    true = _true_steps(KEY, student, own)
    assert true.expected[3, 0] == pytest.approx(1.0 + H * (0 + 10 + 20))
    assert true.tolerance[3, 0] == pytest.approx(0.505 * (1e-3 + 1e-3) + 2e-4 * H * 3 * 2.0)


def test_a_velocity_may_be_off_by_its_digits_by_those_it_was_made_from_and_a_slack():
    expected, spread = np.array([[4.0, -0.1]]), np.array([[0.02, 0.04]])
    key = SimpleNamespace(coordinates=("phi",), m=1, usual_ranges=np.array([1.0, 10.0, 10.0]))
    found = velocity_tolerance(key, np.array([[0.01, NAN]]), expected, spread)
    assert found[0] == pytest.approx([0.505 * 0.03 + 2e-4 * 4.0, 0.505 * 0.04 + 2e-4 * 0.5])


@pytest.mark.parametrize(("expected", "tolerance", "is_clear"), [
    (2.0, 3.99, True), (2.0, 4.01, False), (-20.0, 9.99, True), (-20.0, 10.01, False), (NAN, 1.0, False),
])  # fmt: skip
def test_what_the_digits_leave_open_by_half_its_size_is_not_expected(expected, tolerance, is_clear):
    """The largest of the key's column is 8."""
    found = clear(KEY, np.array([[expected]]), np.array([[tolerance]]))
    assert np.isfinite(found).all() == is_clear
