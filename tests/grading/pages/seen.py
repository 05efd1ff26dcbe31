"""What a class is told of its work, in every place where it is told."""

from __future__ import annotations

import csv
import html
import io
import re
from dataclasses import dataclass
from pathlib import Path

from coursework.grading.batch.journal import Journal
from coursework.grading.marking.rubric import read_rubric
from coursework.grading.platforms.autograder import autograder_results
from tests.grading.batch.test_batch import grade
from tests.grading.pages.truths import Case, write_variants


@dataclass
class Seen:
    """What was said of one student in each place."""

    row: dict[str, str]
    page: str
    raw: str
    comment: str
    platform: str


def records(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text(encoding="utf-8-sig"), newline="")))


def plain(page: str) -> str:
    """The words of a page, names of columns and minus signs as in the files."""
    page = re.sub(r"<i>(.)</i><sub>(\d)</sub>", lambda found: found[1] + "₀₁₂₃₄₅₆₇₈₉"[int(found[2])], page)
    page = re.sub(r"<i>(.)</i>", r"\1", page)
    text = html.unescape(re.sub(r"<style>.*?</style>|<[^>]*>", " ", page, flags=re.DOTALL))
    text = re.sub(r"([φω])([₀-₉])", lambda found: {"φ": "phi", "ω": "w"}[found[1]] + str("₀₁₂₃₄₅₆₇₈₉".index(found[2])), text)
    text = re.sub(r"([rV])([₀-₉])", lambda found: found[1] + str("₀₁₂₃₄₅₆₇₈₉".index(found[2])), text)
    return re.sub(r"\s+", " ", text.replace("−", "-"))


def seen_of(handed_in: dict[str, Case], root: Path) -> dict[str, Seen]:
    """Grade the class in an empty folder and return what each student was told."""
    write_variants(root)
    (root / "rubric.toml").write_text('[[confusion]]\ndatum = "r1"\nvalue = "0.8 m"\nbecause = "AB for DA."\n', encoding="utf-8")
    roster = ["id,name,email,variant", "zz-other,Zed Zzyzx,z@x.edu,s02.toml"]
    sheet = [
        "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission),"
        "Last modified (grade),Feedback comments"
    ]
    for number, (student, (files, _)) in enumerate(handed_in.items(), 7001):
        folder = root / "in" / f"Person {number}_{number}_assignsubmission_file_"
        folder.mkdir(parents=True)
        for name, content in files.items():
            (folder / name).write_bytes(content)
        roster.append(f"id-{student},Person {number},p{number}@x.edu,s01.toml")
        sheet.append(f"Participant {number},Person {number},p{number}@x.edu,x,,100.00,Yes,-,-,")
    for name, lines in (("roster.csv", roster), ("sheet.csv", sheet)):
        (root / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
    out = root / "out"
    options = ("--roster", root / "roster.csv", "--worksheet", root / "sheet.csv", "--rubric", root / "rubric.toml")
    done = grade(root / "in", out, *options)
    assert done.exit_code == 0, done.output
    found = {row["id"]: row for row in records(out / "grades.csv")}
    comments = {row["Full name"]: row["Feedback comments"] for row in records(out / "worksheet.csv")}
    results, rubric = {}, read_rubric((root / "rubric.toml").read_text(encoding="utf-8"))
    with Journal(out) as journal:
        for place in journal.places()[1].values():
            entry = journal.read(place)
            autograder_results(entry.grade, rubric, "gradescope", root / "results.json", "en")
            results[entry.id] = (root / "results.json").read_text(encoding="utf-8")
    pages = {student: (out / "feedback" / f"{student}.html").read_text(encoding="utf-8") for student in found}
    return {
        student.removeprefix("id-"): Seen(
            row, plain(pages[student]), pages[student], html.unescape(comments.get(row["name"], "")), results[student]
        )
        for student, row in found.items()
        if student != "zz-other"
    }
