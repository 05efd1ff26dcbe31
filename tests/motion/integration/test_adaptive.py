"""The next step of a pair: shorter by the root of its order, 0.85 of that to be safe, never much shorter or longer."""

import math
from contextlib import nullcontext
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.integration import exact_motion
from coursework.motion.integration.adaptive import integrate_adaptive, next_length
from coursework.motion.integration.exact_motion import OutOfReach


@pytest.mark.parametrize(
    ("ratio", "order", "part"),
    [
        (1.0, 5, 0.85), (32.0, 5, 0.425), (1 / 32, 5, 1.7), (256.0, 8, 0.425), (256.0, 4, 0.2125), (257**4, 4, 0.2),
        (0.85**4 / 3.9**4, 4, 3.9), (0.85**4 / 4.1**4, 4, 4.0), (0.85**4 / 0.21**4, 4, 0.21), (0.85**4 / 0.19**4, 4, 0.2),
        (0.0, 5, 4.0),
    ],
)  # fmt: skip
def test_the_next_step(ratio, order, part):
    assert next_length(3.0, ratio, order) == pytest.approx(3.0 * part, rel=1e-12)
    assert next_length(3.0, ratio) == next_length(3.0, ratio, 5)


def test_each_component_is_as_accurate_as_asked_for():
    """One that never errs does not hide another: x = t, y = sin(60 t), both at times that no step would choose."""
    times = np.array([0.0, 0.1234, 0.5, 1.0])
    found, _ = integrate_adaptive(lambda t, *q: [1.0, 60 * math.cos(60 * t), 9.0], np.zeros(2), times, 1e-10)
    assert found == pytest.approx(np.column_stack([times, np.sin(60 * times)]), abs=1e-8)


@pytest.mark.parametrize("unit", [1.0, 1e-6, 1e6])
@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "lost"), [(0.98e-6, False), (1.02e-6, True)])
def test_a_motion_is_lost_with_a_gap_of_a_millionth_of_a_radian_or_of_its_largest_position(size, part, lost, unit, monkeypatch):
    """Positions are as large beside the `unit` in every world."""
    gap = part * max(size, 1.0)
    monkeypatch.setattr(exact_motion, "refine", lambda *_, **__: (np.array([[-size * unit], [0.0]]), gap, 3))
    rates = SimpleNamespace(sizes=np.array([unit]), motion=lambda *_, **__: "followed")
    with pytest.raises(OutOfReach) if lost else nullcontext():
        assert exact_motion.exact_motion(rates, None, [0.0], np.arange(2.0)) == "followed"


def test_a_state_without_bound_ends_instead_of_being_followed_for_ever():
    """x' = x^2 from 1 is 1/(1 - t): it is known until just before t = 1."""
    assert integrate_adaptive(lambda t, x: [x * x], np.ones(1), np.array([0.0, 0.99]), 1e-9)[0][-1] == pytest.approx(
        100, rel=1e-5
    )
    with pytest.raises(ArithmeticError):
        integrate_adaptive(lambda t, x: [x * x], np.ones(1), np.array([0.0, 1.01]), 1e-9)
