"""Random groups whose pairs and guides all move: finite differences of the closed positions confirm the rest.

A group is built from the inside out, from its unknowns to its pairs, so it closes at t = 0 in a known mode, at a known
distance from its dead point.  The matrices here are written down from the textbook, not taken from the package.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from coursework.mechanism.groups import GroupMotion, Guide, Pair, crank, prp, rpp, rpr, rrp, rrr

Array = NDArray[np.float64]
Draw = Callable[[st.SearchStrategy[float]], float]
EPS = float(np.finfo(float).eps)

UNIT = st.floats(-1.0, 1.0, allow_subnormal=False)
ANGLE = st.floats(-3.0, 3.0, allow_subnormal=False)
LENGTH = st.floats(0.5, 1.5)
FAR = st.floats(0.15, 1.0) | st.floats(-3.0, -0.9).map(lambda exponent: 10.0**exponent)
SIGN = st.sampled_from([-1.0, 1.0])


def e(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle)])


def n(angle: float) -> Array:
    return np.array([-np.sin(angle), np.cos(angle)])


@dataclass(frozen=True)
class Way:
    """A quantity, number or vector, with constant second derivative."""

    value: Array
    rate: Array
    second: Array

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        t = t[:, None] if np.ndim(self.value) else t
        steady = np.ones_like(t)
        return (
            self.value + self.rate * t + self.second * t * t / 2,
            self.rate + self.second * t,
            self.second * steady,
        )

    def pair(self, t: Array) -> Pair:
        return Pair(*self.at(t))


@dataclass(frozen=True)
class Rail:
    """A guide that travels and turns."""

    through: Way
    angle: Way
    offset: float

    def guide(self, t: Array) -> Guide:
        return Guide(self.through.pair(t), *self.angle.at(t), offset=self.offset)


@dataclass(frozen=True)
class Scene:
    """A group, what it should be at t = 0, and its textbook equations there.

    `matrix` a; `right` gives the two right sides from coordinates and rates; `far` how far from the dead point.
    """

    solve: Callable[[Array], GroupMotion]
    expected: tuple[float, float]
    angles: tuple[bool, bool]
    matrix: Array
    right: Callable[[Array], tuple[Array, Array]]
    far: float


def moving(draw: Draw, value: Array) -> Way:
    return Way(value, np.array([draw(UNIT), draw(UNIT)]), np.array([draw(UNIT), draw(UNIT)]))


def changing(draw: Draw, value: float) -> Way:
    return Way(np.float64(value), np.float64(draw(UNIT)), np.float64(draw(UNIT)))  # type: ignore[arg-type]


@st.composite
def rrr_scenes(draw: Draw) -> Scene:
    far, r_i, r_j = draw(FAR), changing(draw, draw(LENGTH)), changing(draw, draw(LENGTH) * 1.7)
    t_i = draw(ANGLE)
    t_j = t_i + draw(SIGN) * np.arcsin(far) + (np.pi if draw(SIGN) > 0 else 0.0)
    b = moving(draw, np.array([draw(UNIT), draw(UNIT)]))
    d = moving(draw, b.value + r_i.value * e(t_i) - r_j.value * e(t_j))
    mode = -int(np.sign(np.sin(t_i - t_j)))
    ri, rj = r_i.value, r_j.value

    def solve(t: Array) -> GroupMotion:
        return rrr(b.pair(t), d.pair(t), lengths=(r_i.at(t), r_j.at(t)), mode=mode)

    def right(rates: Array) -> tuple[Array, Array]:
        w_i, w_j = rates
        first = d.rate - b.rate + r_j.rate * e(t_j) - r_i.rate * e(t_i)
        second = ri * w_i**2 * e(t_i) - rj * w_j**2 * e(t_j) + d.second - b.second
        second = second + r_j.second * e(t_j) + 2 * r_j.rate * w_j * n(t_j)
        return first, second - r_i.second * e(t_i) - 2 * r_i.rate * w_i * n(t_i)

    matrix = np.array([[-ri * np.sin(t_i), rj * np.sin(t_j)], [ri * np.cos(t_i), -rj * np.cos(t_j)]])
    return Scene(solve, (t_i, t_j), (True, True), matrix, right, far)


@st.composite
def rrp_scenes(draw: Draw) -> Scene:
    far, rod = draw(FAR), changing(draw, draw(LENGTH))
    t_j, s, h = changing(draw, draw(ANGLE)), draw(UNIT), draw(UNIT) / 3
    tj = float(t_j.value)
    t_i = tj + draw(SIGN) * np.arccos(far) + (np.pi if draw(SIGN) > 0 else 0.0)
    b = moving(draw, np.array([draw(UNIT), draw(UNIT)]))
    rail = Rail(moving(draw, b.value + rod.value * e(t_i) - s * e(tj) - h * n(tj)), t_j, h)
    mode = int(np.sign(np.cos(t_i - tj)))
    r, k = rod.value, rail.through

    def solve(t: Array) -> GroupMotion:
        return rrp(b.pair(t), rail.guide(t), length=rod.at(t), mode=mode)

    def right(rates: Array) -> tuple[Array, Array]:
        w_i, ds = rates
        w, al = t_j.rate, t_j.second
        across = s * n(tj) - h * e(tj)
        first = k.rate - b.rate + w * across - rod.rate * e(t_i)
        second = r * w_i**2 * e(t_i) + k.second - b.second + al * across
        second = second + 2 * ds * w * n(tj) - w**2 * (s * e(tj) + h * n(tj))
        return first, second - rod.second * e(t_i) - 2 * rod.rate * w_i * n(t_i)

    matrix = np.array([[-r * np.sin(t_i), -np.cos(tj)], [r * np.cos(t_i), -np.sin(tj)]])
    return Scene(solve, (t_i, s), (True, False), matrix, right, far)


@st.composite
def rpr_scenes(draw: Draw) -> Scene:
    far, e0 = draw(FAR), draw(SIGN) * draw(LENGTH) / 2
    s, theta, end = draw(SIGN) * far, draw(ANGLE), draw(LENGTH)
    d = moving(draw, np.array([draw(UNIT), draw(UNIT)]))
    b = moving(draw, d.value + s * e(theta) + e0 * n(theta))

    def solve(t: Array) -> GroupMotion:
        return rpr(b.pair(t), d.pair(t), offset=e0, end_length=end, mode=int(np.sign(s)))

    def right(rates: Array) -> tuple[Array, Array]:
        w, ds = rates
        second = b.second - d.second - 2 * ds * w * n(theta) + w**2 * (s * e(theta) + e0 * n(theta))
        return b.rate - d.rate, second

    matrix = np.array(
        [
            [-s * np.sin(theta) - e0 * np.cos(theta), np.cos(theta)],
            [s * np.cos(theta) - e0 * np.sin(theta), np.sin(theta)],
        ]
    )
    return Scene(solve, (theta, s), (True, False), matrix, right, far)


@st.composite
def rpp_scenes(draw: Draw) -> Scene:
    far, t_j, h = draw(FAR), changing(draw, draw(ANGLE)), draw(UNIT) / 3
    tj, s_i, s_j = float(t_j.value), draw(UNIT), draw(UNIT)
    t_i = draw(SIGN) * np.arcsin(far) + (np.pi if draw(SIGN) > 0 else 0.0)
    rail = Rail(moving(draw, np.array([draw(UNIT), draw(UNIT)])), t_j, h)
    b = moving(draw, rail.through.value + h * n(tj) + s_j * e(tj) + s_i * e(t_i + tj))
    k = rail.through

    def solve(t: Array) -> GroupMotion:
        return rpp(b.pair(t), rail.guide(t), slide_angle=t_i)

    def right(rates: Array) -> tuple[Array, Array]:
        ds_i, ds_j = rates
        w, al = t_j.rate, t_j.second
        across = s_i * n(t_i + tj) + s_j * n(tj) - h * e(tj)
        along = s_i * e(t_i + tj) + s_j * e(tj) + h * n(tj)
        second = b.second - k.second - 2 * w * (ds_i * n(t_i + tj) + ds_j * n(tj))
        return b.rate - k.rate - w * across, second - al * across + w**2 * along

    matrix = np.array([[np.cos(t_i + tj), np.cos(tj)], [np.sin(t_i + tj), np.sin(tj)]])
    return Scene(solve, (s_i, s_j), (False, False), matrix, right, far)


@st.composite
def prp_scenes(draw: Draw) -> Scene:
    far, t_i, r_i, r_j = draw(FAR), changing(draw, draw(ANGLE)), draw(UNIT) / 3, draw(UNIT) / 3
    ti = float(t_i.value)
    tj = ti + draw(SIGN) * np.arcsin(far) + (np.pi if draw(SIGN) > 0 else 0.0)
    t_j, s_i, s_j = changing(draw, tj), draw(UNIT), draw(UNIT)
    k_i = moving(draw, np.array([draw(UNIT), draw(UNIT)]))
    k_j = moving(draw, k_i.value + s_i * e(ti) + r_i * n(ti) - s_j * e(tj) - r_j * n(tj))
    first_rail, second_rail = Rail(k_i, t_i, r_i), Rail(k_j, t_j, r_j)

    def solve(t: Array) -> GroupMotion:
        return prp(first_rail.guide(t), second_rail.guide(t))

    def right(rates: Array) -> tuple[Array, Array]:
        ds_i, ds_j = rates
        first = k_j.rate - k_i.rate + (s_j * n(tj) - r_j * e(tj)) * t_j.rate
        first = first - (s_i * n(ti) - r_i * e(ti)) * t_i.rate
        b1 = -(n(ti) * (2 * ds_i * t_i.rate + s_i * t_i.second) - n(tj) * (2 * ds_j * t_j.rate + s_j * t_j.second))
        b2 = e(ti) * s_i * t_i.rate**2 - e(tj) * s_j * t_j.rate**2
        b3 = e(ti) * r_i * t_i.second - e(tj) * r_j * t_j.second
        b4 = n(ti) * r_i * t_i.rate**2 - n(tj) * r_j * t_j.rate**2
        return first, b1 + b2 + b3 + b4 + k_j.second - k_i.second

    matrix = np.array([[np.cos(ti), -np.cos(tj)], [np.sin(ti), -np.sin(tj)]])
    return Scene(solve, (s_i, s_j), (False, False), matrix, right, far)


SCENES = {
    "RRR": rrr_scenes(),
    "RRP": rrp_scenes(),
    "RPR": rpr_scenes(),
    "RPP": rpp_scenes(),
    "PRP": prp_scenes(),
}


def turned(difference: Array, angle: bool) -> Array:
    """Return the difference of two coordinates; of angles modulo one turn."""
    return np.asarray(np.angle(np.exp(1j * difference)) if angle else difference)


@pytest.mark.parametrize("group", SCENES)
@settings(max_examples=125, deadline=None)
@given(data=st.data())
def test_the_textbook_equations_hold(group: str, data: st.DataObject) -> None:
    scene = data.draw(SCENES[group])
    solved = scene.solve(np.zeros(1))
    assert solved.rates is not None
    assert solved.accelerations is not None
    for place in range(2):
        off = turned(solved.coordinates[0, place] - scene.expected[place], scene.angles[place])
        assert abs(off) <= 100 * EPS / scene.far  # the closer to the dead point, the fewer digits are in the data

    determinant = np.linalg.det(scene.matrix)
    assert solved.determinant[0] == pytest.approx(determinant, rel=1e-3, abs=100 * EPS / scene.far)
    assert abs(solved.scaled_determinant[0]) <= 1.0 + 4 * EPS
    first, second = scene.right(solved.rates[0])
    slack = 1e-13 / scene.far  # angles lose as many digits as the determinant is small
    for found, wanted in ((solved.rates[0], first), (solved.accelerations[0], second)):
        residual = scene.matrix @ found - wanted
        assert np.abs(residual).max() <= slack * (1.0 + np.abs(found).max() + (solved.rates[0] ** 2).max())


@pytest.mark.parametrize("group", SCENES)
@settings(max_examples=125, deadline=None)
@given(data=st.data())
def test_finite_differences_of_positions(group: str, data: st.DataObject) -> None:
    scene = data.draw(SCENES[group])
    h = 1e-3 * scene.far**2  # a dead point is reached within a time of the order far^2
    solved = scene.solve(h * np.arange(-2.0, 3.0))
    assert solved.rates is not None
    assert solved.accelerations is not None
    assert solved.meets.velocity is not None
    assert solved.meets.acceleration is not None
    followed = [
        (
            turned(solved.coordinates[:, i] - solved.coordinates[2, i], scene.angles[i]),
            solved.rates[2, i],
            solved.accelerations[2, i],
        )
        for i in range(2)
    ] + [(solved.meets.position[:, i], solved.meets.velocity[2, i], solved.meets.acceleration[2, i]) for i in range(2)]
    rounding = 100 * EPS / scene.far
    for position, rate, acceleration in followed:
        first = position @ np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / (12 * h)
        second = position @ np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / (12 * h * h)
        assert abs(first - rate) <= rounding / h + 1e-6 / scene.far
        assert abs(second - acceleration) <= rounding / h**2 + 1e-5 / scene.far**3


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_a_crank_on_a_moving_pivot(data: st.DataObject) -> None:
    draw: Draw = data.draw
    pivot = moving(draw, np.array([draw(UNIT), draw(UNIT)]))
    angle, radius = changing(draw, draw(ANGLE)), changing(draw, draw(LENGTH))
    h = 1e-3
    t = h * np.arange(-2.0, 3.0)
    f, w, al = angle.at(t)
    pin = crank(pivot.pair(t), length=radius.at(t), angle=f, rate=w, acceleration=al).meets
    assert pin.velocity is not None
    assert pin.acceleration is not None
    first = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) @ pin.position / (12 * h)
    second = np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) @ pin.position / (12 * h * h)
    assert first == pytest.approx(pin.velocity[2], abs=1e-9)
    assert second == pytest.approx(pin.acceleration[2], abs=1e-7)
