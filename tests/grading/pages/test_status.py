"""What state a student is told: notes that ask nothing of anybody, or stand among the reasons, are none."""

from __future__ import annotations

import pytest

from coursework.grading.pages.feedback import _status

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
