"""Two tables on the same grid -> whether they agree.

Enters: `Table`s.  Leaves: yes or no.  Used by `read_submission.py`.
"""

from __future__ import annotations

import math

from coursework.grading.reading.numbers import ROUNDED
from coursework.grading.reading.student_work import Table, TableColumn


def alike(first: Table, second: Table) -> bool:
    """Return whether two tables agree; if one is from a report, which may round to other digits, up to the rounding."""
    digits = ROUNDED if first.place or second.place else 0.0
    both = [(column, other) for column in first.columns if (other := second.column(column.name))]
    return len(both) == len(first.columns) == len(second.columns) and all(_same(*pair, digits) for pair in both)


def _same(column: TableColumn, other: TableColumn, digits: float) -> bool:
    return all(
        math.isfinite(value) is math.isfinite(same)
        and (not math.isfinite(value) or abs(value - same) <= digits * (unit + other_unit))
        for value, unit, same, other_unit in zip(column.values, column.last_place, other.values, other.last_place, strict=True)
    )
