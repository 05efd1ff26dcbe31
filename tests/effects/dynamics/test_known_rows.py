"""Where a motion under forces stops being known: an arm of two links that falls for long forgets its start."""

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics.free_motion import FreeMotion
from coursework.effects.dynamics.known_rows import LOST, known_rows


def test_a_motion_that_forgets_its_start_is_told_as_far_as_it_is_known():
    """By SciPy's DOP853 two arms 1e-13 rad apart are 2e-6 of the range apart at 12 s, 1e-3 at 20 s and 5 % at 22 s."""
    run = coursework.solve("falling-arm", "exact", end=22, step=0.5, quantities=["table"])
    assert run.stop.kind == "sensitive" and 12 < run.stop.time < 20
    assert 10 < run.motion.t[-1] < run.stop.time and "round-off decides" in run.stop.sentence
    assert coursework.solve("falling-arm", "exact", end=8, step=0.5, quantities=["table"]).stop is None


@pytest.mark.parametrize("size", [1.0, 1e-9, 1e6])
@pytest.mark.parametrize(("gap", "rows"), [(0.99 * LOST, 9), (1.01 * LOST, 5)])
def test_rows_are_known_up_to_the_last_that_agrees(gap, rows, size):
    """Every second of nine rows is looked at; the fourth of these is off by a part of the range of 8."""
    q, still = size * np.arange(9.0)[:, None], np.zeros((9, 1))
    other = q[::2].copy()
    other[3] += gap * 8 * size
    found = FreeMotion(np.arange(9) * 0.1, q, still, 8)
    known = known_rows(found, FreeMotion(np.arange(5) * 0.2, other, still[::2], 4), 2, [size, size])
    assert (len(known.t), len(known.coordinates), len(known.rates)) == (rows, rows, rows)
    assert (known.ended, known.at) == (("", 0.0) if rows == 9 else ("sensitive", pytest.approx(0.6)))
