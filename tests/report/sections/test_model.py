"""The model says everything, in order, in finished strings; the templates only place it."""

from __future__ import annotations

import re
from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.report.pages import build_model
from tests.report.made import model_of, solved
from tests.report.own import SHAPER

PAPER = ["results", "graphs", "control", "graph_check"]


def names(run: Any) -> list[str]:
    return [section.name for section in model_of(run).sections]


@pytest.mark.long
def test_sections_in_order_and_only_those_asked_for(real: ModuleType) -> None:
    always = ["statement", "structure", "equations", "solution"]
    assert names(solved("31", quantities=("table",))) == [*always, "results", "method"]
    assert names(solved("31", quantities=("checks", "plots"))) == [*always, "graphs", "control", "conclusion", "checks", "method"]
    assert names(real.full()) == [*always, *PAPER, "conclusion", "checks", "accuracy", "method"]
    everything = solved("31", quantities=real.EVERYTHING)
    assert names(everything) == [*always, *PAPER, "accelerations", "points", "conclusion", "checks", "accuracy", "method"]
    stopped = ["statement", "dead_point", "structure", "equations", "solution", "results", "graphs", "control"]
    assert names(real.stopped())[: len(stopped)] == stopped


@pytest.mark.parametrize(("name", "kind"), [("31", "Kinematic analysis"), ("falling-arm", "Kinematic and dynamic analysis")])
def test_the_head_of_a_page_names_what_is_on_it(name: str, kind: str) -> None:
    assert model_of(solved(name, quantities=["table"])).kind == f"{kind} of a plane mechanism"


@pytest.mark.long
def test_every_section_has_its_number_and_the_appendix_letters(real: ModuleType) -> None:
    for run in (real.full(), real.stopped(), coursework.solve(coursework.parse_variant(SHAPER))):
        numbers = [section.number for section in model_of(run).sections]
        appendix = [f"Appendix {letter}." for letter in "ABC"[: sum("Appendix" in number for number in numbers)]]
        assert appendix and numbers == [*map(str, range(1, len(numbers) - len(appendix) + 1)), *appendix]


def test_what_is_not_asked_for_is_not_computed() -> None:
    bare = coursework.solve("31", quantities=("table",))
    build_model(bare)
    assert not {"exact", "checks", "accuracy"} & set(bare.scene.ledger.calls)


def test_the_model_holds_strings_and_no_numbers(real: ModuleType) -> None:
    """Numbers that remain are sizes in mm and places of rows, never something to print."""
    allowed = {"width", "least", "height", "strong", "rules", "places"}

    def walk(thing: Any, key: str) -> None:
        if isinstance(thing, dict):
            for name, inner in thing.items():
                walk(inner, name)
        elif isinstance(thing, list | tuple):
            for inner in thing:
                walk(inner, key)
        else:
            assert isinstance(thing, str | bool) or key in allowed, (key, thing)

    walk(model_of(real.full()).plain(), "")


def test_a_bend_too_small_to_be_seen_has_no_picture(real: ModuleType) -> None:
    def pictures(name: str) -> list[str]:
        return [part["id"] for part in real.parts(solved(name), "results") if part["kind"] == "figure"]

    assert pictures("variable-crank") == []
    assert pictures("whitworth") == ["tangent"]


def test_round_off_in_the_table_of_a_check_prints_nought(real: ModuleType) -> None:
    def lines(run: Any, code: str) -> dict[str, list[str]]:
        judged = next(
            item
            for part in real.parts(run, "checks")
            if part["kind"] == "checks"
            for item in part["items"]
            if item["code"] == code
        )
        return {real.text_of(row[0]): [real.text_of(cell) for cell in row[1:]] for row in judged["lines"]}

    assert lines(solved("watt"), "PERIOD-POSITION") == {}  # nothing differs
    own = lines(real.full(), "PERIOD-POSITION")["φ3, rad"]
    assert own[2] == "0.04675"
    assert "·10" in own[5]  # the column that tells of round-off keeps it


def test_units_of_tables_beside_the_results_are_in_the_language_of_the_page(real: ModuleType) -> None:
    run = solved("variable-crank-exact")
    units = {
        column["unit"]
        for section in model_of(run, "uk").plain()["sections"] if section["name"] in {"accelerations", "analogs"}
        for part in section["parts"] if part["kind"] == "table" for column in part["columns"]
    }  # fmt: skip
    assert units == {"", "с", "рад", "рад/с²", "м/с²", "1/рад", "м/рад", "м/рад²"}
    told = real.text_of(next(part for part in real.parts(run, "statement") if part["kind"] == "paragraph")["text"])
    assert told.startswith("Task sheet: own synthesis for the example of V. R. Pasika")
    chinese = [
        part["caption"]
        for section in model_of(run, "zh").plain()["sections"]
        for part in section["parts"]
        if part["kind"] == "table"
    ]
    assert all(real.text_of(caption)[-1] != "." for caption in chinese)


@pytest.mark.long
def test_the_control_claims_of_the_geometry_what_it_judges_whole(real: ModuleType) -> None:
    def confirmed(run: Any) -> list[str]:
        claims = (line for part in real.parts(run, "control") if part["kind"] == "claims" for line in part["items"])
        return [real.text_of(line[3]) for line in claims if "what the geometry says" in real.text_of(line[2])]

    assert confirmed(solved("v101")) == confirmed(solved("v104")) == ["4\u00a0equations"]
    text = coursework.load("v102").path.read_text(encoding="utf-8")
    unbound = coursework.parse_variant(text.replace(', of = "C", along = "90 deg"', ""), "v102")
    assert confirmed(coursework.solve(unbound, quantities=("table", "checks"))) == []


def test_the_first_row_stands_beside_the_last(real: ModuleType) -> None:
    """The parts are those of numerics.md 1: scheme and period add up to the difference."""
    tables = [part for part in real.parts(real.full(), "results") if part["kind"] == "table"]
    table = next(part for part in tables if part["id"] == "first-last")
    rows = {real.text_of(row[0]): [real.text_of(cell) for cell in row[1:]] for row in table["rows"]}
    assert list(rows) == [
        "row 1, t = 0\u00a0s", "row 25, t = 0.48\u00a0s", "difference", "due to the scheme", "due to the period",
    ]  # fmt: skip
    assert rows["difference"][:3] == ["−0.08275", "−0.03687", "0.04675"]
    assert rows["due to the period"][:3] == ["0.00058", "0.00026", "−0.00203"]
    told = " ".join(real.text_of(part["text"]) for part in real.parts(real.full(), "results") if part["kind"] == "paragraph")
    assert "Explicit Euler follows the tangent of φ3(t)" in told
    assert "0.48\u00a0s is not the period, 0.480366\u00a0s: that alone is −0.0020 of the 0.0468\u00a0rad in φ3." in told
    assert [part["id"] for part in real.parts(real.full(), "results") if part["kind"] == "figure"] == ["tangent"]


def test_a_sum_of_large_terms_that_is_nought_prints_nought(real: ModuleType) -> None:
    """The slider of the exact synthesis keeps its speed: its acceleration is round-off of terms of 4 m/s²."""
    run = solved("variable-crank-exact")
    for quantity, kept in (("accelerations", 3), ("analogs", 5), ("invariants", 4)):
        (table,) = (part for part in real.parts(run, quantity) if part["kind"] == "table")
        assert {real.text_of(row[-1]) for row in table["rows"]} == {"0"}
        assert real.text_of(table["rows"][1][kept]) != "0"
    raw = run.extra_tables["accelerations"].rows[:, -1]
    assert 0 < abs(raw).max() < 1e-11  # the file of the table keeps what was computed


def test_a_run_that_ends_anywhere_blames_no_period(real: ModuleType) -> None:
    def heads(run: Any) -> list[str]:
        tables = (part for part in real.parts(run, "results") if part.get("id") == "first-last")
        return [real.text_of(row[0]) for table in tables for row in table["rows"]][2:]

    assert heads(solved("variable-crank")) == ["difference"]
    assert heads(solved("variable-crank", scheme="euler")) == ["difference", "due to the scheme", "the motion itself"]


def test_a_datum_called_t_is_not_the_period(real: ModuleType) -> None:
    def told(run: Any) -> str:
        return " ".join(real.text_of(part["text"]) for part in real.parts(run, "statement") if part["kind"] == "paragraph")

    assert "The drive repeats after 1.2\u00a0s." in told(solved("robot-arm"))
    assert "The drive repeats after T = 0.480366\u00a0s." in told(real.full())


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("v101", "is zero where link 3 is at a right angle to the direction β: "),
        ("v104", "is zero where the lever arms of link 3 and link 4 cancel: "),
        ("variable-crank", "is zero where link 2 is vertical: "),
        ("walschaerts", "is zero where link 5 is vertical: "),  # ω5 is its angular velocity
    ],
)
def test_where_a_determinant_vanishes_is_said_of_the_links(real: ModuleType, name: str, sentence: str) -> None:
    shown = [part for part in real.parts(solved(name), "solution") if part["kind"] == "equations"]
    assert sentence in " ".join(real.text_of(item["after"]) for part in shown for item in part["items"])


def test_an_exact_table_says_what_euler_would_have_cost() -> None:
    run = solved("example-1")
    told = " ".join(str(part) for section in model_of(run).sections for part in section.parts if section.name == "results")
    assert "the motion itself" in told


def test_long_tables_are_thinned_and_say_so(real: ModuleType) -> None:
    run = solved("31", step=0.48 / 999, quantities=["table"])
    note, table = real.parts(run, "results")
    assert real.text_of(note["text"]) == (
        "One row in 50 is printed, besides the first, the last and those named in the box on the first page (22 of 1000); "
        "table.csv has them all."
    )
    first = [real.text_of(row[0]) for row in table["rows"]]
    assert first[:4] == ["1", "▸ 4", "51", "101"]
    assert first[-2:] == ["951", "1000"]
    assert table["places"][:4] == [1, 4, 51, 101]


def test_a_row_that_the_box_on_the_first_page_names_is_printed(real: ModuleType) -> None:
    run = solved("31", step=0.48 / 99, quantities=["table", "checks"])
    named = {int(row) for row in re.findall(r"[Rr]ow (\d+)", real.text_of(real.parts(run, "statement")))}
    table = next(part for part in real.parts(run, "results") if "rows" in part)
    assert {4, 78} <= named <= {*table["places"]} and len(table["places"]) < 40


def test_wide_tables_are_split_and_points_stay_whole(real: ModuleType) -> None:
    parts = real.parts(solved("31", quantities=("table", "points", "accelerations")), "points")
    tables = [part for part in parts if part["kind"] == "table"]
    assert len(tables) > 1
    heads = [[real.text_of(column["head"]) for column in table["columns"]] for table in tables]
    assert all(head[:2] == ["row", "t"] for head in heads)
    assert all(len({name[-1] for name in head[2:] if name[0] in "xy"}) * 6 == len(head) - 2 for head in heads)


def test_a_stop_is_told_once_with_rows_counted_as_the_table_counts_them(real: ModuleType) -> None:
    callout, facts = real.parts(real.stopped(), "dead_point")[:2]
    assert callout["lead"] == "Dead point at t = 0.116889\u00a0s. "
    assert "up to row 6" in real.text_of(callout["text"])
    told = {name: real.text_of(value) for name, value in facts["items"]}
    assert told["Place in the table"] == "between row 6 and row 7 of the table"
    assert told["Velocities not found"] == "ω3"
    whole = " ".join(real.text_of(section["parts"]) for section in model_of(real.stopped()).plain()["sections"][:7])
    assert whole.count(told["Cause"]) == 1


def test_a_last_row_that_is_elsewhere_fast_does_not_repeat_the_first(real: ModuleType) -> None:
    """engine-start ends where it began, with the crank five times as fast."""
    box = real.parts(solved("engine-start", quantities=("table", "checks")), "statement")
    assert "The last row repeats the positions of the first, not its velocities." in real.text_of(box)
    whole = real.parts(solved("chebyshev", quantities=("table", "checks")), "statement")
    assert "The last row repeats the first." in real.text_of(whole)


def test_tables_beside_the_results_are_thinned_alike_and_show_no_round_off(real: ModuleType) -> None:
    run = solved("epicyclic", quantities=("table", "points"))
    tables = [part for part in real.parts(run, "points") if "rows" in part]
    assert {len(table["rows"]) for table in tables} == {32}
    assert len(next(part for part in real.parts(run, "results") if "rows" in part)["rows"]) == 32
    assert "10⁻" not in real.text_of(tables), "v_Sy is nought: the slider keeps its height"


def test_a_check_that_finds_nothing_off_lists_no_noughts(real: ModuleType) -> None:
    def lines(run: Any) -> dict[str, int]:
        return {one["code"]: len(one["lines"]) for part in real.parts(run, "checks") for one in part.get("items", [])}

    exact, coarse = lines(solved("jansen", quantities=("table", "checks"))), lines(real.full())
    assert exact["ACCURACY"] == 0
    assert coarse["ACCURACY"] == 7


@pytest.mark.parametrize(("name", "row", "column"), [("v112", 4, "P2E = 378.5, computed"), ("31", 3, "P2B = 187.0, computed")])
def test_what_no_ruler_reaches_is_computed_and_every_difference_has_two_decimals(
    real: ModuleType, name: str, row: int, column: str
) -> None:
    parts = real.parts(solved(name, quantities=["table", "graph_check"]), "graph_check")
    table = next(part for part in parts if part["kind"] == "table")
    assert real.text_of(table["rows"][row][1]) == column
    shown = [text for text in (real.text_of(line[-1]) for line in table["rows"]) if text not in {"", "–"}]
    assert shown and all(re.fullmatch(r"−?\d+\.\d\d( \(±\d+\.\d\d\))?", text) for text in shown)


def test_where_nothing_differs_no_remainder_of_round_off_is_shown(real: ModuleType) -> None:
    section = next(s for s in model_of(solved("cardan")).sections if s.name == "checks")
    items = {item.code: item for part in section.parts if part.kind == "checks" for item in part.items}
    period = items["PERIOD-POSITION"]
    assert "nothing differs" in real.text_of(period.sentence)
    assert (period.heads, period.lines) == ([], [])
    assert real.text_of(items["DRIFT"].value).startswith("0")


@pytest.mark.parametrize(
    ("name", "options", "box", "why"),
    [
        ("example-1", {}, "The last row repeats the first.", "its last row repeats the first."),
        ("31", {"scheme": "exact"}, "Last row minus first row: φ1", "that alone is why the last row is not the first."),
    ],
)
def test_the_box_and_the_reason_agree_on_what_returns(
    real: ModuleType, name: str, options: dict[str, Any], box: str, why: str
) -> None:
    sections = {section.name: section for section in model_of(solved(name, **options)).sections}
    told = {
        key: " ".join(real.text_of(text) for text in texts)
        for key, texts in {
            "box": [item for part in sections["statement"].parts if part.kind == "result" for item in part.items],
            "why": [part.text for part in sections["results"].parts if part.kind == "paragraph"],
        }.items()
    }
    assert box in told["box"] and why in told["why"]
