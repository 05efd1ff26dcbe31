"""The page of a class counts as one counts by hand."""

from __future__ import annotations

import pytest

from coursework.grading.pages.class_facts import ClassFacts
from coursework.grading.pages.class_page import _tenths
from coursework.words.sentences import load_phrases


@pytest.mark.parametrize(("most", "scores", "counts"), [
    (60.0, [0, 5.9, 6, 29.9, 30, 53.9, 54, 59.9, 60], [2, 1, 0, 0, 1, 1, 0, 0, 1, 3]),
    (100.0, [100, 100, 99, 9.99, 10], [1, 1, 0, 0, 0, 0, 0, 0, 0, 3]), (0.5, [0.05, 0.26], [0, 1, 0, 0, 0, 1, 0, 0, 0, 0]),
    (0.0, [0.0], [1, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
])  # fmt: skip
def test_scores_lie_in_the_tenths_of_the_points(most: float, scores: list[float], counts: list[int]) -> None:
    tenths = _tenths(ClassFacts(most=most, scores=list(scores)), load_phrases("en"))
    assert [count for _, count in tenths] == counts
    if most == 60:
        assert [label for label, _ in tenths][:2] == ["0–6", "6–12"] and tenths[-1][0] == "54–60"
