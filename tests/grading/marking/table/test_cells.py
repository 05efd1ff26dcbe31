"""Cells right in any way: figures of variant 31, one slip blames one cell, nonsense earns nothing."""

from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.reasons.table import follows_euler
from coursework.grading.marking.table import cells
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.grading.marking.table.first_wrong import first_wrong
from coursework.grading.marking.table.points import table_points
from tests.grading.marking import students


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


def printed(table, decimals):
    return StudentTable(np.round(table, decimals), np.full(table.shape, 10.0**-decimals))


def share(key, student):
    return table_points(key, mark_cells(key, student)).share


def test_gap_and_least_decimals(key):
    assert key.gap == pytest.approx(0.0199, abs=5e-5)
    assert key.least_decimals == 3
    assert [key.names[place] for place in key.order] == ["phi1", "phi2", "phi3", "w3", "w4", "w1", "w2"]


@pytest.mark.parametrize("decimals", [2, 3, 4, 6, 9])
def test_a_right_table_earns_everything(key, decimals):
    cells = mark_cells(key, printed(students.table(), decimals))
    assert not cells.wrong.any()
    assert not cells.missing.any()
    assert table_points(key, cells).share == 1.0


@pytest.mark.parametrize("column", [0, 1, 2, 3])
@pytest.mark.parametrize("decimals", [3, 4, 5])
def test_one_slip_blames_one_cell(key, column, decimals):
    cells = mark_cells(key, printed(students.slip(10, column, 1.05), decimals))
    assert np.argwhere(cells.wrong).tolist() == [[10, 3 + column]]
    assert 0.98 < table_points(key, cells).share < 1.0
    told = first_wrong(key, cells)
    assert (told.row, told.column) == (11, f"w{column + 1}")
    assert "row 11" in told.sentence.lower()


def test_nonsense_earns_next_to_nothing(key):
    zeros = np.zeros_like(key.table)
    assert share(key, printed(zeros, 4)) <= 0.2
    still = np.hstack([np.tile(students.START, (25, 1)), np.zeros((25, 4))])
    assert share(key, printed(still, 4)) <= 0.3
    assert share(key, printed(np.full_like(key.table, np.nan), 4)) == 0.0


def test_other_schemes_are_wrong_where_their_steps_show(key):
    assert share(key, printed(students.table(students.heun), 4)) == pytest.approx(0.58, abs=0.01)
    ahead = students.MISCONCEPTIONS["time_ahead"]()
    assert share(key, printed(ahead, 4)) < 0.04


def test_digits_too_coarse_are_missing_and_never_right(key):
    coarsest = 0.6 * key.gap
    table = students.table()
    inside, outside = (StudentTable(table, np.full(table.shape, unit)) for unit in (coarsest * 0.99, coarsest * 1.01))
    assert not mark_cells(key, inside).missing.any()
    cells = mark_cells(key, outside)
    assert cells.missing[:, :3].all()
    assert not cells.missing[:, 3:].any()
    assert cells.too_coarse[:, :3].all()


def test_of_steps_too_coarse_to_be_seen_none_is_said_to_follow_euler(key):
    table = students.table()
    for unit, told in ((0.59 * key.gap, "right"), (0.61 * key.gap, "unknown")):
        marked = SimpleNamespace(misconception=None, cells=mark_cells(key, StudentTable(table, np.full(table.shape, unit))))
        assert follows_euler(key, marked).key == f"marking.verdict.integration.{told}"


def test_only_half_a_unit_of_the_last_place_is_forgiven(key):
    table = np.round(students.table(), 4)
    slack = 2e-4 * np.ptp(students.table()[:, 6])
    for off, wrong in ((0.50e-4, False), (0.6e-4 + 2 * slack, True)):
        moved = table.copy()
        moved[5, 6] = students.table()[5, 6] + off
        assert mark_cells(key, printed_exactly(moved)).wrong[5, 6] == wrong


def printed_exactly(table):
    return StudentTable(table, np.full(table.shape, 1e-4))


def test_work_computed_coarser_than_printed_is_judged_by_how_it_was_computed(key):
    q, rows = np.array(students.START), []
    for k in range(25):
        w = np.round(students.velocities(k * students.H, q), 3)
        rows.append(np.concatenate([q, w]))
        q = np.round(q + students.H * w[:3], 3)
    degrees = np.array(rows)
    student = StudentTable(degrees, np.full(degrees.shape, 10.0**-6))
    cells = mark_cells(key, student)
    assert cells.computed_to is not None
    assert cells.wrong[:, :3].sum() == 0


def test_a_wrong_start_closes_the_gate_for_carried_cells(key):
    table = students.table(start=(1.53, 3.37, 2.87))
    cells = mark_cells(key, printed(table, 4))
    assert cells.wrong[0, 0]
    assert table_points(key, cells).shut["start"]
    right = table_points(key, mark_cells(key, printed(students.table(), 4)))
    assert "start" not in right.shut


def test_one_slip_in_work_computed_coarser_than_printed_is_one_cell(key):
    """Radians of four decimals, turned into degrees of three."""
    for row in range(2, 23, 3):
        table = students.table()
        table[row, row % 3] += 0.17
        table[:, :3] = np.round(np.degrees(np.round(table[:, :3], 4)), 3) * np.pi / 180
        units = np.full(table.shape, 1e-4)
        units[:, :3] = 1e-3 * np.pi / 180
        cells = mark_cells(key, StudentTable(np.hstack([table[:, :3], np.round(table[:, 3:], 4)]), units))
        assert np.argwhere(cells.wrong).tolist() == [[row, row % 3]]


@pytest.mark.parametrize("size", [0.004, -250.0])
@pytest.mark.parametrize(("part", "shown"), [(0.98e-12, True), (-0.98e-12, True), (1.02e-12, False), (-1.02e-12, False)])
def test_a_datum_that_is_printed_whole_hides_nothing_at_any_size(size, part, shown):
    key = SimpleNamespace(given={"a": size}, names=("a", "b"), coarsest=np.array([1e-6, 1e-6]))
    student = StudentTable(np.array([[size * (1 + part), 1.0]]), np.array([[1.0, 1e-6]]))
    marks, coarse = cells.marks_by(key, student, [], np.zeros((1, 0), dtype=bool))
    assert marks.tolist() == [[cells.WRONG if shown else cells.MISSING, cells.WRONG]] and coarse.tolist() == [[not shown, False]]
