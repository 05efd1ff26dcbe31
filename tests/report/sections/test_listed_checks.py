"""The list of checks: a number, its limit and the side that passes; what is round-off is told as nought."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.report.sections.checks import counted
from coursework.results.checks.result import Finding
from coursework.words.sentences import say


def listed(real: ModuleType, run: Any) -> dict[str, Any]:
    """Return the checks of a page by their codes."""
    return {one["code"]: one for part in real.parts(run, "checks") for one in part.get("items", [])}


def test_a_limit_says_which_side_of_it_passes(real: ModuleType) -> None:
    items = listed(real, real.full())
    least = {code for code, one in items.items() if real.text_of([one["limit"]]).startswith("≥")}
    most = {code for code, one in items.items() if real.text_of([one["limit"]]).startswith("≤")}
    assert least == {"CONDITION", "AGREEMENT", "SINUSOID", "STEP"}
    assert most == {"INITIAL", "RESIDUAL", "ACCURACY", "PERIOD-POSITION", "PERIOD-VELOCITY", "CONTINUITY", "PEAK", "DRIFT"}


def test_what_is_not_judged_has_no_number_and_no_limit(real: ModuleType) -> None:
    """The wheel of v101 has its rate from its contact; without the link nothing judges equation 2."""
    text = coursework.load("v101").path.read_text(encoding="utf-8")
    without = text.replace('4 = { wheel = "C", contact = "P", rate = "w4" }\n', "")
    assert without != text
    whole, part = (
        listed(real, coursework.solve(coursework.parse_variant(one), quantities=("table", "checks"))) for one in (text, without)
    )
    assert real.text_of([whole["AGREEMENT"]["value"]]) == "4\xa0equations"
    assert part["AGREEMENT"]["mark"] == say("checks.mark.SKIP")
    assert [real.text_of([part["AGREEMENT"][key]]) for key in ("value", "limit")] == ["–", "–"]


def test_a_start_that_closes_to_the_last_digits_is_open_by_round_off(real: ModuleType) -> None:
    """Whitworth's start leaves 3e-18 m beside lengths of 0.35 m."""
    exact = listed(real, coursework.solve("whitworth", quantities=("table", "checks")))
    assert real.text_of([exact["START"]["value"]]) == "3·10−18 (round-off)"


@pytest.mark.parametrize(("share", "told"), [(0.9e-9, "2·10−16 (round-off)"), (1.1e-9, "2.20·10−16\xa0m")])
def test_what_passes_by_far_is_round_off(real: ModuleType, monkeypatch: pytest.MonkeyPatch, share: float, told: str) -> None:
    run, limit = coursework.solve("31", quantities=("table", "checks")), 2e-7
    monkeypatch.setattr(type(run), "checks", (Finding("PASS", "Told.", share * limit, limit, "m", code="START"),))
    assert real.text_of([listed(real, run)["START"]["value"]]) == told


def test_digits_that_are_left_are_never_told_as_more(real: ModuleType) -> None:
    assert real.text_of([listed(real, real.full())["CONDITION"]["value"]]) == "15.2\xa0digits"
    assert counted(5.99, say("unit.digits", number=5.99)) == 5.9
    assert counted(6.04, say("unit.digits", number=6.04)) == 6.0
