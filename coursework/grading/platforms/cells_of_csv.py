"""A platform's CSV with the place of every cell, so that some cells can be changed and every other byte kept.

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
    """One cell: its value, the range of its text (with quotation marks), and its line."""

    value: str
    start: int
    end: int
    line: int


@frozen
class CellText:
    """A CSV file: its text, separator and encoding, and the cells of each record (blank lines are left out)."""

    file: str
    text: str
    encoding: str
    mark: bytes
    separator: str
    records: tuple[tuple[CsvCell, ...], ...]

    @property
    def titles(self) -> list[str]:
        """Return the contents of the first record."""
        return [cell.value.strip() for cell in self.records[0]] if self.records else []

    @property
    def columns(self) -> dict[str, int]:
        """Return the column (from 0) of each title, case folded; of equal titles the first column."""
        return {title.casefold(): place for place, title in reversed([*enumerate(self.titles)])}

    def value(self, record: int, column: int | None) -> str:
        """Return the content of one column in a record; "" if the record is shorter or there is no such column."""
        cells = self.records[record]
        return cells[column].value.strip() if column is not None and column < len(cells) else ""

    def named(self, names: Iterable[str]) -> Iterator[tuple[int, dict[str, str]]]:
        """Yield the number of each record below the head, and its contents by title, for the titles in `names`."""
        places = {name: self.columns.get(name) for name in names}
        for record in range(1, len(self.records)):
            yield record, {name: self.value(record, place) for name, place in places.items()}

    def replaced(self, changes: Mapping[tuple[int, int], str]) -> bytes:
        """Return the file with some cells changed; `changes` maps (record, cell) to the new text, quoted if it must be."""
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
        """Return a value as it is written into a cell of this file, in quotation marks if necessary."""
        if any(sign in value for sign in (self.separator, '"', "\n", "\r")) or value != value.strip():
            return '"' + value.replace('"', '""') + '"'
        return value


def read_cells(content: bytes, file: str) -> CellText:
    """Return the cells of a CSV file.  Raises `InputError` if it is too large or its bytes cannot be decoded."""
    if len(content) > MOST_BYTES:
        raise InputError([Fault(say("fault.G014", count=len(content), most_bytes=MOST_BYTES), file)])
    name = decode(content).encoding.removesuffix("-sig")
    mark = next((mark for mark, _ in MARKS if content.startswith(mark)), b"")
    try:
        text = content[len(mark) :].decode(name)
    except UnicodeDecodeError as error:
        raise InputError([Fault(say("fault.G015"), file)]) from error
    outside = "".join(text.partition("\n")[0].split('"')[::2])  # the head without what stands in quotation marks
    separator = max(_SEPARATORS, key=outside.count)
    return CellText(file, text, name, mark, separator, tuple(_records(text, separator)))


def _records(text: str, separator: str) -> Iterator[tuple[CsvCell, ...]]:
    """Yield the records; within quotation marks separators and line ends are text, and a doubled mark is one."""
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
