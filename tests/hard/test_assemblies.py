"""H24, H25, H29, H32: tables with noise, wheels on circles, starts that do not close, two assemblies of one dyad."""

import math

import mpmath
import numpy as np
import pytest

from coursework.equations.five_point import AMPLIFICATION, best_spacing, derivative, noise, rounding_error
from coursework.motion.geometry.closed_start import closed_start
from coursework.motion.geometry.closure import compile_closure
from coursework.words.errors import InputError
from tests.hard.scenes import CASES, check, expected, four_bar, numbers, scene, solve
from tests.hard.test_change_points import chain


@pytest.mark.parametrize("spacing", CASES["H24"]["data"]["dt"])
def test_h24_closer_nodes_make_a_rounded_table_worse(spacing):
    """r = 0.5 + 0.05 sin 2 pi t rounded to 1e-4: the predicted error of the derivative is the one that is found."""
    sigma = rounding_error(1e-4)
    assert sigma == pytest.approx(2.887e-5, rel=1e-3)
    assert pytest.approx(0.95015, abs=1e-5) == AMPLIFICATION == math.sqrt(130) / 12
    found = []
    for shift in np.linspace(0, 1, 40, endpoint=False):
        t = shift + spacing * np.arange(400)
        exact = 0.5 + 0.05 * np.sin(2 * np.pi * t)
        rounded = np.round(exact * 1e4) / 1e4
        found.append(derivative(t, rounded)[2:-2] - derivative(t, exact)[2:-2])
    assert np.std(found) == pytest.approx(noise(sigma, spacing), rel=0.2)


def test_h24_the_best_spacing_makes_noise_and_truncation_together_least():
    sigma, fifth = rounding_error(1e-4), 0.05 * (2 * math.pi) ** 5
    best = best_spacing(sigma, fifth)
    with mpmath.workdps(30):
        wanted = mpmath.findroot(lambda h: 4 * h**3 * fifth / 30 - sigma * mpmath.sqrt(130) / 12 / h**2, 0.03)
    assert best == pytest.approx(float(wanted), rel=1e-12)

    def worst(spacing: float) -> float:
        nodes = np.arange(0, 3, spacing)
        rounded = np.round((0.5 + 0.05 * np.sin(2 * np.pi * nodes)) * 1e4) / 1e4
        slope = 0.05 * 2 * np.pi * np.cos(2 * np.pi * nodes)
        return float(np.sqrt(np.mean((derivative(nodes, rounded) - slope)[2:-2] ** 2)))

    assert worst(best) < min(worst(best / 8), worst(best * 4))


def wheel(inside: bool) -> str:
    """A wheel of 0.5 m rolls in (on) a circle of 2 m, its centre at 1 m/s; psi is the angle of the wheel itself."""
    arm, sign = ("R - r", "-") if inside else ("R + r", "+")
    spin = f"psi = {sign}({arm})*theta/r"
    return scene(
        'theta = { start = "0 rad", rate = "wl" }\npsi = { start = "0 rad", rate = "ww" }',
        given='R = "2 m"\nr = "0.5 m"',
        drive='vC = "1"',
        step=0.05,
        end=2 * math.pi * (1.5 if inside else 2.5),
        equations=[f"({arm})*wl = vC"],
        closures=[spin],
    )


@pytest.mark.parametrize("inside", [True, False])
def test_h25_a_wheel_in_and_on_a_circle(inside):
    wanted = expected("H25")
    run = solve(wheel(inside))
    line, body = run.table["wl"].iloc[0], run.table["ww"].iloc[0]
    assert line == pytest.approx(float(wanted["centre_line_rate_inside" if inside else "outside"]), rel=1e-15)
    assert abs(body) == pytest.approx(float(wanted["omega"].split()[0]), rel=1e-14)
    if inside:
        assert abs(body) + line == pytest.approx(float(wanted["spin relative to centre line inside"]), rel=1e-15)
        turns = float(wanted["turns per lap inside (R-r)/r"])
    else:
        # The key "outside" holds the rate of the line of centres; the turns stand under their own formula.
        turns = float(wanted["outside (R+r)/r"])
    lap = run.table["theta"].iloc[-1] / (2 * math.pi)
    assert abs(run.table["psi"].iloc[-1]) / (2 * math.pi) / lap == pytest.approx(turns, rel=1e-12)
    # No slip, independently: the point of the wheel at the contact is at rest, v_C + omega x CP = 0.
    contact = -0.5 if not inside else 0.5
    assert 1.0 + body * contact == pytest.approx(0, abs=1e-14)


def test_h29_a_start_that_does_not_close_is_refused_with_the_nearest_that_does():
    data, wanted = CASES["H29"]["data"], expected("H29")
    assert data["four-bar"].startswith("a=1,b=2,c=1.5,d=2, theta=1, phi_b=0.5, phi_c=1.6")
    run = solve(four_bar(1, 2, 1.5, 2, (1.0, 0.5, 1.6)))
    with pytest.raises(InputError) as caught:
        _ = run.motion
    found = numbers(str(caught.value))
    for residual in wanted["closure_residual"]:
        assert any(abs(value - float(residual)) < 1e-6 for value in found)
    angles = [float(angle) for angle in wanted["corrected (phi_b,phi_c) branch +"]]
    for angle in angles:
        assert any(abs(value - angle) < 5e-9 for value in found)  # nine digits are told, to be typed
    closed = closed_start(compile_closure(run.scene.equations, [1.0, 0.5, 1.6]))[1]
    assert closed == pytest.approx([1.0, *angles], rel=0, abs=1e-14)


def test_h29_a_start_that_is_a_little_open_fails_its_check_and_the_exact_motion_starts_closed():
    closed = [float(angle) for angle in expected("H29")["corrected (phi_b,phi_c) branch +"]]
    run = solve(four_bar(1, 2, 1.5, 2, (1.0, closed[0] + 1e-3, closed[1])), quantities=("table", "checks"))
    found = check(run, "START")
    assert found.verdict == "FAIL"
    assert "the nearest closed start is" in found.sentence
    assert run.exact.coordinates[0] == pytest.approx([1.0, *closed], abs=1e-12)
    rounded = solve(four_bar(1, 2, 1.5, 2, (1.0, round(closed[0], 7), round(closed[1], 7))), quantities=("table", "checks"))
    assert check(rounded, "START").verdict == "PASS"


@pytest.mark.parametrize("mode", [1, -1])
@pytest.mark.parametrize("as_group", [True, False])
def test_h32_the_branch_is_the_sign_of_the_determinant_and_is_kept(mode, as_group):
    numbers_of = [float(value) for value in expected("H32")["branch +: phi_b,phi_c,det" if mode > 0 else "branch -"]]
    a, b, c, d, theta = (float(CASES["H32"]["data"][name]) for name in ("a", "b", "c", "d", "theta"))
    text = (
        chain(a, b, c, d, theta, 6.3, mode=f"{mode:+d}") if as_group else four_bar(a, b, c, d, (theta, *numbers_of[:2]), end=6.3)
    )
    run = solve(text, "rk4")
    assert run.stop is None
    assert run.exact.coordinates[0] == pytest.approx([theta, *numbers_of[:2]], abs=1e-13)
    p, q = run.exact.column("p"), run.exact.column("q")
    assert b * c * math.sin(q[0] - p[0]) == pytest.approx(numbers_of[2], rel=1e-13)
    signs = np.sign(np.sin(q - p))
    assert np.all(signs == signs[0]) and signs[0] == mode
    for motion in (run.motion, run.exact):
        assert np.all(np.sign(motion.determinants) == np.sign(motion.determinants[0]))
    assert np.allclose(run.motion.coordinates, run.exact.coordinates, atol=1e-6)


def test_h32_a_poor_start_does_not_fall_into_the_other_assembly():
    """0.2 rad off is refused, with the assembly nearest to it and not the other one."""
    plus = [float(value) for value in expected("H32")["branch +: phi_b,phi_c,det"]]
    minus = [float(value) for value in expected("H32")["branch -"]]
    for near in (plus, minus):
        start = (0.7, near[0] + 0.2, near[1] - 0.1)
        run = solve(four_bar(1, 3, 2, 2.5, start))
        with pytest.raises(InputError) as caught:
            _ = run.motion
        assert any(abs(value - near[0]) < 5e-9 for value in numbers(str(caught.value)))  # nine digits are told
        closed = closed_start(compile_closure(run.scene.equations, start))[1]
        assert closed is not None and abs(closed[1] - near[0]) < 1e-12
