"""A real browser shows the page without a complaint, fetches nothing, and prints it on A4."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType
from typing import Any

import pymupdf
import pytest

from tests.report.made import model_of, page_of, solved

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def report(real: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    run = real.full()
    path: Path = tmp_path_factory.mktemp("page") / "report.html"
    path.write_text(page_of(model_of(run)), encoding="utf-8")
    return path.parent


@pytest.mark.parametrize("width", [1400, 800, 390])
def test_it_is_shown_without_a_complaint(opened: Any, report: Path, width: int) -> None:
    shown = opened(report, viewport={"width": width, "height": 900})
    page = shown.page
    assert shown.said == []
    assert shown.fetched == [(report / "report.html").as_uri()]
    assert page.title() == "Variant 31: Rolling wheel, right-angled link, crank and rod"
    assert page.locator("h2").count() == 12
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    # Every equation is a picture with a height of its own.
    heights = page.eval_on_selector_all(".formula svg", "all => all.map(one => one.getBoundingClientRect().height)")
    assert len(heights) > 12
    assert min(heights) > 8


def test_it_prints_on_a4_true_to_scale(opened: Any, report: Path) -> None:
    printed = opened(report).page.pdf(format="A4", prefer_css_page_size=True)
    with pymupdf.open(stream=printed, filetype="pdf") as document:
        assert 5 <= len(document) <= 16
        for sheet in document:
            sides = sorted((round(sheet.rect.width / 72 * 25.4), round(sheet.rect.height / 72 * 25.4)))
            assert sides == [210, 297]
            blocks = list(sheet.get_text("blocks"))
            assert all(block[2] < sheet.rect.width - 15 / 25.4 * 72 for block in blocks)
        assert [abs(length - 100) < 0.05 for length in bars(document)] == [True]


@pytest.mark.long
def test_an_upright_construction_prints_true_to_scale_too(opened: Any, tmp_path: Path) -> None:
    (tmp_path / "report.html").write_text(page_of(model_of(solved("jansen", quantities=["graph_check"]))), encoding="utf-8")
    printed = opened(tmp_path).page.pdf(format="A4", prefer_css_page_size=True)
    with pymupdf.open(stream=printed, filetype="pdf") as document:
        assert all(sheet.rect.width < sheet.rect.height for sheet in document)
        # The sheet with the plan of velocities has a bar as the construction has.
        assert [abs(length - 100) < 0.05 for length in bars(document)] == [True, True]


def bars(document: Any) -> list[float]:
    """Return the lengths (mm) of the lines in the colour of the bar by which a print is checked."""
    lines = [path for sheet in document for path in sheet.get_drawings() if path["color"]]
    return [
        max(path["rect"].width, path["rect"].height) / 72 * 25.4
        for path in lines
        if max(abs(part - 1 / 255) for part in path["color"]) < 1e-3
    ]
