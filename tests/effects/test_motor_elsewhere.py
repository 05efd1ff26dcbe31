"""A motor on a link that is not free, and one between two links: each acts where it is, so every link balances by itself."""

import numpy as np

import coursework
from tests.effects.massed import of_text, text_of
from tests.report.real import parts

CHANGES = (
    ('[drive]\nw1 = "w0"\n', ""), ('period = "2*pi/w0"\n', ""), ('Q1 = { on = "3", torque = "-60 N*m" }', ""),
    (
        "[ask]",
        '[motor]\nrates = ["w1"]\nstart = { w1 = "4 rad/s" }\n3 = { torque = "9 - 2*w3" }\n'
        '2 = { torque = "3*sin(4*t)", from = "1" }\n\n[ask]',
    ),
)  # fmt: skip


def test_a_motor_on_the_rocker_acts_there():
    found = of_text(text_of("example-1-forces", *CHANGES))
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
    run = coursework.solve(coursework.parse_variant(text_of("example-1-forces", *CHANGES)), quantities=["table", "forces"])
    compared = next(one for one in parts(run, "forces") if one.get("id") == "forces-compare")
    name, _, computed, _, _, apart = compared["rows"][-1]
    assert (name, computed, apart) == ("M", "0", "–")
