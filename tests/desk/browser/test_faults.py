"""A slip is underlined where it is and listed with the sentence of `check`; a mend is one click."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from typing import Any

import pytest

from tests.desk.browser.conftest import VIEW

pytestmark = pytest.mark.browser
# What is typed over what, and a word of the sentence that follows.
SLIPS = (
    ('"0.953 m"', '"0.953 kg"', "length"),
    ("cos(phi3) - r3", "cos(ph3) - r3", "phi3"),
    ('format = 1', 'format = 7', "format"),
    ('[given]', '[givn]', "given"),
    ('"0.847 m"', '"0.847 m', ""),
    ('rate = "w1" }', 'rate = "w1"', ""),
    ('"0.02 s"', '"-0.02 s"', "0"),
    ('r2    =', 'r1    =', "r1"),
    ('w4 = "1/s"', 'w4 = "1/q"', ""),
    ('holds  = ["C.y"]', 'holds  = ["Q.y"]', "Q"),
    ('hinges = ["D"]', 'hinges = ["X"]', "X"),
    ('"table", "plots"', '"tabel", "plots"', "table"),
)  # fmt: skip
# A space typed into an equation, and what is beside the equations before any answer can come.
TYPED = f"""(() => {{ const view = {VIEW};
  view.dispatch({{ changes: {{ from: view.state.doc.toString().indexOf("cos(phi3) - r3"), insert: " " }} }});
  return [...document.querySelectorAll(".verdict")].map((one) => one.className); }})()"""


def slipped(one: Any, before: str, after: str, word: str) -> None:
    line = one.text[: one.text.index(before)].count("\n") + 1
    one.replace(before, after)
    one.rest("faulty")
    found = one.faults()
    assert any(at == line and word in sentence for at, _, sentence in found), (after, found)
    assert one.page.locator(".cm-lintRange-error").count() > 0
    assert one.report.evaluate("document.querySelectorAll('main > section').length") > 5  # the last good page stays
    one.page.keyboard.press("Control+z")
    one.rest("changed")
    assert one.faults() == []


@pytest.mark.long
def test_twelve_slips_are_underlined(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    for slip in SLIPS:
        slipped(one, *slip)
    assert one.said == []


def test_a_slip_is_underlined_and_a_mend_is_one_click(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    before = one.text
    # What the geometry said of a line is grey as soon as the line changes; of other lines it is still said.
    one.page.wait_for_selector(".verdict.right")
    shown = one.page.evaluate(TYPED)
    assert shown.count("verdict asked") == 1 < shown.count("verdict right")
    one.page.focus("#desk-text .cm-content")
    one.page.keyboard.press("Control+z")
    assert one.text == before
    slipped(one, *SLIPS[-1])
    one.replace("cos(phi3) - r3", "cos(ph3) - r3")
    one.rest("faulty")
    one.page.click("#desk-faults .go")
    assert one.page.evaluate("getSelection().toString()") == "ph3"
    # What is typed over a value meanwhile is no slider's to write over.
    slider = one.page.locator("[data-datum=r1] input[type=range]")
    assert slider.is_enabled()
    one.replace('"0.953 m"', '"0.99 m"')
    one.until(slider.is_disabled)
    one.replace('"0.99 m"', '"0.953 m"')
    one.rest("faulty")
    # There is no file of a text with faults, but its first fault; all work is what stands there, saved or not.
    one.page.click("#desk-take")
    one.page.click("[data-format=xlsx]")
    one.until(lambda: "ph3" in one.page.inner_text("dialog .told"))
    with one.page.expect_download() as taken:
        one.page.click("[data-format=zip]")
    with zipfile.ZipFile(taken.value.path()) as packed:
        assert {name: packed.read(name).decode() for name in packed.namelist()} == {"31.toml": one.text}
    one.page.keyboard.press("Escape")
    one.page.click("#desk-faults .mend")
    one.rest("changed")
    assert one.text == before
    one.until(slider.is_enabled)
    one.page.click("#desk-take")
    with one.page.expect_download() as taken:
        one.page.click("[data-format=dxf]")
    assert taken.value.suggested_filename == "31-dxf.zip"
