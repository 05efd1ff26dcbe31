"""What `coursework check` says of equations."""

from pathlib import Path

import pytest

from coursework.words.data_folders import folder
from tests.command import call
from tests.mechanisms.library import mechanism
from tests.variant.judging.test_advice_followed import FORCES, SAW

pytestmark = pytest.mark.usefixtures("folder")


def test_an_angle_of_the_file_in_degrees_is_read_in_degrees():
    """In the velocities, the determinant, and where it is zero: the guides are parallel at psi = 90.75°."""
    text = mechanism("pin-between-guides", ('angle = "90 deg"', 'angle = "-89.25 deg"'), end="2 s")
    Path("own.toml").write_text(text, encoding="utf-8")
    told = call("check", "own.toml").stdout
    assert "uj = " in told and "1.557" not in told
    assert "sin(89.25° + psi): zero when the two guides are parallel" in told
    assert "become singular: sin(89.25° + psi) = 0, with psi = 1.58389 rad = 90.75°" in told


def test_where_every_coordinate_is_driven_no_position_equation_is_missed():
    text = """format = 1
title = "A rope over two cranks"
given = { r = "1 m", w = "2 1/s" }
drive = { w1 = "w", w2 = "2*w" }
coordinates = { a = { start = "0 rad", rate = "w1" }, b = { start = "0 rad", rate = "w2" } }
unknowns = { v = "m/s" }
time = { step = "0.01 s", end = "0.1 s" }
constraint = [{ name = "1", because = "the rope", equation = "v - r*w1*cos(a) - r*w2*cos(b) = 0" }]
"""
    Path("own.toml").write_text(text, encoding="utf-8")
    assert "\nThe drives place every coordinate: no position equation is needed.\n" in call("check", "own.toml").stdout


@pytest.mark.parametrize(("name", "determinant", "closing"), [("31", "r2*r1*sin(phi1 - phi2)", 3), ("example-4", "s2", 2)])
def test_the_determinant_of_two_velocities_has_the_sign_of_the_page(name, determinant, closing):
    told = call("check", name).stdout
    assert f"\n{closing} position equations determine every coordinate.\n" in told
    assert f"determinant {determinant}: zero" in told and f"determinant -{determinant}:" not in told


def test_the_term_of_an_equation_that_contradicts_is_named_and_others_are_not(tmp_path, monkeypatch):
    """`run` and `check` name what differs, in two equations at once; what no slip explains is to be derived anew."""
    monkeypatch.chdir(tmp_path)
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8")
    slips = text.replace("cos(phi3) - r3", "cos(phi3) + r3").replace("r2*w2*sin(phi2)", "r2*w2*cos(phi2)")
    (tmp_path / "slips.toml").write_text(slips, encoding="utf-8")
    (tmp_path / "wild.toml").write_text(text.replace("cos(phi3) - r3", "sin(phi2)/3 + r1"), encoding="utf-8")
    for command in ("run", "check"):
        told = call(command, "slips")
        assert told.exit_code == 2
        assert (
            "equation 11 contradicts" in told.stderr and "One slip would explain it: the sign of r3*w3*sin(phi3)" in told.stderr
        )
        assert "One slip would explain it: sine and cosine are exchanged in cos(phi2)" in told.stderr
        assert "no single slip that would explain it was found" in call(command, "wild").stderr


@pytest.mark.parametrize(
    ("name", "told"),
    [
        (
            "gears",
            "= 3, but 1 freedom is driven. The equations determine every velocity, so [links] and [frame] leave out",
        ),
        (
            "parallel-cranks",
            "= 0, but 1 freedom is driven. The equations determine every velocity: the mechanism moves thanks to its",
        ),
    ],
)
def test_freedoms_that_do_not_agree_are_told_with_what_to_do(name, told):
    Path("own.toml").write_text(mechanism(name), encoding="utf-8")
    assert told in call("check", "own.toml").stdout


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [('inertia = "rod"', 'inertia = "disc"', "V726"), ('rails = [ { through = "B", angle = "0" } ]', "", "V722"), ("", "", "")],
)
def test_what_a_run_would_find_wrong_with_forces_is_told_before_it(right, wrong, code):
    asked = '[ask]\nquantities = ["table", "forces"]\n'
    Path("own.toml").write_text((SAW + FORCES + asked).replace(right, wrong, 1), encoding="utf-8")
    told, ran = call("check", "own"), call("run", "own", "--format", "csv")
    assert told.exit_code == ran.exit_code == (2 if code else 0), told.output
    assert code in told.stderr and code in ran.stderr


def told_of(name, *changes):
    """Return what `check` and `run` say of a mechanism with these changes."""
    Path("own.toml").write_text(mechanism(name, *changes), encoding="utf-8")
    return call("check", "own.toml").output, call("run", "own.toml", "--format", "csv", "--out", "out").output


NO_MASSES = (
    '[masses]\n2 = { mass = "2 kg", inertia = "0.03 kg*m^2", centre = "C + c/2 @ phi2" }\n[forces]\ngravity = "9.81 m/s^2"\n',
    "",
)
NO_FORCES = (', "forces"]', "]")


@pytest.mark.parametrize(("slip", "said"), [
    (('hinges = ["A", "B"]', 'hinges = ["A"]'), 'B of link 3 stands still, but hinges of [frame] do not list it'),
    (('1 = { points = ["A", "C"], rate = "w1" }\n', ""), "hinges of [frame] list A, but no link of [links] has"),
    (('3 = { points = ["B", "D"]', '3 = { points = ["D"]'), "hinges of [frame] list B, but no link of [links] has"),
])  # fmt: skip
def test_a_pivot_or_link_left_out_is_named_by_check_and_by_run_with_and_without_forces(slip, said):
    for told in (*told_of("roberts", slip, NO_MASSES, NO_FORCES), *told_of("roberts", slip)):
        assert said in told
    assert "V722" in told
    for told in told_of("roberts"):
        assert "stands still" not in told and "The hinges of" not in told


def test_run_says_as_check_does_that_a_pair_is_left_out():
    """The arms of the lift cross in M; without it in the second link they are not joined, and the table is right all the same."""
    missing = "Mobility W = 3·4 − 2·4 − 1 = 3, but 1 freedom is driven."
    for told in told_of("scissor", ('["C", "M", "D"]', '["C", "D"]')):
        assert missing in told and "Link 2 is joined to the others at C only: is one of its points missing in it" in told
    for told in told_of("roberts", ('["C", "D", "P"]', '["P"]'), NO_MASSES, NO_FORCES):
        assert "Link 2 is joined to no other: are its points those of the links that it meets?" in told
    check, run = told_of("scissor")
    assert "= 1, as many as the one freedom driven" in check and "Mobility" not in run


def test_two_wheels_of_one_shaft_are_no_pair_left_out():
    check, run = told_of("gears-and-crank")
    assert "Mobility W = 3·4 − 2·4 − 3 = 1, as many as" in check
    assert "Mobility" not in run


@pytest.mark.parametrize(("slip", "how"), [
    (("u = -L*w1*sin(al)", "u = L*w1*sin(al)"), "the sign of u differs"),
    (("h = L*w1*cos(al)", "h = -L*w1*cos(al)"), "the sign of L*w1*cos(al) differs"),
    (("us*cos(be) - s*w2", "us*cos(be) + s*w2"), "the sign of s*w2*sin(be) differs"),
])  # fmt: skip
def test_a_slip_is_found_under_a_drive_in_pieces_too(slip, how):
    """Such a motion is computed from the text read anew: the wrong equation stood there again, and nothing was found."""
    for told in told_of("scissor", slip):
        assert f"One slip would explain it: {how}." in told


def test_a_wheel_that_touches_nothing_of_the_file_is_no_special_dimension():
    """The second gear is listed as a bar: the first one counts as rolling on the frame, and nothing moves."""
    bar = ('2 = { wheel = "Q", contact = "P", points = ["A2"]', '2 = { points = ["Q", "A2"]')
    check, _ = told_of("press-with-two-gears", bar)
    assert "the file does not list what wheel 1 touches at P" in check and "special dimensions" not in check
    assert "but 1 freedom is driven: a wheel is counted as rolling on the frame where the file does not list what" in check


def test_whether_the_positions_follow_from_their_equations_is_told():
    """The height of the slider tells its rod's angle, and not that of the last wheel."""
    Path("own.toml").write_text(mechanism("gears-and-crank"), encoding="utf-8")
    assert "1 position equation does not determine every coordinate." in call("check", "own.toml").stdout


def test_a_rail_across_a_block_that_forces_move_is_told_before_a_run():
    Path("own.toml").write_text(
        mechanism("block-on-a-spring", ('angle = "0"', 'angle = "30 deg"'), end="0.1 s"), encoding="utf-8"
    )
    told = call("check", "own.toml")
    assert told.exit_code == 2 and "V316" in told.output and "the rail through C lies at 30°, and C moves along 0°" in told.output


RING = """[points]
O = "(0, 0)"
C = "O + (R - r) @ crank"
P = "O + R @ crank"
E = "C + e @ wheel"
[links]
1 = { points = ["O", "C"], rate = "wc" }
2 = { wheel = "C", contact = "P", points = ["E"], rate = "wp" }
[frame]
hinges = ["O"]
circles = [{ center = "O", radius = "R" }]
[ask]"""


@pytest.mark.parametrize("scale", [1e-6, 3e4])
def test_a_wrong_sign_that_a_waiting_drive_and_a_sine_of_zero_hide_is_named_without_position_equations(scale):
    """V_E is the derivative of C + e @ wheel wherever the wheel is; at the start both sines are zero, and nothing moves."""
    late = ('wc = "w"', 'wc = { pieces = [["0 s", "0"], ["0.4 s", "w"]] }')
    bound = ('u = "m/s"', 'u = { unit = "m/s", of = "E", along = "0 deg" }')
    sizes = [(f'"{value} m"', f'"{value * scale:.9g} m"') for value in (0.7, 0.3, 0.1)]
    right = mechanism("wheel-in-a-ring", late, bound, ("[ask]", RING), *sizes)
    for written, named in ("(R - r)*wc*sin(crank) - e", ""), ("(R - r)*wc*sin(crank) + e", "Equation 2 does not fit"):
        Path("own.toml").write_text(right.replace("(R - r)*wc*sin(crank) - e", written), encoding="utf-8")
        told = call("check", "own.toml").stdout
        assert named in told if named else "does not fit" not in told


def test_a_drawing_without_links_is_refused_by_check_as_by_run():
    text = SAW.replace("1 = { points", "#").replace("2 = { points", "#")
    Path("saw.toml").write_text(text + '[ask]\nquantities = ["graph_check"]\n', encoding="utf-8")
    for command in ("check", "run"):
        told = call(command, "saw")
        assert (told.exit_code, told.stdout) == (2, "")
        assert "saw.toml:38  ask.quantities: the graph-analytical check needs [links]; this variant has none." in told.stderr


TURNED = """[drive]
w = "3 rad/s"
[coordinates]
q = { start = "0.5 rad", rate = "w" }
f = { start = "0.5 rad", rate = "wf" }
[time]
step = "0.02 s"
end = "0.2 s"
[[constraint]]
equation = "wf = 2*w"
[ask]
quantities = ["table", "analogs"]
"""


@pytest.mark.parametrize(("slip", "code"), [
    (("", ""), ""), (('"analogs"', '"invariants"'), "V518"), (('"3 rad/s"', '"30*t"'), "V521"),
    (('"3 rad/s"', '"30*t + 1"'), ""),
])  # fmt: skip
def test_tables_that_a_run_refuses_are_refused_before_it(slip, code):
    Path("own.toml").write_text(TURNED.replace(*slip), encoding="utf-8")
    for command in (("check",), ("run", "--format", "csv", "--out", "own")):
        done = call(*command, "own.toml")
        assert (done.exit_code == 2, code in done.stderr) == (bool(code), True), done.output
