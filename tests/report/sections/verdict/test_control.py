"""The control of a table: every check that could be judged stands once, in its group, what failed first."""

from __future__ import annotations

from types import ModuleType

import pytest

import coursework
from coursework.report.sections.verdict.control import _number
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.results.checks.result import Finding
from coursework.words.sentences import say
from tests.mechanisms.library import mechanism
from tests.report.real import text_of
from tests.solved import solved


@pytest.mark.parametrize("run", ["full", "stopped"])
def test_every_check_that_was_judged_has_one_line_in_its_group(real: ModuleType, run: str) -> None:
    judged = [one for one in getattr(real, run)().checks if one.verdict != "SKIP"]
    groups = [part for part in real.parts(getattr(real, run)(), "control") if part["kind"] == "claims"]
    names = {"computation": "Was the table computed right?", "motion": "Is the table close to the motion of the mechanism?"}
    told = {part["title"]: [word for _, word, *_ in part["items"]] for part in groups}
    marks = {"PASS": "passed", "COARSE": "coarse", "FAIL": "failed"}
    for group, title in names.items():
        verdicts = [one.verdict for one in judged if one.group == group]
        words = told.get(title, [])
        assert sorted(words) == sorted(marks.get(verdict, verdict) for verdict in verdicts)
        assert words == sorted(words, key=lambda word: word == "passed")
    assert [part["strong"] for part in groups] == [sum(word != "passed" for _, word, *_ in part["items"]) for part in groups]


def test_under_forces_the_scales_told_are_those_of_its_checks(real: ModuleType) -> None:
    """Its velocities are judged by their largest value, and neither drift nor period is judged."""
    page = real.text_of(real.parts(solved("falling-arm", quantities=["table", "checks"]), "control"))
    assert "largest value that the velocity has" in page
    assert not [word for word in ("range", "period", "shortest length") if word in page]


@pytest.mark.parametrize(
    ("piece", "sentence"),
    [("wb", "The graphs have no jump."), ("1.1*wb", "The graphs have no jump except in velocities where the drive jumps.")],
)
def test_jumps_of_the_drive_alone_are_told_without_a_column_that_is_off_by_nothing(
    real: ModuleType, piece: str, sentence: str
) -> None:
    text = mechanism("engine-start", ('["0.4 s", "wb"]', f'["0.4 s", "{piece}"]'))
    run = coursework.solve(coursework.parse_variant(text, "own.toml"), quantities=["checks"])
    told = next(one.sentence for one in run.checks if one.code == "CONTINUITY")
    assert told.endswith("from row to row as it does.")
    assert sentence in real.text_of(real.parts(run, "control"))
    assert "not both back" in next(one.sentence for one in run.checks if one.code == "PERIOD-POSITION")


@pytest.mark.parametrize(("value", "limit", "shown"), [
    (0.05004, 0.05, "5.004"), (0.0506, 0.05, "5.1"), (0.05, 0.05, "5.0"), (0.05004, 0.06, "5.0"), (0.05004, None, "5.0"),
])  # fmt: skip
def test_a_share_beside_its_limit_has_digits_enough_to_tell_them_apart(value: float, limit: float | None, shown: str) -> None:
    context = PageContext(solved("31"), load_words("en"))
    cell = _number(context, Finding("FAIL", "Off.", value, limit, say("unit.relative")))
    assert text_of(cell).replace("\u00a0", " ") == f"{shown} %"
