"""The list of checks: a number, its limit and the side that passes; what is round-off is told as nought."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.report.sections.verdict.checks import amount, bound, counted
from coursework.report.text.numbers import TIGHT
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.results.checks.result import Finding
from coursework.words.sentences import say
from tests.solved import solved


def listed(real: ModuleType, run: Any) -> dict[str, Any]:
    """Return the checks of a page by their codes."""
    return {one["code"]: one for part in real.parts(run, "checks") for one in part.get("items", [])}


def test_a_limit_says_which_side_of_it_passes(real: ModuleType) -> None:
    items = listed(real, real.full())
    least = {code for code, one in items.items() if real.text_of([one["limit"]]).startswith("≥")}
    most = {code for code, one in items.items() if real.text_of([one["limit"]]).startswith("≤")}
    assert least == {"CONDITION", "AGREEMENT", "SINUSOID", "STEP"}
    assert most == {"INITIAL", "RESIDUAL", "ACCURACY", "PERIOD-POSITION", "PERIOD-VELOCITY", "CONTINUITY", "PEAK", "DRIFT"}


def test_nought_is_told_in_the_measure_of_its_limit(real: ModuleType) -> None:
    """0 % beside 5 %, and 0 beside 1e-11."""
    items = listed(real, coursework.solve("whitworth", quantities=("table", "checks"), scheme="exact"))
    told = {code: (real.text_of([one["value"]]), real.text_of([one["limit"]])) for code, one in items.items()}
    assert told["INITIAL"][0] == "0" and "10−11" in told["INITIAL"][1]
    assert told["ACCURACY"] == ("0\xa0%", "≤\xa05\xa0%")


def test_what_is_left_of_nought_is_told_alike_beside_the_claim_and_in_the_appendix(real: ModuleType) -> None:
    """It was 1·10⁻¹⁶ (round-off) in one place and 0 in the other."""
    run = coursework.solve("31", quantities=("table", "checks"))
    claims = {real.text_of(row) for part in real.parts(run, "control") for row in part.get("items", part.get("rows", []))}
    for code in ("INITIAL", "RESIDUAL"):
        told = real.text_of([listed(real, run)[code]["value"]])
        assert told.endswith(" (round-off)") and any(told in claim for claim in claims)


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


def test_an_amount_is_told_in_per_cent_or_as_a_power_and_with_a_unit_that_is_short(real: ModuleType) -> None:
    context, share = PageContext(real.full(), load_words("en")), say("unit.of_the_scale")
    assert [amount(context, value, share) for value in (0.0, 6e-4, 0.25)] == ["0\xa0%", "0.1\xa0%", "25.0\xa0%"]
    assert "%" not in amount(context, 4e-4, share)
    assert [amount(context, 2.0, "u" * letters).endswith("u") for letters in (12, 13)] == [True, False]
    assert amount(context, None, "m") == "–"
    assert bound(context, Finding("PASS", "Told.", 9.0, 6.0, say("unit.digits", number=6.0))) == f"≤{TIGHT}6\xa0digits"
    assert bound(context, Finding("PASS", "Told.", 9.0, None, share)) == "–"
    limits = [bound(context, Finding("PASS", "Told.", 0.0, value, share)) for value in (0.05, 6e-4, 4e-4)]
    assert limits[:2] == [f"≤{TIGHT}5\xa0%", f"≤{TIGHT}0.06\xa0%"] and limits[2] == f"≤{TIGHT}4·10⁻⁴"


def test_an_amount_that_is_whole_but_for_the_last_digit_shown_is_whole() -> None:
    rows = say("unit.rows", number=1000)
    assert [counted(value, rows) for value in (1000.04, 999.96, 1000.06)] == [1000.0, 1000.0, 1000.06]


@pytest.mark.parametrize(("language", "noun"), [("en", "digits"), ("ru", "верных цифр"), ("uk", "правильних цифр")])
def test_the_limit_of_digits_has_its_noun(language: str, noun: str) -> None:
    run = solved("31")
    (check,) = [one for one in run.checks if one.code == "CONDITION"]
    assert bound(PageContext(run, load_words(language)), check).replace("\xa0", " ").endswith(f"6 {noun}")


@pytest.mark.parametrize("key", ["unit.of_the_scale", "unit.of_the_shortest", "unit.relative"])
def test_a_share_of_less_than_the_last_digits_of_a_number_is_nought_and_any_other_amount_is_told(key: str) -> None:
    assert [counted(sign * value, say(key)) for sign in (1, -1) for value in (0.9e-12, 1.1e-12)] == [0.0, 1.1e-12, 0.0, -1.1e-12]
    assert [counted(value, unit) for value in (0.9e-12, 0.3) for unit in (say("unit.rows", number=1), "m")] == [
        0.9e-12, 0.9e-12, 0.3, 0.3
    ]  # fmt: skip
