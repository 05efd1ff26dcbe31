"""An equation that gives an angle by itself, q = atan2(y, x), holds up to whole turns: its links do not know of them."""

import math

import numpy as np
import pytest

import coursework
from tests.hard.scenes import check, scene, solve

CRANK, APART, FIRST, SPEED = 0.5, 0.3, 4.2, 3.0


def lever(t):
    """Return the angle of the lever to a crank pin, which goes right round with the crank, without jumps."""
    pin = CRANK * np.exp(1j * (FIRST + SPEED * np.asarray(t))) + 1j * APART
    return np.unwrap(np.angle(pin))


def asked(closure, turns=0.0, off=0.0):
    start = float(lever([0.0])[0]) + 2 * math.pi * turns + off
    return scene(
        f'th = {{ start = "{FIRST} rad", rate = "w" }}\nq = {{ start = "{start!r} rad", rate = "wq" }}',
        given=f'a = "{CRANK} m"\nd = "{APART} m"', drive=f'w = "{SPEED}"', step=0.01, end=2.5, closures=[closure],
    )  # fmt: skip


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
@pytest.mark.parametrize("turns", [0, 1, -3])
@pytest.mark.parametrize("closure", ["q = atan2(d + a*sin(th), a*cos(th))", "atan2(d + a*sin(th), a*cos(th)) - q = 0"])
def test_a_lever_that_goes_right_round_meets_in_every_row(closure, turns, scheme):
    run = solve(asked(closure, turns), scheme, quantities=("table", "checks"))
    assert run.passed and check(run, "DRIFT").verdict == "PASS"
    wanted = lever(run.table.index) + 2 * math.pi * turns
    assert np.ptp(wanted) > 2 * math.pi and run.exact.column("q") == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(("off", "is_closed"), [(0.004, True), (0.006, False)])
def test_a_start_may_be_off_by_whole_turns_and_a_hundredth_of_the_largest_length(off, is_closed):
    run = solve(asked("q = atan2(d + a*sin(th), a*cos(th))", 1, off))
    if is_closed:
        assert run.exact.column("q")[0] == pytest.approx(float(lever([0.0])[0]) + 2 * math.pi, abs=1e-12)
    else:
        with pytest.raises(coursework.InputError, match=r"V313 .*residuals 1: 0\.006 "):
            run.compute()


def test_a_jump_of_half_a_turn_still_is_one():
    """An arctangent knows the line of the lever and not its direction."""
    run = solve(asked("q = atan((d + a*sin(th))/(a*cos(th))) + pi", 0, 2 * math.pi), "rk4", quantities=("table", "checks"))
    drift = check(run, "DRIFT")
    assert drift.verdict == "FAIL" and "jumps between rows" in drift.sentence
