"""Rows that number the columns, and times with a step of their own: what is taken for either, just inside and just outside."""

from __future__ import annotations

import math

import pytest

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.numbers import PrintedNumber, no_number, printed
from coursework.grading.reading.table.layout import _numbered, goes_on, layouts_of
from coursework.grading.reading.table.rows import _own_step

HEADS = ["t", "phi, rad", "", "w (rad/s)", ""]
BODY = ["0", "1.1", "1.2", "1.3", "1.4"]
GRID = Grid(0.02, 21, ())


def cells(texts: list[str]) -> list[PrintedNumber]:
    return [printed(text, ".") if text else no_number("", "missing") for text in texts]


def after(*rows: list[str]) -> list[list[str]]:
    """The texts of a table when the rows that number its columns are taken out."""
    return [[cell.text for cell in row] for row in _numbered([cells(row) for row in rows])]


@pytest.mark.parametrize("first", [0, 1])
def test_a_head_over_several_columns_takes_their_numbers_before_its_unit(first: int) -> None:
    one, two = str(first), str(first + 1)
    told = ["t", f"phi{one}, rad", f"phi{two}, rad", f"w{one}(rad/s)", f"w{two}(rad/s)"]
    assert after(HEADS, ["", one, two, one, two], BODY) == [told, BODY]
    assert after(HEADS, ["t", one, two, one, two], BODY) == [told, BODY]  # a head merged with the cell below is repeated there
    assert after(HEADS, ["", one, two, "", ""], BODY)[0] == ["t", f"phi{one}, rad", f"phi{two}, rad", "w (rad/s)", ""]
    assert after(["t", "phi"], ["", one, two], BODY)[0] == ["t", f"phi{one}", f"phi{two}"]  # numbers beyond the last head


@pytest.mark.parametrize(
    "row",
    [
        ["", "2", "3", "2", "3"],  # begins with neither 0 nor 1
        ["", "1", "3", "1", "3"],  # leaves a number out
        ["", "1", "1", "1", "1"],  # numbers nothing
        ["", "2", "1", "0", "1"],
        ["", "1", "0.5", "0", "-1"],  # goes down only
        ["0", "1", "2", "1", "2"],  # a row of the table: its first column has a number
        ["", "1", "", "", ""],
    ],
)
def test_other_rows_stay_rows(row: list[str]) -> None:
    assert after(HEADS, row, BODY) == [HEADS, row, BODY]


def test_numbers_without_heads_above_them_are_left_out() -> None:
    """A row of numbers is no head, nor is a row of empty cells: what numbers the columns names nothing there."""
    row = ["", "1", "2", "3", "4"]
    assert after(row, BODY) == [BODY]
    assert after(BODY, row, BODY) == [BODY, BODY]
    assert after([""] * 5, row, BODY) == [[""] * 5, BODY]
    half = ["t", "", "", "w", ""]
    assert after(half, row, BODY) == [["t", "t1", "t2", "w3", "w4"], BODY]


@pytest.mark.parametrize(("begin", "step", "names", "goes"), [
    (0.06, 0.02, None, True), (0.0659, 0.02, None, True), (0.0661, 0.02, None, False),  # a step later, within 3 tenths of one
    (0.0541, 0.02, None, True), (0.0539, 0.02, None, False), (0.04, 0.02, None, False), (0.12, 0.02, None, False),
    (0.12, 0.02, ["t", "phi1"], True), (0.0541, 0.02, ["t", "phi1"], True), (0.0539, 0.02, ["t", "phi1"], False),
    (0.0, 0.02, ["t", "phi1"], False), (0.06, 0.02, ["phi1", "w1"], False),
    (0.04, 0.02, ["t", "phi1"], True),  # the row of 0.04 s twice
])  # fmt: skip
def test_a_table_goes_on_a_step_later_or_anywhere_later_under_heads(
    begin: float, step: float, names: list[str] | None, goes: bool
) -> None:
    columns = (("phi1", "rad"), ("w1", "rad/s"))
    (first,) = layouts_of([cells(row) for row in (["t", "phi1"], ["0", "5"], ["0.02", "6.5"], ["0.04", "7"])], ".", columns)
    rows = [[f"{begin + k * step:.4g}", value] for k, value in enumerate(("7", "4", "9.5"))]
    (second,) = layouts_of([cells(row) for row in ([names] if names else []) + rows], ".", columns)
    assert second.has_heads is bool(names)
    assert goes_on(first, second) is goes
    changed = [[rows[0][0], "7.5"], *rows[1:]]
    (second,) = layouts_of([cells(row) for row in ([names] if names else []) + changed], ".", columns)
    assert goes_on(first, second) is (goes and not (names and begin == 0.04))


@pytest.mark.parametrize(
    ("ratio", "other"), [(1.049, False), (1.051, True), (0.951, False), (0.949, True), (0.5, True), (3, True)]
)
def test_a_step_is_another_from_a_twentieth_on(ratio: float, other: bool) -> None:
    times = [0.02 * ratio * place for place in range(8)]
    rows, step = _own_step(times, GRID)
    assert (bool(rows), step) == (other, pytest.approx(0.02 * ratio if other else 0, abs=1e-12))
    shuffled, again = _own_step(times[::-1], GRID)
    assert again == pytest.approx(step) and shuffled == (rows and (7, 6, 5, 4, 3, 2, 1, 0))


@pytest.mark.parametrize(("count", "rows"), [(2, ()), (3, (0, 1, 2))])
def test_three_times_show_a_step_and_two_do_not(count: int, rows: tuple[int, ...]) -> None:
    assert _own_step([0.05 * place for place in range(count)] + [math.nan], GRID)[0] == rows


@pytest.mark.parametrize(("off", "even"), [(0.29, True), (0.31, False), (-0.29, True), (-0.31, False)])
def test_a_time_is_of_its_row_within_three_tenths_of_a_step(off: float, even: bool) -> None:
    """A time further off is that of no row, be it of the student's step or of the task's: the steps are uneven."""
    times = [0.05 * place for place in range(8)]
    times[3] += 0.05 * off
    assert (_own_step(times, GRID)[1] > 0) is even


def test_times_put_right_one_by_one_leave_the_rest_a_step_of_their_own() -> None:
    """Row 4 has the time of the task's row 4: it stands where one of the student's rows is lacking."""
    times = [0.05 * place for place in range(12)]
    times[3] = 0.06
    rows, step = _own_step(times, GRID)
    assert rows == (0, 1, 3, 2, *range(4, 12)) or rows == tuple(range(12))
    assert step == pytest.approx(0.05, rel=0.03)
    times[3] = 0.011  # no time of the task's either
    assert _own_step(times, GRID) == ((), 0.0)
