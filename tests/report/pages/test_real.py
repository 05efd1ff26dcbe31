"""The report of real runs: what the rooms below hand up is what the page shows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework import write_report
from coursework.report.pages import build_model, render_html, render_pdf
from coursework.report.text.parts import Paragraph
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.set_values import with_set
from coursework.words.data_folders import folder

ASKED = ("table", "plots", "checks")


@pytest.fixture(scope="module")
def run() -> Any:
    return coursework.solve("31", quantities=ASKED, student="Olena Kovalchuk", group="MT-21")


def test_the_page_of_variant_31(run: Any, reading: ModuleType, tmp_path: Path) -> None:
    write_report(run, tmp_path / "report.html", tmp_path / "report.pdf")
    page = reading.html_text((tmp_path / "report.html").read_text(encoding="utf-8"))
    paper = reading.pdf_text((tmp_path / "report.pdf").read_bytes())
    assert reading.numbers(page) == reading.numbers(paper)
    # Rows 1 and 25 of reference/variant31.json.
    for row in (
        "1 0.00 1.6300 3.3700 2.8700 −1.5755 −0.71733 5.5518 −16.654",
        "25 0.48 1.5472 3.3331 2.9168 −1.2545 −0.68605 5.3225 −15.124",
    ):
        assert row in page
        assert row in paper
    html = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert 'aria-label="ω₃ = V_My / (r₃ (2 cos φ₃ + sin φ₃))"' in html


def test_only_what_is_asked_for_is_computed() -> None:
    bare = coursework.solve("31", quantities=("table",))
    render_html(build_model(bare))
    assert not {"exact", "checks", "accuracy"} & set(bare.scene.ledger.calls)


def test_everything_that_can_be_asked_for_has_a_page(reading: ModuleType) -> None:
    everything = coursework.solve("31", quantities=(*ASKED, "accelerations", "points", "accuracy"))
    model = build_model(everything)
    names = [section.name for section in model.sections]
    assert names[-5:] == ["points", "conclusion", "checks", "accuracy", "method"]
    assert reading.numbers(reading.html_text(render_html(model))) == reading.numbers(reading.pdf_text(render_pdf(model)))


def test_the_impossible_drive_of_variant_31(reading: ModuleType) -> None:
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8").replace('"4.35 rad"', '"0.02 rad"')
    stopped = coursework.solve(replace(parse_variant(text), ask=ASKED))
    model = build_model(stopped)
    page = reading.html_text(render_html(model))
    assert "Dead point at t = 0.116889 s" in page
    assert "between row 6 and row 7 of the table" in page
    assert "6 0.10 " in page
    assert "7 0.12 " not in page
    assert reading.numbers(page) == reading.numbers(reading.pdf_text(render_pdf(model)))


def test_a_check_row_at_rest_is_not_drawn_and_the_page_says_why() -> None:
    run = coursework.solve(with_set(coursework.load("robot-arm"), (), 1), quantities=["table", "graph_check"])
    assert run.graph_check is not None and all(reading.table == 0 for reading in run.graph_check.readings)
    (section,) = (section for section in build_model(run).sections if section.name == "graph_check")
    (told,) = section.parts
    assert isinstance(told, Paragraph) and "".join(run.get("t", "") for run in told.text).endswith("nothing moves in that row.")


def test_a_motion_that_jumps_between_its_rows_costs_lines_of_the_study_only() -> None:
    text = (folder("variants") / "v104.toml").read_text(encoding="utf-8")
    run = coursework.solve(parse_variant(text.replace('D = "(0, 0)"', 'D = "(0, 1 + abs(t - 0.1)/(t - 0.1))"'), "jumps.toml"))
    assert {row.failed != "" for row in run.accuracy.rows} == {True, False}
