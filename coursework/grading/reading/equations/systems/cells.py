"""Formulas of a spreadsheet beside a legend of its cells, B1 = r, C5: phi, F5: w = B1*COS(C5) -> formulas by names.

Enters: a text, what a name means.  Leaves: the text with names in place of the cells and without the legend; unchanged if it has
no such legend.  Nothing is computed.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from string import ascii_uppercase, digits

_PLACE = r"\$?[A-Z]{1,2}\$?\d{1,4}(?![\w(])"
_CELL = rf"({_PLACE})"
_REFERENCE = re.compile(rf"(?<![\w.$!'\\]){_PLACE}")
_NAME = r"(?!(?:in|is|ist|es|at|to|en|an|auf|em|im)\b)([^\W\d][\w{}'\u0307]{0,20}(?: \d)?)"
_WORDS = r"\W{0,8}(?:[^\W\d_]{2,12}(?:\s\d{1,3})?\s*[:,]?\s+){0,4}\(?"
_BETWEEN = r"\s*(?:[=:(|,;\t–—-]|\bis\b|\bist\b|\bes\b|→|->|⇒)\s*"
_FORMULA = r"[\s|)\"';]*(?::\s*)?=\s*\"?=?\s*([^=]*[-+*/(][^=]*?)[\s|\"]*"
_FORMULAS = (
    (re.compile(rf"{_WORDS}{_CELL}{_BETWEEN}(?!{_PLACE}){_NAME}{_FORMULA}"), 1, 2),
    (re.compile(rf"{_WORDS}(?!{_PLACE}){_NAME}(?:{_BETWEEN}|\s+(?:[^\W\d_]{{1,9}}\s+)?){_CELL}{_FORMULA}"), 2, 1),
    (re.compile(rf"{_WORDS}{_CELL}(){_FORMULA}"), 1, 2),
)
_REST = r"(?:[\s)=:,|].*)?"
_PAIRS = (
    (re.compile(rf"{_WORDS}{_CELL}(?:{_BETWEEN}|\s+){_NAME}({_REST})"), 1, 2),
    (re.compile(rf"{_WORDS}{_NAME}(?:{_BETWEEN}|\s+(?:[^\W\d_]{{1,9}}\s+){{0,2}}){_CELL}({_REST})"), 2, 1),
    (re.compile(rf"{_WORDS}([A-Z]{{1,2}}){_BETWEEN}{_NAME}({_REST})"), 1, 2),  # a column
)
_RANGE = re.compile(
    rf"{_WORDS}\$?([A-Z])\$?(\d{{1,4}})\s*(?:[:–—-]|\.\.+|…|\w{{1,4}})\s*\$?([A-Z])\$?(\d{{1,4}}){_BETWEEN}((?:{_NAME},\s*)+{_NAME})\W*"
)
_NO_LEGEND = re.compile(rf"[*+^/]|{_PLACE}|[,;]\s*[A-Z]{{1,2}}{_BETWEEN}\w|\bsin|\bcos", re.IGNORECASE)
_OF_COLUMN = re.compile(
    r"(?<!\w)(?i:col\w{0,4}\.?|spalte|стол\w+|стовп\w+|колонк\w)\s([A-Z])(?!\w)|列\s?([A-Z])(?!\w)|(?<!\w)([A-Z])\s?[列열]"
)
_PARTS, _NEXT = re.compile(r"[,;|\t]|\s{2,}|\s(?:and|und|и|та|і)\s"), re.compile(rf"[;,\t]\s*(?=(?:{_PLACE})\s*[:=(])")
_FEWEST, _MOST_CHARACTERS, _LONGEST = 2, 40_000, 600


def with_cells_named(text: str, meaning: Callable[[str], str | None], data: frozenset[str]) -> str:
    r"""Return a text with the names of its legend in place of the cells; of what is none of the `data` each row has its own cell.

    >>> means = {"r": "r", "phi": "phi", "w": "w"}.get
    >>> with_cells_named("B1 = r, C5 = phi\nF5: w = $B$1*COS(C5)/G5\nG5: =SIN(C5)", means, frozenset({"r"}))
    '\nw = r*COS(phi)/G5\nG5 = SIN(phi)'
    >>> with_cells_named("A2 = r + w\nw = A2*phi", means, frozenset())
    'A2 = r + w\nw = A2*phi'
    """
    if len(text) > _MOST_CHARACTERS or sum(1 for _ in _REFERENCE.finditer(text)) <= _FEWEST:
        return text
    typed, text = text, _OF_COLUMN.sub(r"\1\2\g<3>0", text)  # "column E" is named as the cell E0 would be
    lines = [_NEXT.split(line) if len(line) <= _LONGEST else [line] for line in text.split("\n")]
    formulas = {piece: found for line in lines for piece in line if len(piece) <= _LONGEST and (found := _formula(piece))}
    legend: dict[str, str] = {}
    said: set[int] = set()
    for place, (whole, pieces) in enumerate(zip(text.split("\n"), lines, strict=True)):
        if formulas.keys().isdisjoint(pieces) and (pairs := [*_pairs(whole, meaning)]):
            said.add(place)
            legend.update(pairs)
    legend = {cell: name for cell, name, _ in formulas.values() if name} | legend
    used = {_bare(found[0]) for _, _, formula in formulas.values() for found in _REFERENCE.finditer(formula)}
    columns = _columns({cell: name for cell, name in legend.items() if meaning(name) not in data})
    known = sum(cell in legend or cell.rstrip(digits) in columns for cell in used)
    if (
        max(known, sum(meaning(name) is not None for _, name, _ in formulas.values() if name)) < _FEWEST
        or sum(meaning(cell) is None for cell in legend) < _FEWEST
    ):
        return typed

    said_of = {cell.rstrip(digits) for cell in legend}

    def named(found: re.Match[str]) -> str:
        cell = _bare(found[0])
        column = "" if re.search(r"\$\d", found[0]) else cell.rstrip(digits)
        is_free = meaning(cell) is None or cell.rstrip(digits) not in said_of  # V1 of the task, where no column V is named
        return legend.get(cell) or columns.get(column) or (cell if is_free else f"cell_{cell}")

    written = list[str]()
    for place, pieces in enumerate(lines):
        read = [(formulas.get(piece), piece) for piece in pieces]
        ones = [f"{one[1] or one[0]} = {one[2]}" if one else piece for one, piece in read]
        written.append("" if place in said else "; ".join(_REFERENCE.sub(named, one) for one in ones))
    return "\n".join(written)


def _columns(cells: Mapping[str, str]) -> dict[str, str]:
    """Return the name of each column, if it is said as such or by a row of cells; a single cell is a datum's, B4 = omega."""
    rows = Counter(cell.lstrip(ascii_uppercase) for cell in cells)
    found = {cell.rstrip(digits): name for cell, name in cells.items() if rows[cell.lstrip(ascii_uppercase)] > 1}
    return found | {cell.rstrip(digits): name for cell, name in cells.items() if cell.lstrip(ascii_uppercase) in {"", "0"}}


def _bare(cell: str) -> str:
    return cell.replace("$", "")


def _formula(piece: str) -> tuple[str, str, str] | None:
    """Return the cell, the name ("" if none is said) and the formula of a piece that says all three."""
    for pattern, cell, name in _FORMULAS:
        if (found := pattern.fullmatch(piece)) and (found[name] or _REFERENCE.search(found[3]) or found[3].count("(")):
            return _bare(found[cell]), found[name].replace(" ", ""), found[3]
    return None


def _pairs(line: str, meaning: Callable[[str], str | None]) -> Iterator[tuple[str, str]]:
    """Yield (cell or column, name) of a line that is a legend; names that mean nothing in the task are none."""
    if len(line) > _LONGEST:
        return
    if found := _RANGE.fullmatch(line):
        names = re.findall(r"[^\W\d]\w*", found[5])
        if found[1] == found[3]:
            cells = [f"{found[1]}{row}" for row in range(int(found[2]), int(found[4]) + 1)]
        else:
            cells = [f"{chr(column)}{found[2]}" for column in range(ord(found[1]), ord(found[3]) + 1)]
        yield from zip(cells, names, strict=False) if len(cells) == len(names) and all(map(meaning, names)) else ()
        return
    pieces = [line] if _pair(line, meaning) else _PARTS.split(line)
    yield from filter(None, (_pair(piece, meaning) for piece in pieces))


def _pair(piece: str, meaning: Callable[[str], str | None]) -> tuple[str, str] | None:
    for pattern, cell, name in _PAIRS:
        found = pattern.fullmatch(piece)
        if found and not _NO_LEGEND.search(found[3]) and meaning(found[name].replace(" ", "")):
            return _bare(found[cell]), found[name].replace(" ", "")
    return None
