"""What is right of a force in a row, its size by its two parts, and the largest of its kind there."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.key.forces import ForceKey

NAMES = ("R01x", "R01y", "N03", "M", "K03")


def key():
    """Return a key whose exact rows and table differ in row 2; no value is known of the couple K03 there."""
    made = ForceKey(None)
    exact = np.array([[9.0, 9, 9, 9, 9], [3.0, -4.0, 11.0, -2.0, np.nan]])
    table = exact + np.array([[0.0] * 5, [3.0, -4.0, 1.0, 0.5, 0.0]])
    both = tuple(SimpleNamespace(reactions=SimpleNamespace(names=NAMES, rows=rows)) for rows in (exact, table))
    made.__dict__.update(_both=both, _slipped={"no_inertia": exact * 2})
    return made


@pytest.mark.parametrize(("name", "right"), [
    ("R01x", (3.0, 6.0, 11.0)), ("R01", (5.0, 10.0, 11.0)), ("N03", (11.0, 12.0, 11.0)), ("M", (-2.0, -1.5, 2.0)),
    ("R01y", (-4.0, -8.0, 11.0)),
])  # fmt: skip
def test_a_force_in_a_row_beside_the_largest_force_and_a_couple_beside_the_largest_couple(name, right):
    assert key().right(name, 1) == pytest.approx(right)


def test_where_no_other_is_known_a_force_is_the_largest_itself():
    alone = ForceKey(None)
    found = SimpleNamespace(reactions=SimpleNamespace(names=("M",), rows=np.array([[np.nan]])))
    alone.__dict__["_both"] = found, found
    assert np.isnan(alone.right("M", 0)[2])


def test_a_column_of_a_size_and_what_a_slip_makes_of_it():
    exact, table, slips = key().columns("R01")
    assert (exact.tolist(), table[1], slips["no_inertia"][1]) == ([pytest.approx(9 * 2**0.5), 5.0], 10.0, 10.0)
