"""Every length given between things drawn stands on the drawing: beside a part, on a dimension line as long as the scale says."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.figures import draw_start, room
from coursework.drawing.lettering.dimensions import HEAD, TIGHT
from coursework.drawing.lettering.naming import _unsaid
from coursework.drawing.lettering.offsets import _beside
from coursework.drawing.outline.ground import rail_side
from coursework.drawing.outline.lengths import lengths
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.sheet import Sheet
from coursework.mechanism.mechanism import build
from coursework.report.text.symbols import symbol
from coursework.variant.catalogue import names
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import evaluate_any, named, spelled
from coursework.words.data_folders import folder
from tests.drawing import measured
from tests.mechanisms.library import mechanism
from tests.sample import sampled
from tests.solved import solved

# What lies at no point drawn, or changes with the motion: an origin, a drive's radius, the law of a crank's length, centres of
# mass and the ends of a spring; and the way between two pins one of which lies on the other.
ABSENT = {
    "andrews": {"rr"},
    "andrews-forces": {"xc", "yc", "sc", "sd", "ra", "da", "sa", "sb", "ea", "fa", "ta", "tb", "ua", "ub"},
    "epicyclic": {"rho"},
    "v112": {"xC0"},
    "variable-crank-exact": {"l1"},
}
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")


def scale_of(caption: str) -> float:
    found = re.search(r"scale (\d[\d.]*):(\d+(?:\.\d+)?)", caption)
    assert found is not None
    return 1000 * float(found[1]) / float(found[2])


def ends_of(svg: str, word: str) -> tuple[complex, complex]:
    """Return the tips of both arrows of a dimension."""
    first, second = (line for line in measured.lines(svg, "data-dimension") if line.says["data-dimension"] == word)
    tips = [line.b + HEAD * (line.b - line.a) / abs(line.b - line.a) for line in (first, second)]
    return tips[0], tips[1]


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(names()))
def test_every_given_length_is_written_on_the_drawing(name: str) -> None:
    run = solved(name, quantities=["table"])
    drawing = run.mechanism()
    assert drawing is not None
    written = " ".join(word.text.translate(_LOWERED).replace("ℓ", "l") for word in measured.words(drawing.svg))
    missing = {
        datum.name
        for datum in run.variant.given
        if datum.si == "m"
        and symbol(datum.name).text.translate(_LOWERED).replace("_", "") not in re.split(r"[^\w]|(?<=\d)(?=\D)", written)
    }
    assert missing == ABSENT.get(name, set())


@pytest.mark.parametrize(
    ("name", "word", "metres"), [("engine-start", "e", 0.01), ("v112", "xD", 0.0986648), ("jansen", "ℓ", 0.0078)]
)
def test_a_short_dimension_has_its_arrows_outside_and_is_true_to_scale(name: str, word: str, metres: float) -> None:
    drawing = solved(name, quantities=["table"]).mechanism()
    assert drawing is not None
    first, second = ends_of(drawing.svg, word)
    assert abs(second - first) == pytest.approx(metres * scale_of(drawing.caption), abs=0.02)
    tails = [line.a for line in measured.lines(drawing.svg, "data-dimension") if line.says["data-dimension"] == word]
    is_outside = abs(tails[1] - tails[0]) > abs(second - first)
    assert is_outside == (abs(second - first) <= TIGHT)


@pytest.mark.parametrize(("name", "word"), [("oscillating-cylinder", "e"), ("prp", "ri")])
def test_an_offset_that_a_link_has_stands_beside_that_part(name: str, word: str) -> None:
    svg = solved(name, quantities=["table"]).mechanism().svg  # type: ignore[union-attr]
    slots = [line for line in measured.lines(svg, "data-link") if "data-slot" in line.says]
    stub = min(slots, key=lambda line: abs(line.b - line.a))
    [label] = [one for one in measured.words(svg) if one.text == word]
    assert measured.beside(label, stub) < 5 or measured.led(svg, label, [stub])


def test_a_datum_by_chance_as_long_as_a_part_is_not_taken_for_it() -> None:
    """The third side of the triangle P1, Y, P3 is e; two data of its length, or one a part in a million longer, are none."""
    variant = load("jansen")

    def written(**values: float) -> set[str]:
        changed = tuple(replace(datum, value=values.get(datum.name, datum.value)) for datum in variant.given)
        run = solve(replace(variant, given=changed), quantities=["table"])
        drawing = draw_start(run.scene.mechanism, run.scene.equations, run.motion, run.scene.start)
        assert drawing is not None
        return {word.text for word in measured.words(drawing.svg)}

    assert {"e", "h"} <= written()
    assert "e" not in written(h=0.0558)


UNUSED = mechanism("one-arm")


def test_a_datum_that_places_nothing_is_no_length_of_a_part() -> None:
    """On one line CD = L - c = 1.1 m: the b of the file, which no point needs, says something else."""
    words = {word.text for word in measured.words(solve(parse_variant(UNUSED), quantities=["table"]).mechanism().svg)}  # type: ignore[union-attr]
    assert "c" in words and "b" not in words


@pytest.mark.parametrize(("rolls", "place", "side"), [(True, 1j, -1), (True, -1j, 1), (False, 1j, 1), (False, -1j, 1)])
def test_the_ground_lies_below_the_wheel_that_rolls_on_a_guide_else_where_no_points_are(
    rolls: bool, place: complex, side: int
) -> None:
    """Another wheel and most points are below the guide, 3 m; the guide of a slider looks at all points but its own."""
    rail = SimpleNamespace(base="A", toward="B", at="A", rider="K", rolls=rolls)
    wheels = [SimpleNamespace(centre="M", contact="K"), SimpleNamespace(centre="N", contact="L")]
    outline = SimpleNamespace(wheels=wheels, shown=("A", "B", "K", "M", "N"))
    places = {"A": 0j, "B": 1 + 0j, "K": 9j, "M": place, "N": -3j, "L": -4j}
    assert rail_side(outline, places, rail) == side  # type: ignore[arg-type]


def test_the_arrow_of_a_driven_point_has_room_on_the_sheet() -> None:
    """13 mm upwards, which is towards smaller numbers on paper."""
    run = solve("31", quantities=["table"])
    outline = read_outline(run.scene.mechanism)
    assert outline is not None
    poses = read_poses(outline, run.scene.equations)(np.array(run.motion.t), run.motion.coordinates)
    bare, pointed = (list(room(outline, poses, [0], arrows, 50.0)) for arrows in ({}, {"M": 1j}))
    ((at, radius),) = pointed[len(bare) :]
    assert at == pytest.approx((50 * poses.pose(0)["M"]).conjugate() - 13j) and radius > 5


def test_the_ground_of_a_guide_lies_on_one_side_in_every_row() -> None:
    run = solve("v110", quantities=["table"])
    outline = read_outline(run.scene.mechanism)
    assert outline is not None
    poses = read_poses(outline, run.scene.equations)(np.array(run.motion.t), run.motion.coordinates)
    sides = [{rail_side(outline, poses.pose(row), rail) for row in range(len(run.motion.t))} for rail in outline.rails]
    assert any(len(side) == 2 for side in sides), "the mean of the points goes over the line of the guide"

    def grounds(row: int) -> list[tuple[complex, complex]]:
        painter = Painter(
            Sheet(200.0, 200.0, (0.0, 0.0, 200.0, 200.0)), outline, poses, row, lambda z: 100 + 100j + 50 * z.conjugate(), 50.0
        )
        painter.fixed()
        return painter.grounds

    assert len(grounds(0)) == 2
    assert all(grounds(row) == grounds(0) for row in range(1, len(run.motion.t)))


def test_an_origin_without_a_name_is_marked_where_data_count_from_it() -> None:
    """K of v110 is at (xK, yK); in v112 the origin is O, in variant 31 nothing counts from it."""
    svg = solve("v110", quantities=["table"]).mechanism().svg  # type: ignore[union-attr]
    [mark] = [word for word in measured.words(svg) if word.text == "0"]
    tips = ends_of(svg, "xK")
    assert min(abs(tip.real - (mark.box[0] + mark.box[2]) / 2) for tip in tips) < 5
    for name in ("v112", "31"):
        assert all(word.text != "0" for word in measured.words(solved(name, quantities=["table"]).mechanism().svg))  # type: ignore[union-attr]


@pytest.mark.parametrize("name", ["example-4", "31"])
def test_no_length_of_a_part_stands_above_another_as_in_a_fraction(name: str) -> None:
    given = {datum.name for datum in solved(name).variant.given}
    scene = solved(name).scene
    svg = draw_start(scene.mechanism, scene.equations, solved(name).motion, scene.start).svg
    boxes = [word.box for word in measured.words(svg) if word.text.translate(_LOWERED) in given]
    assert len(boxes) >= 3
    for place, (left, top, right, bottom) in enumerate(boxes):
        for other in boxes[place + 1 :]:
            if min(right, other[2]) > max(left, other[0]):
                assert max(top, other[1]) - min(bottom, other[3]) > 4.0  # mm between what is inked


def test_a_chain_draws_a_link_on_to_a_point_past_its_joint_and_dimensions_the_whole_of_it() -> None:
    text = (folder("variants") / "chebyshev.toml").read_text(encoding="utf-8")
    chain = parse_variant(re.sub(r"(?s)\[links\].*?\n\n", "", text, count=1))
    outline = read_outline(solve(chain, quantities=["table"]).scene.mechanism)
    assert outline is not None
    assert [bar.corners for bar in outline.bars if bar.link == "2"] == [("B", "C", "P")]


def test_a_length_that_a_closure_a_point_or_a_law_uses_helps_to_place_and_one_of_velocities_alone_does_not() -> None:
    given = [SimpleNamespace(name=name, si=si, value=1.0) for name, si in (*((name, "m") for name in "abcdehk"), ("p", "1/s"))]
    variant = SimpleNamespace(given=given, holds=[parse("c*sin(phi)")], functions=[SimpleNamespace(formulas=[parse("d + p*t")])])
    sides = (parse("a*cos(phi)"), parse("s"))
    closure, rates = ([SimpleNamespace(is_closure=whole, sides=(left, sides[1]))] for whole, left in (
        (True, sides[0]), (False, parse("k*w")),
    ))  # fmt: skip
    points = {name: parse(text, vectors=True) for name, text in (("A", "b @ phi"), ("B", "(h, 0)"), ("C", "A + e @ psi"))}
    mechanism = SimpleNamespace(points=tuple(points.items()), variant=variant, constraints=(*closure, *rates))
    assert _unsaid(mechanism, {frozenset("AC"): parse("e")}) == dict.fromkeys("abcd", 1.0)  # h and e are said already


@pytest.mark.parametrize("name", [*names(), "four-bar-along-its-chain"])
def test_a_length_is_that_between_its_points_where_the_motion_starts(name: str) -> None:
    """A sum that only keeps its value, as that which leads to a pivot along the chain, gives no length across it."""
    run = solved(name, quantities=["table"]) if name in names() else solve(parse_variant(mechanism(name)), quantities=["table"])
    variant, found = run.variant, build(run.variant)
    place: dict[str, complex] = {**variant.values, "pi": math.pi, "t": 0.0}
    place |= {one.name: run.motion.column(one.name)[0] for one in variant.coordinates}
    outline = read_outline(found)
    assert outline is not None
    poses = read_poses(outline, run.scene.equations)(run.motion.t[:1], run.motion.coordinates[:1])
    for ends, length in lengths(found).items():
        if place.keys() >= {*length.names()} and poses.at.keys() >= ends:
            first, last = (poses.at[end][0] for end in ends)
            assert abs(last - first) == pytest.approx(abs(evaluate_any(length, place)), rel=0.02), (ends, spelled(length))


@pytest.mark.parametrize(("drive", "length"), [("s", 1.5), ("phi", None)])
def test_a_driven_length_is_dimensioned_and_one_that_is_sought_is_not(drive: str, length: float | None) -> None:
    """No bent arrow shows how a cylinder is driven; its length of 1.5 m at the start runs from B to C."""
    sought = ('us = "v1*sin(p*t)"', 'w1 = "v1*sin(p*t)/c"')
    turned = [sought, ('rate = "us"', 'rate = "v"')] if drive == "phi" else []
    drawing = solve(parse_variant(mechanism("boom", *turned))).mechanism()
    assert drawing is not None
    if length is None:
        assert not [line for line in measured.lines(drawing.svg, "data-dimension") if line.says["data-dimension"] == "s"]
    else:
        begin, end = ends_of(drawing.svg, "s")
        assert abs(end - begin) == pytest.approx(length * scale_of(drawing.caption), abs=0.1)


@pytest.mark.parametrize("scale", [0.004, 250.0])
@pytest.mark.parametrize(("part", "beside"), [(0.98e-6, True), (-0.98e-6, True), (1.02e-6, False), (-1.02e-6, False)])
def test_an_offset_is_where_it_is_measured_within_a_millionth_of_the_distance(scale, part, beside):
    """A block at 3 + 4j from A, whose guide lies along x: 4 beside it, 5 away."""
    at = {name: scale * place for name, place in (("A", 0j), ("B", 3 + 4j), ("E", 9 + 4j))}
    outline = SimpleNamespace(blocks=[SimpleNamespace(at="B", base="B", toward="E")], slots=[])
    found = [*_beside(SimpleNamespace(at=at, outline=outline, slot_line=None), named("e"), scale * (4 + 5 * part), "A", "B")]
    assert [(one.point, one.rider) for one in found] == ([("A", "B")] if beside else [])
