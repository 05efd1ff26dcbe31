"""Friction while forces move a mechanism: a closed form, Newton and Euler written out, what holds and what locks."""

import math

import numpy as np
import pytest

import coursework
from coursework.effects.dynamics.dynamics_checks import remainder
from coursework.report.pages import build_model, render_html
from tests.effects.test_ways import PARALLEL
from tests.mechanisms.library import mechanism
from tests.report.real import text_of as shown

BLOCK = mechanism("block-on-a-spring")
PIN = '{ radius = "20 mm", coefficient = "0.1" }'
RUBS = f'A = {PIN}\nB = {PIN}\nC = {{ coefficient = "0.1" }}'


def rubbing(name, entries, end="0.6 s"):
    changed = ("[ask]", f"[friction]\n{entries}\n\n[ask]"), ('end    = "2 s"', f'end    = "{end}"')
    return coursework.solve(coursework.parse_variant(mechanism(name, *changed)))


@pytest.mark.parametrize(("start", "speed"), [("0.5 m/s", 0.5), ("-20 cm/s", -0.2), ("0", 0.0)])
def test_a_slide_that_is_free_begins_with_a_speed_in_metres_a_second(start, speed):
    motor = coursework.parse_variant(BLOCK.replace('rates = ["u"]', f'rates = ["u"]\nstart = {{ u = "{start}" }}')).motor
    assert dict(motor.start) == {"u": pytest.approx(speed)}


def test_a_slide_that_is_free_does_not_begin_with_an_angular_velocity():
    with pytest.raises(coursework.InputError, match=r"motor[.]start[.]u: a speed was expected"):
        coursework.parse_variant(BLOCK.replace('rates = ["u"]', 'rates = ["u"]\nstart = { u = "0.5 rad/s" }'))


def test_a_block_on_a_spring_loses_the_same_of_every_swing_and_stops():
    run = coursework.solve(coursework.parse_variant(BLOCK))
    exact, least = run.scene.exact, 0.1 * 2 * 9.81 / 50
    half = np.floor(exact.t * 5 / math.pi)
    swing = (1 - least * (2 * half + 1)) * np.cos(5 * exact.t) + least * (-1) ** half
    assert np.abs(exact.column("s") - swing).max() < 1e-12
    stop = run.scene.stop
    # After 13 half swings the spring pulls less than friction holds.
    assert stop is not None and stop.kind == "held" and stop.time == pytest.approx(13 * math.pi / 5, abs=1e-9)
    assert "the pair at C comes to rest" in str(stop.sentence)
    assert run.summary.startswith("At t = 8.16814 s the pair at C comes to rest, and friction holds it")  # the rows go on
    page = shown(render_html(build_model(run, "en")))
    assert "schemes of higher order lose their order" in page and "the pair at C comes to rest" in page


def test_what_nothing_pulls_stands_in_every_row_though_the_last_time_is_rounded_beyond_the_end():
    """239 * 0.05 + 0.05 is more than 240 * 0.05: a loop that began at the end again and again had no end itself."""
    spring = 'k1 = { spring = ["O", "C"], stiffness = "50 N/m", free = "1 m" }\n'
    run = coursework.solve(coursework.parse_variant(BLOCK.replace(spring, "")), scheme="exact")
    assert run.motion.stop is None and run.motion.t[-1] == 12.0 and np.ptp(run.motion.column("s")) == 0.0
    assert run.summary.startswith("Nothing moves: the forces hold the mechanism where it stands")


@pytest.mark.parametrize("start", [179.9, 180.0, 180.1])
def test_a_slider_that_starts_from_rest_near_its_dead_centre_turns_round_there_and_goes_on(start):
    """It slides in at first, then out: its speed is 0 at the start and again where it turns, between which it is sought."""
    changes = ("[ask]", f"[friction]\n{RUBS}\n\n[ask]"), ('end    = "2 s"', 'end = "0.2 s"'), ('"0 deg"', f'"{start} deg"')
    run = coursework.solve(coursework.parse_variant(mechanism("example-2-motor", *changes)), scheme="exact")
    assert run.stop is None and len(run.motion.t) == 21
    assert np.ptp(run.motion.column("theta1")) == pytest.approx(1.2717573, abs=1e-3)
    left, exchanged = remainder(run.results.forces)
    assert np.abs(left).max() < 1e-4 * exchanged


def test_a_guide_of_some_length_bears_a_couple_at_its_two_ends():
    """The mass 0.05 m above the guide tilts the block on its ends 0.1 m apart: they bear m|a| together, where that is more than
    the weight, so the block swings as if it had a tenth more of mass while it is slowed down.
    """
    text = BLOCK.replace('C = { coefficient = "0.1" }', 'C = { coefficient = "0.1", length = "0.1 m" }')
    text = text.replace('mass = "2 kg"', 'mass = "2 kg", centre = "C + (0, 0.05)"').replace('end = "12 s"', 'end = "0.2 s"')
    exact = coursework.solve(coursework.parse_variant(text), scheme="exact").scene.exact
    assert len(exact.t) == 5
    assert np.abs(exact.column("s") - np.cos(5 / math.sqrt(1.1) * exact.t)).max() < 1e-11


# The force alone instead of the spring: 1.962 N hold the block.
PUSHED = BLOCK.replace(
    'k1 = { spring = ["O", "C"], stiffness = "50 N/m", free = "1 m" }', 'F = { on = "1", at = "C", force = "(PUSH, 0)" }'
).replace('end = "12 s"', 'end = "2 s"\nscheme = "exact"')
HOLDS = 0.1 * 2 * 9.81  # N


def pushed(push, given):
    return coursework.solve(coursework.parse_variant(PUSHED.replace("PUSH", push).replace("[points]", f"{given}\n[points]")))


def test_what_friction_holds_goes_on_when_the_force_has_grown():
    run = pushed("q*t/t1", '[given]\nq = "4 N"\nt1 = "1 s"\n')
    begins = HOLDS / 4
    after = np.maximum(run.motion.t - begins, 0.0)
    assert run.stop is None and np.count_nonzero(after) == 31
    assert run.motion.column("s") == pytest.approx(1 + 4 / 2 * after**3 / 6, abs=1e-11)
    assert run.motion.column("u") == pytest.approx(4 / 2 * after**2 / 2, abs=1e-11)
    assert run.scene.exact_accelerations[:, 0] == pytest.approx(4 / 2 * after, abs=1e-11)


@pytest.mark.long
@pytest.mark.parametrize(("more", "kind"), [(1.0, "held"), (1.0 - 1e-9, "held"), (1.0 + 1e-9, None)])
def test_a_force_as_large_as_what_friction_holds_does_not_move_it(more, kind):
    """Written so that it differs by round-off from moment to moment: nothing of it begins a motion."""
    run = pushed("q*t1/t1*(sin(t/t1)^2 + cos(t/t1)^2)", f'[given]\nq = "{HOLDS * more!r} N"\nt1 = "1 s"\n')
    assert (run.stop.kind if run.stop else None) == kind


def test_a_block_is_pushed_stands_and_is_pulled_back():
    """5 N from 0.52 s to 0.8 s, nothing to 1.53 s, then -3 N: parabolas joined by hand."""
    law = '{ pieces = [["0 s", "0"], ["0.52 s", "5"], ["0.8 s", "0"], ["1.53 s", "-3"]] }'
    run = pushed("q*g", f'[given]\nq = "1 N"\n[functions]\ng = {law}\n')
    t, up, down, back = run.motion.t, (5 - HOLDS) / 2, HOLDS / 2, (3 - HOLDS) / 2
    fast = up * 0.28
    slides = np.clip(t - 0.8, 0, fast / down)
    wanted = 1 + up * np.clip(t - 0.52, 0, 0.28) ** 2 / 2 + fast * slides - down * slides**2 / 2
    assert run.stop is None
    assert run.motion.column("s") == pytest.approx(wanted - back * np.maximum(t - 1.53, 0) ** 2 / 2, abs=1e-10)


UNRUBBED = BLOCK.replace('[friction]\nC = { coefficient = "0.1" }\n', "")


def test_a_damper_beside_the_spring_takes_its_part_of_every_swing():
    text = UNRUBBED.replace('free = "1 m"', 'free = "1 m", damping = "4 N*s/m"').replace('end = "12 s"', 'end = "2 s"')
    exact = coursework.solve(coursework.parse_variant(text), scheme="exact").scene.exact
    t, swing = exact.t, math.sqrt(24)
    assert np.abs(exact.column("s") - np.exp(-t) * (np.cos(swing * t) + np.sin(swing * t) / swing)).max() < 1e-12


@pytest.mark.parametrize(("product", "verdict"), [(2.79, "PASS"), (2.81, "COARSE")])
def test_a_spring_swings_within_what_runge_kutta_holds_a_little_below_the_root_of_eight(product, verdict):
    stiffness = 2 * (product / 0.05) ** 2
    text = UNRUBBED.replace('"50 N/m"', f'"{stiffness!r} N/m"').replace('end = "12 s"', 'end = "0.5 s"')
    run = coursework.solve(coursework.parse_variant(text), scheme="rk4")
    told = {one.code: one for one in run.results.checks}["STABLE"]
    assert told.verdict == verdict
    if verdict == "COARSE":
        assert (told.value, told.limit) == (pytest.approx(product, rel=1e-6), 2.8)
        assert told.step == pytest.approx(0.9 * 2.8 / (product / 0.05))


@pytest.mark.parametrize(("coefficient", "starts"), [("2.54", True), ("2.56", False)])
def test_it_starts_where_the_spring_pulls_more_than_friction_holds(coefficient, starts):
    """50 N of the spring against the coefficient times 19.62 N."""
    run = coursework.solve(coursework.parse_variant(BLOCK.replace('coefficient = "0.1"', f'coefficient = "{coefficient}"')))
    stop = run.scene.stop
    assert stop is not None and (stop.time > 0.5) == starts
    assert ("does not start" in str(stop.sentence)) != starts


def slider_crank(theta, w):
    """The crank's acceleration: nine laws of Newton and Euler, the closed loop, friction found by repeating them."""
    r1, r2, first, second = 0.4, 1.2, 0.2, 0.4
    theta2 = math.asin(-r1 * math.sin(theta) / r2)
    w2 = -r1 * math.cos(theta) * w / (r2 * math.cos(theta2))
    u = -r1 * math.sin(theta) * w - r2 * math.sin(theta2) * w2
    e1, e2 = (np.array([math.cos(a), math.sin(a)]) for a in (theta, theta2))
    n1, n2 = np.array([-e1[1], e1[0]]), np.array([-e2[1], e2[0]])
    weight, eye = np.array([0, -9.81]), np.eye(2)
    a, b = np.zeros((10, 10)), np.zeros(10)  # a1, a2, of the slider; forces in A, B, C, on the slider's guide
    a[:2, 0], a[:2, 1], a[0, 2], b[:2] = r1 * n1, r2 * n2, -1, r1 * w * w * e1 + r2 * w2 * w2 * e2
    a[2:4, 3:5], a[2:4, 5:7], a[2:4, 0] = eye, -eye, -4 * first * n1
    b[2:4] = -4 * first * w * w * e1 - 4 * weight
    a[4, 0], a[4, 3:5], a[4, 5:7] = -5.0533, -first * n1, -(r1 - first) * n1
    a[5:7, 5:7], a[5:7, 7:9], a[5:7, 0], a[5:7, 1] = eye, -eye, -12 * r1 * n1, -12 * second * n2
    b[5:7] = -12 * (r1 * w * w * e1 + second * w2 * w2 * e2) - 12 * weight
    a[7, 1], a[7, 5:7], a[7, 7:9] = -1.5, -second * n2, -(r2 - second) * n2
    a[8, 2], a[8, 7], a[9, 8], a[9, 9], b[9] = -20, 1, 1, 1, 20 * 9.81
    sizes = np.zeros(3)
    for _ in range(100):
        at_a, at_b = sizes[0] * np.sign(w), sizes[1] * np.sign(w2 - w)
        b[4], b[7], b[8] = -(600 - 35 * w) + at_a - at_b, at_b, 300 * u + sizes[2] * np.sign(u)
        x = np.linalg.solve(a, b)
        sizes = np.array([0.002 * np.hypot(*x[3:5]), 0.002 * np.hypot(*x[5:7]), 0.1 * abs(x[9])])
    return x[0]


def test_rows_of_a_slider_crank_are_those_of_newton_and_euler():
    run, theta, w, worst = rubbing("example-2-motor", RUBS), 0.0, 0.0, 0.0
    for row in range(61):
        own = run.motion.coordinates[row][0], run.motion.column("w1")[row]
        worst = max(worst, abs(own[0] - theta), abs(own[1] - w))
        theta, w = theta + 0.01 * w, w + 0.01 * slider_crank(theta, w)
    assert worst < 1e-12


def test_the_motion_itself_turns_round_with_its_guide_and_keeps_account_of_its_energy():
    run = rubbing("example-2-motor", RUBS)
    exact = run.scene.exact_analysis
    left, exchanged = remainder(exact)
    assert np.abs(left).max() < 1e-3 * exchanged and exact.energy.friction.min() < -10
    # From rest in a dead position the slider has neither speed nor acceleration: it rubs all the same.
    assert exact.energy.friction[1] < 0


def test_joints_of_a_falling_arm_take_energy():
    pin = '{ coefficient = "0.2", radius = "20 mm" }'
    energy = rubbing("falling-arm", f"D = {pin}\nA = {pin}").scene.exact_analysis.energy
    total = energy.kinetic + energy.potential
    assert (np.diff(total) < 0).all()


def test_a_slider_that_locks_is_told_with_its_time():
    run = rubbing("example-2-motor", 'C = { coefficient = "4" }')
    for stop in (run.scene.stop, run.motion.stop):
        assert stop is not None and stop.kind == "locked" and 0.2 < stop.time < 0.4 and "C locks" in str(stop.sentence)


@pytest.mark.parametrize(("speed", "scheme"), [("0", "euler"), ("3", "euler"), ("3", "exact")])
def test_a_mechanism_that_locks_where_it_begins_is_told_so_and_is_no_fault_of_the_tool(speed, scheme):
    begins = ('"0 deg"', '"45 deg"'), ('rates = ["w1"]', f'rates = ["w1"]\nstart = {{ w1 = "{speed} rad/s" }}')
    rubs = ("[ask]", '[friction]\nC = { coefficient = "20" }\n\n[ask]')
    run = coursework.solve(coursework.parse_variant(mechanism("example-2-motor", rubs, *begins)), scheme=scheme)
    assert run.stop.kind == "locked" and run.stop.time <= 0.01
    assert {one.verdict for one in run.checks} <= {"PASS", "SKIP"}


def test_reactions_that_are_not_unique_leave_friction_unknown():
    motor = '[motor]\nrates = ["w1"]\n1 = { torque = "1 N*m" }\n'
    text = PARALLEL.replace('[drive]\nw1 = "w0"\n', motor) + '[friction]\nA = { radius = "10 mm", coefficient = "0.1" }\n'
    with pytest.raises(coursework.InputError, match="V718"):
        coursework.solve(coursework.parse_variant(text)).motion  # noqa: B018


def test_a_pin_of_four_links_takes_the_power_that_its_friction_takes():
    """What drive, weight and friction give is what the energy grows by; the first link has no pair with itself."""
    drive = ('w1 = "a0*t"                    # from rest\n', ""), ("[drive]\n", ""), ('end    = "0.03 s"', 'end = "0.003 s"')
    moved = (
        '[friction]\nE = { radius = "1 mm", coefficient = "0.1" }\n[motor]\nrates = ["w1"]\nstart = { w1 = "20 rad/s" }\n\n[ask]'
    )
    text = mechanism("andrews-forces", *drive, ("[ask]", moved), ('"table", "checks", "forces", "energy"', '"forces"'))
    run = coursework.solve(coursework.parse_variant(text), scheme="exact")
    left, exchanged = remainder(run.results.forces)
    assert (run.results.forces.energy.friction < 0).all() and np.abs(left).max() < 1e-4 * exchanged
