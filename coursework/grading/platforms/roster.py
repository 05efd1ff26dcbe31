"""ROSTER.csv -> the students of the class and the variant of each.

Enters: the bytes of a roster.  Leaves: `Student`s.  Raises `InputError`.
Used by the code that grades a class.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from dataclasses import field

from coursework.grading.platforms.cells_of_csv import read_cells
from coursework.grading.platforms.names import same_key
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

COLUMNS = ("id", "name", "email", "variant")
ACCEPTED = "accepted_decimals"  # a further column, with the same number for all variants of one template


@frozen
class Student:
    """One line of the roster; `variant` is a name in the catalogue or a path beside the roster; further columns are kept."""

    id: str
    name: str
    email: str
    variant: str
    more: Mapping[str, str] = field(default_factory=dict)
    line: int = 0


def read_roster(content: bytes, file: str, head: str = "id,name,email,variant") -> tuple[Student, ...]:
    """Return all students of the class, in the order of the file; `head` is the first line that is advised.

    Raises `InputError` with every fault: no column "id", or an id that is missing or not unique.
    """
    cells = read_cells(content, file)
    if not cells.records:
        raise InputError([Fault(say("fault.G017", line=head), file)])
    titles = cells.titles
    if "id" not in cells.columns:
        advice = closest("id", titles) or say("hint.first_line", line=head)
        raise InputError([Fault(say("fault.G018", head=", ".join(titles[:10]), advice=advice), file, 1)])
    students: list[Student] = []
    faults: list[Fault] = []
    seen: dict[str, int] = {}
    more = {title: place for place, title in enumerate(titles) if title.casefold() not in COLUMNS}
    for record, told in cells.named(COLUMNS):
        line = cells.records[record][0].line
        if not any(cell.value.strip() for cell in cells.records[record]):
            continue
        student = unicodedata.normalize("NFC", told["id"])
        if not student:
            faults.append(Fault(say("fault.G019"), file, line))
        elif first := seen.get(same_key(student)):
            faults.append(Fault(say("fault.G020", student=student[:80], first=first), file, line))
        seen.setdefault(same_key(student), line)
        kept = {title: cells.value(record, place) for title, place in more.items()}
        students.append(Student(student, told["name"], told["email"], told["variant"], kept, line))
    if faults:
        raise InputError(faults)
    return tuple(students)
