"""The first page: title block, data with their meanings, the answer."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType, SimpleNamespace

import pytest

import coursework
from coursework.report.sections.statement import _given
from coursework.report.text.numbers import Numbers
from tests.mechanisms.library import mechanism
from tests.report.made import solved
from tests.report.own import SHAPER


def test_the_title_block_has_a_line_for_what_is_not_given(real: ModuleType) -> None:
    run = replace(real.full(), teacher="B. B. Ponomarev")
    block = real.parts(run, "statement")[0]
    told = {word: real.text_of(value) for word, value in block["items"]}
    assert told == {
        "Institution": "", "Student": "Olena Kovalchuk", "Group": "MT-21", "Teacher": "B. B. Ponomarev", "Mark": "",
        "Signature": "",
    }  # fmt: skip


def test_a_run_that_stops_is_praised_up_to_its_stop_only(real: ModuleType) -> None:
    stops = coursework.parse_variant(SHAPER.replace('r1 = "0.10 m"', 'r1 = "0.25 m"'))
    shown = {part["kind"]: part for part in real.parts(coursework.solve(stops), "statement")}
    assert real.text_of(shown["result"]["lead"]).startswith("Computed right up to the stop.")


def test_the_answer_stands_on_the_first_page(real: ModuleType) -> None:
    shown = {part["kind"]: part for part in real.parts(real.full(), "statement")}
    lead = real.text_of(shown["result"]["lead"]).replace("\u00a0", " ")
    assert lead.startswith(
        "Computed right from the given start. Not close to the motion: φ1 is off by 0.14 rad in row 20, 69.8 %"
    )
    assert lead.endswith(" of its scale of 0.20 rad.")
    told = " ".join(real.text_of(item) for item in shown["result"]["items"]).replace("\u00a0", " ")
    assert "Row 4, t = 0.06 s: ω1 = 0.21984 rad/s, ω2 = 0.11362 rad/s, ω3 = 4.3916 rad/s, ω4 = −7.9410 rad/s." in told
    assert "φ1 −0.0828 rad, φ2 −0.0369 rad, φ3 0.0468 rad" in told
    assert "Take h ≈ 0.00111 s, or the scheme Runge-Kutta 4 at the old step (0.005 %)." in told
    assert "argest error" not in told, "the verdict above has it"
    why = real.text_of(next(part for part in real.parts(real.full(), "results") if part["kind"] == "paragraph")).replace(
        "\u00a0", " "
    )
    assert "Largest relative error of explicit Euler: 0.140 rad (8.0°) in φ1, row 20, 69.8 % of its scale." in why
    ending = " ".join(map(real.text_of, real.parts(real.full(), "conclusion"))).replace("\u00a0", " ")
    assert "Largest relative error of explicit Euler: 0.140 rad (8.0°) in φ1, row 20, 69.8 % of its scale" in ending, (
        "one measure, one error"
    )
    data = [[real.text_of(cell) for cell in row] for row in shown["table"]["rows"]]
    assert data[0] == ["r1", "DA", "0.953", "m"]
    assert data[3] == ["V1", "amplitude of VMy", "4.5\u2007\u2007", "m/s"]
    assert data[-1] == ["φ3", "at t = 0", "2.87\u2007", "rad"]


def test_what_a_datum_means_is_said_by_the_file(real: ModuleType) -> None:
    variant = real.changed({'"0.457 m" ': '{ value = "0.457 m", means = "BC; BM = 2r3, CP = r3/2" } '})
    run = coursework.solve(variant, quantities=["table"])
    assert run.motion.t.tolist() == real.full().motion.t.tolist()
    shown = next(part for part in real.parts(run, "statement") if part["kind"] == "table")
    assert real.text_of(shown["rows"][2]) == "r3 BC; BM = 2r3, CP = r3/2 0.457 m"
    assert variant.with_data(given={"r3": 0.5}).given[2].means == "BC; BM = 2r3, CP = r3/2"


def test_a_drive_of_two_letters_is_a_symbol_in_the_meaning_of_a_datum(real: ModuleType) -> None:
    run = coursework.solve(coursework.parse_variant(mechanism("drawn-bar")), quantities=["table"])
    shown = next(part for part in real.parts(run, "statement") if part["kind"] == "table")
    assert any({"v": "V", "s": "x"} in row[1] for row in shown["rows"] if "amplitude" in real.text_of(row[1]))


def test_lengths_of_the_frame_and_of_a_slide_are_said_by_their_ends(real: ModuleType) -> None:
    def data(name: str) -> dict[str, str]:
        shown = next(part for part in real.parts(solved(name), "statement") if part["kind"] == "table")
        return {real.text_of(row[0]): real.text_of(row[1]) for row in shown["rows"]}

    assert data("whitworth") | {"d": "AD", "s2": "DB, at t = 0, computed", "φ1": "at t = 0"} == data("whitworth")
    assert data("v107")["s"] == "OM, at t = 0"
    assert data("v108")["xO"] == "abscissa of O"


@pytest.mark.long
def test_a_datum_called_like_an_article_is_a_symbol_in_formulas_and_a_word_elsewhere(real: ModuleType) -> None:
    def letters(name: str) -> str:
        run = solved(name)
        parts = [*real.parts(run, "statement"), *real.parts(run, "solution")]
        texts = [
            each
            for part in parts
            for each in (part.get("text"), *(one.get("after") for one in part.get("items") or [] if isinstance(one, dict)))
        ]
        return " ".join("".join(f"<{r['v']}>" if "v" in r else r.get("t", "") for r in text) for text in texts if text)

    told = letters("v102")
    assert "<Δ> = <a> sin <φ> + <c> cos <φ>" in told and "D is a fixed pivot" in told
    assert "/(2 <a>) = 0.525 m" in letters("peaucellier") and "C runs on a circle" in letters("peaucellier")


def test_a_gear_on_a_pivot_does_not_roll_along(real: ModuleType) -> None:
    def told(name: str) -> str:
        run = solved(name)
        return " ".join(real.text_of(part["text"]) for part in real.parts(run, "statement") if part["kind"] == "paragraph")

    assert "Wheel 4 turns about O and does not slip at Q." in told("v112")
    assert "Wheel 4 with centre C rolls at P without slipping." in told("v101")
    assert "Wheel 4 with centre C rolls at P on the fixed circle about O without slipping." in told("v108")


def test_a_computed_datum_is_shown_as_far_as_it_can_be_measured(real: ModuleType) -> None:
    data = next(part for part in real.parts(solved("v108"), "statement") if part["kind"] == "table")
    shown = {real.text_of(row[0]): real.text_of(row[2]).strip("\u2007\u2008") for row in data["rows"]}
    assert (shown["xO"], shown["yO"], shown["R0"]) == ("1.65234", "−1.7018", "0.574")
    assert _given(SimpleNamespace(numbers=Numbers(",")), "-1.063E-06") == "−1,063·10⁻⁶"


def test_the_nodes_of_a_tabulated_law_have_their_unit(real: ModuleType) -> None:
    shown = real.parts(solved("variable-crank-table", quantities=["table"]), "statement")
    told = " ".join(real.text_of(part["text"]) for part in shown if part["kind"] == "paragraph")
    assert "51 nodes from 1.33902\u00a0rad to 2.21168\u00a0rad" in told


@pytest.mark.parametrize(("name", "rider"), [("example-5", "D"), ("example-6", "D5"), ("prp", "C"), ("example-2", "C")])
def test_the_slider_moves_on_its_guide_and_not_the_point_the_guide_leads_through(real: ModuleType, name: str, rider: str) -> None:
    run = solved(name, quantities=("table",))
    assert f"{rider} moves in a straight guide." in real.text_of(real.parts(run, "statement"))


@pytest.mark.parametrize(("name", "rail"), [("example-2", '"C", angle = "0"'), ("prp", '"Kj", angle = "pi/2 + gamma"')])
def test_a_guide_that_only_the_group_has_is_told_like_one_of_the_frame(real: ModuleType, name: str, rail: str) -> None:
    """The drawing shows both; the first guide of `prp` turns with its arm, so it is none of the frame."""
    bare = coursework.parse_variant(mechanism(name, (f"[ {{ through = {rail} }} ]", "[]")))
    told = real.text_of(real.parts(coursework.solve(bare), "statement"))
    assert "A is a fixed pivot. C moves in a straight guide." in told


@pytest.mark.parametrize(("name", "told"), [("pendulum", True), ("example-2-motor", False)])
def test_forces_that_act_without_a_motor_are_said_to(real: ModuleType, name: str, told: bool) -> None:
    run = coursework.solve(coursework.parse_variant(mechanism(name)), quantities=["table"], end=0.05)
    assert ("No motor acts." in " ".join(map(real.text_of, real.parts(run, "statement")))) is told
