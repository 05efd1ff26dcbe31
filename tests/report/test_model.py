"""The model says everything, in order, in finished strings; the templates only place it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.errors import InputError
from coursework.formula.reader import parse
from coursework.integration.motion import Motion, Stop
from coursework.report import build_model, notebook_html
from coursework.report.words import Words, load_words
from coursework.sentences import load_phrases
from coursework.variant.record import Law

GOLDEN = Path(__file__).parent / "model31.json"
EXTRAS = ("points", "accelerations", "analogs", "invariants")
ALL = ("table", "plots", "checks", "graph_check", *EXTRAS, "accuracy")
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="170mm" height="110mm" viewBox="0 0 170 110"></svg>'


def parts(run: Any, section: str) -> list[dict[str, Any]]:
    """Return the parts of a section as plain dicts."""
    found = [s for s in build_model(run).plain()["sections"] if s["name"] == section]
    assert found, f"no section {section}"
    return list(found[0]["parts"])


def text_of(thing: Any) -> str:
    """Return all text inside a part, runs joined."""
    if isinstance(thing, str):
        return thing
    if isinstance(thing, dict):
        keys = ("t", "v", "s", "p") if set(thing) <= {"t", "v", "s", "p"} else thing
        return "".join(text_of(thing.get(key, "")) for key in keys)
    return " ".join(text_of(x) for x in thing) if isinstance(thing, list | tuple) and not is_runs(thing) else (
        "".join(text_of(x) for x in thing) if isinstance(thing, list | tuple) else ""
    )  # fmt: skip


def is_runs(thing: Any) -> bool:
    return bool(thing) and all(isinstance(x, dict) and set(x) <= {"t", "v", "s", "p"} for x in thing)


def test_the_golden_model(stand_in: ModuleType) -> None:
    """Everything the page of variant 31 says.  After a wanted change: UPDATE_GOLDEN=1 pytest tests/report, and read the diff."""
    run = stand_in.run(student="Olena Kovalchuk", group="MT-21", date="20 November 2026")
    found = build_model(run).plain()
    for section in found["sections"]:
        for part in section["parts"]:
            part.pop("svg", None)
    text = json.dumps(found, indent=1, ensure_ascii=False) + "\n"
    if os.environ.get("UPDATE_GOLDEN"):
        GOLDEN.write_text(text, encoding="utf-8")
    assert text == GOLDEN.read_text(encoding="utf-8")


def test_sections_in_order_and_only_those_asked_for(stand_in: ModuleType) -> None:
    def names(**changes: Any) -> list[str]:
        return [section.name for section in build_model(stand_in.run(**changes)).sections]

    always = ["title", "remarks", "given", "drive", "constraints", "derivation"]
    assert names(asked=("table",)) == [*always, "table", "method"]
    assert names(asked=("checks", "plots")) == [*always, "plots", "checks", "method"]
    extras = {"points": stand_in.ExtraTable("Points", ("t", "A.x"), ("s", "m"), np.ones((25, 2)))}
    everything = names(asked=ALL, extra_tables=extras, accuracy=stand_in.study(), graph=stand_in.Graph(SVG))
    assert everything == [*always, "table", "plots", "checks", "graph_check", "points", "accuracy", "method"]
    stopped = [section.name for section in build_model(stand_in.stopped()).sections]
    assert stopped == [*always, "table", "plots", "dead_point", "checks", "method"]


def test_what_is_not_asked_for_is_not_looked_at(stand_in: ModuleType) -> None:
    class Shy:
        def __init__(self, run: Any) -> None:
            self.run = run

        def __getattr__(self, name: str) -> Any:
            assert name not in {"exact", "checks", "accuracy", "graph"}, f"{name} was not asked for"
            return getattr(self.run, name)

    build_model(Shy(stand_in.run(asked=("table",))))  # type: ignore[arg-type]


def test_the_model_holds_strings_and_no_numbers(stand_in: ModuleType) -> None:
    """Numbers that remain are sizes in mm and places of rows, never something to print."""
    allowed = {"width", "height", "strong", "rules"}

    def walk(thing: Any, key: str) -> None:
        if isinstance(thing, dict):
            for name, inner in thing.items():
                walk(inner, name)
        elif isinstance(thing, list | tuple):
            for inner in thing:
                walk(inner, key)
        else:
            assert isinstance(thing, str | bool) or key in allowed, (key, thing)

    walk(build_model(stand_in.run(asked=ALL, accuracy=stand_in.study(), graph=stand_in.Graph(SVG))).plain(), "")


def test_long_tables_are_thinned_and_say_so(stand_in: ModuleType) -> None:
    note, table = parts(stand_in.run(motion=stand_in.euler(999), exact=None), "table")
    assert text_of(note["text"]) == (
        "One row in 5 is printed, with the first, the last and any marked one (202 of 1000); table.csv holds them all."
    )
    first = [text_of(row[0]) for row in table["rows"]]
    assert first[:4] == ["1", "▸ 4", "6", "11"]
    assert first[-2:] == ["996", "1000"]
    assert [text_of(row[0]) for i, row in enumerate(table["rows"]) if i in table["strong"]] == ["▸ 4"]


def test_wide_tables_are_split_and_points_stay_whole(stand_in: ModuleType) -> None:
    names = ("t", *(f"{point}.{part}" for point in "ABC" for part in ("x", "y", "vx", "vy")))
    extra = stand_in.ExtraTable("Points", names, ("s",) + ("m",) * 12, np.ones((25, 13)))
    tables = parts(stand_in.run(asked=("points",), extra_tables={"points": extra}), "points")
    heads = [[text_of(column["head"]) for column in table["columns"]] for table in tables]
    assert heads == [
        ["row", "t", "xA", "yA", "vAx", "vAy"], ["row", "t", "xB", "yB", "vBx", "vBy"], ["row", "t", "xC", "yC", "vCx", "vCy"],
    ]  # fmt: skip
    assert text_of(tables[1]["caption"]) == "Points. Part 2 of 3."


def test_a_stop_is_told_with_rows_counted_as_the_table_counts_them(stand_in: ModuleType) -> None:
    callout, facts = parts(stand_in.stopped(), "dead_point")
    assert callout["lead"] == "Dead point at t = 0.11688925\u00a0s"
    assert "up to row 6" in text_of(callout["text"])
    told = {name: text_of(value) for name, value in facts["items"]}
    assert told["Place in the table"] == "between row 6 and row 7 of the table"
    assert told["Velocities not found"] == "ω3"
    assert told["Cause"] == "r3 (2 cos φ3 + sin φ3) becomes zero."
    assert text_of(parts(stand_in.stopped(), "title")[0]["items"]).count("stops at t = 0.11688925\u00a0s") == 1


def test_a_stop_at_the_first_row_with_branches(stand_in: ModuleType) -> None:
    bare = np.zeros((0, 3))
    nothing = Motion(
        np.zeros(0), bare, np.zeros((0, 4)), bare.copy(), bare.copy(), stand_in.COORDINATES, stand_in.VELOCITIES, "euler", 0.02, 0
    )
    stop = Stop("change point", 0.0, 0.0, ("w1",), {}, "Two motions meet.", "", ({"w1": 1.0}, {"w1": -0.5}))
    run = stand_in.run(motion=nothing, exact=nothing, stop=stop)
    told = [text_of(item) for item in parts(run, "dead_point")[1]["items"]]
    assert told[0] == "Place in the table at row 1 of the table"
    assert told[-3:-1] == ["Possible there ω1 = 1\u00a0rad/s", "Possible there ω1 = −0.5\u00a0rad/s"]
    assert "plots" not in [section.name for section in build_model(run).sections]


def test_redundant_and_derived_equations_say_so(stand_in: ModuleType) -> None:
    equations = (replace(stand_in.EQUATIONS[0], used=False), replace(stand_in.EQUATIONS[1], derived=True, because=""))
    shown = parts(stand_in.run(equations=equations), "constraints")[1]["items"]
    assert text_of(shown[0]["after"]) == "not needed to find the velocities; kept as a check"
    assert text_of(shown[1]["before"]) == "(differentiated from the positions)"


def test_a_large_block_is_told_in_words(stand_in: ModuleType) -> None:
    block = stand_in.Block(("w1", "w2", "w3"), ("1", "2", "3"), (), None, "the determinant of the 3 equations 1, 2, 3 is zero")
    told = text_of(parts(stand_in.run(reduction=stand_in.Reduction((block,))), "derivation")[1]["text"])
    assert told.startswith("The 3 velocities ω1, ω2 and ω3 follow together from equations (1), (2) and (3)")


def test_check_lines_become_a_small_table(stand_in: ModuleType) -> None:
    period = parts(stand_in.run(), "checks")[2]["items"][0]
    assert period["heads"] == ["", "scheme error", "T ≠ period", "round-off"]
    assert [text_of(cell) for cell in period["lines"][0]] == ["φ1, rad", "−0.08333", "5.79·10−4", "1.00·10−16"]


def test_the_accuracy_section(stand_in: ModuleType) -> None:
    told = parts(stand_in.run(asked=("accuracy",), accuracy=stand_in.study()), "accuracy")
    words = " ".join(text_of(part) for part in told)
    for expected in (
        "understate", "The ring is the step of this coursework", "Did not finish:", "Newton did not come to rest at row 2",
        "Measured orders: Euler 0.98, Heun 2.04, RK4 3.99.", "▸ Euler", "running time", "35.0\u00a0µs", "importing",
    ):  # fmt: skip
        assert expected in words, expected
    quiet = " ".join(
        text_of(part) for part in parts(stand_in.run(asked=("accuracy",), accuracy=stand_in.study(False)), "accuracy")
    )
    assert "µs" not in quiet.replace("35 µs", "")
    assert "importing" not in quiet


def drawn(stand_in: ModuleType) -> Any:
    return stand_in.Graph(SVG, (("w1", 1.2, 1.21, 0.01, "rad/s"),), (("w1", 1.2, 0.01, "rad/s"),), ("A note.",))


def unusual(stand_in: ModuleType) -> list[Any]:
    """Return runs that between them make the report say everything it can say."""
    wide = Variety(stand_in)
    return [
        stand_in.run(asked=ALL, accuracy=stand_in.study(), graph=drawn(stand_in),
                     student="S", group="G", date="D", extra_tables=wide.extras),
        stand_in.run(asked=ALL, accuracy=stand_in.study(False), checks=wide.many(3), settings=stand_in.Settings(1, 0.0)),
        stand_in.run(checks=wide.many(1), settings=stand_in.Settings(2, 0.0), exact=replace(stand_in.exact(), label="")),
        stand_in.run(checks=wide.each(1), settings=stand_in.Settings(0, 5.0), motion=stand_in.euler(0), exact=None),
        stand_in.run(checks=wide.each(2), motion=stand_in.euler(999), exact=None, scheme="unknown"),
        wide.of_lengths(), wide.of_groups(), stand_in.run(partials={"r3": ("r", "phi1")}),
        stand_in.run(reduction=wide.large), stand_in.run(equations=wide.equations),
        stand_in.stopped(), replace(stand_in.stopped(), phases="1.59 < alpha < 4.69"), wide.at_a_row(),
        coursework.solve("example-1", quantities=["table", "plots"]),
    ]  # fmt: skip


class Variety:
    """Unusual pieces of a run."""

    def __init__(self, stand_in: ModuleType) -> None:
        self.made = stand_in
        names = tuple(f"{point}.{part}" for point in "ABC" for part in ("x", "y", "vx", "vy"))
        self.extras = {
            name: stand_in.ExtraTable(f"All {name}", ("t", *names), ("s",) + ("m",) * 12, np.ones((25, 13))) for name in EXTRAS
        }
        block = stand_in.Block(("w1", "w2", "w3"), ("1", "2", "3"), (), None, "the determinant is zero")
        small = stand_in.Block(("w4",), ("4",), (("w4", parse("2*w3")),), parse("r3"), "")
        first = stand_in.Block(("w1", "w2"), ("4", "5"), (("w1", parse("2")), ("w2", parse("3"))), parse("r3"), "r3 is zero")
        self.large = stand_in.Reduction((block, small))
        self.equations = (
            replace(stand_in.EQUATIONS[0], used=False, derived=True), *stand_in.EQUATIONS[1:],
        )  # fmt: skip
        self.alone = stand_in.Reduction((first,))

    def many(self, count: int) -> Any:
        return self.made.CHECKS[:1] * count

    def each(self, count: int) -> Any:
        return tuple(check for check in self.made.CHECKS for _ in range(count))

    def of_lengths(self) -> Any:
        coordinates = tuple(
            replace(c, unit=unit) for c, unit in zip(self.made.variant().coordinates, ("m", "m", "A"), strict=True)
        )
        laws = (
            Law("r", parse("0.1277 - 0.0255*phi1")), Law("s", table=((0.0, 1.0), (1.0, 2.0)), of="phi1", method="five-point"),
            Law("u", table=((0.0, 1.0), (1.0, 2.0)), of="phi1", method="spline"),
        )  # fmt: skip
        return self.made.run(
            variant=self.made.variant(coordinates=coordinates, functions=laws),
            reduction=self.alone,
            asked=ALL,
            accuracy=self.made.study(),
        )

    def of_groups(self) -> Any:
        drive = (Law("w1", pieces=((0.0, parse("10")), (0.2, parse("12")))),)
        variant = self.made.variant(driven=None, drive=drive, given=())
        near = {variant.coordinates[0].name: 1.6}  # other data have moved this start; the chain gives the others
        coordinates = tuple(replace(c, start=None, near=near.get(c.name)) for c in variant.coordinates)
        other = replace(variant, coordinates=coordinates, drive=())
        assert build_model(self.made.run(variant=variant))
        motion = replace(self.made.euler(), coordinate_names=("phi1", "phi2", "other"))
        return self.made.run(variant=other, motion=motion, exact=None, asked=("table",))

    def at_a_row(self) -> Any:
        stop = Stop("change point", 0.1, 5.0, ("w1",), {"phi1": 1.0}, "Two motions meet.", "Choose.", ({"w1": 1.0}, {"w1": 2.0}))
        return self.made.run(motion=self.made.euler(5), exact=None, stop=stop)


def keys(table: Mapping[str, Any], path: str = "") -> set[str]:
    """Return the keys of all sentences in a words file."""
    inner = (keys(v, f"{path}{k}.") if isinstance(v, dict) else {f"{path}{k}"} for k, v in table.items())
    return set().union(*inner)


def test_every_word_of_a_page_can_be_said(stand_in: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """No key is missing for whatever can be asked, and no sentence is translated for nothing."""
    said: set[str] = set()
    speak = Words.__call__

    def recorded(self: Words, key: str, **values: object) -> str:
        said.add(key)
        return speak(self, key, **values)

    monkeypatch.setattr(Words, "__call__", recorded)
    for run in unusual(stand_in):
        build_model(run, stamp="0123456789abcdef")
        notebook_html(run)
    everything = keys(load_phrases().entries)
    assert sorted(said - everything) == []
    assert sorted(key for key in everything - said if key.partition(".")[0] not in FINDINGS) == []


# Sections of the words file that the rooms below the report speak: tests/report/test_language.py.
FINDINGS = {
    "join", "amount", "unit", "check", "event", "phase", "determinant", "equation", "exact", "scheme", "study", "drawing",
    "extra", "reading", "remark", "advice", "summary", "ended", "gate",
    "platform", "marking", "feedback", "grading", "class", "fault",
}  # fmt: skip


def test_an_unknown_language_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match=r'no words for the language "xx" .* There is: en'):
        load_words("xx")
