"""Given angles stand on the drawing: as an arc that turns by the datum, the right way, from what the file measures it from."""

from __future__ import annotations

import cmath
import itertools
import math
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest

from coursework import parse_variant, solve
from coursework.drawing.lettering.angles import _angle, _is_shown
from coursework.variant.catalogue import names
from coursework.variant.formula.reader import parse
from tests.drawing import measured
from tests.drawing.outline.test_mechanism import drawing_of
from tests.mechanisms.library import mechanism
from tests.sample import sampled


def svg_of(name: str, **changes: str) -> str:
    drawing = solve(parse_variant(mechanism(name, *changes.items())), quantities=["table"]).mechanism()
    assert drawing is not None
    return drawing.svg


def arc_of(svg: str, letter: str) -> list[complex]:
    [path] = [node for node in ElementTree.fromstring(svg).iter() if node.get("data-angle") == letter]
    return measured.points(path.get("d", ""))


def turned(points: list[complex]) -> float:
    """Return by how much the tangent of an arc turns (rad), counter-clockwise as seen; half a piece is lost at each end."""
    ways = [(b - a).conjugate() for a, b in itertools.pairwise(points)]
    total = sum(cmath.phase(b / a) for a, b in itertools.pairwise(ways))
    return total * len(ways) / (len(ways) - 1)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "letter", "degrees"),
    [
        ("v101", "β", 45.0), ("v110", "β", 45.0),
        ("prp", "γ", math.degrees(0.35)), ("prp", "δ", -math.degrees(0.9)),
        ("stephenson", "γ", 10.0), ("watt", "γ", -90.0),
    ],
)  # fmt: skip
def test_an_arc_turns_by_its_datum_and_has_its_letter(name: str, letter: str, degrees: float) -> None:
    svg = svg_of(name)
    arc = arc_of(svg, letter)
    assert math.degrees(turned(arc)) == pytest.approx(degrees, abs=1.0)
    [word] = [one for one in measured.words(svg) if one.text == letter]
    assert min(measured.apart(word, at) for at in arc) < 5


def test_a_bend_begins_at_the_part_that_the_coordinate_turns() -> None:
    """gamma of Watt's bell crank is measured at D from DC: both ends of the arc lie on the link."""
    svg = svg_of("watt")
    arc = arc_of(svg, "γ")
    sides = {
        line.says["data-from"] + line.says["data-to"]: line
        for line in measured.lines(svg, "data-link")
        if "data-from" in line.says
    }
    for end, side in ((arc[0], sides["CD"]), (arc[-1], sides["DE"])):
        way = (side.b - side.a) / abs(side.b - side.a)
        assert abs(((end - side.a) * way.conjugate()).imag) < 0.02


@pytest.mark.parametrize("written", ["D + -(-r5 @ (phi3 + gamma))", "D - (-r5) @ (gamma + phi3)"])
def test_a_bend_may_be_written_with_any_signs(written: str) -> None:
    svg = svg_of("watt", **{"D + r5 @ (phi3 + gamma)": written})
    assert math.degrees(turned(arc_of(svg, "γ"))) == pytest.approx(-90.0, abs=1.0)


@pytest.mark.parametrize("name", sampled(names()))
def test_the_head_of_an_arc_lies_on_its_end(name: str) -> None:
    """It is 1.7 mm long, on a short arc six tenths of it, and leans as the arc does there."""
    paths = [*ElementTree.fromstring(drawing_of(name).svg).iter(f"{measured.SVG}path")]
    for path, head in itertools.pairwise(paths):
        if path.get("data-angle", "").startswith(("phi", "th")) and head.get("fill") == "black":
            arc, (tip, *neck) = measured.points(path.get("d", "")), measured.points(head.get("d", ""))[:3]
            long = sum(abs(b - a) for a, b in itertools.pairwise(arc))
            middle = sum(neck) / 2
            assert abs(tip - arc[-1]) < 0.01
            assert abs(middle - tip) == pytest.approx(min(1.7, 0.6 * long), abs=0.02)
            assert abs(neck[1] - neck[0]) == pytest.approx(0.6 * abs(middle - tip), abs=0.02)
            assert min(abs(middle - place) for place in arc) < 0.7  # they are at most 1.3 mm apart


@pytest.mark.parametrize(("value", "is_drawn"), [("1.8 deg", True), ("1.6 deg", False)])
def test_an_angle_too_small_to_be_seen_has_no_arc(value: str, is_drawn: bool) -> None:
    svg = svg_of("stephenson", **{'gamma = "10 deg"': f'gamma = "{value}"'})
    assert ('data-angle="γ"' in svg) == is_drawn


def test_an_angle_that_is_no_direction_is_not_drawn() -> None:
    """alpha of variant 31 is the phase of its drive."""
    assert measured.names(svg_of("31"), "data-angle") == {"phi1", "phi2", "phi3"}


@pytest.mark.parametrize(("text", "turn"), [
    ("gamma", -0.2), ("-gamma", 0.2), ("phi3 + gamma", -0.2), ("phi3 - gamma", 0.2),
    ("gamma - phi3 + pi/2", -0.2), ("gamma + 1", -0.2),
    ("gamma + 2*phi3", None), ("phi3 + 2*phi3 + gamma", None), ("gamma + delta", None), ("phi3", None), ("gamma + r", -0.2),
    ("gamma - gamma", None), ("2*gamma", None),
])  # fmt: skip
def test_an_angle_is_the_one_datum_of_a_direction_beside_coordinates_and_numbers(text: str, turn: float | None) -> None:
    """Any name that is no angle of the data counts as a coordinate.  The sheet turns the other way round."""
    given = [SimpleNamespace(name=name, value=value, si=si) for name, value, si in (
        ("gamma", 0.2, "rad"), ("delta", 0.3, "rad"), ("r", 0.4, "m"))]  # fmt: skip
    mechanism = SimpleNamespace(variant=SimpleNamespace(given=given))
    found = list(_angle(mechanism, parse(text), (1 + 2j,), 1j))  # type: ignore[arg-type]
    assert [(one.name, one.at, one.turn) for one in found] == ([] if turn is None else [("gamma", (1 + 2j,), turn)])
    assert all(one.begin == pytest.approx(1j * cmath.exp(-1j * one.turn)) for one in found)


@pytest.mark.parametrize("radius", [4.0, 40.0])
@pytest.mark.parametrize(("reach", "off", "shown"), [
    (0.902, 0.0, True), (0.898, 0.0, False), (2.0, 0.0196, True), (2.0, 0.0204, False),
    (2.0, -0.0196, True), (2.0, -0.0204, False),
])  # fmt: skip
def test_a_link_shows_a_direction_if_it_nearly_reaches_the_arc(radius: float, reach: float, off: float, shown: bool) -> None:
    at = 3 + 4j
    link = (at + reach * radius * cmath.exp(1j * (0.7 + off)), at)
    painter: Any = SimpleNamespace(sheet=SimpleNamespace(heavy=[link, (0j, 1 + 0j)]), rails={})
    assert _is_shown(painter, at, cmath.exp(0.7j), radius) is shown
