"""A link whose rate is another's, or whose wheel would slip, is told by name; a sense counted clockwise is none of that."""

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.geometry.judging.misfits import misfits
from coursework.motion.geometry.judging.turning import _of_link, said_otherwise
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import changed, mechanism

# A four-bar whose angles are counted clockwise.
CLOCKWISE = mechanism("clockwise-four-bar")
# A link to the slider, which starts from rest: an arm that grows, and turns no more than two points that stand still.
TO_SLIDER = "[[group]]", 'S = "(x, 0)"\n[[group]]'
MASSES = '[masses]\n2 = { mass = "1 kg", inertia = "rod" }\n'


def closure(text, *slips):
    return coursework.solve(parse_variant(changed(text, *slips), "mine")).scene.closure


@pytest.mark.parametrize(
    ("text", "link", "slips"),
    [
        (mechanism("chebyshev"), "2", [('"P"], rate = "w2"', '"P"], rate = "w3"')]),
        (CLOCKWISE, "3", [('["D", "C"], rate = "w3"', '["D", "C"], rate = "w1"')]),
        (CLOCKWISE, "2", [("[ask]", f"{MASSES}[ask]")]),  # forces count a rate as vectors do
        (CLOCKWISE, "1", [('D = "(d, 0)"', 'D = "(0.32, 0)"'), ('["A", "B"]', '["A", "D"]')]),
        (mechanism("driven-slider"), "1", [TO_SLIDER, ("[frame]", '[links]\n1 = { points = ["A", "S"], rate = "w2" }\n[frame]')]),
        (mechanism("robot-arm"), "2", [('["A", "M"], rate = "w2"', '["A", "M"], rate = "w1"')]),
        # The wheel would roll the wrong way: equation and position equation agree, its pin does not.
        (
            mechanism("epicyclic"),
            "2",
            [("(R0 - R)*w1 + R*w2", "(R0 - R)*w1 - R*w2"), ("(R0 - R)*phi1 + R*psi2", "(R0 - R)*phi1 - R*psi2")],
        ),
    ],
)
def test_a_link_that_turns_otherwise_than_its_rate_is_named(text, link, slips):
    with pytest.raises(coursework.InputError, match=f"V309 .*link {link} turns at"):
        closure(text, *slips)


@pytest.mark.parametrize(("slips", "told"), [
    ([("w1 + w2 = 0", "w1 - w2 = 0"), ("f1 + f2", "f1 - f2")], "Or is a sign wrong in its equation or in what [closure] holds?"),
    ([("(m*z/2, 0)", "(m*z/3, 0)")], "A wheel turns as its centre and its contact move"),
])  # fmt: skip
def test_a_wheel_that_turns_otherwise_is_told_where_the_slip_may_be(slips, told):
    """Gears that turn in one sense, with an equation and a hold that agree, and a contact at no pitch radius."""
    with pytest.raises(coursework.InputError, match=r"V309") as caught:
        closure(mechanism("press-with-two-gears"), *slips)
    assert told in str(caught.value)


@pytest.mark.parametrize(("size", "speed"), [(1e-6, -1.0), (1e3, -1.0), (1e5, -1e-3), (1.0, 300.0)])
def test_a_link_that_rests_is_not_judged_by_its_round_off(size, speed):
    """A kite whose rocker lies on the frame, C on A, while crank and coupler turn."""
    text = f'''format = 1
[given]
a = "{0.5 * size!r} m"
c = "{size!r} m"
[drive]
w1 = "{speed} rad/s"
[coordinates]
p1 = {{ start = "{math.pi + 1!r} rad", rate = "w1" }}
p2 = {{ start = "1 rad", rate = "w2" }}
p3 = {{ start = "{math.pi!r} rad", rate = "w3" }}
[time]
step = "{0.02 / abs(speed)!r} s"
end = "{0.5 / abs(speed)!r} s"
[points]
A = "(0, 0)"
B = "A + a @ p1"
C = "B + a @ p2"
D = "(c, 0)"
[links]
1 = {{ points = ["A", "B"], rate = "w1" }}
2 = {{ points = ["B", "C"], rate = "w2" }}
3 = {{ points = ["D", "C"], rate = "w3" }}
[[constraint]]
name = "1"
closure = "a @ p1 + a @ p2 = (c, 0) + c @ p3"
[frame]
hinges = ["A", "D"]
'''
    assert closure(text).complete


def test_the_rate_that_is_meant_is_named_where_another_link_has_it():
    slips = [('["B", "C"], rate = "w2"', '["B", "C"], rate = "w3"'), ('["D", "C"], rate = "w3"', '["D", "C"], rate = "w2"')]
    with pytest.raises(coursework.InputError) as told:
        closure(CLOCKWISE.replace("-a*", "a*").replace("-b*", "b*").replace("-c*", "c*"), *slips)
    assert ['rate = "w2"' in str(fault) for fault in told.value.faults] == [True, False]
    assert ['rate = "w3"' in str(fault) for fault in told.value.faults] == [False, True]


def test_angles_may_be_counted_clockwise():
    assert closure(CLOCKWISE) is not None


def test_other_data_of_one_template_are_judged_too():
    """A link at k times an angle turns at its rate only where k is 1; both variants share what was compiled."""
    link = "[closure]", '[links]\n3 = { points = ["Q", "S"], rate = "w3" }\n[closure]'
    text = mechanism("four-bar-by-its-points", ('d = "0.37 m"', 'd = "0.37 m"\nk = 1'), ("c @ phi3", "c @ (k*phi3)"), link)
    assert closure(text).names
    with pytest.raises(coursework.InputError, match=r"V309 .*link 3 turns at"):
        closure(text, ("k = 1", "k = 2"), ("1.5448169061004255", "0.77240845305021275"))


def test_a_wheel_that_carries_a_point_turns_as_that_point_does():
    """The rate of the wheel of variant 31 is an unknown, without an angle of its own: alone it follows from rolling only."""
    wheel = 'contact = "P", rate = "w4" }', 'contact = "P", points = ["E"], rate = "w4" }'
    with pytest.raises(coursework.InputError, match=r"V309 .*link 4 turns at"):
        closure(mechanism("31", wheel, ('P = "C', 'E = "C + r3/4 @ phi1"\nP = "C')))


@pytest.mark.parametrize(("beside", "is_its_rack"), [("R", True), ("1.009*R", True), ("1.011*R", False)])
def test_a_gear_turns_as_its_rack_runs(beside, is_its_rack):
    """Positions and equation agree that the rack runs against the lowest point of the gear; a slider elsewhere is no rack."""
    against = ("xC0 + R*psi4, -R)", f"xC0 - R*psi4, -{beside})"), ("u - R*w4", "u + R*w4")
    text = mechanism("v112", *against)
    if not is_its_rack:
        assert closure(text) is not None
        return
    with pytest.raises(coursework.InputError, match=r"V309 .*link 4 turns at 15\.49\d* rad/s .* is -15\.49"):
        closure(text)


def test_points_in_one_place_do_not_tell_how_their_link_turns():
    assert closure(CLOCKWISE, ("[links]", 'E = "C + 0*(C - D)"\n[links]\n9 = { points = ["C", "E"], rate = "w2" }')) is not None


@pytest.mark.parametrize(
    ("slips", "told"),
    [
        ([], r"Link 2 turns at \S+ rad/s at t = 0\.025 s .* its rate w2 is"),
        ([('2 = { points = ["A", "M"], rate = "w2" }\n', "")], "M moves along x at"),
        ([("VMx + r2*w2", "VMx - r2*w2")], "Link 2 turns at"),
    ],
)
def test_points_that_move_otherwise_than_the_file_says_are_told_where_no_position_is_held(slips, told):
    """The hand stands still at the start.  As no point depends on phi2, the drive cannot hold the hand."""
    text = mechanism("robot-arm", ('[closure]\ndriven = "M"\n', ""), ('M = "A + r2 @ phi2"', 'M = "A + r2 @ phi1"'), *slips)
    assert re.match(told, str(coursework.solve(parse_variant(text, "mine")).summary))


@pytest.mark.parametrize("off", [0.0, 1e-4, 0.056, 3.7])
def test_a_start_that_does_not_close_changes_no_rate(off):
    """An open start is told by its own check; a link that is named wrong is told beside it, whatever the start."""
    start = "74.0438 deg", f"{74.0438 + off} deg"
    assert closure(mechanism("windshield-wiper"), start) is not None
    with pytest.raises(coursework.InputError, match=r"V309 .*link 5 turns at"):
        closure(mechanism("windshield-wiper"), start, ('"Q"], rate = "w5"', '"Q"], rate = "w4"'))


TRAIN = """
[given]
z1 = "24"
z2 = "18"
m = "3 mm"
[drive]
w1 = "40*sin(2*t)"
wc = { pieces = [["0 s", "0"], ["0.7 s", "5*(t - 0.7)"]] }
[coordinates]
p1 = { start = "0 rad", rate = "w1" }
pc = { start = "90 deg", rate = "wc" }
p2 = { start = "0 rad", rate = "w2" }
[time]
step = "0.05 s"
end = "1.2 s"
[[constraint]]
equation = "(w2 - wc)*z2 = -(w1 - wc)*z1"
[points]
O = "(0, 0)"
P = "m*(z1 + z2)/2 @ pc"
Q = "m*z1/2 @ pc"
[links]
1 = { wheel = "O", contact = "Q", rate = "w1" }
2 = { wheel = "P", contact = "Q", rate = "w2" }
4 = { points = ["O", "P"], rate = "wc" }
[frame]
hinges = ["O"]
"""


@pytest.mark.parametrize(("written", "told"), [
    ("= -(w1", None), ("= (w1", r"Link 2 turns at -30\.1914 rad/s at t = 1\.2 s .* its rate w2 is 35\.1914 rad/s"),
])  # fmt: skip
def test_a_planet_is_judged_where_each_drive_leads(written, told):
    """While the carrier waits, the wrong sign looks like an angle counted clockwise; Willis: w2 = wc - (w1 - wc) z1/z2."""
    run = coursework.solve(coursework.parse_variant(TRAIN.replace("= -(w1", written)), "rk4", quantities=("table", "checks"))
    otherwise = said_otherwise(run.scene.equations, run.motion.t, run.motion.coordinates)
    assert re.search(told, otherwise[1]) if told else not otherwise
    assert ("Equation 1 does not fit how the links move: a sign is wrong" in run.summary) is bool(told)


@pytest.mark.parametrize("largest", [0.02, 300.0])
@pytest.mark.parametrize(("found", "named", "others", "told"), [
    ([0.5, 0.7], [0.5, 0.7 + 0.9e-6], [], None), ([0.5, 0.7], [0.5, 0.7 + 1.1e-6], [], ("alone", 0.7)),
    ([0.5, -0.7], [-0.5, 0.7 + 0.9e-6], [], None), ([0.5, -0.7], [-0.5, 0.7 + 1.1e-6], [], ("alone", -0.7)),
    ([0.9e-6, 0.0], [1.0, 0.3], [], ("alone", 0.0)), ([1.1e-6, 0.0], [1.0, 0.3], [], ("alone", 1.1e-6)),
    ([0.5, 0.7], [0.2, 0.2], [0.5, 0.7 + 0.9e-6], ("as", 0.7)), ([0.5, 0.7], [0.2, 0.2], [0.5, 0.7 + 1.1e-6], ("alone", 0.7)),
    ([0.5, 0.7, 0.9], [0.5, 0.7 + 0.9e-6, 0.1], [], ("alone", 0.9)),
    ([0.5, 0.7, 0.9], [0.5, 0.7 + 1.1e-6, 0.1], [], ("alone", 0.7)),
])  # fmt: skip
def test_a_rate_may_be_off_by_a_millionth_of_the_largest(largest, found, named, others, told):
    """Rates in parts of the largest; the third is of no time of the run, and told only if the first two agree."""
    variant = SimpleNamespace(links=[], forces=None, bindings=[], file="", nearest_line=lambda *_: 1)
    closure = SimpleNamespace(configurations=(np.arange(2.0),), equations=SimpleNamespace(variant=variant))
    of = [("w3", largest * np.array(others))] if others else []
    rates = (largest * np.array(one)[:, None] for one in (found, named))
    fault = _of_link(SimpleNamespace(link="2", rate="w2"), closure, np.arange(3.0), *rates, largest, of)
    said = fault and (fault.message.key.rpartition(".")[2], fault.message.values["found"])
    assert said == (told and (told[0], pytest.approx(largest * told[1], rel=1e-12)))


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e7])
@pytest.mark.parametrize(("turns", "moves", "unfit"), [("-(w1", "-", ()), ("(w1", "-", ("1",)), ("-(w1", "", ("2",))])
def test_a_sign_is_told_beside_equations_of_another_unit_at_any_size(size, turns, moves, unfit):
    """The centre of the planet moves at v = -R wc sin(pc): of metres a second, beside radians, that is little or all there is."""
    text = TRAIN.replace("= -(w1", f"= {turns}").replace("3 mm", f"{size!r} m").replace(
        "[time]", '[unknowns]\nv = { unit = "m/s", of = "P", along = "0 deg" }\n[time]'
    ).replace("[points]", f'[[constraint]]\nequation = "v = {moves}m*(z1 + z2)/2*wc*sin(pc)"\n[points]')  # fmt: skip
    run = coursework.solve(coursework.parse_variant(text), "rk4")
    assert misfits(run.scene.equations, run.motion.t, run.motion.coordinates) == ((), unfit)
