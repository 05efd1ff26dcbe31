"""What the printed M-functions of the deck would give, fault by fault, beside what the groups give.

Each test computes the misprint as it stands in the deck, so that a student who typed it in recognises the numbers.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from coursework.mechanism.groups import GroupMotion, Guide, Pair, crank, prp, rpp, rpr, rrr

Array = NDArray[np.float64]
REFERENCE = Path(__file__).parents[2] / "reference"
A = Pair((0.0, 0.0))
QUARTER = np.pi / 2


def rates(motion: GroupMotion) -> Array:
    assert motion.rates is not None
    return np.asarray(motion.rates[0])


def accelerations(motion: GroupMotion) -> Array:
    assert motion.accelerations is not None
    return np.asarray(motion.accelerations[0])


def driven(degrees: float, length: float = 0.4) -> Pair:
    return crank(A, length=length, angle=np.deg2rad(degrees), rate=10.0).meets


def acceleration_of(pair: Pair) -> Array:
    assert pair.acceleration is not None
    return np.asarray(pair.acceleration[0])


@pytest.mark.parametrize(
    ("degrees", "right", "printed"),
    [
        (0.0, (24.9702734839, -12.8065750467), (27.2663905859, -6.6240905414)),
        (90.0, (0.0, -200 / 7), (0.0, -200 / 7)),  # s' = 0 here, and the fault cannot be seen
    ],
)
def test_fault_1_rprki_has_a_cosine_for_a_sine(degrees: float, right: tuple[float, float], printed: tuple[float, float]) -> None:
    solved = rpr(driven(degrees), Pair((0.0, -1.0)))
    (theta, s), (turn, slide) = solved.coordinates[0], rates(solved)
    matrix = np.array([[-s * np.sin(theta), np.cos(theta)], [s * np.cos(theta), np.sin(theta)]])

    def program(last: float) -> Array:
        """Return what the M-function computes: a ddq = B'' - da/dt dq, `last` the entry that was misprinted."""
        changing = np.array(
            [
                [
                    slide * np.cos(theta + QUARTER) + s * turn * np.cos(theta + np.pi),
                    turn * np.cos(theta + QUARTER),
                ],
                [slide * np.sin(theta + QUARTER) + s * turn * np.sin(theta + np.pi), turn * last],
            ]
        )
        found: Array = np.linalg.solve(matrix, acceleration_of(driven(degrees)) - changing @ np.array([turn, slide]))
        return found

    assert program(np.sin(theta + QUARTER)) == pytest.approx(right, abs=1e-9)
    assert accelerations(solved) == pytest.approx(right, abs=1e-9)
    assert program(np.cos(theta + QUARTER)) == pytest.approx(printed, abs=1e-9)


@pytest.mark.parametrize("degrees", [0.0, 40.0, 200.0])
def test_fault_2_rppki_has_a_minus_before_b(degrees: float) -> None:
    guide = Guide(Pair((0.0, 0.8)), 0.0)
    solved = rpp(driven(degrees), guide, slide_angle=-QUARTER)
    matrix = np.array([[np.cos(-QUARTER), 1.0], [np.sin(-QUARTER), 0.0]])
    right = acceleration_of(driven(degrees))
    assert accelerations(solved) == pytest.approx(np.linalg.solve(matrix, right), abs=1e-12)
    assert -accelerations(solved) == pytest.approx(np.linalg.solve(matrix, -right), abs=1e-12)
    # the two differ wherever B accelerates, which a crank pin always does
    assert np.abs(2 * accelerations(solved)).max() > 10.0


@pytest.mark.parametrize("degrees", [0.0, 90.0, 250.0])
def test_fault_3_prpki_forgets_b5(degrees: float) -> None:
    phi = np.deg2rad(degrees)
    psi, turn, gain = np.pi / 3 + 0.6 * np.sin(phi), 6.0 * np.cos(phi), -60.0 * np.sin(phi)
    k_i = crank(A, length=0.3, angle=psi, rate=turn, acceleration=gain).meets
    t_i, r_i, t_j, r_j = psi - 0.9, 0.15, 1.9207963267949, 0.1
    solved = prp(Guide(k_i, t_i, turn, gain, r_i), Guide(Pair((1.1, -0.2)), t_j, offset=r_j))
    s_i, ds_i = solved.coordinates[0, 0], rates(solved)[0]
    n_i, e_i = np.array([-np.sin(t_i), np.cos(t_i)]), np.array([np.cos(t_i), np.sin(t_i)])
    matrix = np.array([[np.cos(t_i), -np.cos(t_j)], [np.sin(t_i), -np.sin(t_j)]])
    b1 = -n_i * (2 * ds_i * turn + s_i * gain)
    b2, b3, b4 = e_i * s_i * turn**2, e_i * r_i * gain, n_i * r_i * turn**2
    b5 = -acceleration_of(k_i)
    assert accelerations(solved) == pytest.approx(np.linalg.solve(matrix, b1 + b2 + b3 + b4 + b5), abs=1e-10)
    forgotten = np.linalg.solve(matrix, b1 + b2 + b3 + b4)
    assert np.abs(forgotten - accelerations(solved)).max() > 1.0


def second_dyad(cd: float) -> Array:
    """Return w5, w6 of example 3 at crank 60 deg as the deck's DCEF velocity call computes them with `cd` for CD."""
    first = rrr(driven(60.0, 26.5), Pair((87.5, 0.0)), lengths=(105.6, 67.5), mode=1)
    theta3, w3 = first.coordinates[0, 1], rates(first)[1]
    c = Pair(first.meets.position, cd * w3 * np.array([-np.sin(theta3), np.cos(theta3)]))
    return rates(rrr(c, Pair((150.0, 70.0)), lengths=(65.0, 48.0), mode=-1))


def test_fault_4_example_3_takes_ad_for_cd() -> None:
    right, printed = second_dyad(67.5), second_dyad(87.5)
    assert right == pytest.approx((-3.18045457492925, -7.16374069757861), rel=1e-13)
    assert printed == pytest.approx((-4.12281148601939, -9.2863305338982), rel=1e-13)
    assert printed / right == pytest.approx(87.5 / 67.5, rel=1e-14)


def newton(steps: int) -> tuple[Array, float]:
    """Return theta2, theta3 of example 3 at crank 60 deg after Newton steps from 25, 80 deg, and the last step."""
    b, d, rod, rocker = driven(60.0, 26.5).position[0], np.array([87.5, 0.0]), 105.6, 67.5
    theta = np.deg2rad([25.0, 80.0])
    step = np.zeros(2)
    for _ in range(steps):
        (c2, c3), (s2, s3) = np.cos(theta), np.sin(theta)
        gap = b + rod * np.array([c2, s2]) - d - rocker * np.array([c3, s3])
        jacobian = np.array([[-rod * s2, rocker * s3], [rod * c2, -rocker * c3]])
        step = np.linalg.solve(jacobian, -gap)
        theta = theta + step
    return theta, float(np.linalg.norm(step))


def velocities_at(theta: Array) -> Array:
    """Return w2, w3 of example 3 at crank 60 deg from the velocity equations with the angles `theta`."""
    velocity = driven(60.0, 26.5).velocity
    assert velocity is not None
    (c2, c3), (s2, s3) = np.cos(theta), np.sin(theta)
    matrix = np.array([[-105.6 * s2, 67.5 * s3], [105.6 * c2, -67.5 * c3]])
    found: Array = np.linalg.solve(matrix, -velocity[0])
    return found


def test_printed_y2_is_the_third_newton_step() -> None:
    check = json.loads((REFERENCE / "example3_rrr_rrr.json").read_text())["deck_check"]
    theta, step = newton(3)
    assert velocities_at(theta) == pytest.approx((-0.580620100031004, 3.252748641369780), abs=1e-14)
    assert step == pytest.approx(9.9e-5, rel=0.01)

    solved = rrr(driven(60.0, 26.5), Pair((87.5, 0.0)), lengths=(105.6, 67.5), mode=1)
    assert solved.coordinates[0] == pytest.approx(check["y1_theta2_theta3"], abs=1e-14)
    assert rates(solved) == pytest.approx(check["computed"], abs=1e-13)
    assert rates(solved) == pytest.approx(check["printed_y2"], abs=2e-8)
    assert velocities_at(newton(8)[0]) == pytest.approx(rates(solved), abs=1e-13)
    assert np.abs(velocities_at(theta) - rates(solved)).max() > 1e-8


def test_guesses_of_example_3_lead_to_e_below_and_their_opposites_above() -> None:
    c = rrr(driven(60.0, 26.5), Pair((87.5, 0.0)), lengths=(105.6, 67.5), mode=1).meets
    for mode, degrees in ((-1, (-37.708, -75.223)), (1, (56.990, 94.505))):
        solved = rrr(c, Pair((150.0, 70.0)), lengths=(65.0, 48.0), mode=mode)
        assert np.rad2deg(solved.coordinates[0]) == pytest.approx(degrees, abs=1e-3)
