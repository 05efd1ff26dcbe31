"""A roster and an assignment -> all files for the students and their instructor.

Enters: `Student`s, `Assignment`, the folder OUT.  Leaves: variant files, sheets, keys, roster.csv, class.html, and, if asked
for, one PDF.  Used by `commands/assign.py`.

The data of a student depend on that student alone; a further student adds files and a row and changes class.html.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from coursework.assigning.class_page import class_page
from coursework.assigning.handout import Handout, difficulty_text, make_handout
from coursework.assigning.key import key_csv, key_equations, key_html
from coursework.assigning.page_words import Plain
from coursework.assigning.ranges import MEASURES
from coursework.assigning.sheet import sheet, sheet_html
from coursework.assigning.variants import Assignment
from coursework.grading.marking.rubric import Rubric
from coursework.grading.platforms.escapes import text_cell
from coursework.grading.platforms.roster import ACCEPTED, Student
from coursework.report.pages.pdf import pdf_of
from coursework.report.text.words import Words
from coursework.scene.quantities import TABLE
from coursework.scene.scene import Scene
from coursework.scene.scene_run import SceneRun
from coursework.system.files.csv_text import csv_text
from coursework.system.files.whole_files import refused, write_bytes
from coursework.system.frozen import frozen

ROSTER, CLASS, PDF = "roster.csv", "class.html", "sheets.pdf"


@frozen
class Wishes:
    """How the files are made: the `seed` as typed, the text of the `deadline`, whether there is a PDF.

    By the `rubric` a sheet says what the program marks and what a person looks at.  With `workbooks` each student gets a
    workbook, whose first row has its formulas if `help_level` is 1.
    """

    seed: str
    deadline: str
    pdf: bool
    rubric: Rubric
    workbooks: bool
    help_level: int


def assign(
    roster: Sequence[Student], assignment: Assignment, out: Path, wishes: Wishes, words: Words,
    drawn: Callable[[int], None], made: Callable[[int], None], missed: Callable[[str], None],
) -> list[str]:  # fmt: skip
    """Write the files of a class and return their kinds; nothing is written if one student gets no variant.

    `drawn` and `made` are called with how many more students have data and files, `missed` with the letters that the PDF
    shows as boxes.  Raises `InputError`, `OutputError`.
    """
    if wishes.workbooks:
        from coursework.system.extras import require
        from coursework.takeaway.workbook.book import task_workbook

        require("xlsxwriter", "xlsx", "workbook")  # before any file is written
    individuals = assignment.individuals([student.id for student in roster], drawn)
    equations = key_equations(Scene(assignment.template, assignment.settings), words)
    for name, content in assignment.tables.items():
        _write(out / name, content)
    handouts: list[Handout] = []
    pages: list[Plain] = []
    for student, individual in zip(roster, individuals, strict=True):
        handout = make_handout(student, individual, assignment.accepted_decimals)
        page = sheet(handout, words, wishes.deadline, wishes.rubric)
        _write(out / f"{handout.stem}.toml", individual.content)
        _write(out / "sheets" / f"{handout.stem}.html", sheet_html(page).encode("utf-8"))
        _write(out / "key" / f"{handout.stem}.csv", key_csv(handout).encode("utf-8"))
        _write(out / "key" / f"{handout.stem}.html", key_html(handout, equations, words).encode("utf-8"))
        if wishes.workbooks:
            content = task_workbook(SceneRun(handout.scene, (TABLE.name,)), words.phrases.language, wishes.help_level)
            _write(out / "workbooks" / f"{handout.stem}.xlsx", content)
        handouts.append(handout)
        pages.append(page)
        made(1)
    written = ["ID.toml", "sheets/ID.html", "key/ID.csv", "key/ID.html", ROSTER, CLASS]
    if wishes.workbooks:
        written.append("workbooks/ID.xlsx")
    if wishes.pdf:
        paper = pdf_of("sheets.typ", pages)  # each sheet begins on a new page
        _write(out / PDF, paper.content)
        missed(paper.missing)
        written.append(PDF)
    _write(out / CLASS, class_page(handouts, assignment, wishes.seed, words).encode("utf-8"))
    _write(out / ROSTER, roster_csv(handouts, assignment).encode("utf-8-sig"))
    return written


def roster_csv(handouts: Sequence[Handout], assignment: Assignment) -> str:
    """Return the roster for `grade --roster`, with the drawn data and their difficulty; further columns are kept."""
    names = [one.name for one in assignment.ranges.ranges]
    head = ["id", "name", "email", "variant", "least_decimals", ACCEPTED, *names, *MEASURES]
    more = [key for key in handouts[0].student.more if key not in head]
    rows = [
        [
            handout.student.id, text_cell(handout.student.name), handout.student.email, f"{handout.stem}.toml",
            handout.least_decimals, assignment.accepted_decimals,
            *(handout.individual.accepted.values[one.path] for one in assignment.ranges.ranges),
            *(difficulty_text(handout.individual.accepted.numbers[name]) for name in MEASURES),
            *(text_cell(handout.student.more.get(key, "")) for key in more),
        ]
        for handout in handouts
    ]  # fmt: skip
    return csv_text([*head, *more], rows, "\r\n")


def _write(path: Path, content: bytes) -> None:
    """Write a file, unless it already has these bytes."""
    with refused(path):
        if path.is_file() and path.read_bytes() == content:
            return
    write_bytes(path, content)
