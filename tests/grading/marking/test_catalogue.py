"""Tables of the catalogue's variants: right ones have no wrong cell, whatever their digits; of wrong ones each can be marked."""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.table.causes.clockwise import turned_back
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.variant.catalogue import names
from tests.grading.marking.told import found_in
from tests.sample import sampled

BY_FORCES = ("example-2-motor", "falling-arm")  # marked by rows: tests/effects/test_graded_tables.py


@pytest.mark.parametrize("name", sampled(name for name in names() if name not in BY_FORCES))
def test_a_right_table_has_no_wrong_cell(name):
    variant = coursework.load(name)
    key = key_of(variant)
    columns, rows = coursework.solve(variant, "euler", quantities=["table"]).columns()
    assert columns == key.names
    for decimals in (2, 3, 4, 6):
        printed = StudentTable(np.round(rows, decimals), np.full(key.table.shape, 10.0**-decimals))
        cells = mark_cells(key, printed)
        assert not cells.wrong.any(), (decimals, np.argwhere(cells.wrong)[:4])
        if decimals >= key.least_decimals:
            assert not cells.missing[:, : len(key.coordinates)].any()


@pytest.mark.parametrize("name", ["homework", "whitworth"])
def test_a_solved_start_is_right_as_the_sheet_rounds_it(name):
    """With six decimals or in a workbook stands what the sheet told; half a place more is not the task's."""
    key = key_of(coursework.load(name))
    told = 10.0 ** -(key.least_decimals + 2)
    begun = key.table[0, 1]
    for start, wrong in ((round(begun / told) * told, 0), (begun + 0.6 * told, 1)):
        table = key.table.copy()
        table[0, 1] = start
        cells = mark_cells(key, StudentTable(table, np.full(table.shape, 1e-9)))
        assert cells.wrong[0, : len(key.coordinates)].sum() == wrong


@pytest.mark.parametrize("name", ["31", "cardan", "variable-crank", "watt"])
def test_a_wrong_table_is_looked_into_whatever_the_variant_is_written_with(name):
    """A crank of variable length has no equation without a term that has no name."""
    key = key_of(coursework.load(name))
    table = key.table + 0.3 * np.sin(np.arange(key.table.size)).reshape(key.table.shape)
    found_in(key, mark_cells(key, StudentTable(np.round(table, 4), np.full(table.shape, 1e-4))))


@pytest.mark.parametrize("name", ["cardan", "epicyclic", "example-2"])
@pytest.mark.parametrize("start", [1, 0], ids=["start", "negative"])
def test_a_mirrored_train_is_counted_clockwise(name, start):
    """Its drive with the other sign says the same, number for number."""
    key = key_of(coursework.load(name))
    m, table = len(key.coordinates), key.table.copy()
    for place, unit in enumerate(map(key.variant.unit_of, key.names)):
        if unit in {"rad", "rad/s"}:
            table[:, place] = (2 * start * table[0, place] if place < m else 0.0) - table[:, place]
    back = turned_back(key, StudentTable(np.round(table, 5), np.full(table.shape, 1e-5)))
    assert back is not None
    assert not mark_cells(key, back).wrong.any()
