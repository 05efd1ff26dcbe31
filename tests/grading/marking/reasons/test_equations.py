"""Of lines in trouble six are told one by one, of all others how many they are."""

from types import SimpleNamespace

import pytest

from coursework.grading.marking.reasons import equations
from coursework.words.sentences import say


@pytest.mark.parametrize(("wrong", "asked", "told"), [(2, 0, 2), (4, 2, 6), (5, 2, 6), (0, 9, 6)])
def test_six_lines_are_told_one_by_one(monkeypatch, wrong, asked, told):
    monkeypatch.setattr(equations, "_line", lambda mark: mark.name)
    lines = [SimpleNamespace(verdict="wrong", lack=None, name=f"wrong {k}") for k in range(wrong)]
    right = SimpleNamespace(verdict="right", lack=None, name="right")
    questions = [SimpleNamespace(name=f"asked {k}") for k in range(asked)]
    found = list(equations.equation_reasons(SimpleNamespace(marks=[right, *lines], questions=questions), None, 40.0))
    named = [one.name for one in (*lines, *questions)][:told]
    more = [say("feedback.more_lines", number=wrong + asked - told)] if wrong + asked > told else []
    assert [one.text for one in found] == [*named, *more]
    assert {(one.part, one.kind) for one in found} == {("equations", "finding")}
