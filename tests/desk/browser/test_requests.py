"""How often the desk asks: once for what is typed in one go, one at a time for what is moved, again where nobody answers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]
PAGE = "POST api/page"


def test_what_is_typed_in_one_go_is_asked_once(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    assert one.asked[PAGE] == 1
    before = one.asked[PAGE]
    one.page.focus("#desk-text .cm-content")
    one.page.keyboard.press("Control+Home")
    one.page.keyboard.type("# twenty letters here")
    one.rest("computing")
    one.rest("changed")
    assert one.asked[PAGE] == before + 1


def test_a_slider_is_followed_one_answer_at_a_time_to_its_end(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    flying, most = 0, 0

    def count(change: int) -> None:
        nonlocal flying, most
        flying += change
        most = max(most, flying)

    one.page.on("request", lambda request: request.url.endswith("/api/page") and count(1))
    for end in ("requestfinished", "requestfailed"):
        one.page.on(end, lambda request: request.url.endswith("/api/page") and count(-1))
    before = one.asked[PAGE]
    one.page.focus("[data-datum=r1] input[type=range]")
    for _ in range(12):
        one.page.keyboard.press("ArrowRight")
    one.rest("changed")
    value = one.page.input_value("[data-datum=r1] input[type=text]")
    assert f'"{value} m"' in one.text
    assert value in one.report.inner_text("#statement")
    assert most == 1
    assert one.asked[PAGE] <= before + 13
    one.page.focus("#desk-text .cm-content")
    one.page.keyboard.press("Control+z")
    one.until(lambda: '"0.964 m"' in one.text)  # one press of a key is undone, not all twelve


def test_where_nobody_answers_nothing_is_lost_and_it_asks_again(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    one.page.route("**/api/page", lambda route: route.abort())
    one.replace('"0.953 m"', '"0.954 m"')
    one.rest("unreachable")
    assert one.page.evaluate("JSON.parse(localStorage.getItem('coursework.draft.31')).text.includes('0.954 m')")
    one.page.unroute("**/api/page")
    one.rest("changed")
    assert "0.954" in one.report.inner_text("#statement")


def test_a_busy_server_is_asked_again_when_it_says(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    refusal = {"status": 503, "headers": {"Retry-After": "1"}, "json": {"sentence": "All are busy."}}
    one.page.route("**/api/page", lambda route: route.fulfill(**refusal), times=1)
    one.replace('"0.953 m"', '"0.954 m"')
    one.rest("unreachable")
    assert one.page.inner_text("#desk-state") == "All are busy."
    one.rest("changed")


def test_what_changes_no_number_leaves_the_moving_part_as_it_is(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    one.report.evaluate("document.querySelector('#live').mark = document.querySelector('#results').mark = 'the same'")
    one.replace("# DA", "# D to A")
    one.rest("changed")
    marks = "['#live', '#results'].map(one => document.querySelector(one).mark)"
    assert one.report.evaluate(marks) == ["the same", "the same"]
    # Where numbers change, scheme, row and place on the screen stay.
    one.report.select_option("#lab-scheme", "rk4")
    one.report.evaluate("scrollTo(0, document.querySelector('#graphs').offsetTop)")
    top = one.report.evaluate("document.querySelector('#graphs').getBoundingClientRect().top")
    one.replace('"0.953 m"', '"0.954 m"')
    one.rest("changed")
    assert one.report.evaluate(marks) == [None, None]
    assert one.report.input_value("#lab-scheme") == "rk4"
    assert abs(one.report.evaluate("document.querySelector('#graphs').getBoundingClientRect().top") - top) < 2


def test_the_study_comes_when_it_is_looked_at(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    heads = one.report.eval_on_selector_all("main > section > h2", "list => list.map(one => one.innerText)")
    assert one.report.locator("#accuracy > *").count() == 1
    before = one.asked[PAGE]
    one.report.evaluate("document.querySelector('#accuracy').scrollIntoView()")
    one.report.wait_for_selector("#accuracy table")
    assert one.asked[PAGE] == before + 1
    assert one.report.locator("[data-later]").count() == 0
    assert one.report.eval_on_selector_all("main > section > h2", "list => list.map(one => one.innerText)") == heads
    # What was there stays, pale, until it is there anew: nothing jumps under the eyes of a reader.
    one.report.evaluate("scrollTo(0, 0)")
    one.replace('"0.953 m"', '"0.954 m"')
    one.rest("changed")
    assert one.report.locator("#accuracy[data-later] table").count() > 0
    one.report.evaluate("document.querySelector('#accuracy').scrollIntoView()")
    one.report.wait_for_selector("#accuracy:not([data-later]) table")
