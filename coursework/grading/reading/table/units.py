"""The unit of a printed column, from its head, its ratio to the key or the other columns; also whole turns of an angle.

Enters: printed numbers and the `Grid`.  Leaves: unit, factor to SI, turns.  Only here is a table compared with the key.
Used by `table.py`; `precheck.py` and `feedback.py` print the units.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import compress, pairwise
from statistics import median

from coursework.grading.reading.expected import Grid, GridColumn
from coursework.grading.reading.table.headers import PRINTED

AS_READ = {"1/s": "rad/s", "deg": "°"}  # unit of a column -> its spelling in table headers
_LARGE = 0.05  # share of the column's largest value; smaller cells give no reliable ratio
_WIDTH = 0.12
_TURN = 2 * math.pi
_BEGINS, _AS_BEGUN = 0.05, 0.01  # most deviation at the start: in rad, and as a share of the start value
_HELD = 0.75  # part of an angle's steps that its own velocities must explain in order to tell its turns
_MOVED, _TURNED = 1 / 6, 1 / 2  # of a turn: an angle's most motion per row; a greater change than the second is a jump


def units_of_columns(grid: Grid, heads: Mapping[str, str], values: Mapping[str, Sequence[float]]) -> dict[str, str]:
    """Return the unit of each column handed in, by name; `values` have one number for each row of the grid, NaN if missing.

    The head or the key determines the unit; a head that the numbers contradict is only a slip.  If a column is too wrong for
    that, a velocity's unit follows from the steps made with it, and any other column has the unit of most columns of its kind:
    nobody prints one angle in degrees and the next in radians.  If no column of a kind has a unit, as with exchanged columns,
    all their numbers together determine it.
    """
    there = [column for column in grid.columns if column.name in values]
    found = {column.name: unit_of_column(column, heads[column.name], values[column.name]) for column in there}
    named = {column.name: column for column in there}

    def settle(unit: str) -> None:
        alike = [column for column in there if column.unit == unit]
        usual = Counter(known for column in alike if (known := found[column.name]))
        most = usual.most_common(1)[0][0] if usual else _together(alike, values) or next(iter(PRINTED[unit]))
        found.update({column.name: most for column in alike if not found[column.name]})

    def moved_with(column: GridColumn, factor: float = 1.0) -> tuple[list[float], list[float]]:
        moves = [factor * (later - before) for before, later in pairwise(values[column.name])]
        return moves, [grid.step * rate for rate in values[column.rate][:-1]]

    in_doubt = [column for column in there if found[column.name] == "deg" and not heads[column.name] and column.rate in named]
    for column in in_doubt if "rad" in found.values() else ():
        if found[column.rate] in {"1/s", None}:
            found[column.name] = _alike(_ratios(*reversed(moved_with(column))), {"rad": 1.0}, _WIDTH) or "deg"
    for column in there:  # velocities under another unit's head: both the key and the steps made with them tell so
        if (rate := named.get(column.rate)) and heads[rate.name]:
            told = _alike(_ratios(rate.values, values[rate.name]), PRINTED[rate.unit], _AS_BEGUN)
            moved = _ratios(*moved_with(column, factor_of(column, found[column.name] or "")))
            if told and _alike(moved, {told: factor_of(rate, told)}, _WIDTH):
                found[rate.name] = told
    turning = [column for column in there if column.unit == "1/s"]
    for unit in {column.unit: None for column in there if column not in turning}:
        settle(unit)
    if "1/s" not in map(found.get, heads):
        # Ten times a datum of the drive is about a velocity in rpm, but no velocity is then exactly one.
        is_sure = any(_is_exact(column, found[column.name], values[column.name]) for column in turning)
        # Radians added to degrees also give steps as of velocities in degrees, but these are no larger than the task's.
        sizes = [abs(ratio) for column in turning for ratio in _ratios(column.values, values[column.name]) if ratio]
        known = {unit: factor for unit, factor in PRINTED["1/s"].items() if _is_about(sizes, factor)}
        for column in there:
            if named.get(column.rate) in turning and (not found[column.rate] or (not heads[column.rate] and not is_sure)):
                factor = factor_of(column, found[column.name] or "")
                found[column.rate] = _alike(_ratios(*moved_with(column, factor)), known, _WIDTH) or found[column.rate]
    if turning:
        settle("1/s")
    return {name: unit or "" for name, unit in found.items()}


def _together(columns: Sequence[GridColumn], values: Mapping[str, Sequence[float]]) -> str | None:
    """Return the unit of columns of one kind from the sizes of all their numbers, in whichever column each one is."""
    pairs = [pair for column in columns for pair in zip(values[column.name], column.values, strict=True)]
    known = [pair for pair in pairs if all(map(math.isfinite, pair))]
    own, key = (sorted(abs(pair[place]) for pair in known) for place in (0, 1))
    return _alike(_ratios(key, own), PRINTED[columns[0].unit], _WIDTH)


def _is_exact(column: GridColumn, unit: str | None, values: Sequence[float]) -> bool:
    """Return whether most of a column's ratios to the key are the factor of its unit, up to the rounding of printed numbers."""
    return unit is not None and bool(_alike(_ratios(column.values, values), {unit: factor_of(column, unit)}, _AS_BEGUN))


def _is_about(sizes: Sequence[float], factor: float) -> bool:
    """Return whether ratios to the key are nearer to the factor of a unit than to 1."""
    off = math.log(median(sizes or [1.0]))
    return abs(off + math.log(factor)) <= abs(off)


def unit_of_column(column: GridColumn, head: str, values: Sequence[float]) -> str | None:
    """Return the unit of a column from its head or the key, None if neither determines it."""
    known = PRINTED[column.unit]
    first = values[0] / column.values[0] if column.unit == "rad" and column.values[0] else math.nan
    begins = [first] if math.isfinite(first) else []
    if head in known:  # unless the start value, or most of an angle, a length or a speed, is printed in another unit
        is_told = column.unit in {"rad", "m", "m/s"}
        return (_alike(begins or _ratios(column.values, values), known, _AS_BEGUN) if is_told else None) or head
    if column.unit == "1/s" and head in {"deg", "rad"}:
        return {"deg": "deg/s", "rad": "1/s"}[head]
    # A column that starts with the task's start value in some unit has that unit; a wrong table may later differ by any factor.
    # Velocities are not judged by their start: a factor of 57 may also come from a calculator set to degrees.
    # Only a position may be counted from elsewhere; a velocity whose first row is wild differs by that in every row.
    increments = _ratios(_increments(column.values), _increments(values)) if column.rate else []
    seen = ((_ratios(column.values, values), _WIDTH), (begins, _AS_BEGUN), (increments, _WIDTH))
    return next((unit for ratios, width in seen if (unit := _alike(ratios, known, width))), None)


def _alike(ratios: Sequence[float], known: Mapping[str, float], width: float) -> str | None:
    """Return the unit that most ratios are those of; where they are nearer to ten, a point has slipped: rpm is 9.55."""
    sizes = [abs(ratio) for ratio in ratios]  # of a drive with the other sign, too
    for unit, factor in known.items():
        if 2 * sum(abs(size * factor - 1) <= width for size in sizes) > len(sizes):
            middle = median(sizes)
            if abs(middle * factor - 1) <= abs(middle / 10 - 1):
                return unit
    return None


def factor_of(column: GridColumn, unit: str) -> float:
    """Return the factor that converts a unit of this column to SI."""
    return PRINTED[column.unit].get(unit, 1.0)


def whole_turns(column: GridColumn, values: Sequence[float], moves: Sequence[float] = ()) -> tuple[int, ...]:
    """Return by how many whole turns an angle (rad) differs from the key in each row, () if by none.

    The number is the same in all rows, except in rows that agree with the key as printed.  If the angle is kept within one turn,
    the number changes at each jump, provided that this brings the angle to the key: a wild motion jumps, too.  There `moves`
    tell the turns: the steps (rad) to the next row that the printed velocities make, if there are any.  A column that stands
    still where the key moves has no turns, however near it is to one.
    """
    own, right = (any(abs(step) > 0 for step in _increments(numbers)) for numbers in (values, column.values))
    if column.unit != "rad" or (right and not own) or not _apart(column, values):
        return ()
    jumps = turns_of_jumps(values)
    if any(jumps):
        whole = [value - _TURN * turns for value, turns in zip(values, jumps, strict=True)]
        beside = _turns_beside(column, whole)
        if stands_beside(column, [value - _TURN * beside for value in whole], median):
            return tuple(beside + turns for turns in jumps)
    if told := _turns_of_moves(column, values, moves):
        return told
    beside = _turns_beside(column, values)
    found = tuple(0 if abs(own - key) <= _BEGINS else beside for own, key in zip(values, column.values, strict=True))
    return found if any(found) else ()


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


def _turns_of_moves(column: GridColumn, values: Sequence[float], moves: Sequence[float]) -> tuple[int, ...]:
    """Return the whole turns that an angle lacks in each row if it moved as its velocities say, () if it did not.

    A row that its step does not lead to is passed over: the steps from the last sure row on tell the turns of the rows behind
    it, or the values alone if a velocity between is misprinted too.  If it agrees with the key it was put right: it keeps its
    number.
    """
    first = _apart(column, values)[0]
    numbers, held, known = [round(first / _TURN)], [_is_whole(first)], 0
    sure, moved = 0, 0.0
    for row, move in enumerate(moves, start=1):
        lack, moved = values[row] - values[row - 1] - move, moved + move
        since, jump = values[row] - values[sure] - moved, values[row] - values[sure]
        known += math.isfinite(lack)
        held.append(_is_whole(lack))
        if held[-1]:
            numbers.append(numbers[-1] + round(lack / _TURN))
        else:
            if not math.isfinite(moved):  # rows are missing between: the key tells how far the angle went
                jump -= column.values[row] - column.values[sure]
            told = since if _is_whole(since) else jump if math.isfinite(jump) else 0.0
            numbers.append(numbers[sure] + round(told / _TURN))
        if held[-1] or _is_whole(since):
            sure, moved = row, 0.0
    if sum(held[1:]) < _HELD * known or len({*compress(numbers, held)}) < 2:
        return ()
    rows = zip(numbers, held, values, column.values, strict=True)
    return tuple(0 if not holds and abs(own - key) <= _BEGINS else number for number, holds, own, key in rows)


def _is_whole(angle: float) -> bool:
    """Return whether an angle (rad) is known and near a whole number of turns."""
    return math.isfinite(angle) and abs(math.remainder(angle, _TURN)) <= _BEGINS


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
