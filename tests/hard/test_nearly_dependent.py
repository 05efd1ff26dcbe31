"""Equations that nearly depend on each other everywhere: the motion is followed as far as round-off allows, and no finer."""

import math

import numpy as np
import pytest

from tests.hard.scenes import check, scene, solve
from tests.results.checks.scenes import evidence_of, finding, spoil

R1, R2, X, Y, V = 0.5, 0.4, 0.5, 0.3, 0.4
# The hand runs along y = 0.3 m until the arm is stretched, by Pythagoras.
STRETCHED = (math.sqrt((R1 + R2) ** 2 - Y**2) - X) / V


def arm(share: float) -> str:
    """Return an arm whose second equation is the first one, and a `share` of the one that belongs there."""
    far = math.hypot(X, Y)
    upper = math.atan2(Y, X) + math.acos((R1**2 + far**2 - R2**2) / (2 * R1 * far))
    lower = math.atan2(Y - R1 * math.sin(upper), X - R1 * math.cos(upper))
    along, across = "V + r2*w2*sin(phi2) + r1*w1*sin(phi1)", "r2*w2*cos(phi2) + r1*w1*cos(phi1)"
    return scene(
        f'phi1 = {{ start = "{upper!r} rad", rate = "w1" }}\nphi2 = {{ start = "{lower!r} rad", rate = "w2" }}',
        given=f'r1 = "{R1} m"\nr2 = "{R2} m"\nV = "{V} m/s"',
        equations=[f"{along} = 0", f"{along} - {share!r}*({across}) = 0"],
    )


@pytest.mark.parametrize(("share", "within"), [(1.0, 1e-12), (1e-4, 1e-11), (1e-8, 1e-7), (1e-9, 1e-6)])
def test_the_dead_point_is_found_whatever_the_equations_share(share, within):
    run = solve(arm(share), "rk4")
    assert run.stop is not None
    assert (run.stop.kind, run.stop.time) == ("dead point", pytest.approx(STRETCHED, abs=within))
    assert run.scene.flow.evaluations < 1000  # 180 000 where more digits were asked for than there are


def test_an_arm_alone_asks_for_all_digits():
    run = solve(arm(1.0), "rk4")
    assert run.scene.flow.noise < 1e-15
    assert solve(arm(1e-8), "rk4").scene.flow.noise == pytest.approx(1e8 * run.scene.flow.noise, rel=1.0)


@pytest.mark.parametrize("share", [1.0, 1e-6, 1e-8, 3e-10])
def test_equations_are_satisfied_to_the_digits_that_they_leave(share):
    """Of the sixteen digits a share of 1e-8 leaves eight: an equation that is off by the ninth has been solved right."""
    run = solve(arm(share), "rk4", quantities=("table", "checks"))
    at, of_number = run.motion.t, 16 - check(run, "CONDITION").value
    assert [check(run, code).verdict for code in ("INITIAL", "RESIDUAL", "CONDITION")] == ["PASS"] * 3
    # The rate by hand: the hand's speed along x, with none along y.
    upper, lower = run.motion.coordinates.T
    w1 = -V * np.cos(lower) / (R1 * np.sin(upper - lower))
    assert run.motion.column("w1") == pytest.approx(w1, rel=10 ** (of_number - 15)) and len(at) == 44
    # An equation off by more than that, in the fourth row, has not.
    for times, verdict in ((0.0, "PASS"), (100.0, "FAIL")):
        wrong = times * max(1e-11, 10 ** (of_number - 16)) * abs(w1[3])
        judged = finding("RESIDUAL", evidence_of(run, motion=spoil(run.motion, w1=(3, wrong))))
        assert (judged.verdict, judged.row == 4 if times else True) == (verdict, True)
