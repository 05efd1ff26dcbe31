"""A class III group has its dead point where the lines of its three rods meet in one point, or are parallel."""

import math
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.commands.check import check_variant
from tests.mechanisms.library import changed as changed_lines
from tests.mechanisms.library import mechanism

LISTED = Path(__file__).parents[2] / "mechanisms"
AT = np.radians(70)  # from BC to BE
CORNERS = {"C": (0.22, 0.0), "E": (0.26, -AT)}  # of the plate, from B


def stop_of(**changed):
    text = mechanism("plate-on-three-rods", **changed)
    return coursework.solve(coursework.parse_variant(text), quantities=("table",)).stop


def guided(al, corner, **changed):
    """Return where the plate stops with E in a guide at the angle `al` in place of its third rod; B starts in `corner`."""
    text = mechanism(
        "plate-on-three-rods", ("(xF, yF) + l3 @ v", "(xF, yF) + v @ al"), ("l3*cos(v)", "v*cos(al)"), ("l3*sin(v)", "v*sin(al)"),
        ('["F", "E"], rate = "wv"', '["E"]'), ('"D", "F"]', '"D"]\nrails = [{ through = "E", angle = "al" }]'),
        l3=None, v='{ start = "0 m", rate = "wv" }', be=f'70 deg"\nal = "{al} deg', **changed,
    )  # fmt: skip
    x, y = corner + ray(0.26, (0.3 if changed else 0.10426076463415124) - AT)
    text = changed_lines(text, xF=f"{float(x)!r} m", yF=f"{float(y)!r} m")
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


def test_a_guide_stands_for_a_rod_across_it():
    stop = guided(60, np.array([0.16, 0.0]) + ray(0.3, 0.26710832750772134))
    f, k, g, u, _ = stop.coordinates.values()
    corner = ray(0.16, f) + ray(0.3, k)
    ends = [corner, corner + ray(0.22, g), corner + ray(0.26, g - AT)]
    a, c = ray(1, k), ray(1, u)
    x, y = ends[0] + np.linalg.solve(np.array([a, -c]).T, ends[1] - ends[0])[0] * a - ends[2]
    assert abs(x * math.cos(math.radians(60)) + y * math.sin(math.radians(60))) < 1e-8  # seen from E, across the guide
    assert "the lines of links 2 and 4 and the line across the guide at E meet in one point, about which link 3" in stop.meaning


def test_parallel_rods_across_a_guide():
    top = np.array([0.16, 0.3]) + ray(0.22, 0.3)
    starts = {"k": math.pi / 2, "g": 0.3, "u": math.pi / 2}
    angles = {name: f'{{ start = "{at!r} rad", rate = "w{name}" }}' for name, at in starts.items()}
    stop = guided(0, np.array([0.16, 0.3]), xD=f"{float(top[0])!r} m", yD=f"{float(top[1] - 0.25)!r} m", **angles)
    assert stop.time == pytest.approx(0, abs=1e-9)
    told = "links 2 and 4 are parallel and lie across the guide at E, so that link 3 can be moved a little along it"
    assert told in stop.meaning


def test_a_dyad_without_angles_is_told_to_be_stretched():
    """C moves by x and y, so the determinant is a sum of products that says nothing; B and D are 0.7 m apart there."""
    b, c, d = ray(0.1, 0.3), 0.3, 0.75
    apart = math.hypot(d - b[0], b[1])
    turned = math.atan2(b[1], b[0] - d) - math.acos((c**2 + apart**2 - 0.4**2) / (2 * c * apart))
    xy = dict(zip(("xC", "yC"), np.array([d, 0.0]) + ray(c, turned), strict=True))
    starts = {name: f'{{ start = "{float(at)!r} m", rate = "v{name}", unit = "m" }}' for name, at in xy.items()}
    text = mechanism("four-bar-by-squared-lengths", d=f"{d} m", **starts)
    stop = coursework.solve(coursework.parse_variant(text), quantities=("table",)).stop
    assert stop.time == pytest.approx((math.acos(0.55) - 0.3) / 10, abs=1e-9)
    assert "link 2 and link 3 lie on one line (stretched or folded)" in stop.meaning


@pytest.mark.parametrize(("name", "told"), [
    ("plate-on-three-rods", "the lines of links 2, 4 and 5 meet in one point, about which link 3 can turn a little; or links 2"),
    ("four-bar-by-squared-lengths", "link 2 and link 3 lie on one line (stretched or folded)"),
    ("block-of-three-equations", "the determinant of the 3 equations 1, 2, 3 is zero"),
])  # fmt: skip
def test_what_lines_do_at_a_dead_point_is_told_before_the_run(name, told, capsys):
    """A check lists it for each block; of three equations without links nothing better is known than their determinant."""
    check_variant(str(LISTED / f"{name}.toml"))
    assert f"zero when {told}" in capsys.readouterr().out
