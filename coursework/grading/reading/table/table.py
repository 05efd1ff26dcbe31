"""Parts of tables -> the student's tables on the assigned grid, with a record of how each was read.

Enters: `Part`s, the `Grid`.  Leaves: `Table`s, or `Refused` with the reason.
Used by `tables_of_file.py`, `read_document.py` and `read_submission.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from statistics import median_low
from typing import Any

from coursework.grading.reading.expected import Grid, GridColumn
from coursework.grading.reading.limits import Refused, unreadable
from coursework.grading.reading.numbers import NOTHING, PrintedNumber
from coursework.grading.reading.student_work import OwnTimes, Reading, Table, TableColumn
from coursework.grading.reading.submission import Note, note
from coursework.grading.reading.table.columns import Place, Places, find_columns
from coursework.grading.reading.table.digits import last_places
from coursework.grading.reading.table.headers import INDEX, TIME
from coursework.grading.reading.table.layout import Layout
from coursework.grading.reading.table.parts import Part, joined
from coursework.grading.reading.table.rows import Rows, in_order, place_rows
from coursework.grading.reading.table.units import factor_of, stands_beside, turns_of_jumps, units_of_columns, whole_turns
from coursework.words.sentences import ranges, say

_UNCOMPUTED = 0.2  # of the cells: above this share of formulas without a value a file is refused
_STEADY = 0.9  # least share of numbers in equal steps in the column of a drive: a few may be slips
_MANY = 5  # fewer numbers than this may end in the same zeros by chance


def read_parts(parts: Sequence[Part], grid: Grid) -> list[tuple[Part, Table | Refused]]:
    """Return the whole tables that the parts make, each read on the grid or with the reason why it is refused."""
    return [(part, _read(part, grid)) for part in joined(parts, grid) if _is_table(part.layout)]


def _read(part: Part, grid: Grid) -> Table | Refused:
    try:
        return _table(part, grid)
    except Refused as refused:
        return refused


def weight(part: Part, read: Table | Refused, grid: Grid) -> float:
    """Return the weight of a table; a refused one counts its cells, those without a head of the task as a quarter."""
    if isinstance(read, Table):
        return read.weight
    named = {*part.names(grid).values()}
    return sum(
        1.0 if at in named else 0.25
        for row in part.layout.body[: grid.rows]
        for at, cell in enumerate(row)
        if cell.stands_for_number
    )


def _is_table(layout: Layout) -> bool:
    """Return whether there are at least three columns of numbers, or two if the table has heads."""
    filled = sum(any(row[at].stands_for_number for row in layout.body) for at in range(len(layout.heads)))
    return filled >= (2 if layout.has_heads else 3)


def _table(part: Part, grid: Grid) -> Table:
    layout = part.layout
    standing = [cell for row in layout.body for cell in row if cell.stands_for_number]
    uncomputed = sum(cell.flag == "formula" for cell in standing)
    if uncomputed > _UNCOMPUTED * len(standing):
        raise unreadable("formulas", cells=uncomputed)
    places = find_columns(layout, grid)
    rows = place_rows(layout, places, grid)
    other = _in_order(part, grid, places, rows) if rows.off_grid else None
    if any(row is not None for row in rows.of_grid):
        found = {name: [row[place.at].flag for row in layout.body] for name, place in places.places.items() if name != INDEX}
        empty = tuple(name for name, flags in found.items() if "formula" in flags)
        unsure = say("reading.trouble.formulas_in", names=empty, cells=uncomputed) if empty else None
        unsure = say("reading.trouble.two_rows", row=rows.twice) if rows.twice else unsure
        return replace(_placed(part, grid, places, rows), in_order=other, unsure=unsure)
    if other is None or len(layout.body) != grid.rows:
        raise unreadable("no_rows", step=grid.step, rows=grid.rows)
    return other


def _in_order(part: Part, grid: Grid, places: Places, rows: Rows) -> Table:
    """Return the table with its rows in the order of the file: nothing but its times may be wrong."""
    assert rows.off_grid
    found, (row, time) = _placed(part, grid, places, in_order(rows, len(part.layout.body))), rows.off_grid
    told = note("data_differ", "times_differ", row=row + 1, found=time, expected=row * grid.step)
    return replace(found, notes=(told, *found.notes))


def _placed(part: Part, grid: Grid, places: Places, rows: Rows) -> Table:
    layout, origin = part.layout, part.origin
    read = _columns(grid, places, layout, rows)
    read = sorted(map(partial(_like_others, read, layout, grid), read), key=lambda column: column.at)
    read, zeros = _without_zeros(read, layout, grid)
    units: dict[str, dict[str, Any]] = {column.name: {"at": column.at, "by": column.by, "unit": column.unit} for column in read}
    if TIME in places.places:
        time = places.places[TIME]
        units = {TIME: {"at": time.at + 1, "by": time.by, "unit": rows.time_unit}} | units
    order = "sorted" if rows.is_sorted else "given"
    reading = Reading(
        origin.file, origin.encoding, origin.separator, layout.decimal, part.sheet, layout.transposed,
        tuple(head.text for head in layout.heads) if layout.has_heads else (), units, len(layout.body), order,  # type: ignore[arg-type]
    )  # fmt: skip
    numbers = tuple(0 if row is None else row + 1 for row in rows.of_grid)
    notes = origin.notes + tuple(_notes(layout, places, rows, read, grid))
    if zeros:
        notes += (note("coarse_work", decimals=max(column.decimals for column in read if not _is_steady(column))),)
    own = _own_times(grid, places, layout, rows, read) if rows.own else None
    return Table(
        reading,
        tuple(read),
        numbers,
        notes,
        own,
        origin.place,
        strange=sum(_strange(column, layout) for column in read),
        asked=places.asked,
        is_cut=layout.is_cut and (None in rows.of_grid or len(read) < len(grid.columns)),
    )


def _strange(column: TableColumn, layout: Layout) -> int:
    """Return how many numbers of a column are read by position although its head has a word that names something else."""
    head = layout.heads[column.at - 1]
    text = head.text if layout.has_heads else layout.above[column.at - 1]
    is_strange = column.by == "position" and not head.candidates and any(map(str.isalpha, text))
    return sum(map(math.isfinite, column.values)) if is_strange else 0


def _own_times(grid: Grid, places: Places, layout: Layout, rows: Rows, read: Sequence[TableColumn]) -> OwnTimes:
    """Return all rows of a table with its own time step, with the units and turns found for its columns."""
    columns, of_task = {}, {column.name: column for column in grid.columns}
    for column in read:
        cells = [layout.body[row][places.places[column.name].at] for row in rows.own]
        factor, beside = factor_of(of_task[column.name], column.unit), column.turns[0] if column.turns else 0
        whole = [cell.value * factor for cell in cells]
        jumps = turns_of_jumps(whole) if len({*column.turns}) > 1 else [0] * len(whole)
        values = tuple(value - 2 * math.pi * (beside + turns) for value, turns in zip(whole, jumps, strict=True))
        one = set(column.last_place)  # with one unit for all cells, the zeros that a steady drive dropped are counted in it
        known = one.pop() if len(one) == 1 else math.inf
        columns[column.name] = values, tuple(min(step * factor, known) for step in last_places(cells)[1])
    return OwnTimes(rows.own_step, columns)


def _columns(grid: Grid, places: Places, layout: Layout, rows: Rows) -> list[TableColumn]:
    there = {column.name: places.places[column.name] for column in grid.columns if column.name in places.places}
    cells = {
        name: [NOTHING if row is None else layout.body[row][place.at] for row in rows.of_grid] for name, place in there.items()
    }
    heads = {name: layout.heads[place.at].unit for name, place in there.items()}
    units = units_of_columns(grid, heads, {name: [cell.value for cell in found] for name, found in cells.items()})
    factors = {column.name: factor_of(column, units[column.name]) for column in grid.columns if column.name in there}

    def column_of(column: GridColumn) -> TableColumn:
        rates = cells.get(column.rate, [])[:-1]
        moves = [grid.step * factors[column.rate] * rate.value for rate in rates]
        return _column(column, there[column.name], cells[column.name], units[column.name], moves)

    return [column_of(column) for column in grid.columns if column.name in there]


def _column(column: GridColumn, place: Place, cells: list[PrintedNumber], unit: str, moves: Sequence[float]) -> TableColumn:
    decimals, steps = last_places(cells)
    factor = factor_of(column, unit)
    values = [cell.value * factor for cell in cells]
    turns = whole_turns(column, values, moves)
    return TableColumn(
        column.name, place.at + 1, place.by, unit,
        tuple(value - 2 * math.pi * off for value, off in zip(values, turns or [0] * len(values), strict=True)),
        tuple(step * factor for step in steps),
        tuple(cell.text for cell in cells), tuple(cell.flag for cell in cells), decimals, turns,
    )  # fmt: skip


def _like_others(columns: list[TableColumn], layout: Layout, grid: Grid, column: TableColumn) -> TableColumn:
    """Return a column in exactly equal steps (a steady drive, whose zeros were dropped) with the digits of the other columns.

    So is one whose key drops as many zeros: slips and rows that stand twice break its steps. A column of one constant fraction
    gets them only if other columns dropped zeros and it has fewer digits than they have.
    """
    others = [other for other in columns if other is not column]
    known = [value for value in column.values if math.isfinite(value)]
    if not others or not known or len(set(column.last_place)) > 1:
        return column
    is_plain = column.decimals == 0 or known[0] != known[-1]
    digits = max(_digits(layout, other) for other in others)
    is_short = any(_drops_zeros(layout, other) for other in others) and _digits(layout, column) < digits
    if all(len(set(other.last_place)) == 1 for other in others):
        decimals = max([other.decimals for other in others if other.unit == column.unit] or [other.decimals for other in others])
    else:
        is_plain, first = False, layout.body[0][column.at - 1]
        decimals = column.decimals + digits - first.digits
    if decimals <= column.decimals or not (is_plain or is_short):
        return column
    if not _is_steady(column) and not _ends_in(grid, replace(column, decimals=decimals), decimals - column.decimals):
        return column
    finer = 10.0 ** (column.decimals - decimals)
    return replace(column, decimals=decimals, last_place=tuple(step * finer for step in column.last_place))


def _without_zeros(columns: list[TableColumn], layout: Layout, grid: Grid) -> tuple[list[TableColumn], int]:
    """Return the columns with fewer decimals if all their numbers end in zeros, and how many zeros: these show no accuracy.

    A student who rounds at each step but prints more decimals has such zeros below the start; a column in equal steps may have
    them anyway, and so may one whose key has as many.
    """
    found = {column.name: _zeros(_numbers(layout, column, first=1)) for column in columns if not _is_steady(column)}
    uneven = [column for column in columns if (told := found.get(column.name)) is not None and not _ends_in(grid, column, told)]
    zeros = min((found[column.name] for column in uneven), default=0)
    coarser = 10.0**zeros
    return [
        replace(column, decimals=column.decimals - zeros, last_place=tuple(step * coarser for step in column.last_place))
        if zeros and column in uneven else column
        for column in columns
    ], zeros  # fmt: skip


def _ends_in(grid: Grid, column: TableColumn, zeros: int) -> bool:
    """Return whether the key's values below the start end in so many zeros (at least one) when printed as a column is."""
    key = next(one for one in grid.columns if one.name == column.name)
    shown = (round(value / factor_of(key, column.unit) * 10.0**column.decimals) for value in key.values[1:])
    return zeros > 0 and all(value % 10**zeros == 0 for value in shown)


def _zeros(numbers: list[PrintedNumber]) -> int:
    """Return how many trailing zeros after the decimal mark all numbers have, 0 if there are fewer than `_MANY` numbers."""
    if len(numbers) < _MANY:
        return 0
    found = 0
    while all(-cell.place > found and round(cell.value * 10.0**-cell.place) % 10 ** (found + 1) == 0 for cell in numbers):
        found += 1
    return found


def _numbers(layout: Layout, column: TableColumn, first: int = 0) -> list[PrintedNumber]:
    cells = [row[column.at - 1] for row in layout.body[first:]]
    return [cell for cell in cells if cell.is_number and cell.value]


def _digits(layout: Layout, column: TableColumn) -> int:
    """Return the greatest number of significant digits in a column."""
    return max((cell.digits for cell in _numbers(layout, column)), default=0)


def _drops_zeros(layout: Layout, column: TableColumn) -> bool:
    """Return whether the cells of a column have different numbers of decimals."""
    return len({cell.place for cell in _numbers(layout, column)}) > 1


def _is_steady(column: TableColumn) -> bool:
    """Return whether a column has exactly equal steps or one constant value, which rounded numbers of a motion do not have.

    Rows may be missing, and a few slips are allowed.
    """
    known = [(row, value) for row, value in enumerate(column.values) if math.isfinite(value)]
    steps = [(later - earlier) / (row - before) for (before, earlier), (row, later) in pairwise(known)]
    if len(steps) < 2:
        return False
    step = median_low(steps)
    begins = [value - step * row for row, value in known]
    near = 1e-9 * max(1.0, abs(known[0][1]), abs(known[-1][1]))
    equal = sum(abs(each - step) <= near for each in steps)  # where a row was left out, the column jumps once
    in_line = sum(abs(begin - median_low(begins)) <= near for begin in begins)
    return equal >= _STEADY * len(steps) or in_line >= _STEADY * len(known)


def _notes(layout: Layout, places: Places, rows: Rows, read: list[TableColumn], grid: Grid) -> Iterator[Note]:
    """Yield notes on how the table was read, for whoever reads the page."""
    for unit, code in (("deg", "degrees"), ("deg/s", "degrees"), ("rpm", "rpm")):
        if names := tuple(column.name for column in read if column.unit == unit):
            yield note(code, "deg_s" if unit == "deg/s" else "", columns=names)
    if layout.transposed:
        yield note("transposed")
    if rows.is_sorted:
        yield note("rows_sorted")
    if missing := [place + 1 for place, row in enumerate(rows.of_grid) if row is None]:
        yield note("rows_missing", number=len(missing), rows=ranges(missing))
    if rows.extra:
        yield note("rows_extra", number=rows.extra)
    by_position = tuple(column.name for column in read if column.by == "position")
    if by_position:
        lost = [layout.heads[column.at - 1].text for column in read if column.by == "position"]
        has_lost = any(text.startswith("?") for text in lost)
        yield note("greek_lost" if has_lost else "columns_by_position", columns=by_position)
    if any(name not in {TIME, INDEX} for name in places.repeated):
        yield note("duplicate_column", columns=places.repeated)
    dates = sum(flag == "date" for column in read for flag in column.flags)
    if dates or (rows.recovered and any(row[places.places[TIME].at].flag == "date" for row in layout.body)):
        yield note("date_cell", "date_cell" if dates else "date_cell_time", number=dates or rows.recovered)
    if errors := sum(flag in {"error", "formula"} for column in read for flag in column.flags):
        yield note("error_cell", number=errors)
    keys = {column.name: column for column in grid.columns}
    for column in read:
        if column.turns and stands_beside(keys[column.name], column.values):
            yield note("turns", column=column.name, number=", ".join(map(str, sorted({*column.turns} - {0}))))
