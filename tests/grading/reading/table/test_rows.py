"""Where a table says which row is which: its times, their numbers, or neither."""

from __future__ import annotations

import math

import pytest

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.numbers import PrintedNumber
from coursework.grading.reading.table.rows import _by_time, _order, _own_step, _times
from tests.grading.reading.table.misread import HEAD, ROWS, column, csv, read

DATE = PrintedNumber("02.янв", math.nan, 0, 0, "date")


def cell(value: float) -> PrintedNumber:
    return PrintedNumber(f"{value:g}", value, -2, 2, "")


@pytest.mark.parametrize(("cells", "times", "restored"), [
    ([0, DATE, 40, 60], [0, 0.02, 0.04, 0.06], 1), ([0, 20, DATE, DATE], [0, 0.02, 0.04, 0.06], 2),
    ([0, 20, 40], [0, 0.02, 0.04], 0),
    ([DATE, 20, 40], [0, 0.02, 0.04], 1), ([0, DATE, 45, 60], [0, 0.02, 0.045, 0.06], 1),
    ([0, DATE, 47, 60], [0, None, 0.047, 0.06], 0), ([DATE, DATE, 40], [None, None, 0.04], 0),
])  # fmt: skip
def test_times_that_a_spreadsheet_spoilt_follow_from_those_around_them(cells, times, restored) -> None:  # type: ignore[no-untyped-def]
    found, count = _times([one if isinstance(one, PrintedNumber) else cell(one) for one in cells], 1e-3)
    assert [None if math.isnan(time) else pytest.approx(time, abs=1e-12) for time in found] == times
    assert count == restored


def rows(first: list[str], *, heads: list[str] | None = None, start: int = 1) -> bytes:
    """The table with its rows numbered before, or instead of, the time."""
    body = [[str(number) if name == "№" else row[0] for name in first] + row[1:] for number, row in enumerate(ROWS, start)]
    return "\n".join(";".join(line) for line in ([heads] if heads else []) + body).encode()


@pytest.mark.parametrize("start", [0, 1])
@pytest.mark.parametrize(("first", "heads"), [
    (["t"], None), (["№", "t"], None), (["№"], None), (["№", "t"], ["", "t", *HEAD[1:]]), (["№", "t"], ["№", "", *HEAD[1:]]),
    (["№", "t"], ["", "", *HEAD[1:]]), (["№"], ["", *HEAD[1:]]), (["t"], ["", *HEAD[1:]]), (["№"], ["№", *HEAD[1:]]),
])  # fmt: skip
def test_a_table_reads_the_same_with_times_with_numbers_of_rows_and_with_both(
    first: list[str], heads: list[str] | None, start: int
) -> None:
    table = read(rows(first, heads=heads, start=start))
    assert all(table.rows_present)
    for name in ("phi1", "w4"):
        assert column(table, name) == column(read(csv(ROWS)), name)


@pytest.mark.parametrize("step", [0.004, 30.0])
@pytest.mark.parametrize(("unit", "off", "found"), [
    (0.499, 0.4, None), (0.501, 0.4, 2), (0.501, 0.55, 2), (0.501, 0.56, None),  # 0.51 of a unit and 0.3 of a step, together
    (0.01, 0.299, 2), (0.01, 0.301, None), (0.01, -0.299, 2), (0.01, -0.301, None),
])  # fmt: skip
def test_times_coarser_than_half_a_step_count_in_order_at_any_step(step, unit, off, found):  # type: ignore[no-untyped-def]
    times = [step * place for place in (0, 1, 2 + off, 3)]
    assert _by_time(times, unit * step, Grid(step, 5, ()), 0.0)[2] == found


@pytest.mark.parametrize("step", [0.004, 30.0])
@pytest.mark.parametrize(("off", "even"), [(0.299, True), (-0.299, True), (0.301, False), (-0.301, False)])
def test_own_times_are_even_within_three_tenths_of_their_step(step, off, even):  # type: ignore[no-untyped-def]
    times = [step * place for place in (0, 1, 2 + off, 3, 4)]
    assert _own_step(times, Grid(1.7 * step, 5, ())) == (((0, 1, 2, 3, 4), pytest.approx(step)) if even else ((), 0.0))


@pytest.mark.parametrize("step", [0.004, 30.0])
@pytest.mark.parametrize(("part", "order"), [(1.02e-3, (0, 2, 1, 3, 4)), (0.98e-3, ())])
def test_times_nearer_than_a_thousandth_of_a_step_are_in_no_order(step, part, order):  # type: ignore[no-untyped-def]
    times = [part * step * place for place in (0, 2, 1, 3, 4)]
    assert _order(times, [None] * 5, Grid(step, 5, ())) == order
