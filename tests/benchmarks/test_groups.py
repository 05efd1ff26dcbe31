"""The four-bar by groups against the same formulas written out by hand, in one run on one machine."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.mechanism.groups import GroupMotion, Pair, crank, rrr
from tests.benchmarks.timer import ratio

Array = NDArray[np.float64]
ROWS = 1000
PHI = np.linspace(0.0, 2 * np.pi, ROWS)


def by_groups() -> GroupMotion:
    pin = crank(Pair((0.0, 0.0)), length=0.4, angle=PHI, rate=10.0).meets
    return rrr(pin, Pair((1.2, 0.0)), lengths=(1.0, 0.7), mode=1)


def by_hand() -> tuple[Array, ...]:
    """Positions, velocities, accelerations of both links and of C: nothing checked, nothing general."""
    r1, r2, r3, r4, w = 0.4, 1.0, 0.7, 1.2, 10.0
    c1, s1 = np.cos(PHI), np.sin(PHI)
    bx, by = r1 * c1, r1 * s1
    dx, dy = r4 - bx, -by
    d = np.sqrt(dx * dx + dy * dy)
    x = (r2 * r2 + d * d - r3 * r3) / (2 * d)
    y = np.sqrt(r2 * r2 - x * x)
    ux, uy = (x * dx - y * dy) / d, (x * dy + y * dx) / d
    vx, vy = ux - dx, uy - dy
    theta2, theta3 = np.arctan2(uy, ux), np.arctan2(vy, vx)
    determinant = uy * vx - ux * vy
    px, py = r1 * w * s1, -r1 * w * c1
    w2, w3 = -(vx * px + vy * py) / determinant, -(ux * px + uy * py) / determinant
    qx = r1 * w * w * c1 + w2 * w2 * ux - w3 * w3 * vx
    qy = r1 * w * w * s1 + w2 * w2 * uy - w3 * w3 * vy
    e2, e3 = -(vx * qx + vy * qy) / determinant, -(ux * qx + uy * qy) / determinant
    cvx, cvy = -w3 * vy, w3 * vx
    cax, cay = -e3 * vy - w3 * w3 * vx, e3 * vx - w3 * w3 * vy
    return theta2, theta3, w2, w3, e2, e3, bx + ux, by + uy, cvx, cvy, cax, cay


def test_both_compute_the_same() -> None:
    solved, hand = by_groups(), by_hand()
    point = solved.meets
    for place, rows in enumerate((solved.coordinates, solved.rates, solved.accelerations)):
        assert rows is not None
        assert np.abs(rows - np.column_stack(hand[2 * place : 2 * place + 2])).max() < 1e-10
    for place, rows in enumerate((point.position, point.velocity, point.acceleration), start=3):
        assert rows is not None
        assert np.abs(rows - np.column_stack(hand[2 * place : 2 * place + 2])).max() < 1e-10


def test_groups_cost_at_most_five_times_the_bare_formulas() -> None:
    found = ratio(by_groups, by_hand, most=5, repeats=100)
    assert found <= 5, f"{found:.2f} times"
