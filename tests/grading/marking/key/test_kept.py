"""Rows that were computed are kept: the same rows are not computed again, other rows or data are, and nobody spoils them."""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.kept import FEW_NUMBERS, kept
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.ways import StudentTable, own_ways

MODEL = coursework.compile_model("31")
TIMES, ROWS = np.array([0.0, 0.02]), np.array([[1.63, 3.37, 2.87], [1.6, 3.35, 2.9]])


class Counted:
    def __init__(self):
        self.calls = 0

    def __call__(self, t, q, data):
        self.calls += 1
        return MODEL.rates(t, q, data)


def test_the_same_rows_are_computed_once_and_other_rows_times_and_data_anew():
    ask, data, other = Counted(), MODEL.data(), MODEL.data({"r1": "953 mm"})
    for asked in ((data, TIMES, ROWS), (other, TIMES, ROWS), (data, TIMES + 0.01, ROWS), (data, TIMES, ROWS[::-1])):
        calls = ask.calls
        for _ in range(2):
            assert np.array_equal(kept(ask, *asked), MODEL.rates(*asked[1:], asked[0]))
        assert ask.calls == calls + 1


def test_what_is_kept_is_not_spoilt_by_who_got_it():
    data = MODEL.data()
    kept(MODEL.rates, data, TIMES, ROWS)[:] = 0.0
    assert np.array_equal(kept(MODEL.rates, data, TIMES, ROWS), MODEL.rates(TIMES, ROWS, data))


def test_long_tables_are_not_kept():
    ask, count = Counted(), FEW_NUMBERS // 3 + 1
    for _ in range(2):
        kept(ask, MODEL.data(), np.zeros(count), np.tile(ROWS[0], (count, 1)))
    assert ask.calls == 2


@pytest.mark.parametrize(("numbers", "calls"), [(1024, 1), (1025, 2)])
def test_results_of_1024_numbers_are_kept(numbers, calls):
    asked = []

    def ask(rows, data):
        asked.append(data)
        return rows

    for _ in range(2):
        kept(ask, None, np.zeros(numbers))
    assert len(asked) == calls


def test_ways_and_marks_that_are_kept_are_those_of_the_floor_and_the_start_asked_for():
    key = key_of(MODEL.variant)
    student = StudentTable(key.table, np.full(key.table.shape, 1e-4))
    floors = [own_ways(key, student, coarse).step.tolerance[1:, :3].min() for coarse in (1e-3, 2e-3, 1e-3)]
    assert floors == [1e-3, 2e-3, 1e-3]
    elsewhere = key.table + 0.01
    assert not mark_cells(key, student).wrong[0, :3].any()
    assert mark_cells(key, student, elsewhere).wrong[0, :3].all()
    assert not mark_cells(key, student).wrong[0, :3].any()
