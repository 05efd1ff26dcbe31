"""Everything by keyboard: Tab leaves the text, F6 goes from part to part, dialogs give the focus back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]
WHERE = "(document.activeElement.closest('#desk-bar, #desk-text, #desk-faults, #desk-data, #desk-page, dialog') ?? {}).id"


def test_a_variant_is_changed_saved_and_taken_by_keyboard_alone(desk: Callable[..., Any]) -> None:
    one, folder = desk()
    page, press = one.page, one.page.keyboard.press
    reached = []
    for _ in range(12):
        press("Tab")
        reached.append(page.evaluate("document.activeElement.closest('[id]').id"))
    for control in (
        "desk-files",
        "desk-save",
        "desk-new",
        "desk-take",
        "desk-table",
        "desk-scheme",
        "desk-step",
        "desk-language",
    ):
        assert control in reached
    # F6 from the bar to the text, on to the data, into the report, back to the bar.
    page.focus("#desk-save")
    parts = []
    for _ in range(3):
        press("F6")
        parts.append(page.evaluate(WHERE))
    assert parts == ["desk-text", "desk-data", "desk-page"]
    press("F6")  # the frame hands it on
    page.wait_for_selector("#desk-text .cm-focused")
    # A line is typed, its fault visited with Enter, and mended.
    press("Control+Home")
    page.keyboard.type("x = 1\n")
    one.rest("faulty")
    press("F6")
    assert page.evaluate(WHERE) == "desk-faults"
    press("Enter")
    page.wait_for_selector("#desk-text .cm-focused")
    for _ in range(6):
        press("Control+z")
    one.rest("changed")
    press("Control+s")
    one.rest("saved")
    assert (folder / "31.toml").is_file()
    # A dialog takes the focus and gives it back; a format is taken.
    page.focus("#desk-take button")
    press("Enter")
    page.wait_for_selector("dialog [data-format=csv]")
    page.focus("dialog [data-format=toml]")
    with page.expect_download() as taken:
        press("Enter")
    assert taken.value.suggested_filename == "31.toml"
    press("Escape")
    assert page.evaluate("document.activeElement.parentElement.id") == "desk-take"
    # What is looked for is typed at once.
    page.focus("#desk-new button")
    press("Enter")
    page.wait_for_selector("[data-variant=watt]")
    page.keyboard.type("watt")
    one.until(lambda: page.eval_on_selector_all(".cards:not(.pieces) > :not([hidden])", "all => all.length") < 5)
    press("Escape")  # the word, then the dialog
    press("Escape")
    # Where there is no page yet F6 goes past it.
    page.evaluate("document.getElementById('desk-page').classList.add('empty')")
    page.focus("#desk-text .cm-content")
    press("F6")
    press("F6")
    assert page.evaluate(WHERE) == "desk-bar"
    # Of the sections those that are not begun yet are offered, in the order of a file.
    page.focus("#desk-text .cm-content")
    press("Control+End")
    page.keyboard.type("\n[")
    page.wait_for_selector(".cm-completionLabel")
    offered = page.eval_on_selector_all(".cm-completionLabel", "all => all.map(one => one.textContent)")
    assert offered[0] == "[functions]"
    assert "[given]" not in offered
    assert one.said == []
