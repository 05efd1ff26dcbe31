"""What of a table made by a cause as a whole does not count."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table.causes.whole import untold_points
from coursework.grading.marking.table.points import TablePoints


@pytest.mark.parametrize(("wrong", "shut"), [([False, False], {}), ([True, False], {"untold": 1})])
def test_cells_that_do_not_count_are_told_where_there_are_any(wrong, shut):
    """A page said that 0 cells do not count."""
    none = np.zeros((1, 2), dtype=bool)
    printed = SimpleNamespace(wrong=none, missing=none, counted=~none)
    made = SimpleNamespace(wrong=np.array([wrong]), missing=none, counted=~none)
    assert untold_points(printed, TablePoints(0.5, 2, {}, none), made).shut == shut
