"""What a wrong table may have been made with: other numbers, another table, or its columns meant otherwise.

Enters: a table as hypotheses see it, the rubric's confusions, tables of other variants.  Leaves: `Claim`s.
Used by `hypotheses.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from coursework.grading.marking.table.cells import HALF, SLACK, StudentTable
from coursework.grading.marking.table.claims import Claim, TableUnderTest
from coursework.system.arrays import Array

FACTORS = (10.0, 0.1, 2.0, 0.5, -1.0)
# Columns count as exchanged where, put back, this part of them is the key's.
_LIKE_KEY = 0.8


def other_data(printed: TableUnderTest, confusions: Mapping[str, float]) -> Iterator[Claim]:
    """Velocities with a datum ten times, twice, turned round; with two data exchanged; with a value that was declared."""
    given = printed.key.variant.given
    tried: list[tuple[str, dict[str, float]]] = [
        (f"datum_{datum.name}", {datum.name: factor * datum.value}) for datum in given for factor in FACTORS
    ]
    tried += [
        (f"swap_{first.name}_{second.name}", {first.name: second.value, second.name: first.value})
        for index, first in enumerate(given)
        for second in given[index + 1 :]
        if first.si == second.si and first.value != second.value
    ]
    tried += [(f"confusion_{name}", {name: value}) for name, value in confusions.items()]
    sets = printed.key.sets_at(printed.key.t, printed.q, [data for _, data in tried])
    for (code, data), found in zip(tried, sets, strict=True):
        yield from printed.velocity_claim(code, printed.slopes(data), found)


def other_tables(printed: TableUnderTest, others: Mapping[str, Array]) -> Iterator[Claim]:
    """The exact motion, or the table of another variant of the class."""
    units = np.nan_to_num(printed.student.units)
    key = printed.key
    exact = np.full_like(key.table, np.nan)
    exact[: len(key.exact)] = key.exact[: len(exact)]
    tolerance = HALF * units + SLACK * key.ranges
    yield Claim("exact", exact, tolerance, is_whole=True)
    for name, table in others.items():
        if table.shape == key.table.shape:
            yield Claim(f"variant_{name}", table, HALF * units + SLACK * np.ptp(table, axis=0), is_whole=True)
    for table in key.branches:
        yield Claim("branch", table, HALF * units + SLACK * np.ptp(table, axis=0), is_whole=True)


def other_columns(printed: TableUnderTest) -> Iterator[Claim]:
    """Two columns of one kind exchanged; an angle counted from another axis or the other way round."""
    key, student, m = printed.key, printed.student, printed.m
    tolerance = HALF * np.nan_to_num(student.units) + SLACK * key.ranges
    width = len(key.names)
    unit = [key.variant.unit_of(name) for name in key.names]
    for first in range(width):
        for second in range(first + 1, width):
            if unit[first] != unit[second] or (first < m) != (second < m):
                continue
            order = list(range(width))
            order[first], order[second] = second, first
            values = student.values[:, order]
            with np.errstate(invalid="ignore"):
                close = np.abs(values - key.table) <= tolerance[:, order]
            if close[:, [first, second]].mean() > _LIKE_KEY:
                put_back = StudentTable(values, student.units[:, order])
                yield _as_euler("swapped_columns", put_back)
    for place in range(m):
        if key.variant.coordinates[place].unit != "rad":
            continue
        for sign in (1.0, -1.0):
            shift = np.nanmedian(student.values[:, place] - sign * key.table[:, place])
            quarters = np.round(shift / (np.pi / 2)) if np.isfinite(shift) else 0.0
            if not quarters or abs(shift - quarters * np.pi / 2) > 0.02:
                continue
            values = student.values.copy()
            values[:, place] = sign * (values[:, place] - quarters * np.pi / 2)
            yield _as_euler(f"origin_{key.names[place]}", replace(student, values=values))


def _as_euler(code: str, student: StudentTable) -> Claim:
    """Return the claim that a table put right is Euler's."""
    blank = np.full(student.values.shape, np.nan)
    return Claim(code, blank, blank, "all", student)
