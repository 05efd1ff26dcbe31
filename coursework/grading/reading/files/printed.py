"""Tables as programs print them or write them in code -> rows: split columns, a common factor, lists, named values, single cells.

Enters: lines, a text.  Leaves: whole lines; rows of texts, () if the text has no such table.
Used by `separators.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Sequence
from itertools import chain, groupby, islice

from coursework.grading.reading.limits import Room
from coursework.grading.reading.numbers import looks_numeric

_PIECE = re.compile(r"^[ \t]*columns?[ \t]+(\d{1,3})(?:[ \t]+(?:through|to|and|-)[ \t]+\d{1,3})?[ \t]*:?[ \t]*$", re.IGNORECASE)
_FACTOR = re.compile(r"[ \t]*1(?:\.0+)?[eE]([-+]?\d{1,2})[ \t]*\*[ \t]*")
_DECIMAL = re.compile(r"(?<![\w.])-?\d+\.\d+(?![\w.])")
_LIST = re.compile(r"[\[{(<]([^\[\]{}()<>]{3,})[\]})>]")
_VECTOR = re.compile(r"(?<=[=:])[ \t]*\n([-+\d.,eE\s]{6,})")  # as MATLAB prints a vector, or with one number per line
_NAMED = re.compile(r"([^\W\d]\w{0,20})[ \t]*(?:[:=]|:=)[ \t]*(?:[A-Za-z.]{1,20}\()?[ \t]*$")
_QUOTED = re.compile(r"""['"]([^'"\n]{1,40})['"]""")
PAIR = re.compile(r"(?<![\w.])([^\W\d][\w.]{0,20})[ \t]*(?:=|:)[ \t]*([-+−]?\d[\d.,]*(?:[eE][-+]?\d{1,3})?)(?![\w.*/^(])")
_FEWEST, _MOST_LISTS, _BEFORE = 3, 5000, 40
_TABLE = re.compile(r"\btable\s*\(")
_COLUMNS = re.compile(r"\bcolumns\s*:\s*(?:(\d{1,2})|\(([^()]{1,400})\)(?:\s*\*\s*(\d{1,2}))?)")
_CELL = re.compile(r"\[([^\[\]]{0,200})\]|\$([^$\n]{1,200})\$|\"([^\"\n]{0,200})\"")
_MARKUP = re.compile(r"^[*_$\s]+|[*_$\s]+$")
_MOST_COLUMNS = 40
_Rows = tuple[tuple[str, ...], ...]


def in_whole_lines(given: list[str]) -> list[str]:
    r"""Return the lines with tables put together that pandas, MATLAB or Octave print in pieces, and with common factors applied.

    A row that continues on the next lines, as Fortran writes it, becomes one line.

    >>> in_whole_lines(["  Columns 1 through 2", "", " 0 1.5", " 1 1.6", "", "  Column 3", "", " 2.5", " 2.6"])
    ['', ' 0 1.5 2.5', ' 1 1.6 2.6']
    >>> in_whole_lines(["   t  phi1  \\", "0  0  1.63   ", "1  1  1.65   ", "", "    w1  ", "0  2.0  ", "1  2.1  "])
    ['', '   t  phi1    w1', '0  0  1.63   2.0', '1  1  1.65   2.1']
    >>> in_whole_lines(["T =", "   1.0e+03 *", "   0   1.5"])
    ['T =', '', '   0   1.5e+03']
    >>> in_whole_lines(["t phi1 phi2", "w1", "0 1 2", "3", "1 2 3", "4", "2 3 4", "5"])
    ['t phi1 phi2 w1', '0 1 2 3', '1 2 3 4', '2 3 4 5']
    """
    lines = _unwrapped(_without_factors(given))
    is_piece = [bool("olumn" in line and _PIECE.match(line)) for line in lines]
    if not any(is_piece) and not any(line.rstrip().endswith("  \\") for line in lines):
        return lines
    out: list[list[str]] = []
    goes_on = is_numbered = False
    for kind, group in groupby(zip(lines, is_piece, strict=True), lambda pair: 2 * pair[1] + bool(pair[0].strip())):
        rows = [line.rstrip() for line, _ in group]
        if kind > 1:
            goes_on = (found := _PIECE.match(rows[-1])) is not None and found[1] != "1"
        elif kind:
            ends = rows[0].endswith("  \\")  # pandas prints the row numbers before each piece
            rows[0] = rows[0].removesuffix("\\").rstrip()
            if goes_on and out and len(out[-1]) == len(rows):
                out[-1] = _beside(out[-1], rows, is_numbered)
            else:
                out.append(rows)
            goes_on = is_numbered = ends
    return [line for rows in out for line in ("", *rows)]


def _unwrapped(lines: list[str]) -> list[str]:
    """Return the lines with wrapped rows joined; the pattern of widths must repeat, and the last line of a row is shorter."""
    widths = [len(cells) if all(map(looks_numeric, cells)) else 0 for cells in (line.split() for line in lines)]
    first = next((at for at, width in enumerate(widths) if width), 0)
    end = next((at for at in range(first, len(widths)) if not widths[at]), len(widths))
    last = next((at for at in range(first, end) if widths[at] != widths[first]), end)
    shape = widths[first : last + 1]
    if (
        last == end
        or shape[-1] > shape[0]
        or (end - first) < _FEWEST * len(shape)
        or widths[first:end] != (end - first) // len(shape) * shape
    ):
        return lines
    above = first - len(shape)
    begin = above if above >= 0 and [len(line.split()) for line in lines[above:first]] == shape else first
    rows = [" ".join(map(str.strip, lines[at : at + len(shape)])) for at in range(begin, end, len(shape))]
    return [*lines[:begin], *rows, *lines[end:]]


def _beside(before: list[str], rows: list[str], is_numbered: bool) -> list[str]:
    width = max(map(len, before)) + 1
    label = max((len(row) - len(row.lstrip("0123456789.")) for row in rows[1:]), default=0) if is_numbered else 0
    return [f"{first.ljust(width)}{row[label:] if is_numbered else row.strip()}" for first, row in zip(before, rows, strict=True)]


def _without_factors(lines: list[str]) -> list[str]:
    """Return the lines with each common factor, such as "1.0e+03 *", applied to the decimals below it, up to a line of words."""
    out: list[str] = []
    power = ""
    for line in lines:
        if found := _FACTOR.fullmatch(line):
            power = f"e{found[1]}"
            out.append("")
            continue
        if power and not _PIECE.match(line) and any(map(str.isalpha, line)):
            power = ""
        out.append(_DECIMAL.sub(rf"\g<0>{power}", line) if power else line)
    return out


def listed_rows(text: str, room: Room) -> tuple[tuple[str, ...], ...]:
    r"""Return the rows of a table written as lists in program code, each after its name if all have one; () if there is none.

    >>> listed_rows("T = [0 1.5; 1 1.6; 2 1.7];", Room(600, 40))
    (('0', '1.5'), ('1', '1.6'), ('2', '1.7'))
    >>> listed_rows("t = [0, 1, 2]\nw1 = [5, 6, 7]\nw2 = [7, 8, 9]", Room(600, 40))
    (('t', '0', '1', '2'), ('w1', '5', '6', '7'), ('w2', '7', '8', '9'))
    """
    found: list[tuple[str, list[str]]] = []
    first = 0
    for group in islice(chain(_LIST.finditer(text), _VECTOR.finditer(text)), _MOST_LISTS):
        name = _NAMED.search(text[max(group.start(1) - 1 - _BEFORE, 0) : group.start(1) - 1])
        lines = [line for line in re.split(r"[;\n]", group[1]) if line.strip(" \t,.")] if ";" in group[1] else [group[1]]
        for line in lines:
            cells = _entries(line)
            if len(cells) > 1 and all(map(looks_numeric, cells)):
                first = first or group.start()
                found.append((name[1] if name and len(lines) == 1 else "", cells))
    usual = Counter(len(cells) for _, cells in found).most_common(1)
    rows = [(name, cells) for name, cells in found if usual and len(cells) == usual[0][0]]
    if len(rows) < _FEWEST or len(rows) > room.rows:
        return ()
    if all(name for name, _ in rows):
        return tuple((name, *cells) for name, cells in rows)[: room.columns]
    heads = _QUOTED.findall(text[:first])
    return tuple(tuple(row[: room.columns]) for row in ([heads] * (len(heads) == usual[0][0]) + [cells for _, cells in rows]))


def _entries(line: str) -> list[str]:
    """Return the entries of a list: split at commas if these separate entries, else at blanks."""
    bare = line.replace("...", " ").strip(" \t\n,")
    is_parted = ", " in bare or ",\n" in bare or not re.search(r"\s", bare)
    return [cell.strip() for cell in bare.split(",")] if is_parted else [cell for cell in bare.split() if cell != "-"]


def named_rows(text: str, most_rows: int) -> tuple[tuple[str, ...], ...]:
    r"""Return the rows of a table in which each number follows its name ("t=0 w1=5"), under a row of the names; () if none.

    >>> named_rows("t=0 w1=5\nt=1 w1=6\nt=2 w1=7", 600)
    (('t', 'w1'), ('0', '5'), ('1', '6'), ('2', '7'))
    """
    records: list[dict[str, str]] = [{}]
    for found in islice(PAIR.finditer(text), 40 * most_rows):
        if found[1] in records[-1]:
            records.append({})
        records[-1][found[1]] = found[2].rstrip(",")
    usual = Counter(map(tuple, records)).most_common(1)[0][0]
    rows = [tuple(record.values()) for record in records if tuple(record) == usual]
    return (usual, *rows)[: most_rows + 1] if len(rows) >= _FEWEST and len(usual) > 1 else ()


def rows_of_typst(text: str, most_rows: int) -> _Rows:
    """Return the rows of the largest table of a Typst text.

    >>> rows_of_typst("#table(columns: 2, [*t*], [$w_1$], [0], [5], [1], [6], [2], [7])", 600)
    (('t', 'w_1'), ('0', '5'), ('1', '6'), ('2', '7'))
    """
    found = []
    for begun in islice(_TABLE.finditer(text), _MOST_COLUMNS):
        end = next((one.start() for one in islice(_TABLE.finditer(text, begun.end()), 1)), len(text))
        columns = _COLUMNS.search(text, begun.end(), end)
        if columns is None:
            continue
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
