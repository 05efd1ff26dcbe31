"""The start from which row 2 was made, where row 1 has been put right: on two coordinates whose rates are known by heart."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.grading.marking.table.starts import _stepped_back
from coursework.grading.marking.table.ways import StudentTable

STRIDE = 0.1
KEYED: Any = SimpleNamespace(
    coordinates=("p", "q"), m=2, stride=STRIDE, t=np.zeros(1), velocities_at=lambda t, q: q * np.array([2.0, -1.0])
)


def cells(*, start: float = 1.5, below: float = 1.44, misprint: float = 1.2) -> Any:
    """Row 1 says 1.5, the task's, and 4; row 2 was stepped from 1 and 4: 1.2 and 3.6. The rates in row 1 are the task's."""
    values = np.array(
        [[start, 4.0, 3.0, -4.0], [misprint, 3.6, 2.4, -3.6], [below, 3.24, 2.88, -3.24], [1.728, 2.916, 3.456, -2.916]]
    )
    units = np.array([[0.01, 0.01, 0.02, 0.03], [0.001, 0.002, 0.01, 0.01], [0.01] * 4, [0.01] * 4])
    return SimpleNamespace(student=StudentTable(values, units))


@pytest.mark.parametrize("misprint", [1.2, 7.0, 1.8, np.nan])  # 1.8 is what the task's start makes
def test_the_start_is_found_from_row_2_as_the_next_rows_have_it(misprint: float) -> None:
    given = cells(misprint=misprint)
    found = _stepped_back(KEYED, given)
    assert found is not None
    assert found.values[0] == pytest.approx([1.0, 4.0, 3.0, -4.0], abs=1e-3)
    assert found.units[0] == pytest.approx([0.001 + STRIDE * 0.02, 0.01, 0.02, 0.03])
    assert np.array_equal(found.values[1:], given.student.values[1:], equal_nan=True) and given.student.values[0, 0] == 1.5


@pytest.mark.parametrize("other", [{"start": 0.9}, {"below": 1.6, "misprint": 1.3}])
def test_a_row_2_that_follows_or_of_which_no_two_rows_say_the_same_tells_no_start(other: dict[str, float]) -> None:
    assert _stepped_back(KEYED, cells(**other)) is None


@pytest.mark.parametrize(("start", "is_other"), [(0.9029, False), (0.9031, True)])
def test_a_start_is_another_if_its_step_misses_row_2_by_more_than_a_digit(start: float, is_other: bool) -> None:
    assert (_stepped_back(KEYED, cells(start=start)) is not None) == is_other
