"""The desk for everybody: work is in the browser alone, goes out as one zip and comes back, is forgotten when asked."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from typing import Any

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]


def test_work_stays_in_the_browser_goes_out_and_comes_back(desk: Callable[..., Any]) -> None:
    one, folder = desk("serve")
    page = one.page
    page.click("#desk-new")
    page.click("[data-variant=example-1]")
    page.fill("#desk-line", "mine")
    page.keyboard.press("Enter")
    one.rest("saved")
    one.replace("format", "# my own\nformat")
    one.rest("changed", "saved")
    one.rest("saved")
    text = one.text
    page.reload()
    one.rest("saved")
    assert one.text == text
    assert list(folder.iterdir()) == []
    page.click("#desk-take")
    with page.expect_download() as taken:
        page.click("[data-format=zip]")
    packed = taken.value.path().read_bytes()
    with zipfile.ZipFile(io.BytesIO(packed)) as zipped:
        assert {name: zipped.read(name).decode() for name in zipped.namelist()} == {"mine.toml": text}
    page.keyboard.press("Escape")
    page.click("#desk-forget")
    page.click("dialog .main")
    page.wait_for_selector("#desk-welcome:not([hidden])")  # the page is loaded anew
    assert page.evaluate("Object.keys(localStorage).every(key => !/[.](work|draft)/.test(key))")
    assert one.text == ""
    page.click("#desk-take")
    page.set_input_files("#desk-open", {"name": "all.zip", "mimeType": "application/zip", "buffer": packed})
    one.until(lambda: one.text)  # one text alone is opened at once
    one.rest("saved")
    assert one.text == text
