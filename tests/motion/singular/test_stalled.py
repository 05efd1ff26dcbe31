"""Where a stalled flow was going: the zero of D = a + b (t + 2 q - 1)^n is at t + 2 q = 1, for n = 1 and 2, along q' = 1/2."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.singular.stalled import ahead

BEGUN = np.array([0.0, 0.4])


def flow(order, least=0.0, speed=0.5):
    return SimpleNamespace(
        scaled=lambda t, q: [9.0, least - 0.03 * (t + 2 * q[0] - 1) ** order], part=lambda t, q,
        block: (None, None, np.array([speed])),
        slopes=lambda t, q, block: [-2.0 * block, -4.0 * block], units=np.ones(1),
    )  # fmt: skip


@pytest.mark.parametrize(("within", "found"), [(None, (0.15, 0.7)), (0.1501, (0.15, 0.7)), (0.1499, (0.0, 0.4))])
@pytest.mark.parametrize("order", [1, 2])
def test_a_simple_and_a_double_zero_are_found_where_the_block_may_move_that_far(order, within, found):
    assert ahead(flow(order), BEGUN, 1, 0.1, within=within) == pytest.approx(found, abs=1e-9)


def test_a_block_whose_velocities_have_no_bound_rests_on_the_way():
    assert ahead(flow(1, speed=0.0), BEGUN, 1, 0.1) == pytest.approx((0.0, 1.0), abs=1e-9)


def test_what_comes_no_nearer_to_zero_stays_where_it_is():
    """At its least, one, the determinant grows to both sides: no step of Newton's method makes it smaller."""
    assert ahead(flow(2, least=-1.0), np.array([0.3, 0.4]), 1, 0.1).tolist() == [0.3, 0.4]
    assert ahead(flow(0, least=1.0), BEGUN, 1, 0.1).tolist() == BEGUN.tolist()
