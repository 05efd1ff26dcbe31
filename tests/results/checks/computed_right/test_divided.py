"""A divisor that changes its sign between two rows is zero there, or passes a pole."""

import math

import numpy as np
import pytest

from coursework.results.checks.computed_right.divided import _zero

STATES = np.array([[2.0, 1.0], [4.0, -3.0]])  # t and q: at a share x of the way 2 + 2x and 1 - 4x


@pytest.mark.parametrize(("value", "share"), [
    (lambda t, q: q, 0.25), (lambda t, q: t - 3.5, 0.75), (lambda t, q: q * abs(q), 0.25), (lambda t, q: 1 / (q - 1e-9), None),
    (lambda t, q: math.tan(math.pi * (t - 2) / 2 + 1e-3), None),
])  # fmt: skip
def test_where_between_two_rows_a_divisor_is_zero(value, share):
    found = _zero(value, STATES)
    assert found == (share if share is None else pytest.approx(share, abs=1e-6))
