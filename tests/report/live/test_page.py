"""The live page in a real browser: every hook, without a word, a request or a trace; away where it may not be."""

from __future__ import annotations

import re
from typing import Any

import pymupdf
import pytest

import coursework
from coursework.report.live.page import MOST_BYTES, MOST_ROWS
from tests.mechanisms.library import mechanism
from tests.report.live.test_work import rest

pytestmark = pytest.mark.browser


def test_it_opens_from_disk_without_a_word_and_fetches_nothing(written: Any, opened: Any) -> None:
    folder = written("31")
    page = opened(folder)
    page.page.wait_for_timeout(300)
    assert page.page.is_visible("#live")
    page.page.click("#play")
    page.page.wait_for_selector("#live:not([data-row='1'])")
    page.page.click("#play")
    assert page.page.get_attribute("#play", "aria-pressed") == "false"
    assert page.said == []
    assert page.fetched == [(folder / "report.html").as_uri()]


def test_it_leaves_no_name_and_keeps_nothing(written: Any, opened: Any) -> None:
    known = "Object.keys(window).sort().join()"
    with_it, without = (opened(written("31", live=live)).page.evaluate(known) for live in (True, False))
    assert with_it == without


def test_it_is_hidden_without_scripts_and_in_print(written: Any, opened: Any) -> None:
    silent = opened(written("31"), java_script_enabled=False).page
    assert not silent.is_visible("#live")
    page = opened(written("31")).page
    page.emulate_media(media="print")
    assert not page.is_visible("#live")
    title = page.inner_text("#live h2") or "Watch it move"
    with pymupdf.open(stream=page.pdf(format="A4", prefer_css_page_size=True), filetype="pdf") as printed:
        assert title not in "".join(sheet.get_text() for sheet in printed)


def test_the_scrub_and_the_keys_go_by_rows(written: Any, opened: Any) -> None:
    page = opened(written("31"))
    assert page.row == 1
    most = float(page.page.get_attribute("#scrub", "max"))
    page.set("#scrub", most * 18 / 24)
    assert page.row == 19
    assert page.page.inner_text("#live-clock") == "row 19, t = 0.36 s"
    assert page.page.get_attribute("#lab-table tr.live-now", "data-row") == "19"
    # Euler's wheel stands 23 mm beside its rail.
    assert page.page.inner_text("#live-rail") == "P of the dashed mechanism is 23.3 mm off its guide."
    page.page.focus("#live")
    for key, row in (("ArrowRight", 20), ("ArrowLeft", 19), ("Home", 1), ("ArrowLeft", 1), ("End", 25), ("ArrowRight", 25)):
        page.page.keyboard.press(key)
        assert page.row == row, key
    page.page.keyboard.press(" ")
    assert page.page.get_attribute("#play", "aria-pressed") == "true"
    page.page.keyboard.press(" ")
    assert page.page.get_attribute("#play", "aria-pressed") == "false"
    # A key that an input needs is left to it.
    page.set("#scrub", 5)
    page.page.focus("#lab-step")
    page.page.keyboard.press("ArrowRight")
    assert (page.row, page.page.input_value("#lab-step")) == (6 * 2 - 1, "1")


def test_what_stands_still_is_on_the_side_of_the_ground_as_on_paper(written: Any, opened: Any) -> None:
    """v108: a hinge above its link hangs, a fixed cylinder is hatched, and its wheel leaves a circle, not a rail."""
    page = opened(written("v108"))
    ground = page.page.get_attribute(".live-ground path", "d")
    tip, left, right = re.findall(r"M(\S+) (\S+)L(\S+) (\S+)L(\S+) (\S+)Z", ground)[0][1::2]
    assert float(left) == float(right) < float(tip)
    assert page.page.get_attribute("path.live-hatch", "d").count("L") > 20
    assert page.page.inner_text("#live-rail") == "P of the dashed mechanism is on its circle."
    assert page.page.inner_text("#live-away") == "Every point is where it should be."
    page.page.focus("#live")
    page.page.keyboard.press("End")
    assert page.page.inner_text("#live-rail").endswith("mm off its circle.")
    assert "is 0 mm from" not in page.page.inner_text("#live")


def test_a_rack_is_a_bar_that_goes_with_its_slider(written: Any, opened: Any) -> None:
    page = opened(written("v112"))
    bars = r"M(\S+) \S+L(\S+) \S+L\S+ \S+L\S+ \S+Z"
    lengths = []
    for key in ("Home", "End"):
        page.page.focus("#live")
        page.page.keyboard.press(key)
        found = re.findall(bars, page.page.get_attribute(".live-body path", "d"))
        lengths.append(max(abs(float(a) - float(b)) for a, b in found))
    # Longer than the block of any slider (24), and rigid but for the rounding of its ends.
    assert lengths[0] > 30
    assert abs(lengths[0] - lengths[1]) <= 0.3


def test_every_graph_says_what_its_axis_is(written: Any, opened: Any) -> None:
    page = opened(written("31")).page
    titles = "all => all.map(one => [...one.querySelectorAll('.live-title')].at(-1).textContent)"
    assert {*page.eval_on_selector_all("#live-panels [data-panel]", titles)} == {"t, s"}


def test_a_cursor_goes_through_every_graph(written: Any, opened: Any) -> None:
    page = opened(written("31"))
    places = "all => all.map(one => Number(one.querySelector('.live-cursor').getBoundingClientRect().left))"
    before = page.page.eval_on_selector_all("[data-panel]", places)
    page.set("#scrub", 12)
    after = page.page.eval_on_selector_all("[data-panel]", places)
    assert len(after) >= 14
    assert page.page.eval_on_selector_all("tr.live-now", "all => all.map(row => row.dataset.row)") == ["13", "13"]
    assert all(b > a for a, b in zip(before, after, strict=True))


def test_every_table_of_the_page_shows_the_row_that_is_reached(written: Any, opened: Any) -> None:
    page = opened(written("pantograph"))
    page.set("#scrub", 13)
    lit = page.page.eval_on_selector_all("tr.live-now", "all => all.map(row => row.dataset.row)")
    # The laboratory has row 14; the tables on the page print every second row.
    assert sorted(lit) == ["13", "13", "13", "13", "14"]


def test_motion_is_not_forced_on_anyone(written: Any, opened: Any) -> None:
    page = opened(written("31"), before=lambda page: page.clock.install(time=0), reduced_motion="reduce")
    rest(page.page)  # before a clock stands still by which it measures
    page.page.clock.pause_at(60_000)
    page.page.click("#play")
    page.page.clock.run_for(900)
    assert page.row == 1
    page.page.clock.run_for(200)
    assert page.row == 2
    page.page.clock.run_for(2000)
    assert page.row == 4


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "walschaerts"])
def test_a_phone_shows_it_whole(written: Any, opened: Any, name: str) -> None:
    page = opened(written(name), viewport={"width": 390, "height": 800}).page
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.eval_on_selector("#play", "at => at.getBoundingClientRect().right") <= 390
    clipped = "cells => cells.filter(cell => cell.scrollWidth > cell.clientWidth).map(cell => cell.textContent)"
    assert page.eval_on_selector_all("#lab-table tr:nth-child(-n+9) td", clipped) == []


def test_long_names_part_in_the_heads_of_the_laboratory(written: Any, opened: Any) -> None:
    longer = (("phi1", "angleOfTheCrank"), ("phi2", "angleOfTheConnectingRod"), ("phi3", "angleOfTheRockerBehind"))
    page = opened(written(coursework.parse_variant(mechanism("four-bar", *longer)), quantities=("table",))).page
    clipped = "heads => heads.filter(head => head.scrollWidth > head.clientWidth).map(head => head.textContent)"
    assert page.eval_on_selector_all("#lab-table th", clipped) == []


def test_without_points_there_is_no_empty_drawing(written: Any, opened: Any) -> None:
    page = opened(written(coursework.parse_variant(mechanism("slider-crank-in-other-letters")), quantities=("plots",)))
    shown = [name for name in ("live-field", "live-traces", "live-clock", "play") if page.page.locator(f"#{name}").is_visible()]
    assert shown == ["live-clock", "play"]
    page.page.focus("#live")
    page.page.keyboard.press("ArrowRight")
    assert (page.row, page.said) == (2, [])


def test_it_can_be_left_out(written: Any, opened: Any) -> None:
    text = (written("31", live=False) / "report.html").read_text(encoding="utf-8")
    assert "<script" not in text
    assert "script-src" not in text
    assert 'id="live"' not in text


def test_a_table_too_long_for_a_laboratory_still_moves(written: Any, opened: Any) -> None:
    few = 0.48 / (MOST_ROWS - 1)
    assert 'id="lab-table"' in (written("31", step=few) / "report.html").read_text(encoding="utf-8")
    folder = written("31", step=0.48 / MOST_ROWS)
    page = opened(folder)
    assert page.page.locator("#lab-table").count() == 0
    assert "The laboratory is left out" in page.page.inner_text("#live")
    text = (folder / "report.html").read_text(encoding="utf-8")
    parts = re.findall(r"<script[^>]*>(.*?)</script>", text, re.S)
    assert sum(len(part.encode()) for part in parts) <= MOST_BYTES
    page.page.focus("#live")
    path = "document.querySelector('.live-body path').getAttribute('d')"
    first = page.page.evaluate(path)
    page.page.keyboard.press("ArrowRight")
    assert page.row == 2
    page.page.keyboard.press("End")
    assert page.row == MOST_ROWS + 1
    assert page.page.evaluate(path) != first
    page.page.click("#live-velocities")
    assert page.page.locator(".live-arrows path").count() > 0
    assert page.said == []


def test_a_wide_mechanism_begins_below_the_answer_and_numbers_stand_at_one_margin(written: Any, opened: Any) -> None:
    page = opened(written(coursework.parse_variant(mechanism("gears-and-crank"))), viewport={"width": 1400, "height": 1000}).page
    assert page.evaluate("(one => one.scrollWidth - one.clientWidth)(document.querySelector('#mechanism > div'))") <= 0
    ends = "all => all.map(one => Math.round(one.getBoundingClientRect().right))"
    assert len(set(page.eval_on_selector_all("#equations .name", ends))) == 1
