"""The same mechanisms slower and faster: no limit of a change point is a number of seconds or of radians a second."""

import math

import numpy as np
import pytest

from tests.hard.scenes import four_bar, scene, solve


@pytest.mark.parametrize("speed", [1e-9, 1e-7, 1e-4, 1.0, 1e5, 1e8])
@pytest.mark.parametrize("form", ["closure", "equations"])
def test_both_motions_of_a_parallelogram_are_told_however_slow_or_fast_it_is(form, speed):
    """H04 with another clock: what a slow crank does is no rounding error, and a fast one moves little in a microsecond."""
    begin, end = 3.0, 0.3 / speed
    text = four_bar(1.0, 2.0, 1.0, 2.0, (begin, 0.0, begin), speed=repr(speed), step=end / 150, end=end)
    if form == "equations":
        written = (f"a*w1*{of}(theta) + b*wp*{of}(p) - c*wq*{of}(q) = 0" for of in ("sin", "cos"))
        lines = (f'[[constraint]]\nname = "{name}"\nequation = "{one}"\n' for name, one in enumerate(written))
        text = text.split("[[constraint]]")[0] + "".join(lines)
    stop = solve(text, "rk4").stop
    assert stop.kind == "change point" and stop.time == pytest.approx((math.pi - begin) / speed, rel=1e-6)
    told = sorted((one["wp"] / speed, one["wq"] / speed) for one in stop.branches)
    assert np.array(told) == pytest.approx(np.array([[0, 1], [2 / 3, -1 / 3]]), abs=1e-5)
    assert stop.sentence.count("wp = 0, ") == 1


@pytest.mark.parametrize("pace", [1e-6, 1e-3, 1.0, 1e3, 1e6])
def test_how_fast_both_motions_are_where_a_drive_only_touches_is_told_in_any_time(pace):
    """x = 3.2 + 0.8 sin(4 p t) comes to 4 m, r + l: the crank is as fast as sqrt(0.8 (4 p)^2 l/(r (r + l))) there."""
    elbow = math.acos((1 + 3.2**2 - 9) / 6.4)
    text = scene(
        f'x = {{ start = "3.2 m", rate = "v" }}\nth = {{ start = "{elbow!r} rad", rate = "wt" }}\n'
        f'ps = {{ start = "{-math.asin(math.sin(elbow) / 3)!r} rad", rate = "wp" }}',
        given=f'r = "1 m"\nl = "3 m"\nA = "0.8 m"\nk = "{4 * pace!r} 1/s"', drive='v = "A*k*cos(k*t)"', step=0.01 / pace,
        end=1.5 / pace, closures=["(x, 0) = r @ th + l @ ps"],
    )  # fmt: skip
    stop = solve(text, "rk4").stop
    speed = 4 * pace * math.sqrt(0.8 * 3 / 4)
    assert stop.kind == "change point" and stop.time == pytest.approx(math.pi / 8 / pace, rel=1e-5)
    assert sorted(one["wt"] for one in stop.branches) == pytest.approx([-speed, speed], rel=1e-3)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("speed", [1e-6, 1e-4, 1.0, 1e6])
def test_a_slide_passes_its_pivot_in_any_size_and_time(size, speed):
    """A crank as long as the pivot is high: the lever turns half as fast, and the slide runs through zero with its sign."""
    begin = math.pi / 4 + 0.15
    text = scene(
        f'th = {{ start = "0.3 rad", rate = "w" }}\nq = {{ start = "{begin!r} rad", rate = "wq" }}\n'
        f's = {{ start = "{2 * size * math.cos(begin - math.pi / 2)!r} m", rate = "u" }}',
        given=f'a = "{size!r} m"', drive=f'w = "{3 * speed!r} rad/s"', step=0.01 / speed, end=2.5 / speed,
        closures=["(0, a) + a @ th = s @ q"],
    )  # fmt: skip
    run = solve(text, "rk4")
    half = begin + 1.5 * speed * run.motion.t
    assert run.stop is None and len(run.motion.t) == 251
    assert run.motion.column("q") == pytest.approx(half, abs=1e-5)
    assert run.motion.column("s") / size == pytest.approx(2 * np.cos(half - math.pi / 2), abs=1e-5)
