"""Right tables whose digits were cut off instead of rounded cost nothing, in any way to cut them; wrong ones cost as rounded."""

import numpy as np
import pytest

from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import NEAR, codes, variants, with_a_steady_drive

CUT = {"toward zero": np.trunc, "downwards": np.floor}
LESS = np.arange(6, 20, 3)


def cut(table, digits, how):
    return CUT[how](np.round(table * 10.0**digits, 7)) / 10.0**digits


def desks():
    return [*variants()[1::2], with_a_steady_drive()]


def enough(desk):
    """Decimals with which a right table of the desk loses nothing when it is rounded."""
    return next(digits for digits in range(2, 6) if desk.marked(np.round(desk.machine.table(), digits), digits=digits)[0] == 60.0)


def told(desk, table, digits):
    return [note.code for note in desk.marker._notes(desk.marked(table, digits=digits)[1])]


@pytest.mark.long
@pytest.mark.parametrize("how", CUT)
@pytest.mark.parametrize("more", [0, 1, 2])
def test_a_right_table_with_digits_cut_off_loses_nothing(how, more):
    for desk in desks():
        digits = enough(desk) + more
        points, marks = desk.marked(cut(desk.machine.table(), digits, how), digits=digits)
        assert points == 60.0 and codes(marks) == () and marks.first is None, (desk.variant.name, digits)


def test_it_is_told_and_only_where_it_is_so():
    desk = variants()[1]
    table = desk.machine.table()
    assert desk.marked(cut(table, 2, "toward zero"), digits=2)[1].cut_off > 3 and "coarse_work" in told(
        desk, cut(table, 2, "toward zero"), 2
    )
    assert desk.marked(np.round(table, 2), digits=2)[1].cut_off == 0 and "coarse_work" not in told(desk, np.round(table, 2), 2)


def test_a_slip_in_cut_off_numbers_costs_its_own_cell_and_is_told_with_the_numbers_as_printed():
    desk = variants()[1]
    table = cut(desk.machine.table(), 2, "toward zero")
    table[7, 4] += 1.0
    points, marks = desk.marked(table, digits=2)
    assert marks.cells.wrong.sum() == 1 and points == pytest.approx(60 - 60 / marks.points.cells, abs=0.01)
    assert (marks.first.row, marks.first.column) == (8, desk.key.names[4]) and marks.first.found == pytest.approx(
        table[7, 4], abs=1e-12
    )


@pytest.mark.long
def test_further_digits_of_a_wrong_table_cut_off_cost_about_the_same_as_rounded():
    for desk in desks():
        machine = desk.machine

        def heun(t, q, machine=machine):
            rate = machine.velocities(t, q)[: machine.m]
            return machine.h / 2 * (rate + machine.velocities(t + machine.h, q + machine.h * rate)[: machine.m])

        other = Machine(desk.variant, data={desk.variant.given[0].name: 1.1 * desk.variant.given[0].value})
        for table, more in ((machine.table(heun), 1), (machine.table(heun), 2), (other.table(), 2)):
            digits = enough(desk) + more
            rounded = desk.marked(np.round(table, digits), digits=digits)[0]
            for how in CUT:
                found = desk.marked(cut(table, digits, how), digits=digits)[0]
                assert found == pytest.approx(rounded, abs=NEAR), (desk.variant.name, digits, how)


def test_one_cell_a_unit_too_small_is_a_slip():
    for desk in desks():
        digits = enough(desk)
        table = np.round(desk.machine.table(), digits)
        table[9, -1] -= 10.0**-digits * (1 if table[9, -1] > 0 else -1)
        points, marks = desk.marked(table, digits=digits)
        assert not marks.cut_off and points == pytest.approx(60 - 60 / marks.points.cells * marks.cells.wrong.sum(), abs=0.01)


@pytest.mark.long
def test_more_right_never_costs_in_numbers_that_are_cut_off():
    desk, chance = variants()[1], np.random.default_rng(3)
    right = desk.machine.table()
    for how in CUT:
        table = cut(right, 2, how)
        for row in LESS:
            table[row, chance.integers(table.shape[1])] += 0.5
        points = desk.marked(table, digits=2)[0]
        for _ in range(12):
            row, column = np.unravel_index(chance.permutation(right.size)[0], right.shape)
            table[row, column] = np.round(right[row, column], 2)
            after = desk.marked(table, digits=2)[0]
            assert after >= points - 1e-9, (how, row, column)
            points = after
