"""A platform's CSV with the place of every cell, so that some cells change and every other byte stays.

Enters: the bytes of a worksheet or gradebook.  Leaves: `CellText`, and the bytes with chosen cells replaced.
Used by `worksheet.py`, `canvas.py`, `roster.py` and `decisions.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from coursework.grading.reading.files.encoding import MARKS, decode
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

_SEPARATORS = (",", ";", "\t", ":")
MOST_BYTES = 64 * 1024 * 1024


@frozen
class CsvCell:
    """One cell: its value, and where its text (quotation marks included) stands."""

    value: str
    start: int
    end: int
    line: int


@frozen
class CellText:
    """A CSV file: its text as it stands, separator, encoding, and the cells of each record (blank lines left out)."""

    file: str
    text: str
    encoding: str
    mark: bytes
    separator: str
    records: tuple[tuple[CsvCell, ...], ...]

    @property
    def titles(self) -> list[str]:
        """Return what stands in the cells of the first record."""
        return [cell.value.strip() for cell in self.records[0]] if self.records else []

    @property
    def columns(self) -> dict[str, int]:
        """Return which column (from 0) has a title, in small letters; of two alike the first."""
        return {title.casefold(): place for place, title in reversed([*enumerate(self.titles)])}

    def value(self, record: int, column: int | None) -> str:
        """Return what stands in one column of a record; "" where the record ends before it, or there is no such column."""
        cells = self.records[record]
        return cells[column].value.strip() if column is not None and column < len(cells) else ""

    def named(self, names: Iterable[str]) -> Iterator[tuple[int, dict[str, str]]]:
        """Yield (record, what stands under each of `names`) of every record but the head."""
        places = {name: self.columns.get(name) for name in names}
        for record in range(1, len(self.records)):
            yield record, {name: self.value(record, place) for name, place in places.items()}

    def replaced(self, changes: Mapping[tuple[int, int], str]) -> bytes:
        """Return the file with some cells changed: (record, cell) to its new text, written out with its quotation marks."""
        pieces = []
        last = 0
        for (record, place), text in sorted(changes.items()):
            cell = self.records[record][place]
            pieces += [self.text[last : cell.start], text]
            last = cell.end
        whole = "".join([*pieces, self.text[last:]])
        try:
            return self.mark + whole.encode(self.encoding.removesuffix("-sig"))
        except UnicodeEncodeError as error:
            message = say("fault.G016", letter=whole[error.start], encoding=self.encoding)
            raise InputError([Fault(message, self.file)]) from error

    def quoted(self, value: str) -> str:
        """Return a value as a cell of this file: in quotation marks where it needs them."""
        if any(sign in value for sign in (self.separator, '"', "\n", "\r")) or value != value.strip():
            return '"' + value.replace('"', '""') + '"'
        return value


def read_cells(content: bytes, file: str) -> CellText:
    """Return the cells of a CSV file.  Raises `InputError` where its letters cannot be read back the same, or it is too large."""
    if len(content) > MOST_BYTES:
        raise InputError([Fault(say("fault.G014", count=len(content), most_bytes=MOST_BYTES), file)])
    name = decode(content).encoding.removesuffix("-sig")
    mark = next((mark for mark, _ in MARKS if content.startswith(mark)), b"")
    try:
        text = content[len(mark) :].decode(name)
    except UnicodeDecodeError as error:
        raise InputError([Fault(say("fault.G015"), file)]) from error
    separator = _separator(text)
    return CellText(file, text, name, mark, separator, tuple(_records(text, separator)))


def _separator(text: str) -> str:
    """Return the sign that stands most often outside quotation marks in the first line."""
    outside = "".join(text.partition("\n")[0].split('"')[::2])
    return max(_SEPARATORS, key=outside.count)


def _records(text: str, separator: str) -> Iterator[tuple[CsvCell, ...]]:
    """Give the records; a quotation mark encloses separators and ends of lines, two are one."""
    sign = re.escape(separator)
    pattern = re.compile(rf'(?:"((?:[^"]++|"")*+)"?)?([^{sign}\r\n]*+)({sign}|\r\n|[\r\n]|\Z)')
    cells: list[CsvCell] = []
    line = 1
    for found in pattern.finditer(text):
        quoted, rest, ending = found.groups()
        value = rest if quoted is None else quoted.replace('""', '"') + rest
        cells.append(CsvCell(value, found.start(), found.start(3), line))
        line += text.count("\n", found.start(), found.start(3))
        if ending != separator:
            if len(cells) > 1 or cells[0].value:
                yield tuple(cells)
            cells = []
            line += 1
