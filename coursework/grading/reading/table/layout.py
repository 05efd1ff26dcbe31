"""Rows of cells -> the blocks of numbers in them, their heads, and whether they are transposed.

Enters: rows of cells, their decimal mark, the columns of the task.  Leaves: `Layout`s, one per table.
Used by `parts.py`, `columns.py`, `rows.py` and `table.py`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise, takewhile, zip_longest
from statistics import median

from coursework.grading.reading.files.separators import is_progression
from coursework.grading.reading.numbers import NOTHING, PrintedNumber
from coursework.grading.reading.table.headers import INDEX, TIME, Head, read_head
from coursework.grading.reading.unit_names import unit_of
from coursework.system.frozen import frozen

_SEARCHED = 60  # number of rows that are searched for heads
_FIRST = 6  # number of columns that are searched for the heads of a transposed table
_FEWEST = 3  # least number of rows that show how the rows are counted
_ROUNDED = 0.3  # of a step: the most that rounding changes it
_MORE = re.compile(r"\b\d{1,6} more rows\b|\bomitted \d{1,6} rows\b")
_DOTS = {"..", "...", "…", "⋮", "⋯"}  # of rows or columns that are left out
Rows = list[list[PrintedNumber]]
Columns = Sequence[tuple[str, str]]


@frozen
class Layout:
    """Heads (one per column of the file, empty if there are none) and the rows of numbers below them.

    `above` has the texts of the row above the numbers if there are no known heads; these texts name something else.
    """

    heads: tuple[Head, ...]
    has_heads: bool
    body: tuple[tuple[PrintedNumber, ...], ...]
    transposed: bool
    decimal: str
    above: tuple[str, ...] = ()
    is_cut: bool = False  # dots stand for rows or columns that a program did not print

    @property
    def keys(self) -> dict[str, int]:
        """Return the indices of the columns of time and row numbers, if heads name them."""
        said = {head.candidates[0]: at for at, head in reversed([*enumerate(self.heads)]) if head.is_certain}
        return {name: said[name] for name in (TIME, INDEX) if name in said}


def layouts_of(rows: Rows, mark: str, columns: Columns) -> list[Layout]:
    """Return the tables in rows of cells: one below the other with heads of their own, or side by side under repeated heads."""
    rows = _numbered(rows)
    width = max(map(len, rows), default=0)
    if width < 2:
        return []
    upright = _heads_in(rows[:_SEARCHED], columns)
    turned = [list(column) for column in zip(*(_padded(row, width) for row in rows), strict=True)]
    lying = _heads_in(turned[:_FIRST], columns)
    standing = [layout for section in _sections(rows, columns) for layout in _standing(section, mark, columns)]
    if lying[1] > max(upright[1], 1) or (not upright[1] and _lies(rows, turned, len(columns))):
        block = _block(turned, lying[0] if lying[1] else -1, columns, True, mark)
        longest = max((len(layout.body) for layout in standing if layout.has_heads), default=0)
        return _beside_each_other(block) if block and len(block.body) >= longest else standing
    return standing


def _sections(rows: Rows, columns: Columns) -> list[Rows]:
    """Split the rows where heads follow numbers: another table begins there, or the next page."""
    is_body = [*map(_is_body, rows)]
    ends = [at for at in range(1, len(rows)) if is_body[at - 1] and not is_body[at]]
    starts = [0]
    for at in ends[:_SEARCHED]:
        between = [*takewhile(lambda row: not _is_body(row), rows[at : at + _FIRST])]
        if _heads_in(between, columns)[1] or any(map(_begins_another, between)):
            starts.append(at)
    return [rows[start:end] for start, end in pairwise((*starts, len(rows)))]


def _begins_another(row: Sequence[PrintedNumber]) -> bool:
    """Return whether a row has a head of the time or the row number and others besides, perhaps none of the task."""
    texts = [cell.text for cell in row if cell.flag == "text"]
    is_keyed = len(texts) >= _FEWEST and read_head(texts[0], ()).candidates in {(TIME,), (INDEX,)}
    return is_keyed and not _is_dots(row)


def _standing(rows: Rows, mark: str, columns: Columns) -> list[Layout]:
    """Return the table of a section as the blocks it consists of, empty if it has no rows of numbers."""
    head, named = _heads_in(rows[:_SEARCHED], columns)
    block = _block(_with_blank_head(rows, head) if named else rows, head, columns, False, mark)
    return _beside_each_other(block) if block else []


def _beside_each_other(layout: Layout) -> list[Layout]:
    """Return the parts of a table that continues on the right under the same heads, or the table itself if it does not."""
    heads = [head.candidates for head in layout.heads]
    starts = [at for at, head in enumerate(heads) if head == heads[0]]
    if heads[0] not in {(TIME,), (INDEX,)} or len(starts) < 2:
        return [layout]
    ends = [max(at for at in range(start, end) if heads[at]) + 1 for start, end in pairwise((*starts, len(heads)))]
    if any(heads[start:end] != heads[: ends[0]] for start, end in zip(starts, ends, strict=True)):
        return [layout]
    blocks = [
        replace(layout, heads=layout.heads[start:end], body=tuple(cut for row in layout.body if _is_body(cut := row[start:end])))
        for start, end in zip(starts, ends, strict=True)
    ]
    return blocks if all(map(goes_on, blocks, blocks[1:])) else [layout]


def goes_on(first: Layout, second: Layout) -> bool:
    """Return whether the second table begins where the first ends: one step later, or at least one step if it has its own heads.

    With heads of its own, a page may also repeat the last row of the page before.
    """
    keys = first.keys
    for name in keys if second.has_heads else ("0", "1"):
        at, other = (keys[name], second.keys.get(name)) if second.has_heads else (int(name), int(name))
        before, after = numbers_in(first, at), numbers_in(second, other)
        steps = [later - earlier for numbers in (before, after) for earlier, later in pairwise(numbers)]
        step = median(steps) if before and after and steps and min(steps) >= 0 else 0.0
        gap = (after[0] - before[-1]) / step if step > 0 else 0.0
        if gap > 1 - _ROUNDED and (second.has_heads or gap < 1 + _ROUNDED):
            return True
        if step > 0 and abs(gap) < _ROUNDED and second.has_heads and _texts(first.body[-1]) == _texts(second.body[0]):
            return True
    return False


def _texts(row: Sequence[PrintedNumber]) -> list[str]:
    return [cell.text for cell in row]


def numbers_in(layout: Layout, at: int | None) -> list[float]:
    """Return the numbers in a column of a table, [] if it has no such column."""
    return [row[at].value for row in layout.body if at is not None and at < len(row) and row[at].is_number]


def _with_blank_head(rows: Rows, head: int) -> Rows:
    """Add a head in front of the others if the rows of numbers have one cell more: the time, or the row number before the time.

    The head is blank, or the name of the index, which pandas prints alone on the line below the heads.
    """
    below = [row for row in rows[head + 1 :] if len(row) == len(rows[head]) + 1 and row[-1].flag == ""]
    has_time = any(read_head(cell.text, ()).candidates == (TIME,) for cell in rows[head])
    counts = [row[1 if has_time else 0].value for row in below]  # the time, which follows the row numbers if it has a head
    if len(below) < _FEWEST or not is_progression(counts) or (has_time and not is_progression([row[0].value for row in below])):
        return rows
    first = rows[head + 1] if len(rows[head + 1]) == 1 else _padded([], 1)
    return [*rows[:head], [*first, *rows[head]], *rows[head + 1 :]]


def _padded(row: list[PrintedNumber], width: int) -> list[PrintedNumber]:
    return row + [NOTHING] * (width - len(row))


def _heads_in(rows: Rows, columns: Columns) -> tuple[int, int]:
    """Return the row that names most columns and how many it names, (-1, 0) if no row names two."""
    best = (-1, 1)
    for place, row in enumerate(rows):
        texts = [cell.text for cell in row if cell.flag == "text"]
        if len(texts) > best[1]:
            heads = (read_head(text, columns) for text in texts)
            named = len({head.candidates or head.told if len(head.candidates) < 2 else head.text
                         for head in heads if head.candidates or head.told})  # fmt: skip
            if named > best[1]:
                best = place, named
    return best if best[1] > 1 else (-1, 0)


def _lies(rows: Rows, turned: Rows, columns: int) -> bool:
    """Return whether a table without heads is transposed: about as many rows as the task has columns, the time along one."""
    numeric = [row for row in rows if sum(cell.is_number for cell in row) >= 3]
    if not columns <= len(numeric) <= columns + 2 or len(turned) < 3:
        return False
    along = any(is_progression(sorted(cell.value for cell in row if cell.is_number)) for row in numeric[:2])
    down = any(is_progression(sorted(row[place].value for row in numeric if row[place].is_number)) for place in (0, 1))
    return along and not down


def _block(rows: Rows, head: int, columns: Columns, transposed: bool, mark: str) -> Layout | None:
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
    if not body:
        return None
    width = max(map(len, body))
    texts = _joined(texts, width, {name for name, _ in columns})
    heads = [read_head(text, columns) for text in texts[:width]]
    heads += [Head("", (), "")] * (width - len(heads))
    units += [""] * (width - len(units))
    above = tuple(cell.text for cell in _padded(before, width))
    is_cut = any(text.strip() in _DOTS for text in texts) or any(map(_is_dots, rows))
    merged = tuple(replace(read, unit=read.unit or below) for read, below in zip(heads, units, strict=False))
    return Layout(merged, head >= 0, tuple(tuple(_padded(list(row), width)) for row in body), transposed, mark, above, is_cut)


def _is_dots(row: Sequence[PrintedNumber]) -> bool:
    """Return whether a row stands for rows that were not printed: nothing but dots, in two cells at least, or R's words."""
    texts = [cell.text.strip() for cell in row if cell.text.strip()]
    return (len(texts) > 1 and _DOTS.issuperset(texts)) or _MORE.search(" ".join(texts)) is not None


def _is_body(row: Sequence[PrintedNumber]) -> bool:
    filled = sum(cell.flag != "missing" for cell in row)
    standing = sum(cell.stands_for_number for cell in row)
    return standing >= 2 and 2 * standing >= filled and any(cell.is_number or cell.flag == "formula" for cell in row)


def _is_numbering(row: Sequence[PrintedNumber]) -> bool:
    """Return whether a row only numbers the columns from 0 or 1, perhaps starting again under each head."""
    values = [cell.value for cell in row[1:] if cell.text]
    steps = [later - earlier for earlier, later in pairwise(values)]
    return (
        len(steps) > 0 and not row[0].text and values[0] in {0, 1} and all(step == 1 or step < 0 for step in steps) and 1 in steps
    )


def _numbered(rows: Rows) -> Rows:
    """Return the rows without those that number the columns; their numbers are added to the heads that span these columns."""
    out: Rows = []
    for row in rows:
        heads = out[-1] if out and any(cell.flag == "text" for cell in out[-1]) and not _is_body(out[-1]) else []
        heads = _padded(heads, len(row))
        # A head merged with the cell below it is repeated there.
        below = [cell._replace(text="") if cell.text == head.text else cell for head, cell in zip(heads, row, strict=False)]
        if not _is_numbering(below):
            out.append(row)
        elif any(head.text for head in heads):
            out[-1] = _with_numbers(heads, below)
    return out


def _with_numbers(heads: list[PrintedNumber], row: Sequence[PrintedNumber]) -> list[PrintedNumber]:
    """Return the heads with the number of each column put before the unit; a head applies to all columns up to the next head."""
    found: list[PrintedNumber] = []
    over = ""
    for cell, number in zip_longest(heads, row):
        over = cell.text or over
        at = min((place for place, sign in enumerate(over) if sign in ",(["), default=len(over))
        text = f"{over[:at].rstrip()}{number.text}{over[at:]}" if number and number.text else cell.text
        found.append(cell._replace(text=text, flag="text" if text else "missing"))
    return found


def _is_units(row: list[PrintedNumber]) -> bool:
    texts = [cell.text for cell in row if cell.flag == "text"]
    return len(texts) >= 2 and 2 * sum(bool(unit_of(text)) for text in texts) >= len(texts)


def _joined(texts: list[str], width: int, names: Collection[str] = ()) -> list[str]:
    """Return the heads, with units that a comma separated ("t, s,phi1, rad") put back; a column of the task may be named s."""
    while texts and not texts[-1]:
        texts = texts[:-1]
    if len(texts) <= width:
        return texts
    joined: list[str] = []
    for place, text in enumerate(texts):
        is_name = text == TIME or (text in names and text not in texts[place + 1 :])
        if joined and unit_of(text) and not is_name and "," not in joined[-1]:
            joined[-1] += f", {text}"
        else:
            joined.append(text)
    return joined
