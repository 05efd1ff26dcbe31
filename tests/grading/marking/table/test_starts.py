"""The start from which row 2 was made, where row 1 has been put right: on two coordinates whose rates are known by heart."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.grading.marking.table.starts import _stepped_back
from coursework.grading.marking.table.ways import ANGLES, KEY, STEP, STEP_TRUE, StudentTable

STRIDE = 0.1
KEYED: Any = SimpleNamespace(
    coordinates=("p", "q"), stride=STRIDE, t=np.zeros(1), velocities_at=lambda t, q: q * np.array([2.0, -1.0])
)


def cells(marks: list[int], wrong: list[bool]) -> Any:
    """Row 1 says 1.5 and 4, the task's; row 2 was stepped from 1 and 4: 1.2 and 3.6. The rates in row 1 are the task's."""
    values = np.array([[1.5, 4.0, 3.0, -4.0], [1.2, 3.6, 2.4, -3.6], [1.44, 3.24, 2.88, -3.24]])
    units = np.array([[0.01, 0.01, 0.02, 0.03], [0.001, 0.002, 0.01, 0.01], [0.01, 0.01, 0.01, 0.01]])
    return SimpleNamespace(
        student=StudentTable(values, units), wrong=np.array([[False] * 4, [*wrong, False, False], [True] * 4]),
        marks=np.array([[ANGLES] * 4, [ANGLES] * 4, [*marks, KEY, KEY]]),
    )  # fmt: skip


@pytest.mark.parametrize("mark", [KEY, STEP, STEP_TRUE])
def test_the_start_is_found_from_row_2_where_row_3_follows_from_it(mark: int) -> None:
    given = cells([mark, ANGLES], [True, False])
    found = _stepped_back(KEYED, given)
    assert found is not None
    assert found.values[0] == pytest.approx([1.0, 4.0, 3.0, -4.0], abs=1e-5)
    assert found.units[0] == pytest.approx([0.001 + STRIDE * 0.02, 0.01, 0.02, 0.03])
    assert np.array_equal(found.values[1:], given.student.values[1:]) and given.student.values[0, 0] == 1.5


@pytest.mark.parametrize(("marks", "wrong"), [
    ([KEY, KEY], [False, False]), ([ANGLES, KEY], [True, False]), ([KEY, ANGLES], [False, True]),
])  # fmt: skip
def test_a_row_2_that_is_right_or_from_which_no_row_follows_tells_no_start(marks: list[int], wrong: list[bool]) -> None:
    assert _stepped_back(KEYED, cells(marks, wrong)) is None
