"""A kind of check is one record: a new one stands on the page, in run.json and on the command line by itself."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.results.checks import check as records
from coursework.results.checks.check import CHECKS, check_motion
from coursework.results.checks.evidence import ALIKE, worst
from coursework.results.checks.result import GROUPS, VERDICTS, Check, Finding, Need, floored
from coursework.results.checks.summary import summary
from coursework.words.sentences import say
from tests.results.checks.scenes import evidence_of, finding, solve
from tests.solved import solved

KEYS = ["code", "group", "verdict", "value", "unit", "limit", "column", "row", "sentence"]


@pytest.fixture
def dummy(monkeypatch, tmp_path):
    def judge(evidence):
        return Finding("COARSE", f"{len(evidence.motion.t)} rows of a dummy.", 1.5, 1.0, "m", "phi2", 7, 2.5, 3.5, cured=False)

    monkeypatch.setattr(records, "CHECKS", (*CHECKS, Check("DUMMY", "motion", judge)))
    monkeypatch.chdir(tmp_path)


@pytest.mark.usefixtures("dummy")
def test_a_new_check_is_everywhere():
    told = CliRunner().invoke(main, ["run", "31", "--format", "html,csv"])
    assert told.exit_code == 0, told.output
    assert "≈ COARSE DUMMY            1.5 m (limit 1), phi2, row 7" in told.output
    assert "DUMMY: 25 rows of a dummy." in told.output
    record = json.loads(Path("coursework-31/run.json").read_text(encoding="utf-8"))["checks"][-1]
    assert record == {
        "code": "DUMMY", "group": "motion", "verdict": "COARSE", "value": 1.5, "unit": "m", "limit": 1.0, "column": "phi2",
        "row": 7, "sentence": "25 rows of a dummy.", "first": 2.5, "last": 3.5,
    }  # fmt: skip
    assert list(record)[: len(KEYS)] == KEYS
    page = Path("coursework-31/report.html").read_text(encoding="utf-8")
    assert "DUMMY" in page
    assert "25 rows of a dummy." in page


def test_every_record_has_its_words_and_every_verdict_its_sign():
    from coursework.words.sentences import load_phrases

    words = load_phrases()
    assert all(words.has(f"check.{check.code}.title") for check in CHECKS)
    assert len({words.template(f"checks.mark.{verdict}") for verdict in VERDICTS}) == len(VERDICTS)
    assert all(words.has(f"checks.word.{verdict}") for verdict in VERDICTS)
    assert {check.group for check in CHECKS} == set(GROUPS)
    assert len({check.code for check in CHECKS}) == len(CHECKS)


def test_what_a_check_needs_and_has_not_is_said(monkeypatch):
    run = solve("31")
    lacking = Need(lambda evidence: False, lambda evidence: say("check.no_row"))
    monkeypatch.setattr(records, "CHECKS", (replace(CHECKS[3], needs=(lacking,)),))
    (only,) = check_motion(evidence_of(run))
    assert (only.verdict, only.code) == ("SKIP", "RESIDUAL")
    assert "no row to judge" in only.sentence


def test_the_page_shows_two_groups_and_the_summary_first():
    run = coursework.solve("31", quantities=["table", "checks"])
    plain = build_model(run).plain()["sections"]
    answer = next(part for part in plain[0]["parts"] if part["kind"] == "result")
    assert answer["title"] == "Result"
    assert answer["lead"][0]["t"] == "Computed right from the given start. Not close to the motion: "
    checks = next(section for section in plain if section["name"] == "checks")
    groups = [part for part in checks["parts"] if part["kind"] == "checks"]
    assert [part["title"] for part in groups] == [
        "Was the table computed right?",
        "Is the table close to the motion of the mechanism?",
    ]
    assert [item["code"] for part in groups for item in part["items"]] == [check.code for check in CHECKS]
    marks = {item["verdict"]: item["mark"] for part in groups for item in part["items"]}
    assert marks == {"passed": "✓", "coarse": "≈", "skipped": "–"}
    assert "Was the table computed right?" in render_html(build_model(run))


def judged(code, verdict, **more):
    group = next(check.group for check in CHECKS if check.code == code)
    return Finding(verdict, "A sentence.", code=code, group=group, **more)


SUMMARIES = {
    "all is well": (
        [judged("STOP", "PASS"), judged("ACCURACY", "PASS", value=0.003, column="w6", row=12)],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is close to the motion: largest error 0.3 % (w6, row 12).",
    ),
    "the step is too coarse for something else": (
        [judged("STOP", "PASS"), judged("ACCURACY", "PASS", value=0.0, column="w6", row=1),
         judged("STEP", "COARSE", option="--step h/2"), judged("PEAK", "COARSE", option="--step h/2")],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is close to the motion: no entry is off by more than round-off. "
        "The step is too coarse (see STEP and PEAK); take --step h/2.",
    ),
    "no step helps": (
        [judged("STOP", "PASS"), judged("ACCURACY", "COARSE", value=1.36, column="w7", row=21)],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is not close to the motion: largest error 136.0 % (w7, row 21).",
    ),
    "no geometry": (
        [judged("STOP", "PASS"), judged("AGREEMENT", "SKIP", headline="Signs are not checked: no geometry judges the equations."),
         judged("ACCURACY", "SKIP")],
        "Signs are not checked: no geometry judges the equations. The table is computed right: 1 of 1 checks of the computation. "
        "How close it is to the motion is not known.",
    ),
    "wrong": (
        [judged("STOP", "PASS"), judged("RESIDUAL", "FAIL"), judged("ACCURACY", "FAIL"), judged("PERIOD-POSITION", "FAIL")],
        "The table is not computed right: 1 of 2 checks of the computation pass; see RESIDUAL. A sentence. "
        "Wrong: PERIOD-POSITION.",
    ),
    "the tool itself": (
        [judged("STOP", "PASS"), judged("ACCURACY", "PASS", value=0.01, column="w1", row=2), judged("DRIFT", "ERROR")],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is close to the motion: largest error 1.0 % (w1, row 2). "
        "The tool could not judge DRIFT.",
    ),
    "rounded data": (
        [judged("STOP", "PASS"), judged("TABLE-DIGITS", "COARSE"),
         judged("ACCURACY", "PASS", value=1e-9, column="u", row=2)],
        "The table is computed right, as far as the digits of its data go: 1 of 2 checks of the computation; see TABLE-DIGITS. "
        "It is close to the motion: largest error less than 0.0001 % (u, row 2).",
    ),
}  # fmt: skip


STOPS = judged("STOP", "FAIL", value=0.117)
FOUND = say("check.ACCURACY.found", name="w1", row=5, share="30 %", scale=2.5, unit="rad/s")
SUMMARIES |= {
    "it stops": (
        [STOPS, judged("RESIDUAL", "PASS"), judged("INITIAL", "PASS"), judged("ACCURACY", "SKIP")],
        "The motion stops at t = 0.117 s. The table is computed right up to the stop: 2 of 2 checks of the computation. "
        "How close it is to the motion is not known.",
    ),
    "it never begins": ([STOPS, judged("ACCURACY", "SKIP")], "The motion stops at t = 0.117 s. No row is computed."),
    "it stops and is wrong": (
        [STOPS, judged("RESIDUAL", "FAIL"), judged("ACCURACY", "SKIP")],
        "The motion stops at t = 0.117 s. The table is not computed right: 0 of 2 checks of the computation pass; see RESIDUAL. "
        "How close it is to the motion is not known.",
    ),
    "the step stops it": (
        [judged("STOP", "COARSE", value=0.25), judged("RESIDUAL", "PASS"),
         judged("ACCURACY", "COARSE", value=0.3, column="w1", row=5, option="--scheme rk4")],
        "The rows end at t = 0.25 s, where the mechanism does not: the step is too large. "
        "The table is computed right up to the stop: 1 of 1 checks of the computation. "
        "It is not close to the motion: largest error 30.0 % (w1, row 5); take --scheme rk4.",
    ),
    "its scale is known": (
        [judged("STOP", "PASS"), replace(judged("ACCURACY", "COARSE", value=0.3, column="w1", row=5), sentence=FOUND)],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is not close to the motion: largest error 30.0 % of 2.5 rad/s (w1, row 5).",
    ),
    "its scale stands in a part": (
        [judged("STOP", "PASS"),
         replace(judged("ACCURACY", "PASS", value=0.03, column="w1", row=5), sentence=say("check.ACCURACY.pass", found=FOUND))],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is close to the motion: largest error 3.0 % of 2.5 rad/s (w1, row 5).",
    ),
    "what is coarse is said once": (
        [judged("STOP", "PASS"), judged("ACCURACY", "COARSE", value=0.3, column="w1", row=5), judged("STEP", "COARSE")],
        "The table is computed right: 1 of 1 checks of the computation. "
        "It is not close to the motion: largest error 30.0 % (w1, row 5).",
    ),
}  # fmt: skip


def test_exact_rows_without_an_error_are_the_motion_itself():
    for value, told in (
        (0.0, "The rows are the motion itself."),
        (0.01, "It is close to the motion: largest error 1.0 % (w1, row 2)."),
    ):
        found = [judged("STOP", "PASS"), judged("ACCURACY", "PASS", value=value, column="w1", row=2)]
        assert summary(found, is_motion=True) == f"The table is computed right: 1 of 1 checks of the computation. {told}"


@pytest.mark.parametrize(("share", "told"), [(0.99987, "0.9998"), (0.999999, "0.9999"), (0.9, "0.9"), (1.0, "1")])
def test_a_part_of_a_whole_is_never_told_larger_than_it_is(share, told):
    assert f"{floored(share):.4g}" == told


ALL = ("1", "2", "3", "4")


@pytest.mark.parametrize(
    ("names", "told"),
    [
        (("2",), "3 of 4 equations agree; 2 is not judged: nothing in the geometry gives w4. Write in [unknowns] "),
        (("2", "4"), "2 of 4 equations agree; 2 and 4 are not judged: nothing in the geometry gives w4. Write"),
        (ALL, "Equations 1, 2, 3 and 4 are not judged: nothing in the geometry gives w4. Write"),
    ],
)
def test_equations_that_nothing_judges_are_called_so(names, told):
    run = solve("v101")
    agreed = tuple(name for name in ALL if name not in names)
    unjudged = tuple((name, ("w4",)) for name in names)
    closure = replace(run.results.evidence.closure, agreed=agreed, unjudged=unjudged)
    found = finding("AGREEMENT", evidence_of(run, closure=closure))
    assert (found.verdict, found.value, found.limit) == ("SKIP", None, None)
    assert found.sentence.startswith(told)
    right = replace(found, verdict="PASS", code="RESIDUAL", unjudged="")
    first = "The table is computed right; equation"
    assert summary([right, found]).startswith(first)
    assert "of 1" not in summary([right, found]).split(".")[0]


@pytest.mark.parametrize("name", SUMMARIES)
def test_the_summary(name):
    findings, expected = SUMMARIES[name]
    assert summary(findings) == expected


def test_of_two_bars_that_stay_parallel_every_place_names_the_first():
    """Links 3 and 7 of Peaucellier's rhombus err alike but for round-off, which must not choose the name."""
    sizes = np.array([[0.1, 0.2 * (1 - 0.5 * ALIKE), 0.2], [0.2 * (1 - 2 * ALIKE), 0.0, 0.2]])
    assert worst(sizes) == (0, 1)
    assert worst(np.where(sizes == 0.0, np.nan, sizes)) == (1, 1)
    lesson = coursework.solve("peaucellier", quantities=("table", "checks")).distance_to_exact
    assert lesson is not None
    assert (lesson.column, lesson.row) == ("phi3", 34)


@pytest.mark.parametrize(("name", "options"), [("31", {}), ("31", {"scheme": "rk4"}), ("31", {"step": 0.03}), ("example-6", {})])
def test_a_check_passes_on_the_side_of_its_limit_that_it_names(name, options):
    """Digits, rows and shares of a sine are to be at least so many; errors, gaps and remainders at most."""
    judged = [one for one in solve(name, **options).checks if None not in (one.value, one.limit) and one.verdict in VERDICTS[:3]]
    assert len(judged) > 8
    for one in judged:
        assert (one.verdict == "PASS") == (one.value >= one.limit if one.is_least else one.value <= one.limit), one.code


@pytest.mark.parametrize(("name", "fewest"), [("31", 4), ("falling-arm", 2), ("31-forces", 6)])
def test_the_row_of_a_finding_is_one_that_its_sentence_names(name, fewest):
    """Of what is coarse or wrong; what passes tells no row, or the whole table."""
    open_ones = [one for one in solved(name, scheme="euler").checks if one.row and one.verdict in {"COARSE", "FAIL"}]
    named = [(one, {*map(int, re.findall(r"[Rr]ows? (\d+)", str(one.sentence)))}) for one in open_ones]
    assert sum(bool(rows) for _, rows in named) >= fewest
    assert all(one.row in rows for one, rows in named if rows)
