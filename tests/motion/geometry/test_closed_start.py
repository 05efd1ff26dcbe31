"""The nearest closed position of a start: Newton's, unless that runs more than a radian or a metre away."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.geometry import closed_start as module
from coursework.motion.geometry.closure import Closure


@pytest.mark.parametrize(("far", "found"), [(0.99, 0.99), (-1.01, 0.5), (1.01, 0.5), (None, 0.5)])
def test_a_root_that_is_far_away_is_sought_downhill(monkeypatch, far, found):
    guesses = {0.0: far, 0.25: 0.5}
    closure = SimpleNamespace(
        start=np.zeros(1), origin=None, residual=lambda *_: (np.zeros(1), None),
        newton=lambda t, q, origin: None if guesses[q[0]] is None else np.array([guesses[q[0]]]),
    )  # fmt: skip
    monkeypatch.setattr(module, "_downhill", lambda _: np.array([0.25]))
    monkeypatch.setattr(module, "_without_turns", lambda _, q: q)
    assert module.closed_start(closure)[1].tolist() == [found]


@pytest.mark.parametrize(("lengths", "scale"), [((), 1.0), ((0.0,), 1.0), ((-2.0, 0.5), 2.0), ((0.3,), 0.3)])
def test_a_residual_is_measured_against_the_largest_length_of_the_data(lengths, scale):
    given = [SimpleNamespace(value=9.0, si="rad/s"), *(SimpleNamespace(value=value, si="m") for value in lengths)]
    closure = SimpleNamespace(equations=SimpleNamespace(variant=SimpleNamespace(given=given)))
    assert Closure.scale.fget(closure) == scale
