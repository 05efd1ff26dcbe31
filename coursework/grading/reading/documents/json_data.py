"""JSON written by a program -> its tables, given as columns, records or rows with a head, and its named values.

Enters: text.  Leaves: `Document`.  Raises `Refused`.  All forms of pandas' `to_json` are understood.
Used by `read_document.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest
from typing import Any

from coursework.grading.reading.documents.document import Document, place_of
from coursework.grading.reading.documents.json_text import JsonNumber, JsonObject, read_json
from coursework.grading.reading.equations.notation.signs import relates_two_sides
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.limits import CELL_CHARACTERS, Room

LEVELS = 6
_MOST_VALUES, _MOST_RECORDS, _MOST_NAMES = 20_000, 10_000, 1000
_SIDES = (("lhs", "rhs"), ("left", "right"))  # of an equation, each by itself
_FEW = 10  # most numbers that one name may have in a row
_NOT_NUMBERS = {"NaN", "Infinity", "-Infinity"}


def document_of_json(text: str, kind: str, room: Room) -> Document:
    """Return the tables and named values of a JSON file; `kind` names its encoding."""
    reader = _Reader(Document(kind), room)
    reader.read(read_json(text, LEVELS), "")
    return reader.document


class _Reader:
    """Walks through the data; `LEVELS` limits how deeply they are nested."""

    def __init__(self, document: Document, room: Room) -> None:
        self.document, self.room = document, room
        self.visited = 0

    def read(self, value: Any, path: str) -> None:
        """Add the tables and lines of a value; `path` has the names that lead to it."""
        rows = self._rows(value)
        if rows:
            self.document.add_table(
                (row[: self.room.columns] for row in rows[: self.room.rows]), place_of("entry", name=path[:80] or "[]")
            )
        if isinstance(value, JsonObject):
            if sides := _sides(value):
                self.document.add_line(" = ".join(sides), place_of("entry", name=path[:80]))
            for name, inner in value.pairs[:_MOST_RECORDS]:
                if not rows or _is_texts(inner):
                    self._named(name, inner, f"{path}.{name}" if path else name)
        elif isinstance(value, list):
            for number, inner in enumerate(value[:_MOST_RECORDS], start=1):
                if not rows or _is_text(inner):
                    self._named("", inner, f"{path}[{number}]")

    def _named(self, name: str, value: Any, path: str) -> None:
        """Add a text (perhaps an equation), a named number (perhaps an answer), or the contents of a list or object."""
        self.visited += 1
        if self.visited > _MOST_VALUES:
            return
        if isinstance(value, (JsonObject, list)):
            self.read(value, path)
        if not isinstance(value, str):
            return
        place = place_of("entry", name=path[:80])
        if isinstance(value, JsonNumber):
            self.document.add_line(f"{name} = {value}" if name else "", place)
        else:
            for line in value.split("\n"):
                self.document.add_line(f"{name} = {line}" if name and not relates_two_sides(line) else line, place)

    def _rows(self, value: Any) -> list[Sequence[Cell]]:
        """Return a value as rows of cells, with a row of heads first if it has names; [] if it is no table."""
        if isinstance(value, list):
            return _series(value) or _records(value) if all(isinstance(row, JsonObject) for row in value) else _lists(value)
        lists = [inner for _, inner in value.pairs if isinstance(inner, list)]
        bodies = [rows for inner in lists if (rows := _lists(inner))]
        for heads in lists if len(bodies) == 1 else []:  # as pandas writes it, orient="split"
            if all(map(_is_word, heads)) and {len(heads)} == {*map(len, bodies[0])}:
                return [[_cell(head) for head in heads], *bodies[0]]
        return self._columns(value)

    def _columns(self, value: JsonObject) -> list[Sequence[Cell]]:
        """Return the rows of an object of columns, each a list or numbered entries; also of an object of numbered records."""
        is_one = any(isinstance(inner, list) and _flat(inner) for _, inner in value.pairs)  # others may be groups of columns
        pairs = [pair for name, inner in value.pairs for pair in _spread(name, inner, is_one)]
        found = [(name, inner) for name, inner in pairs if isinstance(inner, (list, JsonObject)) and not _is_texts(inner)]
        columns = [(name, inner) for name, inner in found if _flat(inner)]
        if len(columns) < 2 or len(columns) < len(found):
            return []
        if all(isinstance(inner, JsonObject) for _, inner in columns):
            first: Any = columns[0][1]
            numbers = [name.replace(".", "", 1).replace("-", "", 1) for name, _ in first.pairs]  # of rows, or times
            if all(name.isdecimal() for name, _ in columns) or not all(map(str.isdecimal, numbers)):
                return _records([inner for _, inner in columns])
        lists = [[_cell(entry) for entry in _entries(inner)[: self.room.rows]] for _, inner in columns[: self.room.columns]]
        heads = [Cell(name[:CELL_CHARACTERS]) for name, _ in columns[: self.room.columns]]
        return [heads, *map(list, zip_longest(*lists, fillvalue=Cell("")))]


def _series(records: list[Any]) -> list[Sequence[Cell]]:
    """Return records that each name one column, with its numbers and perhaps those of the axis along which it is drawn.

    So programs of graphs write them; an axis that all have in common is the first column, without a head.  [] for other records.
    """
    records = records[:_MOST_NAMES]
    lists = [[inner for _, inner in one.pairs if isinstance(inner, list) and _flat(inner)] for one in records]
    are_alike = len({(len(found), *map(len, found)) for found in lists}) == 1
    if not are_alike or not 1 < len(records) < min(map(len, lists[0]), default=0):
        return []
    texts = [{name: text for name, text in one.pairs if isinstance(text, str)} for one in records]
    names = ([one.get(key, "") for one in texts] for key, text in texts[0].items() if _is_word(text))
    heads = next((found for found in names if len({*found}) == len(records)), None)
    if heads is None:
        return []
    columns = [lists[0][0]] if len({tuple(found[0]) for found in lists if len(found) > 1}) == 1 else []
    said = [f"{head}, {unit}" if (unit := one.get("unit")) else head for head, one in zip(heads, texts, strict=True)]
    rows = zip(*columns, *(found[-1] for found in lists), strict=True)
    return [[_cell(head) for head in [""] * len(columns) + said], *([_cell(entry) for entry in row] for row in rows)]


def _records(records: list[Any]) -> list[Sequence[Cell]]:
    """Return records as rows under a row of their names; a name that occurs twice in a record makes two columns."""
    names: dict[tuple[str, int], int] = {}
    rows: list[list[Cell]] = []
    for record in records[:_MOST_RECORDS]:
        seen: dict[str, int] = {}
        row = [Cell("")] * len(names)
        for name, value in (pair for entry in record.pairs[:_MOST_RECORDS] for pair in _parted(*entry)):
            seen[name] = seen.get(name, 0) + 1
            if len(names) >= _MOST_NAMES and (name, seen[name]) not in names:
                continue
            at = names.setdefault((name, seen[name]), len(names))
            row += [Cell("")] * (at + 1 - len(row))
            row[at] = _cell(value)
        rows.append(row)
    return [[Cell(name[:CELL_CHARACTERS]) for name, _ in names], *rows] if len(names) > 1 else []


def _parted(name: str, value: Any) -> list[tuple[str, Any]]:
    """Return an entry of a record, or the entries inside it if it is short: phi1, phi2, phi3 for a list phi."""
    if isinstance(value, JsonObject) and len(value.pairs) <= _FEW:
        return list(value.pairs)
    if isinstance(value, list) and 1 < len(value) <= _FEW:
        return [(f"{name}{number}", inner) for number, inner in enumerate(value, start=1)]
    return [(name, value)]


def _spread(name: str, value: Any, is_grouped: bool = False) -> list[tuple[str, Any]]:
    """Return a column, or the columns of a list of lists: each list is a column if there are few lists, else a row.

    With `is_grouped`, also those of an object of lists; the number of a list is put behind the name of the object.
    """
    if is_grouped and isinstance(value, JsonObject) and all(isinstance(inner, list) and _flat(inner) for _, inner in value.pairs):
        return [(name + key if key.isdecimal() else key, inner) for key, inner in value.pairs]
    lists = value if isinstance(value, list) and value and all(isinstance(inner, list) for inner in value) else []
    if len(lists) < 2 or len({len(inner) for inner in lists}) > 1:
        return [(name, value)]
    columns = lists if len(lists) <= _FEW else [*map(list, zip(*lists, strict=True))]
    return (
        [(f"{name}{number}", inner) for number, inner in enumerate(columns, start=1)] if len(columns) <= _FEW else [(name, value)]
    )


def _lists(rows: list[Any]) -> list[Sequence[Cell]]:
    found = [[_cell(entry) for entry in row] for row in rows[:_MOST_RECORDS] if isinstance(row, list) and _flat(row)]
    return list(found) if len(found) > 1 and len(found) == len(rows[:_MOST_RECORDS]) else []


def _is_texts(value: Any) -> bool:
    """Return whether a value is a text that relates two sides or a list in which some text does."""
    texts = value if isinstance(value, list) else [value]
    return any(_is_word(text) and relates_two_sides(text) for text in texts)


def _is_text(value: Any) -> bool:
    """Return whether a value is a record with an equation in it."""
    return isinstance(value, JsonObject) and (bool(_sides(value)) or any(_is_texts(entry) for _, entry in value.pairs))


def _sides(value: JsonObject) -> list[str]:
    """Return the two sides of an equation that a record has each by itself, [] for any other record."""
    found = ([side for side in map(value.value, names) if isinstance(side, str)] for names in _SIDES)
    return next((sides for sides in found if len(sides) == 2), [])


def _is_word(value: Any) -> bool:
    return isinstance(value, str) and not isinstance(value, JsonNumber)


def _flat(value: Any) -> bool:
    entries = _entries(value)
    return len(entries) > 1 and not any(isinstance(entry, (list, JsonObject)) for entry in entries)


def _entries(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [entry for _, entry in value.pairs]


def _cell(value: Any) -> Cell:
    if isinstance(value, JsonNumber):
        return Cell(str(value)[:CELL_CHARACTERS], "error" if value in _NOT_NUMBERS else "number")
    return Cell(value[:CELL_CHARACTERS] if isinstance(value, str) else "")
