"""A table that is the key to the last digit: with more decimals than two programs have in common."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.student_table import is_the_key

TABLE = np.array([[1.0, 1 / 3], [0.5, -2 / 7]])


@pytest.mark.parametrize(("decimals", "off", "is_key"), [
    (13, 0.0, True), (12, 0.0, False), (13, 3e-13, False), (14, 3e-13, False), (14, 0.0, True),
])  # fmt: skip
def test_a_table_printed_with_thirteen_decimals_and_right_in_each_is_the_key(decimals: int, off: float, is_key: bool) -> None:
    values = np.round(TABLE + np.array([[0.0, off], [0.0, 0.0]]), decimals)
    student = SimpleNamespace(values=values, units=np.full(TABLE.shape, 10.0**-decimals))
    assert is_the_key(SimpleNamespace(table=TABLE), student) is is_key


def test_the_very_numbers_are_the_key_whatever_their_digits_and_a_cell_without_digits_is_no_print() -> None:
    key = SimpleNamespace(table=TABLE)
    assert is_the_key(key, SimpleNamespace(values=TABLE.copy(), units=np.full(TABLE.shape, np.nan)))
    near = np.nextafter(TABLE, 2.0)
    assert not is_the_key(key, SimpleNamespace(values=near, units=np.full(TABLE.shape, np.nan)))
