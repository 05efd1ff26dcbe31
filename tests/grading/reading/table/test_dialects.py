"""Every dialect × digits × style × unit gives back the printed numbers, with the unit of their last place."""

from __future__ import annotations

import math
from itertools import product

import pytest

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.student_work import Table
from coursework.variant.catalogue import names
from tests.grading.reading.table.dialects import DIALECTS, STYLES, written
from tests.grading.reading.table.misread import ROWS, csv, read, read_table
from tests.grading.scenes import expected, times
from tests.sample import first, sampled

DIGITS = (2, 3, 4, 6)
# They keep the number itself; such a style is a format of the cell that the file shows, and all digits are stored.
OF_SPREADSHEETS = {"xlsx_numbers", "ods_numbers"}


def table_of(grid: Grid, dialect: str, style: str, digits: int, unit: str) -> Table:
    columns = {column.name: (column.unit, column.values) for column in grid.columns}
    if dialect in OF_SPREADSHEETS and style in {"significant", "scientific"}:
        digits = 15
    content = DIALECTS[dialect](grid.names, written(times(grid), columns, style, digits, unit), unit)
    read = read_table(content, f"table.{dialect}", grid)
    assert isinstance(read, Table), read.text
    return read


def check(grid: Grid, table: Table, digits: int, unit: str, style: str) -> int:
    """Every cell lies within half the unit of its last place, which is no coarser than what was printed.

    Exact tenths, whose zeros were dropped, do not say how many decimals there were.
    """
    assert {column.name for column in table.columns} == set(grid.names), table.reading
    assert all(table.rows_present)
    cells = 0
    for key in grid.columns:
        column = table.column(key.name)
        assert column is not None
        in_degrees = unit == "deg" and key.unit == "rad"
        assert column.unit == ("deg" if in_degrees else key.unit)
        factor = math.pi / 180 if in_degrees else 1.0
        for own, right, step in zip(column.values, key.values, column.last_place, strict=True):
            assert abs(own - right) <= 0.505 * step + 1e-12, (key.name, own, right, step)
            if abs(right / factor - round(right / factor, 1)) < 1e-9:
                assert step <= 1.001
            elif style in {"fixed", "dropped"}:
                assert step <= 1.001 * factor * 10.0**-digits
            else:
                assert step <= 1.001 * max(10 * abs(right), factor) * 10.0 ** (1 - digits)
            cells += 1
    return cells


@pytest.mark.parametrize("name", sampled(names()))
def test_every_variant_of_the_catalogue(name: str) -> None:
    """Each variant in all digits, the dialects, styles and units in turn: variant 31 has the whole product."""
    grid = expected(name).grid
    first = names().index(name)
    for turn, digits in enumerate(DIGITS):
        place = 4 * first + turn
        dialect, style = list(DIALECTS)[place % len(DIALECTS)], list(STYLES)[(place // 3) % 4]
        check(grid, table_of(grid, dialect, style, digits, ("rad", "deg")[place % 2]), digits, ("rad", "deg")[place % 2], style)


@pytest.mark.long
@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("half", first(1, (0, 1)))
def test_variant_31_in_every_style(dialect: str, half: int) -> None:
    grid = expected().grid
    cells = 0
    for place, (style, digits, unit) in enumerate(product(STYLES, DIGITS, ("rad", "deg"))):
        if place.bit_count() % 2 == half:  # each two of them together
            cells += check(grid, table_of(grid, dialect, style, digits, unit), digits, unit, style)
    assert cells == 4 * 4 * 25 * 7


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_two_bytes_a_letter_are_told_without_a_mark(encoding: str) -> None:
    text = csv(ROWS).decode().replace("phi", "φ")
    assert read(text.encode(encoding)).columns == read(text.encode()).columns
