"""What brings a position back to the closure: Baumgarte's term, or Newton's corrections with the drive where it has to be."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.integration.integrate import Correction, Row, refuse_gain
from coursework.words.errors import InputError

KEPT = np.array([[10.0], [20.0], [30.0], [40.0]])
KNOWN = np.array([[0.0], [0.1], [0.2], [0.3]])
ROW = Row(1, 0.5, np.array([1.0, 2.0]))


def test_baumgarte_moves_by_step_times_gain_times_the_linear_correction():
    """1 - gain*step is left of an error a step: of 0.1 with 5 1/s and 0.04 s 0.08, so that 0.02 are taken away."""
    asked = []
    closure = SimpleNamespace(linear=lambda t, q, kept: asked.append((t, *q, *kept)) or np.array([-0.1, 0.2]))
    found = Correction(closure, 0, gain=5.0).corrected((KEPT, KNOWN), ROW, 0.04, np.array([1.5, 2.5]))
    assert found == pytest.approx([1.48, 2.54])
    assert asked == [(0.5, 1.0, 2.0, 20.0)]  # where the step began


def test_newton_corrects_as_often_as_is_asked_from_where_the_drive_stands():
    asked = []
    closure = SimpleNamespace(driven=(1,), correction=lambda t, q, kept: asked.append((t, *q, *kept)) or np.array([0.25, 0.0]))
    moved = np.array([1.5, 9.0])
    found = Correction(closure, 2).corrected((KEPT, KNOWN), ROW, 0.25, moved)
    assert found == pytest.approx([2.0, 0.2])
    assert asked == [(0.75, 1.5, 0.2, 30.0), (0.75, 1.75, 0.2, 30.0)]  # all at the end of the step
    assert moved.tolist() == [1.5, 9.0]


@pytest.mark.parametrize(
    ("gain", "is_refused"), [(0.0, True), (-1.0, True), (1e-9, False), (99.9, False), (100.0, True), (101.0, True)]
)
def test_a_gain_that_multiplies_errors_is_refused(gain, is_refused):
    """With 0.02 s: 1 - gain*step is beyond -1 from 100 1/s on."""
    if is_refused:
        with pytest.raises(InputError):
            refuse_gain(gain, 0.02)
    else:
        refuse_gain(gain, 0.02)
