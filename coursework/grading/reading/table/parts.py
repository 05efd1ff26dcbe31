"""Tables as they stand in a submission -> whole tables: parts of one table are joined, whatever files they are in.

Enters: sheets of cells, their origin, the `Grid`.  Leaves: `Part`s, in their order.  Raises `Refused`.
A table continues below (on another page, sheet or file, with or without repeated heads) or beside (a table of the same rows with
other columns).  Used by `table.py`, `tables_of_file.py`, `read_document.py` and `read_submission.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.limits import doubtful
from coursework.grading.reading.numbers import NOTHING, PrintedNumber, differ, looks_numeric, marks, no_number, printed, stored
from coursework.grading.reading.submission import Note
from coursework.grading.reading.table.headers import INDEX, TIME, Head
from coursework.grading.reading.table.layout import Layout, goes_on, layouts_of
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence

_Row = tuple[PrintedNumber, ...]
_MOST = 200  # most parts that are compared
_NEGATIVE = re.compile(r"\(\s*(\d[\d.,' ]*)\)")
_FEWEST = 2  # least number of rows with numbers in parentheses


@frozen
class Origin:
    """Where sheets come from: `file`, `encoding` and `separator` as in grades.json, and `notes` made while reading."""

    file: str
    encoding: str
    separator: str
    notes: tuple[Note, ...] = ()
    place: Sentence | None = None


@frozen
class Part:
    """One table as it stands in a file; `sheet` is the name of the spreadsheet's sheet, None if there is none."""

    layout: Layout
    origin: Origin
    sheet: str | None = None

    def names(self, grid: Grid) -> dict[str, int]:
        """Return the columns of the task that the heads may mean, mapped to their index in the file."""
        return {
            name: at for at, head in enumerate(self.layout.heads) for name in head.candidates or head.told if name in grid.names
        }


def parts_of(sheet: Sheet, origin: Origin, grid: Grid) -> list[Part]:
    """Return the tables of a sheet.  Raises `Refused` if its decimal mark is ambiguous."""
    mark, mixed = _decimal_mark(sheet, origin.separator)
    rows = [[_printed(cell, mark, mixed) for cell in row] for row in _with_minus(sheet.rows)]
    return [Part(layout, origin, sheet.name) for layout in layouts_of(rows, mark, grid.units)]


def _with_minus(rows: Sequence[Sequence[Cell]]) -> Sequence[Sequence[Cell]]:
    """Return the rows with "-5" for an accountant's "(5)", if numbers stand in parentheses and none has a minus.

    The first column is left alone, as times and row numbers are never negative.  A single row with parentheses is also left
    alone: these mark given values.
    """
    texts = [plain for row in rows for cell in row if (plain := cell.text.strip())]
    found = [[_NEGATIVE.fullmatch(cell.text.strip()) if at else None for at, cell in enumerate(row)] for row in rows]
    is_one_row = sum(map(any, found)) < _FEWEST
    if is_one_row or any(text[0] in "-−–‐" and looks_numeric(text) for text in texts):
        return rows
    return [
        [cell._replace(text=f"-{negative[1]}") if negative else cell for cell, negative in zip(row, here, strict=True)]
        for row, here in zip(rows, found, strict=True)
    ]


def _printed(cell: Cell, mark: str, mixed: bool) -> PrintedNumber:
    if cell.kind == "number":
        return stored(cell.text)
    if cell.kind == "text":
        return printed(cell.text, mark, mixed)
    return no_number(cell.text, cell.kind)


def _decimal_mark(sheet: Sheet, separator: str) -> tuple[str, bool]:
    """Return the decimal mark of a whole sheet and whether it uses both marks; a number such as 1,234 alone never decides.

    Raises `Refused` if both marks occur equally often, or if every number could be read in two ways.
    """
    texts = [cell.text for row in sheet.rows for cell in row if cell.kind == "text" and looks_numeric(cell.text)]
    comma, point, either_comma, either_point = marks(texts)
    if comma != point:
        return ("," if comma > point else "."), comma > 0 and point > 0
    if comma:
        raise doubtful("two_marks", cells=comma)
    if either_comma and separator == ";" and not either_point:
        return ",", False  # programs separate by semicolons because the comma is the decimal mark
    if either_comma:
        raise doubtful("thousands", cells=either_comma)
    return ".", False


def joined(parts: Sequence[Part], grid: Grid) -> list[Part]:
    """Return the tables, with the parts of one table joined; tables of a single row are dropped."""
    rows: list[Part] = []
    for part in parts[:_MOST]:
        for place in reversed(range(len(rows))):
            is_next = part.layout.has_heads or place == len(rows) - 1
            if is_next and (whole := _below(rows[place], part, grid) or _below(part, rows[place], grid)):
                rows[place] = whole
                break
        else:
            rows.append(part)
    out: list[Part] = []
    for part in rows:
        for place, first in enumerate(out):  # take the first that fits: the parts of two schemes' tables have the same order
            if whole := _beside(first, part, grid):
                out[place] = whole
                break
        else:
            out.append(part)
    return [part for part in out if len(part.layout.body) > 1]


def _below(first: Part, second: Part, grid: Grid) -> Part | None:
    """Return a table with the rows of the second below its own, None if they are not parts of one table.

    Both must have the same heads, or the second none and as many columns; it must begin where the first ends.
    """
    above, below = first.layout, second.layout
    alike = _said(above) == _said(below) if below.has_heads else len(above.heads) == len(below.heads)
    counted = len(above.body) + len(below.body) <= grid.rows and not above.keys and below.has_heads
    if not alike or above.transposed != below.transposed or not (goes_on(above, below) or counted):
        return None
    return _whole(first, second, above.heads, above.body + below.body)


def _said(layout: Layout) -> list[tuple[str, ...]]:
    return [head.candidates or head.told or (head.text,) for head in layout.heads]


def _beside(first: Part, second: Part, grid: Grid) -> Part | None:
    """Return a table with the columns that only the second has to the right of its own, None if they are not parts of one table.

    They must hold different columns of the task in the same rows, and the columns that both have must agree.
    """
    names, others = first.names(grid), second.names(grid)
    added = others.keys() - names.keys()
    if not added or not names.keys() - others.keys():
        return None
    pairs = _pairs(first.layout, second.layout)
    if pairs is None:
        return _beside(second, first, grid) if _pairs(second.layout, first.layout) else None
    shared = [(names[name], others[name]) for name in names.keys() & others.keys()]
    if any(other and differ(row[at], other[place]) for row, other in pairs for at, place in shared):
        return None
    kept = [
        at for at, head in enumerate(second.layout.heads) if not (meant := {*head.candidates} or {*head.told}) or added & meant
    ]
    body = tuple((*row, *(other[at] if other else NOTHING for at in kept)) for row, other in pairs)
    return _whole(first, second, (*first.layout.heads, *(second.layout.heads[at] for at in kept)), body)


def _pairs(first: Layout, second: Layout) -> list[tuple[_Row, _Row]] | None:
    """Pair each row of the first table with the row of the second, () if it lacks it; None if their rows are not the same.

    Rows are matched by time, else by row number, or by their order if the second table has neither.
    """
    for name in (TIME, INDEX):
        rows, others = _by(first, name), _by(second, name)
        if others and others.keys() <= rows.keys() and 2 * len(others) >= len(rows):
            return [(row, others.get(number, ())) for number, row in rows.items()]
    if second.keys or len(first.body) != len(second.body):
        return None
    return [*zip(first.body, second.body, strict=True)]


def _by(layout: Layout, name: str) -> dict[float, _Row]:
    """Return the rows by their time or row number, empty if a row has none or two rows have the same."""
    at = layout.keys.get(name)
    found = {} if at is None else {row[at].value: row for row in layout.body if row[at].is_number}
    return found if len(found) == len(layout.body) else {}


def _whole(first: Part, second: Part, heads: Sequence[Head], body: Sequence[_Row]) -> Part:
    origin, other = first.origin, second.origin
    notes = (*origin.notes, *(one for one in other.notes if one not in origin.notes))
    separator = origin.separator if origin.separator == other.separator else "cells"
    encoding, file = _both(origin.encoding, other.encoding), _both(origin.file, other.file)
    origin = replace(origin, file=file, encoding=encoding, separator=separator, notes=notes)
    sheet = _both(first.sheet, second.sheet) if first.sheet and second.sheet else first.sheet
    return Part(replace(first.layout, heads=tuple(heads), body=tuple(body)), origin, sheet)


def _both(first: str, second: str) -> str:
    return first if second in first.split(" + ") else f"{first} + {second}"
