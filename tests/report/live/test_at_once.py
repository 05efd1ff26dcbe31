"""What a page shows before anybody has moved or waited for anything: every graph, what marks mean, data as they were given.

The mechanism is the shaper of a task sheet, which stands in no file of the catalogue.
"""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import installed_browser
from tests.drawing.outline.test_clearest import SHAPER

pytestmark = pytest.mark.browser
DRAWN = """[...document.querySelectorAll("#live-panels [data-panel]")].map((one) =>
  ["true", "table", "dots"].map((kind) => (one.querySelector(".live-" + kind).getAttribute("d") || "").split(/[ML]/).length))"""


@pytest.fixture(scope="module")
def shaper(written: Any, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("own") / "shaper.toml"
    path.write_text(SHAPER, encoding="utf-8")
    folder: Path = written(str(path))
    return folder


def test_every_graph_is_drawn_when_the_page_is_there(shaper: Path, opened: Any) -> None:
    """On a screen on which none of them can be seen, and before any frame of the page has come."""
    frozen = "window.requestAnimationFrame = () => 0; window.setTimeout = () => 0;"
    page = opened(shaper, frozen, viewport={"width": 1000, "height": 300}).page
    drawn = page.evaluate(DRAWN)
    assert len(drawn) == 9  # the crank turns evenly
    for truth, table, dots in drawn:
        assert truth > 20 and (table, dots) == (27, 27)  # 26 rows
    assert page.evaluate("document.querySelectorAll('#lab-table td:not(:empty)').length") == 26 * 10
    # What is measured on the machine comes later; its axes stand there.
    assert page.text_content("#lab-diagram .live-title >> nth=0") == "absolute error, rad or m"


def test_a_picture_taken_by_the_browser_alone_has_the_graphs(shaper: Path, tmp_path: Path) -> None:
    found = installed_browser()
    if found is None:
        pytest.skip("no browser on the path")
    told = subprocess.run(
        [found, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", (shaper / "report.html").as_uri()],
        capture_output=True, text=True, check=True, timeout=120, encoding="utf-8",
    ).stdout  # fmt: skip
    panels = told.partition('id="live-panels"')[2].partition('class="live-below"')[0]
    assert panels.count('class="live-true" d="M') == 9
    assert panels.count('class="live-dots" d="M') == 9


def test_the_blue_row_and_the_orange_line_are_told(shaper: Path, opened: Any) -> None:
    page = opened(shaper).page
    told = page.inner_text("#live")
    assert "the orange line marks the time of the drawing. Its row is blue in every table." in told
    assert page.inner_text("#results .live-note").strip() == "Blue row: the time of the moving drawing."
    assert "orange line: the time of the moving drawing" in page.inner_text("#graphs .key >> nth=0")
    line, mark = (
        page.evaluate(f"getComputedStyle(document.querySelector('{one}')).backgroundColor")
        for one in (".live-line", ".live-cursor")
    )
    assert line == mark
    page.evaluate("scrub.value = 1; scrub.dispatchEvent(new Event('input'))")  # before that nothing is marked
    row, mark = (
        page.evaluate(f"getComputedStyle(document.querySelector('{one}')).backgroundColor")
        for one in (".live-row", "#results tr.live-now td")
    )
    assert row == mark
    page.emulate_media(media="print")
    assert not page.is_visible("#results .live-note")
    assert not page.is_visible("#graphs .key .live-note")


def test_without_what_moves_nothing_tells_of_it(written: Any, opened: Any) -> None:
    assert opened(written("31", live=False)).page.locator(".live-note").count() == 0
    assert not opened(written("31"), java_script_enabled=False).page.is_visible("#results .live-note")


@pytest.mark.parametrize(("name", "before", "after"), [("n", "120 rpm", "180 rpm"), ("r1", "0.1 m", "0.15 m")])
def test_a_datum_is_told_in_the_unit_in_which_it_was_given(shaper: Path, opened: Any, name: str, before: str, after: str) -> None:
    page = opened(shaper)
    page.page.select_option("#lab-datum-name", name)
    assert page.page.inner_text("#lab-value") == before
    page.set("#lab-datum", page.page.get_attribute("#lab-datum", "max"))
    assert page.page.inner_text("#lab-value") == after
    assert page.page.get_attribute("#lab-datum", "aria-valuetext") == after


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "datum", "value"), [("whitworth", "d", "50 mm"), ("whitworth", "w0", "60 rpm"), ("v101", "beta", "45°")]
)
def test_also_millimetres_turns_a_minute_and_degrees(written: Any, opened: Any, name: str, datum: str, value: str) -> None:
    page = opened(written(name)).page
    page.select_option("#lab-datum-name", datum)
    assert page.inner_text("#lab-value") == value
