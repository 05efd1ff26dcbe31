"""Links, pairs, mobility and Assur groups of mechanisms counted by hand, as a textbook does it."""

from __future__ import annotations

import re
from contextlib import nullcontext
from pathlib import Path

import pytest

import coursework
from coursework.mechanism import mechanism as module
from coursework.mechanism.groups.joint import MESHING, PRISMATIC, REVOLUTE, ROLLING
from coursework.mechanism.mechanism import build
from coursework.mechanism.structure import read_structure
from coursework.mechanism.structure_record import Structure
from coursework.variant.catalogue import names
from tests.report.own import FIVE_BAR, SHAPER

HEAD = """\
format = 1
title = "own"
[given]
w0 = "1 rad/s"
r = "1 m"
[drive]
{drive}
[coordinates]
{coordinates}
[time]
step = "0.1 s"
end = "1 s"
[points]
{points}
[links]
{links}
[frame]
{frame}
[[constraint]]
name = "1"
equation = "{rate} - w1 = 0"
"""


def listed(
    links: str, points: str, frame: str, drive: str = 'w1 = "w0"', turning: str = "123456789", rate: str = "w2"
) -> Structure | None:
    """Return the structure of links as a file lists them; only which points they hold matters, not where those are."""
    places = "\n".join(f'{name} = "({place}*r + r*cos(phi1), r*sin(phi{turning[-1]}))"' for place, name in enumerate(points))
    coordinates = "\n".join(f'phi{k} = {{ start = "0 rad", rate = "w{k}" }}' for k in turning)
    values = {"drive": drive, "coordinates": coordinates, "points": places, "links": links, "frame": frame, "rate": rate}
    return read_structure(build(coursework.parse_variant(HEAD.format(**values))))


def links(*points: str) -> str:
    return "\n".join(f'{k} = {{ points = {[*held]}, rate = "w{k}" }}'.replace("'", '"') for k, held in enumerate(points, start=1))


def hinges(points: str) -> str:
    return f"hinges = {[*points]}".replace("'", '"')


def groups(found: Structure | None) -> list[tuple[str, tuple[str, ...], int, str]]:
    assert found is not None
    return [(group.group_class, group.links, group.order, group.kind) for group in found.groups]


def test_the_shaper_as_a_textbook_has_it() -> None:
    found = read_structure(build(coursework.parse_variant(SHAPER)))
    assert found is not None
    assert (found.mobility.links, found.mobility.lower_pairs, found.mobility.higher_pairs, found.mobility.degrees) == (5, 7, 0, 1)
    assert [(link.name, link.kind, link.points) for link in found.links] == [
        ("1", "pivoted", ("A", "B")), ("2", "slider", ("B",)), ("3", "lever", ("D", "E")), ("4", "coupler", ("E", "F")),
        ("5", "slider", ("F",)),
    ]  # fmt: skip
    pairs = [(pair.point, pair.links, pair.kind) for pair in found.pairs]
    assert sorted(pairs, key=str) == sorted([
        ("A", ("0", "1"), REVOLUTE), ("B", ("1", "2"), REVOLUTE), ("B", ("2", "3"), PRISMATIC), ("D", ("0", "3"), REVOLUTE),
        ("E", ("3", "4"), REVOLUTE), ("F", ("4", "5"), REVOLUTE), ("F", ("0", "5"), PRISMATIC),
    ], key=str)  # fmt: skip
    assert groups(found) == [("I", ("0", "1"), 0, ""), ("II", ("2", "3"), 2, "RPR"), ("II", ("4", "5"), 2, "RRP")]


def test_two_driven_links_stand_before_the_dyad_between_them() -> None:
    found = read_structure(build(coursework.parse_variant(FIVE_BAR)))
    assert found is not None and (found.mobility.degrees, found.drives) == (2, 2)
    assert groups(found) == [("I", ("0", "1"), 0, ""), ("I", ("0", "4"), 0, ""), ("II", ("2", "3"), 2, "RRR")]


def test_a_pin_in_a_guide_is_shown_with_its_slider_and_counted_both_ways() -> None:
    """Slider-crank, two links listed: 3·2 - 2·2 - 1 = 3·3 - 2·4."""
    found = listed(links("AB", "BC"), "ABC", f'{hinges("A")}\nrails = [ {{ through = "C", angle = "0" }} ]', turning="12")
    assert found is not None
    assert (found.mobility.links, found.mobility.lower_pairs, found.mobility.higher_pairs) == (3, 4, 0)
    assert (found.without.links, found.without.lower_pairs, found.without.higher_pairs) == (2, 2, 1)
    assert found.links[-1].name == "3" and found.links[-1].kind == "slider"
    assert groups(found)[1:] == [("II", ("2", "3"), 2, "RRP")]


def test_a_triad_is_a_group_of_class_three_and_order_three() -> None:
    """Ternary link CDE on three legs: BC from the crank, DF and EG from the frame."""
    found = listed(links("AB", "BC", "CDE", "DF", "EG"), "ABCDEFG", hinges("AFG"), turning="12345")
    assert found is not None and found.mobility.degrees == 1
    assert groups(found) == [("I", ("0", "1"), 0, ""), ("III", ("2", "3", "4", "5"), 3, "")]


def test_four_links_in_a_ring_are_a_group_of_class_four() -> None:
    """Two ternary links in a ring of four, held at two points: nothing smaller can be put together."""
    found = listed(links("AB", "BCD", "CE", "EFG", "FD"), "ABCDEFG", hinges("AG"), turning="12345")
    assert found is not None and found.mobility.degrees == 1
    assert groups(found) == [("I", ("0", "1"), 0, ""), ("IV", ("2", "3", "4", "5"), 2, "")]


def test_a_wheel_that_rolls_keeps_one_freedom_and_a_gear_on_its_pivot_two() -> None:
    rolling = read_structure(build(coursework.load("31")))
    gear = read_structure(build(coursework.load("v112")))
    assert rolling is not None and gear is not None
    assert [pair.links for pair in rolling.pairs if pair.kind is ROLLING] == [("0", "4")]
    assert (rolling.mobility.lower_pairs, rolling.mobility.higher_pairs, rolling.driven) == (5, 0, "M")
    assert [pair.links for pair in gear.pairs if pair.kind is MESHING] == [("4", "5")]
    assert (gear.mobility.lower_pairs, gear.mobility.higher_pairs) == (6, 1)
    assert [pair.links for pair in gear.pairs if pair.kind is PRISMATIC] == [("0", "5")]


def test_two_gears_on_pivots_touch_each_other_once() -> None:
    wheels = '1 = { wheel = "A", contact = "C", rate = "w1" }\n2 = { wheel = "B", contact = "C", rate = "w2" }'
    found = listed(wheels, "ABC", hinges("AB"), turning="12")
    assert found is not None
    assert (found.mobility.links, found.mobility.lower_pairs, found.mobility.higher_pairs, found.mobility.degrees) == (2, 2, 1, 1)
    assert [pair.links for pair in found.pairs if pair.kind is MESHING] == [("1", "2")]


def test_a_parallelogram_with_a_third_rocker_has_a_passive_constraint() -> None:
    found = listed(links("AB", "BCD", "EC", "FD"), "ABCDEF", hinges("AEF"), turning="1234")
    assert found is not None
    assert (found.mobility.degrees, found.drives, found.groups) == (0, 1, ())


def test_where_more_can_move_than_is_driven_a_pair_is_missing_and_nothing_is_told() -> None:
    assert listed(links("AB", "BC", "CD"), "ABCD", hinges("A"), turning="123") is None


def test_a_driven_coupler_begins_no_chain_of_groups() -> None:
    found = listed(links("AB", "BC", "DC"), "ABCD", hinges("AD"), drive='w2 = "w0"', turning="123", rate="w3")
    assert found is not None and found.mobility.degrees == 1
    assert found.groups == ()


@pytest.mark.parametrize("name", names())
def test_every_mechanism_of_the_catalogue_has_the_freedoms_of_its_drives(name: str) -> None:
    found = read_structure(build(coursework.load(name)))
    assert found is not None
    assert found.mobility.degrees == found.without.degrees == found.drives
    # Of a driven link the first one named is that on which it stands.
    links_of_groups = [link for group in found.groups for link in group.links[group.group_class == "I" :]]
    assert sorted(links_of_groups) == sorted(link.name for link in found.links) or not found.groups
    assert found.groups or name in {"cardan", "epicyclic"}  # their line of centres is no link of the list


@pytest.mark.parametrize(("points", "holds", "most", "told"), [
    ('P1 = "P0 + P0"', "-P1.x*P1.x*P1.x*P1.x", 100, ""),  # B = O + r @ phi1 + l @ phi2 has 11 parts, P1 23, P1.x 24
    ('P1 = "P0 + P0"', "P1.x*P1.x*P1.x*P1.x*l", 100, "V342"),
    ('P1 = "P0 + P0"\nP2 = "P1 + P1"', "l", 47, ""), ('P1 = "P0 + P0"\nP2 = "P1 + P1"', "l", 46, "V347"),
])  # fmt: skip
def test_points_written_out_have_as_many_parts_as_are_allowed(
    points: str, holds: str, most: int, told: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (Path(__file__).parents[1] / "variant/bad/geometry-exploding-holds.toml").read_text(encoding="utf-8")
    text = re.sub(r"(?ms)^P1 = .*", f'{points}\n[closure]\nholds = ["{holds}"]\n', text)
    variant = coursework.parse_variant(text)
    monkeypatch.setattr(module, "MAX_EXPANDED", most)
    with pytest.raises(coursework.InputError, match=told) if told else nullcontext():
        build(variant)
