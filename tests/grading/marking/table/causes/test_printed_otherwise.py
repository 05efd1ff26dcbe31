"""Columns that are right but for how they were printed: as many cells must say so as are no chance, and it costs the same."""

from dataclasses import replace

import numpy as np
import pytest

from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.printed_otherwise import other_columns, printed_otherwise
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.explained import Explained
from coursework.grading.marking.table.points import RUN, left_open
from coursework.grading.marking.table.starts import march, own_start
from coursework.grading.marking.table.ways import StudentTable
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import variants


def printed(table):
    return StudentTable(np.round(table, 4), np.full(table.shape, 1e-4))


@pytest.mark.parametrize(("rows", "told"), [(RUN - 1, []), (RUN, ["sign_w3"])])
def test_so_many_cells_with_the_other_sign_are_no_chance(rows, told):
    """The others of the column may have been put right; four cells that are left cost less one by one."""
    desk = variants()[0]
    table = desk.key.table.copy()
    table[8 : 8 + rows, desk.key.names.index("w3")] *= -1
    assert [claim.code for claim in printed_otherwise(TableUnderTest(desk.key, printed(table)))] == told


@pytest.mark.parametrize(("rows", "told"), [(2, []), (3, ["swapped_columns"])])
def test_so_many_cells_exchanged_are_no_chance(rows, told):
    desk = variants()[0]
    table = desk.key.table.copy()
    table[8 : 8 + rows, 3:5] = table[8 : 8 + rows, 4:2:-1].copy()
    assert [*{claim.code for claim in other_columns(TableUnderTest(desk.key, printed(table)))}] == told


@pytest.mark.parametrize(("unit", "way", "off", "told"), [
    ("rad", 1, np.pi / 2 + 0.0029, ["origin_phi2"]), ("rad", 1, np.pi / 2 + 0.0031, []), ("rad", 1, 0.0, []),
    ("rad", -1, 0.0, ["origin_phi2"] * 2), ("rad", -1, 0.0031, []), ("rad", 1, np.nan, []),
    ("m", 1, np.pi / 2, []), ("m", -1, 0.0, []),
])  # fmt: skip
def test_only_an_angle_is_counted_from_another_axis_and_no_length(unit, way, off, told):
    """A quarter turn on, to 0.003 rad, or the other way round, with its rate or without; what is not there is neither."""
    desk = variants()[0]
    coordinates = tuple(replace(one, unit=unit) if one.name == "phi2" else one for one in desk.variant.coordinates)
    key = replace(desk.key, variant=replace(desk.variant, coordinates=coordinates))
    table = desk.key.table.copy()
    table[:, 1] = way * table[:, 1] + off
    assert [claim.code for claim in other_columns(TableUnderTest(key, StudentTable(table, np.full(table.shape, 1e-9))))] == told


@pytest.mark.long
@pytest.mark.parametrize("number", [0, 4])
def test_one_column_in_print_only_costs_the_same_however_many_there_are(number):
    """Of seven columns and of five; two of them, or one that the angles were made from, are more than that."""
    desk = variants()[number]
    table, m = desk.machine.table(), desk.machine.m
    assert len(desk.key.names) == {0: 7, 4: 5}[number]
    turned, exchanged = table.copy(), table.copy()
    turned[:, -1] *= -1
    exchanged[:, m : m + 2] = table[:, [m + 1, m]]
    assert [desk.marked(one)[0] for one in (turned, exchanged)] == [57, 57]
    turned[:, m] *= -1
    assert desk.marked(turned)[0] < 51


def test_a_cell_that_comes_to_be_held_takes_nothing_from_those_beside_one_put_right():
    """The explanation's own table has another value there: that it follows from a misprint put right above does not matter."""
    desk = variants()[0]
    other = np.round(Machine(desk.variant, drive_sign=-1.0).table(), 4)
    table, m = other.copy(), desk.machine.m
    table[12, m] = desk.key.table[12, m]
    table[12, m + 1] += 0.7
    gates, holds = Explained(desk.key, mark_cells(desk.key, printed(table))), np.asarray(table == other)
    held = holds | (table == desk.key.table)
    assert gates.share(held, table=other) == gates.share(holds) > gates.share(held)


def test_cells_of_the_table_from_another_start_close_no_gate_in_it():
    """One of them put right took the worth of seven others."""
    desk = variants()[0]
    start = desk.key.table[0, : desk.machine.m].copy()
    start[-1] += 0.1
    table = march(desk.key, start, desk.key.velocities_at)
    own = own_start(desk.key, mark_cells(desk.key, printed(table)))
    assert left_open(desk.key, own.cells, np.arange(len(table))).all()
