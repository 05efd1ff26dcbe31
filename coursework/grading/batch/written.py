"""The gradebook's files: grades.csv, grades.json, changes.csv, class.html, and the files for the platforms.

Enters: finished grades from the journal.  Leaves: files in OUT, each written whole, the same bytes for the same grades.
Used by the command only.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from coursework.grading.batch.class_list import ClassList, Place
from coursework.grading.batch.gradebook import Graded, page_name
from coursework.grading.marking.reasons.reasons import told
from coursework.grading.marking.rubric import Rubric
from coursework.grading.pages.class_facts import ClassFacts
from coursework.grading.pages.class_page import class_page
from coursework.grading.platforms.canvas import Gradebook
from coursework.grading.platforms.downloads import feedback_zip
from coursework.grading.platforms.escapes import text_cell
from coursework.grading.platforms.worksheet import Worksheet
from coursework.system.files.csv_text import csv_text
from coursework.system.files.whole_files import write_bytes
from coursework.words.sentences import ENGLISH, Phrases, load_phrases

COLUMNS = (
    "id", "name", "status", "points", "max", "table", "equations", "answers", "wrong_cells", "missing_cells", "first_wrong",
    "misconception", "sentence", "page",
)  # fmt: skip
FORMAT = 1
_NOT_IN_JSON = {"reason", "reasons", "hidden"}


def submission_record(place: Place, grade: Mapping[str, Any], page: str, words: Phrases) -> dict[str, Any]:
    """Return one submission as grades.json writes it."""
    kept = {key: value for key, value in grade.items() if key not in _NOT_IN_JSON}
    head = {"id": place.id, "name": place.name, "variant": place.variant}
    notes = [*grade["notes"]]
    if codes := ", ".join(grade.get("hidden") or ()):  # for readers of grades.json; the page leaves it out
        notes.append({"code": "too_coarse", "text": words.said("reading.note.not_looked_for", codes=codes)})
    if place.row and place.row.locked:
        notes.append({"code": "locked", "text": words.said("reading.note.locked")})
    page_of = {"late": grade.get("late"), "overrides": grade.get("overrides", []), "page": page_name(place.id) if page else None}
    return {**head, **kept, "notes": notes, **page_of}


def write_gradebook(
    out: Path, listed: ClassList, graded: Graded, rubric: Rubric, *, worksheet: Worksheet | None = None,
    canvas: Gradebook | None = None, moodle: bool = False, language: str = ENGLISH,
) -> list[str]:  # fmt: skip
    """Write all files except pages and journal; return their names."""
    words = load_phrases(language)
    places = {place.id: place for place in listed.places}
    facts = ClassFacts()
    lines: list[list[str]] = []
    records: list[str] = []
    for entry in graded.entries():
        place = places[entry.id]
        record = submission_record(place, entry.grade, entry.page, words)
        facts.add(record, _why(entry.grade))
        lines.append(_line(record, told(entry.grade, words)))
        records.append(json.dumps(record, ensure_ascii=False, allow_nan=False))
    strangers = [
        {"name": file_list.name or file_list.folder or file_list.id, "files": [name for name, _ in file_list.files]}
        for file_list in listed.not_on_roster
    ]
    written = ["grades.csv", "grades.json", "class.html", "changes.csv"]
    write_bytes(out / "grades.csv", _csv(COLUMNS, lines))
    write_bytes(out / "grades.json", b"".join(_json(rubric, records, strangers, facts)))
    changes = [(change.id, change.before, change.after, change.reason) for change in graded.changes]
    page = class_page(facts, changes, [(str(entry["name"]), list(entry["files"])) for entry in strangers], words)
    write_bytes(out / "class.html", page.encode("utf-8"))
    write_bytes(out / "changes.csv", _csv(("id", "before", "after", "reason"), changes))
    if worksheet is not None:
        write_bytes(out / "worksheet.csv", worksheet.filled(_marks(places, graded, words)))
        written.append("worksheet.csv")
    if canvas is not None:
        write_bytes(out / "canvas.csv", canvas.filled(_points(places, graded, canvas)))
        written.append("canvas.csv")
    if moodle:
        write_bytes(out / "feedback.zip", feedback_zip(_pages(out, places, graded)))
        written.append("feedback.zip")
    return written


def _line(record: Mapping[str, Any], sentence: str) -> list[str]:
    parts = [record[part] for part in ("table", "equations", "answers")]
    return [
        record["id"], record["name"] or "", record["status"], _number(record["score"]), _number(record["max"]),
        *(_number(part.get("score") if part else None) for part in parts),
        str(record["table"]["wrong_cells"]), str(record["table"]["missing_cells"]), record["table"]["first_wrong"] or "",
        record["misconception"]["code"] if record["misconception"] else "", sentence, record["page"] or "",
    ]  # fmt: skip


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.2f}"


def _csv(head: Sequence[str], lines: Iterable[Sequence[str]]) -> bytes:
    return csv_text(head, (map(text_cell, line) for line in lines), "\r\n").encode("utf-8-sig")


def _json(rubric: Rubric, records: Sequence[str], strangers: Sequence[Mapping[str, Any]], facts: ClassFacts) -> Iterator[bytes]:
    """Yield grades.json in pieces, with one line for each submission."""
    yield f'{{"format": {FORMAT}, "rubric": {json.dumps(rubric.plain(), ensure_ascii=False)},\n"submissions": [\n'.encode()
    yield ",\n".join(records).encode()
    tail = {"not_on_roster": strangers, "class": facts.plain()}
    yield b"\n],\n" + json.dumps(tail, ensure_ascii=False, allow_nan=False)[1:].encode() + b"\n"


def _marks(places: Mapping[str, Place], graded: Graded, words: Phrases) -> dict[int, tuple[float | None, str]]:
    """Return points and comment of each student, by the number of the worksheet's record."""
    marks: dict[int, tuple[float | None, str]] = {}
    for entry in graded.entries():
        if (row := places[entry.id].row) is not None:
            marks[row.record] = entry.grade["score"], told(entry.grade, words)
    return marks


def _points(places: Mapping[str, Place], graded: Graded, canvas: Gradebook) -> dict[int, float]:
    found = {}
    for entry in graded.entries():
        record = record_in(canvas, places[entry.id])
        if record is not None and entry.grade["score"] is not None:
            found[record] = entry.grade["score"]
    return found


def record_in(canvas: Gradebook, place: Place) -> int | None:
    """Return the record of a student in Canvas's export, None if there is none."""
    keys = (place.id, place.email, *(file_list.number for file_list in place.file_lists))
    return canvas.record_of(keys, place.name)


def _pages(out: Path, places: Mapping[str, Place], graded: Graded) -> Iterator[tuple[str, str, bytes]]:
    for entry in graded.entries():
        page = out / page_name(entry.id)
        for file_list in places[entry.id].file_lists:
            if entry.page and file_list.folder:
                yield file_list.folder, entry.id, page.read_bytes()


def _why(grade: Mapping[str, Any]) -> str:
    """Return all reasons why a person has to look at a grade, not only the first."""
    states = dict.fromkeys(str(one["text"]) for one in grade.get("reasons", ()) if one["kind"] == "state")
    return " ".join(states) or str(grade["reason"])
