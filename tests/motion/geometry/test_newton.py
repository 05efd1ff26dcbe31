"""When Newton has arrived and when it gives up, on corrections made up for it; row by row by the same rules."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.geometry.closure import Closure


@pytest.mark.parametrize(
    ("steps", "taken"),
    [
        ([9.9, 0.0], 2), ([10.1], None), ([-10.1], None), ([np.nan], None),  # no correction goes further than ten
        ([1e-3, 0.9e-15], 2), ([1e-3, 1.1e-15, 0.0], 3),  # settled
        ([0.9e-11, 0.5e-11], 2), ([0.9e-11, 0.4e-11, 0.0], 3), ([1.2e-11, 1.1e-11, 0.0], 3),  # small, and shrinks no longer
        ([1e-3] * 24 + [0.0], 25), ([1e-3] * 24 + [0.9e-9], 25), ([1e-3] * 24 + [1.1e-9], None),  # corrections run out
    ],
)  # fmt: skip
def test_newton_ends_where_it_has_settled_or_runs_off(steps, taken):
    assert_both(steps, None if taken is None else np.cumsum(steps)[-1])


def assert_both(steps, end):
    """The n-th correction is the n-th of the steps."""
    left = iter(steps)
    alone = SimpleNamespace(correction=lambda t, q, target: np.array([next(left)]))
    found = Closure.newton(alone, 0.0, np.zeros(1), None)
    assert (found is None) == (end is None)
    if found is not None:
        assert found[0] == end
    assert not [*left]
    again = iter(steps)
    rows = SimpleNamespace(correction=lambda t, q, target: np.full((len(q), 1), next(again)))
    q, closed = Closure.newton_rows(rows, np.zeros(2), np.zeros((2, 1)), np.zeros((2, 0)))
    assert closed.tolist() == [end is not None] * 2
    if end is not None:
        assert q.tolist() == [[end]] * 2
