"""Rows that stand where others belong: how far, and how many of them, before anybody speaks of a shift."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.marking.table import points, starts
from coursework.grading.marking.table.causes import clockwise, odd_rows, printed_otherwise, shifted
from coursework.grading.marking.table.causes.odd_rows import Shift, displaced_rows, repeated_rows
from coursework.grading.marking.table.cells import GIVEN, KEY, MISSING, STEP, WRONG
from coursework.grading.marking.table.ways import StudentTable


@pytest.mark.parametrize("by", [1, 2, 3, -3, 4, -4])
@pytest.mark.parametrize("many", [3, 2])
def test_three_rows_in_a_row_that_belong_elsewhere(by: int, many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows 8 and on of twenty, in each of which every number is another."""
    table = np.arange(40.0).reshape(20, 2) ** 2
    values = table.copy()
    values[7 : 7 + many] = table[7 + by : 7 + many + by]
    monkeypatch.setattr(odd_rows, "as_printed", lambda key, units: np.full(values.shape, 0.01))
    student = StudentTable(values, np.zeros(values.shape))
    found = displaced_rows(SimpleNamespace(table=table), SimpleNamespace(student=student))
    assert found == ((Shift(8, 7 + many, by),) if many == 3 else ())


@pytest.mark.parametrize(
    ("below", "begins_wrong"),
    [
        ((KEY, STEP, KEY), False), ((MISSING, KEY, STEP), False), ((MISSING, STEP, KEY), True), ((MISSING,) * 3, True),
        ((STEP, KEY, KEY), True),
    ],
)  # fmt: skip
def test_a_wrong_start_value_is_a_slip_of_the_pen_where_the_first_value_below_is_right(
    below: tuple[int, ...], begins_wrong: bool
) -> None:
    marks = np.array([[GIVEN, WRONG], *([KEY, mark] for mark in below)])
    cells = SimpleNamespace(wrong=marks == WRONG, marks=marks)
    assert points._begins_wrong(cells, 2) == begins_wrong
    assert not points._begins_wrong(SimpleNamespace(wrong=np.zeros_like(marks, dtype=bool), marks=marks), 2)


def test_a_column_is_constant_that_changes_by_no_more_than_round_off() -> None:
    key = SimpleNamespace(ranges=5 * np.array([0.0, 0.9e-9, 1.1e-9]), table=np.full((3, 3), -5.0))
    assert points.constant(key).tolist() == [True, True, False]


@pytest.mark.parametrize(
    ("printed", "moved", "told"),
    [
        ((1.0, 2.0, 3.0, 4.0), 0.02, (2,)), ((1.0, 2.0, 3.0, 4.0), 0.005, ()), ((1.0, 2.0, 3.0, None), 0.02, (2,)),
        ((1.0, 2.0, None, None), 0.02, ()), ((1.0, 2.0, 3.0, 4.5), 0.02, ()),
    ],
)  # fmt: skip
def test_a_row_is_repeated_where_more_than_half_of_it_stands_again_and_moves_in_the_key(
    printed: tuple[float | None, ...], moved: float, told: tuple[int, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    values = np.array([[1.0, 2.0, 3.0, 4.0], printed], dtype=float)
    table = np.array([[1.0, 2.0, 3.0, 4.0], [1.0 + moved, 2.0, 3.0, 4.0]])
    monkeypatch.setattr(odd_rows, "_tolerance", lambda key, cells: np.full(values.shape, 0.01))
    assert repeated_rows(SimpleNamespace(table=table), SimpleNamespace(student=SimpleNamespace(values=values))) == told


@pytest.mark.parametrize(
    ("late", "early", "made"),
    [
        ([0] * 4 + [1] * 6, [0] * 10, [0, 1, 2, 4, 5, 6, 7, 8, 9, None]),
        ([0] * 10, [0] * 3 + [1] * 7, [0, 1, 2, None, 3, 4, 5, 6, 7, 8]),
        ([0] * 9 + [2.1], [0] * 10, [0, 1, 2, 4, 5, 6, 7, 8, 9, None]), ([0] * 9 + [1.9], [0] * 10, None),
        ([0] * 10, [0] * 9 + [2.1], [0, 1, 2, None, 3, 4, 5, 6, 7, 8]), ([0] * 10, [0] * 9 + [1.9], None),
    ],
)  # fmt: skip
def test_rows_are_put_back_where_half_of_all_and_a_row_more_than_before_is_then_right(
    late: list[float], early: list[float], made: list[int | None] | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three rows of ten are right where they stand."""
    right = {0: np.array([1.0] * 3 + [0.0] * 7), -1: np.array(late, dtype=float), 1: np.array(early, dtype=float)}
    monkeypatch.setattr(shifted, "_right", lambda printed, stands, by: right[by])
    monkeypatch.setattr(shifted, "alike_rows", lambda key, student, stands: np.eye(10, dtype=bool))
    student = StudentTable(np.arange(10.0)[:, None], np.ones((10, 1)))
    key, of_task = SimpleNamespace(table=student.values), np.zeros((10, 1), dtype=bool)
    found = shifted.put_back(SimpleNamespace(key=key, student=student, of_task=of_task))
    told = None if found is None else [None if np.isnan(one) else int(one) for one in found.values[:, 0]]
    assert told == made


@pytest.mark.parametrize(
    ("first", "is_mirrored"),
    [(-0.409, True), (-0.411, False), (-0.391, True), (-0.389, False), (0.4, False), (-0.4 + 2 * np.pi, True)],
)
def test_an_angle_begins_mirrored_within_the_last_digit_of_the_start_s_negative(
    first: float, is_mirrored: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clockwise, "_angular", lambda key: np.array([True]))
    key = SimpleNamespace(table=np.array([[0.4]]), m=1)
    assert clockwise._begins_mirrored(key, StudentTable(np.array([[first]]), np.array([[0.01]]))) == is_mirrored
    key.table = np.array([[0.004]])  # its own negative but for a digit
    assert not clockwise._begins_mirrored(key, StudentTable(np.array([[-0.004]]), np.array([[0.01]])))


@pytest.mark.parametrize(
    ("before", "off", "is_own"), [(None, 0.49, False), (None, 0.52, True), (0.0, 0.99, False), (0.0, 1.01, True)]
)
def test_a_start_is_another_by_more_than_its_rounding(
    before: float | None, off: float, is_own: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Half a digit as it is printed; a whole one where what stood there was put right."""
    monkeypatch.setattr(starts, "_marked_from", lambda key, cells, start, least: SimpleNamespace(marks=np.zeros((1, 1))))
    monkeypatch.setattr(starts, "_told_by_velocities", lambda key, cells: iter(()))
    monkeypatch.setattr(starts, "_stepped_back", lambda key, cells: None)
    key = SimpleNamespace(coordinates=("q",), m=1, table=np.array([[3.0]]), told_to=0.0, stride=0.02)
    table = StudentTable(np.array([[3.0 + 0.1 * off]]), np.array([[0.1]]))
    student = table if before is None else StudentTable(np.array([[3.0]]), np.array([[0.1]]))
    cells = SimpleNamespace(student=student, before=None if before is None else table, marks=np.zeros((1, 1)))
    found = starts.own_start(key, cells)
    assert (found is not None) == is_own


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(
    ("shift", "told"),
    [(np.pi / 2 + 0.0029, True), (np.pi / 2 - 0.0031, False), (-np.pi + 0.0031, False), (-np.pi - 0.0029, True), (0.0029, False)],
)
def test_an_angle_counted_from_another_axis_is_a_whole_number_of_quarters_off(
    sign: float, shift: float, told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(printed_otherwise, "_exchanged", lambda _: iter(()))
    monkeypatch.setattr(printed_otherwise, "_as_euler", lambda code, student: (code, student.values[:, 0]))
    monkeypatch.setattr(printed_otherwise, "_kept", lambda printed, stands, undone: undone)
    table = np.array([[0.3, 7.0], [1.4, 8.0], [2.9, 9.0]])
    variant = SimpleNamespace(coordinates=(SimpleNamespace(unit="rad", rate="w"),))
    key = SimpleNamespace(variant=variant, names=("q", "w"), table=table)
    student = StudentTable(sign * table + [shift, 0.0], np.zeros((3, 2)))
    found = [*printed_otherwise.other_columns(SimpleNamespace(key=key, student=student, m=1, of_task=None))]
    is_turned = sign < 0 and (told or abs(shift) < 0.003)  # the other way round: with its velocity and without
    assert [code for code, _ in found] == ["origin_q"] * (2 if is_turned else told)
    assert all(values == pytest.approx(table[:, 0], abs=0.003) for _, values in found)
