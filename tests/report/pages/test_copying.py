"""What a page puts on the clipboard: LaTeX, tables for a spreadsheet, figures; by mouse, finger and keyboard, from a file."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from coursework.report.formulas.latex import latex
from tests.report.made import model_of, page_of, solved

pytestmark = pytest.mark.browser

CLIPBOARD = """navigator.clipboard.read().then(async ([one]) => Object.fromEntries(await Promise.all(one.types.map(
  async (kind) => [kind, kind === "text/plain" ? await (await one.getType(kind)).text() : (await one.getType(kind)).size]))))"""
STOPS = "[...document.querySelectorAll('main > section')].map((one) => one.querySelectorAll('.copy[tabindex=\"0\"]').length)"
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def page(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    path: Path = tmp_path_factory.mktemp("copying") / "report.html"
    path.write_text(page_of(model_of(solved("31"), "ru", live=True)), encoding="utf-8")
    context = browser.new_context(viewport={"width": 1400, "height": 900}, permissions=["clipboard-read", "clipboard-write"])
    shown = context.new_page()
    shown.said, shown.asked = [], []
    shown.on("console", lambda message: shown.said.append(message.text))
    shown.on("request", lambda request: shown.asked.append(request.url))
    shown.goto(path.as_uri())
    yield shown
    assert shown.said == [] and [url for url in shown.asked if not url.startswith("data:image/svg")] == [path.as_uri()]
    context.close()


def copied(page: Any, home: str) -> dict[str, Any]:
    """Point at the first of its kind, press what appears there, and return what is on the clipboard."""
    place = page.locator(home).first
    button = place.locator("> .copy")
    assert button.evaluate("one => getComputedStyle(one).opacity") == "0"
    place.hover()
    button.click()
    page.wait_for_function("(one) => one.textContent.startsWith('✓')", arg=button.element_handle())
    assert button.text_content() == "✓ скопировано"
    page.locator("h1").hover()
    page.evaluate("document.activeElement.blur()")
    return dict(page.evaluate(CLIPBOARD))


def test_formulas_are_copied_as_the_latex_that_the_house_writes(page: Any) -> None:
    assert page.locator(".line > .copy").first.get_attribute("title") == "Копировать: LaTeX"
    assert copied(page, "#equations .line") == {"text/plain": _first_numbered()}
    assert copied(page, "#equations .flow")["text/plain"].split("\n")[:2] == ["V_{Mx}=0", "V_{Dx}=0"]


def _first_numbered() -> str:
    parts = next(one for one in model_of(solved("31"), "ru", live=True).sections if one.name == "equations").parts
    items = [item for part in parts for item in getattr(part, "items", []) if getattr(item, "name", "")]
    return latex(items[0].math)


def test_a_table_is_copied_as_a_spreadsheet_reads_it(page: Any) -> None:
    rows = list(csv.reader(io.StringIO(copied(page, "#results figure.table")["text/plain"]), delimiter="\t"))
    assert len(rows) == 26 and {len(row) for row in rows} == {9}
    assert rows[0][1:3] == ["t с", "φ1 рад"]
    numbers = [[float(cell.replace(",", ".")) for cell in row] for row in rows[1:]]
    assert numbers[0][5] == -1.5755 and [row[0] for row in numbers] == list(range(1, 26))


def test_figures_are_copied_as_svg_and_as_a_picture(page: Any) -> None:
    for home, drawings in (("#mechanism", 1), ("#graphs figure.panels", 7)):
        found = copied(page, home)
        assert found["image/png"] > 10_000
        whole = ElementTree.fromstring(found["text/plain"])
        assert [len(whole), len(whole.findall(f"{SVG}g/{SVG}svg"))] == [drawings, drawings]
        assert whole.get("width") == f"{whole.get('viewBox').split()[2]}mm"
        assert not whole.findall(".//*[@class='screen']")


def test_the_keyboard_stops_once_a_section_and_goes_on_by_arrows(page: Any) -> None:
    assert set(page.evaluate(STOPS)) <= {0, 1}
    page.locator("#equations .copy").first.focus()
    assert page.evaluate("getComputedStyle(document.activeElement).opacity") == "1"
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    assert page.evaluate(CLIPBOARD)["text/plain"].startswith(r"\vec{V}_C=\vec{V}_M")
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowUp")
    assert page.evaluate("document.activeElement === document.querySelector('#equations .copy')")
    assert set(page.evaluate(STOPS)) <= {0, 1}


def test_nothing_of_it_is_printed(page: Any) -> None:
    page.emulate_media(media="print")
    assert page.locator(".copy:visible").count() == 0
    page.emulate_media(media="screen")
