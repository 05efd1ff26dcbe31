"""What state a student is told, and where the cells of the table are counted."""

from __future__ import annotations

from typing import Any

import pytest

from coursework.grading.pages import feedback
from coursework.words.sentences import load_phrases, say


def shown(monkeypatch: pytest.MonkeyPatch, **final: Any) -> dict[str, Any]:
    monkeypatch.setattr(feedback, "filled", lambda template, **content: content)
    monkeypatch.setattr(feedback, "fitted", lambda made: made)
    monkeypatch.setattr(feedback, "_why", lambda reasons, lettered, words: [])
    whole = {"status": "graded", "notes": [], "reasons": [], "score": 1.0, "max": 2.0} | final
    return feedback.short_page("A. Student", None, whole, load_phrases("en"))  # type: ignore[return-value]


@pytest.mark.parametrize(("status", "told"), [
    ("graded", "Marked."), ("graded-with-notes", "Marked, with notes."),
    ("needs-review", "Your instructor will look at this before it counts."),
])  # fmt: skip
def test_the_page_tells_the_state_that_the_class_list_tells(monkeypatch: pytest.MonkeyPatch, status: str, told: str) -> None:
    """Pages said "Marked." where the list of the class had "marked with notes"."""
    notes = [{"code": "degrees", "text": "one"}]
    assert {shown(monkeypatch, status=status, notes=some)["status"] for some in ([], notes)} == {told}


@pytest.mark.parametrize(("kinds", "counted"), [
    ([], False), (["table rule"], True), (["table state"], False), (["equations rule"], False),
    (["equations rule", "table cell"], False),    (["table cell", "table rule"], True),
])  # fmt: skip
def test_cells_are_counted_once_in_the_reasons_or_above_the_table(
    monkeypatch: pytest.MonkeyPatch, kinds: list[str], counted: bool
) -> None:
    reasons = [{**dict(zip(("part", "kind"), kind.split(), strict=True)), "text": kind} for kind in kinds]
    assert shown(monkeypatch, reasons=reasons)["counted"] is counted


@pytest.mark.parametrize(
    ("count", "begun"), [(0, "0 submissions: "), (1, "1 submission: "), (2, "2 submissions: "), (21, "21 submissions: ")]
)
def test_one_submission_is_no_plural(count: int, begun: str) -> None:
    assert str(say("screen.submissions", count=count, told="x", fresh=count, kept=0)).startswith(begun)
