"""The rows of a file -> rows of the assigned grid.

Enters: a `Layout`, the places of time and row numbers, the grid.  Leaves: `Rows`.
Used by `table.py`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from statistics import fmean, median_low

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.numbers import PrintedNumber
from coursework.grading.reading.table.columns import Places
from coursework.grading.reading.table.headers import INDEX, PRINTED, TIME
from coursework.grading.reading.table.layout import Layout
from coursework.system.frozen import frozen

_FEWEST, _OTHER = 3, 0.05  # least number of rows that show a step; relative difference that makes it another than the grid's
_SHORTEST = 1e-3  # of the grid's step: times nearer to one another are the same
_USUAL = 0.4  # of the median step: how far printed times may lead another step from it
_NEAR = 0.3  # of a step: how far a printed time may be from the time of its row


@frozen
class Rows:
    """For each row of the grid (from 0) the index of the file's row, None if there is none; and what was unusual about the rows.

    `extra` counts rows of the file that match no row of the grid; `recovered` counts times that a spreadsheet had spoilt.
    `order` are the file's rows in the order of even times, () if the times are uneven or the file is in that order or the
    opposite one.  If the student's time step differs from the grid's, `own` are the file's rows in the order of time and
    `own_step` is the step in s; otherwise they are () and 0.  `off_grid` is the first row in order (from 0) whose time is not
    that of the row of the grid at its place, with this time in s; None if there is none.  `twice` is the first row of the grid
    (from 1) for which the file has two rows that contradict each other, 0 if there is none.
    """

    of_grid: tuple[int | None, ...]
    is_sorted: bool
    extra: int
    recovered: int
    time_unit: str
    own: tuple[int, ...] = ()
    own_step: float = 0.0
    off_grid: tuple[int, float] | None = None
    twice: int = 0
    order: tuple[int, ...] = ()


def place_rows(layout: Layout, places: Places, grid: Grid) -> Rows:
    """Assign the rows of the file to the rows of the grid: by time, else by row numbers, else in order."""
    count = len(layout.body)
    unit, recovered = "s", 0
    own: tuple[int, ...] = ()
    order: tuple[int, ...] = ()
    step = 0.0
    times: list[float] = []
    if TIME in places.places:
        at = places.places[TIME].at
        cells = [row[at] for row in layout.body]
        unit = _time_unit(layout.heads[at].unit, cells, grid)
        times, recovered = _times(cells, PRINTED["s"][unit])
        own, step = _own_step(times, grid)
        finest = min((cell.last_place for cell in cells if cell.is_number), default=0.0)
        targets = _by_time(times, finest * PRINTED["s"][unit], grid, step)
        order = _order(times, targets, grid)
    elif INDEX in places.places and (numbers := _row_numbers(layout, places.places[INDEX].at)):
        targets = [number if 0 <= number < grid.rows else None for number in numbers]
    else:
        targets = [place if place < grid.rows else None for place in range(count)]
    of_grid, twice = _unique(layout, places, targets, grid.rows)
    on_grid = [target for target in targets if target is not None]
    is_sorted = any(later < earlier for earlier, later in pairwise(on_grid))
    return Rows(
        of_grid, is_sorted, targets.count(None), recovered, unit, own, step, _off_grid(times, targets, order), twice, order
    )


def in_order(rows: Rows, count: int) -> Rows:
    """Return the rows of the grid filled in the order of even times, else of the file, of `count` rows."""
    order = rows.own or rows.order or range(count)
    of_grid = tuple(order[place] if place < len(order) else None for place in range(len(rows.of_grid)))
    return Rows(of_grid, bool(rows.order), max(count - len(of_grid), 0), 0, rows.time_unit)


def _off_grid(times: Sequence[float], targets: Sequence[int | None], order: Sequence[int]) -> tuple[int, float] | None:
    found = ((place, row) for place, row in enumerate(order or range(len(times))) if targets[row] != place)
    return next(((place, times[row]) for place, row in found if math.isfinite(times[row])), None)


def _order(times: Sequence[float], targets: Sequence[int | None], grid: Grid) -> tuple[int, ...]:
    """Return the rows of a file in the order of even times, () if they stand in it or in the opposite one, or are uneven.

    A time that is none of the even ones may be the task's; else its row belongs where one is lacking. With such a row most others
    must be moved: otherwise the order of the file is likelier.
    """
    count, known = len(times), sorted(filter(math.isfinite, times))
    if len(known) < _FEWEST or all(target == place for place, target in enumerate(targets)):
        return ()
    off = sorted(time for time, target in zip(times, targets, strict=True) if target is None and math.isfinite(time))
    steps = [(known[-1] - known[0]) / (count - 1), *(_usual_step(some) for some in (known, off) if some[1:])]
    tried = [
        _put_in_places(_by_time([time - begin for time in times], 0.0, replace(grid, step=step, rows=count), step), targets)
        for step in steps
        if step > _SHORTEST * grid.step
        for begin in (known[0], 0.0, step, known[-1] - (count - 1) * step)
    ]
    order, left = min(tried, key=lambda found: found[1], default=([], 0))
    moved = sum(row != place for place, row in enumerate(order))
    back = sum(row == count - 1 - place for place, row in enumerate(order))
    return tuple(order) if moved and 2 * back <= count and (not left or 2 * moved > count) else ()


def _usual_step(times: Sequence[float]) -> float:
    """Return the mean of the steps that are near the median of all."""
    steps = [later - earlier for earlier, later in pairwise(times)]
    middle = median_low(steps)
    return fmean(step for step in steps if abs(step - middle) <= _USUAL * middle)


def _put_in_places(own: Sequence[int | None], targets: Sequence[int | None]) -> tuple[list[int], int]:
    """Return the rows of a file in their `own` places, else in those by the task's times, and how many have neither.

    Of several rows with one own place, that which the task's time puts where none is moves, above all if it stands there already.
    """
    places = range(len(own))
    lacking = {*places} - {*own}
    left = sorted(places, key=lambda row: (targets[row] in lacking, targets[row] == row))
    rows: dict[int, int] = {}
    for wanted in (own, targets):
        for row in left:
            if (place := wanted[row]) is not None and place in places:
                rows.setdefault(place, row)
        left = sorted({*left} - {*rows.values()})
    rest = iter(left)
    return [rows[place] if place in rows else next(rest) for place in places], len(left)


def _own_step(times: Sequence[float], grid: Grid) -> tuple[tuple[int, ...], float]:
    """Return the file's rows in the order of time and their own time step; () and 0 if it is uneven or equals the grid's.

    Times that are the task's instead, each of a row that is lacking otherwise, were put right one by one.
    """
    order = sorted((time, place) for place, time in enumerate(times) if math.isfinite(time))
    if len(order) < _FEWEST:
        return (), 0.0
    step = (order[-1][0] - order[0][0]) / (len(order) - 1)
    even = all(abs(time - number * step) < _NEAR * step for number, (time, _) in enumerate(order))
    rows = [place for _, place in order]
    if not even:
        step = _usual_step([time for time, _ in order])
        by_step = _by_time(times, 0.0, replace(grid, step=step, rows=len(times)), step) if step > _SHORTEST * grid.step else []
        rows, left = _put_in_places(by_step, _by_time(times, 0.0, grid, step))
        even = bool(rows) and not left
    return (tuple(rows), step) if even and step > 0 and abs(step / grid.step - 1) >= _OTHER else ((), 0.0)


def _time_unit(head: str, cells: Sequence[PrintedNumber], grid: Grid) -> str:
    """Return "s" or "ms": from the head, else from the ratio of the printed time step to the grid's."""
    if head in PRINTED["s"]:
        return head
    values = [cell.value for cell in cells if cell.is_number]
    steps = sorted(later - earlier for earlier, later in pairwise(sorted(values)) if later > earlier)
    return "ms" if steps and 0.8 < steps[len(steps) // 2] / (1000 * grid.step) < 1.25 else "s"


def _times(cells: Sequence[PrintedNumber], factor: float) -> tuple[list[float], int]:
    """Return the times of the rows in s and how many were restored: spoilt ones follow from the even steps of the others."""
    times = [cell.value * factor if cell.is_number else math.nan for cell in cells]
    known = [(place, time) for place, time in enumerate(times) if math.isfinite(time)]
    spoilt = [place for place, cell in enumerate(cells) if cell.flag in {"date", "error", "formula", "missing"}]
    if not spoilt or len(known) < 2:
        return times, 0
    (first, start), (last, end) = known[0], known[-1]
    step = (end - start) / (last - first)
    if step and all(abs(start + (place - first) * step - time) <= _NEAR * abs(step) for place, time in known):
        return [start + (place - first) * step if math.isnan(time) else time for place, time in enumerate(times)], len(spoilt)
    return times, 0


def _by_time(times: Sequence[float], unit: float, grid: Grid, own_step: float) -> list[int | None]:
    """Return the row of the grid for each time, None if it is near none.  Times printed coarser than half a step count in order.

    If the student's own step is shorter than the grid's, the tolerance is a share of that step, so that no other row is nearer.
    """
    in_order = unit > 0.5 * grid.step and len(times) <= grid.rows
    if in_order and all(abs(time - place * grid.step) <= 0.51 * unit + _NEAR * grid.step for place, time in enumerate(times)):
        return list(range(len(times)))
    rows: list[int | None] = []
    most = _NEAR * min(grid.step, own_step or grid.step)
    for time in times:
        # Compare before rounding, because a time may be as large as a float can be.
        near = math.isfinite(time) and -0.5 < time / grid.step < grid.rows
        place = round(time / grid.step) if near else -1
        rows.append(place if 0 <= place < grid.rows and abs(time - place * grid.step) < most else None)
    return rows


def _row_numbers(layout: Layout, at: int) -> list[int]:
    """Return the rows (from 0) that a column of row numbers gives, [] if the column has no row numbers."""
    values = [row[at].value for row in layout.body]
    if not all(math.isfinite(value) and value == math.floor(value) and 0 <= value < 10**6 for value in values):
        return []
    numbers = [int(value) for value in values]
    start = min(numbers)
    return [number - start for number in numbers] if start in {0, 1} and len(set(numbers)) == len(numbers) else []


def _unique(layout: Layout, places: Places, targets: list[int | None], rows: int) -> tuple[tuple[int | None, ...], int]:
    """Return the file's row for each row of the grid, of several the first; and the first row (from 1) for which two differ."""
    columns = [place.at for name, place in places.places.items() if name not in {TIME, INDEX}]
    of_grid: list[int | None] = [None] * rows
    twice = 0
    for place, target in enumerate(targets):
        if target is None:
            continue
        first = of_grid[target]
        if first is None:
            of_grid[target] = place
        elif any(_contradict(layout.body[first][at], layout.body[place][at]) for at in columns):
            twice = twice or target + 1
    return tuple(of_grid), twice


def _contradict(first: PrintedNumber, second: PrintedNumber) -> bool:
    return (first.value, first.flag) != (second.value, second.flag) and (first.is_number or second.is_number)
