"""Why rows under forces end where no position closes: a limit of the free coordinate, links without mass, or the step."""

import math
import re

import numpy as np
import pytest
from scipy.integrate import quad

import coursework
from coursework.effects.dynamics.why_ended import CHANGE
from coursework.report.live.page import _words
from coursework.words.sentences import load_phrases
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


KITE = """format = 1
[given]
a = "0.5 m"
b = "COUPLER m"
c = "1 m"
[coordinates]
phi1 = { start = "1 rad", rate = "w1" }
phi2 = { start = "P rad", rate = "w2" }
phi3 = { start = "Q rad", rate = "w3" }
[time]
step = "0.01 s"
end = "0.7 s"
[points]
A = "(0, 0)"
B = "A + a @ phi1"
C = "B + b @ phi2"
E = "(c, 0)"
[links]
1 = { points = ["A", "B"], rate = "w1" }
2 = { points = ["B", "C"], rate = "w2" }
3 = { points = ["E", "C"], rate = "w3" }
[[constraint]]
name = "1"
closure = "a @ phi1 + b @ phi2 = (c, 0) + c @ phi3"
[frame]
hinges = ["A", "E"]
[masses]
1 = { mass = "1 kg", inertia = "rod" }
2 = { mass = "2 kg", inertia = "rod" }
3 = { mass = "1 kg", inertia = "rod" }
[motor]
rates = ["w1"]
start = { w1 = "6 rad/s" }
[ask]
quantities = ["table", "checks", "dynamics"]
"""


def placed(coupler, theta):
    """Angles of coupler and rocker of the kite by the law of cosines, and their velocities for a crank at 1 rad/s."""
    pin = 0.5 * np.exp(1j * theta)
    away = 1 - pin
    p = np.angle(away) + math.acos((coupler**2 + abs(away) ** 2 - 1) / (2 * coupler * abs(away)))
    q = np.angle(pin + coupler * np.exp(1j * p) - 1)
    return p, q, -0.5 * math.sin(theta - q) / (coupler * math.sin(p - q)), 0.5 * math.sin(theta - p) / math.sin(q - p)


def inertia(coupler, theta):
    """The inertia of three rods of 1, 2 and 1 kg, reduced to the crank."""
    p, _, k2, k3 = placed(coupler, theta)
    middle = 0.5 * np.exp(1j * theta) + k2 * coupler / 2 * np.exp(1j * p)
    return 0.25 / 3 + k3**2 / 3 + 2 * abs(middle) ** 2 + 2 * coupler**2 / 12 * k2**2


@pytest.mark.parametrize(("coupler", "kind", "told"), [
    (0.5, CHANGE, "links lie in one line at a change point: two motions meet there, and phi1 moves on in both"),
    (0.4995, "dead point", "(phi1) is at its limit"), (0.5005, None, ""),
])  # fmt: skip
@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_a_crank_that_comes_to_a_change_point_does_not_turn_back(coupler, kind, told, scheme):
    """Nothing gives energy: dt = sqrt(J(theta)/J(1)) dtheta/6.  A coupler a thousandth shorter is a limit, a longer passes."""
    p, q = map(float, placed(coupler, 1.0)[:2])
    text = KITE.replace("COUPLER", repr(coupler)).replace("P rad", f"{p!r} rad").replace("Q rad", f"{q!r} rad")
    stop = coursework.solve(coursework.parse_variant(text), scheme=scheme).scene.stop
    assert (stop.kind if stop else None) == kind
    if stop is not None:
        last = math.pi if kind == CHANGE else math.acos((1.25 - (1 + coupler) ** 2) / 1.0)
        whole, _ = quad(lambda theta: math.sqrt(inertia(coupler, theta) / inertia(coupler, 1.0)) / 6, 1.0, last, limit=200)
        assert ("the two motions would stay apart" in stop.meaning) == (kind == CHANGE)
        assert told in stop.cause and stop.time == pytest.approx(whole, abs=2e-8 if kind == CHANGE else 2e-5)


@pytest.mark.parametrize("scheme", ["exact", "rk4"])
def test_parallel_cranks_go_through_their_change_point_and_it_is_told(scheme):
    """J = 2 m a^2/3 + m2 a^2 is the same everywhere: the angle grows as w t + M/J t^2/2, and at pi all links lie in one line."""
    text = KITE.replace("COUPLER", "1.0").replace('c = "1 m"', 'c = "1 m"\nM = "2 N*m"').replace("c @ phi3", "a @ phi3")
    text = re.sub(r'start = "[PQ1] rad"', lambda found: f'start = "{0.0 if "P" in found[0] else 2.0} rad"', text)
    text = text.replace("[motor]", '[forces]\npush = { on = "1", torque = "M" }\n[motor]')
    run = coursework.solve(coursework.parse_variant(text), scheme=scheme, quantities=("table", "checks"))
    at = 2 * (math.pi - 2) / (6 + math.sqrt(36 + 4 * 2 / (2 * (2 * 0.25 / 3 + 2 * 0.25)) * (math.pi - 2)))
    assert run.stop is None
    told = re.search(r"At t = ([0-9.]+) s links lie in one line at a change point: two motions meet there", run.summary)
    assert float(told[1]) == pytest.approx(at, abs=1e-6)
    assert run.motion.notes == run.scene.passed
    assert _words(load_phrases(), run)["dead"] == "The motion is followed here up to t = {t} s only."  # it does not stop


SLEEVE = f"""format = 1
[given]
r = "0.3 m"
[coordinates]
a = {{ start = "-0.5 rad", rate = "w1" }}
b = {{ start = "{math.pi / 2 - 0.25!r} rad", rate = "w" }}
s = {{ start = "{-0.6 * math.sin(0.25)!r} m", rate = "u" }}
[time]
step = "0.01 s"
end = "0.6 s"
[points]
O = "(0, 0)"
A = "O + r @ a"
S = "(r, 0)"
E = "A + r @ b"
[links]
1 = {{ points = ["O", "A"], rate = "w1" }}
2 = {{ points = ["A", "E"], rate = "w" }}
3 = {{ points = ["S"], slides = 2, rate = "w" }}
[frame]
hinges = ["O", "S"]
[[constraint]]
name = "1"
closure = "r @ a = (r, 0) + s @ b"
[masses]
1 = {{ mass = "1 kg", inertia = "rod" }}
2 = {{ mass = "0.5 kg", inertia = "0.01 kg*m^2", centre = "A" }}
3 = {{ mass = "0.1 kg", inertia = "0.001 kg*m^2", centre = "S" }}
[forces]
push = {{ on = "1", torque = "0.02 N*m" }}
[motor]
rates = ["w1"]
start = {{ w1 = "1 rad/s" }}
"""


def test_a_crank_whose_end_comes_to_the_pivot_of_its_sleeve_has_one_motion_only():
    """The angle at the circumference, b' = a'/2 throughout: J = m r^2/3 + m2 r^2 + (J2 + J3)/4."""
    stop = coursework.solve(coursework.parse_variant(SLEEVE), scheme="exact").scene.stop
    speedup = 0.02 / (0.03 + 0.045 + 0.011 / 4)
    assert stop.time == pytest.approx((math.sqrt(1 + speedup) - 1) / speedup, abs=1e-8)
    assert stop.kind == CHANGE and "Only one motion goes on" in stop.cause and "started there anew" in stop.meaning


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
