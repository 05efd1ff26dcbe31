"""New: the catalogue by pictures and words; a mechanism from pieces, each hung on a point that the text has."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]
VARIANTS = Path(__file__).parents[3] / "variants"


def test_the_catalogue_is_searched_and_one_is_begun(desk: Callable[..., Any]) -> None:
    one, folder = desk()
    page = one.page
    page.click("#desk-new")
    page.wait_for_selector("[data-variant] svg")
    assert page.locator("#desk-new [data-variant] svg").count() == len(list(VARIANTS.glob("*.toml")))
    page.fill("#desk-new input[type=search]", "RRR walking")
    assert page.locator("[data-variant]:visible").evaluate_all("list => list.map(one => one.dataset.variant)") == ["jansen"]
    page.click("[data-variant=jansen]")
    page.fill("#desk-line", "31 and more")
    page.keyboard.press("Enter")
    assert page.inner_text("#desk-line-why")
    page.fill("#desk-line", "walking")
    page.keyboard.press("Enter")
    one.until(lambda: one.text == (VARIANTS / "jansen.toml").read_text(encoding="utf-8"))
    one.rest("changed")
    assert list(folder.iterdir()) == []  # nothing is written before somebody saves
    page.click("#desk-save")
    one.rest("saved")
    assert (folder / "walking.toml").is_file()


def test_a_mechanism_is_built_from_pieces(desk: Callable[..., Any]) -> None:
    one, _ = desk("edit", "fresh", "--no-browser")
    page = one.page

    def hang(kind: str, point: str = "") -> None:
        before = one.text
        page.click("#desk-new")
        page.click(f"[data-piece={kind}]")
        if point:
            page.select_option("#desk-on-from", point)
        page.click("dialog .main")
        one.until(lambda: one.text != before)
        one.rest("changed")

    # The pieces stand below the catalogue; a button leads there.
    page.click("#desk-new")
    page.wait_for_selector("[data-variant] svg")
    page.wait_for_selector("[data-piece=wheel] svg")
    page.click("dialog .row button >> nth=1")
    one.until(lambda: page.eval_on_selector("[data-piece=crank]", "one => one.getBoundingClientRect().bottom < innerHeight"))
    page.keyboard.press("Escape")
    hang("crank")
    assert one.faults() == []
    hang("RRR", "B")
    assert one.text.count("[[group]]") == 2
    assert one.report.evaluate("document.querySelectorAll('#mechanism [data-joint]').length") >= 4
    page.focus("#desk-text .cm-content")
    page.keyboard.press("Control+z")
    one.until(lambda: one.text.count("[[group]]") == 1)


def test_an_empty_text_begins_with_an_empty_page(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    page = one.page
    assert page.locator("[data-datum]").count() > 0
    page.click("#desk-new")
    page.click("dialog .row button")
    page.wait_for_selector("#desk-line")
    page.keyboard.press("Enter")
    one.until(lambda: one.text == "")
    one.rest("faulty")
    # What the text before had is nowhere; what an empty one lacks is told, but underlined nowhere.
    assert (page.locator("[data-datum]").count(), page.locator("[class*=cm-lint]").count()) == (0, 0)
    assert page.is_visible("#desk-welcome")
    assert not page.is_visible("#desk-pale")
    assert "without faults. The section [coordinates] is missing." in page.text_content("#desk-pale")
    # It is told as what is still to be typed, with a click each that begins it.
    assert page.locator("#desk-faults .missing").count() == len(one.faults()) == 2
    for begun in ("[coordinates]", "[time]", "[[constraint]]"):
        page.wait_for_selector(f"#desk-faults .missing:has-text('{begun.strip('[]')}') .mend").click()
        one.until(lambda begun=begun: begun in one.text)
        one.rest("faulty")
    assert page.locator("#desk-faults .missing").count() == 0
    assert page.is_visible("#desk-pale") and not page.is_visible("#desk-welcome")
    assert "The report appears as soon as this is mended." in page.text_content("#desk-pale")
    for _ in range(3):
        page.keyboard.press("Control+z")
    one.until(lambda: one.text == "" and len(one.faults()) == 2)
    page.click("#desk-equations")
    assert page.wait_for_selector("[data-notice=refused] span").inner_text() in one.faults()[0][2]
    page.focus("#desk-text .cm-content")
    page.keyboard.type("[given")
    one.rest("faulty")
    assert page.is_visible("#desk-welcome")
