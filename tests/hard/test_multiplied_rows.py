"""Equations multiplied by any number mean the same: where a motion ends, how, and that it is followed."""

import math
from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest

from coursework.equations.codegen.programs import _adjugate
from tests.hard.scenes import scene, solve

FACTORS = [(1e6, 1.0), (1e-6, 1.0), (1e9, 1e-9), (1.0, 1e9), (1e-12, 1.0)]
TOUCH = math.pi / 8  # s: the slider is farthest out, 3.2 m + amplitude, where 4 m is the length of both links


def slider(amplitude: float, along: float, across: float) -> str:
    """Return a slider at 3.2 + A sin 4t that drives a crank of 1 m by a rod of 3 m, its two equations multiplied."""
    elbow = math.acos((1 + 3.2**2 - 9) / 6.4)
    return scene(
        f'x = {{ start = "3.2 m", rate = "v" }}\nth = {{ start = "{elbow!r} rad", rate = "wt" }}\n'
        f'ps = {{ start = "{-math.asin(math.sin(elbow) / 3)!r} rad", rate = "wp" }}',
        given=f'r = "1 m"\nl = "3 m"\nA = "{amplitude!r} m"\nk = "4 1/s"',
        drive='v = "A*k*cos(k*t)"',
        step=0.01,
        end=1.5,
        equations=[
            f"{along!r}*v = -{along!r}*r*wt*sin(th) - {along!r}*l*wp*sin(ps)",
            f"0 = {across!r}*r*wt*cos(th) + {across!r}*l*wp*cos(ps)",
        ],
    )


@pytest.mark.parametrize("factors", FACTORS)
@pytest.mark.parametrize("beyond", [1e-2, 1e-5, 1e-7])
def test_a_dead_point_is_one_at_its_time(beyond, factors):
    stop = solve(slider(0.8 + beyond, *factors), "rk4").stop
    assert stop.kind == "dead point" and abs(stop.time - math.asin(0.8 / (0.8 + beyond)) / 4) < 1e-8


@pytest.mark.parametrize("factors", FACTORS)
@pytest.mark.parametrize(("short", "kind"), [(0.0, "change point"), (1e-7, None)])
def test_what_only_touches_a_position_is_told_from_what_passes_it(short, kind, factors):
    """At the touch the crank is as fast as sqrt(A k^2 (r + l)/(r l)) of x'' = -A k^2, one way or the other."""
    scene = solve(slider(0.8 - short, *factors), "rk4").scene
    found = scene.search.event
    assert (None if found is None else found.kind) == kind
    if found is not None:
        told = sorted(branch["wt"] for branch in scene.stop.branches)
        speed = math.sqrt(0.8 * 16 * 3 / 4)
        assert found.time == pytest.approx(TOUCH, abs=1e-7) and told == pytest.approx([-speed, speed], rel=1e-4)


def determinant(matrix: list[list[Fraction]]) -> Fraction:
    """Return the determinant by its definition."""
    places = range(len(matrix))
    signs = ((-1) ** sum(order[i] > order[j] for i in places for j in places if i < j) for order in permutations(places))
    return sum((sign * math.prod(matrix[i][order[i]] for i in places)
                for sign, order in zip(signs, permutations(places), strict=True)), Fraction(0))  # fmt: skip


@pytest.mark.parametrize("factors", [(1, 1, 1, 1), (1, 1, 1, 1e9), (1, 1e-9, 1, 1), (1e9, 1e-9, 1e6, 1e-6)])
@pytest.mark.parametrize("singular", [False, True])
def test_the_adjugate_keeps_its_digits(singular, factors):
    """Against fractions.  A singular block has one, too: its clock stands still there, its positions do not."""
    rows = np.array([[2.0, -1, 3, 5], [1, 4, -2, 3], [-3, 2, 1, 4], [5, 1, -4, 2]])
    rows[3] = rows[0] + rows[1] - rows[2] if singular else rows[3]
    rows, right = rows * np.array(factors)[:, None], np.array([1.0, -2, 4, 3]) * factors
    *found, size = _adjugate((*rows.ravel().tolist(), *right.tolist()))
    exact = [[Fraction(x) for x in row] for row in rows.tolist()]
    wanted = [
        determinant([[*row[:i], Fraction(b), *row[i + 1 :]] for row, b in zip(exact, right.tolist(), strict=True)])
        for i in range(4)
    ]
    assert found == pytest.approx([float(x) for x in wanted], rel=1e-13)
    assert size == pytest.approx(float(determinant(exact)), rel=1e-13, abs=1e-13 * max(map(abs, found)))


def platform(factor: float) -> str:
    """Return three cranks that move a triangle by three rods: six velocity equations in one block, one of them multiplied."""
    feet, spread = [0, 2, 1 + 1.7j], [7 * math.pi / 6, -math.pi / 6, math.pi / 2]
    cranks, pose = [0.5, 2.0, -1.2], (1.0211342257, 0.6014567796, 1.8165530563)
    rods = [
        np.angle(pose[0] + 1j * pose[1] + 0.3 * np.exp(1j * (pose[2] + a)) - foot - 0.4 * np.exp(1j * c))
        for foot, a, c in zip(feet, spread, cranks, strict=True)
    ]
    names = [*(f"c{i}" for i in range(3)), "x", "y", "psi", *(f"a{i}" for i in range(3))]
    starts = [*cranks, *pose, *map(float, rods)]
    arms = [f"rp*u_psi*{{of}}(psi + {angle!r})" for angle in spread]
    equations = [
        line
        for i, arm in enumerate(arms)
        for line in (
            f"-rc*u_c{i}*sin(c{i}) - rl*u_a{i}*sin(a{i}) - u_x + {arm.format(of='sin')} = 0",
            f"rc*u_c{i}*cos(c{i}) + rl*u_a{i}*cos(a{i}) - u_y - {arm.format(of='cos')} = 0",
        )
    ]
    equations[1] = f"{factor!r}*({equations[1].removesuffix(' = 0')}) = 0"
    return scene(
        "\n".join(
            f'{name} = {{ start = "{start!r} {"m" if name in "xy" else "rad"}", rate = "u_{name}" }}'
            for name, start in zip(names, starts, strict=True)
        ),
        given='rc = "0.4 m"\nrl = "0.9 m"\nrp = "0.3 m"\nk = "1 1/s"',
        drive='u_c0 = "3*k*cos(3*k*t)"\nu_c1 = "1.4*k*cos(2*k*t)"\nu_c2 = "2*k*cos(4*k*t)"',
        step=0.01,
        equations=equations,
    )


@pytest.mark.parametrize("factor", [1.0, 1e9, 1e-9])
def test_six_equations_are_followed_to_the_end(factor):
    scene = solve(platform(factor), "rk4").scene
    assert scene.search.goes_on and scene.flow.evaluations < 6000


@pytest.mark.parametrize("factor", [1e-9, 1e-3, 1.0, 1e6])
@pytest.mark.parametrize(("longer", "kind"), [(0.0, "change point"), (1e-7, "dead point"), (1e-3, "dead point"), (-1e-6, None)])
def test_one_equation_alone_is_told_alike_whatever_its_size(longer, kind, factor):
    """A crank as long as its rod brings it upright where it is upright itself; a longer one never gets there."""
    crank = 1.0 + longer
    text = scene(
        f'th = {{ start = "0.3 rad", rate = "w" }}\nps = {{ start = "{-math.asin(crank * math.sin(0.3))!r} rad", rate = "wp" }}',
        given=f'r = "{crank!r} m"\nl = "1 m"', drive='w = "2"', step=0.01,
        equations=[f"{factor!r}*r*w*cos(th) + {factor!r}*l*wp*cos(ps) = 0"],
    )  # fmt: skip
    event = solve(text, "rk4").scene.search.event
    assert (None if event is None else event.kind) == kind
    if event is not None:
        assert event.time == pytest.approx((math.asin(1 / crank) - 0.3) / 2, abs=1e-7)


DEMANDED = {
    "1e6": "5e+05 (in the unit of its equation)",
    "10": "5 (in the",
    "9": "4.5 m/s",
    "1": "0.5 m/s",
    "0.2": "0.1 m/s",
    "0.01": "0.005 (in the",
}


@pytest.mark.parametrize(("factor", "unit"), DEMANDED.items())
def test_the_demand_of_a_multiplied_equation_is_no_speed(factor, unit):
    """A hand on a circle of 1 m is drawn outwards at 0.5 m/s, and stops at its edge."""
    text = scene(
        f'phi = {{ start = "0.5 rad", rate = "w" }}\nx = {{ start = "{math.cos(0.5)!r} m", rate = "u" }}',
        given='r = "1 m"\nV = "0.5 m/s"', drive='u = "V"', equations=[f"-{factor}*r*w*sin(phi) = {factor}*u"],
    )  # fmt: skip
    stop = solve(text, "rk4").stop
    assert stop is not None and stop.time == pytest.approx((1 - math.cos(0.5)) / 0.5, abs=1e-12)
    assert f"The drive asks for {unit}" in stop.sentence


def test_a_determinant_that_vanishes_far_away_is_not_called_never_zero_where_it_does():
    """u = k x^2 from 0.5 m: x = 0.5/(1 - t) is without bounds at t = 1 s."""
    text = scene('x = { start = "0.5 m", rate = "u" }', given='k = "2 1/s"\nm = "1 m"', equations=["u*m^2/x^2 = k*m"], end=2.0)
    stop = solve(text, "rk4").stop
    assert stop is not None and stop.time == pytest.approx(1.0, abs=1e-4)
    assert "never" not in stop.sentence and "m^2/x^2 is zero" in stop.sentence
