"""Why rows under forces end where no position closes: a limit of the free coordinate, links without mass, or the step."""

import math

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics.why_ended import _vanishes
from tests.effects.dynamics.test_dynamics import rod_of
from tests.mechanisms.library import mechanism


def piston(free, scheme="exact", **options):
    return coursework.solve(
        coursework.parse_variant(mechanism("slider-crank-under-a-force", rates=f'["{free}"]')), scheme=scheme, **options
    )


@pytest.fixture(scope="module")
def led_by_its_crank():
    return piston("w1").motion


@pytest.mark.long
def test_a_piston_that_leads_stops_at_its_dead_centre_and_the_crank_that_leads_passes_it(led_by_its_crank):
    run, whole = piston("u3"), led_by_its_crank
    assert run.stop.kind == "dead point"
    assert whole.stop is None and len(whole.t) == 301
    assert run.stop.time == pytest.approx(np.interp(math.pi, whole.column("theta1"), whole.t), abs=2e-5)
    rows = len(run.motion.t) - 1
    assert np.abs(run.motion.rows[:rows] - whole.rows[:rows]).max() < 1e-4 * np.abs(whole.rows).max()
    assert "(s3) is at its limit" in run.stop.cause and "such as w1 or w2" in run.stop.meaning


@pytest.mark.long
def test_rows_of_a_scheme_that_reach_the_limit_are_told_so():
    run = piston("u3", "rk4", step=0.0005)
    assert run.motion.stop.kind == "dead point" and run.motion.stop.time == pytest.approx(0.3826, abs=1e-3)


def test_rows_that_go_on_beyond_the_limit_are_judged_up_to_it_and_not_called_unknown_as_well():
    run = piston("u3", "semi-implicit", step=0.02)
    assert len(run.motion.t) > len(piston("u3", step=0.02).motion.t) == 20
    assert "in row 20" in run.summary and "Beyond row 20 the motion itself is not followed" in run.summary
    assert "how close the table is" not in run.summary


ROOT, POLE = "c*sqrt(1 - t/0.3)*u3", "c*u3/(t - 0.1)*t"


@pytest.mark.parametrize(("scheme", "law"), [("exact", ROOT), ("euler", ROOT), ("rk4", ROOT), ("euler", POLE)])
def test_a_force_without_a_value_is_charged_and_not_the_links(scheme, law):
    text = mechanism("example-2-motor", ("(-c*u3, 0)", f"(-{law}, 0)"))
    why = "no real number" if law == ROOT else "division by zero"
    with pytest.raises(coursework.InputError, match=rf"V019 bad.toml:\d+  forces.F1, column \d+: .*{why}"):
        _ = coursework.solve(coursework.parse_variant(text, "bad.toml"), scheme=scheme).motion


DISC = """format = 1
[given]
wn = "5 rad/s"
M0 = "10 N*m"
[coordinates]
phi1 = { start = "0 rad", rate = "w1" }
[time]
step = "0.3 s"
end = "3 s"
[points]
D = "(0, 0)"
A = "D + 1 @ phi1"
[links]
1 = { points = ["D", "A"], rate = "w1" }
[frame]
hinges = ["D"]
[masses]
1 = { mass = "3 kg", inertia = "rod" }
[motor]
rates = ["w1"]
1 = { torque = "M0*sqrt(1 - w1/wn)" }
"""


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_a_law_that_a_row_leaves_ends_the_rows_before_it(scheme):
    """J = 1 kg*m^2 and w' = 10*sqrt(1 - w/5): w = 5 - 5*(1 - t)^2, and Euler's w is 0, 3, 4.897 and then above 5."""
    run = coursework.solve(coursework.parse_variant(DISC, "disc.toml"), scheme=scheme)
    stop, known = run.motion.stop, [0, 3, 3 + 3 * math.sqrt(0.4)]
    assert (stop.kind, stop.time) == ("no value", pytest.approx(0.9, abs=0.31 if scheme == "rk4" else 1e-9))
    assert "motor.1, column 4: there is no value at t = " in stop.cause and '"sqrt(1 - w1/wn)" is no real number' in stop.cause
    assert "The rows up to row 3 are valid" in stop.meaning and "shorter step" in stop.meaning
    wanted = known if scheme == "euler" else (5 - 5 * (1 - np.arange(3) * 0.3) ** 2).tolist()
    assert run.motion.column("w1").tolist() == pytest.approx(wanted, abs=0.02 if scheme == "rk4" else 1e-9)


def test_links_without_mass_would_have_to_stretch():
    """A heavy crank drives a rod that is too short for it, and nothing but the crank has a mass: it hits its limit."""
    text = rod_of(r=0.36, M1=1, T=0)
    kept = "".join(line for line in text.splitlines(keepends=True) if "M2 kg" not in line and not line.startswith("C = { mass"))
    run = coursework.solve(coursework.parse_variant(kept), scheme="exact")
    assert run.stop.kind == "dead point" and "would have to stretch" in run.stop.cause
    assert abs(run.motion.column("w1")[-1]) > 1


def test_a_step_that_is_too_wide_for_the_links_is_the_step_of_the_scheme():
    """At 2 rad/s from 0.5 rad one step of 0.5 s asks for 1.5 rad, and arcsin(35/36) is 1.335 rad; weight slows the motion."""
    variant = coursework.parse_variant(rod_of(r=0.36, M1=1, M2=2, T=0))
    run = coursework.solve(variant, scheme="euler", step=0.5, end=0.5)
    assert run.stop is run.motion.stop and run.scene.stop is None
    assert run.stop.kind == "step too large" and "no dead point" in run.stop.cause


def test_what_grows_beside_a_limit_is_no_force_that_falls_with_the_speed():
    """The piston's equation has no damper: what makes slopes steep in the last rows is its inertia, without bounds there."""
    found = {check.code: check for check in piston("u3", "euler", step=0.01).checks}
    assert found["STABLE"].verdict != "COARSE" and found["ENERGY"].verdict == "COARSE"


BLOCK = """format = 1
[given]
k = "200 N/mm"
al = "30 deg"
[coordinates]
x = { start = "0.01 m", rate = "v" }
[time]
step = "0.5 ms"
end = "0.1 s"
[points]
S = "x @ (-al)"
[links]
1 = { points = ["S"] }
[frame]
rails = [{ through = "S", angle = "-al" }]
[masses]
1 = "2 kg"
[forces]
stop = { on = "1", at = "S", force = "(-k*x) @ (-al)" }
[motor]
rates = ["v"]
"""


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_a_block_that_swings_as_far_as_its_mechanism_is_long_does_not_go_off_the_scale(scheme):
    """x = X cos(w t) at 3e9 m/s."""
    text = BLOCK.replace("[given]", '[given]\nX = "1e7 m"').replace("0.01 m", "1e7 m").replace('"0.1 s"', '"0.02 s"')
    motion = coursework.solve(coursework.parse_variant(text), scheme=scheme).motion
    assert len(motion.t) == 41
    assert motion.column("x") == pytest.approx(
        1e7 * np.cos(math.sqrt(1e5) * motion.t), abs=1e-12 * 1e7 if scheme == "exact" else 1e3
    )


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_a_spring_of_the_wrong_sign_is_told_not_to_need_a_shorter_step(scheme):
    """x = x0 cosh(w t), w^2 = k/m; the scale ends at 1e9 m/s."""
    stop = coursework.solve(coursework.parse_variant(BLOCK.replace("-k*x", "k*x")), scheme=scheme).stop
    rate = math.sqrt(2e5 / 2)
    assert stop.time == pytest.approx(math.acosh(1e9 / (0.01 * rate)) / rate, abs=1.1e-3)
    assert "in the exact motion too" in stop.cause and "no shorter step helps" in stop.meaning


def test_a_rail_across_the_motion_of_a_block_under_forces_is_told_with_both_angles():
    text = BLOCK.replace('S", angle = "-al"', 'S", angle = "al"')
    with pytest.raises(coursework.InputError, match=r"V316 .*lies at 30°, and S moves along -30°. Write angle = .-30 deg"):
        _ = coursework.solve(coursework.parse_variant(text), scheme="exact", quantities=("table", "checks")).checks


def test_a_rail_across_a_block_that_rests_on_it_is_told_though_nothing_moves():
    """Gravity alone acts, along the rail and across the only way that S has; along that way, to a fiftieth, it simply rests."""
    text = BLOCK.replace("x @ (-al)", "(x, 0)").replace(
        'stop = { on = "1", at = "S", force = "(-k*x) @ (-al)" }', 'gravity = "9.81"'
    )
    rails = {angle: coursework.parse_variant(text.replace('"-al"', f'"{angle}"')) for angle in ("90 deg", "1 deg", "2 deg")}
    for angle, told in ("90 deg", "lies at 90°, and S moves along 0°"), ("2 deg", "lies at 2°, and S moves along 0°"):
        with pytest.raises(coursework.InputError, match=f"V316 .*{told}"):
            _ = coursework.solve(rails[angle], quantities=("table", "checks")).checks
    assert "Nothing moves" in coursework.solve(rails["1 deg"], quantities=("table", "checks")).summary


@pytest.mark.parametrize("way", [lambda d: 0.7 - 0.2 * np.expm1(d), lambda d: 0.7 - 0.3 * d**2 + 0.1 * d**5])
def test_the_time_of_a_limit_is_read_from_a_determinant_that_falls_evenly_or_as_a_root(way):
    """The last states say nothing: where a determinant is a hundred-thousandth, so are the digits of its position."""
    sizes = np.append([1.0, *0.4 * 0.7 ** np.arange(24)], [3e-5, 2e-6])
    t = way(sizes)
    t[-2:] += 1e-6
    assert _vanishes(t, sizes) == pytest.approx(0.7, abs=1e-12)
    rough = sizes * (1 + 0.4 * (-1) ** np.arange(27))  # the polynomial through these is anything
    assert abs(_vanishes(t, rough) - t[-1]) < t[-1] - t[0]
