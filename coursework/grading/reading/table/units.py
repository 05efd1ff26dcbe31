"""The unit a column was printed in: from its head, else from its ratio to the key; and whole turns of an angle.

Enters: printed numbers and a `GridColumn`.  Leaves: unit, factor to SI, turns.  The only place that looks at the key's values.
Used by `table.py`; `precheck.py` and `feedback.py` say it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median

from coursework.grading.reading.expected import GridColumn
from coursework.grading.reading.table.headers import PRINTED

AS_READ = {"1/s": "rad/s", "deg": "°"}  # unit of a column -> as the heads of the tables say it
_LARGE = 0.05  # of the column's largest value: smaller cells say nothing about a ratio
_WIDTH = 0.12
_TURN = 2 * math.pi
_BEGINS = 0.05  # rad


def unit_of_column(column: GridColumn, head: str, values: Sequence[float]) -> str:
    """Return the unit of a column; `values` has one number a row of the grid, NaN where there is none."""
    known = PRINTED.get(column.unit, {column.unit: 1.0})
    if head in known:
        return head
    if column.unit == "1/s" and head in {"deg", "rad"}:
        return {"deg": "deg/s", "rad": "1/s"}[head]
    ratios = _ratios(column.values, values)
    # What begins as the task begins is in that unit; a wrong table may grow to any multiple of the right one later.  A velocity
    # that begins at 57 times the right one shows a calculator in degrees as well as a unit.
    begins = ratios[:1] if column.unit == "rad" else []
    for seen in (ratios, _ratios(_increments(column.values), _increments(values)), begins):
        for unit, factor in known.items():
            if seen and _in_unit(seen, factor):
                return unit
    return next(iter(known))


def _in_unit(ratios: Sequence[float], factor: float) -> bool:
    """Return whether most ratios are those of a unit; where they are nearer to ten, a point has slipped: rpm is 9.55."""
    middle = median(ratios)
    most = 2 * sum(abs(ratio * factor - 1) <= _WIDTH for ratio in ratios) > len(ratios)
    return most and abs(middle * factor - 1) <= abs(middle / 10 - 1)


def factor_of(column: GridColumn, unit: str) -> float:
    """Return what one unit of a column is in SI."""
    return PRINTED.get(column.unit, {}).get(unit, 1.0)


def whole_turns(column: GridColumn, values: Sequence[float]) -> int:
    """Return how many whole turns an angle (rad) stands beside the key, one number for the whole column.

    Where it begins as the task begins, the beginning tells; a wrong table may be turns away later.
    """
    apart = _apart(column, values)
    if column.unit != "rad" or not apart:
        return 0
    at_first = round(apart[0] / _TURN)
    return at_first if abs(apart[0] - at_first * _TURN) < _BEGINS else round(median(apart) / _TURN)


def stands_beside(column: GridColumn, values: Sequence[float]) -> bool:
    """Return whether an angle without its whole turns is the key's, about: other numbers stand no whole turns away from it."""
    apart = _apart(column, values)
    return min(abs(apart[0]), abs(median(apart))) < _TURN / 8


def _apart(column: GridColumn, values: Sequence[float]) -> list[float]:
    return [own - key for own, key in zip(values, column.values, strict=True) if math.isfinite(own) and math.isfinite(key)]


def _increments(values: Sequence[float]) -> list[float]:
    """Return how far each number is from the first one there is; a whole turn too many does not show in it."""
    start = next((value for value in values if math.isfinite(value)), 0.0)
    return [value - start for value in values]


def _ratios(key: Sequence[float], own: Sequence[float]) -> list[float]:
    """Return the ratios of a column to the key over its larger cells, nothing where there are too few."""
    largest = max((abs(value) for value in key if math.isfinite(value)), default=0.0)
    ratios = [
        mine / right
        for mine, right in zip(own, key, strict=True)
        if math.isfinite(mine) and math.isfinite(right) and abs(right) > _LARGE * largest
    ]
    return ratios if len(ratios) >= 2 else []
