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
    printed = SimpleNamespace(right=~none, missing=none)
    made = SimpleNamespace(right=~np.array([wrong]), carried=none)
    assert untold_points(printed, TablePoints(0.5, 2, {}, none), made, 1.0).shut == shut


def test_a_cell_too_coarse_to_be_shown_earns_nothing_in_a_table_made_by_a_cause():
    none, first = np.zeros((1, 2), dtype=bool), np.array([[True, False]])
    printed = SimpleNamespace(right=~first, missing=first)
    for carried, share in ((none, 0.5), (first, 0.75)):
        made = SimpleNamespace(right=~none, carried=carried)
        assert untold_points(printed, TablePoints(1.0, 2, {}, none), made, 0.5).share == share
