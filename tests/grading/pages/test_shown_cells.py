"""A student's cells as shown: decimals below each other, few digits, a true minus; what is no number stays."""

from __future__ import annotations

from coursework.grading.pages.shown_cells import DIGITS, shown_column


def test_a_column_of_seventeen_digits_is_as_wide_as_one_of_six() -> None:
    shown = shown_column(["-1.5755372880645735", "16.654150589644065", "0.21983599671975862", "3"])
    assert shown == ["−1.5755", "16.6542", "0.2198", "3\u2008\u2007\u2007\u2007\u2007"]
    assert max(len(text.replace(".", "").lstrip("−")) for text in shown) <= DIGITS + 2


def test_decimals_stand_below_each_other_and_a_comma_stays_one() -> None:
    shown = shown_column(["0,5", "-10,25", "7"])
    assert len({len(text) - (text.find(",") if "," in text else text.find("\u2008")) for text in shown}) == 1
    assert shown[1] == "−10,25"


def test_what_is_no_number_is_left_and_cut() -> None:
    assert shown_column(["#VALUE!", "", "x" * 40]) == ["#VALUE!", "", "x" * 15 + "…"]
