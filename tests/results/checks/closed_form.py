"""Variant 31 by formulas typed by hand, so that what a check says is measured against something else than the tool.

Enters: steps and their length (s).  Leaves: motions: Euler by the coursework's own formulas, the exact one by the closed form of
its triangle.  Used by the tests of the checks.
"""

from __future__ import annotations

from math import atan, cos, pi, sin
from typing import Any

import numpy as np

from coursework.motion.integration.motion import Motion

R1, R2, R3, V, P, ALPHA, H, STEPS = 0.953, 0.847, 0.457, 4.5, 13.08, 4.35, 0.02, 24
START = (1.63, 3.37, 2.87)
COORDINATES = ("phi1", "phi2", "phi3")
VELOCITIES = ("w1", "w2", "w3", "w4")


def velocities(t: float, q: Any) -> Any:
    p1, p2, p3 = q
    w3 = V * sin(P * t + ALPHA) / (R3 * (2 * cos(p3) + sin(p3)))
    w4 = 2 * w3 * cos(p3) - 4 * w3 * sin(p3)
    a = 0.5 * R3 * w4 - R3 * w3 * cos(p3)
    b = -R3 * w3 * sin(p3)
    det = R1 * R2 * sin(p2 - p1)
    w1 = (a * -R2 * cos(p2) - b * R2 * sin(p2)) / det
    w2 = (b * R1 * sin(p1) + a * R1 * cos(p1)) / det
    return np.array([w1, w2, w3, w4])


def euler(steps: int = STEPS, h: float = H) -> Motion:
    q = np.array(START)
    rows, rates = [], []
    for i in range(steps + 1):
        u = velocities(i * h, q)
        rows.append(q)
        rates.append(u)
        q = q + h * u[:3]
    return _motion(np.arange(steps + 1) * h, np.array(rows), np.array(rates), "euler", "explicit Euler")


def exact(steps: int = STEPS, h: float = H) -> Motion:
    t = np.arange(steps + 1) * h
    u0 = 2 * sin(START[2]) - cos(START[2])
    u = u0 + V / (P * R3) * (cos(ALPHA) - np.cos(P * t + ALPHA))
    p3 = pi + atan(0.5) - np.arcsin(u / 5**0.5)
    mx = R1 * cos(START[0]) + R2 * cos(START[1]) + 2 * R3 * cos(START[2])
    cy = R1 * sin(START[0]) + R2 * sin(START[1]) + R3 * sin(START[2] + pi / 2)
    bx, by = mx - 2 * R3 * np.cos(p3), cy - R3 * np.cos(p3)
    bend = np.arccos((bx**2 + by**2 - R1**2 - R2**2) / (2 * R1 * R2))
    p1 = np.arctan2(by, bx) - np.arctan2(R2 * np.sin(bend), R1 + R2 * np.cos(bend))
    p1 = p1 + 2 * pi * np.round((START[0] - p1[0]) / (2 * pi))
    q = np.stack([p1, p1 + bend, p3], axis=1)
    rates = np.array([velocities(ti, qi) for ti, qi in zip(t, q, strict=True)])
    return _motion(t, q, rates, "exact", "exact positions from the closure (Newton)")


def _motion(t: Any, q: Any, u: Any, scheme: str, label: str) -> Motion:
    bare = np.zeros((len(t), 3))
    return Motion(t, q, u, bare, bare.copy(), COORDINATES, VELOCITIES, scheme, H, len(t) - 1, label=label)
