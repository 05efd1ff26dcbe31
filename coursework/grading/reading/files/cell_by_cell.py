"""Tables of which a text has one cell after the other: table(columns: 5, [t], …) of Typst, or one cell in each line.

Enters: a text, its lines.  Leaves: rows of texts, () if the text has no such table.
Used by `separators.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import groupby, islice

from coursework.grading.reading.numbers import looks_numeric

_TABLE = re.compile(r"\btable\s*\(")
_COLUMNS = re.compile(r"\bcolumns\s*:\s*(?:(\d{1,2})|\(([^()]{1,400})\)(?:\s*\*\s*(\d{1,2}))?)")
_CELL = re.compile(r"\[([^\[\]]{0,200})\]|\$([^$\n]{1,200})\$|\"([^\"\n]{0,200})\"")
_MARKUP = re.compile(r"^[*_$\s]+|[*_$\s]+$")
_FEWEST, _MOST_COLUMNS = 3, 40
_Rows = tuple[tuple[str, ...], ...]


def rows_of_typst(text: str, most_rows: int) -> _Rows:
    """Return the rows of the largest table of a Typst text.

    >>> rows_of_typst("#table(columns: 2, [*t*], [$w_1$], [0], [5], [1], [6], [2], [7])", 600)
    (('t', 'w_1'), ('0', '5'), ('1', '6'), ('2', '7'))
    """
    found = []
    for begun in islice(_TABLE.finditer(text), _MOST_COLUMNS):
        end = next((one.start() for one in islice(_TABLE.finditer(text, begun.end()), 1)), len(text))
        if columns := _COLUMNS.search(text, begun.end(), end):
            width = int(columns[1] or 0) or len([one for one in columns[2].split(",") if one.strip()]) * int(columns[3] or 1)
            cells = [_MARKUP.sub("", one[1] or one[2] or one[3] or "") for one in _CELL.finditer(text, columns.end(), end)]
            found.append(_in_rows(cells[: most_rows * _MOST_COLUMNS], width))
    rows = max(found, key=len, default=())
    return rows[:most_rows] if sum(map(looks_numeric, sum(rows[1:2], ()))) else ()


def rows_of_lines(lines: Sequence[str], progresses: Callable[[_Rows, list[int]], bool]) -> _Rows:
    """Return the rows of a table with one cell in each line, under the names of its columns.

    `progresses` tells whether one of the first columns of rows with these places rises in equal steps.
    """
    filled = [line.strip() for line in lines if line.strip()]
    heads: list[str] = []
    for is_number, group in groupby(filled, looks_numeric):
        block = list(group)
        if not is_number:
            heads = block
            continue
        for width in range(min(len(heads), len(block) // _FEWEST, _MOST_COLUMNS), 1, -1):
            rows = _in_rows([*heads[-width:], *block], width)
            if len(block) % width == 0 and progresses(rows, [*range(1, len(rows))]):
                return rows
    return ()


def _in_rows(cells: Sequence[str], width: int) -> _Rows:
    return tuple(tuple(cells[at : at + width]) for at in range(0, len(cells), width)) if width > 1 else ()
