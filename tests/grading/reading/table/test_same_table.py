"""A table that is handed in twice: which one repeats the other."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest

from coursework.grading.reading.table.tables_of_file import alike


@dataclass
class Column:
    name: str
    at: int
    values: tuple[float, ...]
    last_place: tuple[float, ...]


@dataclass
class Reading:
    header: tuple[str, ...]
    columns: dict[str, dict[str, object]]


@dataclass
class Half:
    """What stands for a table of three rows; t is its first column."""

    reading: Reading
    columns: tuple[Column, ...]
    rows_present: tuple[int, ...] = (0, 1, 2)
    own: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    strange: tuple[str, ...] = ()
    place: str = ""

    def column(self, name: str) -> Column | None:
        return next((column for column in self.columns if column.name == name), None)


def half(*names: str, off: float = 0.0, place: str = "", **more: object) -> Half:
    """Return a table with some of the columns a, b, c, which have two decimals, all numbers moved by `off`."""
    values = {"a": (1.0, 2.0, 3.0), "b": (0.5, math.nan, 0.7), "c": (7.0, 8.0, 9.0)}
    columns = tuple(
        Column(name, at, tuple(value + off for value in values[name]), (0.01,) * 3) for at, name in enumerate(names, start=2)
    )
    heads = ("t", *names)
    return Half(Reading(heads, {c.name: {"at": c.at} for c in columns}), columns, place=place, **more)


@pytest.mark.parametrize(("off", "place", "are"), [
    (0.0, "", True), (0.001, "", False), (0.0100, "line 3", True), (0.0102, "line 3", False), (-0.0100, "line 3", True),
    (-0.0102, "line 3", False),
])  # fmt: skip
def test_a_report_repeats_a_table_up_to_what_printing_takes(off, place, are):
    """Of two numbers with two decimals each half a last place; a table of a file beside that of a file none."""
    assert alike(half("a", "b"), half("a", "b", off=off, place=place)) is are
    assert not alike(half("a", "b"), half("a", place=place))
