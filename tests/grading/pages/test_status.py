"""What state a student is told: notes that ask nothing of anybody, or stand among the reasons, are none."""

from __future__ import annotations

import pytest

from coursework.grading.pages import feedback
from coursework.grading.pages.feedback import _status
from coursework.words.sentences import load_phrases

QUIET, LOUD = {"code": "repaired", "text": "one"}, {"code": "ignored_file", "text": "two"}


@pytest.mark.parametrize(("status", "notes", "reasons", "told"), [
    ("graded-with-notes", [], [], "graded"), ("graded-with-notes", [QUIET], [], "graded"),
    ("graded-with-notes", [LOUD], [], "graded_with_notes"), ("graded-with-notes", [QUIET, LOUD], [], "graded_with_notes"),
    ("graded-with-notes", [LOUD], ["two"], "graded"), ("graded-with-notes", [LOUD], ["one"], "graded_with_notes"),
    ("graded", [LOUD], [], "graded"), ("needs-review", [], [], "needs_review"), ("needs-review", [LOUD], ["two"], "needs_review"),
])  # fmt: skip
def test_a_state_as_it_is_told(status: str, notes: list[dict[str, str]], reasons: list[str], told: str) -> None:
    final = {"status": status, "notes": notes, "reasons": [{"text": text} for text in reasons]}
    assert _status(final) == told


@pytest.mark.parametrize(("kinds", "counted"), [
    ([], False), (["table rule"], True), (["table state"], False), (["equations rule"], False),
    (["equations rule", "table cell"], False),    (["table cell", "table rule"], True),
])  # fmt: skip
def test_cells_are_counted_once_in_the_reasons_or_above_the_table(
    monkeypatch: pytest.MonkeyPatch, kinds: list[str], counted: bool
) -> None:
    monkeypatch.setattr(feedback, "filled", lambda template, **content: content)
    monkeypatch.setattr(feedback, "fitted", lambda made: made)
    monkeypatch.setattr(feedback, "_why", lambda reasons, lettered, words: [])
    reasons = [{**dict(zip(("part", "kind"), kind.split(), strict=True)), "text": kind} for kind in kinds]
    final = {"status": "graded", "notes": [], "reasons": reasons, "score": 1.0, "max": 2.0}
    assert feedback.short_page("A. Student", None, final, load_phrases("en"))["counted"] is counted  # type: ignore[index,call-overload]
