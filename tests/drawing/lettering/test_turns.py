"""Every coordinate that is an angle has one arc on Figure 1: from its axis, about its origin, in the sense of its value."""

from __future__ import annotations

import cmath
import math
import re
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.figures import draw_start
from coursework.drawing.lettering.turns import _Arm, _begin, _centre, _gap_begin, _line, _rank, clockwise_rates, turns
from coursework.mechanism.mechanism import build
from coursework.variant.catalogue import names
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import Formula, evaluate_any, signed
from tests.drawing import measured
from tests.drawing.lettering.test_angles import arc_of, turned
from tests.drawing.outline.test_mechanism import drawing_of, run_of
from tests.mechanisms.library import mechanism
from tests.sample import sampled


def svg_of(text: str) -> str:
    """Return the drawing of the start of a file, links on one line or not."""
    run = solve(parse_variant(text), quantities=["table"])
    drawing = draw_start(run.scene.mechanism, run.scene.equations, run.motion, run.scene.start)
    assert drawing is not None
    return drawing.svg


def centre_of(arc: list[complex]) -> complex:
    """Return the middle of the circle through the ends and the middle of an arc."""
    a, b, c = arc[0], arc[len(arc) // 3], arc[-1]
    w = (c - a) / (b - a)
    return a + (b - a) * (w - abs(w) ** 2) / (w - w.conjugate())


def direction(arc: list[complex], end: int) -> float:
    """Return the direction (degrees, counter-clockwise as seen) in which an end of an arc lies from its origin."""
    return math.degrees(cmath.phase((arc[end] - centre_of(arc)).conjugate()))


@pytest.mark.parametrize("name", sampled(names()))
def test_every_angle_has_one_arc_as_large_as_it_is_drawn(name: str) -> None:
    run, drawing = run_of(name), drawing_of(name)
    row = int(re.search(r"row (\d+)", drawing.caption)[1])  # type: ignore[index]
    motion = run.motion  # nothing asked for needs the exact one
    counted = [c.name for c in run.variant.coordinates if c.unit == "rad"]
    assert set(counted) <= measured.names(drawing.svg, "data-angle")
    for angle in counted:
        arc = arc_of(drawing.svg, angle)
        value = run.scene.start[motion.coordinate_names.index(angle)] if row == 1 else float(motion.column(angle)[row - 1])
        size = math.degrees(-value if -math.pi < value < -0.03 else value % math.tau)
        if math.degrees(0.03) < size < 360 - 1e-6:
            assert (turned(arc) > 0) is (not -math.pi < value < -0.03) or angle == "theta"
            assert abs(math.degrees(turned(arc))) == pytest.approx(size, abs=1.0)
        else:
            assert math.degrees(turned(arc)) == pytest.approx(math.degrees(0.6), abs=1.0)


def test_names_stand_beside_their_arcs() -> None:
    svg = drawing_of("31").svg
    for place in "123":
        [word] = [one for one in measured.words(svg) if one.text == f"φ{place}"]
        others = [at for other in "123" if other != place for at in arc_of(svg, f"phi{other}")]
        near = min(measured.apart(word, at) for at in arc_of(svg, f"phi{place}"))
        assert near < min(measured.apart(word, at) for at in others)


def test_arcs_begin_on_their_axis_and_end_on_their_link() -> None:
    svg = svg_of(mechanism("three-arms"))
    ends = {name: (direction(arc, 0), direction(arc, -1)) for name in ("q1", "q2", "psi") if (arc := arc_of(svg, name))}
    assert ends["q1"] == pytest.approx((0, 50), abs=0.1)
    assert ends["q2"] == pytest.approx((50, 80), abs=0.1)  # from the line of the first arm
    assert ends["psi"] == pytest.approx((90, 20), abs=0.1)  # clockwise, as the file counts it
    assert turned(arc_of(svg, "psi")) < 0
    sides = {line.says["data-from"]: line.a for line in measured.lines(svg, "data-link")}
    for name, origin in (("q1", "O"), ("q2", "A"), ("psi", "B")):
        assert abs(centre_of(arc_of(svg, name)) - sides[origin]) < 0.01


@pytest.mark.parametrize(
    ("degrees", "size", "said"),
    [
        ("-40", -40.0, "q2\u00a0< 0"), ("-170", -170.0, "q2\u00a0< 0"), ("-190", 170.0, "q2"),
        ("400", 40.0, "q2"), ("1.8", 1.8, "q2"), ("1.6", 34.4, "q2\u00a0≈ 0"), ("0", 34.4, "q2\u00a0= 0"),
        ("360", 34.4, "q2\u00a0= 0"), ("-1.6", 34.4, "q2\u00a0≈ 0"), ("-1.8", -1.8, "q2\u00a0< 0"),
    ],
)  # fmt: skip
def test_an_angle_is_drawn_in_the_sense_of_its_value_and_one_of_nought_is_told(degrees: str, size: float, said: str) -> None:
    svg = svg_of(mechanism("three-arms", ('"30 deg"', f'"{degrees} deg"')))
    assert math.degrees(turned(arc_of(svg, "q2"))) == pytest.approx(size, abs=0.2)
    assert said in {word.text for word in measured.words(svg)}


@pytest.mark.parametrize(("degrees", "against"), [("-40", True), ("40", False)])
def test_the_caption_tells_of_an_arc_against_the_positive_sense(degrees: str, against: bool) -> None:
    run = solve(parse_variant(mechanism("three-arms", ('"30 deg"', f'"{degrees} deg"'))), quantities=["table"])
    caption = draw_start(run.scene.mechanism, run.scene.equations, run.motion, run.scene.start).caption  # type: ignore[union-attr]
    assert "in its positive sense" in caption
    assert ("one marked <\u00a00 runs against it." in caption) is against


def test_an_arrow_ends_each_arc() -> None:
    svg = drawing_of("31").svg
    heads = [node.get("d", "") for node in ElementTree.fromstring(svg).iter() if node.get("fill") == "black" and node.get("d")]
    tips = [measured.points(head)[0] for head in heads]
    for name in ("phi1", "phi2", "phi3"):
        assert min(abs(tip - arc_of(svg, name)[-1]) for tip in tips) < 1e-3


FIVE_BAR = mechanism(
    "five-bar", ('"30 deg"', '"60 deg"'), r1="0.12 m", r2="0.30 m", r3="0.32 m", r4="0.10 m", d="0.35 m", n4="-90 rpm",
    step="0.02 s", end="1 s", period=None, quantities=None,
)  # fmt: skip


def test_both_drives_of_a_five_bar_and_its_dyad_are_counted_where_they_begin() -> None:
    svg = svg_of(FIVE_BAR)
    sides = {line.says["data-from"] + line.says["data-to"]: line for line in measured.lines(svg, "data-link")}
    for name, side in (("phi1", "AB"), ("phi2", "BC"), ("phi3", "DC"), ("phi4", "ED")):
        arc = arc_of(svg, name)
        assert abs(centre_of(arc) - sides[side].a) < 0.01
        way = cmath.phase((arc[-1] - sides[side].a) / (sides[side].b - sides[side].a))
        assert abs(way) < 1e-3
        assert math.radians(direction(arc, 0)) == pytest.approx(0.0, abs=1e-3)
    assert measured.overlaps(svg) == []


def test_an_arm_is_found_in_what_the_motion_keeps() -> None:
    """E of variant V105 hangs on two chains; its last arm stands in [closure] only."""
    variant = load("v105")
    run = run_of("v105")
    mechanism = build(variant)
    values = {**variant.values, "pi": math.pi, **dict(zip(run.motion.coordinate_names, run.scene.start, strict=True))}
    found = {turn.coordinate for turn in turns(mechanism, {**values, **dict.fromkeys(dict(mechanism.points), 0j)})}
    assert found == {c.name for c in variant.coordinates if c.unit == "rad"}


VALUES = {"O": 1 + 0j, "A": 1 + 2j, "B": 5 + 0j, "C": 5 + 3j, "r1": 2.0, "q1": math.pi / 2, "r2": 3.0, "phi2": math.pi / 2}


def parts_of(text: str) -> list[tuple[Formula, int]]:
    return list(signed(parse(text, vectors=True)))


@pytest.mark.parametrize(("text", "place", "begin"), [
    ("O + r1 @ q1", 1, 1 + 0j), ("r1 @ q1 + O", 0, 0j), ("O + r1 @ q1 + r2 @ phi2", 2, 1 + 2j),
    ("O + r1 @ q1 - r2 @ phi2", 2, 1 - 1j), ("C - r2 @ phi2", 1, 5 + 0j),
])  # fmt: skip
def test_an_arm_begins_where_the_sum_before_it_ends_and_one_with_a_minus_at_its_own_end(
    text: str, place: int, begin: complex
) -> None:
    assert _begin(parts_of(text), place, VALUES) == pytest.approx(begin)


@pytest.mark.parametrize(("text", "place", "begin"), [
    ("C - B - r2 @ phi2", 2, 5 + 0j), ("B + r2 @ phi2 - C", 1, 5 + 0j), ("C - r2 @ phi2 - B", 1, 5 + 0j),
    ("O + r1 @ q1 + r2 @ phi2 - C", 2, 1 + 2j), ("O + r1 @ q1 + r2 @ phi2 - C", 1, 1 + 0j),
    ("C - O - r1 @ q1 - r2 @ phi2", 3, 1 + 2j),
])  # fmt: skip
def test_an_arm_of_a_gap_begins_at_the_points_on_its_own_side(text: str, place: int, begin: complex) -> None:
    assert _gap_begin(parts_of(text), place, VALUES) == pytest.approx(begin)


@pytest.mark.parametrize(("text", "end", "line"), [
    ("B + r2 @ phi2", "C", "BC"), ("r2 @ phi2", "C", "OC"), ("B - r2 @ phi2", "C", ""), ("B + A + r2 @ phi2", "C", ""),
    ("-B + r2 @ phi2", "C", ""), ("B + r2 @ phi2", "", ""), ("r1 @ q1 + r2 @ phi2", "C", ""),
])  # fmt: skip
def test_a_point_and_an_arm_make_a_line(text: str, end: str, line: str) -> None:
    mechanism = SimpleNamespace(points=(("O", parse("(0, 0)", vectors=True)), ("B", parse("(r1, 0)", vectors=True))))
    assert _line(mechanism, parts_of(text), end) == line  # type: ignore[arg-type]
    bare = SimpleNamespace(points=mechanism.points[1:])
    assert _line(bare, parts_of(text), end) == (line if line != "OC" else "")  # type: ignore[arg-type]


def test_an_arm_shows_a_coordinate_best_by_itself_then_beside_a_constant_then_beside_another_one() -> None:
    def arm(part: int, rest: str, is_named: bool = True) -> _Arm:
        return _Arm(0j, is_named, part, tuple(signed(parse(rest))) if rest else (), 0.0, "")

    arms = [arm(1, ""), arm(1, "", is_named=False), arm(1, "gamma"), arm(-1, ""), arm(1, "gamma", is_named=False), arm(1, "phi1"),
        arm(1, "gamma - phi1", is_named=False)]  # fmt: skip
    ranks = [_rank(one, {"phi1", "phi2"}) for one in arms]
    assert ranks == [(0, False), (0, True), (1, False), (1, False), (1, True), (2, False), (2, True)]


# By hand: the arm lies along this axis (degrees) where phi3 is 0, and turns from there in this sense.
ARMS = {
    "(r3*cos(phi3), r3*sin(phi3))": (0, 1), "(r3*cos(phi3), -r3*sin(phi3))": (0, -1),
    "(-r3*cos(phi3), r3*sin(phi3))": (180, -1), "(-r3*cos(phi3), -r3*sin(phi3))": (180, 1),
    "(r3*sin(phi3), r3*cos(phi3))": (90, -1), "(-r3*sin(phi3), r3*cos(phi3))": (90, 1),
    "(r3*sin(phi3), -cos(phi3)*r3)": (-90, 1), "(-r3*sin(phi3), -r3*cos(phi3))": (-90, -1), "r3 @ (phi3 - pi/2)": (-90, 1),
}  # fmt: skip


@pytest.mark.parametrize("arm", ARMS)
def test_an_arm_by_components_is_counted_as_they_say(arm: str) -> None:
    built, values = placed(mechanism("crank-and-driven-point", ("r3 @ phi3", arm)), phi3=0.4)
    (found,) = [turn for turn in turns(built, values) if turn.coordinate == "phi3"]
    assert found.axis == pytest.approx(cmath.exp(1j * math.radians(ARMS[arm][0])))
    assert (found.sense, found.size, found.line) == (ARMS[arm][1], pytest.approx(0.4), "CM")
    assert found.at == (values["C"],)
    assert values["M"] - values["C"] == pytest.approx(0.3 * found.axis * cmath.exp(1j * found.sense * 0.4))


def placed(text: str, **given: float) -> tuple[Any, dict[str, complex]]:
    variant = parse_variant(text)
    values: dict[str, complex] = {**variant.values, "pi": math.pi, "phi1": 1.0, "phi2": 0.8, **given}
    for name, formula in variant.points:
        values[name] = evaluate_any(formula, values)
    return build(variant), values


def test_an_angle_that_nothing_counts_is_drawn_only_where_its_link_lies_along_it() -> None:
    """The last link is held by components: from x it is the angle of CM, otherwise the file does not tell where it begins."""
    held = mechanism("crank-and-driven-point", ("C + r3 @ phi3", "(0.5, 0.1)"))
    built, values = placed(held)
    along = cmath.phase(values["M"] - values["C"])
    for angle, at in ((along, [(values["C"],)]), (along + math.pi, [(values["M"],)]), (along + 0.5, [])):
        assert [turn.at for turn in turns(built, {**values, "phi3": angle}) if turn.coordinate == "phi3"] == at


@pytest.mark.parametrize(("file", "arm", "sense"), [
    ("clockwise-four-bar", "(a*cos(f1), -a*sin(f1))", -1), ("clockwise-four-bar", "a @ (-f1)", -1),
    ("four-bar-by-its-points", "", 1),
])  # fmt: skip
def test_the_arrow_of_a_crank_turns_as_its_angle_is_counted(file: str, arm: str, sense: int) -> None:
    hinged = ("[closure]", '[links]\n1 = { points = ["O", "P"], rate = "w1" }\n[frame]\nhinges = ["O"]\n[closure]')
    svg = svg_of(mechanism(file, ("(a*cos(f1), -a*sin(f1))", arm) if arm else hinged))
    (arrow,) = [
        measured.points(node.get("d", "")) for node in ElementTree.fromstring(svg).iter() if node.get("stroke-width") == "0.3"
    ]
    assert math.copysign(1, turned(arrow)) == sense


ARM = """format = 1
[given]
r1 = "0.4 m"
v = "0.2 rad/s"
[drive]
w1 = "3 rad/s"
[functions]
g = "v*t"
[coordinates]
phi1 = { start = "0.4 rad", rate = "w1" }
[time]
step = "0.5 s"
end = "1 s"
[points]
D = "(0, 0)"
M = "D + r1 @ (ANGLE)"
[links]
1 = { points = ["D", "M"] }
[frame]
hinges = ["D"]
"""


@pytest.mark.parametrize(("angle", "against"), [("phi1 + g", False), ("g - phi1", True)])
def test_an_angle_beside_a_law_of_time_has_its_sense_but_no_arc(angle: str, against: bool) -> None:
    text = ARM.replace("ANGLE", angle)
    assert "data-angle" not in svg_of(text)
    assert clockwise_rates(build(parse_variant(text)), {"D": 0j, "M": 0.4 + 0j}) == ({"w1"} if against else set())


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("off", "leads"), [(0.0098, True), (-0.0098, True), (0.0102, False), (-0.0102, False)])
def test_a_link_leads_a_way_within_a_hundredth_of_its_length(size: float, off: float, leads: bool) -> None:
    turned_by = 2 * math.asin(off / 2)
    values: Any = {"A": 3 + 4j, "B": 3 + 4j + size * cmath.exp(1j * (0.7 + turned_by))}
    mechanism: Any = SimpleNamespace(variant=SimpleNamespace(links=[SimpleNamespace(rate="w2", wheel=None, points=("B", "A"))]))
    assert _centre(mechanism, "w2", values, cmath.exp(0.7j)) == (values["A"] if leads else None)


@pytest.mark.parametrize("name", ["31", "v108"])
@pytest.mark.parametrize("size", [1e-9, 1e7])
def test_a_mechanism_of_any_size_turns_about_the_same_places(name: str, size: float) -> None:
    """Of v108 with links of ten thousand kilometres one of two places was lost to round-off."""

    def found(size: float) -> list[tuple[str, list[complex], complex]]:
        model = build(load(name))
        lengths = {datum.name for datum in model.variant.given if datum.si == "m"}
        values: dict[str, Any] = {"pi": math.pi, "t": 0.0, **{c.name: c.start_or_guess or 0.0 for c in model.variant.coordinates}}
        values |= {each: value * size if each in lengths else value for each, value in model.variant.values.items()}
        for point, formula in model.points:
            values[point] = evaluate_any(formula, values)
        return [(one.coordinate, [at / size for at in one.at], one.axis) for one in turns(model, values)]

    assert found(size) == [(angle, pytest.approx(at), pytest.approx(axis)) for angle, at, axis in found(1.0)]
