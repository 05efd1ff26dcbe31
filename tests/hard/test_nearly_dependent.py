"""Equations that nearly depend on each other everywhere: the motion is followed as far as round-off allows, and no finer."""

import math

import pytest

from tests.hard.scenes import scene, solve

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
