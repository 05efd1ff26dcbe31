"""Variant 31 in closed form, without the tool: whether its whole motion is possible, and how near it comes to a dead point.

C keeps its height, so 2 sin φ3 − cos φ3 = √5 sin(φ3 − atan ½) follows M alone; B follows from M and φ3; links 1 and 2 must reach
from D to B.  Everything is periodic in the phase of the drive.
"""

import math

import numpy as np

DELTA = math.atan(0.5)
PHASES = 20_001


def margins(r1, r2, r3, V1, p, alpha, phi1, phi2, phi3):
    """Return (guide, reach): least √5 |cos(φ3 − δ)|/3 and least |sin(φ1 − φ2)| over a period; negative where impossible."""
    psi = alpha + np.linspace(0.0, 2 * math.pi, PHASES)
    risen = V1 / p * (math.cos(alpha) - np.cos(psi))
    level = math.sin(phi3 - DELTA) + risen / (math.sqrt(5) * r3)
    if np.max(np.abs(level)) >= 1:
        return -1.0, -1.0
    side = 1.0 if math.cos(phi3 - DELTA) > 0 else -1.0
    angle = np.arcsin(level)
    third = DELTA + (angle if side > 0 else math.pi - angle)
    m = complex(r1 * math.cos(phi1) + r2 * math.cos(phi2) + 2 * r3 * math.cos(phi3),
                r1 * math.sin(phi1) + r2 * math.sin(phi2) + 2 * r3 * math.sin(phi3))  # fmt: skip
    reach = np.abs(m + 1j * risen - 2 * r3 * np.exp(1j * third))
    cosine = (reach**2 - r1**2 - r2**2) / (2 * r1 * r2)
    if np.max(np.abs(cosine)) >= 1:
        return float(np.min(np.cos(angle)) * math.sqrt(5) / 3), -1.0
    return float(np.min(np.cos(angle)) * math.sqrt(5) / 3), float(np.sqrt(1 - np.max(cosine**2)))
