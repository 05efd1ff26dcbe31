"""Rows of cells -> the block of numbers in them, its heads, and which way it lies.

Enters: a `Sheet`, its decimal mark, the columns of the task.  Leaves: `Layout`, or None where there is no table.
Used by `table.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from coursework.grading.reading.files.cells import Cell, Sheet
from coursework.grading.reading.files.separators import is_progression
from coursework.grading.reading.limits import doubtful
from coursework.grading.reading.numbers import PrintedNumber, looks_numeric, marks, printed, stored
from coursework.grading.reading.table.headers import TIME, Head, read_head
from coursework.grading.reading.unit_names import unit_of
from coursework.system.frozen import frozen

_SEARCHED = 60  # rows in which the heads are looked for
_FIRST = 6  # columns in which the heads of a transposed table are looked for
_FEWEST = 3  # rows that show how rows are counted
_Rows = list[list[PrintedNumber]]


@frozen
class Layout:
    """Heads (one a column of the file, empty where there are none) and the rows of numbers below them.

    `above` is the row over the first of numbers where there are no heads: what stands there names something else.
    """

    heads: tuple[Head, ...]
    has_heads: bool
    body: tuple[tuple[PrintedNumber, ...], ...]
    transposed: bool
    decimal: str
    above: tuple[str, ...] = ()


def lay_out(sheet: Sheet, separator: str, columns: Sequence[tuple[str, str]]) -> Layout | None:
    """Return the table of a sheet; raises `Refused` where its decimal mark cannot be told."""
    mark, mixed = _decimal_mark(sheet, separator)
    rows = [[_printed(cell, mark, mixed) for cell in row] for row in sheet.rows]
    width = max(map(len, rows), default=0)
    if width < 2:
        return None
    upright = _heads_in(rows[:_SEARCHED], columns)
    turned = [list(column) for column in zip(*(_padded(row, width) for row in rows), strict=True)]
    lying = _heads_in(turned[:_FIRST], columns)
    if lying[1] > max(upright[1], 1) or (not upright[1] and _lies(rows, turned, len(columns))):
        block = _block(turned, lying[0] if lying[1] else -1, columns, True, mark)
        standing = _upright(rows, upright[0], columns, mark) if upright[1] else None
        return standing if standing and (not block or len(block.body) < len(standing.body)) else block
    return _upright(rows, upright[0] if upright[1] else -1, columns, mark)


def _upright(rows: _Rows, head: int, columns: Sequence[tuple[str, str]], mark: str) -> Layout | None:
    return _block(_with_blank_head(rows, head) if head >= 0 else rows, head, columns, False, mark)


def _with_blank_head(rows: _Rows, head: int) -> _Rows:
    """Return the rows with a blank head first, where those below begin by counting and have one number more than heads."""
    below = [row for row in rows[head + 1 :] if len(row) == len(rows[head]) + 1 and row[-1].flag == ""]
    counted = [row[0].value for row in below]
    if len(below) < _FEWEST or counted != [counted[0] + place for place in range(len(counted))]:
        return rows
    if not is_progression([row[1].value for row in below]):  # the time itself may count
        return rows
    return [*rows[:head], [*_padded([], 1), *rows[head]], *rows[head + 1 :]]


def _printed(cell: Cell, mark: str, mixed: bool) -> PrintedNumber:
    if cell.kind == "number":
        return stored(cell.text)
    if cell.kind == "text":
        return printed(cell.text, mark, mixed)
    return PrintedNumber(cell.text, float("nan"), 0, 0, cell.kind)


def _padded(row: list[PrintedNumber], width: int) -> list[PrintedNumber]:
    return row + [PrintedNumber("", float("nan"), 0, 0, "missing")] * (width - len(row))


def _decimal_mark(sheet: Sheet, separator: str) -> tuple[str, bool]:
    """Return the decimal mark of a whole file and whether it uses both; 1,234 alone never decides.

    Raises `Refused` where every number could be read in two ways.
    """
    texts = [cell.text for row in sheet.rows for cell in row if cell.kind == "text" and looks_numeric(cell.text)]
    comma, point, either_comma, either_point = marks(texts)
    if comma != point:
        return ("," if comma > point else "."), comma > 0 and point > 0
    if comma:
        raise doubtful("two_marks", cells=comma)
    if either_comma and separator == ";" and not either_point:
        return ",", False  # programs write the semicolon because the comma is taken
    if either_comma:
        raise doubtful("thousands", cells=either_comma)
    return ".", False


def _heads_in(rows: _Rows, columns: Sequence[tuple[str, str]]) -> tuple[int, int]:
    """Return the row that names most columns, and how many; a single name is no row of heads."""
    best = (-1, 1)
    for place, row in enumerate(rows):
        texts = [cell.text for cell in row if cell.flag == "text"]
        if len(texts) > best[1]:
            heads = (read_head(text, columns) for text in texts)
            named = len({head.candidates if head.is_certain else head.text for head in heads if head.candidates})
            if named > best[1]:
                best = place, named
    return best if best[1] > 1 else (-1, 0)


def _lies(rows: _Rows, turned: _Rows, columns: int) -> bool:
    """Return whether a table without heads has its columns in rows: few rows, and the time runs along the first."""
    numeric = [row for row in rows if sum(cell.is_number for cell in row) >= 3]
    if not columns <= len(numeric) <= columns + 2 or len(turned) < 3:
        return False
    along = any(is_progression(sorted(cell.value for cell in row if cell.is_number)) for row in numeric[:2])
    down = any(is_progression(sorted(row[place].value for row in numeric if place < len(row) and row[place].is_number))
               for place in (0, 1))  # fmt: skip
    return along and not down


def _block(rows: _Rows, head: int, columns: Sequence[tuple[str, str]], transposed: bool, mark: str) -> Layout | None:
    texts = [cell.text for cell in rows[head]] if head >= 0 else []
    body: list[tuple[PrintedNumber, ...]] = []
    units: list[str] = []
    before: list[PrintedNumber] = []
    for row in rows[head + 1 :]:
        if _is_body(row):
            body.append(tuple(row))
        elif head < 0 and not body:
            before = row
        elif head >= 0 and not body and _is_units(row):
            units = [unit_of(cell.text) for cell in row]
        elif body and _heads_in([row], columns)[1] and [cell.text for cell in row] != texts:
            break  # another table begins; the same heads again are those of the next page
    width = max(map(len, body), default=0)
    if len(body) < 2 or width < 2:
        return None
    texts = _joined(texts, width)
    heads = [read_head(text, columns) for text in texts[:width]]
    heads += [Head("", (), "")] * (width - len(heads))
    units += [""] * (width - len(units))
    above = tuple(cell.text for cell in _padded(before, width))
    merged = tuple(replace(read, unit=read.unit or below) for read, below in zip(heads, units, strict=False))
    return Layout(merged, head >= 0, tuple(tuple(_padded(list(row), width)) for row in body), transposed, mark, above)


def _is_body(row: list[PrintedNumber]) -> bool:
    filled = sum(cell.flag != "missing" for cell in row)
    standing = sum(cell.stands_for_number for cell in row)
    return standing >= 2 and 2 * standing >= filled and any(cell.is_number or cell.flag == "formula" for cell in row)


def _is_units(row: list[PrintedNumber]) -> bool:
    texts = [cell.text for cell in row if cell.flag == "text"]
    return len(texts) >= 2 and 2 * sum(bool(unit_of(text)) for text in texts) >= len(texts)


def _joined(texts: list[str], width: int) -> list[str]:
    """Return the heads, each unit that a comma of its own cut off put back ("t, s,phi1, rad")."""
    while texts and not texts[-1]:
        texts = texts[:-1]
    if len(texts) <= width:
        return texts
    joined: list[str] = []
    for text in texts:
        if joined and unit_of(text) and text != TIME and "," not in joined[-1]:
            joined[-1] += f", {text}"
        else:
            joined.append(text)
    return joined
