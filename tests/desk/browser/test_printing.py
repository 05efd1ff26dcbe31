"""Printed is the report, and nothing of the desk around it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pymupdf
import pytest

pytestmark = [pytest.mark.browser, pytest.mark.long]


def test_the_report_is_printed_alone(desk: Callable[..., Any]) -> None:
    one, _ = desk()
    with pymupdf.open(stream=one.page.pdf(format="A4", prefer_css_page_size=True)) as printed:
        text = " ".join(" ".join(page.get_text() for page in printed).split())
        assert 8 <= len(printed) <= 13
    # All of it, also what nobody has looked at on the screen.
    for word in ("Graph-analytical check", "Conclusion", "Newton projection per step", "Numerical method"):
        assert word in text
    assert "Write equations" not in text
    assert "format = 1" not in text
    assert one.page.evaluate("document.querySelector('#desk-print').children.length") == 0
    assert one.said == []
