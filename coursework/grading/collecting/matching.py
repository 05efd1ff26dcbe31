"""File lists, a roster, Moodle's worksheet if there is one -> which file list belongs to which student.

Enters: `Student`s, `FileList`s, `Worksheet`.  Leaves: `Matched`.
Used by the code that grades a class.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence

from coursework.grading.collecting.file_lists import FileList
from coursework.grading.platforms.names import name_key, same_key
from coursework.grading.platforms.roster import Student
from coursework.grading.platforms.worksheet import Worksheet, WorksheetRow
from coursework.system.frozen import frozen
from coursework.system.grouped import grouped


@frozen
class Matched:
    """File lists by the student's id on the roster; those of nobody on the roster; the worksheet's row of each student."""

    file_lists: Mapping[str, tuple[FileList, ...]]
    not_on_roster: tuple[FileList, ...]
    rows: Mapping[str, WorksheetRow]


def match(
    roster: Sequence[Student], file_lists: Iterable[FileList], platform: str, worksheet: Worksheet | None = None
) -> Matched:
    """Return which file lists belong to which student.  Several lists of one student are left to the caller to review.

    Moodle: number of the folder -> row of the worksheet -> e-mail, ID number or full name on the roster; without a worksheet
    the full name.  Canvas: user number or name.  Folders: the id.  A list that fits nobody, or several, is not on the roster.
    """
    people = _People(roster)
    rows = {row.number: row for row in worksheet.rows if row.number} if worksheet else {}
    of_row = {student.id: row for row in (worksheet.rows if worksheet else ()) if (student := people.of_row(row))}
    found: dict[str, list[FileList]] = {}
    others: list[FileList] = []
    for file_list in file_lists:
        called = file_list.folder or file_list.shared or file_list.id  # Moodle's number may be another student's id
        student = people.by_id.get(same_key(called))
        if student is None and platform == "moodle":
            row = rows.get(file_list.number)
            student = people.of_row(row) if row else (None if worksheet else people.by_name.get(name_key(file_list.name or "")))
        elif student is None and platform == "canvas":
            student = people.by_id.get(same_key(file_list.number)) or people.by_letters.get((file_list.name or "").casefold())
        if student is None:
            others.append(file_list)
        else:
            found.setdefault(student.id, []).append(file_list)
    return Matched({student: tuple(listed) for student, listed in found.items()}, tuple(others), of_row)


class _People:
    """The roster, with an index for each way in which platforms identify a student."""

    def __init__(self, students: Sequence[Student]) -> None:
        self.by_id = {same_key(student.id): student for student in students}
        self.by_email = _unique((student.email.casefold(), student) for student in students if student.email)
        self.by_name = _unique((name_key(student.name), student) for student in students if student.name)
        self.by_letters = _unique((letters, student) for student in students for letters in _run_together(student.name))

    def of_row(self, row: WorksheetRow) -> Student | None:
        """Return the student of a worksheet's row: by e-mail, else ID number, else a full name that is unique on both sides."""
        return (
            self.by_email.get(row.email.casefold())
            or (self.by_id.get(same_key(row.id_number)) if row.id_number else None)
            or (self.by_name.get(name_key(row.name)) if row.name_is_unique else None)
        )


def _unique(pairs: Iterable[tuple[str, Student]]) -> dict[str, Student]:
    """Return the pairs whose key belongs to only one student."""
    found = grouped(pairs).items()
    return {key: students[0] for key, students in found if len({student.id for student in students}) == 1 and key}


def _run_together(name: str) -> set[str]:
    """Return a name as Canvas writes it in file names: letters only, in the given order and with the last word first."""
    words = [re.sub(r"[\W_]", "", word) for word in unicodedata.normalize("NFC", name).casefold().replace(",", " ").split()]
    return {"".join(words), "".join([*words[-1:], *words[:-1]])} if words else set()
