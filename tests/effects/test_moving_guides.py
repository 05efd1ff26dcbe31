"""A guide is part of a link only if it turns and shifts with it; start values measured on a drawing are no moving pins."""

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.effects.scheme import _Reader
from coursework.mechanism.groups.joint import PIN_IN_GUIDE, PRISMATIC, REVOLUTE, Joint
from tests.effects.massed import of_text
from tests.mechanisms.library import mechanism

BARS = mechanism("rod-on-a-slider-of-a-bar")


@pytest.mark.parametrize(
    ("through", "angle", "link"),
    [
        ("O", "phi", ""), ("O", "phi + 0.3", ""), ("O", "pi - 1 + phi", ""), ("A", "phi - pi/2", ""), ("A", "0.4", "1"),
        ("O", "2*phi", "1"), ("O", "phi/2", "1"), ("O", "-phi", "1"), ("O", "phi + sin(phi)", "1"), ("K", "phi", "1"),
        ("O", "0.2*sin(9*t)", "0"), ("O", "30 deg", ""),
    ],
)  # fmt: skip
def test_a_guide_belongs_to_a_link_only_if_it_moves_with_it(through, angle, link):
    """At twice the angle it counted as the crank: M = -22.44 N*m by reactions, where virtual power says -15.68."""
    text = BARS.replace('through = "O", angle = "phi"', f'through = "{through}", angle = "{angle}"')
    line = next(place for place, each in enumerate(text.splitlines(), start=1) if each.startswith("guide"))
    run = coursework.solve(coursework.parse_variant(text, "own.toml"))
    if link:
        with pytest.raises(coursework.InputError, match=rf"V736 own.toml:{line}  the guide of B counts as part of link {link} "):
            _ = run.results.forces
    else:
        verdicts = {one.code: one.verdict for one in run.checks}
        assert verdicts["VIRTUAL-POWER"] == "PASS", verdicts


FOUR_BAR = mechanism("four-bar-measured-on-a-drawing")


@pytest.mark.parametrize(("start", "is_measured"), [("70.2 deg", True), ("71 deg", True), ("80 deg", False)])
def test_start_values_measured_on_a_drawing_leave_the_pins_in_their_links(start, is_measured):
    """The loop closes at 70.162 degrees; the checks ask for the forces of the exact motion, too."""
    run = coursework.solve(coursework.parse_variant(FOUR_BAR.replace("70.2 deg", start), "own.toml"))
    if is_measured:
        assert {"VIRTUAL-POWER", "FORCE-ACCURACY"} <= {one.code for one in run.checks}
    else:
        with pytest.raises(
            coursework.InputError, match=r"V735 own.toml:\d+  masses.3: .*or correct the start.*point C does not stand still"
        ):
            _ = run.results.forces


def test_a_start_that_leaves_the_links_open_is_told_instead_of_the_pins_that_seem_to_move_for_it():
    """The rocker counted from D to B, as students do: the pin D of link 3 seemed to need a drive of its own."""
    text = mechanism("roberts", ("109.471220634 deg", "-70.528779366 deg"))
    run = coursework.solve(coursework.parse_variant(text, "own.toml"))
    line = text[: text.index("[coordinates]")].count("\n") + 1
    with pytest.raises(coursework.InputError) as caught:
        _ = run.results.forces
    (told,) = str(caught.value).splitlines()
    assert told.startswith(f"V737 own.toml:{line}  The start values leave the mechanism open by 0.566 m")
    assert told.endswith("phi3 = -196.098933951 deg. Correct it first: no force passes between links that do not meet.")


def test_a_guide_does_not_move_because_the_pin_in_it_stands_still():
    """With both bars on one line the slider stays in O for ever: its velocity, and that of its guide, are round-off."""
    run = coursework.solve(coursework.parse_variant(mechanism("scott-russell", ("160 deg", "20 deg"))))
    assert np.abs(np.asarray(run.points["A"].velocity)).max() < 1e-14
    assert {one.code: one.verdict for one in run.checks}["VIRTUAL-POWER"] == "PASS"


def test_a_likelier_slip_is_told_beside_an_open_start():
    with pytest.raises(coursework.InputError, match=r"V737 .* A likelier slip: phi1 = 70.53 rad is 11.2 turns; 70.53 deg"):
        _ = coursework.solve(coursework.parse_variant(mechanism("roberts", ("70.528779366 deg", "70.53 rad")))).results.forces


SLEEVE = mechanism("bar-through-a-sleeve")


@pytest.mark.parametrize("rate", ["", ', rate = "wp"'])
def test_a_sleeve_turns_with_its_bar_whether_or_not_the_file_names_the_rate(rate):
    """The bar gives the sleeve its angular acceleration by the couple J*epsilon, from psi = atan2(r sin, d + r cos)."""
    run = coursework.solve(coursework.parse_variant(SLEEVE.replace('"E"]', f'"E"]{rate}')))
    r, d, w, phi = 0.1, 0.3, 5.0, math.radians(40)
    above, below = r * r + r * d * math.cos(phi), r * r + d * d + 2 * r * d * math.cos(phi)
    epsilon = w**2 * r * d * math.sin(phi) * (2 * above - below) / below**2
    assert run.results.forces.column("K32")[0] == pytest.approx(0.01 * epsilon, rel=1e-9)
    with pytest.raises(coursework.InputError, match=r"V725 .*link 2 turns and has a mass, but no inertia"):
        bare = SLEEVE.replace('"E"]', f'"E"]{rate}').replace(', inertia = "0.01 kg*m^2"', "")
        _ = coursework.solve(coursework.parse_variant(bare)).results.forces


@pytest.mark.parametrize(
    ("right", "wrong", "named"),
    [
        ("= 0.22*w3*cos", "= -0.22*w3*cos", "equation 2 does not fit how the links move: "),
        ("- 0.25*w2*sin", "- 0.25*w2*cos", "equation 1 does not fit "),
        ("0.22*w3*", "0.32*w3*", "equations 1 and 2 do not fit "),
        (
            '["D", "C"], rate = "w3"',
            '["D", "C"]',
            "of the equations no geometry judges 1 and 2: look for a wrong sign there first",
        ),
    ],
)
def test_an_equation_that_no_position_judges_is_told_before_the_links(right, wrong, named):
    """Points of the rocker are those of the frame and of the coupler: only its shape judges the equations."""
    assert of_text(FOUR_BAR).reactions.names
    text = FOUR_BAR.replace(right, wrong)
    if "rate" in right:
        text = text.replace("= 0.22*w3*cos", "= -0.22*w3*cos")
    with pytest.raises(coursework.InputError, match=rf"V735 .*: {named}.*, point C does not stand still"):
        of_text(text)


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("", "", "Signs are not checked"),
        ("= 0.22*w3*cos", "= -0.22*w3*cos", "Equation 2 does not fit how the links move: a sign is wrong there"),
        ("0.22*w3*", "0.32*w3*", "Equations 1 and 2 do not fit how the links move:"),
    ],
)
def test_without_forces_the_first_line_names_what_does_not_fit_the_links(right, wrong, told):
    text = re.sub(r"\[masses\]\n.*\n", "", FOUR_BAR.replace(', "forces"', ""))
    assert coursework.solve(coursework.parse_variant(text.replace(right, wrong))).summary.startswith(told)


def test_an_arm_that_grows_is_no_rigid_link():
    """A bar swings and reaches: its length is a coordinate, its points are no shape; nothing gives its angle."""
    text = """
format = 1
[given]
n = "3 rad/s"
[coordinates]
s = { start = "0.5 m", rate = "u" }
q = { start = "0.3 rad", rate = "w" }
c = { start = "0.3 rad", rate = "wc" }
[time]
step = "0.01 s"
end = "0.1 s"
[[constraint]]
equation = "wc = n"
[[constraint]]
equation = "u = 0.1*wc*cos(c)"
[[constraint]]
equation = "w = wc/2"
[points]
O = "(0, 0)"
A = "O + s @ q"
[links]
1 = { points = ["O", "A"], rate = "w" }
[frame]
hinges = ["O"]
"""
    assert "does not fit" not in coursework.solve(coursework.parse_variant(text)).summary


@pytest.mark.parametrize(("joints", "guide"), [
    ([(REVOLUTE, "3", "2"), (PIN_IN_GUIDE, "3", "4"), (PRISMATIC, "3", "1")], "1"), ([(REVOLUTE, "3", "2")], ""),
    ([(PIN_IN_GUIDE, "3", "4")], ""), ([(PRISMATIC, "3", "0")], ""), ([(PRISMATIC, "1", "3")], ""),
    ([(PRISMATIC, "3", "0"), (PRISMATIC, "3", "2")], "2"),
])  # fmt: skip
def test_a_block_turns_with_what_it_slides_on_and_not_with_what_it_is_pinned_to(joints, guide):
    linkage = SimpleNamespace(joints=[Joint(kind, (one, other), None) for kind, one, other in joints])
    assert _Reader.guide_of(SimpleNamespace(bodies=SimpleNamespace(linkage=linkage)), "3") == guide
