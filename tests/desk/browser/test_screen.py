"""The desk on a wide screen, a narrower one and a phone, light and dark, with faults, notices and dialogs open: nothing cut,
covered, pale or beyond the keyboard.

The judge is the one of the report's pages; axe-core looks too where `tests/javascript` has fetched it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.axe import ASKED, AXE

pytestmark = pytest.mark.browser
TESTS = Path(__file__).parents[2]
WIDE, BETWEEN, PHONE = (1400, 900), (1000, 900), (390, 844)
DIALOGS = {"#desk-new": ".card svg", "#desk-take": "[data-format]", "#desk-table": ".drop", "#desk-files": ".files li"}


def complaints(one: Any, size: tuple[int, int]) -> list[Any]:
    """Return what a person would complain about in one window, with both colours of a screen."""
    page = one.page
    page.set_viewport_size({"width": size[0], "height": size[1]})
    found = [*page.evaluate("judge.layout()"), *page.evaluate("judge.access()")]
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        found += page.evaluate("judge.contrast()")
        found += page.evaluate(ASKED) if AXE.exists() else []
    return found


def looked_at(desk: Callable[..., Any]) -> Any:
    """A desk whose page may be asked by scripts of the tests."""
    one, _ = desk(bypass_csp=True)
    for path in (TESTS / "report" / "pages" / "screen.js", *([AXE] if AXE.exists() else [])):
        one.page.add_script_tag(path=path)
    return one


@pytest.mark.parametrize("size", [*(pytest.param(size, marks=pytest.mark.long) for size in (WIDE, BETWEEN)), PHONE])
def test_a_desk_at_rest_and_with_faults_is_read(size: tuple[int, int], desk: Callable[..., Any]) -> None:
    one = looked_at(desk)
    assert complaints(one, size) == []
    assert size == PHONE or one.page.eval_on_selector("#desk-bar", "one => one.offsetHeight") < 60  # one line
    one.replace("cos(phi3) - r3", "cos(ph3) - r3")
    one.rest("faulty")
    assert complaints(one, size) == []


@pytest.mark.long
@pytest.mark.parametrize("size", [WIDE, PHONE])
@pytest.mark.parametrize("opener", DIALOGS)
def test_a_dialog_is_read(opener: str, size: tuple[int, int], desk: Callable[..., Any]) -> None:
    one = looked_at(desk)
    one.page.click(opener)
    one.page.wait_for_selector(DIALOGS[opener])
    assert complaints(one, size) == []
    one.page.keyboard.press("Escape")
    one.page.wait_for_selector("dialog", state="detached")


HEADINGS = "[...document.querySelectorAll('h2')].map((one) => one.textContent)"
CUT = """[...document.querySelectorAll("#desk-bar select, #desk-bar input")].filter((one) => {
    const { font, paddingLeft, paddingRight } = getComputedStyle(one), pen = document.createElement("canvas").getContext("2d");
    pen.font = font;
    const arrow = one.matches("select") ? 20 : 0;
    const room = one.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - arrow;
    return pen.measureText(arrow ? one.selectedOptions[0].text : one.placeholder).width > room;
}).map((one) => one.id)"""


@pytest.mark.parametrize(
    "language", [pytest.param("uk", marks=pytest.mark.long), "ru", pytest.param("zh", marks=pytest.mark.long)]
)
def test_another_language_keeps_the_text_and_its_undo(language: str, desk: Callable[..., Any]) -> None:
    one = looked_at(desk)
    before = one.text
    english, headings = one.page.inner_text("#desk-bar"), one.report.evaluate(HEADINGS)
    one.replace('"0.953 m"', '"0.954 m"')
    one.page.select_option("#desk-language", language)
    one.page.wait_for_selector(f"html[lang={language}]")
    one.rest("changed")
    assert one.report.evaluate("document.documentElement.lang") == language
    words = set(one.page.inner_text("#desk-bar").split()) & set(english.split())
    assert "Save" not in words
    assert one.page.evaluate(CUT) == []
    others = one.report.evaluate(HEADINGS)  # also of the sections that nobody has looked at
    assert len(others) == len(headings)
    assert set(others) & set(headings) == set()
    assert complaints(one, WIDE) == []
    one.page.focus("#desk-text .cm-content")
    one.page.keyboard.press("Control+z")
    assert one.text == before
