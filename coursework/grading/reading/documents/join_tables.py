"""The tables of a document -> those put together that are one.

Enters: tables as they stand in a document, names and units of the task's columns.  Leaves: `DocumentTable`s, in their order.
A table goes on below (over pages, with its heads or without), on its right (the rows in two blocks beside each other), or in
another table of the same rows (the columns in blocks).  Used by `read_document.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise, takewhile
from statistics import median

from coursework.grading.reading.documents.document import DocumentTable
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.numbers import looks_numeric, plain_text
from coursework.grading.reading.table.headers import INDEX, TIME, read_head

_Row = tuple[Cell, ...]
_Columns = Sequence[tuple[str, str]]
_LOOKED_AT = 8  # rows in which heads are looked for, and how the time goes on
_STEP = 0.3  # of a step that rounding may take


@dataclass(frozen=True)
class _Part:
    """A table with what its heads mean, nothing where no row names two columns."""

    table: DocumentTable
    columns: _Columns

    @cached_property
    def heads(self) -> list[tuple[str, ...]]:
        return _heads(self.table.rows, self.columns)

    @cached_property
    def names(self) -> set[str]:
        """Return the columns of the task that heads may mean."""
        return {name for head in self.heads for name in head} & {name for name, _ in self.columns}

    @cached_property
    def body(self) -> list[_Row]:
        return [row for row in self.table.rows if _is_body(row)]

    @cached_property
    def keys(self) -> dict[str, dict[float, _Row]]:
        """Return the rows by their time and by their number, where each has one of its own."""
        found = {}
        for key in (TIME, INDEX):
            place = next((at for at, head in enumerate(self.heads) if key in head), None)
            rows = {} if place is None else {number: row for row in self.body for number in _number(row, place)[:1]}
            if len(rows) > 1 and len(rows) == len(self.body):
                found[key] = rows
        return found


def joined(tables: Sequence[DocumentTable], columns: _Columns) -> list[DocumentTable]:
    """Return the tables with those put together that are one."""
    out: list[_Part] = []
    for part in (
        _Part(block, columns) for table in tables for lower in _stacked(table, columns) for block in _blocks(lower, columns)
    ):
        for place in reversed(range(len(out))):
            first = out[place]
            if (part.heads or place == len(out) - 1) and _is_rest(first, part):
                out[place] = _Part(replace(first.table, rows=(*first.table.rows, *part.body)), columns)
                break
        else:
            out.append(part)
    whole: list[_Part] = []
    for part in out:
        for place, first in enumerate(whole):  # the first that fits: tables of two schemes stand in one order
            if rows := _beside(first, part):
                whole[place] = _Part(replace(first.table, rows=rows), columns)
                break
        else:
            whole.append(part)
    return [part.table for part in whole]


def _is_rest(first: _Part, part: _Part) -> bool:
    """Return whether a table goes on in another: with the same heads, or none and as many columns, one step later."""
    is_alike = first.heads == part.heads if part.heads else max(map(len, first.table.rows)) == max(map(len, part.table.rows))
    return is_alike and bool(part.body) and _goes_on(first.table.rows, part.body)


def _stacked(table: DocumentTable, columns: _Columns) -> list[DocumentTable]:
    """Return a table in which other heads stand below the first rows as the tables that it is made of."""
    starts, heads = [0], _heads(table.rows, columns)
    for at, row in enumerate(table.rows):
        if heads and at > starts[-1] and not _is_body(row) and _is_body(table.rows[at - 1]):
            again = _heads((row,), columns)
            if again and again != heads:
                starts, heads = [*starts, at], again
    return [replace(table, rows=table.rows[start:end]) for start, end in pairwise((*starts, len(table.rows)))]


def _blocks(table: DocumentTable, columns: _Columns) -> list[DocumentTable]:
    """Return a table whose rows go on on the right, under the same heads once more, as the parts that it is made of."""
    heads = _heads(table.rows, columns)
    if not heads or not {TIME, INDEX} & {*heads[0]}:
        return [table]
    starts = [at for at, head in enumerate(heads) if head == heads[0]]
    ends = [max(at for at in range(start, end) if heads[at]) + 1 for start, end in pairwise((*starts, len(heads)))]
    spans = list(zip(starts, ends, strict=True))
    if len(spans) < 2 or any(heads[start:end] != heads[: ends[0]] for start, end in spans):
        return [table]
    blocks = [replace(table, rows=tuple(row[start:end] for row in table.rows)) for start, end in spans]
    goes_on = all(_goes_on(first.rows, [row for row in second.rows if _is_body(row)]) for first, second in pairwise(blocks))
    return blocks if goes_on else [table]


def _beside(first: _Part, second: _Part) -> tuple[_Row, ...] | None:
    """Return the rows of two tables that hold different columns of the task in the same rows, None for any others."""
    if not first.names or not second.names or first.names & second.names:
        return None
    for key in (TIME, INDEX):
        longer, other = first.keys.get(key, {}), second.keys.get(key, {})
        if len(longer) < len(other):
            first, second, longer, other = second, first, other, longer
        if other and other.keys() <= longer.keys() and 2 * len(other) >= len(longer):
            break
    else:
        return None
    width = max(map(len, first.table.rows))
    kept = [at for at, head in enumerate(second.heads) if not {TIME, INDEX} & {*head}]
    above, heads = (list(takewhile(lambda row: not _is_body(row), part.table.rows)) for part in (first, second))
    lines = max(len(above), len(heads))
    above, heads = ([()] * (lines - len(rows)) + rows for rows in (above, heads))
    pairs = [*zip(above, heads, strict=True), *((row, other.get(number, ())) for number, row in longer.items())]
    return tuple((*_filled(row, range(width)), *_filled(more, kept)) for row, more in pairs)


def _filled(row: _Row, places: Sequence[int]) -> _Row:
    """Return the cells of a row in some columns, blank ones where it is shorter."""
    return tuple(row[at] if at < len(row) else Cell("") for at in places)


def _is_body(row: _Row) -> bool:
    filled = [cell for cell in row if cell.text]
    numbers = sum(cell.kind != "text" or looks_numeric(cell.text) for cell in filled)
    return numbers >= 2 and 2 * numbers >= len(filled)


def _heads(rows: Sequence[_Row], columns: _Columns) -> list[tuple[str, ...]]:
    """Return what the heads of a table mean, nothing where no row names two columns."""
    for row in rows[:_LOOKED_AT]:
        if not _is_body(row):
            named = [read_head(cell.text, columns).candidates for cell in row]
            if sum(map(bool, named)) > 1:
                return named
    return []


def _goes_on(first: Sequence[_Row], second: Sequence[_Row]) -> bool:
    """Return whether one of the first two columns rises in steps and the second table begins one step after the first ends."""
    for place in (0, 1):
        before = [value for row in first[-_LOOKED_AT:] if _is_body(row) for value in _number(row, place)]
        after = [value for row in second[:_LOOKED_AT] for value in _number(row, place)]
        steps = [later - earlier for numbers in (before, after) for earlier, later in pairwise(numbers)]
        if not before or not after or not steps:
            continue
        step = median(steps)
        if step > 0 and abs(after[0] - before[-1] - step) <= _STEP * step:
            return True
    return False


def _number(row: _Row, place: int) -> list[float]:
    text = plain_text(row[place].text).replace(",", ".") if place < len(row) else ""
    return [float(text)] if looks_numeric(text) and len(text) < 20 and text.count(".") < 2 and " " not in text else []
