"""What rows make, which cells stand beside their makers, and what is found first: with w = 2 p, u = 2 w and steps of a tenth."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.before.guesses import _is_open, _parts, _ranked
from coursework.grading.marking.table.before.made import _marched, as_it_was, beside_makers, made_from_rows
from coursework.grading.marking.table.before.restored import _made_into, _other, _silent
from coursework.grading.marking.table.ways import StudentTable

NAN = math.nan
KEY = SimpleNamespace(
    coordinates=("p",), m=1, velocities=("w", "u"), blocks=(("w",), ("u",)), stride=0.1, t=np.arange(4.0),
    velocities_at=lambda t, q: np.hstack([2 * q, 4 * q]), block_at=lambda index, t, q, w: {1: 2 * w[:, :1]}[index],
    variant=SimpleNamespace(unit_of={"p": "rad"}.get),
)  # fmt: skip


def table(*rows, unit=1e-3):
    values = np.array(rows, dtype=float)
    return StudentTable(values, np.full(values.shape, unit))


def test_cells_beside_their_makers_and_back():
    """The first coordinates are made from nothing, and from the last row only velocities are."""
    cells = np.array([[1, 2, 3], [4, 5, 6], [7, 8, 9]])
    assert beside_makers(cells, 1).tolist() == [[2, 3, 4], [5, 6, 7], [8, 9, 0]]
    assert _made_into(beside_makers(cells, 1), 1).tolist() == [[0, 2, 3], [4, 5, 6], [7, 8, 9]]


def test_a_row_makes_its_velocities_in_two_ways_and_the_next_coordinate_in_three():
    """By p = 3: w = 6, u = 12; u from the printed w = 5: 10; steps with 5, with 6, and with the first of the later ones: none."""
    found = made_from_rows(KEY, KEY.t[:1], np.array([[3.0, 5.0, 7.0]]))
    assert found[0] == pytest.approx([6, 12, NAN, 10, 3.5, 3.6, 3.5], nan_ok=True)


def ways(student, step=(), true=()):
    """Return ways by which the coordinates of some rows follow from the row above, and velocities may be off by a tenth."""

    def holds(rows):
        flags = np.zeros(student.values.shape, dtype=bool)
        flags[list(rows), 0] = True
        return SimpleNamespace(holds=lambda values: flags)

    wide = SimpleNamespace(tolerance=np.full(student.values.shape, 0.1))
    none = SimpleNamespace(tolerance=np.full(student.values.shape, NAN))
    return SimpleNamespace(angles=wide, earlier=none, step=holds(step), step_true=holds(true))


def test_cells_put_right_are_again_what_the_rows_above_made():
    """Row 2 is the task's: 1.32 and its velocities, where the rows above make 1.2 + 0.12 = 1.44."""
    student = table([1.0, 2, 4], [1.2, 2.4, 4.8], [1.32, 2.64, 5.28], [1.73, 3.4, 6.9])
    right = np.array([[False] * 3, [False] * 3, [True] * 3, [False] * 3])
    found = as_it_was(KEY, student, right, ways(student))
    assert found.values[2] == pytest.approx([1.44, 2.88, 5.76])
    assert found.values[[0, 1, 3]].tolist() == student.values[[0, 1, 3]].tolist()
    assert found.units[2, 0] == pytest.approx(2.1e-3) and found.units[1, 0] == 1e-3
    assert as_it_was(KEY, student, np.zeros_like(right), ways(student)) is None
    follows = np.zeros_like(right)
    follows[1:3] = True  # of two, the second one that follows from the first is left; edges are made anew
    assert as_it_was(KEY, student, follows, ways(student, step=[2])).values[2, 0] == pytest.approx(1.44)


def test_velocities_that_follow_stay_as_printed_and_a_missing_cell_is_no_change():
    """Of 1.2 the velocities 2.45 and 4.85 are near enough to 2.4 and 4.9, 2.6 is not; row 3 follows in the second way only."""
    student = table([1.0, 2, NAN], [1.2, 2.45, 4.85], [1.5, 2.9, 6.0], [1.95, 3.9, 7.8])
    right = np.array([[False] * 3, [False, True, True], [False] * 3, [False] * 3])
    assert as_it_was(KEY, student, right, ways(student)) is None
    off = replace(student, values=np.where(student.values == 2.45, 2.6, student.values))
    assert as_it_was(KEY, off, right, ways(off)).values[1] == pytest.approx([1.2, 2.4, 4.85])
    right[1:, 0] = True
    assert as_it_was(KEY, student, right, ways(student, true=[3])).values[2:, 0] == pytest.approx([1.445, 1.735])
    right[0, 0] = True
    assert as_it_was(KEY, student, right, ways(student, true=[2, 3])) is None


def test_what_is_no_step_from_above_becomes_that_step_with_the_digits_of_what_it_is_made_of():
    """Steps of 0.2 in both columns; the last place of row n (from 1) is n thousandths, that of its velocities n hundredths.

    In the first, row 2 begins a run; row 4 is no step, so rows 5 and 6 are made from it; 7 is near enough; 8 follows otherwise.
    """
    key = SimpleNamespace(coordinates=("p", "s"), m=2, stride=0.1)
    first = [1.0, 1.2, 1.403, 1.9, 2.15, 1.7, 2.205, 3.0, 3.2135, 9.9]
    second = [1.0, 1.2, 1.9, 2.1, 5.0, 2.5, 2.7, 2.9, 3.1, 3.3]
    digits = np.arange(1, 11) * 1e-3
    student = StudentTable(
        np.column_stack([first, second, first, second]), np.column_stack([digits, digits, 10 * digits, 20 * digits])
    )
    right = np.array([[False, True], *[[True, True]] * 8, [False, True]])
    follows = np.array([[False, True], [True, True], [True, True], [False, True], *[[True, True]] * 4, [False] * 2, [True] * 2])
    follows[4, 1] = False
    q, units = _marched(key, student, right, follows, np.full((10, 2), 2.0))
    assert q[:, 0] == pytest.approx([1.0, 1.2, 1.403, 1.603, 1.803, 2.003, 2.205, 3.0, 3.2, 9.9])
    made = {1: 2 + 1 + 1, 3: 4 + 3 + 3, 4: 5 + 10 + 4, 5: 6 + 19 + 5, 8: 9 + 8 + 8}
    assert units[:, 0] == pytest.approx([1e-3 * made.get(row, row + 1) for row in range(10)])
    assert q[:, 1] == pytest.approx([1.0, 1.2, 1.9, 2.1, 2.3, 2.5, 2.7, 2.9, 3.1, 3.3])
    assert units[4, 1] == pytest.approx(1e-3 * (5 + 4 + 8)) and units[5, 1] == pytest.approx(6e-3)
    assert student.values[3, 0] == 1.9 and student.units[1, 0] == 2e-3


@pytest.mark.parametrize(("moved", "makes", "columns", "odd"), [
    ("010 100 000 000", "1100", [[1], [0], [0, 1]], True), ("010 100 000 000", "1000", [[1]], False),
    ("010 000 100 000", "1010", [[0], [1], [0, 1]], False), ("001 001 000 000", "0100", [], True),
    ("000 000 000 000", "1111", [], False),
])  # fmt: skip
def test_parts_are_the_coordinates_that_move_where_wrong_cells_are_made_and_every_second_row_of_two(moved, makes, columns, odd):
    """Of two coordinates and a velocity, which never makes a part of its own."""
    flags = np.array([[sign == "1" for sign in row] for row in moved.split()])
    rows = [[[False], [True]] * 2, [[True], [False]] * 2]
    for alone in (False, True):  # where most rows are wrong, one by one: the other is nearer to what it was as printed
        found = list(_parts(flags, np.array([sign == "1" for sign in makes]), 2, alone=alone))
        expected = sorted(some for some in columns if len(some) == 1 or not alone)
        assert sorted(np.flatnonzero(one).tolist() for one in found if one.ndim == 1) == expected
        assert sorted(one.tolist() for one in found if one.ndim == 2) == (rows if odd and not alone else [])


def test_an_angle_is_open_by_whole_turns_where_a_velocity_tells_it():
    assert _is_open(KEY, np.array([0, 0, 0, 1]), np.array([0, 3, 4, 0])).tolist() == [True, True, False, False]


def test_of_each_row_the_cell_of_which_most_speaks_comes_first_and_of_equal_ones_the_most_exact():
    row, place = np.array([0, 0, 0, 1, 1, 1, 0, 0]), np.array([0, 1, 0, 2, 1, 0, 2, 1])
    x, counts = np.array([10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0]), np.array([2, 3, 4, 2, 2, 0, 2, 3])
    far, half = np.array([0, 0, 3, 0, 0, 0, 0, 1]), np.array([0.1, 0.2, 0.1, 0.1, 0.1, 0.1, 0.3, 0.1])
    by_step = np.zeros(8, dtype=bool)
    (first, units), (second, _), (third, _) = _ranked((2, 3), (row, place, by_step), (x, x / 4), counts, far, half)
    assert np.nan_to_num(first).tolist() == [[12, 0, 0], [0, 14, 0]] == np.nan_to_num(4 * units).tolist()
    assert second[0, 1] == 11.0 and second[1, 2] == 13.0 and third[0, 2] == 16.0 and np.isnan(third[1]).all()
    assert _ranked((2, 3), (row, place, by_step), (x, x), np.zeros(8, dtype=int), far, half) == []


@pytest.mark.parametrize(("other", "values"), [(10.3, (10.0, 10.3)), (10.19, (10.0,)), (9.81, (10.0,)), (9.79, (10.0, 9.79))])
def test_a_cell_has_a_value_by_a_step_beside_that_by_a_velocity_if_these_differ(other, values):
    at = np.array([0, 0]), np.array([1, 1]), np.array([False, True])
    found = _ranked((1, 2), at, (np.array([10.0, other]), np.zeros(2)), np.array([3, 2]), np.zeros(2), np.array([0.1, 0.2]))
    assert [table[0, 1] for table, _ in found] == list(values)


@pytest.mark.parametrize(("moved", "gains", "silent"), [
    ("xxx", "---", "xxx"), ("xxx", "-x-", "x--"), ("-xx-x", "-----", "-xx-x"), ("xx-xx", "x----", "---xx"), ("---", "xxx", "---"),
    ("xx", "xx", "--"),
])  # fmt: skip
def test_of_rows_that_moved_the_first_ones_without_gain_are_silent(moved, gains, silent):
    found = _silent(*(np.array([sign == "x" for sign in text]) for text in (moved, gains)))
    assert "".join("x" if one else "-" for one in found) == silent


def test_tables_beside_each_other():
    one, two = table([1, 2, 3], [4, 5, NAN]), table([1, 9, 3], [7, 5, 6], unit=1e-2)
    assert _other(two, one).tolist() == [[False, True, False], [True, False, True]]
    assert _other(one, two).tolist() == [[False, True, False], [True, False, False]]
