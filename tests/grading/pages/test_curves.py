"""The graphs of a student's page: what is wrong is a cross each, said once for all; what is no number is none."""

from __future__ import annotations

import numpy as np

from coursework.grading.pages.curves import panel
from coursework.report.text.symbols import symbol
from coursework.words.sentences import load_phrases

T = 0.02 * np.arange(25)
KEY = np.sin(13 * T)


def drawn(found: np.ndarray, is_wrong: np.ndarray) -> str:
    return panel(symbol("w1"), "rad/s", T, KEY, found, is_wrong, load_phrases())


def test_a_table_that_is_all_wrong_weighs_little_more_than_one_that_is_right() -> None:
    right = drawn(KEY, np.zeros(25, dtype=bool))
    wrong = drawn(KEY + 0.3, np.ones(25, dtype=bool))
    assert "crossed" in wrong and "crossed" not in right
    assert len(wrong) < 1.3 * len(right)


def test_a_missing_number_is_no_cross() -> None:
    found = np.where(np.arange(25) == 3, np.nan, KEY)
    assert "crossed" not in drawn(found, np.isnan(found))
