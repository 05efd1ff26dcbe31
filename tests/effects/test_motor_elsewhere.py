"""A motor on a link that is not free, and one between two links: each acts where it is, so every link balances by itself."""

import json

import numpy as np
import pytest

import coursework
from coursework.scene.quantities import plans
from tests.effects.massed import of_text
from tests.mechanisms.library import changed, mechanism
from tests.report.real import parts
from tests.solved import solved

CHANGES = (
    ('[drive]\nw1 = "w0"\n', ""), ('period = "2*pi/w0"\n', ""), ('Q1 = { on = "3", torque = "-60 N*m" }', ""),
    (
        "[ask]",
        '[motor]\nrates = ["w1"]\nstart = { w1 = "4 rad/s" }\n3 = { torque = "9 - 2*w3" }\n'
        '2 = { torque = "3*sin(4*t)", from = "1" }\n\n[ask]',
    ),
)  # fmt: skip


def test_a_motor_on_the_rocker_acts_there():
    found = of_text(mechanism("example-1-forces", *CHANGES))
    motion = found.rows.motion
    q = [np.exp(1j * motion.column(f"theta{place}")) for place in (1, 2, 3)]
    b, c = 0.4 * q[0], 1.2 + 0.7 * q[2]

    def force(name):
        return found.column(f"{name}x") + 1j * found.column(f"{name}y")

    between = 3 * np.sin(4 * motion.t)
    links = [
        (4, 0.0533, b / 2, [(force("R01"), 0 * b), (-force("R12"), b)], found.column("M") - between),
        (10, 0.833, (b + c) / 2, [(force("R12"), b), (-force("R23"), c)], between),
        (7, 0.286, (1.2 + c) / 2, [(force("R23") - 200, c), (force("R03"), 1.2 + 0 * c)], 9 - 2 * motion.column("w3")),
    ]  # fmt: skip
    largest = found.reactions.largest
    for place, (mass, inertia, centre, forces, couple) in enumerate(links, start=1):
        second = found.beside[f"S{place}.ax"] + 1j * found.beside[f"S{place}.ay"]
        total = sum(one for one, _ in forces) - 9.81j * mass - mass * second
        moment = sum((np.conj(at - centre) * one).imag for one, at in forces) + couple - inertia * found.beside[f"e{place}"]
        assert np.abs(total).max() < 1e-11 * largest and np.abs(moment).max() < 1e-11 * largest, place
    assert np.abs(found.column("M")).max() < 1e-11 * largest  # nothing turns the crank from the frame
    given = (9 - 2 * motion.column("w3")) * motion.column("w3") + between * (motion.column("w2") - motion.column("w1"))
    assert np.abs(found.energy.drive - given).max() < 1e-9 * np.abs(given).max()


def test_the_page_prints_no_round_off_for_what_is_nothing():
    run = coursework.solve(coursework.parse_variant(mechanism("example-1-forces", *CHANGES)), quantities=["table", "forces"])
    compared = next(one for one in parts(run, "forces") if one.get("id") == "forces-compare")
    name, _, computed, _, _, apart = compared["rows"][-1]
    assert (name, computed, apart) == ([{"v": "M", "s": ""}], "0", "–")


WHEEL = mechanism("flywheel")


def test_a_torque_of_the_time_turns_a_wheel_as_its_integrals_say():
    """J dw/dt = M0 cos pt from rest: w = M0/(J p) sin pt, phi = phi(0) + M0/(J p^2) (1 - cos pt)."""
    motion = coursework.solve(coursework.parse_variant(WHEEL), "exact").motion
    assert motion.column("w") == pytest.approx(3 / (0.5 * 7) * np.sin(7 * motion.t), abs=1e-10)
    assert motion.column("phi") == pytest.approx(0.2 + 3 / (0.5 * 49) * (1 - np.cos(7 * motion.t)), abs=1e-10)


def test_the_determinants_of_a_motion_under_forces_are_those_of_its_blocks():
    """A slider-crank: r2 cos(theta2) for the rod, the unit that the speed of the slider has for the other one."""
    motion = solved("example-2-motor").motion
    assert motion.determinants[:, 0] == pytest.approx(1.2 * np.cos(motion.column("theta2")), rel=1e-12)
    assert motion.determinants.shape[1] == 2 and set(np.abs(motion.determinants[:, 1])) == {1.0}


def test_points_keep_to_their_guides_also_in_their_accelerations():
    """The slider's acceleration is that of its column, the crank pin's has a tangential part; the plan says the same."""
    run, row = solved("example-2-motor", quantities=["accelerations", "points", "plans"]), 11
    motion, (names, moved) = run.motion, run.results.point_accelerations
    second = dict(zip(motion.velocity_names, run.results.accelerations.T, strict=True))

    def point(name):
        return moved[:, names.index(f"{name}.ax")] + 1j * moved[:, names.index(f"{name}.ay")]

    assert point("C") == pytest.approx(second["u3"], abs=1e-9 * np.abs(second["u3"]).max())
    spun = 0.4 * (1j * second["w1"] - motion.column("w1") ** 2) * np.exp(1j * motion.column("theta1"))
    assert point("B") == pytest.approx(spun, rel=1e-9)
    (drawn,) = [
        complex(x, y)
        for place, _, made, plan, kind, _, to, x, y, _ in plans.of(run.results).rows()
        if (place, made, plan, kind, to) == (row + 1, "table", "acceleration", "absolute", "B")
    ]
    assert drawn == pytest.approx(spun[row], rel=1e-9)
    shown = json.dumps([part for part in parts(run, "accelerations") if part["kind"] == "equations"], ensure_ascii=False)
    assert f"{second['w2'][run.variant.time.row_of_check - 1]:.5g}".lstrip("-") in shown


LOOP = mechanism(
    "four-bar-loop", ('[drive]\nw1 = "n"\n', ""), ('[points]\nA = "a', '[points]\nO = "(0, 0)"\nD = "(d, 0)"\nA = "O + a'),
    ("(d, 0) + c @ phi3", "B"), ("[time]", 'B = "D + c @ phi3"\n[time]'), period=None, end="0.2 s",
) + """
[links]
1 = { points = ["O", "A"], rate = "w1" }
2 = { points = ["A", "B"], rate = "w2" }
3 = { points = ["D", "B"], rate = "w3" }
[frame]
hinges = ["O", "D"]
[masses]
1 = { mass = "1 kg", inertia = "rod" }
2 = { mass = "2 kg", inertia = "rod" }
3 = { mass = "3 kg", inertia = "rod" }
[forces]
gravity = "9.81 m/s^2"
[motor]
rates = ["w1"]
[ask]
quantities = ["table", "checks", "dynamics", "energy"]
"""  # fmt: skip


def test_under_forces_a_start_that_is_open_is_told_and_rods_have_the_length_of_the_closed_one():
    """The rod, as long as its ends were apart before they were brought together, was too light: energy came from nowhere."""
    runs = [
        coursework.solve(coursework.parse_variant(changed(LOOP, ("0.57204749", start))), "exact", quantities=["checks", "energy"])
        for start in ("0.57204749", "0.571")
    ]
    for run, open_ones in zip(runs, ([], ["START"]), strict=True):
        assert [one.code for one in run.checks if one.verdict == "FAIL"] == open_ones
        assert next(one.value for one in run.checks if one.code == "ENERGY") < 1e-9
    assert np.abs(runs[0].table.to_numpy() - runs[1].table.to_numpy()).max() < 1e-9
    with pytest.raises(coursework.InputError, match=r"V313 .* the start values violate the closure"):
        _ = coursework.solve(coursework.parse_variant(changed(LOOP, ("0.5720474966558032", "0.5")))).table


WRITTEN = changed(
    LOOP, ("[[constraint]]\nclosure = \"A + b @ phi2 = B\"", """[closure]
holds = ["a*cos(phi1) + b*cos(phi2) - c*cos(phi3)", "a*sin(phi1) + b*sin(phi2) - c*sin(phi3)"]
[[constraint]]
name = "x"
equation = "a*w1*sin(phi1) + b*w2*sin(phi2) - c*w3*sin(phi3) = 0"
[[constraint]]
name = "y"
equation = "a*w1*cos(phi1) + b*w2*cos(phi2) - c*w3*cos(phi3) = 0"
"""),
)  # fmt: skip


@pytest.mark.parametrize("place", ["w1*sin", "w1*cos"])
def test_under_forces_an_equation_with_a_wrong_sign_is_refused(place):
    """From rest every sign looks right."""
    run = coursework.solve(coursework.parse_variant(changed(WRITTEN, (f"a*{place}", f"-a*{place}"))))
    with pytest.raises(coursework.InputError, match=r"V302 .* contradicts the geometry"):
        _ = run.table
    of_loop = coursework.solve(coursework.parse_variant(LOOP)).table
    assert np.abs(coursework.solve(coursework.parse_variant(WRITTEN)).table.to_numpy() - of_loop.to_numpy()).max() < 1e-9


def test_a_slider_whose_pin_has_no_name_is_as_heavy_as_one_with_a_name():
    """Its centre of mass was taken to lie still at the origin."""
    text = mechanism("example-2-motor", ('rails  = [ { through = "C", angle = "0" } ]\n', "")).split("# --- texts")[0]
    begin, rest = text.split("[links]")
    text = changed(begin + "[frame]" + rest.split("[frame]")[1], ('C = { mass = "20 kg"', '3 = { mass = "20 kg"'))
    nameless = changed(text, ('meets       = "C"\n', ""), ('on = "3", at = "C"', 'on = "3", at = "(s3, 0)"'))
    one, other = (coursework.solve(coursework.parse_variant(each), end=0.2).table for each in (text, nameless))
    assert np.abs(one.to_numpy() - other.to_numpy()).max() < 1e-9
