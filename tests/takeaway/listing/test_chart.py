"""The block diagram: well-formed, its boxes numbered as the comments of the listing, its shapes those of ISO 5807."""

import re
from xml.etree import ElementTree

import pytest

from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.takeaway.listing.chart import block_diagram
from coursework.takeaway.listing.program import program_of
from tests.sample import sampled
from tests.solved import solved
from tests.takeaway.listing.test_listing import FILES, written

SPACE = "{http://www.w3.org/2000/svg}"


def drawn(name, words="en"):
    run = solved(name, scheme="euler", quantities=["table"])
    return ElementTree.fromstring(block_diagram(program_of(PageContext(run, load_words(words))), load_words(words)))


@pytest.mark.parametrize("name", sampled(FILES))
def test_boxes_and_comments_have_the_same_numbers(name):
    numbers = [int(text.text) for text in drawn(name).iter(f"{SPACE}text") if text.get("font-size") == "10"]
    assert numbers == list(range(1, len(numbers) + 1))
    run = solved(name, scheme="euler", quantities=["table"])
    told = {int(one) for one in re.findall(r"(?:^ *|  )# (\d+) ", written(run, "python"), re.MULTILINE)}
    assert told == {*numbers}


def test_shapes_are_those_of_the_standard():
    svg = drawn("31")
    assert len([one for one in svg.iter(f"{SPACE}rect") if one.get("rx") == "22"]) == 4
    corners = sorted(len(one.get("points").split()) for one in svg.iter(f"{SPACE}polygon"))
    assert corners == [4, 4, 4, 4, 4, 6, 6]  # two of data, three decisions, two limits of the loop


@pytest.mark.parametrize("words", ["ru", "uk", "zh"])
def test_it_speaks_the_language_of_the_report(words):
    said = {text.text for text in drawn("31", words).iter(f"{SPACE}text")}
    assert {load_words(words)("listing.box.start"), load_words(words)("listing.box.end")} <= said and "start" not in said


def test_both_stand_in_the_appendix_where_they_are_asked_for():
    usual = solved("31")
    assert not {"listing", "flowchart"} & {*usual.asked}
    model = build_model(solved("31", quantities=["table", "listing", "flowchart"]), "ru")
    program, picture = (next(part for part in one.parts) for one in model.sections if one.name in {"listing", "flowchart"})
    assert program.text == written(solved("31"), "python", "ru")
    assert ElementTree.fromstring(picture.svg).tag == f"{SPACE}svg" and picture.width == pytest.approx(580 * 25.4 / 96, rel=1e-6)
    page = render_html(model)
    assert "# 12  (11): w3" in page.replace("&#39;", "'") or "(11): w3" in page
    assert "<style>" not in picture.svg  # it would set every other drawing too


@pytest.mark.parametrize("name", ["example-2-motor", "falling-arm"])
def test_boxes_of_a_motion_under_forces_are_numbered_without_a_gap(name):
    """One box more where positions are closed between the steps."""
    numbers = [int(text.text) for text in drawn(name).iter(f"{SPACE}text") if text.get("font-size") == "10"]
    assert numbers == list(range(1, len(numbers) + 1))


def test_every_corner_of_a_box_is_beside_the_others():
    """A limit of a loop has its corners cut off: no side is longer than the box is wide, none runs back across it."""
    for one in drawn("31").iter(f"{SPACE}polygon"):
        places = [complex(*map(float, place.split(","))) for place in one.get("points").split()]
        wide, high = (max(part) - min(part) for part in (([p.real for p in places]), ([p.imag for p in places])))
        assert wide < 400 and high < 200
        turns = []
        for k in range(len(places)):
            a, b, c = places[k - 2], places[k - 1], places[k]
            turns.append(((c - b) * (b - a).conjugate()).imag)
        assert all(turn > 0 for turn in turns) or all(turn < 0 for turn in turns)  # convex


@pytest.mark.parametrize("name", ["31", "falling-arm"])
def test_the_lines_of_a_subroutine_stand_within_its_box(name):
    root = drawn(name)
    boxes = [tuple(float(one.get(key)) for key in ("x", "y", "width", "height")) for one in root.iter(f"{SPACE}rect")]
    sides = [re.findall(r"M([\d.]+) ([\d.]+)V([\d.]+)", one.get("d")) for one in root.iter(f"{SPACE}path")]
    for two in (two for two in sides if len(two) == 2 and two[0][1:] == two[1][1:]):
        (left, top, low), (right, *_) = (map(float, one) for one in two)
        assert any((top, low) == (y, y + high) and left - x == pytest.approx(8) == x + wide - right for x, y, wide, high in boxes)
