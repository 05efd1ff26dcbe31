"""A table that was handed in as several: positions in one, velocities in the next -> one table.

Enters: tables on one grid.  Leaves: `Table`; whether two say the same.  Used by `read_submission.py`.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from coursework.grading.reading.student_work import Table, TableColumn

_ROUNDED = 0.505  # of the last place: what printing takes from a number


def alike(first: Table, second: Table) -> bool:
    """Return whether two tables say the same; a report repeats the table of the file beside it, with digits of its own."""
    return {c.name for c in first.columns} == {c.name for c in second.columns} and _same_where_both(first, second)


def put_beside(first: Table, second: Table) -> Table | None:
    """Return a table with the columns that only the second has behind its own, None where they are no parts of one.

    What both have is the same, and each has all rows that the other has: halves of one table.
    """
    added = [column for column in second.columns if first.column(column.name) is None]
    if not added or first.own or second.own or first.rows_present != second.rows_present or not _same_where_both(first, second):
        return None
    shift = max(len(first.reading.header), *(column.at for column in first.columns))
    columns: dict[str, Any] = {c.name: {**second.reading.columns[c.name], "at": c.at + shift} for c in added}
    heads = (*first.reading.header, *second.reading.header) if first.reading.header and second.reading.header else ()
    return replace(
        first,
        reading=replace(first.reading, header=heads, columns={**first.reading.columns, **columns}),
        columns=(*first.columns, *(replace(column, at=column.at + shift) for column in added)),
        notes=first.notes + tuple(one for one in second.notes if one not in first.notes),
        strange=first.strange + second.strange,
    )


def _same_where_both(first: Table, second: Table) -> bool:
    digits = _ROUNDED if first.place or second.place else 0.0
    both = [(column, other) for column in first.columns if (other := second.column(column.name))]
    return all(_same(column, other, digits) for column, other in both)


def _same(column: TableColumn, other: TableColumn, digits: float) -> bool:
    return all(
        math.isfinite(value) is math.isfinite(same)
        and (not math.isfinite(value) or abs(value - same) <= digits * (unit + other_unit))
        for value, unit, same, other_unit in zip(column.values, column.last_place, other.values, other.last_place, strict=True)
    )
