"""The unit in which a column was printed, from its head or else from its ratio to the key; also whole turns of an angle.

Enters: printed numbers and a `GridColumn`.  Leaves: unit, factor to SI, turns.  Only here is a table compared with the key.
Used by `table.py`; `precheck.py` and `feedback.py` print the units.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from statistics import median

from coursework.grading.reading.expected import GridColumn
from coursework.grading.reading.table.headers import PRINTED

AS_READ = {"1/s": "rad/s", "deg": "°"}  # unit of a column -> its spelling in table headers
_LARGE = 0.05  # share of the column's largest value; smaller cells give no reliable ratio
_WIDTH = 0.12
_TURN = 2 * math.pi
_BEGINS, _AS_BEGUN = 0.05, 0.01  # most deviation at the start: in rad, and as a share of the start value
_MOVED, _TURNED = 1 / 6, 1 / 2  # of a turn: an angle's most motion per row; a greater change than the second is a jump


def unit_of_column(column: GridColumn, head: str, values: Sequence[float]) -> str:
    """Return the unit of a column; `head` is the unit in its header, `values` has one number per row of the grid or NaN."""
    known = PRINTED.get(column.unit, {column.unit: 1.0})
    if head in known:
        return head
    if column.unit == "1/s" and head in {"deg", "rad"}:
        return {"deg": "deg/s", "rad": "1/s"}[head]
    ratios = _ratios(column.values, values)
    # A column that starts with the task's start value in some unit has that unit; a wrong table may later differ by any factor.
    # Velocities are not judged by their start: a factor of 57 may also come from a calculator set to degrees.
    first = values[0] / column.values[0] if column.unit == "rad" and column.values[0] else math.nan
    begins = [first] if math.isfinite(first) else []
    increments = _ratios(_increments(column.values), _increments(values))
    for seen, width in ((ratios, _WIDTH), (begins, _AS_BEGUN), (increments, _WIDTH)):
        for unit, factor in known.items():
            if seen and _in_unit(seen, factor, width):
                return unit
    return next(iter(known))


def _in_unit(ratios: Sequence[float], factor: float, width: float) -> bool:
    """Return whether most ratios fit a unit and the median is not nearer to 10, a slipped decimal point (rpm gives 9.55)."""
    middle = median(ratios)
    most = 2 * sum(abs(ratio * factor - 1) <= width for ratio in ratios) > len(ratios)
    return most and abs(middle * factor - 1) <= abs(middle / 10 - 1)


def factor_of(column: GridColumn, unit: str) -> float:
    """Return the factor that converts a unit of this column to SI."""
    return PRINTED.get(column.unit, {}).get(unit, 1.0)


def whole_turns(column: GridColumn, values: Sequence[float]) -> tuple[int, ...]:
    """Return by how many whole turns an angle (rad) differs from the key in each row, () if by none.

    The number is the same in all rows.  If the angle is kept within one turn, the number changes at each jump, provided that this
    brings the angle to the key: a wild motion jumps, too.
    """
    if column.unit != "rad" or not _apart(column, values):
        return ()
    jumps = turns_of_jumps(values)
    if any(jumps):
        whole = [value - _TURN * turns for value, turns in zip(values, jumps, strict=True)]
        beside = _turns_beside(column, whole)
        if stands_beside(column, [value - _TURN * beside for value in whole], median):
            return tuple(beside + turns for turns in jumps)
    beside = _turns_beside(column, values)
    return (beside,) * len(values) if beside else ()


def _turns_beside(column: GridColumn, values: Sequence[float]) -> int:
    """Return the whole turns of the column: from its first known row if that agrees with the key up to turns, else the median."""
    apart = _apart(column, values)
    at_first = round(apart[0] / _TURN)
    return at_first if abs(apart[0] - at_first * _TURN) < _BEGINS else round(median(apart) / _TURN)


def turns_of_jumps(values: Sequence[float]) -> list[int]:
    """Return for each row the whole turns by which an angle (rad) that is kept within one turn has jumped so far.

    >>> turns_of_jumps([3.0, 3.1, -3.1, -3.0, 3.1]), turns_of_jumps([3.0, 3.1, 0.31, 3.2])
    ([0, 0, -1, -1, 0], [0, 0, 0, 0])
    """
    known = [value for value in values if math.isfinite(value)]
    is_within = bool(known) and max(known) - min(known) <= _TURN
    turns, total, before = list[int](), 0, math.nan
    for value in values:
        jump = (value - before) / _TURN
        if is_within and abs(jump) > _TURNED and abs(jump - round(jump)) < _MOVED:
            total += round(jump)
        turns.append(total)
        before = value if math.isfinite(value) else before
    return turns


def stands_beside(column: GridColumn, values: Sequence[float], judged: Callable[[Sequence[float]], float] | None = None) -> bool:
    """Return whether an angle, after removing whole turns, is within 1/8 turn of the key; only then do whole turns explain it.

    `judged` condenses the distances of the rows to one number; by default this is the lesser of the first and the median.
    """
    apart = list(map(abs, _apart(column, values)))
    return (judged(apart) if judged else min(apart[0], median(apart))) < _TURN / 8


def _apart(column: GridColumn, values: Sequence[float]) -> list[float]:
    return [own - key for own, key in zip(values, column.values, strict=True) if math.isfinite(own) and math.isfinite(key)]


def _increments(values: Sequence[float]) -> list[float]:
    """Return each number less the first known one, in which an offset of whole turns cancels."""
    start = next((value for value in values if math.isfinite(value)), 0.0)
    return [value - start for value in values]


def _ratios(key: Sequence[float], own: Sequence[float]) -> list[float]:
    """Return the ratios of a column to the key in the rows where the key is not small, empty if there are fewer than two."""
    largest = max((abs(value) for value in key if math.isfinite(value)), default=0.0)
    ratios = [
        mine / right
        for mine, right in zip(own, key, strict=True)
        if math.isfinite(mine) and math.isfinite(right) and abs(right) > _LARGE * largest
    ]
    return ratios if len(ratios) >= 2 else []
