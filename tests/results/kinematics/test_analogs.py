"""Analogs of a group: the way there, the way back, and the crank with an angular acceleration."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from coursework.mechanism.groups import GroupMotion, Pair, crank, rrr
from coursework.results.kinematics.analogs import (
    acceleration_analog,
    in_analogs,
    in_seconds,
    true_acceleration,
    true_velocity,
    velocity_analog,
)

Array = NDArray[np.float64]
PHI = np.linspace(0.0, 2 * np.pi, 25)
OMEGA = st.floats(0.1, 50.0) | st.floats(-50.0, -0.1)
EPSILON = st.floats(-100.0, 100.0)


def fourbar(omega: Array | float, epsilon: Array | float) -> GroupMotion:
    pin = crank(Pair((0.0, 0.0)), length=0.4, angle=PHI, rate=omega, acceleration=epsilon).meets
    return rrr(pin, Pair((1.2, 0.0)), lengths=(1.0, 0.7), mode=1)


def assert_same(found: GroupMotion, wanted: GroupMotion, slack: float = 1e-13) -> None:
    pairs = [
        (found.rates, wanted.rates),
        (found.accelerations, wanted.accelerations),
        (found.meets.position, wanted.meets.position),
        (found.meets.velocity, wanted.meets.velocity),
        (found.meets.acceleration, wanted.meets.acceleration),
    ]
    for one, two in pairs:
        assert one is not None
        assert two is not None
        assert np.abs(one - two).max() <= slack * np.abs(two).max()
        assert not one.flags.writeable


@settings(max_examples=40, deadline=None)
@given(OMEGA, EPSILON)
def test_analogs_give_the_true_motion_and_back(omega: float, epsilon: float) -> None:
    analogs, true = fourbar(1.0, 0.0), fourbar(omega, epsilon)
    assert_same(in_seconds(analogs, omega, epsilon), true)
    # a slow crank with a large epsilon_1: accelerations then consist of the term that is taken off again
    assert_same(in_analogs(true, omega, epsilon), analogs, 1e-13 * (1.0 + abs(epsilon) / omega**2))


def test_a_crank_that_speeds_up_row_by_row() -> None:
    omega, epsilon = np.linspace(1.0, 9.0, len(PHI)), np.linspace(-3.0, 7.0, len(PHI))
    assert_same(in_seconds(fourbar(1.0, 0.0), omega, epsilon), fourbar(omega, epsilon))


def test_the_formula_for_constant_omega_is_wrong_when_the_crank_speeds_up() -> None:
    analogs, true = fourbar(1.0, 0.0), fourbar(10.0, 40.0)
    assert analogs.accelerations is not None
    assert true.accelerations is not None
    short = analogs.accelerations * 10.0**2  # the formula of [library], without q' epsilon_1
    assert np.abs(short - true.accelerations).max() > 10.0


def test_single_columns() -> None:
    first, second = np.array([0.5, -2.0]), np.array([3.0, 0.0])
    assert true_velocity(first, [2.0, 3.0]) == pytest.approx([1.0, -6.0])
    assert true_acceleration(first, second, 2.0, 1.0) == pytest.approx([12.5, -2.0])
    assert velocity_analog([1.0, -6.0], [2.0, 3.0]) == pytest.approx(first)
    assert acceleration_analog([1.0, -4.0], [12.5, -2.0], 2.0, 1.0) == pytest.approx(second)


def test_a_standing_crank_has_no_analogs() -> None:
    with pytest.raises(ValueError, match=r"^analogs: omega_1 is 0 at row 1; a standing crank has velocities, but no"):
        velocity_analog([1.0, 2.0], [3.0, 0.0])
    with pytest.raises(ValueError, match=r"^analogs: omega_1 is 0; "):
        in_analogs(fourbar(0.0, 1.0), 0.0, 1.0)


def test_positions_alone_have_no_analogs() -> None:
    pin = crank(Pair((0.0, 0.0)), length=0.4, angle=PHI, rate=1.0).meets
    positions = rrr(pin, Pair((1.2, 0.0)), lengths=(1.0, 0.7), mode=1, positions_only=True)
    with pytest.raises(ValueError, match=r"^analogs: the motion holds positions only; compute it without"):
        in_seconds(positions, 10.0)


def test_a_crank_at_a_steady_speed_needs_no_acceleration_said():
    """Of a crank of 0.1 m at 5 rad/s the pin has 0.1*25 m/s² towards the pivot; its analog is 0.1 m."""
    turned = crank(Pair([0.0, 0.0]), length=0.1, angle=[0.0], rate=1.0)
    moved = in_seconds(turned, omega_1=5.0)
    assert moved.meets.acceleration.tolist() == [[-2.5, 0.0]] and moved.accelerations.tolist() == [[0.0]]
    back = in_analogs(moved, omega_1=5.0)
    assert back.meets.acceleration.tolist() == [[-0.1, 0.0]] and back.accelerations.tolist() == [[0.0]]
    assert true_acceleration(0.3, 0.2, 5.0) == 5.0 and acceleration_analog(1.5, 5.0, 5.0) == 0.2
    assert true_acceleration(0.3, 0.2, 5.0, 2.0) == 5.6 and acceleration_analog(1.5, 5.6, 5.0, 2.0) == pytest.approx(0.2)
