"""Equations whose motion ends at a finite time, each known in closed form: the time is told, in few steps, and no dead point."""

import math

import pytest

from coursework.words.errors import InputError
from tests.hard.scenes import numbers, scene, solve

ENDS = [
    ("k*x^2", 1.0),  # x = 1/(1 - t)
    ("k*x^3", 0.5),  # x = (1 - 2t)^-1/2
    ("k*exp(x)", math.exp(-1)),  # x = -ln(1/e - t): thirty-six only, where time cannot go on
    ("k*exp(x^2)", math.sqrt(math.pi) / 2 * math.erfc(1)),
    ("k*exp(exp(x))", 0.018732469570),  # E1(e), by mpmath
    ("k*tan(x)^2", 1 / math.tan(1) + 1 - math.pi / 2),  # x stays below pi/2
    ("k/(1.00437 - k*t)", 1.00437),
    ("k/abs(1.00437 - k*t)", 1.00437),
    ("k*tan(k*t)", math.pi / 2),
]


@pytest.mark.parametrize(("rate", "end"), ENDS, ids=[rate for rate, _ in ENDS])
def test_a_rate_without_a_bound_is_told_with_its_time(rate, end):
    text = scene('x = { start = "1 rad", rate = "w" }', given='k = "1 1/s"', step=0.01, end=3.0, equations=[f"w = {rate}"])
    run = solve(text, "rk4")
    with pytest.raises(InputError, match=r"^V526 .* grows beyond (all bounds|1e\+09 rad) about t = ") as told:
        _ = run.motion
    assert numbers(str(told.value).split("about t =")[1])[0] == pytest.approx(end, rel=1e-5)
    assert run.scene.flow.evaluations < 250_000


def test_what_only_gets_fast_for_a_moment_is_followed():
    """A turn of 2.5 rad within 1e-5 s of a run of 1000 s is no end of a motion."""
    fast = "b + a*exp(-((t - tm)/T)^2)"
    text = scene(
        'x = { start = "1 rad", rate = "w" }', given='k = "1"\na = "1.4e5 1/s"\nb = "0.001 1/s"\ntm = "500 s"\nT = "1e-5 s"',
        drive=f'u = "{fast}"', step=10.0, end=1000.0, equations=["w = k*u"],
    )  # fmt: skip
    run = solve(text, "rk4")
    assert run.scene.search.event is None
    assert run.exact.column("x")[-1] == pytest.approx(2 + 1.4 * math.sqrt(math.pi), abs=1e-7)


@pytest.mark.parametrize(("last", "is_rounding"), [("0.3 s", True), ("0.28 s", False)])
def test_a_root_that_ends_with_the_run_is_told_that_the_row_s_time_is_rounded(last, is_rounding):
    """Three steps of 0.1 s are 0.30000000000000004 s, a little behind the end of the root."""
    text = scene(
        'x = { start = "1 rad", rate = "w" }', given=f'a = "1 rad/s"\nT = "{last}"', drive='w = "a*sqrt(1 - (t/T)^2)"', step=0.1,
        end=0.3,
    )  # fmt: skip
    with pytest.raises(InputError, match="no real number" if is_rounding else "value") as told:
        _ = solve(text, "rk4").motion
    assert ("the time of a row is a product of floating-point numbers" in str(told.value)) == is_rounding


@pytest.mark.parametrize("apart", [0.3, 0.4999, 0.7])
def test_at_the_pole_of_a_tangent_a_formula_has_no_value_and_no_rate_is_blamed(apart):
    """The lever turns with 1 to 6 rad/s where it stands upright; both sides of tan(q) = y/x go to infinity there."""
    pin = 0.5 * math.cos(0.3), apart + 0.5 * math.sin(0.3)
    text = scene(
        f'th = {{ start = "0.3 rad", rate = "w" }}\nq = {{ start = "{math.atan2(pin[1], pin[0])!r} rad", rate = "wq" }}',
        given=f'a = "0.5 m"\nd = "{apart} m"', drive='w = "3"', step=0.01, end=2.5,
        closures=["tan(q) = (d + a*sin(th))/(a*cos(th))"],
    )  # fmt: skip
    with pytest.raises(InputError, match=r"^V512 .* beyond t = .* a formula has no value there") as told:
        _ = solve(text, "rk4").motion
    turned = 0.3 + 3 * numbers(str(told.value).split("beyond t =")[1])[0]  # upright once a half turn
    assert math.remainder(turned - math.pi / 2, math.pi) == pytest.approx(0.0, abs=2e-5)  # of six digits


def touching(more: float = 0.0, sharp: float = 1.0) -> str:
    """Return x' cos(x)^2 = 1 from 1 rad, `more` added to the square: x is as steep as it can be at a quarter turn."""
    return scene(
        'x = { start = "1 rad", rate = "w" }', given=f'k = "1 1/s"\nq = "{more!r}"\nm = "{sharp!r}"', step=0.001, end=0.2,
        equations=["w*(cos(x)^2 + q)*m = k*m"],
    )  # fmt: skip


@pytest.mark.parametrize("sharp", [1.0, 1e6, 1e-6])
@pytest.mark.parametrize(("more", "is_one"), [(0.0, True), (0.9e-12, True), (1.1e-12, False), (1e-6, False)])
def test_a_determinant_that_only_touches_zero_as_its_own_coordinate_moves_ends_the_motion(more, is_one, sharp):
    """t = x/2 + sin(2x)/4 less its value at the start."""
    event = solve(touching(more, sharp), "rk4").scene.search.event
    assert (event is not None) == is_one
    if event is not None:
        assert event.kind == "dead point" and event.position[0] == pytest.approx(math.pi / 2, abs=1e-8)
        assert event.time == pytest.approx(math.pi / 4 - 0.5 - math.sin(2) / 4, abs=1e-11)
