"""A step over which several determinants change their signs is taken again in parts, one by one."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.singular.walk import Walk


@pytest.mark.parametrize(("at_once", "lengths"), [(False, [0.8, 0.2, 0.3]), (True, [0.8])])
def test_a_step_over_several_signs_is_taken_again_shorter(at_once, lengths):
    """A step of 0.8 s comes behind 0.5 s, where both are below zero; a quarter of it does not."""
    made, arrived = [], []
    walk = SimpleNamespace(
        end=1.0, taken=0, scaled=[0.5, 0.7], length=0.8, near=0.0, state=np.zeros(2), way=[np.zeros(2)],
        flow=SimpleNamespace(clock=lambda *_: "clock", units=np.ones(1)), _inside=lambda *_: (None, 0.0),
        _at_rest=lambda block: None,
        _at_once=lambda crossed, block, after: at_once, _arrive=lambda clock, part, goal: arrived.append((part, goal)),
        _determinants=lambda state: [0.5, 0.7] if state[-1] <= 0.5 else [-0.1, -0.2],
    )  # fmt: skip

    def step(clock):
        made.append(walk.length)
        return np.array([0.0, walk.state[-1] + walk.length]), walk.length, 0.3

    walk._step = step
    assert Walk._until(walk, 0.4) is None
    assert made == pytest.approx(lengths) and arrived == [(pytest.approx(lengths[-1]), 0.4)] and walk.taken == len(lengths)


@pytest.mark.parametrize(("crossed", "block", "after", "is_one"), [
    ([0], 0, [-0.1, 0.2], True), ([1], 0, [0.1, -0.2], False), ([0, 1], 0, [-0.1, -0.2], False),
    ([0, 1], 0, [-4e-10, -4e-10], True), ([0, 1], 0, [-4e-10, -6e-10], False), ([1, 2], 0, [1.0, -1e-12, -1e-12], False),
])  # fmt: skip
def test_several_that_are_nought_together_are_one(crossed, block, after, is_one):
    """Before the step each was 5e-10."""
    walk = SimpleNamespace(scaled=[5e-10] * 3)
    assert Walk._at_once(walk, crossed, block, after) is is_one
