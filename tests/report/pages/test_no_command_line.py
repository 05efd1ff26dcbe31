"""A page is read where nobody types: no option of the command line, no name that only the tool has; the terminal keeps both."""

from __future__ import annotations

import re
from functools import cache

import pytest

import coursework
from coursework.scene.scene_run import SceneRun
from tests.report.made import model_of, page_of, paper_of, solved
from tests.report.own import SHAPER
from tests.report.reading import html_text, pdf_text

TYPED = re.compile(r"[−-]{2}[a-z]|\bh/\d|\brk4\b|\bG\d[xy]\b|\bG\d\b")


@cache
def coarse() -> SceneRun:
    return coursework.solve(coursework.parse_variant(SHAPER), scheme="euler", quantities=("table", "plots", "checks", "accuracy"))


@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_a_page_and_a_paper_hold_nothing_that_is_typed(language: str) -> None:
    for run in (coarse(), solved("31")) if language == "en" else (coarse(),):
        model = model_of(run, language)
        for text in (html_text(page_of(model).partition("</style>")[2]), pdf_text(paper_of(model))):
            assert not TYPED.findall(text)
            assert "0.00111" in text.replace(",", ".") or run.variant.name != "31"


def test_the_summary_of_the_terminal_and_of_run_json_keeps_the_option() -> None:
    run = coarse()
    assert "take --step h/" in run.summary
    assert any("Take --step h/" in finding.sentence and finding.option.startswith("--step h/") for finding in run.checks)


def test_a_scheme_that_would_do_is_named_by_its_title() -> None:
    """Where no step is found within the rows that are computed, the scheme alone is advised."""
    run = solved("31")
    text = html_text(page_of(model_of(run)))
    assert "or the scheme Runge−Kutta 4 at the old step" in text


def test_equations_of_a_chain_are_numbered_from_one() -> None:
    model = model_of(coarse())
    (section,) = (section for section in model.sections if section.name == "equations")
    names = [item.name for part in section.parts if part.kind == "equations" for item in part.items if item.name]
    assert names == ["1", "2", "3", "4"]
    text = html_text(page_of(model))
    assert "(1) and (2) are solved together for ω3 and u" in text and "From (4), with ω3 from above" in text
    assert "that of equation (" in text


def test_equations_that_the_source_numbers_keep_their_numbers() -> None:
    model = model_of(solved("31"))
    (section,) = (section for section in model.sections if section.name == "equations")
    names = [item.name for part in section.parts if part.kind == "equations" for item in part.items if item.name]
    assert names[-4:] == ["11", "12", "16", "18"]
