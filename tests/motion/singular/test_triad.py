"""A class III group has its dead point where the lines of its three rods meet in one point, or are parallel."""

import math

import numpy as np
import pytest

import coursework
from tests.mechanisms.library import mechanism

AT = np.radians(70)  # from BC to BE
CORNERS = {"C": (0.22, 0.0), "E": (0.26, -AT)}  # of the plate, from B


def stop_of(**changed):
    text = mechanism("plate-on-three-rods", **changed)
    return coursework.solve(coursework.parse_variant(text), quantities=("table",)).stop


def ray(length, angle):
    return length * np.array([math.cos(angle), math.sin(angle)])


def test_the_lines_of_the_rods_meet_in_one_point():
    stop = stop_of()
    f, k, g, u, v = stop.coordinates.values()
    corner = ray(0.16, f) + ray(0.3, k)
    ends = [corner, corner + ray(0.22, g), corner + ray(0.26, g - AT)]
    (a, b), (c, d) = (math.cos(k), -math.cos(u)), (math.sin(k), -math.sin(u))
    along = np.linalg.solve([[a, b], [c, d]], ends[1] - ends[0])[0]
    x, y = ends[0] + along * ray(1, k) - ends[2]
    assert abs(x * math.sin(v) - y * math.cos(v)) < 1e-8
    assert "the lines of links 2, 4 and 5 meet in one point, about which link 3 can turn a little" in stop.meaning


def test_parallel_rods():
    tops = {name: np.array([0.16, 0.3]) + ray(r, 0.3 + turned) for name, (r, turned) in CORNERS.items()}
    starts = dict(zip("kguv", (math.pi / 2, 0.3, math.pi / 2, math.pi / 2), strict=True))
    fixed = {"xD": tops["C"][0], "yD": tops["C"][1] - 0.25, "xF": tops["E"][0], "yF": tops["E"][1] - 0.28}
    angles = {name: f'{{ start = "{angle!r} rad", rate = "w{name}" }}' for name, angle in starts.items()}
    stop = stop_of(**angles, **{name: f"{float(place)!r} m" for name, place in fixed.items()})
    assert stop.time == pytest.approx(0, abs=1e-9)
    assert "links 2, 4 and 5 are parallel, so that link 3 can be moved a little across them" in stop.meaning
