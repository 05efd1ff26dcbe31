"""The drawing is an instrument: a joint dragged by mouse or arrow keys moves numbers of the text; one undo takes it back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytestmark = pytest.mark.browser
SHOWN = """({ ownerSVGElement: svg }) => ({
  box: svg.getAttribute("viewBox"), set: svg.style.width + svg.style.height + svg.style.overflow,
  wide: parseFloat(svg.getAttribute("width")), high: parseFloat(svg.getAttribute("height")),
})"""


def numbers(text: str) -> dict[str, str]:
    """Return what stands behind each name of the data and the start."""
    lines = [line.partition("=") for line in text.partition("[drive]")[0].splitlines() + text.splitlines() if "=" in line]
    return {name.strip(): value.partition("#")[0].strip() for name, _, value in lines}


def moved(before: str, after: str) -> set[str]:
    one, other = numbers(before), numbers(after)
    return {name for name in one if one[name] != other[name]}


def test_a_joint_is_dragged_and_the_text_follows(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    page, before = one.page, one.text
    ring = page.frame_locator("#desk-page").locator("[data-joint=M]")
    ring.evaluate("one => one.scrollIntoView({ block: 'center' })")
    box, frame = ring.bounding_box(), page.frame_locator("#desk-page").locator("[data-joint=D]")
    fixed = frame.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(1, 4):
        page.mouse.move(x + 5 * step, y + 7 * step)
    one.until(lambda: moved(before, one.text) == {"phi1", "phi2", "phi3"})
    one.rest("changed")
    assert all(abs(frame.bounding_box()[side] - fixed[side]) < 1 for side in "xy")  # the drawing does not jump under the hand
    page.mouse.up()
    one.rest("changed")
    # Once the hand is off, the figure is as large as it fits: it was the window of the sheet that had been dragged upon.
    drawn = ring.evaluate(SHOWN)
    assert (drawn["box"], drawn["set"]) == (f"0 0 {drawn['wide']} {drawn['high']}", "")
    assert ring.get_attribute("transform") is None  # it is where the drawing has it, not where the hand was
    page.focus("#desk-text .cm-content")
    page.keyboard.press("Control+z")
    one.rest("changed")
    assert one.text == before


@pytest.mark.long
def test_a_joint_is_moved_by_keyboard_and_says_why_it_stays(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    page, before = one.page, one.text
    ring = page.frame_locator("#desk-page").locator("[data-joint=M]")
    # The joint keeps the focus while the page is made anew under it.
    ring.focus()
    asked = one.asked["POST api/drag"]
    page.keyboard.press("ArrowUp")
    one.until(lambda: moved(before, one.text) == {"phi1", "phi2", "phi3"})
    one.rest("changed")
    assert one.asked["POST api/drag"] == asked + 1
    assert one.report.evaluate("document.activeElement.dataset.joint") == "M"
    # What nothing frees says why.
    page.frame_locator("#desk-page").locator("[data-joint=D]").focus()
    page.keyboard.press("ArrowUp")
    page.frame_locator("#desk-page").locator("#drag-why:not(:empty)").wait_for()
    # With Alt the lengths follow.
    page.frame_locator("#desk-page").locator("[data-joint=A]").focus()
    page.keyboard.press("Alt+ArrowUp")
    one.until(lambda: moved(before, one.text) & {"r1", "r2", "r3"})
    assert page.locator(".desk-moved").count() > 0
    assert one.said == []


@pytest.mark.long
def test_a_finger_drags_a_joint_and_not_the_page(desk: Callable[..., Any]) -> None:
    one, _ = desk(has_touch=True)
    page, before = one.page, one.text
    ring = page.frame_locator("#desk-page").locator("[data-joint=M]")
    ring.evaluate("one => one.scrollIntoView({ block: 'center' })")
    box, hand = ring.bounding_box(), page.context.new_cdp_session(page)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def touch(kind: str, *points: dict[str, float]) -> None:
        hand.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [*points]})

    touch("touchStart", {"x": x, "y": y})
    for step in range(1, 6):  # farther than where a page would begin to scroll
        touch("touchMove", {"x": x + 5 * step, "y": y + 6 * step})
    touch("touchEnd")
    one.until(lambda: moved(before, one.text) == {"phi1", "phi2", "phi3"})
    one.rest("changed")
    start = float(numbers(one.text)["phi1"].partition('start = "')[2].partition(" ")[0])
    assert abs(start - 1.63) < 0.3  # a touch that is broken off would end in the corner of the window: 2.18
    assert one.report.evaluate("document.documentElement.classList.contains('dragging')") is False
