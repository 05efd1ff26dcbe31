"""The control of a table: every check that could be judged stands once, in its group, what failed first."""

from __future__ import annotations

from types import ModuleType

import pytest


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
