"""Rows that stand where others belong: how far, and how many of them, before anybody speaks of a shift."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table import odd_rows
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
