"""Rows that repeat others or contradict them, just inside and just outside what round-off explains."""

import numpy as np
import pytest

from coursework.equations.reduction.independent import _judge_dropped, _left_out, _nearly, independent_rows


@pytest.mark.parametrize(("part", "kept"), [(1.8e-9, [0]), (2.2e-9, [0, 1]), (-1.8e-9, [0]), (-2.2e-9, [0, 1])])
def test_a_row_of_which_a_billionth_is_left_depends_on_those_before(part, kept):
    """Of (1, 1 + x) beside (1, 1) there is x/2 of its length left; a column of other unit changes nothing."""
    rows = np.array([[1.0, 1.0], [1.0, 1.0 + part]])
    assert independent_rows(rows) == independent_rows(rows * [1.0, 1e6]) == independent_rows(rows * [1e-9, 1e-12]) == kept
    assert independent_rows(np.array([[0.0, 0.0], *rows])) == [one + 1 for one in kept]


@pytest.mark.parametrize(
    ("right", "contradicts"),
    [((1, 1 + 1.8e-9), False), ((1, 1 + 2.2e-9), True), ((1, 1 - 2.2e-9), True), ((0, 0.9e-12), False), ((0, 1.1e-12), True)],
)
def test_a_right_side_contradicts_by_more_than_a_billionth_of_both(right, contradicts):
    for size in (1e-6, 1e7):
        sames, conflicts = _judge_dropped(size * np.ones((2, 1)), size * np.array(right, dtype=float), [0], ["1", "2"], size)
        assert bool(conflicts) is contradicts
    assert [name for name, *_ in conflicts] == (["2"] if contradicts else [])
    assert sames == ([] if contradicts else [("2", ["1"])])


@pytest.mark.parametrize(("weight", "named"), [(0.9e-9, ["1"]), (1.1e-9, ["1", "2"]), (-1.1e-9, ["1", "2"])])
def test_rows_that_count_for_a_billionth_are_not_named(weight, named):
    ((index, _, involved),) = _left_out(np.array([[1.0, 0.0], [0.0, 1.0], [1.0, weight]]), [0, 1], ["1", "2", "3"])
    assert (index, involved) == (2, named)


@pytest.mark.parametrize(("part", "differs"), [(1.8e-14, False), (2.2e-14, True)])
def test_what_differs_by_more_than_round_off_is_written_so(part, differs):
    assert bool(_nearly(np.array([[1.0, 0.0], [1.0, part]]), [0], ["1", "2"])) == differs
