"""Rows that are not handed in cost their cells and nothing else, wherever they are missing."""

import numpy as np
import pytest

from tests.grading.marking.table.desks import variants
from tests.grading.marking.table.test_no_work import MOST, NAMES, marker, share, without_work


def left_out(chance, rows):
    """Every second, third or fifth row and the last one; half of all rows, but for the first."""
    for pace in (2, 3, 5):
        yield np.unique([*range(0, rows, pace), rows - 1])
    yield np.union1d(0, chance.choice(rows, size=rows // 2, replace=False))


@pytest.mark.parametrize("number", [0, 4])
def test_right_rows_earn_their_cells_and_a_slip_between_them_one_or_the_row_s(number):
    desk, chance = variants()[number], np.random.default_rng(number)
    rows, m = desk.machine.rows, desk.machine.m
    times, right = np.arange(rows) * desk.machine.h, desk.machine.table()
    slipped = desk.machine.table(slip=(7, 0, 0.2))
    cell = 60 / (right.size - m)
    for kept in left_out(chance, rows):
        earned = cell * (right[kept].size - m)
        assert desk.marked(right[kept], times=times[kept])[0] == pytest.approx(earned, abs=0.01)
        found, marked = desk.marked(slipped[kept], times=times[kept])
        wrong = int(marked.cells.wrong.sum())
        assert wrong <= (1 if 7 in kept else m)
        assert found >= earned - 2 * m * cell
        if 7 not in kept and wrong:
            before = int(kept[kept < 7].max())
            after = int(kept[kept > 7].min())
            assert f"{after - before} of Euler’s steps from your own row {before + 1}" in marked.first.sentence


def test_faults_cost_the_same_part_of_the_rows_that_are_handed_in():
    for desk in variants()[::2]:
        start, times = desk.machine.start.copy(), np.arange(desk.machine.rows) * desk.machine.h
        start[-1] += 0.1
        found, marked = desk.marked(desk.machine.table(start=start)[::2], times=times[::2])
        cells = marked.cells
        assert marked.earned.rule == "start"
        assert found == pytest.approx(57 * (1 - cells.missing.sum() / cells.counted.sum()), abs=0.05)


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES[:4])
def test_some_rows_of_a_table_without_work_earn_no_more_than_all_of_them_may(name):
    for label, table in without_work(marker(name).key, np.random.default_rng(7)):
        for pace in (2, 3):
            thinned = np.full(table.shape, np.nan)
            thinned[::pace] = table[::pace]
            assert share(name, thinned) <= MOST, (label, pace)


def test_columns_with_a_head_and_no_number_are_missing():
    """Without a single velocity, or a single angle, no unit could be told, and the grader stopped."""
    for desk in variants()[::2]:
        m = desk.machine.m
        for empty in (slice(m, None), slice(0, m), slice(0, 1)):
            table = desk.machine.table()
            table[:, empty] = np.nan
            points, marked = desk.marked(table)
            assert marked.cells.missing[1:, empty].all()
            assert 0 <= points < 60
