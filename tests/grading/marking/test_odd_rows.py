"""Rows that stand where others belong: how far, and how many of them, before anybody speaks of a shift."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table import odd_rows, points
from coursework.grading.marking.table.cells import GIVEN, KEY, MISSING, STEP, WRONG
from coursework.grading.marking.table.odd_rows import Shift, displaced_rows


@pytest.mark.parametrize("by", [1, 2, 3, -3, 4, -4])
@pytest.mark.parametrize("many", [3, 2])
def test_three_rows_in_a_row_that_belong_up_to_three_rows_off(by: int, many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows 8 and on of twenty, in each of which every number is another."""
    table = np.arange(40.0).reshape(20, 2) ** 2
    values = table.copy()
    values[7 : 7 + many] = table[7 + by : 7 + many + by]
    monkeypatch.setattr(odd_rows, "as_printed", lambda key, units: np.full(values.shape, 0.01))
    student = SimpleNamespace(values=values, units=np.zeros(values.shape))
    found = displaced_rows(SimpleNamespace(table=table), SimpleNamespace(student=student))
    assert found == ((Shift(8, 7 + many, by),) if many == 3 and abs(by) <= 3 else ())


@pytest.mark.parametrize(
    ("below", "begins_wrong"),
    [
        ((KEY, STEP, KEY), False), ((MISSING, KEY, STEP), False), ((MISSING, STEP, KEY), True), ((MISSING,) * 3, True),
        ((STEP, KEY, KEY), True),
    ],
)  # fmt: skip
def test_a_wrong_start_value_is_a_slip_of_the_pen_where_the_first_value_below_is_right(
    below: tuple[int, ...], begins_wrong: bool
) -> None:
    marks = np.array([[GIVEN, WRONG], *([KEY, mark] for mark in below)])
    cells = SimpleNamespace(wrong=marks == WRONG, marks=marks)
    assert points._begins_wrong(cells, 2) == begins_wrong
    assert not points._begins_wrong(SimpleNamespace(wrong=np.zeros_like(marks, dtype=bool), marks=marks), 2)


def test_a_column_is_constant_that_changes_by_no_more_than_round_off() -> None:
    key = SimpleNamespace(ranges=5 * np.array([0.0, 0.9e-9, 1.1e-9]), table=np.full((3, 3), -5.0))
    assert points._constant(key).tolist() == [True, True, False]
