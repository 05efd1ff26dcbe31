"""What other programs do to a file, and what a person does with files: nothing typed is lost, nothing written over unseen."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]
OWN, OTHER = ('"0.953 m"', '"0.955 m"'), ('"0.953 m"', '"0.954 m"')


def saved(desk: Callable[..., Any]) -> tuple[Any, Path]:
    one, folder = desk()
    one.page.click("#desk-save")
    one.rest("saved")
    return one, folder / "31.toml"


def test_a_change_from_outside_is_taken_over_at_once(desk: Callable[..., Any]) -> None:
    one, path = saved(desk)
    path.write_text(one.text.replace(*OTHER), encoding="utf-8")
    one.page.wait_for_selector("[data-notice=outside]")
    one.rest("saved")
    assert one.text == path.read_text(encoding="utf-8")
    assert one.page.input_value("[data-datum=r1] input[type=text]") == "0.954"


@pytest.mark.parametrize("choice", ["mine", "theirs"])
def test_two_changes_are_shown_side_by_side(choice: str, desk: Callable[..., Any]) -> None:
    one, path = saved(desk)
    path.write_text(f"{one.text}\n", encoding="utf-8")
    one.page.wait_for_selector("[data-notice=outside]")
    first = one.text
    one.replace(*OWN)
    path.write_text(first.replace(*OTHER), encoding="utf-8")
    one.page.wait_for_selector("#desk-state[data-file=conflict]")
    assert one.page.locator("[data-notice=outside]").count() == 0  # what was taken over is the past
    one.page.keyboard.press("Control+s")
    assert one.page.locator(".merge .cm-changedLine").count() == 2
    assert path.read_text(encoding="utf-8") == first.replace(*OTHER)
    one.page.click(f"[data-choice={choice}]")
    one.rest("saved")
    assert one.text == path.read_text(encoding="utf-8") == first.replace(*(OWN if choice == "mine" else OTHER))


def test_files_are_copied_renamed_deleted_and_brought_back(desk: Callable[..., Any]) -> None:
    one, path = saved(desk)
    page, folder = one.page, path.parent

    def names() -> set[str]:
        return {each.stem for each in folder.glob("*.toml")}

    def act(name: str, what: str, other: str = "") -> None:
        page.click(f"li[data-name='{name}'] [data-act={what}]")
        if other:
            page.fill("#desk-line", other)
            page.keyboard.press("Enter")
            page.wait_for_selector(f".files li[data-name={other}]")

    page.click("#desk-files")
    act("31", "duplicate", "copy")
    assert names() == {"31", "copy"}
    act("copy", "rename", "other")
    assert names() == {"31", "other"}
    act("other", "remove")
    page.wait_for_selector("li.deleted[data-name=other]")
    assert names() == {"31"}
    act("other", "restore")
    page.wait_for_selector("li:not(.deleted)[data-name=other]")
    assert names() == {"31", "other"}


def test_where_the_browser_keeps_nothing_no_other_text_is_opened_unasked(desk: Callable[..., Any]) -> None:
    one, path = saved(desk)
    (path.parent / "other.toml").write_text(one.text, encoding="utf-8")
    one.page.evaluate("void (Storage.prototype.setItem = () => { throw new Error('full'); })")
    one.replace(*OWN)
    before = one.text
    one.page.click("#desk-files")
    one.page.click("li[data-name=other] .name")
    one.page.wait_for_selector("dialog .main")
    one.page.keyboard.press("Escape")
    assert (one.text, one.page.inner_text("#desk-name")) == (before, "31")
    one.page.click("#desk-files")
    one.page.click("li[data-name=other] .name")
    one.page.click("dialog .main")
    one.until(lambda: one.page.inner_text("#desk-name") == "other")


def test_a_folder_that_cannot_be_written_is_said_before_the_first_change(desk: Callable[..., Any]) -> None:
    one, folder = desk()
    assert one.page.locator("#desk-notices p").count() == 0

    def refuses(route: Any) -> None:
        answer = route.fetch()
        route.fulfill(response=answer, body=answer.text().replace('"writable": true', '"writable": false'))

    one.page.route(lambda url: urlsplit(url).path == "/", refuses)
    one.page.reload()
    one.rest("changed", "saved")
    assert str(folder) in one.page.inner_text("[data-notice=folder]")
