"""The drawing of a mechanism: every file of the catalogue has one, true to its scale, and no word lies on another."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from types import SimpleNamespace

import pytest

from coursework import load, parse_variant, solve
from coursework.drawing.outline.lengths import lengths
from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.tracing import read_outline
from coursework.drawing.paper.board import SCALES
from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.record import Drawing
from coursework.drawing.paper.sheet import Sheet
from coursework.drawing.paper.symbols import decimal, powers, ratio
from coursework.mechanism.mechanism import build
from coursework.mechanism.structure import driven_freedoms
from coursework.report.wording.data_meanings import meanings
from coursework.run import Run
from coursework.variant.catalogue import names
from coursework.variant.formula.tree import spelled
from tests.drawing import measured
from tests.hard.scenes import scene
from tests.mechanisms.library import mechanism
from tests.report.own import STEPHENSON
from tests.sample import sampled
from tests.solved import solved


@cache
def run_of(name: str) -> Run:
    return solved(name, quantities=["table"])


@cache
def drawing_of(name: str) -> Drawing:
    found = run_of(name).mechanism()
    assert found is not None
    return found


def outline_of(name: str, **changes: object) -> Outline:
    found = read_outline(build(replace(load(name), **changes)))  # type: ignore[arg-type]
    assert found is not None
    return found


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(names()))
def test_every_variant_has_a_drawing_with_its_links_and_points(name: str) -> None:
    drawing, outline = drawing_of(name), outline_of(name)
    said = {word.text for word in measured.words(drawing.svg)}
    assert drawing.id == "mechanism"
    assert drawing.width <= 170
    assert drawing.height <= (90 if len(outline.bars) < 7 else 114)
    assert set(outline.names) <= said
    assert {bar.link for bar in outline.bars} <= said
    assert {"x", "y"} <= said
    drawn = measured.names(drawing.svg, "data-link")
    assert {bar.link for bar in outline.bars if len(bar.corners) > 1} <= drawn


@pytest.mark.parametrize("name", sampled(names()))
def test_no_word_lies_on_another_or_leaves_the_sheet(name: str) -> None:
    assert measured.overlaps(drawing_of(name).svg) == []
    assert measured.beyond(drawing_of(name).svg) == []


def test_the_measure_sees_words_that_meet() -> None:
    def sheet(apart: float) -> str:
        texts = "".join(f'<text x="{x}" y="9" font-size="3.2">phi</text>' for x in (5, 5 + apart))
        return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20">{texts}</svg>'

    wide = measured.size("phi", 3.2)[0]
    assert 4.5 < wide < 5.5
    assert measured.overlaps(sheet(wide - 0.01)) == [("phi", "phi")]
    assert measured.overlaps(sheet(wide + 0.01)) == []
    assert measured.beyond(sheet(35 - wide)) == []
    assert measured.beyond(sheet(35.01 - wide)) == ["phi"]


def test_links_follow_from_the_groups_where_none_are_listed() -> None:
    four_bar = outline_of("example-1", links=())
    assert [(bar.link, bar.corners) for bar in four_bar.bars] == [("1", ("A", "B")), ("2", ("B", "C")), ("3", ("D", "C"))]
    slider = outline_of("example-2", links=())
    assert [(bar.link, bar.corners) for bar in slider.bars[:2]] == [("1", ("A", "B")), ("2", ("B", "C"))]
    assert [(block.link, block.at, block.open) for block in slider.blocks] == [("3", "C", False)]
    lever = outline_of("example-6")
    assert ("3", ("D", "E")) in [(bar.link, bar.corners) for bar in lever.bars]
    assert [(block.at, block.open) for block in lever.blocks] == [("B", True), ("E", True), ("D5", False)]
    assert [(slot.link, slot.at, slot.riders) for slot in lever.slots] == [("3", "D", ("B",)), ("5", "D5", ("E",))]
    assert [rail.rider for rail in lever.rails] == ["D5"]


def test_a_point_of_a_coupler_is_drawn_from_the_joint_it_is_placed_from() -> None:
    outline = read_outline(build(parse_variant(STEPHENSON)))
    assert outline is not None
    assert ("2", ("G", "B", "D")) in [(bar.link, bar.corners) for bar in outline.bars]


def test_links_follow_from_the_points_where_a_file_has_neither_links_nor_groups() -> None:
    bare = outline_of("31", links=())
    assert [(bar.link, bar.corners) for bar in bare.bars] == [("1", ("D", "A")), ("2", ("A", "B")), ("3", ("B", "M", "C"))]


BY_SQUARES = {
    "as coordinates": ("(xC - xB)^2 + (yC - yB)^2 - r2^2", "(xC - xB)^2 + (yC - yB)^2 - r2^2"),
    "by points, the length first": ("(xC - xB)^2 + (yC - yB)^2 - r2^2", "r2^2 - (C.x - B.x)^2 - (B - C).y^2"),
    "multiplied out": ("(xC - xB)^2 + (yC - yB)^2 - r2^2", "xB*(xB - 2*xC) + xC^2 + yB^2 + yC^2 - 2*yB*yC - r2^2"),
}


@pytest.mark.parametrize("spelling", BY_SQUARES.values(), ids=BY_SQUARES)
def test_a_link_of_which_only_the_square_of_its_length_is_given_is_drawn_and_told(spelling: tuple[str, str]) -> None:
    text = mechanism("four-bar-by-squared-lengths", spelling)
    built = build(parse_variant(re.sub(r"\[links\]\n(\d = .*\n)+", "", text)))
    outline = read_outline(built)
    assert outline is not None
    assert {bar.corners for bar in outline.bars} == {("A", "B"), ("D", "C"), ("B", "C")}
    assert len({bar.link for bar in outline.bars}) == 3
    assert set(outline.hinges) == {"A", "D"}
    told = meanings(built)
    assert [told[name] for name in ("r1", "r2", "r3")] == ["AB", "BC", "DC"]


def test_a_crank_without_a_named_begin_turns_about_the_point_at_the_origin() -> None:
    text = mechanism("slotted-lever", ("D = ", 'O = "(0, 0)"\nD = '))
    outline = read_outline(build(parse_variant(text)))
    assert outline is not None and [bar.corners for bar in outline.bars] == [("O", "A")]
    assert outline.hinges == ("O",)


def test_a_sleeve_is_a_block_with_open_ends_and_its_bar_goes_through() -> None:
    drawing, outline = drawing_of("v107"), outline_of("v107")
    assert [(block.at, block.open) for block in outline.blocks] == [("O", True)]
    assert measured.names(drawing.svg, "data-sleeve") == {"4"}
    (bar,) = measured.lines(drawing.svg, "data-slot")
    run = run_of("v107")
    scale = 1000 * float(re.search(r"scale 1:(\d+)", drawing.caption)[1]) ** -1  # type: ignore[index]
    # The farthest place of the sleeve in the run and 10 mm of paper.
    assert abs(bar.b - bar.a) == pytest.approx(run.motion.column("s").max() * scale + 10, abs=0.05)


def test_lengths_are_those_the_file_gives() -> None:
    said = {frozenset(ends): spelled(length) for ends, length in lengths(build(load("31"))).items()}
    assert said == {
        frozenset("DA"): "r1", frozenset("AB"): "r2", frozenset("BM"): "2*r3", frozenset("BC"): "r3", frozenset("CP"): "r3/2",
    }  # fmt: skip
    assert {"r₁", "r₂", "2r₃", "r₃", "r₃/2"} <= {word.text for word in measured.words(drawing_of("31").svg)}


def test_the_same_bytes_every_time() -> None:
    assert solve("31", quantities=["table"]).mechanism() == drawing_of("31")


def test_what_stops_is_drawn_where_it_stops() -> None:
    variant = load("31").with_data(given={"alpha": 0.02})
    run = solve(variant, quantities=["table"])
    drawing = run.at_stop()
    assert drawing is not None
    assert drawing.id == "dead-point"
    assert "0.116889" in drawing.caption
    assert measured.overlaps(drawing.svg) == []
    assert run_of("31").at_stop() is None


def test_a_circle_too_small_for_the_scale_is_drawn_without_hatching() -> None:
    sheet = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0))
    before = list(sheet.segments)
    for a, b, away in ((1 + 1j, 1 + 1j, 1j), (1 + 1j, 2 + 1j, 0j)):
        sheet.hatch(a, b, away)
    assert sheet.segments == before
    sheet.hatch(10 + 10j, 30 + 10j, 1j)
    assert len(sheet.segments) > len(before)


CLOSED = scene(
    'phi1 = { start = "0.5 rad", rate = "w1" }\nphi2 = { start = "0.397481135893743 rad", rate = "w2" }\n'
    'phi3 = { start = "0.962037461727003 rad", rate = "w3" }',
    given='r1 = "0.4 m"\nr2 = "1.2 m"\nr3 = "0.8 m"\nd = "1 m"',
    drive='w1 = "10 rad/s"',
    more='[points]\nA = "(0, 0)"\nD = "(d, 0)"\nB = "A + r1 @ phi1"\n',
)


@pytest.mark.parametrize(
    ("closure", "joint"),
    [
        ('[[constraint]]\nname = "1"\nclosure = "B + r2 @ phi2 = D + r3 @ phi3"\n', "C"),
        ('C = "B + r2 @ phi2"\n[[constraint]]\nname = "1"\nclosure = "C = D + r3 @ phi3"\n', "C"),
        ('F = "B + r2 @ phi2"\n[[constraint]]\nname = "1"\nclosure = "D + r3 @ phi3 = F"\n', "F"),
        ('C = "B + r2 @ phi2"\n[closure]\nholds = ["(C - D - r3 @ phi3).x", "(C - D - r3 @ phi3).y"]\n', "C"),
    ],
)
def test_bars_of_a_position_equation_are_links(closure: str, joint: str) -> None:
    """However the loop is written it is one four-bar; a joint that no point is takes the next letter."""
    run = solve(parse_variant(CLOSED + closure), quantities=["table", "trajectories", "hodographs", "plans"])
    outline, drawing = read_outline(run.scene.mechanism), run.mechanism()
    assert outline is not None and drawing is not None
    assert [(bar.link, bar.corners) for bar in outline.bars] == [("1", ("A", "B")), ("2", ("B", joint)), ("3", ("D", joint))]
    assert outline.hinges == ("A", "D")
    assert {joint, "r₂", "r₃"} <= {word.text for word in measured.words(drawing.svg)}
    assert measured.overlaps(drawing.svg) == []
    assert all(run.figures().values())


def test_the_scale_of_an_enlargement_is_as_round_as_that_of_a_reduction():
    """A coupling of 15 mm was drawn 6.666666666667:1."""
    told = [str(ratio(scale)) for scale in SCALES]
    assert {"30000:1", "1:1", "1.5:1", "6:1", "8:1", "1:1.5", "1:8"} <= {*told}
    assert [scale for scale in told if not re.fullmatch(r"1:\d+(\.5)?|\d+(\.5)?:1", scale)] == []
    assert all(fine < coarse for fine, coarse in pairwise(SCALES))


def test_a_number_of_many_zeros_is_a_power_of_ten():
    assert [str(decimal(value)) for value in (1e-5, 2e-6, 0.2, 5e6, 1e7)] == ["0.00001", "2·10⁻⁶", "0.2", "5000000", "1·10⁷"]
    assert powers("V = 1.43e-06 m/s") == "V = 1.43·10⁻⁶ m/s" and powers("0.2 m/s") == "0.2 m/s"


def test_a_link_whose_angle_is_counted_clockwise_is_drawn_once() -> None:
    """Its rate is another name than that of the coordinate: the arm from O to A is link 1 all the same."""
    variant = load("robot-arm")
    first, second = variant.links
    outline = read_outline(build(replace(variant, links=(replace(first, rate="W1"), second))))
    assert outline is not None and [bar.link for bar in outline.bars] == ["1", "2"]


@pytest.mark.parametrize(("name", "joints", "points"), [("31", "DABC", "MP"), ("robot-arm", "DA", "M")])
def test_a_joint_is_a_ring_and_a_mere_point_a_dot(name: str, joints: str, points: str) -> None:
    """P of variant 31 is where the wheel touches, M the end of a link."""
    drawn = re.findall(r'<circle [^>]*fill="(\w+)"[^>]* data-joint="(\w+)"', drawing_of(name).svg)
    assert sorted(at for fill, at in drawn if fill == "white") == sorted(joints)
    assert sorted(at for fill, at in drawn if fill == "black") == sorted(points)


@pytest.mark.parametrize("highest", [90.5, 90.4])
def test_a_sheet_that_is_covered_grows_by_the_place_of_its_axes_where_it_may(highest: float) -> None:
    sheet = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0))
    for y in range(0, 81, 2):
        sheet.line(complex(0, y), complex(100, y), "", heavy=True)
    sheet.axes(highest=highest)
    assert (sheet.height, sheet.field) == (
        (90.5, (0.0, 0.0, 100.0, 90.5)) if highest == 90.5 else (80.0, (0.0, 0.0, 100.0, 80.0))
    )


@pytest.mark.parametrize("above", [5, -5])
@pytest.mark.parametrize("way", [1, 1j, -1])
def test_a_rack_is_drawn_beyond_its_contact_on_the_side_away_from_its_gear(above: int, way: complex) -> None:
    drawn: list[list[complex]] = []
    places, gear = {"K": 0j, "P": 10 * way, "C": (10 + above * 1j) * way}, SimpleNamespace(centre="C", contact="P")
    painter = SimpleNamespace(
        at=places, outline=SimpleNamespace(wheels=[gear]),
        sheet=SimpleNamespace(path=lambda points, look, closed: drawn.append(list(points))),
    )  # fmt: skip
    Painter.rack(painter, SimpleNamespace(corners=("K",)), "P")  # type: ignore[arg-type]
    ((begin, end, beyond, beside),) = drawn
    assert (begin, end) == (0, pytest.approx(22 * way))
    assert (beside / way).imag * above < 0 and beyond - end == pytest.approx(beside - begin)


def test_a_velocity_that_an_arrow_shows_is_not_said_to_have_none():
    """M slides in an upright guide; its velocity is the rate of a coordinate, and [closure] need not say that M is driven."""
    variant = parse_variant(mechanism("guided-driver"))
    caption = solve(variant, quantities=["table"]).mechanism().caption
    assert "The arrow shows how M is driven." in caption and "without an arrow" not in caption
    assert driven_freedoms(variant) == 1
