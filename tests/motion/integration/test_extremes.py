"""Where a slope is zero between three samples: the parabola through them, whose roots are known beforehand."""

import numpy as np
import pytest

import coursework
from coursework.motion.integration.turning import _flat


@pytest.mark.parametrize("t", [(0.0, 1.0, 2.0), (-3.0, -2.5, 1.0), (5.0, 7.0, 7.5)])
@pytest.mark.parametrize("size", [1.0, -4.0])
@pytest.mark.parametrize("place", [0.1, 0.4, 0.9])
def test_the_root_nearest_to_the_middle(t, size, place):
    t = np.array(t)
    root = t[0] + place * (t[2] - t[0])
    for other in (t[2] + 10, t[0] - 4):
        assert _flat(t, size * (t - root) * (t - other)) == pytest.approx(root, abs=1e-12)
    assert _flat(t, size * (t - root)) == pytest.approx(root, abs=1e-12)  # a line


def test_a_slope_without_a_root_between_is_flat_in_the_middle():
    t = np.array([0.0, 1.0, 3.0])
    assert _flat(t, (t - 1.5) ** 2 + 1) == 1.0
    assert _flat(t, np.array([2.0, 2.0, 2.0])) == 1.0


def test_a_motion_of_one_row_has_no_interval_to_be_followed_in():
    """With a link of a millimetre variant 31 stops before its second row; its page could not be written."""
    stopped = coursework.load("31").with_data({"r1": 0.000953})
    scene = coursework.solve(stopped, quantities=["table"]).scene
    assert len(scene.exact.t) == 1 and scene.extremes["phi1"] == (1.63, 1.63)
