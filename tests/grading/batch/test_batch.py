"""A batch is never lost: killers, hangs and hogs are told apart; a second run does only what is new; the same bytes always."""

import csv
import json
import re
import shutil
from contextlib import nullcontext
from pathlib import Path

import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from coursework.grading.batch import workers
from coursework.system.processes import pool
from tests.grading.batch.classroom import EQUATIONS, hand_in, small_class
from tests.grading.batch.in_this_process import in_this_process
from tests.grading.marking import students


def grade(source, out, *options):
    """Return what came of marking, in processes of their own where `--jobs` is given."""
    arguments = ["grade", str(source), "--out", str(out), *map(str, options)]
    if "--roster" not in options and "--variant" not in options:
        arguments += ["--variant", "31"]
    with nullcontext() if "--jobs" in options else in_this_process():
        return CliRunner().invoke(main, arguments)


def rows(out):
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def submissions(out):
    found = json.loads((out / "grades.json").read_text(encoding="utf-8"))
    return {entry["id"]: entry for entry in found["submissions"]}


@pytest.fixture(scope="module")
def graded(tmp_path_factory):
    root = tmp_path_factory.mktemp("class")
    source, out = small_class(root / "in"), root / "out"
    done = grade(source, out)
    assert done.exit_code == 0, done.output
    assert " submissions: " in done.output
    return source, out


@pytest.fixture
def copied(graded, tmp_path):
    """The same class and what was made of it, for a test that changes them."""
    return tuple(Path(shutil.copytree(folder, tmp_path / name)) for folder, name in zip(graded, ("in", "out"), strict=True))


def test_every_submission_has_a_state_and_only_graded_ones_a_number(graded):
    found = rows(graded[1])
    states = {student: row["status"] for student, row in found.items()}
    assert states == {
        "ada": "graded", "bert": "graded", "carl": "graded", "dora": "graded", "emil": "graded", "fred": "unreadable",
        "gina": "missing",
    }  # fmt: skip
    assert [found[student]["points"] for student in ("ada", "bert", "fred", "gina")] == ["100.00", "100.00", "", ""]
    assert found["carl"]["first_wrong"] == "row 11 w2"
    assert found["dora"]["misconception"] == "heun"
    assert found["emil"]["equations"] == "30.00"
    assert found["emil"]["sentence"].startswith("Line 4 of the equations is not right. A different sign of ")
    assert found["ada"]["sentence"] == ""
    assert "PDF" in found["fred"]["sentence"]


def test_grades_json_has_the_fixed_keys(graded):
    document = json.loads((graded[1] / "grades.json").read_text(encoding="utf-8"))
    assert list(document) == ["format", "rubric", "submissions", "not_on_roster", "class"]
    assert set(document["class"]) == {
        "graded", "mean", "median", "misconceptions", "first_wrong_rows", "hardest_column", "same_files",
    }  # fmt: skip
    for entry in document["submissions"]:
        assert set(entry) == {
            "id", "name", "variant", "status", "score", "max", "proposed", "files", "reading", "table", "first_wrong",
            "equations", "answers", "misconception", "verdicts", "notes", "late", "overrides", "page",
        }  # fmt: skip
        assert set(entry["table"]) == {
            "state", "score", "max", "rows", "rows_needed", "first_wrong", "wrong_cells", "missing_cells", "carried_cells",
            "decimals", "least_decimals", "computed_to",
        }  # fmt: skip


def test_pages_are_small_without_scripts_and_say_what_is_wrong(graded):
    for student in rows(graded[1]):
        page = (graded[1] / "feedback" / f"{student}.html").read_text(encoding="utf-8")
        assert len(page.encode()) <= 40_000
        assert "<script" not in page
        assert "default-src 'none'" in page
    page = (graded[1] / "feedback" / "carl.html").read_text(encoding="utf-8")
    assert "Row 11" in page
    assert "w2" in page
    assert "Of 172 cells that count, wrong: 1;" in page
    assert "All 172 cells that count are right." in (graded[1] / "feedback" / "ada.html").read_text(encoding="utf-8")
    page = (graded[1] / "feedback" / "dora.html").read_text(encoding="utf-8")
    assert "Heun" in page
    assert "too few to show" not in page  # that is for who reads grades.json
    hidden = [entry["text"] for entry in submissions(graded[1])["dora"]["notes"]]
    assert len(hidden) == 1
    assert "too few to show" in hidden[0]
    assert "rounded_omega_2" in hidden[0]
    assert submissions(graded[1])["carl"]["notes"] == []


def test_a_second_run_marks_nothing_anew_and_writes_the_same_bytes(graded, tmp_path):
    source, out = graded
    before = {path.relative_to(out): path.read_bytes() for path in out.rglob("*") if path.is_file()}
    again = grade(source, out)
    assert "Marked now: 0" in again.output
    assert {path.relative_to(out): path.read_bytes() for path in out.rglob("*") if path.is_file()} == before
    assert grade(source, tmp_path / "other", "--jobs", "2").exit_code == 0
    assert {p.relative_to(tmp_path / "other"): p.read_bytes() for p in (tmp_path / "other").rglob("*") if p.is_file()} == before


def test_a_second_run_marks_what_is_new_and_tells_what_changed(copied):
    source, out = copied
    hand_in_again = source / "carl" / "table.csv"
    from tests.grading.batch.classroom import csv as table_csv

    hand_in_again.write_bytes(table_csv(students.table()))
    (out / "feedback" / "ada.html").unlink()
    done = grade(source, out)
    assert "Marked now: 2" in done.output
    changes = (out / "changes.csv").read_text(encoding="utf-8-sig").splitlines()
    assert changes[0] == "id,before,after,reason"
    assert len(changes) == 2
    assert changes[1].startswith("carl,")
    assert changes[1].endswith(",100.00,files")


def test_a_torn_journal_loses_nothing_else(copied):
    source, out = copied
    journal = out / "journal.jsonl"
    whole = journal.read_bytes()
    journal.write_bytes(whole[:-40])
    done = grade(source, out)
    assert "Marked now: 1" in done.output
    assert journal.read_bytes() == whole


def test_decisions_of_the_instructor(copied, tmp_path):
    source, out = copied
    decided = tmp_path / "overrides.csv"
    decided.write_text('id,check,points,reason\nfred,total,55,read on paper\nemil,equations,"40,0",=right\n', encoding="utf-8")
    done = grade(source, out, "--overrides", decided)
    assert done.exit_code == 0, done.output
    found = submissions(out)
    assert (found["fred"]["status"], found["fred"]["score"]) == ("graded-with-notes", 55)
    assert found["emil"]["score"] == 100
    assert found["emil"]["overrides"] == [{"check": "equations", "points": 40.0, "reason": "=right"}]
    assert "read on paper" in (out / "feedback" / "fred.html").read_text(encoding="utf-8")


def test_a_roster_gives_each_student_a_variant(tmp_path):
    source = tmp_path / "in"
    hand_in(source / "ada")
    hand_in(source / "zoe")
    roster = tmp_path / "roster.csv"
    roster.write_text("id,name,email,variant\nada,Ada A.,a@x,31\nbob,Bob B.,b@x,v101\n", encoding="utf-8")
    done = grade(source, tmp_path / "out", "--roster", roster)
    assert done.exit_code == 0, done.output
    found = submissions(tmp_path / "out")
    assert {student: (entry["variant"], entry["status"]) for student, entry in found.items()} == {
        "ada": ("31", "graded"), "bob": ("v101", "missing"),
    }  # fmt: skip
    document = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))
    assert [entry["name"] for entry in document["not_on_roster"]] == ["zoe"]


@pytest.mark.parametrize("roster", ["id,name,email,variant\nada,A,a,3i1\n", "id,name,email,variant\nada,A,a,\n"])
def test_a_wrong_roster_stops_before_anything_is_graded(tmp_path, roster):
    hand_in(tmp_path / "in" / "ada")
    file = tmp_path / "roster.csv"
    file.write_text(roster, encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--roster", file)
    assert done.exit_code == 2
    assert "roster.csv:2" in done.output
    assert not (tmp_path / "out").exists()


def test_killers_hangs_and_hogs_are_told_apart_and_stop_nobody_else(tmp_path, monkeypatch):
    source, out = tmp_path / "in", tmp_path / "out"
    for student in ("a", "b", "killer", "c", "hang", "d", "hog", "e", "once"):
        hand_in(source / student)
    monkeypatch.setattr(workers, "OPENED", "tests.grading.batch.hostile_child:opened")
    monkeypatch.setattr(workers, "SLOWER", 1.0)  # one that sleeps spends no processor time
    monkeypatch.setenv("COURSEWORK_TEST_ONCE", str(tmp_path / "once"))
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parents[3]))
    done = grade(source, out, "--limit", "3", "--jobs", "2")
    assert done.exit_code == 0, done.output
    states = {student: entry["status"] for student, entry in submissions(out).items()}
    assert {student for student, state in states.items() if state == "graded"} == {"a", "b", "c", "d", "e", "once"}
    assert (states["killer"], states["hang"], states["hog"]) == ("crashed-grader", "timeout", "unreadable")
    monkeypatch.undo()
    again = grade(source, out)
    assert "Marked now: 2" in again.output  # the two that were no fault of theirs
    assert {entry["status"] for entry in submissions(out).values()} == {"graded", "unreadable"}


@pytest.mark.long
@pytest.mark.parametrize(("leaks", "children"), [("leaks 355", 1), ("leaks 356", 2)])
def test_a_child_that_has_grown_by_256_mib_is_replaced(tmp_path, monkeypatch, leaks, children):
    for student in ("a", leaks, "z"):
        hand_in(tmp_path / "in" / student)
    monkeypatch.setattr(workers, "OPENED", "tests.grading.batch.hostile_child:opened")
    monkeypatch.setenv("COURSEWORK_TEST_ONCE", str(tmp_path / "once"))
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parents[3]))
    started = []
    start = pool.Worker._start
    monkeypatch.setattr(pool.Worker, "_start", lambda self: (started.append(self), start(self)))
    done = grade(tmp_path / "in", tmp_path / "out", "--no-pages", "--jobs", "1")
    assert done.exit_code == 0, done.output
    assert {entry["status"] for entry in submissions(tmp_path / "out").values()} == {"graded"}
    assert len(started) == children


def test_one_submission_for_an_autograder(tmp_path):
    hand_in(tmp_path / "in", students.slip(10, 1, 1.05))
    for platform, key in (("gradescope", "score"), ("prairielearn", "score")):
        done = grade(tmp_path / "in", tmp_path / platform, "--results", platform, "--jobs", 1)  # in a process of its own
        assert done.exit_code == 0, done.output
        assert [path.name for path in (tmp_path / platform).iterdir()] == ["results.json"]
        found = json.loads((tmp_path / platform / "results.json").read_text(encoding="utf-8"))
        assert found[key] == pytest.approx(99.65 if platform == "gradescope" else 0.9965, abs=0.01)
    tests = json.loads((tmp_path / "gradescope" / "results.json").read_text(encoding="utf-8"))
    assert sum(part["score"] for part in tests["tests"]) == pytest.approx(tests["score"], abs=1e-9)


def test_a_part_not_handed_in_is_a_test_of_its_own_with_its_own_points(tmp_path):
    """The table was called worth all 100 points, and the sentence stood twice."""
    hand_in(tmp_path / "in", students.table())
    (tmp_path / "in" / "equations.txt").unlink()
    grade(tmp_path / "in", tmp_path / "out", "--results", "gradescope")
    found = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert [(part["name"], part["score"], part["max_score"]) for part in found["tests"]] == [
        ("table", 0.0, 60.0), ("equations", 0.0, 40.0),
    ]  # fmt: skip
    assert found["output"].count("equations") == 1
    (tmp_path / "rubric.toml").write_text('points = 50\nmissing_part = "zero"\n', encoding="utf-8")
    grade(tmp_path / "in", tmp_path / "out", "--results", "prairielearn", "--rubric", tmp_path / "rubric.toml")
    found = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert [(part["points"], part["max_points"]) for part in found["tests"]] == [(30.0, 30.0), (0.0, 20.0)]


def test_a_fault_of_a_rubric_stands_beside_its_file_for_an_autograder_too(tmp_path):
    hand_in(tmp_path / "in", students.table())
    (tmp_path / "own.toml").write_text('[answers]\nx = { of = "w9", row = 4 }\n', encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--results", "gradescope", "--rubric", tmp_path / "own.toml")
    assert done.exit_code == 2
    assert "own.toml" in done.output
    assert "rubric.toml" not in done.output


def test_hostile_names_stay_inside_out_and_are_escaped(tmp_path):
    source, out = tmp_path / "in", tmp_path / "out"
    for student in ("<img src=x onerror=alert(1)>", "CON", "ends.", "=cmd|calc", "x" * 120):
        hand_in(source / student)
    done = grade(source, out)
    assert done.exit_code == 0, done.output
    written = {path.name for path in (out / "feedback").iterdir()}
    assert all(name.startswith("x-") and len(name) == 23 for name in written)
    assert len(written) == 5
    page = (out / "class.html").read_text(encoding="utf-8")
    assert "<img src" not in page
    assert "'=cmd|calc" in (out / "grades.csv").read_text(encoding="utf-8-sig")


def test_the_class_page_calls_people_by_name_and_leads_to_their_pages(tmp_path):
    source = tmp_path / "in"
    given = (*EQUATIONS[:3], EQUATIONS[3].replace("- r1", "+ r1"))
    for number in range(8):
        table = students.table() if number else students.slip(9, 0, 1.2)
        hand_in(source / f"Ann {number}_70{number}_assignsubmission_file_", table, given)
    hand_in(source / "Ann 1_799_assignsubmission_file_", students.slip(8, 1, 1.2), given)
    assert grade(source, tmp_path / "out").exit_code == 0
    page = (tmp_path / "out" / "class.html").read_text(encoding="utf-8")
    assert re.search(r'<a href="feedback/700\.html">Ann 0</a></td><td><b>8\d\.\d+</b></td>', page)
    assert "row 10 <i>ω</i><sub>1</sub>" in page
    assert page.count("Ann 1_799") == page.count("Ann 1_701")  # two of one name keep what tells them apart
    assert "came from 9 people" in page  # the equations, which all have with one slip
    found = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))["class"]["same_files"]
    assert sorted(map(len, found)) == [7, 9]


def test_a_note_is_told_once(tmp_path):
    rpm = students.table()
    rpm[:, 3:] *= 60 / (2 * 3.141592653589793)
    hand_in(tmp_path / "in" / "ada", rpm)
    assert grade(tmp_path / "in", tmp_path / "out").exit_code == 0
    ada = submissions(tmp_path / "out")["ada"]
    assert (ada["score"], [entry["code"] for entry in ada["notes"]]) == (100, ["rpm"])
