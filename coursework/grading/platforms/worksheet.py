"""Moodle's offline grading worksheet, in any language it was downloaded in: grades and comments filled in, the rest kept.

Enters: the bytes of the worksheet, points and comments.  Leaves: `Worksheet`, the filled bytes.  Raises `InputError`.
Used by the code that grades a class.
"""

from __future__ import annotations

import html
import re
from collections import Counter
from collections.abc import Callable, Mapping
from datetime import datetime

from coursework.grading.platforms.cells_of_csv import CellText, read_cells
from coursework.grading.platforms.escapes import shown, text_cell
from coursework.grading.platforms.moodle_times import MOODLE, moodle_time
from coursework.grading.platforms.names import name_key
from coursework.grading.reading.numbers import filled_in
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_NO = {*MOODLE["no"]}
_MOST_COMMENT = 5000
_AFTER_MAXIMUM = 4  # columns after the maximum: whether the grade can be changed, two times, the comment


@frozen
class WorksheetRow:
    """One student of the worksheet; `number` is the one in the names of the downloaded folders.

    `locked`: Moodle says that the grade cannot be changed. `modified`: when the submission was last changed, by the clock of
    the person who downloaded the worksheet.
    """

    record: int
    number: str
    name: str
    email: str
    id_number: str
    name_is_unique: bool
    locked: bool = False
    modified: datetime | None = None


@frozen
class Worksheet:
    """A worksheet: its cells, its columns by meaning, its students, the maximum grade and the decimal mark."""

    cells: CellText
    columns: Mapping[str, int]
    rows: tuple[WorksheetRow, ...]
    maximum: float
    mark: str

    def check_total(self, points: float, rubric: str | Sentence) -> None:
        """Raise `InputError` if the rubric's total is not the worksheet's maximum grade: Moodle would skip grades."""
        if abs(points - self.maximum) > 1e-9:
            raise InputError([Fault(say("fault.G025", maximum=self.maximum, rubric=rubric, points=points), self.cells.file)])

    def filled(self, marks: Mapping[int, tuple[float | None, str]]) -> bytes:
        """Return the worksheet with `marks` filled in: by record, points (None keeps the grade) and the text of a comment.

        A comment is plain text, escaped here because Moodle takes it for HTML.  Locked rows are left as they are.
        """
        changes: dict[tuple[int, int], str] = {}
        for row in self.rows:
            if row.record not in marks or row.locked:
                continue
            points, comment = marks[row.record]
            if points is not None:
                if not 0 <= points <= self.maximum:
                    message = say("fault.G026", points=points, maximum=self.maximum)
                    raise InputError([Fault(message, self.cells.file, self.cells.records[row.record][0].line)])
                changes[row.record, self.columns["grade"]] = self.cells.quoted(f"{points:.2f}".replace(".", self.mark))
            if "comment" not in self.columns:  # comments are switched off for the assignment
                continue
            escaped = html.escape(shown(comment[:_MOST_COMMENT])).replace("\n", "<br>")
            changes[row.record, self.columns["comment"]] = self.cells.quoted(text_cell(escaped))
        return self.cells.replaced(changes)


def read_worksheet(content: bytes, file: str) -> Worksheet:
    """Return a worksheet.  Its columns are found by their titles, else by their position from the column of maximum grades."""
    cells = read_cells(content, file)
    if len(cells.records) < 2:
        raise InputError([Fault(say("fault.G021"), file)])
    titles = cells.columns
    found = {name: titles[title] for name, known in MOODLE["titles"].items() for title in known if title in titles}
    equal = _columns_where(cells, _are_one_number, first=1)
    maximum = found.get("maximum", equal[0] if len(equal) == 1 else None)
    if maximum is None or found.get("grade", maximum - 1) < 1:
        raise InputError([Fault(say("fault.G022"), file, 1)])
    columns = {"identifier": 0, "name": 1, "grade": maximum - 1, "maximum": maximum} | found
    if found.get("status") == columns["name"]:  # while marking is blind there are no names
        del columns["name"]
    last = len(cells.titles) - 1
    if "maximum" not in found and last >= maximum + _AFTER_MAXIMUM:
        columns.setdefault("comment", last)
    for name, holds, first in (("changeable", _are_yes_or_no, maximum + 1), ("email", _are_addresses, 0)):
        places = _columns_where(cells, holds, first)
        if places:
            columns.setdefault(name, places[0])
    if "changeable" in columns:  # the next column is the time of the submission
        columns.setdefault("modified", min(columns["changeable"] + 1, last))
    greatest, mark = _maximum(cells, maximum)
    return Worksheet(cells, columns, _rows(cells, columns), greatest, mark)


def _columns_where(cells: CellText, holds: Callable[[list[str]], bool], first: int) -> list[int]:
    """Return the columns, from `first` on, for whose values below the head `holds` is true."""
    width = min(len(record) for record in cells.records)
    rows = range(1, len(cells.records))
    return [place for place in range(first, width) if holds([cells.value(row, place) for row in rows])]


def _are_one_number(values: list[str]) -> bool:
    number = filled_in(values[0], ".")
    return len({*values}) == 1 and number.is_number and number.value > 0


def _are_yes_or_no(values: list[str]) -> bool:
    return {value.casefold() for value in values} <= {*MOODLE["yes"]} | _NO


def _are_addresses(values: list[str]) -> bool:
    return any(values) and all(re.fullmatch(r"(?:[^@\s]+@[^@\s]+)?", value) for value in values)


def _maximum(cells: CellText, place: int) -> tuple[float, str]:
    """Return the maximum grade and the sheet's decimal mark.  Raises `InputError` if the column is not one positive number."""
    values = {record: value for record in range(1, len(cells.records)) if (value := cells.value(record, place))}
    first = next(iter(values.values()), "")
    mark = "," if "," in first and "." not in first else "."
    number = filled_in(first, mark)
    other = next((record for record, value in values.items() if value != first), None)
    if not number.is_number or number.value <= 0 or other:
        record = other or next(iter(values), 1)
        raise InputError([Fault(say("fault.G024", found=values.get(record, "")[:20]), cells.file, cells.records[record][0].line)])
    return number.value, mark


def _rows(cells: CellText, columns: Mapping[str, int]) -> tuple[WorksheetRow, ...]:
    def value(record: int, name: str) -> str:
        return cells.value(record, columns.get(name))

    whole = [record for record in range(1, len(cells.records)) if len(cells.records[record]) > max(columns.values())]
    names = Counter(name_key(value(record, "name")) for record in whole)
    rows = []
    for record in whole:
        number = re.search(r"([0-9]+)\s*$", value(record, "identifier"))
        name = value(record, "name")
        rows.append(WorksheetRow(
            record, number[1] if number else "", name, value(record, "email"), value(record, "id_number"),
            names[name_key(name)] == 1,
            value(record, "changeable").casefold() in _NO,
            moodle_time(value(record, "modified")),
        ))  # fmt: skip
    return tuple(rows)
