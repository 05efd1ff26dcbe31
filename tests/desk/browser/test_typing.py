"""A person types a variant from nothing, saves it, loses the tab, moves a slider, takes it back: a real desk, a real browser."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.browser
VARIANTS = Path(__file__).parents[3] / "variants"
SHEET = (VARIANTS / "v101.toml").read_text(encoding="utf-8")


def test_a_variant_is_typed_from_nothing_saved_and_moved(desk: Callable[..., Any]) -> None:
    """One desk for all of it: what a newcomer does in the first minutes, in this order."""
    one, folder = desk("edit", "fresh", "--no-browser")
    page = one.page
    assert page.is_visible("#desk-welcome")
    # Typed: letter by letter what stands in the file, nothing closed or indented by itself.
    page.click("#desk-text .cm-content")
    typed, rest = SHEET[:60], SHEET[60:]
    page.keyboard.type(typed)
    page.keyboard.insert_text(rest)
    assert one.text == SHEET
    one.rest("changed")
    assert one.faults() == []
    assert one.state == ("changed", "changed")
    assert not page.is_visible("#desk-welcome")
    one.report.evaluate("document.querySelector('#checks').scrollIntoView()")
    one.report.wait_for_selector("#checks tbody")
    checks = one.report.eval_on_selector_all("#checks tbody", "list => list.length")
    assert checks > 10
    # The tab dies; what was typed is there again and said so.
    page.reload()
    one.rest("changed")
    assert one.text == SHEET
    assert page.is_visible("[data-notice=restored]")
    # Saved with the keyboard.
    page.keyboard.press("Control+s")
    one.rest("saved")
    assert (folder / "fresh.toml").read_text(encoding="utf-8") == SHEET
    assert one.state == ("saved", "saved")
    # A slider writes its number into the text, comments and order stay; undo takes it back.
    line = next(line for line in SHEET.splitlines() if line.startswith("r1"))
    value = page.input_value("[data-datum=r1] input[type=text]")
    page.focus("[data-datum=r1] input[type=range]")
    page.keyboard.press("ArrowRight")
    one.rest("changed")
    moved = page.input_value("[data-datum=r1] input[type=text]")
    assert moved != value
    assert one.text == SHEET.replace(line, line.replace(value, moved, 1))
    page.keyboard.press("ArrowRight")  # another gesture, taken back by itself
    one.until(lambda: page.input_value("[data-datum=r1] input[type=text]") != moved)
    page.focus("#desk-text .cm-content")
    page.keyboard.press("Control+z")
    assert one.text == SHEET.replace(line, line.replace(value, moved, 1))
    page.keyboard.press("Control+z")
    one.rest("saved")
    assert one.text == SHEET
    # The field does the same.
    page.fill("[data-datum=r1] input[type=text]", "0.61")
    page.keyboard.press("Enter")
    one.rest("changed")
    assert line.replace(value, "0.61", 1) in one.text
    # Copied as it stands, and renamed: the desk goes on with the new name.
    for act, other, proposed in (("duplicate", "copy", "fresh-2"), ("rename", "other", "fresh")):
        page.click("#desk-files")
        page.click(f"li[data-name=fresh] [data-act={act}]")
        assert page.input_value("#desk-line") == proposed
        page.fill("#desk-line", other)
        page.keyboard.press("Enter")
        one.until((folder / f"{other}.toml").exists)
        page.wait_for_selector("dialog:has(#desk-line)", state="detached")
        assert page.locator("dialog .told").all_inner_texts() in ([], [""])
        page.keyboard.press("Escape")
    one.until(lambda: page.inner_text("#desk-name") == "other")
    one.report.wait_for_selector("#mechanism")  # the very text that stood there has its page all the same
    assert (folder / "copy.toml").read_text(encoding="utf-8") == one.text
    assert one.said == []
