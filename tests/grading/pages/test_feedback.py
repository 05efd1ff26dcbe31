"""Measured answers on a student's page: what was found, or that nothing was, with the sign of its verdict."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from coursework.grading.marking.answers import AnswerMark, AnswerMarks
from coursework.grading.pages.feedback import _answers
from coursework.words.sentences import load_phrases


@pytest.mark.parametrize(("found", "verdict", "shown", "sign"), [
    (4.41237, "right", "4.412", "✓"), (0.0, "wrong", "0", "✗"), (-8.1, "half", "-8.1", "½"), (None, "blank", "–", "–"),
    (None, "unreadable", "–", "?"),
])  # fmt: skip
def test_an_answer_is_shown_with_four_digits_and_its_sign(found: float | None, verdict: str, shown: str, sign: str) -> None:
    marks = AnswerMarks((AnswerMark("w3", found, 4.4, 0.05, verdict),))  # type: ignore[arg-type]
    (item,) = _answers(SimpleNamespace(answers=marks), load_phrases("en")) or []  # type: ignore[arg-type]
    assert (item["name"], item["found"].replace("−", "-"), item["sign"]) == ("w3", shown, sign)
    assert _answers(SimpleNamespace(answers=None), load_phrases("en")) is None  # type: ignore[arg-type]
