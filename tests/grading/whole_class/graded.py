"""A class graded by the command `coursework grade`: what was said of everybody in every place.

Enters: `Pupil`s, a folder.  Leaves: `Seen` by id.
"""

from __future__ import annotations

import html
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.grading.batch.test_batch import grade
from tests.grading.pages.seen import plain, records
from tests.grading.whole_class.pupils import Pupil

_SHEET = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission),"
    "Last modified (grade),Feedback comments"
)


@dataclass(frozen=True)
class Seen:
    """The row of grades.csv, the entry of grades.json, the words of the page, its bytes, the platform's comment."""

    row: dict[str, str]
    entry: dict[str, Any]
    page: str
    raw: str
    comment: str


def graded(pupils: list[Pupil], folder: Path) -> dict[str, Seen]:
    """Return what the command says of a class whose variants stand in `folder`."""
    roster, sheet = ["id,name,email,variant"], [_SHEET]
    for number, pupil in enumerate(pupils, 7001):
        place = folder / "in" / f"{pupil.name}_{number}_assignsubmission_file_"
        place.mkdir(parents=True)
        for name, content in pupil.files.items():
            (place / name).write_bytes(content)
        roster.append(f"{pupil.id},{pupil.name},{pupil.id}@x.edu,{pupil.mechanism}-{pupil.number}.toml")
        sheet.append(f"Participant {number},{pupil.name},{pupil.id}@x.edu,x,,100.00,Yes,-,-,")
    for name, lines in (("roster.csv", roster), ("sheet.csv", sheet)):
        (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
    out = folder / "out"
    listed = ("--roster", folder / "roster.csv", "--worksheet", folder / "sheet.csv")
    done = grade(folder / "in", out, *listed)
    assert done.exit_code == 0, done.output
    rows = {row["id"]: row for row in records(out / "grades.csv")}
    entries = {entry["id"]: entry for entry in json.loads((out / "grades.json").read_text(encoding="utf-8"))["submissions"]}
    comments = {row["Full name"]: html.unescape(row["Feedback comments"]) for row in records(out / "worksheet.csv")}
    pages = {student: (out / "feedback" / f"{student}.html").read_text(encoding="utf-8") for student in rows}
    return {
        student: Seen(row, entries[student], plain(pages[student]), pages[student], comments[row["name"]])
        for student, row in rows.items()
    }
