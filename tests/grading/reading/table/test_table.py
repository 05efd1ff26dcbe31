"""What the numbers of a table show by themselves: equal steps, zeros that show nothing, columns under words of their own."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from coursework.grading.reading.expected import Grid, GridColumn
from coursework.grading.reading.limits import unreadable
from coursework.grading.reading.numbers import printed
from coursework.grading.reading.student_work import TableColumn
from coursework.grading.reading.table.columns import Place
from coursework.grading.reading.table.headers import read_head
from coursework.grading.reading.table.table import (
    _is_steady,
    _is_table,
    _own_times,
    _strange,
    _without_zeros,
    _zeros,
    weight,
)  # fmt: skip

NAN = math.nan


def column(name: str, texts: list[str], at: int, **changes: Any) -> TableColumn:
    cells = [printed(text, ".") for text in texts]
    known = {
        "name": name, "at": at, "by": "header", "unit": "rad", "values": tuple(cell.value for cell in cells),
        "last_place": tuple(cell.last_place for cell in cells), "texts": tuple(texts),
        "flags": tuple(cell.flag for cell in cells),
        "decimals": max(-cell.place for cell in cells), "turns": 0,
    }  # fmt: skip
    return TableColumn(**known | changes)


def layout(columns: list[list[str]], heads: list[str] | None = None, above: tuple[str, ...] = ()) -> Any:
    body = tuple(tuple(printed(text, ".") for text in row) for row in zip(*columns, strict=True))
    known = [read_head(head, [("phi1", "rad"), ("w1", "1/s")]) for head in heads or [""] * len(columns)]
    return SimpleNamespace(body=body, heads=tuple(known), has_heads=heads is not None, above=above)


@pytest.mark.parametrize(("values", "is_steady"), [
    ([1.0, 1.5, 2.0], True), ([1.0, 1.0, 1.0], True), ([1.0, 2.0], False), ([1.0], False), ([], False),
    ([0.0, NAN, 1.0, 1.5], True), ([0.0, NAN, 0.5, 1.0], False),  # a row that is missing takes its step with it
    ([0.0, 1.0, 2.0 + 1.9e-9], True), ([0.0, 1.0, 2.0 + 2.1e-9], False), ([0.0, 0.1, 0.2 + 0.9e-9], True),
    ([0.0, 0.1, 0.2 + 1.1e-9], False),
    ([1000.0, 500.0, 0.9e-6], True), ([1000.0, 500.0, 1.1e-6], False), ([-1000.0, -500.0, -0.9e-6], True),
    ([0.9e-6, 500.0, 1000.0], True), ([-0.9e-6, -500.0, -1000.0], True), ([0.0, -500.0, -1000.0 - 1.1e-6], False),
    ([*map(float, range(9)), 9.5], True), ([*map(float, range(8)), 8.5, 9.5], False), ([*map(float, range(8)), 8.5], False),
    ([0.5, *map(float, range(1, 10))], True), ([-0.5, *map(float, range(1, 10))], True),
])  # fmt: skip
def test_equal_steps_are_those_that_nine_of_ten_numbers_stand_in(values: list[float], is_steady: bool) -> None:
    assert _is_steady(SimpleNamespace(values=tuple(values))) is is_steady  # type: ignore[arg-type]


@pytest.mark.parametrize(("texts", "zeros"), [
    ("1.500 2.300 0.100 4.200 5.900", 2), ("1.500 2.300 0.100 4.200", 0), ("1.510 2.300 0.100 4.200 5.900", 1),
    ("1.511 2.300 0.100 4.200 5.900", 0), ("10 20 30 40 50", 0), ("1.0 2.0 3.0 4.0 50.0", 1), ("1.5 2.30 0.10 4.20 5.90", 0),
    ("-1.500 -2.300 -0.100 4.200 5.900", 2), ("1.5000 2.1100 3.7100 4.3100 5.1100", 2), ("1.10 1.20 1.30 1.40 1.51", 0),
])  # fmt: skip
def test_zeros_that_end_all_of_five_numbers_are_counted_behind_the_decimal_mark(texts: str, zeros: int) -> None:
    assert _zeros([printed(text, ".") for text in texts.split()]) == zeros


def test_zeros_are_taken_from_uneven_columns_alone_and_as_many_as_all_of_them_have() -> None:
    """The first row is the start, which has more digits than the work."""
    texts = [
        ["0.4321", "1.5000", "2.3700", "0.1100", "4.2500", "5.9100"],
        ["7.1234", "1.1000", "2.2000", "0.9000", "4.1000", "5.3000"],
        ["0.0000", "0.0200", "0.0400", "0.0600", "0.0800", "0.1000"],
    ]  # fmt: skip
    columns = [column(name, cells, at) for at, (name, cells) in enumerate(zip("abc", texts, strict=True), 1)]
    grid = Grid(0.1, 6, tuple(GridColumn(name, "rad", (0.0, *(0.1234 * row for row in range(1, 6)))) for name in "abc"))
    found, zeros = _without_zeros(columns, layout(texts), grid)
    assert (zeros, [one.decimals for one in found]) == (2, [2, 2, 4])
    assert [one.last_place[3] for one in found] == pytest.approx([1e-2, 1e-2, 1e-4])
    assert _without_zeros(columns[2:], layout(texts), grid) == (columns[2:], 0)
    of_key = replace(grid, columns=(GridColumn("a", "rad", (0.5, 0.12, 0.34, 0.56, 0.78, 0.9)), *grid.columns[1:]))
    assert [one.decimals for one in _without_zeros(columns, layout(texts), of_key)[0]] == [4, 1, 4]


@pytest.mark.parametrize(("by", "heads", "above", "is_strange"), [
    ("position", ["x7"], (), True), ("position", ["7"], (), False), ("position", ["phi1"], (), False),
    ("header", ["x7"], (), False), ("position", None, ("x7",), True), ("position", None, ("7",), False),
])  # fmt: skip
def test_a_column_is_strange_where_it_is_taken_by_place_under_a_word_of_its_own(
    by: str, heads: list[str] | None, above: tuple[str, ...], is_strange: bool
) -> None:
    one = column("w1", ["1.5", "bad", "1.7"], 1, by=by)
    assert _strange(one, layout([["1.5"]], heads, above)) == 2 * is_strange


@pytest.mark.parametrize(("count", "heads", "is_table"), [
    (3, None, True), (2, None, False), (2, ["phi1", "w1"], True), (1, ["phi1"], False),
])  # fmt: skip
def test_three_columns_of_numbers_or_two_that_are_named_are_a_table(count: int, heads: list[str] | None, is_table: bool) -> None:
    words = layout([["1.5"]] * count + [["word"]] * 2, None if heads is None else [*heads, "a", "b"])
    assert _is_table(words) is is_table


def test_a_refused_table_weighs_its_named_cells_whole_and_others_a_quarter() -> None:
    grid = Grid(0.1, 2, (GridColumn("phi1", "rad", (1.0, 2.0)),))
    part: Any = SimpleNamespace(
        layout=layout([["1", "2", "3"], ["4", "bad", "6"]]), names=lambda grid: {"phi1": 0}
    )  # fmt: skip
    assert weight(part, unreadable("no_rows", step=0.1, rows=2), grid) == 1.0 + 0.25 + 1.0


def test_rows_with_times_of_their_own_are_in_the_units_and_turns_of_their_column() -> None:
    """540 deg, two turns below: 3 pi - 4 pi; a tenth of a degree is the last place."""
    own = column("phi1", ["540.0"], 1, unit="deg", turns=(2,))
    grid = Grid(0.1, 2, (GridColumn("phi1", "rad", (1.0, 2.0)), GridColumn("w1", "1/s", (1.0, 2.0))))
    rows: Any = SimpleNamespace(own=(0, 2), own_step=0.05)
    places: Any = SimpleNamespace(places={"phi1": Place(0, "header")})
    found = _own_times(grid, places, layout([["540.0", "0.0", "720.0"]]), rows, [own])
    values, steps = found.columns["phi1"]
    assert found.step == 0.05 and values == pytest.approx((-math.pi, 0.0), abs=1e-12)
    assert steps == pytest.approx((math.radians(0.1),) * 2)
