"""A length or an angle that a drive changes and no link has: the force along it, the couple at its joint, by two programs."""

import re

import numpy as np
import pytest

import coursework
from coursework.effects.draft import with_forces
from coursework.effects.rows import SECOND
from coursework.report.pages import build_model, render_html
from coursework.variant.formula.reader import parse
from tests.effects.massed import of_text
from tests.mechanisms.library import changed, mechanism

# A slider-crank whose crank turns clockwise and has a driven length.
REACHING = mechanism(
    "slider-crank", ("[time]", 'r = { start = "100 mm", rate = "vr" }\n[time]'), ('"0 deg"', '"75 deg"'),
    ("[drive]", 'v = "100 mm/s"\np = "2 1/s"\n[drive]\nvr = "v*cos(p*t)"'), r=None, l="50 cm", e="2 cm", n="-90 rpm",
    step="0.5 s", end="2 s", period=None,
)  # fmt: skip
HEAVY = """[masses]
1 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
2 = { mass = "1 kg", inertia = "rod" }
3 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
4 = { mass = "1 kg" }
[forces]
gravity = "9.81 m/s^2"
F1 = { on = "4", at = "C", force = "(-100, 0)" }
"""


def test_both_drives_of_a_crank_of_driven_length_are_those_of_lagrange():
    """Couple and force along the crank at 0, 0.5 and 2 s: Lagrange's equations of (phi1, r) by differences, another program."""
    found = of_text(REACHING + HEAVY)
    assert found.drive_names == ("M1", "F3")
    drives = np.stack([found.column(name) for name in found.drive_names], axis=1)[[0, 1, 4]]
    assert drives == pytest.approx(
        np.array([[-10.05547, 13.43637], [-5.95087, -126.29129], [-5.55876, 24.44725]]), abs=2e-5, rel=1e-5
    )


def test_a_length_along_a_swinging_bar_is_driven_from_the_bar():
    """By hand, Lagrange's equations of (psi, s) at the start, where both change evenly."""
    text = mechanism("wheel-on-a-bar")
    found = of_text(with_forces(coursework.parse_variant(text), text, str))  # 1 kg each, 100 N to the left at C
    psi, s, radius, w, u = np.deg2rad(20.0), 0.3, 0.1, 0.4, 0.3
    height = s * np.cos(psi) - radius * np.sin(psi)  # change of the height of C with psi
    couple = 2 * s * u * w + 9.81 * height - 100 * (s * np.sin(psi) + radius * np.cos(psi))
    force = -s * w**2 + 9.81 * np.sin(psi) + 100 * np.cos(psi)
    assert [float(found.column(name)[0]) for name in ("M1", "Fus")] == pytest.approx([couple, force], rel=1e-12)
    assert found.by_power == pytest.approx(np.column_stack([found.column("M1"), found.column("Fus")]), rel=1e-10, abs=1e-10)


def test_a_bar_that_turns_against_its_angle_is_turned_by_a_couple_on_it():
    """The centre of the trammel's bar runs round a circle evenly: by the power of its weight, M = -m g l/2 cos(th)."""
    text = mechanism(
        "trammel", ('V*cos(k*t)"\n', '"\n'), ('u = "', 'w = "k'), ('"w" }\n[frame]', '"om" }\n[frame]'), ('B", "E"]', 'B"]'),
        ("[time]", '[unknowns]\nom = "1/s"\n[time]'), ("[closure]", '[[constraint]]\nequation = "om = -w"\n[closure]'),
    )  # fmt: skip
    weight = '[masses]\n1 = { mass = "2 kg", inertia = "rod" }\n[forces]\ngravity = "9.81 m/s^2"\n'
    found = of_text(text + weight, scheme="exact")
    wanted = -2 * 9.81 * 0.15 * np.cos(found.rows.motion.column("th"))
    assert found.column("M") == pytest.approx(wanted, abs=1e-12)
    assert found.by_power[:, 0] == pytest.approx(wanted, abs=1e-12)
    with pytest.raises(coursework.InputError, match=r"V309 .*declare a name in \[unknowns\], set it equal to -w in"):
        of_text(text.replace('rate = "om"', 'rate = "w"') + weight)


def test_a_link_that_forces_move_and_that_turns_the_other_way_round_is_told_and_its_advice_holds():
    """An angle from the vertical, clockwise: at 20 degrees the end is where the file's own angle has it at 70."""
    begun = ('"rod" }', '"rod", centre = "B - (0.1*sin(phi), 0.1*cos(phi))" }'), ("0.6 @ phi", "(0.6*sin(phi), 0.6*cos(phi))")
    text = mechanism("pendulum", *begun, phi='{ start = "20 deg", rate = "w" }')
    with pytest.raises(coursework.InputError, match=r"V731 .*link 1 turns just the other way round than its rate w: .* to -w in"):
        of_text(text, scheme="exact")
    named = ("[points]", '[[constraint]]\nequation = "wc = -w"\n[points]'), ("[time]", '[unknowns]\nwc = "1/s"\n[time]')
    followed = changed(text, *named, ('"B"], rate = "w"', '"B"], rate = "wc"'))
    plain = mechanism("pendulum", ('"rod" }', '"rod", centre = "B - 0.1 @ phi" }'), phi='{ start = "70 deg", rate = "w" }')
    own, other = (of_text(each, scheme="exact").rows.motion.column("phi") for each in (followed, plain))
    assert own + other == pytest.approx(np.full(len(own), np.pi / 2), abs=1e-9)


def test_a_bar_that_a_wheel_rolls_on_is_no_disc():
    text = mechanism("wheel-on-a-bar")
    bar, wheel = re.findall("^[12] = .*mass.*", with_forces(coursework.parse_variant(text), text, str), flags=re.M)
    assert "disc" in wheel and "disc" not in bar


def test_a_link_without_a_rate_gets_the_inertia_that_a_run_asks_for():
    text = mechanism("arm-driven-at-its-joints", ('"A"], rate = "w1"', '"A"]'), (', rate = "W2" }', " }"))
    bare = text.partition("[masses]")[0] + "[ask]" + text.partition("[ask]")[2]
    both = with_forces(coursework.parse_variant(bare), bare, str)
    assert re.findall('^[12] = .*mass.*inertia = "rod" }', both, flags=re.M) == re.findall("^[12] = .*mass.*", both, flags=re.M)
    assert of_text(both).rows.count


@pytest.mark.parametrize("named", [True, False])
def test_an_angle_from_link_to_link_is_driven_by_a_couple_at_the_joint(named):
    """By Newton's laws of the forearm alone, then of the whole arm; the same if [links] does not name the rates."""
    changes = [] if named else [('"A"], rate = "w1"', '"A"]'), (', rate = "W2" }', " }")]
    found = of_text(mechanism("arm-driven-at-its-joints", *changes))
    rows, g = found.rows, 9.81j
    first, second = (rows.vector(rows.scheme.by_name[name].centre, SECOND) for name in "12")
    pin = 1.0 * (second + g)
    assert found.drive_names == ("M1", "Mw2") if named else ("Mw1", "Mw2")
    assert found.column("R12x") + 1j * found.column("R12y") == pytest.approx(pin, rel=1e-11)
    assert found.column("R01x") + 1j * found.column("R01y") == pytest.approx(pin + 2.0 * (first + g), rel=1e-11)
    arm = rows.vector(rows.scheme.by_name["2"].centre) - rows.vector(parse("A", vectors=True))
    turned = 0.3**2 / 12 * rows.epsilon(rows.scheme.by_name["2"])
    assert found.column("Mw2") == pytest.approx(turned + (np.conj(arm) * pin).imag, rel=1e-11)
    if named:
        assert found.by_power == pytest.approx(np.column_stack([found.column("M1"), found.column("Mw2")]), rel=1e-10)


@pytest.mark.parametrize("loop", ["B + s @ psi = C", "B + s @ psi = A + c @ phi", "0*A - C + s @ psi = -(xB, yB)"])
def test_the_rod_of_a_cylinder_is_pushed_at_its_pin_and_the_boom_feels_it_there(loop):
    """By hand: moments of the boom about A, then of the rod, which carries nothing but the pin C and the barrel."""
    named = ('C = "A + c @ phi"', 'C = "A + c @ phi"' if "C" in loop else 'C = "B + s @ psi"')
    text = mechanism("boom", ("B + s @ psi = C", loop), named)
    heavy = '[masses]\n1 = { mass = "90 kg", inertia = "rod" }\n[forces]\ngravity = "9.81 m/s^2"\n'
    found = of_text(text + heavy)
    phi, psi, e = (found.rows.motion.column("phi"), found.rows.motion.column("psi"), found.beside["e1"])
    push = (90 * 9.81 * 0.65 * np.cos(phi) + 90 * 1.3**2 / 3 * e) / (1.3 * np.sin(psi - phi))
    assert found.column("F") == pytest.approx(push, rel=1e-10)
    assert found.column("R13x") + 1j * found.column("R13y") == pytest.approx(-push * np.exp(1j * psi), rel=1e-10)
    assert found.energy.drive == pytest.approx(push * found.rows.motion.column("us"), abs=1e-9)


@pytest.mark.parametrize("rubs", [(0, 0), (0.1, 0.2)])
def test_a_carriage_on_two_pins_has_a_force_at_each_of_them(rubs):
    """By hand, 1 kg between the pins and 10 N on the second; both forces were named N01, which no page could set."""
    friction = f"[friction]\nC = {{ coefficient = {rubs[0]} }}\nE = {{ coefficient = {rubs[1]} }}\n" if any(rubs) else ""
    text = mechanism(
        "drawn-block", ("[coordinates]", '[drive]\nu = "0.5*cos(3*t)"\n[coordinates]'),
        ('"(s, 0)"', '"(s, 0)"\nE = "(s + 0.1, 0)"'),
        ('["C"]', '["C", "E"]'), ("rails = [ ", 'rails = [ { through = "E", angle = "0" }, '), ("C = { mass", "1 = { mass"),
        ('at = "C", force = "(2 - u, 0)"', 'at = "E", force = "(0, -10)"'), ("[forces]", '[forces]\ngravity = "9.81 m/s^2"'),
        ('[motor]\nrates = ["u"]\nstart = { u = "0 m/s" }\n', friction), ('"dynamics", "accuracy"', '"forces"'), end="1 s",
    )  # fmt: skip
    run = coursework.solve(coursework.parse_variant(text), scheme="rk4")
    found = run.results.forces
    second, first = found.names[:2]
    assert (second, first) == ("N01", "N01_2")
    assert found.column(second) == pytest.approx(9.81 / 2 + 10) and found.column(first) == pytest.approx(9.81 / 2)
    t = found.rows.motion.t
    against = np.sign(np.cos(3 * t)) * (rubs[0] * 9.81 / 2 + rubs[1] * (9.81 / 2 + 10))
    assert found.column("F") == pytest.approx(-1.5 * np.sin(3 * t) + against)
    assert "01_2</sub>" in render_html(build_model(run, "en"))
