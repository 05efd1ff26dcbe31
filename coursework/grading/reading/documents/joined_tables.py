"""A table that breaks off and goes on in the next one, as at the end of a page -> one table.

Enters: the tables of a document in order, the columns of the task.  Leaves: tables.
Two are one where the second has the same heads, or none, and its first column goes on where that of the first ends.
Used by `read_document.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from statistics import median

from coursework.grading.reading.documents.document import DocumentTable
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.numbers import looks_numeric, plain_text
from coursework.grading.reading.table.headers import read_head

_Row = tuple[Cell, ...]
_LOOKED_AT = 8  # rows in which heads are looked for, and how the time goes on
_STEP = 0.3  # of a step that rounding may take


def joined(tables: Sequence[DocumentTable], columns: Sequence[tuple[str, str]]) -> list[DocumentTable]:
    """Return the tables with those put together that are one."""
    out: list[DocumentTable] = []
    for table in tables:
        body = [row for row in table.rows if _is_body(row)] if out else []
        if body and _same_heads(out[-1].rows, table.rows, columns) and _goes_on(out[-1].rows, body):
            out[-1] = replace(out[-1], rows=(*out[-1].rows, *body))
        else:
            out.append(table)
    return out


def _is_body(row: _Row) -> bool:
    filled = [cell for cell in row if cell.text]
    numbers = sum(cell.kind != "text" or looks_numeric(cell.text) for cell in filled)
    return numbers >= 2 and 2 * numbers >= len(filled)


def _same_heads(first: Sequence[_Row], second: Sequence[_Row], columns: Sequence[tuple[str, str]]) -> bool:
    """Return whether the second table has the heads of the first, or none and as many columns."""
    heads, again = _heads(first, columns), _heads(second, columns)
    return heads == again if again else max(map(len, first)) == max(map(len, second))


def _heads(rows: Sequence[_Row], columns: Sequence[tuple[str, str]]) -> list[tuple[str, ...]]:
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
