"""A class that hands in documents, graded from the command line: right work, another mechanism, hostile files, places."""

from __future__ import annotations

import json
import math
from contextlib import nullcontext
from pathlib import Path

import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from coursework.grading.batch.work import Setup, Task, VariantSource
from coursework.grading.reading.documents.pdf import pdf
from coursework.grading.reading.submission import Submission
from tests.grading.batch.in_this_process import in_this_process
from tests.grading.marking import students
from tests.grading.reading.documents.papers import MAKERS, word_tables
from tests.grading.reading.documents.test_hostile_documents import HOSTILE
from tests.grading.reading.documents.test_right_work import GREEK, LATEX, PLAIN, rows
from tests.mechanisms.library import mechanism

# A crank that turns evenly and drives a slider through a rod; it is in no catalogue.
SLIDER = mechanism("crank-of-a-pump")
SLIDER_LATEX = (
    r"w_a = 6.2832",
    r"r w_a \cos\alpha + l w_b \cos\beta = 0",
    r"v_B = - r w_a \sin\alpha - l w_b \sin\beta",
)


def slider() -> list[list[str]]:
    a, b, out = 0.4, -0.1142, []
    for k in range(31):
        wa = 6.2832
        wb = -0.12 * wa * math.cos(a) / (0.41 * math.cos(b))
        speed = -0.12 * wa * math.sin(a) - 0.41 * wb * math.sin(b)
        out.append([f"{k * 0.01:.2f}", *(f"{value:.4f}" for value in (a, b, wa, wb, speed))])
        a, b = a + 0.01 * wa, b + 0.01 * wb
    return out


def grade(folder: Path, out: Path, variant: str, *more: str) -> dict[str, dict]:
    with nullcontext() if "--jobs" in more else in_this_process():
        found = CliRunner().invoke(main, ["grade", str(folder), "--variant", variant, "--out", str(out), *more])
    assert found.exit_code == 0, found.output
    document = json.loads((out / "grades.json").read_text(encoding="utf-8"))
    return {entry["id"]: entry for entry in document["submissions"]}


def hand_in(folder: Path, **files: bytes) -> None:
    folder.mkdir(parents=True)
    for name, content in files.items():
        (folder / name.replace("__", ".")).write_bytes(content)


@pytest.mark.long
def test_a_class_of_documents(tmp_path: Path) -> None:
    kinds = {"docx": "word, merged", "odt": "opendocument", "pdf": "pdf, ruled", "ipynb": "notebook, page", "md": "markdown",
             "json": "json, split", "rtf": "rtf"}  # fmt: skip
    wrong = (*LATEX[:3], LATEX[3].replace("- r_1", "+ r_1"))
    for ending, kind in kinds.items():
        made = MAKERS[kind][1]
        hand_in(tmp_path / "class" / ending, **{f"work__{ending}": made(GREEK, rows(students.table(), mark=","), LATEX)})
        hand_in(tmp_path / "class" / f"{ending}-slip", **{f"work__{ending}": made(PLAIN, rows(students.table()), wrong)})
    for number, case in enumerate(sorted(HOSTILE)):
        hand_in(tmp_path / "class" / f"x{number}", work=HOSTILE[case][0]())
    found = grade(tmp_path / "class", tmp_path / "out", "31", "--jobs", "1")
    (tmp_path / "one").mkdir()
    for ending in kinds:
        assert (found[ending]["score"], found[ending]["status"][:6]) == (100.0, "graded"), ending
        assert found[ending]["files"][0]["kinds"] == ["table", "equations"] and found[ending]["files"][0]["kind"] == "table"
        assert ("from_pdf" in [note["code"] for note in found[ending]["notes"]]) is (ending == "pdf")
        items = found[f"{ending}-slip"]["equations"]["items"]
        assert [item["verdict"] for item in items] == ["right"] * 3 + ["wrong"]
        page = (tmp_path / "out" / "feedback" / f"{ending}-slip.html").read_text(encoding="utf-8")
        assert items[3]["place"] in page
        assert len(page.encode()) < 40_000
    assert {entry["status"] for student, entry in found.items() if student.startswith("x")} == {"unreadable"}
    grades = (tmp_path / "out" / "grades.csv").read_text(encoding="utf-8-sig")
    assert "An equation in the document is not right (page 1, line " in grades
    (tmp_path / "class" / "pdf-slip").rename(tmp_path / "one" / "pdf-slip")
    russian = grade(tmp_path / "one", tmp_path / "ru", "31", "--language", "ru")
    assert russian["pdf-slip"]["equations"]["items"][0]["place"].startswith("страница 1, строка ")


def test_another_mechanism(tmp_path: Path) -> None:
    path = tmp_path / "pump.toml"
    path.write_text(SLIDER, encoding="utf-8")
    heads = ["t, s", "α, rad", "β, rad", "wa, 1/s", "wb, 1/s", "vB, m/s"]
    for kind in (
        "word by pandoc",
        "word, two pages",
        "opendocument",
        "notebook, wrapped",
        "markdown",
        "json, index",
        "pdf, low bare pages",
    ):
        name, made = MAKERS[kind]
        hand_in(
            tmp_path / "class" / kind.replace(" ", "").replace(",", "-"),
            **{name.replace(".", "__"): made(heads, slider(), SLIDER_LATEX)},
        )
    found = grade(tmp_path / "class", tmp_path / "out", str(path))
    assert {student: entry["score"] for student, entry in found.items()} == dict.fromkeys(found, 100.0)


def test_precheck_reads_a_document_in_the_same_way(tmp_path: Path) -> None:
    for kind in ("word by pandoc", "notebook, printed", "pdf, bare"):
        name, made = MAKERS[kind]
        (tmp_path / name).write_bytes(made(PLAIN, rows(students.table()), LATEX))
        found = CliRunner().invoke(main, ["precheck", str(tmp_path / name), "--variant", "31"])
        assert found.exit_code == 0, found.output
        assert f"{name}: table, equations" in found.output
        assert "read as" in found.output and (
            "paragraph" in found.output or "cell 1" in found.output or "page 1, line" in found.output
        )


def test_which_extras_are_there_is_in_the_key_of_the_journal(monkeypatch: pytest.MonkeyPatch) -> None:
    task = Task(Submission("a", None, ()), VariantSource("31", b"x"))
    keys = []
    for there in (True, False):
        monkeypatch.setattr(pdf, "is_readable", lambda there=there: there)
        keys.append(task.key(Setup()).split())
    assert [first == second for first, second in zip(*keys, strict=True)] == [True, True, True, True, False]


def test_of_two_tables_in_a_document_the_fuller_one_counts(tmp_path: Path) -> None:
    good, worse = rows(students.table()), rows(students.table(students.heun))
    for number, others in enumerate((worse[:20], worse, [row[:4] for row in good])):
        hand_in(tmp_path / "class" / str(number), work__docx=word_tables([PLAIN, *good], [PLAIN[: len(others[0])], *others]))
    found = grade(tmp_path / "class", tmp_path / "out", "31", "--rubric", str(table_only(tmp_path)))
    assert [found[student]["score"] for student in "012"] == [100.0, None, 100.0]
    assert found["1"]["status"] == "needs-review"
    grades = (tmp_path / "out" / "grades.csv").read_text(encoding="utf-8-sig")
    assert "work.docx (table 1)" in grades and "work.docx (table 2)" in grades
    assert "two_tables" in [note["code"] for note in found["0"]["notes"]]


def table_only(folder: Path) -> Path:
    path = folder / "rubric.toml"
    path.write_text("[parts]\ntable = 100\nequations = 0\n", encoding="utf-8")
    return path
