"""Numbers carry the digits they deserve; none is rounded to a false zero."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.report.sections.remarks import _plausibility
from coursework.report.text.numbers import Numbers, first_of, said_step, shown_column, unit_text, with_unit
from coursework.report.text.words import load_words
from coursework.variant.record.entries import Remark

N = Numbers()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (-0.0, "0"), (0.0833, "0.08330"), (12.3, "12.30"), (-16.654151, "−16.65"), (1.3e-15, "1.30·10⁻¹⁵"),
        (9.9999e-4, "1.00·10⁻³"), (0.001, "0.001000"), (99999.6, "100000"), (1e5, "1.00·10⁵"), (-2.5e7, "−2.50·10⁷"),
        (math.inf, "∞"), (-math.inf, "−∞"), (math.nan, "–"), (None, "–"), (9.99996, "10.00"),
    ],
)  # fmt: skip
def test_a_number_on_its_own(value: float | None, text: str) -> None:
    assert N.scalar(value) == text


def test_a_column_has_one_number_of_decimals_and_no_false_zero() -> None:
    assert N.column([1.63, 1.5985, -0.00001234, 0.0]) == ["1.6300", "1.5985", "−1.23·10⁻⁵", "0.0000"]
    assert N.column([-16.654151, 0.511]) == ["−16.654", "0.511"]
    assert N.column([0.0, 0.0]) == ["0", "0"]
    assert N.column([]) == []
    assert N.column([123456.7, 1.0]) == ["123457", "1"]
    assert N.column([math.nan, 1.0]) == ["–", "1.0000"]


def test_a_column_too_small_for_decimals_has_three_digits_each() -> None:
    assert N.column([1.3e-4, -4e-5, 0.0]) == ["0.00013000", "−0.00004000", "0.00000000"]
    assert N.column([9.2e-5, -4e-6, 0.0]) == ["9.20·10⁻⁵", "−4.00·10⁻⁶", "0"]


def test_a_step_is_said_as_it_is_if_it_ends_and_else_with_four_digits() -> None:
    assert [said_step(step) for step in (0.02, 0.0125, 0.123456, 1 / 60, math.pi / 180)] == [
        0.02, 0.0125, 0.123456, 0.01667, 0.01745,
    ]  # fmt: skip


def test_times_show_just_the_decimals_they_need() -> None:
    assert N.times([0.0, 0.02, 0.48]) == ["0.00", "0.02", "0.48"]
    assert N.times([i * 0.1 for i in range(4)]) == ["0.0", "0.1", "0.2", "0.3"]
    assert N.times([0.0, 1.0]) == ["0", "1"]
    assert N.times([1 / 3]) == ["0.33333333"]
    assert N.times([k / 120 for k in range(3)]) == ["0.000000", "0.008333", "0.016667"]  # three beyond the step's first digit
    assert N.times([1.0, 1.0 + 1 / 120]) == ["1.000000", "1.008333"]
    assert N.times([0.0, 2000.75, 4001.5]) == ["0", "2001", "4002"] and N.times([0.0, 200.75]) == ["0.0", "200.8"]
    assert N.times([0.0, 20000.7]) == ["0", "20001"]
    assert N.times([0.0, 0.0125, 0.025]) == ["0.0000", "0.0125", "0.0250"]


def test_data_limits_counts_and_durations() -> None:
    assert N.plain(0.953) == "0.953"
    assert [N.plain(value) for value in (0.0, -0.0, math.nan, math.inf, 9.9e-4)] == ["0", "0", "–", "∞", "9.90·10⁻⁴"]
    assert [N.dressed(text) for text in ("-0.5", "1.5e-07", "-2e+12")] == ["−0.5", "1.5·10⁻⁷", "−2·10¹²"]
    assert N.plain(math.pi / 6) == "0.523599"
    assert N.plain(0.11688925461, 8) == "0.11688925"
    assert N.limit(0.1) == "0.1"
    assert N.limit(1e-12) == "1·10⁻¹²"
    assert N.limit(100.0) == "100"
    assert N.limit(None) == "–"
    assert N.whole(6144) == "6144"
    assert N.whole(410000) == "410\u202f000"
    assert N.duration(35e-6) == "35.0\u00a0µs"
    assert N.duration(0.0081) == "8.10\u00a0ms"
    assert N.duration(2.0) == "2.00\u00a0s"


def test_another_language_has_another_decimal_sign() -> None:
    comma = Numbers(",")
    assert comma.scalar(-0.5) == "−0,5000"
    assert comma.limit(0.5) == "0,5"
    assert comma.column([1.5]) == ["1,5000"]


def test_units() -> None:
    assert with_unit("4.5", "m/s^2") == "4.5\u00a0m/s²"
    assert with_unit("30", "deg") == "30°"
    assert with_unit("5", "deg/s") == "5\u00a0deg/s"
    assert with_unit("2", "1") == "2"
    assert with_unit("–", "m") == "–"
    assert unit_text("1/s") == "1/s"


def test_what_round_off_leaves_of_a_zero_is_zero_in_a_column() -> None:
    """sin of pi beside 0.6: the twelfth digit of its column; just above it a number stands as it is."""
    numbers = Numbers()
    assert numbers.column([0.6, 1.2e-16, -7.7e-17, 0.9e-12 * 0.6]) == ["0.60000", "0.00000", "0.00000", "0.00000"]
    assert numbers.column([0.6, 1.1e-12 * 0.6]) == ["0.60000", "6.60·10⁻¹³"]
    assert numbers.column([1.2e-16, 2.4e-16]) == ["1.20·10⁻¹⁶", "2.40·10⁻¹⁶"]


def test_a_column_whose_entries_are_mostly_far_smaller_than_the_largest_is_written_in_powers_of_ten() -> None:
    assert N.column([-0.00023158, 1.028e-5, 4e-9, 0.0]) == ["−0.00023158", "0.00001028", "4.00·10⁻⁹", "0.00000000"]
    assert N.column([-0.00023158, 1.028e-5, 4e-9, 0.0, -2e-9, 1e-10]) == [
        "−2.32·10⁻⁴", "1.03·10⁻⁵", "4.00·10⁻⁹", "0", "−2.00·10⁻⁹", "1.00·10⁻¹⁰",
    ]  # fmt: skip


def test_a_column_is_judged_by_the_one_beside_it() -> None:
    assert N.column([1.1e-16, 0.0], size=0.5) == ["0", "0"]
    assert N.column([1.1e-16, 0.0])[0] != "0"


def test_numbers_that_differ_by_round_off_are_written_alike():
    below, above, other = N.column([1.1187499999999998, 1.1187500000000004, 1.11875001])
    assert (f"{1.1187499999999998:.4f}", f"{1.1187500000000004:.4f}") == ("1.1187", "1.1188")
    assert below == above == "1.1187"
    assert other == "1.1188"


def test_where_powers_groups_and_round_off_begin() -> None:
    assert [N.plain(value) for value in (1e-3, 999999.0, 1e6)] == ["0.001", "999999", "1.00·10⁶"]
    assert [N.whole(value) for value in (9999, 10000)] == ["9999", "10\u202f000"]
    assert [N.without_noise(value, size) == 0 for value, size in ((0.9e-9, 0.5), (1.1e-9, 0.5), (1.9e-9, 2), (2.1e-9, 2))] == [
        True, False, True, False,
    ]  # fmt: skip
    assert N.column([1.0, 0.9e-12])[1] == "0.0000" and N.column([1.0, 1.1e-12])[1] == "1.10·10⁻¹²"
    assert N.column([1.0, 9e-12], size=10.0)[1] == "0.0000"
    assert [N.duration(value)[-2:] for value in (1.0, 0.999, 0.999e-3)] == ["\xa0s", "ms", "µs"]


@pytest.mark.parametrize("count", [12, 13])
def test_a_dozen_remarks_are_told_and_the_number_of_the_others(count: int) -> None:
    told = [Remark("ANGLE", line, f"Remark {line}.") for line in range(1, count + 1)]
    run = SimpleNamespace(variant=SimpleNamespace(plausibility=told))
    notes = _plausibility(SimpleNamespace(words=load_words("en"), run=run, told=str))
    assert len(notes) == (12 if count == 12 else 13)
    shown = ["".join(piece.get("t", "") for piece in note.text) for note in notes]
    assert "Remark 12." in shown[11]
    assert count == 12 or shown[12] == "Further remarks in run.json: 1."


@pytest.mark.parametrize(("value", "text"), [
    (0.375, "0.38"), (0.3749999999996, "0.38"), (-0.3749999999996, "−0.38"), (0.374999999994, "0.37"), (0.37499, "0.37"),
    (0.625, "0.62"), (0.6250000000004, "0.62"), (0.625000000006, "0.63"),
])  # fmt: skip
def test_numbers_that_differ_beyond_the_twelfth_digit_are_written_alike_at_a_half(value: float, text: str) -> None:
    assert N.fixed(value, 2) == text


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "is_zero"), [(0.98e-12, True), (-0.98e-12, True), (1.02e-12, False), (-1.02e-12, False)])
def test_round_off_beside_the_largest_entry_is_zero_at_any_size(size: float, part: float, is_zero: bool) -> None:
    entries = np.array([part * size, size, -size / 2])
    motion: Any = SimpleNamespace(names=("x",), column=lambda _: entries)
    variant: Any = SimpleNamespace(unit_of=lambda _: "m")
    assert (first_of(motion, "x") == 0, shown_column(motion, "x", variant)[0] == 0) == (is_zero, is_zero)
    assert [text.strip("−0.") == "" for text in N.column([part * size, part * size * 5], size)] == [is_zero, False]
