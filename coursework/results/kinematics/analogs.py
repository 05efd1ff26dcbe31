"""Velocity and acceleration analogs: derivatives by the crank angle, and the way back to seconds.

Enters: velocities and accelerations with the crank's omega_1, epsilon_1, or a `GroupMotion`.
Leaves: the same in analogs, or back.  Used by `invariants.py`, `extra.py` and, through `procedures.py`, by students.

A group computed with crank rate 1 and angular acceleration 0 *is* in analogs, because then time and crank
angle are the same number.  Every motion that drives the group must come from that crank.
Source: [library], analogs; its A = q'' omega_1^2 is completed by q' epsilon_1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups.pairs import GroupMotion, Pair
from coursework.system.arrays import Array

Level: TypeAlias = Callable[[Array, Array], tuple[Array, Array]]


def true_velocity(first: ArrayLike, omega_1: ArrayLike) -> Array:
    """Return q' omega_1, per second; `first` q' (n,) or (n, k), `omega_1` (rad/s) a number or (n,).

    >>> from coursework.procedures import true_velocity
    >>> true_velocity([0.1, 0.2], omega_1=10.0).tolist()
    [1.0, 2.0]
    """
    analog = np.asarray(first, dtype=np.float64)
    return analog * _beside(omega_1, analog)


def true_acceleration(first: ArrayLike, second: ArrayLike, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0) -> Array:
    """Return q'' omega_1^2 + q' epsilon_1, per second squared.

    `first`, `second` the analogs q', q'' (n,) or (n, k); `omega_1` (rad/s) and `epsilon_1` (rad/s^2) of the
    crank, a number or (n,).  Without the last term the formula of [library] holds for a constant omega_1
    only.

    >>> from coursework.procedures import true_acceleration
    >>> true_acceleration([0.1, 0.2], [0.0, 0.5], omega_1=10.0, epsilon_1=5.0).tolist()
    [0.5, 51.0]
    """
    one, two = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    omega = _beside(omega_1, two)
    return two * omega * omega + one * _beside(epsilon_1, one)


def velocity_analog(velocity: ArrayLike, omega_1: ArrayLike) -> Array:
    """Return q' = velocity / omega_1, shaped as `velocity` (n,) or (n, k); `omega_1` (rad/s) a number or (n,).

    Raises `ValueError` where the crank stands still.

    >>> from coursework.procedures import velocity_analog
    >>> velocity_analog([1.0, 2.0], omega_1=10.0).tolist()
    [0.1, 0.2]
    """
    true = np.asarray(velocity, dtype=np.float64)
    return true / _turning(omega_1, true)


def acceleration_analog(velocity: ArrayLike, acceleration: ArrayLike, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0) -> Array:
    """Return q'' = (acceleration - q' epsilon_1)/omega_1^2, shaped as `acceleration` (n,) or (n, k).

    `omega_1` (rad/s) and `epsilon_1` (rad/s^2) a number or (n,).  Raises `ValueError` where the crank stands still.

    >>> from coursework.procedures import acceleration_analog
    >>> acceleration_analog([1.0, 2.0], [0.5, 51.0], omega_1=10.0, epsilon_1=5.0).tolist()
    [0.0, 0.5]
    """
    true = np.asarray(acceleration, dtype=np.float64)
    omega = _turning(omega_1, true)
    return (true - velocity_analog(velocity, omega_1) * _beside(epsilon_1, true)) / (omega * omega)


def in_seconds(analogs: GroupMotion, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0) -> GroupMotion:
    """Return the true motion of a group computed in analogs, the point it meets included.

    `omega_1` (rad/s), `epsilon_1` (rad/s^2) of the crank, a number or one a row.
    Raises `ValueError` when only positions were computed.

    >>> from coursework.procedures import Pair, in_seconds
    >>> from coursework.mechanism.groups import crank
    >>> turned = crank(Pair([0.0, 0.0]), length=0.1, angle=[0.0, 1.0], rate=1.0)
    >>> in_seconds(turned, omega_1=[5.0, 10.0]).meets.velocity.round(3).tolist()
    [[0.0, 0.5], [-0.841, 0.54]]
    """
    return _translated(
        analogs,
        lambda one, two: (true_velocity(one, omega_1), true_acceleration(one, two, omega_1, epsilon_1)),
    )


def in_analogs(motion: GroupMotion, omega_1: ArrayLike, epsilon_1: ArrayLike = 0.0) -> GroupMotion:
    """Return the analogs of a group's true motion, the point it meets included.

    Raises `ValueError` where the crank stands still, and when only positions were computed.

    >>> from coursework.procedures import Pair, in_analogs
    >>> from coursework.mechanism.groups import crank
    >>> turned = crank(Pair([0.0, 0.0]), length=0.1, angle=[0.0, 1.0], rate=[5.0, 10.0])
    >>> in_analogs(turned, omega_1=[5.0, 10.0]).rates.tolist()
    [[1.0], [1.0]]
    """
    return _translated(
        motion,
        lambda one, two: (velocity_analog(one, omega_1), acceleration_analog(one, two, omega_1, epsilon_1)),
    )


def _translated(motion: GroupMotion, level: Level) -> GroupMotion:
    point = motion.meets
    if motion.rates is None or motion.accelerations is None or point.velocity is None or point.acceleration is None:
        raise ValueError("analogs: the motion holds positions only; compute it without positions_only=True.")
    rates, accelerations = level(motion.rates, motion.accelerations)
    meets = Pair(point.position, *level(point.velocity, point.acceleration))
    return replace(motion, rates=_kept(rates), accelerations=_kept(accelerations), meets=meets)


def _kept(rows: Array) -> Array:
    rows.flags.writeable = False
    return rows


def _beside(crank: ArrayLike, rows: Array) -> Array:
    """Return the crank's values in a shape that matches them with the rows of `rows`."""
    given = np.asarray(crank, dtype=np.float64)
    return given[:, None] if given.ndim == 1 and rows.ndim == 2 else given


def _turning(omega_1: ArrayLike, rows: Array) -> Array:
    omega = np.atleast_1d(np.asarray(omega_1, dtype=np.float64))
    if not omega.all():
        place = f" at row {int(np.argmin(omega != 0.0))}" if len(omega) > 1 else ""
        raise ValueError(f"analogs: omega_1 is 0{place}; a standing crank has velocities, but no analogs follow.")
    return _beside(omega_1, rows)
