"""A student's cells as shown: decimals below each other, few digits, a true minus; what is no number stays."""

from __future__ import annotations

import pytest

from coursework.grading.pages.shown_cells import shown_column


def test_a_column_of_seventeen_digits_is_as_wide_as_one_of_six() -> None:
    shown = shown_column(["-1.5755372880645735", "16.654150589644065", "0.21983599671975862", "3"], ".")
    assert shown == ["−1.5755", "16.6542", "0.2198", "3\u2008\u2007\u2007\u2007\u2007"]
    assert max(len(text.replace(".", "").lstrip("−")) for text in shown) <= 6


@pytest.mark.parametrize("mark", [".", ","])
def test_decimals_stand_below_each_other_and_have_the_sign_of_the_page(mark: str) -> None:
    shown = shown_column(["0,5", "-10.25", "7", "1,5e-9"], mark)
    assert len({len(text) - (text.find(mark) if mark in text else text.find("\u2008")) for text in shown[:3]}) == 1
    assert (shown[1].rstrip("\u2007"), shown[3]) == (f"−10{mark}25", f"1{mark}5e−9")


def test_what_is_no_number_is_left_and_cut() -> None:
    assert shown_column(["#VALUE!", "", "x" * 40], ".") == ["#VALUE!", "", "x" * 15 + "…"]


@pytest.mark.parametrize(("text", "shown"), [
    ("123456.7", "123457"), ("99999.44", "99999.4"), ("9999999", "9999999"), ("1234567.25", "1.23457e+06"),  # from a million on
    ("0.0010004", "0.00100"), ("0.00099949", "0.00099949"), ("0.000999491", "0.000999491"), ("0.00012345678", "0.000123457"),
    ("-12345.678", "−12345.7"), ("1.5e3", "1500"), ("1.25e-2", "0.0125"), ("2E7", "2E7"), ("0", "0"), ("0.0", "0.0"),
    ("x" * 16, "x" * 16), ("x" * 17, "x" * 15 + "…"),
])  # fmt: skip
def test_a_number_alone_has_six_digits_and_a_power_of_ten_below_a_thousandth_and_from_a_million_on(text: str, shown: str) -> None:
    assert shown_column([text], ".") == [shown]
