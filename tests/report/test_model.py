"""The model says everything, in order, in finished strings; the templates only place it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.checks.result import Finding
from coursework.errors import InputError
from coursework.report import build_model, notebook_html
from coursework.report.words import Words, load_words
from coursework.sentences import load_phrases

PAPER = ["results", "graphs", "control", "graph_check"]


def names(run: Any) -> list[str]:
    return [section.name for section in build_model(run).sections]


def test_sections_in_order_and_only_those_asked_for(real: ModuleType) -> None:
    always = ["statement", "equations", "solution"]
    assert names(coursework.solve("31", quantities=("table",))) == [*always, "results", "method"]
    assert names(coursework.solve("31", quantities=("checks", "plots"))) == [*always, "graphs", "control", "checks", "method"]
    assert names(real.full()) == [*always, *PAPER, "checks", "accuracy", "method"]
    everything = coursework.solve("31", quantities=real.EVERYTHING)
    assert names(everything) == [*always, *PAPER, "accelerations", "points", "checks", "accuracy", "method"]
    stopped = ["statement", "dead_point", "equations", "solution", "results", "graphs", "control"]
    assert names(real.stopped())[: len(stopped)] == stopped


def test_the_guide_numbers_three_sections_and_the_appendix_has_letters(real: ModuleType) -> None:
    numbers = {section.name: section.number for section in build_model(real.full()).sections}
    assert numbers == {
        "statement": "1", "equations": "2", "solution": "3", **dict.fromkeys(PAPER, ""), "checks": "Appendix A.",
        "accuracy": "Appendix B.", "method": "Appendix C.",
    }  # fmt: skip


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

    walk(build_model(real.full()).plain(), "")


def test_the_title_block_has_a_line_for_what_is_not_given(real: ModuleType) -> None:
    run = replace(real.full(), teacher="B. B. Ponomarev")
    block = real.parts(run, "statement")[0]
    told = {word: real.text_of(value) for word, value in block["items"]}
    assert told == {
        "Institution": "", "Student": "Olena Kovalchuk", "Group": "MT-21", "Teacher": "B. B. Ponomarev", "Mark": "",
        "Signature": "",
    }  # fmt: skip


def test_the_answer_stands_on_the_first_page(real: ModuleType) -> None:
    beside = next(part for part in real.parts(real.full(), "statement") if part["kind"] == "beside")
    told = " ".join(real.text_of(item) for item in beside["right"]["items"]).replace("\u00a0", " ")
    assert "Row 4, t = 0.06 s: ω1 = 0.21984 rad/s, ω2 = 0.11362 rad/s, ω3 = 4.3916 rad/s, ω4 = −7.9410 rad/s." in told
    assert "φ1 −0.0828 rad, φ2 −0.0369 rad, φ3 0.0468 rad" in told
    assert "Largest error of explicit Euler: 0.152 rad (8.7°) in φ3, row 19." in told
    data = [[real.text_of(cell) for cell in row] for row in beside["left"]["rows"]]
    assert data[0] == ["r1", "DA", "0.953\u00a0m"]
    assert data[-1] == ["φ3", "at t = 0", "2.87\u00a0rad"]


def test_what_a_datum_means_is_said_by_the_file(real: ModuleType) -> None:
    variant = real.changed({'"0.457 m" ': '{ value = "0.457 m", means = "BC; BM = 2r3, CP = r3/2" } '})
    run = coursework.solve(variant, quantities=["table"])
    assert run.motion.t.tolist() == real.full().motion.t.tolist()
    beside = next(part for part in real.parts(run, "statement") if part["kind"] == "beside")
    assert real.text_of(beside["left"]["rows"][2]) == "r3 BC; BM = 2r3, CP = r3/2 0.457\u00a0m"
    assert variant.with_data(given={"r3": 0.5}).given[2].means == "BC; BM = 2r3, CP = r3/2"


def test_lengths_of_the_frame_and_of_a_slide_are_said_by_their_ends(real: ModuleType) -> None:
    def data(name: str) -> dict[str, str]:
        beside = next(part for part in real.parts(coursework.solve(name), "statement") if part["kind"] == "beside")
        return {real.text_of(row[0]): real.text_of(row[1]) for row in beside["left"]["rows"]}

    assert data("whitworth") | {"d": "AD", "s2": "DB, at t = 0, computed", "φ1": "at t = 0"} == data("whitworth")
    assert data("v107")["s"] == "OM, at t = 0"
    assert data("v108")["xO"] == "abscissa of O"


def test_a_datum_called_like_an_article_is_a_symbol_in_formulas_and_a_word_elsewhere(real: ModuleType) -> None:
    def letters(name: str) -> str:
        run = coursework.solve(name)
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
        run = coursework.solve(name)
        return " ".join(real.text_of(part["text"]) for part in real.parts(run, "statement") if part["kind"] == "paragraph")

    assert "Wheel 4 turns about O and does not slip at Q." in told("v112")
    assert "Wheel 4 with centre C rolls at P without slipping." in told("v101")
    assert "Wheel 4 with centre C rolls at P on the fixed circle about O without slipping." in told("v108")


def test_a_computed_datum_is_shown_as_far_as_it_can_be_measured(real: ModuleType) -> None:
    beside = next(part for part in real.parts(coursework.solve("v108"), "statement") if part["kind"] == "beside")
    shown = {real.text_of(row[0]): real.text_of(row[2]) for row in beside["left"]["rows"]}
    assert (shown["xO"], shown["yO"], shown["R0"]) == ("1.65234\u00a0m", "−1.7018\u00a0m", "0.574\u00a0m")


def test_the_nodes_of_a_tabulated_law_have_their_unit(real: ModuleType) -> None:
    shown = real.parts(coursework.solve("variable-crank-table", quantities=["table"]), "statement")
    told = " ".join(real.text_of(part["text"]) for part in shown if part["kind"] == "paragraph")
    assert "51 nodes from 1.33902\u00a0rad to 2.21168\u00a0rad" in told


def test_a_bend_too_small_to_be_seen_has_no_picture(real: ModuleType) -> None:
    def pictures(name: str) -> list[str]:
        return [part["id"] for part in real.parts(coursework.solve(name), "results") if part["kind"] == "figure"]

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

    assert lines(coursework.solve("watt"), "PERIOD-POSITION")["φ1, rad"] == ["0"] * 6
    own = lines(real.full(), "PERIOD-POSITION")["φ3, rad"]
    assert own[2] == "0.04675"
    assert "·10" in own[5]  # the column that tells of round-off keeps it


def test_units_of_tables_beside_the_results_are_in_the_language_of_the_page(real: ModuleType) -> None:
    run = coursework.solve("variable-crank-exact")
    units = {
        column["unit"]
        for section in build_model(run, "uk").plain()["sections"] if section["name"] in {"accelerations", "analogs"}
        for part in section["parts"] if part["kind"] == "table" for column in part["columns"]
    }  # fmt: skip
    assert units == {"", "с", "рад", "рад/с²", "м/с²", "1/рад", "м/рад", "м/рад²"}
    told = real.text_of(next(part for part in real.parts(run, "statement") if part["kind"] == "paragraph")["text"])
    assert told.startswith("Task sheet: own synthesis for the example of V. R. Pasika")
    chinese = [
        part["caption"]
        for section in build_model(run, "zh").plain()["sections"]
        for part in section["parts"]
        if part["kind"] == "table"
    ]
    assert all(real.text_of(caption)[-1] != "." for caption in chinese)


def test_the_control_says_how_many_equations_the_geometry_confirms(real: ModuleType) -> None:
    def confirmed(run: Any) -> str:
        (claims,) = (part for part in real.parts(run, "control") if part["kind"] == "claims")
        return str(next(real.text_of(line[3]) for line in claims["items"] if "what the geometry says" in real.text_of(line[2])))

    assert confirmed(coursework.solve("v101")) == "3 of 4"
    assert confirmed(coursework.solve("v104")) == "4\u00a0equations"


def test_the_first_row_stands_beside_the_last(real: ModuleType) -> None:
    """The parts are those of numerics.md 1: scheme and period add up to the difference."""
    tables = [part for part in real.parts(real.full(), "results") if part["kind"] == "table"]
    table = next(part for part in tables if part["id"] == "first-last")
    rows = {real.text_of(row[0]): [real.text_of(cell) for cell in row[1:]] for row in table["rows"]}
    assert list(rows) == [
        "row 1, t = 0\u00a0s", "row 25, t = 0.48\u00a0s", "difference", "part of the scheme", "part of the period",
    ]  # fmt: skip
    assert rows["difference"][:3] == ["−0.08275", "−0.03687", "0.04675"]
    assert rows["part of the period"][:3] == ["0.00058", "0.00026", "−0.00203"]
    told = " ".join(real.text_of(part["text"]) for part in real.parts(real.full(), "results") if part["kind"] == "paragraph")
    assert "Explicit Euler goes along the tangent of φ3(t)" in told
    assert "0.48\u00a0s is not the period, 0.480366\u00a0s: that alone is −0.0020 of the 0.0468\u00a0rad in φ3." in told
    assert [part["id"] for part in real.parts(real.full(), "results") if part["kind"] == "figure"] == ["tangent"]


def test_a_sum_of_large_terms_that_is_nought_prints_nought(real: ModuleType) -> None:
    """The slider of the exact synthesis keeps its speed: its acceleration is round-off of terms of 4 m/s²."""
    run = coursework.solve("variable-crank-exact")
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

    assert heads(coursework.solve("variable-crank")) == ["difference"]
    assert heads(coursework.solve("variable-crank", scheme="euler")) == ["difference", "part of the scheme", "the motion itself"]


def test_a_datum_called_t_is_not_the_period(real: ModuleType) -> None:
    def told(run: Any) -> str:
        return " ".join(real.text_of(part["text"]) for part in real.parts(run, "statement") if part["kind"] == "paragraph")

    assert "The drive repeats after 1.2\u00a0s." in told(coursework.solve("robot-arm"))
    assert "The drive repeats after T = 0.480366\u00a0s." in told(real.full())


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("v101", "is zero where link 3 stands at a right angle to the direction β: "),
        ("v104", "is zero where the lever arms of link 3 and link 4 cancel: "),
        ("variable-crank", "is zero where link 2 is vertical: "),
        ("walschaerts", "is zero where link 5 is vertical: "),  # ω5 is its angular velocity
    ],
)
def test_where_a_determinant_vanishes_is_said_of_the_links(real: ModuleType, name: str, sentence: str) -> None:
    shown = [part for part in real.parts(coursework.solve(name), "solution") if part["kind"] == "equations"]
    assert sentence in " ".join(real.text_of(item["after"]) for part in shown for item in part["items"])


def test_an_exact_table_says_what_euler_would_have_cost() -> None:
    run = coursework.solve("example-1")
    told = " ".join(str(part) for section in build_model(run).sections for part in section.parts if section.name == "results")
    assert "the motion itself" in told


def test_long_tables_are_thinned_and_say_so(real: ModuleType) -> None:
    run = coursework.solve("31", step=0.48 / 999, quantities=["table"])
    note, table = real.parts(run, "results")
    assert real.text_of(note["text"]) == (
        "One row in 5 is printed, with the first, the last and any marked one (202 of 1000); table.csv holds them all."
    )
    first = [real.text_of(row[0]) for row in table["rows"]]
    assert first[:4] == ["1", "▸ 4", "6", "11"]
    assert first[-2:] == ["996", "1000"]
    assert table["places"][:4] == [1, 4, 6, 11]


def test_wide_tables_are_split_and_points_stay_whole(real: ModuleType) -> None:
    tables = real.parts(coursework.solve("31", quantities=("table", "points", "accelerations")), "points")
    heads = [[real.text_of(column["head"]) for column in table["columns"]] for table in tables]
    assert all(head[:2] == ["row", "t"] for head in heads)
    assert all(len({name[-1] for name in head[2:] if name[0] in "xy"}) * 6 == len(head) - 2 for head in heads)


def test_a_stop_is_told_once_with_rows_counted_as_the_table_counts_them(real: ModuleType) -> None:
    callout, facts = real.parts(real.stopped(), "dead_point")[:2]
    assert callout["lead"] == "Dead point at t = 0.11688925\u00a0s"
    assert "up to row 6" in real.text_of(callout["text"])
    told = {name: real.text_of(value) for name, value in facts["items"]}
    assert told["Place in the table"] == "between row 6 and row 7 of the table"
    assert told["Velocities not found"] == "ω3"
    whole = " ".join(real.text_of(section["parts"]) for section in build_model(real.stopped()).plain()["sections"][:7])
    assert whole.count(told["Cause"]) == 1


def keys(table: Mapping[str, Any], path: str = "") -> set[str]:
    """Return the keys of all sentences in a words file."""
    inner = (keys(v, f"{path}{k}.") if isinstance(v, dict) else {f"{path}{k}"} for k, v in table.items())
    return set().union(*inner)


def judged(real: ModuleType, verdicts: tuple[str, ...], codes: tuple[str, ...] = ("UNKNOWN",)) -> Any:
    """Return variant 31 with a finding of each verdict for each code."""
    findings = tuple(Finding(verdict, "Told.", 1.5, code=code) for code in codes for verdict in verdicts)  # type: ignore[arg-type]
    return Judged(real.full(), findings)


class Judged:
    """A run with other findings."""

    def __init__(self, run: Any, findings: Any) -> None:
        self.run, self.checks = run, findings

    def __getattr__(self, name: str) -> Any:
        return getattr(self.run, name)


def unusual(real: ModuleType) -> list[Any]:
    """Return runs that between them make the report say everything it can say."""
    solve = coursework.solve
    codes = tuple(check.code for check in real.full().checks)
    verdicts = ("PASS", "COARSE", "FAIL", "SKIP", "ERROR")
    extras = ["table", "plots", "checks", "accelerations", "points", "analogs", "invariants"]
    dated = solve("31", date="D", student="S", group="G", quantities=real.EVERYTHING)
    return [
        dated, real.full(), real.stopped(), judged(real, verdicts, codes),
        judged(real, verdicts), judged(real, ("PASS",)), judged(real, ("PASS", "PASS")), solve("v107"),
        solve("v108"), solve("v104"), solve("v112", quantities=["table"]),
        solve("31", project=1), solve("31", project=2), solve("31", gain=5.0), solve("31", scheme="rk4"),
        solve("31", scheme="exact"),
        solve("31", step=0.48 / 999, quantities=["table", "plots"]), solve("31", end=0.02, quantities=["table"]),
        solve("example-2", quantities=extras), solve("variable-crank-table"), solve("variable-crank"), solve("robot-arm"),
        solve("andrews", quantities=["table"]), solve("31", quantities=["checks"]), solve("oscillating-cylinder"),
        solve("jansen", quantities=["table"]), solve("cardan", quantities=["table", "checks"]),
        solve("epicyclic", quantities=["table"]), solve("engine-start", quantities=["checks"]),
        solve("31", quantities=["trajectories", "hodographs", "plans", "points"]),
        real.timed(), *real.oddities(),
    ]  # fmt: skip


def test_every_word_of_a_page_can_be_said(real: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """No key is missing for whatever can be asked, and no sentence is translated for nothing."""
    said: set[str] = set()
    speak = Words.__call__

    def recorded(self: Words, key: str, **values: object) -> str:
        said.add(key)
        return speak(self, key, **values)

    monkeypatch.setattr(Words, "__call__", recorded)
    for run in unusual(real):
        build_model(run, stamp="0123456789abcdef")
        notebook_html(run)
    everything = keys(load_phrases().entries)
    assert sorted(said - everything) == []
    unsaid = sorted(key for key in everything - said if key.partition(".")[0] in PAGE and key not in BELOW)
    assert not unsaid, unsaid


# Said by the rooms that draw, or by their tests: a caption, a file without a frame, a formula too long to print.
BELOW = {
    "graph.alt", "graph.caption", "graph.blank", "graph.close", "graph.fastest", "graph.frame", "derivation.long.one",
    "derivation.long.other",
}  # fmt: skip
# What the page itself says; all else is said by the rooms below it: tests/report/test_language.py.
PAGE = {
    "decimal", "or", "title", "statement", "result", "count", "section", "given", "drive", "constraints", "derivation",
    "table", "first_last", "why", "tangent", "control", "graphs", "stop", "checks", "graph", "accuracy", "method",
    "label",
}  # fmt: skip


def test_an_unknown_language_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match=r'no words for the language "xx" .* There is: en'):
        load_words("xx")


def test_what_counts_is_said_in_the_form_of_its_number(real: ModuleType) -> None:
    cardan = coursework.solve("cardan", quantities=("table", "checks"))
    sections = ("equations", "results", "control", "checks")
    told = " ".join(real.text_of(real.parts(cardan, section)) for section in sections).replace("\u00a0", " ")
    assert "1 equation" in told
    assert "1 equations" not in told
    assert "ψ2 made −1 whole turn, taken off" in told
    assert "1 of φ1; −1 of ψ2" in told
    assert "position equations confirm the signs of (1). Nothing here checks the signs of (2)." in told
    assert "differs most" not in told, "nothing differs"
    assert load_words("ru").count("unit.equations", 3) == "уравнения"


def test_a_last_row_that_is_elsewhere_fast_does_not_repeat_the_first(real: ModuleType) -> None:
    """engine-start ends where it began, with the crank five times as fast."""
    box = real.parts(coursework.solve("engine-start", quantities=("table", "checks")), "statement")
    assert "The last row repeats the positions of the first, not its velocities." in real.text_of(box)
    whole = real.parts(coursework.solve("chebyshev", quantities=("table", "checks")), "statement")
    assert "The last row repeats the first." in real.text_of(whole)


def test_tables_beside_the_results_are_thinned_sooner_and_show_no_round_off(real: ModuleType) -> None:
    run = coursework.solve("epicyclic", quantities=("table", "points"))
    tables = [part for part in real.parts(run, "points") if "rows" in part]
    assert {len(table["rows"]) for table in tables} == {31}
    assert len(next(part for part in real.parts(run, "results") if "rows" in part)["rows"]) == 61
    assert "10⁻" not in real.text_of(tables), "v_Sy is nought: the slider keeps its height"


@pytest.mark.parametrize(("name", "rider"), [("example-5", "D"), ("example-6", "D5"), ("prp", "C"), ("example-2", "C")])
def test_the_slider_moves_on_its_guide_and_not_the_point_the_guide_leads_through(real: ModuleType, name: str, rider: str) -> None:
    run = coursework.solve(name, quantities=("table",))
    assert f"{rider} moves in a straight guide." in real.text_of(real.parts(run, "statement"))


def test_a_check_that_finds_nothing_off_lists_no_noughts(real: ModuleType) -> None:
    def lines(run: Any) -> dict[str, int]:
        return {one["code"]: len(one["lines"]) for part in real.parts(run, "checks") for one in part.get("items", [])}

    exact, coarse = lines(coursework.solve("jansen", quantities=("table", "checks"))), lines(real.full())
    assert exact["ACCURACY"] == 0
    assert coarse["ACCURACY"] == 7


@pytest.mark.parametrize(("name", "row", "column"), [("robot-arm", 0, "P2M = 780.0, computed"), ("31", 3, "P2B = 187.0")])
def test_what_no_ruler_reaches_is_computed_and_every_difference_has_two_decimals(
    real: ModuleType, name: str, row: int, column: str
) -> None:
    parts = real.parts(coursework.solve(name, quantities=["table", "graph_check"]), "graph_check")
    table = next(part for part in parts if part["kind"] == "table")
    assert real.text_of(table["rows"][row][1]) == column
    shown = [text for text in (real.text_of(line[-1]) for line in table["rows"]) if text not in {"", "–"}]
    assert shown and all(re.fullmatch(r"−?\d+\.\d\d( \(±\d+\.\d\d\))?", text) for text in shown)


def test_where_nothing_differs_no_remainder_of_round_off_is_shown(real: ModuleType) -> None:
    section = next(s for s in build_model(coursework.solve("cardan")).sections if s.name == "checks")
    items = {item.code: item for part in section.parts if part.kind == "checks" for item in part.items}
    period = items["PERIOD-POSITION"]
    assert "nothing differs" in real.text_of(period.sentence)
    kept = [cell for row in period.lines for head, cell in zip(period.heads[1:], row[1:], strict=True) if head != "roundoff"]
    assert kept and set(map(real.text_of, kept)) == {"0"}
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
    sections = {section.name: section for section in build_model(coursework.solve(name, **options)).sections}
    told = {
        key: " ".join(real.text_of(text) for text in texts)
        for key, texts in {
            "box": [item for part in sections["statement"].parts if part.kind == "beside" for item in part.right.items],
            "why": [part.text for part in sections["results"].parts if part.kind == "paragraph"],
        }.items()
    }
    assert box in told["box"] and why in told["why"]
