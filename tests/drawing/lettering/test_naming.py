"""Where names may stand and what they belong to, for links put down by hand: millimetres, y down, the middle at 50 + 50i."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest

from coursework.drawing.lettering import dimensions, naming
from coursework.drawing.paper.symbols import angle_word, length_text, short
from coursework.variant.formula.tree import named


def bar(*corners: str, link: str = "1") -> Any:
    return SimpleNamespace(link=link, corners=corners)


def painter(places: dict[str, complex], **more: Any) -> Any:
    outline = SimpleNamespace(
        bars=more.pop("bars", ()), slots=more.pop("slots", ()), wheels=more.pop("wheels", ()), hinges=("A",)
    )
    sheet = SimpleNamespace(heavy=more.pop("heavy", []))
    given = {"racks": {}, "grounds": [], "middle": 50 + 50j, "names": tuple(places), **more}
    return SimpleNamespace(at=places, outline=outline, sheet=sheet, **given)


@pytest.mark.parametrize(("line", "other", "lies"), [
    ((0j, 10 + 0j), (4 + 0j, 20 + 0j), True), ((0j, 10 + 0j), (10 + 0j, 20 + 0j), False),
    ((0j, 10 + 0j), (9.95 + 0j, 20 + 0j), False), ((0j, 10 + 0j), (9.85 + 0j, 20 + 0j), True),
    ((0j, 10 + 0j), (4 + 0.09j, 20 + 0.09j), True), ((0j, 10j), (2j, 3j), True),
    ((0j, 10 + 0j), (4 + 0.11j, 20 + 0.11j), False), ((0j, 10 + 0j), (4 + 0j, 20 + 9j), False), ((3j, 3j), (0j, 9j), False),
    ((0j, 9j), (3j, 3j), False), ((10 + 0j, 0j), (4 + 0j, 20 + 0j), True), ((-5 + 0j, -1 + 0j), (0j, 9 + 0j), False),
    ((0j, 10 + 10j), (20 + 20j, 5 + 5j), True), ((9 + 0j, 12 + 0j), (0j, 9 + 0j), False),
])  # fmt: skip
def test_lines_on_one_another_have_a_tenth_of_a_millimetre_in_common(line: Any, other: Any, lies: bool) -> None:
    assert naming.lies_on(line, other) is lies


@pytest.mark.parametrize(("line", "outwards"), [
    ((0j, 100 + 0j), -1j), ((100 + 0j, 0j), -1j), ((0j, 100j), -1 + 0j), ((100 + 100j, 0 + 100j), 1j), ((100j, 0j), -1 + 0j),
])  # fmt: skip
def test_a_word_stands_beside_a_line_away_from_the_middle(line: Any, outwards: complex) -> None:
    for towards in (1, -1):
        found = naming.beside(painter({}), line, 1.2, towards=towards)
        a, b = line
        assert [place for place, _, _ in found] == pytest.approx([a + k * (b - a) for k in (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)])
        assert all(way / abs(way) == pytest.approx(towards * outwards) and gap == 1.2 for _, way, gap in found)


def test_a_point_has_its_name_where_its_links_are_not() -> None:
    places = {"A": 0j, "B": 10 + 0j, "C": 10 + 10j, "D": 10j}
    bars = (bar("A", "B"), bar("B", "C"), bar("D", "A", "B"))
    one = painter(places, bars=bars)
    assert naming._away(one, "C") == pytest.approx(1j)  # its link comes from above
    assert naming._away(one, "B") == pytest.approx(2 - 1j + math.sqrt(0.5) * (1 - 1j))  # from A twice, from C, from D across
    straight = painter({"A": 0j, "B": 10 + 0j, "C": 20 + 1j}, bars=(bar("A", "B", "C"),))
    assert naming._away(straight, "B") == 10 + 0j - (50 + 50j)  # between both its way leads from the middle


def test_the_lines_of_a_link_are_its_bars_slots_and_rack() -> None:
    places = {"A": 0j, "B": 10 + 0j, "C": 10 + 5j, "K": 30 + 0j}
    slot = SimpleNamespace(link="1", line=[10 + 0j, 20 + 0j, 20 + 0j, 20 + 2j])
    other = SimpleNamespace(link="2", line=[0j, 1j])
    one = painter(places, slots=(slot, other), racks={"1": "K"}, slot_line=lambda slot: slot.line)
    assert naming.link_lines(one, bar("A", "B", "C")) == [
        (0j, 10 + 0j), (10 + 0j, 10 + 5j), (10 + 0j, 20 + 0j), (20 + 0j, 20 + 2j), (0j, 30 + 0j),
    ]  # fmt: skip
    assert naming.link_lines(painter(places), bar("C")) == [(10 + 5j, 10 + 5j)]


def test_a_link_is_named_beside_its_longest_part_in_its_wheel_or_at_its_block() -> None:
    places = {"A": 0j, "B": 2.4 + 0j, "C": 2.4 + 30j, "D": 22.4 + 30j, "W": 80 + 50j}
    found = naming.link_places(painter(places), bar("A", "B", "C", "D"))
    assert len(found) == 14 and found[0][0] == pytest.approx(2.4 + 15j) and found[7][0] == pytest.approx(12.4 + 30j)
    assert {gap for *_, gap in found} == {1.2}
    assert naming.link_places(painter(places), bar("C")) == [(2.4 + 30j, 2.4 + 30j - (50 + 50j), 4.0)]
    assert naming.link_places(painter(places), bar("A", "B"))[0] == (0j, -50 - 50j, 4.0)  # 2.4 mm bear no name
    for radius, gaps in ((12.0, [13.0]), (12.1, [4.0, 13.1])):
        wheel = SimpleNamespace(link="1", centre="W", contact="K")
        wide = painter({**places, "K": 80 + 50j + radius * 1j}, wheels=(wheel,))
        assert naming.link_places(wide, bar("A", "C")) == [(80 + 50j, 30 + 0j, pytest.approx(gap)) for gap in gaps]


def test_the_rate_of_a_crank_stands_at_its_hinge_or_near_it() -> None:
    found = naming.rate_places(painter({"A": 10 + 10j, "B": 10 + 30j}), bar("B", "A"), "A")
    assert found[0] == (10 + 10j, -40 - 40j, 2.5)
    assert [place for place, _, _ in found[1:]] == pytest.approx([10 + 13j, 10 + 16j, 10 + 19j])
    assert all(way == pytest.approx(-20 + 0j) and gap == 1.0 for _, way, gap in found[1:])


def test_the_name_of_a_link_belongs_to_its_lines_and_its_wheel_and_all_others_are_rivals() -> None:
    places = {"A": 0j, "B": 10 + 0j, "W": 40 + 0j, "K": 43 + 0j}
    heavy = [(0j, 10 + 0j), (0j, 10j)]
    for link in "12":
        wheels = (SimpleNamespace(link=link, centre="W", contact="K"),)
        owner = naming.link_owner(painter(places, heavy=heavy, wheels=wheels, grounds=[(5j, 6j)]), bar("A", "B"))
        rim = [one for one in (owner.own if link == "1" else owner.rivals) if abs(one[1] - 40) == pytest.approx(3.0)]
        assert len(rim) == (33 if link == "1" else 32) and (0j, 10 + 0j) in owner.own
        assert (0j, 10j) in owner.rivals and (5j, 6j) in owner.rivals and (0j, 10 + 0j) not in owner.rivals


@pytest.mark.parametrize(("values", "found"), [
    ({"a": 5.0, "b": 4.0}, "a"), ({"a": 5.0, "b": 5.0}, None), ({"a": 5.0 + 4e-9}, "a"), ({"a": 5.0 - 6e-9}, None), ({}, None),
])  # fmt: skip
def test_the_third_side_of_a_triangle_is_the_one_datum_as_long(values: dict[str, float], found: str | None) -> None:
    one: Any = SimpleNamespace(place={"A": 0j, "B": 3 + 4j})
    assert naming._measured(one, ("A", "B"), values) == (found and named(found))


def test_a_tight_dimension_has_its_arrows_outside() -> None:
    assert dimensions._ends(0j, 4.6 + 0j) == (0j, 4.6 + 0j) and dimensions._ends(0j, 4.5j) == (-5j, 9.5j)
    assert [*dimensions._samples(0j, 4.5 + 0j)] == pytest.approx([0.75, 2.25, 3.75])
    assert [*dimensions._samples(1j, 1.1j)] == pytest.approx([1.025j, 1.075j])


@pytest.mark.parametrize(("name", "end", "found"), [
    ("B", 1.8j, None), ("B", 1.9j, (1.8j, 2.9j)), ("B", -9 + 0j, (-1.8 + 0j, -10 + 0j)), ("A", 6.9j, None), ("A", 8j, (7j, 9j)),
    ("A", -8j, (-1.8j, -9j)), ("A", 8 + 0j, (1.8 + 0j, 9 + 0j)), ("A", 8 * complex(math.sin(0.4), math.cos(0.4)), (7.0, 9.0)),
    ("A", 8 * complex(math.sin(0.5), math.cos(0.5)), (1.8, 9.0)),
])  # fmt: skip
def test_an_extension_line_begins_beside_its_point_or_below_the_ground_of_its_hinge(name: str, end: complex, found: Any) -> None:
    """The ground is below: cos 0.4 = 0.92 is still towards it, cos 0.5 = 0.88 is not."""
    one = painter({"A": 0j}, ground=lambda name: 1j)
    got = dimensions._extension(one, (name, 0j), end)
    if found is None or isinstance(found[0], complex):
        assert got == (found and pytest.approx(found))
    else:
        assert got is not None and (abs(got[0]), abs(got[1])) == pytest.approx(found)


@pytest.mark.parametrize(("name", "word"), [("ABCDEFGHIJKL", "ABCDEFGHIJKL"), ("ABCDEFGHIJKLM", "ABCDEFGHIJK…")])
def test_a_name_of_more_than_twelve_letters_is_cut(name: str, word: str) -> None:
    assert short(name) == word


@pytest.mark.parametrize(("name", "word"), [("phi_abcd", ("φ", "abcd", "")), ("phi_abcde", ("phi_abcde", "", ""))])
def test_an_angle_has_an_index_of_up_to_four_letters(name: str, word: tuple[str, str, str]) -> None:
    assert angle_word(name) == word


@pytest.mark.parametrize(("letters", "shown"), [(14, True), (15, False)])
def test_a_length_of_up_to_fourteen_letters_stands_beside_its_link(letters: int, shown: bool) -> None:
    assert length_text(named("q" * letters)) == "q" * letters * shown
