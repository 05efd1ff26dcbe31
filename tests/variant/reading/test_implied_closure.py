"""A file without [closure]: its hinges, rails and driven point hold what they say, so that wrong signs are found all the same."""

import re

import pytest

import coursework
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.implied_closure import stays

TURNED = """
format = 1
[given]
R = "0.5 m"
r = "0.1 m"
l = "0.6 m"
A = "1.2 rad"
k = "2 1/s"
beta = "25 deg"
[drive]
wc = "-A*k*sin(k*t)"
[coordinates]
theta = { start = "0.3 rad", rate = "wc" }
phi = { start = "0 rad", rate = "wr" }
chi = { start = "2.2 rad", rate = "wl" }
[unknowns]
v = { unit = "m/s", of = "S", along = "beta" }
[time]
step = "10 ms"
end = "1 s"
[[constraint]]
name = "rolls"
equation = "(R - r)*wc = -r*wr"
[[constraint]]
name = "across"
equation = "(R - r)*wc*sin(theta - beta) + l*wl*cos(chi - beta) = 0"
[[constraint]]
name = "along"
equation = "v = (R - r)*wc*cos(theta - beta) - l*wl*sin(chi - beta)"
[points]
O = "(0, 0)"
C = "((R - r)*sin(theta), -(R - r)*cos(theta))"
P = "(R*sin(theta), -R*cos(theta))"
S = "C + l @ chi"
[links]
1 = { wheel = "C", contact = "P", rate = "wr" }
2 = { points = ["C", "S"], rate = "wl" }
[frame]
rails = [{ through = "S", angle = "beta" }]
circles = [{ center = "O", radius = "R" }]
"""
CUP = TURNED.replace('beta = "25 deg"\n', "").replace(" - beta", "").replace('"beta"', '"0 deg"')
SIGNS = {"rolls": ("= -r*wr", "= r*wr"), "across": ("+ l*wl*cos", "- l*wl*cos"), "along": ("- l*wl*sin", "+ l*wl*sin")}


def checks(text):
    run = coursework.solve(coursework.parse_variant(text))
    return {one.code: one.verdict for one in run.checks}, run


@pytest.mark.parametrize("text", [CUP, TURNED, CUP.replace('through = "S"', 'through = "S + (0, r)"')])
def test_right_equations_are_judged_right(text):
    verdicts, run = checks(text)
    assert verdicts["AGREEMENT"] == "PASS"
    assert len(run.scene.closure.names) == 1


@pytest.mark.parametrize("name", SIGNS)
@pytest.mark.parametrize("text", [CUP, TURNED])
def test_a_wrong_sign_is_refused(text, name):
    with pytest.raises(
        coursework.InputError, match=rf"V302 .*{name} contradicts the geometry of \[points\] and \[frame\]"
    ) as caught:
        checks(text.replace(*SIGNS[name]))
    lines = [number for number, line in enumerate(text.splitlines(), start=1) if SIGNS[name][0] in line]
    assert [fault.line for fault in caught.value.faults] == lines


def bare(name):
    text = coursework.load(name).path.read_text(encoding="utf-8")
    return re.sub(r"(?m)^(driven|holds) *=.*\n(?:  +\".*\n)*\]?", "", text)


@pytest.mark.parametrize(
    ("name", "turned"),
    [("31", ("VMy - 2*r3*w3", "VMy + 2*r3*w3")), ("31", ("+ r1*w1*sin(phi1) = 0", "- r1*w1*sin(phi1) = 0")), ("v102", ("", ""))],
)
def test_catalogue_without_closure(name, turned):
    """Euler's table is that of the file with [closure]; what [frame] does not tell, here a rolling wheel, is not made up."""
    text = bare(name)
    assert "driven" not in re.sub("#.*", "", text).split("[closure]")[1].split("[ask]")[0]
    variant = coursework.parse_variant(text)
    assert variant.driven == "M"
    assert coursework.solve(variant).table.equals(coursework.solve(name).table)
    if turned[0]:
        with pytest.raises(coursework.InputError, match="V302"):
            checks(text.replace(*turned))


@pytest.mark.parametrize(
    "rails",
    [
        '{ through = "S", angle = "0 deg" }, { through = "S", angle = "180 deg" }',
        '{ through = "O", angle = "0 deg" }, { through = "S", angle = "0 deg" }',
    ],
)
def test_what_says_nothing_of_its_own_is_left_out_and_the_rest_judges(rails):
    """Two rails along one line of one point; a rail of a point that never moves."""
    text = CUP.replace('{ through = "S", angle = "0 deg" }', rails)
    assert [spelled(hold) for hold in coursework.parse_variant(text).holds] == ["S.y"]
    assert checks(text)[0]["AGREEMENT"] == "PASS"
    with pytest.raises(coursework.InputError, match=r"V302 .*across contradicts"):
        checks(text.replace(*SIGNS["across"]))


def test_a_driven_point_on_its_rail_is_held_once():
    rail = ARM.replace("hinges", 'rails = [{ through = "M", angle = "0 deg" }]\nhinges').replace('"R*om*cos(om*t)"', '"0*om*R"')
    assert (coursework.parse_variant(rail).driven, coursework.parse_variant(rail).holds) == ("M", ())


def test_a_point_whose_coordinates_are_driven_is_no_further_drive():
    text = ARM.replace('M = "rho @ psi"', 'M = "(x, y)"\nS = "rho @ psi"').replace('["O", "M"]', '["O", "S"]')
    text = text.replace("[time]", 'x = { start = "0 m", rate = "VMx" }\ny = { start = "0 m", rate = "VMy" }\n[time]')
    text = text.replace("hinges", 'rails = [{ through = "S", angle = "0 deg" }]\nhinges')
    variant = coursework.parse_variant(text)
    assert (variant.driven, [spelled(hold) for hold in variant.holds]) == (None, ["S.y"])


@pytest.mark.parametrize(
    ("angle", "told"), [("phi", "a coordinate"), ("t", "the time"), ("wc", "a drive"), ("bet", "Declare it once: in [given]")]
)
def test_what_is_fixed_to_the_frame_stands_still(angle, told):
    with pytest.raises(coursework.InputError, match=r"frame\.rails\.1\.angle.*" + re.escape(told)):
        coursework.parse_variant(CUP.replace('through = "S", angle = "0 deg"', f'through = "S", angle = "{angle}"'))
    with pytest.raises(coursework.InputError, match=r"frame\.circles\.1\.radius"):
        coursework.parse_variant(CUP.replace('radius = "R"', 'radius = "R + phi"'))


@pytest.mark.parametrize("closure", ["", '[closure]\nholds = ["S.y"]\n'])
def test_an_angle_or_radius_without_a_value_is_told_where_it_stands(closure):
    for text, told in (('angle = "0 deg"', "rails.1.angle"), ('radius = "R"', "circles.1.radius")):
        with pytest.raises(coursework.InputError, match=rf"V086 .*{re.escape(told)}.*no real number"):
            coursework.parse_variant(CUP.replace(text, f'{text.split()[0]} = "asin(R/r)"') + closure)


def test_what_the_file_holds_itself_is_all_that_is_held():
    variant = coursework.parse_variant(CUP + '[closure]\nholds = ["S.y - 2*r"]\n')
    assert [spelled(hold) for hold in variant.holds] == ["S.y - 2*r"]


ARM = """
format = 1
[given]
R = "0.2 m"
om = "3 rad/s"
[drive]
VMx = "-R*om*sin(om*t)"
VMy = "R*om*cos(om*t)"
[coordinates]
rho = { start = "0.9 m", rate = "u" }
psi = { start = "20 deg", rate = "w" }
[time]
step = "0.01 s"
end = "1 s"
[[constraint]]
name = "a"
equation = "VMx = u*cos(psi) - rho*w*sin(psi)"
[[constraint]]
name = "b"
equation = "VMy = u*sin(psi) + rho*w*cos(psi)"
[points]
O = "(0, 0)"
M = "rho @ psi"
[links]
1 = { points = ["O", "M"], rate = "w" }
[frame]
hinges = ["O"]
"""


def test_a_driven_point_alone_judges_the_arm_that_carries_it():
    verdicts, run = checks(ARM)
    assert (verdicts["AGREEMENT"], run.variant.driven, run.variant.holds) == ("PASS", "M", ())
    with pytest.raises(coursework.InputError, match=r"V302 .*a contradicts the geometry of \[points\] and \[drive\]"):
        checks(ARM.replace("- rho*w*sin(psi)", "+ rho*w*sin(psi)"))


def test_points_of_two_links_in_one_place_are_proposed_as_a_joint():
    """A peg in a slot without [closure]: nothing says that A and B are one; a hundredth of R = 0.2 m is near."""
    text = ARM.replace('M = "rho @ psi"', 'A = "M + (0, R)"\nB = "M + (0.00199, R)"\nM = "rho @ psi"').replace("VM", "VN")
    text = text.replace("hinges", '2 = { points = ["A"] }\n3 = { points = ["B"] }\n[frame]\nhinges').replace("[frame]\n2", "2", 1)
    (found,) = [one for one in checks(text)[1].checks if one.code == "AGREEMENT"]
    assert (
        found.verdict == "SKIP"
        and "A and B lie in one place, or almost, at the start" in found.sentence
        and '"A = B"' in found.sentence
    )
    apart = text.replace("0.00199", "0.00201")
    assert "A = B" not in next(one for one in checks(apart)[1].checks if one.code == "AGREEMENT").sentence


@pytest.mark.parametrize(("section", "found"), [("closure", "3"), ("ask", '"x"')])
def test_a_section_that_is_written_as_a_value_is_wanted_as_lines(section, found):
    with pytest.raises(
        coursework.InputError, match=rf"V015 .*{section}: a section of lines key = value was expected, found {found}\."
    ):
        coursework.parse_variant(f"{section} = {found}\n{ARM}")


@pytest.mark.parametrize("size", [1e-7, 1e-3, 1e6])
def test_what_the_frame_holds_judges_signs_in_micrometres_as_in_kilometres(size):
    text = re.sub(r'"([0-9.]+) m"', lambda found: f'"{float(found[1]) * size:.9g} m"', TURNED)
    right = coursework.parse_variant(text)
    assert [spelled(hold) for hold in right.holds] == [spelled(hold) for hold in coursework.parse_variant(TURNED).holds] != []


def test_what_a_coordinate_moves_is_tried_at_the_start():
    """What is driven by time alone later on."""
    variant = coursework.parse_variant(CUP)
    assert [stays([parse(text)], variant) for text in ("t*theta", "(1 - t)*theta", "t", "theta")] == [True, False, True, False]
