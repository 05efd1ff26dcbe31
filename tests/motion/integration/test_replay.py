"""Rows made once more: all at once without a correction, one by one with it."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.integration.replay import Replay
from coursework.motion.schemes import SCHEMES

T = np.arange(4) * 0.1
MOTION = SimpleNamespace(t=T, coordinates=np.array([[1.0], [2.0], [4.0], [7.0]]), step=0.1)
# q' = 3 q + t, and a column that is 10 q.
RATES = SimpleNamespace(
    velocities=("w", "v"), table=lambda t, q: (np.column_stack([3 * q[:, 0] + t, 10 * q[:, 0]]), None),
    evaluate=lambda t, q: (3 * q + t, 10 * q, 99.0), slopes_of_rows=lambda later: lambda t, q: 3 * q + t[:, None],
    slopes=lambda later: lambda t, q: 3 * q + t,
)  # fmt: skip


STILL = SimpleNamespace(closure=SimpleNamespace(targets=lambda t: None), corrected=lambda targets, row, step, moved: moved)


@pytest.mark.parametrize("correction", [None, STILL])
def test_each_row_is_one_step_from_the_row_before(correction):
    q = MOTION.coordinates[:, 0]
    moved = np.append(1.5, q[:-1] + 0.1 * (3 * q[:-1] + T[:-1]))
    made = Replay(RATES, SCHEMES["euler"], [1.5], correction)
    assert made.rows(MOTION) == pytest.approx(np.column_stack([moved, 3 * q + T, 10 * q]))
    assert np.array([made.row(MOTION, index) for index in range(4)]) == pytest.approx(made.rows(MOTION))


def test_a_row_is_corrected_as_the_run_corrects_it():
    """The correction adds what the row before and the targets say: row number, and half the target of the row."""
    closure = SimpleNamespace(targets=lambda t: (100 * t, None))
    correction = SimpleNamespace(
        closure=closure, corrected=lambda targets, row, step, moved: moved + 1000 * row.index + targets[0][row.index] + step
    )
    q = MOTION.coordinates[:, 0]
    found = Replay(RATES, SCHEMES["euler"], [1.5], correction).rows(MOTION)[:, 0]
    plain = np.append(1.5, q[:-1] + 0.1 * (3 * q[:-1] + T[:-1]))
    assert found - plain == pytest.approx([0, 0.1, 1010.1, 2020.1])
