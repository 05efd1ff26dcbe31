"""Where the geometry gives the other starts, one number copied wrongly is one fault; a four-bar linkage computed here."""

import cmath
import math

import numpy as np
import pytest

import coursework
from tests.grading.marking.table.desks import Desk, codes

DESK = Desk(coursework.load("example-1"))
BARS, SPEED = {"r1": 0.4, "r2": 1.0, "r3": 0.7, "r4": 1.2}, 10.0
STEP = 2 * math.pi / (36 * SPEED)


def closed(theta1, r1, r2, r3, r4):
    """The angles of coupler and rocker, C above AD, by the cosine rule."""
    pin = r1 * cmath.exp(1j * theta1)
    diagonal = abs(r4 - pin)
    theta2 = cmath.phase(r4 - pin) + math.acos((r2**2 + diagonal**2 - r3**2) / (2 * r2 * diagonal))
    return theta2, cmath.phase(pin + r2 * cmath.exp(1j * theta2) - r4)


def made(theta1=0.0, start=None, **other):
    bars = BARS | other
    q = np.array([theta1, *closed(theta1, **bars)] if start is None else start)
    rows = []
    for _ in range(37):
        (s1, s2, s3), (c1, c2, c3) = np.sin(q), np.cos(q)
        matrix = [[-bars["r2"] * s2, bars["r3"] * s3], [bars["r2"] * c2, -bars["r3"] * c3]]
        w = np.array([SPEED, *np.linalg.solve(matrix, bars["r1"] * SPEED * np.array([s1, -c1]))])
        rows.append([*q, *w])
        q = q + STEP * w
    return np.array(rows)


@pytest.mark.parametrize(("how", "code"), [
    ({"theta1": 0.1}, "start_theta1"), ({"r4": 1.3}, "datum_r4"), ({"start": [0.1, *closed(0, **BARS)]}, "start_theta1"),
])  # fmt: skip
def test_one_number_from_which_all_starts_follow_is_one_fault(how, code):
    """The start of the crank, or the frame, which no velocity depends on: three starts seemed wrong, and 24 points were lost."""
    table = made(**how)
    assert (DESK.marked(table, digits=5)[0], codes(DESK.marked(table, digits=5)[1])[0]) == (57, code)
    put = table.copy()
    for place in range(3):  # with starts put right, each follows from the rows below
        put[0, place] = DESK.key.table[0, place]
        assert DESK.marked(put, digits=5)[0] >= 57


def test_starts_that_follow_from_no_one_number_are_several():
    begun = np.add([0.1, *closed(0, **BARS)], (0, 0.05, -0.03))
    found, marked = DESK.marked(made(start=begun), digits=5)
    assert (found, codes(marked)[0]) == (36, "start_theta1")
