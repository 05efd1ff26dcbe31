"""The right table of every variant of the catalogue is right: no cell is wrong, whatever its digits."""

import numpy as np
import pytest

import coursework
from coursework.grading.marking.key import key_of
from coursework.grading.marking.table.cells import StudentTable, mark_cells
from coursework.variant.catalogue import names


@pytest.mark.parametrize("name", names())
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
