"""How fast deviations die out, on linear motions whose rates are known, and which motion counts as slow."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.close_to_motion.stiffness import _dying, _is_slow


@pytest.mark.parametrize(
    ("matrix", "rate"),
    [
        ([[-5, 0], [0, -1]], 5), ([[5, 0], [0, 1]], 0), ([[0, 3], [-3, 0]], 0), ([[-1, 3], [-3, -1]], 0),
        ([[-3, 1], [-1, -3]], 3), ([[-3, 2.9], [-2.9, -3]], 3), ([[-3, 3.1], [-3.1, -3]], 0),
    ],
)  # fmt: skip
def test_what_swings_faster_than_it_dies_out_does_not_die_out(matrix, rate):
    rates = SimpleNamespace(table=lambda t, q: (q @ np.array(matrix, dtype=float).T, None))
    found = _dying(SimpleNamespace(rates=rates), np.zeros(3), np.array([[0.0, 1.0], [1.0, 0.5], [2.0, 0.0]]))
    assert found == pytest.approx([rate] * 3, abs=1e-5)


@pytest.mark.parametrize(
    ("slopes", "turned", "is_slow"),
    [([1, 1.4, 1.4], 0.99, True), ([1, 1.4, 1.4], 1.01, False), ([2, 2.99, 2], 0.1, True), ([2, 3.01, 2], 0.1, False)],
)
def test_a_slow_motion_changes_by_less_than_half_its_rate_and_a_radian_from_row_to_row(slopes, turned, is_slow):
    motion = SimpleNamespace(
        velocities=np.array(slopes, dtype=float)[:, None], coordinates=np.arange(len(slopes))[:, None] * turned
    )
    assert _is_slow(motion) == is_slow
