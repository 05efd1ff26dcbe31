"""Directions of ways: of one length, whatever the ways', and none where a way has none."""

import numpy as np
import pytest

from coursework.drawing.outline.poses import unit_vectors


def test_a_direction_has_length_one_and_a_point_none():
    assert unit_vectors(np.array([3 + 4j, -0.03j, 0, 1e-9])) == pytest.approx([0.6 + 0.8j, -1j, 0, 1])
