"""SOURCE, roster and worksheet -> which students to grade, and by which variant.

Enters: an opened `Source`, the roster or one variant, Moodle's worksheet if there is one.  Leaves: `ClassList`.
Raises `InputError` before anything is graded.  Used by `gradebook.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from coursework.grading.batch.decisions import Override
from coursework.grading.batch.work import Task, VariantSource
from coursework.grading.collecting.file_lists import FileList
from coursework.grading.collecting.matching import match
from coursework.grading.collecting.sources import Source
from coursework.grading.marking.late import LATE, OF_FILE, UNKNOWN
from coursework.grading.platforms.roster import ACCEPTED, Student
from coursework.grading.platforms.worksheet import Worksheet, WorksheetRow
from coursework.grading.reading.equations.variant_files import is_variant_file
from coursework.grading.reading.submission import Submission
from coursework.system.frozen import frozen
from coursework.variant.catalogue import find
from coursework.variant.reading.reader import read_variant
from coursework.variant.record.variant import Variant
from coursework.variant.toml.source import MAX_BYTES
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say

_DECIMALS = re.compile(r"(?:[0-9]|1[0-5])?")
MOST = 500  # variants: with more the class is a whole university, and to compare a table with all of them helps nobody


@frozen
class Place:
    """One student to grade: the variant, the file lists (empty: nothing handed in), the row in the worksheet if there is one.

    `accepted_decimals` come from the roster, None if it has no such column.
    """

    id: str
    name: str | None
    email: str
    variant: str
    file_lists: tuple[FileList, ...]
    row: WorksheetRow | None = None
    accepted_decimals: int | None = None


@frozen
class ClassList:
    """All students to grade, by id; `sources` and `variants` by the variant's name; file lists of nobody on the roster."""

    places: tuple[Place, ...]
    sources: Mapping[str, VariantSource]
    variants: Mapping[str, Variant]
    not_on_roster: tuple[FileList, ...]

    def tasks(self, source: Source, overrides: Mapping[str, tuple[Override, ...]], timed: bool = False) -> Iterator[Task]:
        """Yield the tasks; files are read when a task is drawn.  If `timed`, a task says when the files were handed in."""
        for place in self.places:
            decisions = overrides.get(place.id, ())
            yield Task(
                _collected(source, place),
                self.sources[place.variant],
                decisions,
                place.accepted_decimals,
                handed_in(source, place) if timed else "",
            )


def handed_in(source: Source, place: Place) -> str:
    """Return the worksheet's time, or LATE by Canvas, or that of the newest file after OF_FILE, or UNKNOWN.

    It is "" if Canvas does not say late, or if nothing was handed in.
    """
    if place.row and place.row.modified:
        return place.row.modified.isoformat()
    if any(file_list.late for file_list in place.file_lists):
        return LATE
    if source.platform == "canvas" or not (place.file_lists and place.file_lists[0].files):
        return ""
    newest = source.newest(place.file_lists[0])
    return f"{OF_FILE}{newest.isoformat()}" if newest else UNKNOWN


def _collected(source: Source, place: Place) -> Submission:
    if not place.file_lists:
        return Submission(place.id, place.name, ())
    found = source.collect(place.file_lists[0])
    listed = tuple(file_list.folder or file_list.id for file_list in place.file_lists)
    review = say("reading.review.resubmitted", names=listed) if len(listed) > 1 else found.review
    return replace(found, id=place.id, name=place.name or found.name, review=review)


def class_of_one(source: Source, variant: str, worksheet: Worksheet | None) -> ClassList:
    """Return a class in which all students have the same variant; their ids come from SOURCE.

    A row of Moodle's worksheet whose number SOURCE does not have is a student who handed in nothing; but if SOURCE has none of
    the numbers, it belongs to groups or to another worksheet, and nobody is said to be missing.
    """
    chosen = read_source(variant, Path())
    rows = {row.number: row for row in worksheet.rows if row.number} if worksheet else {}
    places = []
    for file_list in source.file_lists:
        row = rows.get(file_list.number)
        name = file_list.name or (row.name if row else "") or None
        places.append(Place(file_list.id, name, row.email if row else "", chosen[1].name, (file_list,), row))
    taken = {file_list.number for file_list in source.file_lists}
    if source.platform == "moodle" and taken & rows.keys():
        absent = (number for number in rows if number not in taken)
        places += [Place(one, rows[one].name or None, rows[one].email, chosen[1].name, (), rows[one]) for one in absent]
    return ClassList(_by_id(places), {chosen[1].name: chosen[1]}, {chosen[1].name: chosen[0]}, ())


def class_of_roster(source: Source, roster: Sequence[Student], file: Path, worksheet: Worksheet | None) -> ClassList:
    """Return the class of a roster, each student with the variant given there.  Raises `InputError` with every fault."""
    faults: list[Fault] = []
    read: dict[str, tuple[Variant, VariantSource]] = {}
    for student in roster:
        if not _DECIMALS.fullmatch(student.more.get(ACCEPTED, "").strip()):
            message = say("fault.G070", column=ACCEPTED, text=student.more[ACCEPTED][:40])
            faults.append(Fault(message, str(file), student.line))
        if not student.variant:
            faults.append(Fault(say("fault.G027"), str(file), student.line))
        elif student.variant not in read:
            try:
                found = read_source(student.variant, file.parent)
                taken = any(source.name == found[1].name for _, source in read.values())
                named = replace(found[1], name=student.variant) if taken else found[1]
                read[student.variant] = found[0], named
            except InputError as error:
                faults += [Fault(fault.message, str(file), student.line, place=student.variant) for fault in error.faults]
    if faults:
        raise InputError(faults)
    matched = match(roster, source.file_lists, source.platform, worksheet)
    places = [
        Place(
            student.id, student.name or None, student.email, read[student.variant][1].name,
            matched.file_lists.get(student.id, ()), matched.rows.get(student.id),
            int(decimals) if (decimals := student.more.get(ACCEPTED, "").strip()) else None,
        )
        for student in roster
    ]  # fmt: skip
    sources = {found[1].name: found[1] for found in read.values()}
    variants = {found[1].name: found[0] for found in read.values()}
    return ClassList(_by_id(places), sources, variants, matched.not_on_roster)


def read_source(name: str, folder: Path) -> tuple[Variant, VariantSource]:
    """Return a variant and its bytes, from a name in the catalogue or a path relative to `folder`.  Raises `InputError`."""
    path = folder / name
    is_file = path.is_file()
    if is_file and not _is_variant(path):
        raise InputError([Fault(say("fault.G066"), str(path))])  # the message quotes nothing of the file
    variant = read_variant(path if is_file else find(name))
    assert variant.path is not None
    content = variant.path.read_bytes()
    beside = [law.file for law in variant.laws if law.file]
    return variant, VariantSource(
        variant.path.stem, content, {file: (variant.path.parent / file).read_bytes() for file in beside}
    )


def _is_variant(path: Path) -> bool:
    """Return whether a file looks like a variant; also True if it is too large or unreadable, as its reader then says why."""
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except OSError:
        return True
    return len(content) > MAX_BYTES or is_variant_file(content.decode("utf-8", errors="replace"))


def _by_id(places: Sequence[Place]) -> tuple[Place, ...]:
    return tuple(sorted(places, key=lambda place: place.id))


def class_tables(variants: Mapping[str, Variant]) -> dict[str, list[list[float]]]:
    """Return Euler's table of each variant by name; empty if there is only one variant or more than MOST."""
    if not 1 < len(variants) <= MOST:
        return {}
    from coursework.grading.marking.key.key import tables_of

    return {name: rows.tolist() for name, rows in tables_of(variants).items()}
