"""Links of one rate with a common point are one body: gears of one shaft, a planet that touches the sun and the ring.

The references are Willis' formula and the balance of power: M w1 = d/dt(sum J w^2/2) + M4 w4, whatever the teeth carry.
"""

import numpy as np
import pytest

import coursework
from coursework.mechanism.mechanism import build
from coursework.mechanism.structure import read_structure
from coursework.report.sections.effects.forces import _convention
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from tests.mechanisms.library import changed, mechanism

HEAD = """format = 1
title = "Gears"
[given]
m = "4 mm"
{given}
[drive]
w1 = "10 + 4*sin(3*t)"
{drive}
[coordinates]
{coordinates}
[time]
step = "0.05 s"
end = "0.4 s"
[[constraint]]
name = "first"
equation = "{first}"
[[constraint]]
name = "second"
equation = "{second}"
"""
REDUCER = (
    HEAD.format(
        given="z1 = 18\nz2 = 54\nz3 = 20\nz4 = 60",
        drive="",
        first="z1*w1 + z2*w2 = 0",
        second="z3*w2 + z4*w4 = 0",
        coordinates="\n".join(f'f{k} = {{ start = "0 deg", rate = "w{k}" }}' for k in (1, 2, 4)),
    )
    + """[points]
O = "(0, 0)"
P = "O + (m*z1/2, 0)"
Q = "O + (m*(z1+z2)/2, 0)"
K = "Q + (m*z3/2, 0)"
U = "Q + (m*(z3+z4)/2, 0)"
[links]
1 = { wheel = "O", contact = "P", rate = "w1" }
2 = { wheel = "Q", contact = "P", rate = "w2" }
3 = { wheel = "Q", contact = "K", rate = "w2" }
4 = { wheel = "U", contact = "K", rate = "w4" }
[frame]
hinges = ["O", "Q", "U"]
[closure]
holds = ["z1*f1 + z2*f2", "z3*f2 + z4*f4"]
"""
)
LOADED = (
    REDUCER
    + """[masses]
1 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
2 = { mass = "5 kg", inertia = "0.05 kg*m^2" }
3 = { mass = "2 kg", inertia = "0.02 kg*m^2" }
4 = { mass = "8 kg", inertia = "0.3 kg*m^2" }
[forces]
T4 = { on = "4", torque = "-90 N*m" }
[ask]
quantities = ["table", "checks", "forces"]
"""
)
PLANETS = (
    HEAD.format(
        given="z1 = 20\nz2 = 16\nz3 = 52",
        drive='w3 = "-5 + 9*t^2"',
        first="z1*(w1 - wh) = -z2*(w2 - wh)",
        second="z3*(w3 - wh) = z2*(w2 - wh)",
        coordinates="\n".join(f'{k} = {{ start = "35 deg", rate = "w{k[-1]}" }}' for k in ("f1", "f2", "f3", "h")),
    )
    + """[points]
O = "(0, 0)"
C = "O + m*(z1 + z2)/2 @ h"
P = "O + m*z1/2 @ h"
Q = "O + m*z3/2 @ h"
[links]
1 = { wheel = "O", contact = "P", rate = "w1" }
2 = { wheel = "C", contact = "P", rate = "w2" }
"2a" = { wheel = "C", contact = "Q", rate = "w2" }
3 = { wheel = "O", contact = "Q", rate = "w3" }
H = { points = ["O", "C"], rate = "wh" }
[frame]
hinges = ["O"]
[closure]
holds = ["z1*(f1 - h) + z2*(f2 - h)", "z3*(f3 - h) - z2*(f2 - h)"]
[masses]
1 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
2 = { mass = "1.5 kg", inertia = "0.002 kg*m^2" }
3 = { mass = "3 kg", inertia = "0.2 kg*m^2" }
H = { mass = "2 kg", inertia = "0.06 kg*m^2", centre = "O" }
[forces]
TH = { on = "H", torque = "-40 N*m" }
[ask]
quantities = ["table", "checks", "forces"]
"""
)
I2, I4 = -18 / 54, 18 * 20 / (54 * 60)
J = 0.01 + (0.05 + 0.02) * I2**2 + 0.3 * I4**2


@pytest.fixture(scope="module")
def reducer():
    return coursework.solve(coursework.parse_variant(LOADED), "exact")


def verdicts(run):
    return {one.code: one.verdict for one in run.checks}


def test_a_reducer_needs_the_moment_of_the_power_balance(reducer):
    forces, e1 = reducer.results.forces, 12 * np.cos(3 * reducer.motion.t)
    assert np.allclose(forces.column("M"), J * e1 + 90 * I4, rtol=0, atol=1e-12)
    assert np.allclose(forces.beside["J"], J, rtol=1e-12)
    # What the shaft carries from gear 2 to gear 3: the inertia of gear 3, and the load reduced from wheel 4 over one pair.
    assert np.allclose(forces.column("K23"), 0.02 * I2 * e1 - (0.3 * I4 * e1 + 90) * 20 / 60, rtol=0, atol=1e-12)
    assert {verdicts(reducer)[code] for code in ("VIRTUAL-POWER", "GROUPS", "POWER", "AGREEMENT")} == {"PASS"}


def test_the_gears_of_a_shaft_are_one_link_of_the_structure(reducer):
    """By hand: 3·3 − 2·3 − 2 = 1, three wheels on pivots that mesh twice."""
    found = read_structure(build(reducer.variant))
    assert [link.name for link in found.links] == ["1", "2+3", "4"] and found.links[1].points == ("Q", "P", "K")
    assert (found.mobility.links, found.mobility.lower_pairs, found.mobility.higher_pairs) == (3, 3, 2)
    told = " ".join(_convention(PageContext(reducer, load_words("en")), reducer.results.forces))
    assert "Links 2 and 3 are one body; R and K between them" in told


def test_the_journal_of_a_shaft_rubs_once():
    """P = mu r |R02| |w2| more power; between the gears of the shaft nothing turns."""
    rubs = '[friction]\nQ = { coefficient = "0.1", radius = "10 mm" }\n[ask]'
    run = coursework.solve(coursework.parse_variant(changed(LOADED, ("[ask]", rubs))), "exact")
    forces, e1 = run.results.forces, 12 * np.cos(3 * run.motion.t)
    journal = 0.1 * 0.01 * np.hypot(forces.column("R02x"), forces.column("R02y"))
    assert np.allclose(forces.column("M"), J * e1 + 90 * I4 + journal * abs(I2), rtol=0, atol=1e-9)


def test_both_drives_of_a_differential_act_against_the_frame():
    """By Willis wh = (z1 w1 + z3 w3)/(z1 + z3); virtual power gives each of the two moments."""
    run = coursework.solve(coursework.parse_variant(PLANETS), "exact")
    a, b = 20 / 72, 52 / 72
    e1, e3, radius = 12 * np.cos(3 * run.motion.t), 18 * run.motion.t, 0.072
    eh = a * e1 + b * e3
    load, e2 = (0.06 + 1.5 * radius**2) * eh + 40, eh - 20 / 16 * (e1 - eh)
    forces = run.results.forces
    assert np.allclose(forces.column("M1"), 0.01 * e1 + 0.002 * e2 * (a - 20 / 16 * (1 - a)) + load * a, rtol=0, atol=1e-12)
    assert np.allclose(forces.column("M3"), 0.2 * e3 + 0.002 * e2 * (b + 20 / 16 * b) + load * b, rtol=0, atol=1e-12)
    assert read_structure(build(run.variant)).mobility.degrees == 2 and verdicts(run)["VIRTUAL-POWER"] == "PASS"


def test_drives_of_links_without_an_angle_are_told_with_the_lines_to_add():
    angles = [(f'f{k} = {{ start = "35 deg", rate = "w{k}" }}\n', "") for k in (1, 3)]
    text = changed(PLANETS, *angles, ('[closure]\nholds = ["z1*(f1 - h) + z2*(f2 - h)", "z3*(f3 - h) - z2*(f2 - h)"]\n', ""))
    with pytest.raises(coursework.InputError, match=r'V722 .*angle_1 = \{ start = "0 deg", rate = "w1" \}; angle_3 = '):
        _ = coursework.solve(coursework.parse_variant(text)).results.forces


@pytest.mark.parametrize(("second", "verdict"), [("z3*w2 + z4*w4 = 0", "PASS"), ("z3*w2 - z4*w4 = 0", "SKIP")])
def test_contacts_judge_a_train_without_position_equations(second, verdict):
    held = '[closure]\nholds = ["z1*f1 + z2*f2", "z3*f2 + z4*f4"]\n'
    text = changed(REDUCER, (held, ""), ("z3*w2 + z4*w4 = 0", second))
    run = coursework.solve(coursework.parse_variant(text))
    assert verdicts(run)["AGREEMENT"] == verdict
    assert run.summary.startswith("Equation second does not fit how the links move") is (verdict == "SKIP")


def test_the_exact_motion_names_the_coordinates_that_nothing_holds():
    text = changed(REDUCER, (', "z3*f2 + z4*f4"', ""))
    with pytest.raises(coursework.InputError, match=r"V502 .* leave f4 open"):
        _ = coursework.solve(coursework.parse_variant(text), "exact").table


@pytest.mark.parametrize(("offset", "is_told"), [("-2 cm", True), ("0 cm", False)])
def test_a_datum_that_the_start_does_not_meet_is_told_first(offset, is_told):
    other = ('e = "14 mm"', f'e = "14 mm"\nyS = "{offset}"'), ('"S.y"', '"S.y - yS"')
    run = coursework.solve(coursework.parse_variant(mechanism("planet-between-sun-and-ring", *other)))
    assert run.summary.startswith("S.y - yS = 0.02 at the start, and so it stays: if it should be zero") is is_told
