"""Switches of the part that moves keep their state while a page is written anew, those that are on from the beginning too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.browser
TEXT = (Path(__file__).parents[3] / "variants" / "example-1-forces.toml").read_text(encoding="utf-8")


def test_reactions_stay_on_and_off_as_they_were(desk: Callable[..., Any]) -> None:
    one, _ = desk("edit", "reacting", "--no-browser")
    one.page.click("#desk-text .cm-content")
    one.page.keyboard.insert_text(TEXT)
    one.rest("changed")

    def pressed() -> dict[str, str]:
        one.report.wait_for_selector("#live-forces")
        read = "all => Object.fromEntries(all.map(at => [at.id, at.getAttribute('aria-pressed')]))"
        return dict(one.report.eval_on_selector_all(".live-switches [aria-pressed]", read))

    assert pressed()["live-forces"] == "true"
    one.replace('"4 kg"', '"5 kg"')
    one.rest("changed")
    assert pressed()["live-forces"] == "true"
    one.report.click("#live-forces")
    one.report.click("#live-traces")
    one.replace('"5 kg"', '"6 kg"')
    one.rest("changed")
    assert pressed() == {"live-traces": "true", "live-velocities": "false", "live-centres": "false", "live-forces": "false"}
