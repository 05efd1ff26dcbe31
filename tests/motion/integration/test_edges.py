"""Where a refined motion is cut between two rows: at edges of short stretches, no two within a jump; how far it is off."""

import numpy as np
import pytest

from coursework.motion.integration.exact_motion import Growth, OutOfReach, _halved, quick_times


@pytest.mark.parametrize(
    ("cells", "cut"),
    [
        ([0.2, 0.5], [0.2, 0.5]), ([0.2], []), ([], []), ([0.0, 0.2, 0.5, 1.5], [0.2, 0.5]), ([-0.5, 0.2, 1.5], []),
        ([1.1e-9, 0.5], [1.1e-9, 0.5]), ([0.9e-9, 0.5], [0.5]), ([0.5, 0.5 + 0.9e-9], [0.5]),
        ([0.5, 1 - 1.1e-9], [0.5, 1 - 1.1e-9]), ([0.5, 1 - 0.9e-9], [0.5]), ([0.5, 1.0], [0.5]),
    ],
)  # fmt: skip
def test_stretches_shorter_than_the_interval_cut_it(cells, cut):
    assert quick_times(np.array(cells, dtype=float), 0.0, 1.0) == cut


@pytest.mark.parametrize(("factor", "off"), [(2.0, 7.0), (-2.0, 7.0), (0.5, 2.5), (0.0, 4.0), (np.nan, 4.0), (np.inf, 4.0)])
def test_what_is_off_grows_as_a_way_beside_does_and_stays_where_that_ends(factor, off):
    """3 were off, 1 is left in the interval; the way beside stays as small as it was."""
    growth = Growth(np.array([0.0, 1e-6]), 3.0)
    with np.errstate(all="ignore"):
        growth.go_on(lambda position: 5.0 + factor * (position - 4.0), np.full(2, 4.0), np.full(2, 5.0), 1.0)
    assert growth.off == pytest.approx(off, rel=1e-9)
    assert np.max(np.abs(growth.beside)) == pytest.approx(1e-6)


@pytest.mark.parametrize("left", [48, 49, 1000])
def test_an_interval_is_halved_until_it_agrees_while_steps_are_left(left):
    """With 4 and 8 steps a quarter agrees and a half does not: 7 intervals of 12 steps, the last halved after 48 of them."""

    def loop(begin, parts, step, q):
        return (q + parts * (parts * step > 0.3),)

    if left > 48:
        assert _halved(loop, 0.0, 1.0, [2.0], [1.0], 4, left, None) == ([2.0], 0.0, 84)
    else:
        with pytest.raises(OutOfReach):
            _halved(loop, 0.0, 1.0, [2.0], [1.0], 4, left, None)
