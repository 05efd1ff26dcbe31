"""Canvas's gradebook export with the column of one assignment filled in; every other byte is kept.

Enters: the bytes of the export, points by record.  Leaves: `Gradebook`, the filled bytes.  Raises `InputError`.
Used by the code that grades a class.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping

from coursework.grading.platforms.cells_of_csv import CellText, read_cells
from coursework.grading.platforms.names import name_key, same_key
from coursework.grading.reading.numbers import filled_in
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

_ASSIGNMENT = re.compile(r".+ \([0-9]+\)")
_KEYS = ("id", "sis user id", "sis login id")


@frozen
class Gradebook:
    """An export: its cells, the column to fill in, and the records that are students."""

    cells: CellText
    column: int
    students: tuple[int, ...]

    def record_of(self, keys: tuple[str, ...], name: str | None) -> int | None:
        """Return a student's record: by ID, SIS user ID or SIS login ID (any of `keys`), else by a unique name; or None."""
        columns = self.cells.columns
        wanted = {same_key(key) for key in keys if key}
        for title in _KEYS:
            ids = {record: same_key(self.cells.value(record, columns.get(title))) for record in self.students}
            fitting = [record for record, student in ids.items() if student in wanted - {""}]
            if len(fitting) == 1:
                return fitting[0]
        if not name:
            return None
        named = Counter(spelling for record in self.students for spelling in self._names(record))
        fitting = [record for record in self.students if name_key(name) in self._names(record)]
        return fitting[0] if len(fitting) == 1 and named[name_key(name)] == 1 else None

    def filled(self, points: Mapping[int, float]) -> bytes:
        """Return the export with points (by record) in its column; excused students and equal grades are left as they are."""
        changes = {}
        for record, value in points.items():
            before = self.cells.value(record, self.column)
            number = filled_in(before, ".")
            if before.upper() == "EX" or (number.is_number and round(number.value, 2) == round(value, 2)):
                continue
            changes[record, self.column] = f"{value:.2f}".rstrip("0").rstrip(".")
        return self.cells.replaced(changes)

    def _names(self, record: int) -> set[str]:
        """Return the spellings of a student's name: as it stands, and in other orders if last and first name are known."""
        columns = self.cells.columns
        if "lastname" in columns and "firstname" in columns:
            last, first = (self.cells.value(record, columns[title]) for title in ("lastname", "firstname"))
            return {name_key(f"{last}, {first}"), name_key(f"{first} {last}"), name_key(f"{last} {first}")}
        whole = self.cells.value(record, 0)
        last, comma, first = whole.partition(",")
        return {name_key(whole), name_key(f"{first} {last}"), name_key(f"{last} {first}")} if comma else {name_key(whole)}


def read_gradebook(content: bytes, file: str, points: float) -> Gradebook:
    """Return an export with the assignment in it that is worth `points`.

    Raises `InputError` if no assignment fits, or several: a title that Canvas does not know would create a new assignment.
    """
    cells = read_cells(content, file)
    if len(cells.records) < 2:
        raise InputError([Fault(say("fault.G011"), file)])
    titles = cells.titles
    possible = next((k for k in range(1, min(6, len(cells.records))) if cells.value(k, 0) == "Points Possible"), None)
    listed = [place for place, title in enumerate(titles) if _ASSIGNMENT.fullmatch(title)]
    fitting = [place for place in listed if possible is None or _points(cells, possible, place) in (points, None)]
    if not listed:
        raise InputError([Fault(say("fault.G010"), file, 1)])
    known = "; ".join(titles[place] for place in listed)
    if not fitting:
        raise InputError([Fault(say("fault.G012", points=points, known=known), file, 1)])
    students = tuple(k for k in range(1, len(cells.records)) if k > (possible or 0) and _is_student(cells, k))
    if len(fitting) > 1:
        empty = [place for place in fitting if not any(cells.value(k, place) for k in students)]
        if len(empty) != 1:
            names = "; ".join(titles[place] for place in fitting)
            raise InputError([Fault(say("fault.G013", points=points, names=names), file, 1)])
        fitting = empty
    return Gradebook(cells, fitting[0], students)


def _is_student(cells: CellText, record: int) -> bool:
    """Return whether a record is a student, and not Canvas's own test student or a line of settings."""
    has_id = bool(cells.value(record, cells.columns.get("id", 0)))
    return has_id and not cells.records[record][0].value.startswith("    ") and cells.value(record, 0) != "Student, Test"


def _points(cells: CellText, record: int, place: int) -> float | None:
    number = filled_in(cells.value(record, place), ".")
    return number.value if number.is_number else None
