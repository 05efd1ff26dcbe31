"""An arm of two links whose hand is driven in x and y: what one drive alone could not do, and what both together can."""

import math

import numpy as np
import pytest

from tests.hard.scenes import scene, solve

R1, R2 = 0.5, 0.4
REACH = R1 + R2


def bent(x: float, y: float) -> tuple[float, float]:
    """Return the angles of the arm whose hand is at (x, y) and whose elbow is above."""
    far = math.hypot(x, y)
    upper = math.atan2(y, x) + math.acos(min(1.0, (R1**2 + far**2 - R2**2) / (2 * R1 * far)))
    return upper, math.atan2(y - R1 * math.sin(upper), x - R1 * math.cos(upper))


def arm(vx: str, vy: str, x: float, y: float) -> str:
    """Return the arm with its hand at (x, y) at first."""
    upper, lower = bent(x, y)
    return scene(
        f'phi1 = {{ start = "{upper!r} rad", rate = "w1" }}\nphi2 = {{ start = "{lower!r} rad", rate = "w2" }}',
        given=f'r1 = "{R1} m"\nr2 = "{R2} m"\nm = "1 m"\np = "1 rad/s"',
        drive=f'VMx = "{vx}"\nVMy = "{vy}"',
        equations=["VMx + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0", "VMy - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"],
        more='[points]\nD = "(0, 0)"\nA = "D + r1 @ phi1"\nM = "A + r2 @ phi2"\n[links]\n'
        '1 = { points = ["D", "A"], rate = "w1" }\n'
        '2 = { points = ["A", "M"], rate = "w2" }\n[frame]\nhinges = ["D"]\n[closure]\ndriven = "M"\n',
    )


def test_only_another_motion_of_both_drives_leads_out_of_a_position():
    """Stretched along x the hand may start across, but a straight line leaves the circle that it can reach."""
    run = solve(arm("0", "0.3", REACH, 0.0), "rk4")
    assert run.stop is not None and run.stop.kind == "dead point"
    assert "as the drives move together here" in run.stop.sentence and "Whatever the drive" not in run.stop.sentence


@pytest.mark.parametrize("speed", [1.0, 1e-6])
def test_round_the_edge_of_its_reach_the_arm_has_one_motion(speed):
    """Along its whole reach the arm turns as one piece, with the rate of its hand: there are no two motions to choose from."""
    rate = f"({speed!r}*p)"
    run = solve(
        arm(f"-{REACH!r}*m*{rate}*sin({rate}*t)", f"{REACH!r}*m*{rate}*cos({rate}*t)", REACH, 0.0),
        "rk4",
        end=1 / speed,
        step=0.02 / speed,
    )
    assert run.stop is not None and "removable" in run.stop.sentence
    (told,) = run.stop.branches
    assert told == pytest.approx({"w1": speed, "w2": speed}, rel=1e-4)


@pytest.mark.parametrize("less", [1e-3, 1e-7])
def test_just_inside_its_reach_it_passes_and_just_outside_it_is_dead(less):
    """The hand runs round (0.4 m ± less, 0) on 0.5 m: at t = 1 s it would be furthest, at the reach and so much beyond."""
    for centre in (REACH - 0.5 - less, REACH - 0.5 + less):
        x, y = centre + 0.5 * math.cos(-1), 0.5 * math.sin(-1)
        run = solve(arm("-0.5*m*p*sin(p*t - 1)", "0.5*m*p*cos(p*t - 1)", x, y), "exact", end=1.6)
        if centre < REACH - 0.5:
            hand = [bent(centre + 0.5 * math.cos(t - 1), 0.5 * math.sin(t - 1)) for t in run.motion.t]
            assert run.stop is None and run.motion.coordinates == pytest.approx(np.array(hand), abs=1e-11)
        else:
            beyond = math.acos((REACH**2 - centre**2 - 0.25) / centre)
            assert (run.stop.kind, run.stop.time) == ("dead point", pytest.approx(1 - beyond, abs=1e-9))


def test_a_drive_a_millionth_of_the_other_is_followed_as_exactly():
    run = solve(arm("0.3*sin(2*pi*p*t)", "1e-6*cos(3*p*t)", 0.37, 0.58), "exact")
    t = run.motion.t
    x, y = 0.37 + 0.3 * (1 - np.cos(2 * np.pi * t)) / (2 * np.pi), 0.58 + 1e-6 * np.sin(3 * t) / 3
    assert run.motion.coordinates == pytest.approx(np.array([bent(*at) for at in zip(x, y, strict=True)]), abs=1e-12)
