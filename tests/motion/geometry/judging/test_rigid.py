"""Links that do not keep their shape, rails across the way of their point, circles that no wheel touches are told by name."""

import cmath
import math
import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.geometry.judging.rails import _degrees
from coursework.motion.geometry.judging.rigid import _Seen
from coursework.variant.formula.reader import parse
from coursework.variant.record.held import is_arm
from tests.commands.test_cli import call
from tests.mechanisms.library import mechanism
from tests.motion.geometry.judging.test_turning import closure

TRAMMEL = mechanism("trammel")
# A cylinder, whose two ends are a link: its length is a coordinate.
CYLINDER = mechanism(
    "boom", ('points = ["B"], rate = "w2"', 'points = ["B", "C"], rate = "w2"'),
    ('3 = { points = ["C"], slides = 2, rate = "w2" }\n', ""),
)  # fmt: skip
# A slider that starts from rest, almost as far from a hinge as its coordinate says.
BESIDE = ("[[group]]", 'S = "(x, 0)"\n[[group]]'), ('A = "(0, 0)"', 'A = "(0, 0.001)"')


@pytest.mark.parametrize("text", [TRAMMEL, CYLINDER], ids=["trammel", "cylinder"])
def test_what_keeps_its_shape_or_is_meant_to_grow_is_not_told(text):
    assert closure(text).names


def test_a_circle_that_no_wheel_rolls_on_may_be_drawn_beside():
    slip = (
        'circles = [ { center = "O", radius = "R0" } ]',
        'circles = [ { center = "O", radius = "R" }, { center = "O", radius = "R0" } ]',
    )
    assert closure(mechanism("epicyclic"), slip).agreed


def test_wheels_that_roll_on_each_other_need_no_circle():
    """A wheel about O touches the planet where the ring was: the circle, larger now, is no longer what it rolls on."""
    slips = (
        ('radius = "R0"', 'radius = "1.01*R0"'),
        ('3 = { points = ["E"', '4 = { wheel = "O", contact = "P" }\n3 = { points = ["E"'),
    )
    assert closure(mechanism("epicyclic"), *slips).names


@pytest.mark.parametrize(
    ("text", "slip", "told"),
    [
        (
            mechanism("31"),
            ('["M", "B", "C"]', '["M", "A", "C"]'),
            r"V314 .*A and . of link 3 are .* keep their distance\. .*keeps it to",
        ),
        (
            TRAMMEL,
            ('through = "B", angle = "90 deg"', 'through = "B", angle = "0 deg"'),
            r'V316 .*through B lies at 0°.*angle = "90 deg", or correct B in .points. or what .closure. holds',
        ),
        (
            mechanism("slider-crank"),
            ('"A", angle = "0", offset', '"A", angle = "0.5", offset'),
            r"V316 .*through C lies at 0°, and C moves along (28\.6479|-151\.352)°",
        ),
        (
            mechanism("driven-slider", *BESIDE),
            ("[frame]", '[links]\n1 = { points = ["A", "S"] }\n[frame]'),
            r"V314 .*A and S of link 1 are .* keep their distance\.",
        ),
        (TRAMMEL, ('through = "B", angle = "90 deg"', 'through = "E", angle = "90 deg"'), "V316 .*E leaves that line"),
        (mechanism("epicyclic"), ('radius = "R0"', 'radius = "1.01*R0"'), "V317 .*radius of 0.1.* contact P is 0.1"),
        (mechanism("epicyclic"), ('R0 @ phi1"  ', 'R0*(1.1 + 0.1*sin(phi1)) @ phi1"  '), "V317 .*contact P is 0.132 m from O"),
        (mechanism("31"), ('P = "C - (0, r3/2)"', 'P = "C - (r3/20, r3/2)"'), "V318 .*wheel 4 .*from C to P"),
        (mechanism("31"), ('hinges = ["D"]', 'hinges = ["D", "A"]'), "V319 .*A moves: at t = .*Take it out of hinges"),
        (
            mechanism("31"),
            ('wheel = "C", contact = "P"', 'wheel = "C", contact = "C"'),
            "V325 .*wheel 4 .*contact C lies in its centre C",
        ),
        (mechanism("31"), ('P = "C - (0, r3/2)"', 'P = "C + 0*(C - B)"'), "V325 .*wheel 4 .*contact P lies in its centre C"),
        (mechanism("epicyclic"), ('P = "O + R0 @ phi1"', 'P = "O + R0 @ (phi1 + 0.01)"'), "V318 .*wheel 2 .*from C to P"),
    ],
    ids=[
        "link",
        "rail",
        "slope",
        "almost as long as a coordinate",
        "curved",
        "circle",
        "circle at the start",
        "contact on a rail",
        "moving hinge",
        "contact that is its centre",
        "contact in its centre",
        "contact in a ring",
    ],
)
def test_a_link_or_frame_that_contradicts_the_points_is_told(text, slip, told):
    with pytest.raises(coursework.InputError, match=told):
        closure(text, slip)


@pytest.mark.parametrize(("turned", "told"), [("9e-7", False), ("1.2e-6", True)])
def test_a_rail_may_be_off_by_a_millionth_of_the_way(turned, told):
    slip = 'through = "B", angle = "90 deg"', f'through = "B", angle = "pi/2 + {turned}"'
    if told:
        with pytest.raises(coursework.InputError, match="V316"):
            closure(TRAMMEL, slip)
    else:
        assert closure(TRAMMEL, slip).complete


@pytest.mark.parametrize(("part", "told"), [(0.9e-6, False), (1.1e-6, True)])
def test_a_circle_may_be_off_by_a_millionth_of_the_largest_length(part, told):
    whole = closure(mechanism("epicyclic"))
    slip = 'radius = "R0"', f'radius = "R0*(1 + {part * whole.scale / whole.equations.variant.values["R0"]!r})"'
    if told:
        with pytest.raises(coursework.InputError, match="V317"):
            closure(mechanism("epicyclic"), slip)
    else:
        assert closure(mechanism("epicyclic"), slip).names == whole.names


def test_a_bar_that_its_sleeve_leaves_is_told():
    with pytest.raises(coursework.InputError, match=r"V315 .*link 4 slides along link 2, and its point O lies"):
        closure(mechanism("v107"), ('slides = "3"', 'slides = "2"'))


def test_what_is_nothing_but_round_off_is_told_as_nought():
    """The pin begins on its lever, to the digits of the start, and leaves it: the angle held is not that of the pin."""
    lever = mechanism("slotted-lever-by-an-angle", ("atan2(B.y, B.x)", "atan2(B.y, B.x) - sin(q1) + sin(0.4)"))
    with pytest.raises(coursework.InputError, match=r"V315 .*point B lies 0 m beside the points of that bar at t = 0 and 0\.0"):
        closure(lever)


@pytest.mark.parametrize(("turned", "degrees"), [(-6.7e-15, "0"), (-1e-9, "0"), (-1e-7, "-6e-06"), (-math.pi / 2 + 1e-15, "90")])
def test_the_way_of_a_point_is_told_with_the_digits_that_it_has(turned, degrees):
    assert f"{_degrees(cmath.exp(1j * turned)):.6g}" == degrees


def test_a_start_with_few_digits_tells_nothing_of_links():
    """What its loops leave open would be kept, and would not turn with the links."""
    text = TRAMMEL.replace('start = "24 cm"', 'start = "23.9 cm"').replace(
        'start = "53.13010235415598 deg"', 'start = "53.1 deg"'
    )
    assert closure(text).agreed == ("x", "y")


def test_a_start_that_leaves_a_given_pivot_beside_its_link_is_among_what_may_be_wrong():
    """R - c @ phi3 is held where the start puts it: with phi3 as it closes that is Q, and the file is right.

    Both starts share the compiled template, and which of them is looked at first makes no difference.
    """
    held = ("[closure]", '[links]\n3 = { points = ["Q", "R"], rate = "w3" }\n[closure]'), ("(R - Q - c @ phi3)", "(R - c @ phi3)")
    text = mechanism("four-bar-by-its-points", *held)
    assert closure(text).names
    with pytest.raises(coursework.InputError, match=r"V314 .*Q and R of link 3 .*, or the start values, with which"):
        closure(text, ("1.5448169061004255", "1.3448169061004255"))


def test_a_crank_does_not_grow_to_the_slider_whose_way_is_measured_from_its_pivot():
    with pytest.raises(coursework.InputError, match=r"V314 .*A and C of link 1 are 1\.6 m apart"):
        closure(mechanism("example-2"), ('["A", "B"],', '["A", "B", "C"],'))


@pytest.mark.parametrize(
    ("end", "base", "is_one"),
    [
        ("A + r @ phi", "(1, 0)", True), ("A - r @ phi", "(1, 0)", True), ("r @ phi", "(0, 0)", True),
        ("r @ phi", "(1, 0)", False), ("A + (r, 0)", "(1, 0)", False),
        ("A + r @ phi + b @ psi", "(1, 0)", False), ("B + r @ phi", "(1, 0)", False),
    ],
)  # fmt: skip
def test_an_arm_is_one_vector_from_its_base(end, base, is_one):
    assert is_arm(parse(end, vectors=True), "A", parse(base, vectors=True)) is is_one


def bare31(hinges: str, *changes: tuple[str, str]) -> str:
    text = coursework.load("31").path.read_text(encoding="utf-8").replace('driven = "M"', "").replace('holds  = ["C.y"]', "")
    for right, wrong in (('hinges = ["D"]', f"hinges = {hinges}"), *changes):
        assert right in text
        text = text.replace(right, wrong)
    return text


@pytest.mark.parametrize("hinges", ['["D", "B"]', '["B", "D"]'])
def test_only_the_hinge_is_named_that_the_equations_move(hinges):
    """Without [closure] the frame says what is held: B held, nothing else can be, and the guide of P would lie across."""
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(coursework.parse_variant(bare31(hinges))).compute()
    (fault,) = caught.value.faults
    assert fault.code == "V319" and "and B moves" in str(fault)


def test_a_hinge_that_moves_is_named_where_more_is_held_than_is_free():
    more = ('holds  = ["C.y"]', 'holds = ["C.y", "C.y + 2*C.y"]'), ('hinges = ["D"]', 'hinges = ["D", "B"]')
    text = coursework.load("31").path.read_text(encoding="utf-8")
    for right, wrong in more:
        text = text.replace(right, wrong)
    with pytest.raises(coursework.InputError, match=r"V319 .*and B moves"):
        coursework.solve(coursework.parse_variant(text)).compute()


def test_a_rail_of_a_point_that_nothing_holds_is_not_judged_and_the_advice_holds_it(tmp_path, monkeypatch):
    """C was said to move along 0°, and the rail to be wrong: with phi2 left at its start it did."""
    monkeypatch.chdir(tmp_path)
    text = mechanism("guided-driver", ('holds = ["B.y", "C.x*sin(gam) - C.y*cos(gam)"]', 'holds = ["B.y"]'))
    (tmp_path / "loose.toml").write_text(text, encoding="utf-8")
    told = call("check", "loose").stdout
    assert "[closure] does not say that C stays in its guide." in told
    holds = re.search(r"Write there (holds = \[.*?\]);", told)[1]
    (tmp_path / "held.toml").write_text(text.replace('holds = ["B.y"]', holds), encoding="utf-8")
    assert "2 position equations determine every coordinate." in call("check", "held").stdout
    leaning = text.replace('holds = ["B.y"]', holds).replace('angle = "gam"', 'angle = "30 deg"')
    with pytest.raises(coursework.InputError, match=r"V316 .*through C lies at 30°, and C moves along 60°"):
        _ = coursework.solve(coursework.parse_variant(leaning)).table


def test_a_driven_point_that_nothing_moves_is_to_be_given_a_coordinate():
    still = mechanism("guided-driver", ('M = "(0, yM)"', 'M = "(0, 0)"'), ("[closure]\n", '[closure]\ndriven = "M"\n'), yM=None)
    with pytest.raises(coursework.InputError, match=r'V304 .*Write yM = { start = "0 m", rate = "VMy" } in \[coordinates\]'):
        _ = coursework.solve(coursework.parse_variant(still)).table


def seen(size, tracks, *growing):
    """Three positions of points, in parts of the largest length (m), with a wheel about C that touches at P."""
    wheel = SimpleNamespace(name="4", wheel="C", contact="P")
    variant = SimpleNamespace(links=[wheel], points=(), file="", nearest_line=lambda *_: 1)
    places = {name: size * np.array(track, dtype=complex) for name, track in tracks.items()}
    return _Seen(variant, np.arange(3.0), places, [size * np.array(one) for one in growing], size, frozenset())


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize("part", [0.995, 1.005])
def test_limits_are_shares_of_the_largest_length_or_of_the_way(size, part):
    """A millionth of the length for a distance; for a path a millionth of its way and 1e-9 of the length."""
    inside, off, way = part < 1, part * 1e-6, part * (1e-6 * 0.1 + 1e-9)
    assert seen(size, {"A": [0, 0, 0], "B": [1, 1j, -1 - off]}).keeps("A", "B") is inside
    assert len([*seen(size, {"C": [0, 0, 0], "P": [1, off, 1]}).of_wheels()]) == inside
    assert seen(size, {})._leaves(size * np.array([0, 0.05 + 1j * way, 0.1]), 1) is not inside
    assert seen(size, {"A": [0, 0, 0], "B": [0.3, 0.4, 0.4]}, [-0.2, -0.3, -0.3 - way])._grows("A", "B") is inside
    told = seen(size, {})._between(size * np.array([part * 1e-9, 0.0, -0.5]))
    assert (told["first"] == 0.0) is inside and (told["last"], told["time"]) == (0.5 * size, 2.0)
