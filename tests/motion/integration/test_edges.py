"""Where a refined motion is cut between two rows: at the edges of short stretches, but never within a jump of another cut."""

import numpy as np
import pytest

from coursework.motion.integration.exact_motion import _quick


@pytest.mark.parametrize(
    ("cells", "cut"),
    [
        ([0.2, 0.5], [0.2, 0.5]), ([0.2], []), ([], []), ([0.0, 0.2, 0.5, 1.5], [0.2, 0.5]), ([-0.5, 0.2, 1.5], []),
        ([1.1e-9, 0.5], [1.1e-9, 0.5]), ([0.9e-9, 0.5], [0.5]), ([0.5, 0.5 + 0.9e-9], [0.5]),
        ([0.5, 1 - 1.1e-9], [0.5, 1 - 1.1e-9]), ([0.5, 1 - 0.9e-9], [0.5]), ([0.5, 1.0], [0.5]),
    ],
)  # fmt: skip
def test_stretches_shorter_than_the_interval_cut_it(cells, cut):
    assert _quick(np.array(cells, dtype=float), 0.0, 1.0) == cut
