"""Right work is 100 points in every kind of document, whatever its heads and its decimal mark are."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.batch.work import Setup, VariantSource
from coursework.grading.batch.workshop import Workshop
from coursework.grading.marking.grade import Grade
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.marking import students
from tests.grading.reading.documents.papers import MAKERS, Rows
from tests.grading.reading.equations.notation import notations
from tests.sample import diagonal
from tests.takeaway.taken import taken

LATEX = (
    r"V_{My} - 2 r_3 \omega_3 \cos\varphi_3 - r_3 \omega_3 \sin\varphi_3 = 0",
    r"2 r_3 \omega_3 \sin\varphi_3 - r_3 \omega_3 \cos\varphi_3 + \frac{1}{2} r_3 \omega_4 = 0",
    r"-0.5 r_3 \omega_4 + r_3 \omega_3 \cos\varphi_3 + r_2 \omega_2 \sin\varphi_2 + r_1 \omega_1 \sin\varphi_1 = 0",
    r"r_3 \omega_3 \sin\varphi_3 - r_2 \omega_2 \cos\varphi_2 - r_1 \omega_1 \cos\varphi_1 = 0",
)
PLAIN = ["t", "phi1", "phi2", "phi3", "w1", "w2", "w3", "w4"]
GREEK = ["t, с", "φ₁, рад", "φ₂, рад", "φ₃, рад", "ω₁, 1/с", "ω₂, 1/с", "ω₃, 1/с", "ω₄, 1/с"]


def rows(table: np.ndarray, decimals: int = 4, mark: str = ".") -> Rows:
    return [
        [text.replace(".", mark) for text in (f"{k * students.H:.2f}", *(f"{value:.{decimals}f}" for value in row))]
        for k, row in enumerate(table)
    ]


@cache
def workshop(rubric: str = "") -> Workshop:
    return Workshop(Setup(rubric, pages=False))


def graded(files: dict[str, bytes], variant: str = "31", rubric: str = "") -> Grade:
    handed = Submission("one", None, tuple(submitted_file(name, content) for name, content in files.items()))
    path = coursework.load(variant).path
    assert path is not None
    return workshop(rubric).grade(handed, VariantSource(variant, path.read_bytes()))


@pytest.mark.parametrize(("kind", "written"), diagonal(2, MAKERS, ("plain", "greek")))
def test_right_work_is_worth_all_points(kind: str, written: str) -> None:
    heads, mark = (PLAIN, ".") if written == "plain" else (GREEK, ",")
    name, made = MAKERS[kind]
    grade = graded({name: made(heads, rows(students.table(), mark=mark), LATEX)})
    assert grade.status in {"graded", "graded-with-notes"}, (grade.reason, grade.work.trouble)
    assert grade.total == 100.0, [(mark.verdict, mark.line.text) for mark in grade.equations.marks] if grade.equations else None
    assert grade.work.files[0].kinds == ("table", "equations")
    assert ("from_pdf" in {note.code for note in grade.work.notes}) is kind.startswith("pdf")
    assert all(mark.line.place for mark in grade.equations.marks) if grade.equations else False


@pytest.mark.parametrize("kind", MAKERS)
def test_a_slip_is_found_where_it_stands(kind: str) -> None:
    name, made = MAKERS[kind]
    wrong = (*LATEX[:3], LATEX[3].replace("- r_1", "+ r_1"))
    grade = graded({name: made(PLAIN, rows(students.slip(10, 1, 1.05)), wrong)})
    assert grade.table is not None and grade.table.first is not None and grade.equations is not None
    assert (grade.table.first.row, grade.table.first.column) == (11, "w2")
    assert [mark.verdict for mark in grade.equations.marks] == ["right"] * 3 + ["wrong"]
    assert grade.equations.marks[3].hint is not None and grade.equations.marks[3].hint.kind == "sign"


@pytest.mark.long
@pytest.mark.parametrize("kind", ["word by pandoc", "opendocument", "rtf", "markdown", "pdf, bare", "json, records"])
def test_a_name_says_nothing(kind: str) -> None:
    _, made = MAKERS[kind]
    content = made(PLAIN, rows(students.table()), LATEX)
    for name in ("table.csv", "work", "answer.xlsx", "photo.jpg"):
        assert graded({name: content}).total == 100.0, name


def test_a_report_beside_the_table_repeats_it() -> None:
    name, made = MAKERS["word by pandoc"]
    report = made(GREEK, rows(students.table(), 3, ","), LATEX)
    exact = "\n".join(";".join(row) for row in [PLAIN, *rows(students.table(), 6)]).encode()
    grade = graded({name: report, "table.csv": exact})
    assert grade.total == 100.0
    assert grade.work.table is not None and grade.work.table.reading.file == "table.csv"
    other = made(GREEK, rows(students.table(students.heun), 3, ","), LATEX)
    doubtful = graded({name: other, "table.csv": exact})
    assert doubtful.status == "needs-review" and "table 1" in str(doubtful.reason)


def test_numbers_tell_what_heads_do_not() -> None:
    """Right numbers under heads of a student's own went to a person; wrong ones, or those of another column, still do."""
    heads = {
        "in order": ["crank", "rod", "bar", *PLAIN[4:]],
        "of the other": ["rod", "crank", "bar", *PLAIN[4:]],
        "w5": [*PLAIN[:7], "w5"],
    }
    for name, order, times, points in (
        ("in order", [0, 1, 2], 1.0, 100.0),
        ("of the other", [1, 0, 2], 1.0, None),
        ("w5", [0, 1, 2], 1.0, 100.0),
        ("w5", [0, 1, 2], 1.2, None),
    ):
        table = students.table()[:, [*order, 3, 4, 5, 6]] * [1, 1, 1, 1, 1, 1, times]
        content = "\n".join(";".join(row) for row in [heads[name], *rows(table)]).encode()
        grade = graded({"table.csv": content}, rubric="[parts]\ntable = 100\nequations = 0\n")
        if points:
            assert (grade.status, grade.total) == ("graded-with-notes", points), name
        else:
            assert grade.status == "needs-review" and grade.reason is not None, name
            assert grade.reason.key == "reading.trouble.unread_heads"
            assert grade.plain()["proposed"] < 100


OWN = [
    *((name, kind) for name in ("31", "v102") for kind in ("docx", "odt", "tex", "html", "xlsx")),
    *((name, "xlsx") for name in ("example-1", "example-2", "jansen")),
    *((name, kind) for name in ("example-1", "example-2") for kind in ("docx", "tex", "html")),  # with every second row
]


@pytest.mark.long
@pytest.mark.parametrize(("name", "kind"), OWN)
def test_what_the_tool_itself_writes_is_read_whole(name: str, kind: str) -> None:
    grade = graded({file: content for file, content in taken(name, kind).items() if file.endswith(kind)}, name)
    assert grade.table is not None and grade.work.table is not None
    plain, whole = grade.plain(), all(grade.work.table.rows_present)
    assert whole is (kind == "xlsx" or name in {"31", "v102"})
    assert not whole or plain["table"]["score"] == 60.0
    assert kind == "xlsx" or plain["equations"]["score"] == 40.0


def test_an_equation_goes_on_in_the_next_paragraph() -> None:
    """What stood before the last sign of a paragraph was passed over, and the rest of it was a wrong equation."""
    texts = [line.replace(" - r2", " -| r2").replace(" + r2", " +|r2").split("|") for line in notations.PLAIN["31"].split("\n")]
    page = "".join(f"<p>{text}</p>" for pieces in texts for text in pieces)
    grade = graded({"w.html": f"<html><body><h1>Work</h1>{page}</body></html>".encode()})
    assert grade.part("equations")[0] == 40.0
