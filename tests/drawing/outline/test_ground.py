"""Ground and racks of outlines made by hand: what touches, runs on or lies on what, just inside and just outside each limit."""

from __future__ import annotations

import cmath
import math
from types import SimpleNamespace
from typing import Any

import pytest

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side, touched
from coursework.drawing.outline.outline import Bar, Rail, Track, Wheel

# A gear about C rolls on a rack K, whose rail runs along x through the contact P.
AT = {"O": 0j, "X": 1 + 0j, "K": 0.5 + 0j, "L": 0.7 + 0j, "P": 2 + 0j, "C": 2 + 0.3j, "T": 2 + 1j, "R": 3 + 1j}
GEAR = Wheel("1", "C", "P")
RACK = Bar("5", ("K",))


def outline(**more: tuple[Any, ...]) -> Any:
    given: dict[str, tuple[Any, ...]] = {"rails": (Rail("O", "O", "X", "K"),), "wheels": (GEAR,), "bars": (RACK,), "tracks": ()}
    return SimpleNamespace(**{"shown": (), **given, **more})


@pytest.mark.parametrize("above", [1, -1])
def test_a_rack_lies_beyond_its_contact_seen_from_the_gear(above: int) -> None:
    """The line of its rail runs along x through the contact; the gear stands above it, or below."""
    (rack,) = racks(outline(), AT | {"C": 2 + 0.3j * above})
    assert (rack.link, rack.contact, rack.side) == ("5", "P", -above)
    assert (rack.slot.link, rack.slot.at, rack.slot.riders) == ("5", "K", ("P",))
    assert touched(outline(), AT, GEAR) == ["5"]


@pytest.mark.parametrize(
    ("more", "moved", "is_rack"),
    [
        ({}, {"P": 2 + 1.9e-6j}, True),  # a millionth of its distance along the rail, 2 m
        ({}, {"P": 2 + 2.1e-6j}, False),
        ({}, {"P": -2 - 1.9e-6j}, True),
        ({"bars": (RACK, Bar("2", ("P", "L")))}, {}, True),  # a link that ends at the contact beside the gear
        ({"bars": (RACK, Bar("2", ("P", "L")), Bar("3", ("T", "P")))}, {}, False),  # two: they are geared, nothing slides
        ({"bars": (Bar("5", ("K", "L")),)}, {}, False),  # a slider of two points is no rack
        ({"bars": (Bar("5", ("L",)),)}, {}, False),  # nor one that rides elsewhere
        ({"rails": (Rail("O", "O", "X", "K"), Rail("P", "O", "X", "P", rolls=True))}, {}, False),  # it rolls on a fixed rail
        ({"rails": (Rail("O", "O", "X", "K"), Rail("P", "O", "X", "P"))}, {}, True),
        ({"tracks": (Track("T", "R"),)}, {"R": 2 + 1j + 1 / 1.019}, False),  # within 2 % of a fixed circle
        ({"tracks": (Track("T", "R"),)}, {"R": 2 + 1j + 1 / 1.021}, True),
        ({"tracks": (Track("T", "R"),)}, {"R": 2 + 1j + 1 / 0.979}, True),
        ({"wheels": ()}, {}, False),
    ],
)  # fmt: skip
def test_a_slider_is_a_rack_if_its_line_meets_a_gear_that_rolls_on_nothing_else(
    more: dict[str, Any], moved: dict[str, complex], is_rack: bool
) -> None:
    assert len(racks(outline(**more), AT | moved)) == is_rack


def test_a_wheel_touches_other_wheels_and_links_at_its_contact() -> None:
    others = (GEAR, Wheel("7", "T", "P"), Wheel("8", "T", "R"))
    bars = (RACK, Bar("1", ("C", "P")), Bar("2", ("P", "L")), Bar("3", ("L", "T")))
    assert touched(outline(wheels=others, bars=bars), AT, GEAR) == ["7", "2"]
    assert touched(outline(wheels=others, bars=bars[:2]), AT, GEAR) == ["7", "5", "5"]  # a rack of two gears


@pytest.mark.parametrize(("centre", "solid"), [(2 - 1.2j, 1), (2 + 0.8j, 1), (2 - 0.6j, -1), (2 + 0.4j, -1)])
def test_a_fixed_circle_is_solid_where_no_wheel_rolls(centre: complex, solid: int) -> None:
    """A circle about 2 - 0.2j of radius 0.8: a wheel farther from its middle rolls outside, a nearer one inside it."""
    at = AT | {"T": 2 - 0.2j, "R": 2.8 - 0.2j, "P": 2 + 0.6j, "C": centre}
    assert inward(outline(), at, Track("T", "R")) == solid
    assert inward(outline(), at | {"P": 2 + 0.7j}, Track("T", "R")) == 0


@pytest.mark.parametrize("turn", [1, -1])
def test_a_rail_is_hatched_away_from_its_wheel_else_from_the_rest_of_the_mechanism(turn: int) -> None:
    rolling, sliding = Rail("O", "O", "X", "P", rolls=True), Rail("O", "O", "X", "K")
    at = {name: place.conjugate() if turn < 0 else place for name, place in AT.items()} | {"L": 0.7 - 0.9j * turn}
    assert rail_side(outline(), at, rolling) == -turn  # C alone counts
    shown = outline(shown=("K", "L", "P"))
    assert rail_side(shown, at, sliding) == turn
    assert (
        rail_side(outline(shown=("K", "L")), at | {"K": 0.5 - 2j * turn, "L": 0.7 + 0.9j * turn}, sliding) == -turn
    )  # its own rider does not count
    assert rail_side(outline(shown=("K",)), at, sliding) == -1


def test_a_hinge_stands_on_the_ground_below_it_unless_a_link_hides_it() -> None:
    """The cosine of 41.4 degrees is 0.75: nearer to straight down, the ground is where the link is farthest from."""
    for angle, beside in ((41.3, -1 + 0j), (41.5, -1j), (-41.3, 1 + 0j), (-41.5, -1j)):
        at = {"A": 1 + 1j, "B": 1 + 1j + 0.2 * cmath.exp(1j * math.radians(angle - 90))}
        ways = (hinge_ground(outline(bars=(Bar("1", ends),)), at, "A") for ends in (("A", "B"), ("B", "A")))
        assert set(ways) == {beside if beside == -1j else hidden(angle)}


def hidden(angle: float) -> complex:
    """Of down, left, right and up, the way that is farthest from a link `angle` degrees from straight down."""
    return max((-1j, -1 + 0j, 1 + 0j, 1j), key=lambda way: abs(math.remainder(math.degrees(cmath.phase(way)) + 90 - angle, 360)))
