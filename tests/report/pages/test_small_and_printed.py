"""What is easily lost on a small screen or on paper: names of reactions, the words beside the axes, links that lead nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import docx
import pymupdf
import pytest

import coursework
from tests.command import call
from tests.grading.reading.equations.notation.notations import PLAIN
from tests.lent_pages import LentPages
from tests.report.made import model_of, page_of, solved
from tests.report.pages.test_look import SEEN_WORDS, meet
from tests.sample import first

pytestmark = pytest.mark.browser


@pytest.fixture
def page(lent_pages: LentPages) -> Iterator[Any]:
    yield lent_pages.lend()
    lent_pages.take_back()


# What stands beside the names of the axes is a scale, longest in Russian and Ukrainian: μ = 50 (Н)/мм.
@pytest.mark.parametrize("language", first(1, ["ru", "en", "uk", "zh"]))
def test_plans_of_forces_are_read_on_a_phone(language: str, page: Any, tmp_path: Path) -> None:
    page.set_viewport_size({"width": 390, "height": 900})
    file = tmp_path / "page.html"
    file.write_text(page_of(model_of(solved("example-2-forces"), language)), encoding="utf-8")
    page.goto(file.as_uri())
    raised = page.locator("#forces-1 tspan[dx]:visible")
    assert {*raised.all_text_contents()} == {"ᵗ", "ⁿ"}  # else two reactions have one name
    for drawing in ("#forces-1", "#forces-2", "#lever-M"):
        words = page.evaluate(SEEN_WORDS, f"{drawing} svg")
        axes = {"x", "y", next(one[0] for one in words if "0" in one[0] and "=" in one[0])}
        beside = [one for one in words if one[0] in axes]
        assert len(beside) == 3
        assert [(one[0], two[0]) for one, two in combinations(beside, 2) if meet(one, two)] == []


def test_a_link_is_not_printed_and_a_place_stands_instead_of_a_number(page: Any, tmp_path: Path) -> None:
    handed = tmp_path / "handed" / "ada"
    assert call("run", "31", "--format", "csv", "--out", handed).exit_code == 0
    rows = (handed / "table.csv").read_text(encoding="utf-8").splitlines()
    (handed / "table.csv").write_text("\n".join([*rows[:8], rows[8].replace(",", ",9", 4), *rows[9:]]), encoding="utf-8")
    work = docx.Document()
    for line in PLAIN["31"].splitlines():
        work.add_paragraph(line)
    work.save(str(handed / "work.docx"))
    assert call("grade", tmp_path / "handed", "--variant", "31", "--out", tmp_path / "marks", "--jobs", "0").exit_code == 0
    page.goto((tmp_path / "marks/feedback/ada.html").as_uri())
    link = page.locator("a[href='#first']")
    assert link.is_visible()
    listed = "[...document.querySelectorAll('.equations li')].map((one) => [one.value, getComputedStyle(one).listStyleType])"
    assert {style for _, style in page.evaluate(listed)} == {"none"}  # "paragraph 2" beside the number of another count
    page.emulate_media(media="print")
    assert not link.is_visible()


def test_what_is_drawn_to_scale_keeps_it_on_the_paper_that_a_printer_has(page: Any, tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text(page_of(model_of(solved("31"), "en")), encoding="utf-8")
    page.goto(file.as_uri())
    for paper, width in (("A4", 842), ("Letter", 792)):
        with pymupdf.open(stream=page.pdf(format=paper, prefer_css_page_size=True), filetype="pdf") as printed:
            drawn = [(sheet, path) for sheet in printed for path in sheet.get_drawings()]
            bars = [(sheet.rect.width, path["rect"]) for sheet, path in drawn if path["color"] and 0 < sum(path["color"]) < 0.02]
        ((wide, bar),) = bars
        assert bar.width == pytest.approx(100 * 72 / 25.4, abs=0.3)
        assert wide == pytest.approx(width, abs=1)  # turned


def test_a_micrometre_of_the_laboratory_is_written_as_on_paper(page: Any, tmp_path: Path) -> None:
    small = coursework.load("31").with_data({"r1": 0.953e-6, "r2": 0.847e-6, "r3": 0.457e-6, "V1": 4.5e-6})
    file = tmp_path / "page.html"
    file.write_text(page_of(model_of(coursework.solve(small), live=True)), encoding="utf-8")
    page.set_viewport_size({"width": 1400, "height": 900})
    page.goto(file.as_uri())
    value = page.locator("#lab-value")
    assert value.text_content() == "9.53·10⁻⁷ m"
    assert value.evaluate("(one) => one.getClientRects().length") == 1  # it stood on two lines
