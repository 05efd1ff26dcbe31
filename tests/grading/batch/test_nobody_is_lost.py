"""Whatever names a disk has and whoever writes into OUT: everybody has a grade, the same bytes as alone."""

import json
import os
import subprocess
import sys
import unicodedata
import zipfile
from hashlib import sha256

import numpy as np
import pytest

from coursework.grading.batch.journal import Entry, Journal
from coursework.grading.platforms.escapes import text_cell
from coursework.system.files import lock
from coursework.words.data_folders import folder
from coursework.words.errors import OutputError
from tests.grading.batch.classroom import EQUATIONS, csv, hand_in, small_class
from tests.grading.batch.test_batch import grade, rows, submissions
from tests.grading.marking import students

posix = pytest.mark.skipif(os.name != "posix", reason="names of any bytes, links and pipes are of POSIX")


def bytes_of(out):
    return {path.relative_to(out).as_posix(): sha256(path.read_bytes()).hexdigest() for path in out.rglob("*") if path.is_file()}


@posix
def test_names_that_are_no_text_cost_nobody(tmp_path):
    source = tmp_path / "in"
    hand_in(source / "ada")
    table = csv(students.table())
    (source / "bert").mkdir()
    for name in (b"\xff.csv", b"caf\xe9.csv"):
        (source / "bert" / os.fsdecode(name)).write_bytes(table)
    (source / os.fsdecode(b"\xe8\xe2\xe0\xed")).mkdir()
    assert grade(source, tmp_path / "out").exit_code == 0
    found = submissions(tmp_path / "out")
    assert sorted(found) == ["\\xe8\\xe2\\xe0\\xed", "ada", "bert"]
    assert {entry["name"] for entry in found["bert"]["files"]} == {"\\xff.csv", "caf\\xe9.csv"}
    assert found["ada"]["status"] == "graded"


@posix
def test_folders_of_random_bytes_are_all_found(tmp_path):
    chance = np.random.default_rng(4)
    names = {bytes(chance.integers(1, 256, chance.integers(1, 20)).tolist()).replace(b"/", b"_").strip(b".~") for _ in range(300)}
    names = {name for name in names if name and not name.startswith((b".", b"~"))}
    (tmp_path / "in").mkdir()
    for name in names:
        (tmp_path / "in" / os.fsdecode(name)).mkdir()
    assert grade(tmp_path / "in", tmp_path / "out", "--no-pages").exit_code == 0
    assert len(submissions(tmp_path / "out")) == len([*(tmp_path / "in").iterdir()])


@pytest.mark.long
@posix
@pytest.mark.parametrize("jobs", [1, 2])
def test_two_spellings_of_one_name_are_two_people_whom_somebody_must_look_at(tmp_path, jobs):
    name = "René"
    for form, table in (("NFC", students.table()), ("NFD", students.table(students.heun))):
        hand_in(tmp_path / "in" / unicodedata.normalize(form, name), table)
    assert grade(tmp_path / "in", tmp_path / "out", "--jobs", jobs).exit_code == 0
    found = submissions(tmp_path / "out")
    assert sorted(found) == [name, f"{name}~2"]
    assert {entry["status"] for entry in found.values()} == {"needs-review"}
    assert len({entry["proposed"] for entry in found.values()}) == 2


def test_one_bad_name_in_a_zip_costs_that_entry_at_most(tmp_path):
    target = tmp_path / "in.zip"
    with zipfile.ZipFile(target, "w") as file:
        for student in ("ada", "berté"):
            file.writestr(f"{student}/table.csv", csv(students.table()))
        file.writestr("../outside/table.csv", b"x")
    content = target.read_bytes().replace("berté".encode(), b"bert\xff\xfe")
    target.write_bytes(content)
    done = grade(target, tmp_path / "out")
    assert done.exit_code == 0, done.output
    found = submissions(tmp_path / "out")
    assert len(found) == 2
    assert found["ada"]["table"]["score"] == 60.0
    assert "../outside/table.csv" in done.output


DAMAGED = [
    b'{"key":"x","id":"ada","grade":{},"page":""}', b"[1,2,3]", b"NaN", b"[" * 100_000, b'{"sum":"0","entry":"{}"}',
    b'{"sum":"0","entry":[]}', b"\xff\xfe",
]  # fmt: skip


@pytest.fixture(scope="module")
def one(tmp_path_factory):
    """A submission, what was made of it, and the grade that a journal says of it."""
    root = tmp_path_factory.mktemp("one")
    hand_in(root / "in" / "ada")
    assert grade(root / "in", root / "out").exit_code == 0
    return root


@pytest.mark.parametrize("line", DAMAGED)
def test_a_damaged_line_of_the_journal_is_skipped(one, tmp_path, line):
    """Before the good lines and behind them; a line whose sum is not its own is damaged as well."""
    good = (one / "out" / "journal.jsonl").read_bytes()
    for content, kept in ((line + b"\n" + good, 1), (good + line + b"\n", 1), (good.replace(b"100.0", b"999.0"), 0)):
        (tmp_path / "journal.jsonl").write_bytes(content)
        with Journal(tmp_path) as journal:
            assert len(journal.places()[0]) == kept


def test_what_a_damaged_journal_had_is_marked_anew(one):
    before = bytes_of(one / "out")
    journal = one / "out" / "journal.jsonl"
    journal.write_bytes(b"\n".join([*DAMAGED, journal.read_bytes().replace(b"100.0", b"999.0")]))
    assert grade(one / "in", one / "out").exit_code == 0
    assert bytes_of(one / "out") == before


@posix
@pytest.mark.parametrize("kind", ["folder", "pipe", "link"])
def test_a_journal_that_is_no_file_is_refused(tmp_path, kind):
    hand_in(tmp_path / "in" / "ada")
    out, other = tmp_path / "out", tmp_path / "other"
    out.mkdir()
    other.write_bytes(b"kept")
    place = out / "journal.jsonl"
    {"folder": place.mkdir, "pipe": lambda: os.mkfifo(place), "link": lambda: place.symlink_to(other)}[kind]()
    done = grade(tmp_path / "in", out)
    assert (done.exit_code, done.output.count("W016")) == (2, 1)
    assert other.read_bytes() == b"kept"


@pytest.mark.parametrize("with_rubric", [True, False])
def test_a_total_that_moodle_would_refuse_is_told_with_the_rubric_it_comes_from(tmp_path, with_rubric):
    hand_in(tmp_path / "in" / "Ada_7000_assignsubmission_file_")
    (tmp_path / "own.toml").write_text("points = 90\n", encoding="utf-8")
    sheet = tmp_path / "sheet.csv"
    head = "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (grade),Comments"
    sheet.write_text(f"{head}\nParticipant 7000,Ada,a@x.edu,s,,80.00,Yes,-,\n", encoding="utf-8")
    own = ["--rubric", str(tmp_path / "own.toml")] if with_rubric else []
    done = grade(tmp_path / "in", tmp_path / "out", "--worksheet", str(sheet), *own)
    assert done.exit_code == 2
    assert ("own.toml gives 90 points" if with_rubric else "and the default rubric gives 100 points") in done.output


@posix
def test_pages_are_not_written_through_a_link(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    out, other = tmp_path / "out", tmp_path / "other"
    out.mkdir()
    other.mkdir()
    (out / "feedback").symlink_to(other)
    assert grade(tmp_path / "in", out).exit_code == 2
    assert list(other.iterdir()) == []


def test_results_among_submissions_are_refused(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    for out in (tmp_path / "in", tmp_path / "in" / "marks"):
        done = grade(tmp_path / "in", out)
        assert (done.exit_code, done.output.count("C074")) == (2, 1)
    assert grade(tmp_path / "in", tmp_path / "in-marks").exit_code == 0


def test_a_folder_is_held_by_one_process_and_let_go_when_it_ends(tmp_path):
    with lock.held(tmp_path), pytest.raises(OutputError, match=str(os.getpid())), lock.held(tmp_path):
        pass
    (tmp_path / "feedback").mkdir()
    (tmp_path / "feedback" / ".coursework-0123456789ab.part").write_bytes(b"begun by a process that was killed")
    with lock.held(tmp_path):
        pass
    assert [path.name for path in tmp_path.rglob("*")] == ["feedback"]


@pytest.mark.long
def test_two_graders_at_once_leave_the_bytes_of_one(tmp_path):
    source = small_class(tmp_path / "in")
    assert grade(source, tmp_path / "alone").exit_code == 0
    expected = bytes_of(tmp_path / "alone")
    command = [sys.executable, "-m", "coursework", "grade", str(source), "--variant", "31", "--jobs", "1", "--out"]
    for round_ in range(2):
        out = tmp_path / f"out{round_}"
        two = [subprocess.Popen([*command, str(out)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(2)]
        states = sorted(process.wait() for process in two)
        assert states in ([0, 0], [0, 2])
        assert bytes_of(out) == expected


def test_a_line_stands_where_the_journal_says_even_if_the_file_has_grown(tmp_path):
    with Journal(tmp_path) as journal:
        first = journal.add(Entry("k1", "a", {"status": "graded", "score": 1.0}))
        with (tmp_path / "journal.jsonl").open("ab") as other:
            other.write(b"something else\n")
        second = journal.add(Entry("k2", "b", {"status": "graded", "score": 2.0}))
        assert (journal.read(first).id, journal.read(second).id) == ("a", "b")
        assert journal.places()[0] == {"k1": first, "k2": second}


def test_a_rubric_of_brackets_is_one_sentence(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    (tmp_path / "rubric.toml").write_text("points = " + "[" * 9_999, encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--rubric", tmp_path / "rubric.toml")
    assert done.exit_code == 2
    assert len(done.output.strip().splitlines()) <= 2


@pytest.mark.parametrize(("text", "safe"), [
    ('a;=HYPERLINK("x")', "a;'=HYPERLINK(\"x\")"), ("a\n=1+1", "a\n'=1+1"), ("x; -3 follows", "x; -3 follows"),
    ("x;-3+cmd|1", "x;'-3+cmd|1"),
    ("a; b = c", "a; b = c"), ("-0.5; text", "'-0.5; text"),
])  # fmt: skip
def test_a_formula_behind_a_separator_is_none(text, safe):
    assert text_cell(text) == safe


def test_json_of_the_class_can_be_read_whatever_the_names(tmp_path):
    hand_in(tmp_path / "in" / "a;=1")
    assert grade(tmp_path / "in", tmp_path / "out").exit_code == 0
    assert [*submissions(tmp_path / "out")] == ["a;=1"]
    assert json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))


def test_an_equation_nobody_can_read_is_a_question_with_points_proposed_and_never_a_deduction(tmp_path):
    hand_in(tmp_path / "in" / "ivan", equations=(*EQUATIONS[:3], "w3*zeta(phi3) - r2*w2*cos(phi2) = 0"))
    assert grade(tmp_path / "in", tmp_path / "out").exit_code == 0
    entry = submissions(tmp_path / "out")["ivan"]
    assert (entry["status"], entry["score"], entry["proposed"]) == ("needs-review", None, 90.0)
    assert "zeta" in rows(tmp_path / "out")["ivan"]["sentence"]
    assert "zeta" in (tmp_path / "out" / "class.html").read_text(encoding="utf-8")


def test_what_is_no_variant_is_not_quoted_and_long_ids_are_cut(tmp_path):
    (tmp_path / "in" / "ada").mkdir(parents=True)
    (tmp_path / "private.txt").write_text("a secret = 'x' [[[", encoding="utf-8")
    (tmp_path / "roster.csv").write_text("id,name,email,variant\nada,A,a@b,private.txt\n", encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--roster", tmp_path / "roster.csv")
    assert (done.exit_code, "secret" in done.output, done.output.count("G066")) == (2, False, 1)
    own = tmp_path / "own.toml"
    own.write_text(
        (folder("variants") / "31.toml").read_text(encoding="utf-8").replace("format = 1\n", ""), encoding="utf-8"
    )  # it is 1 where left out
    (tmp_path / "roster.csv").write_text("id,name,email,variant\nada,A,a@b,own.toml\n", encoding="utf-8")
    assert grade(tmp_path / "in", tmp_path / "own", "--roster", tmp_path / "roster.csv").exit_code == 0
    long = "x" * 300
    (tmp_path / "roster.csv").write_text(f"id,name,email,variant\n{long},A,a,31\n{long},B,b,31\n", encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--roster", tmp_path / "roster.csv")
    assert (done.exit_code, "x" * 81 in done.output) == (2, False)


def test_an_empty_address_of_a_scheduler_is_said_to_be_this_machine(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    done = grade(tmp_path / "in", tmp_path / "out", "--scheduler", "")
    assert (done.exit_code, "on this machine" in done.output) == (0, True)


@posix
def test_an_id_made_for_a_twin_is_nobody_else_s(tmp_path):
    for name in (unicodedata.normalize("NFC", "René"), unicodedata.normalize("NFD", "René"), "René~2"):
        hand_in(tmp_path / "in" / name)
    assert grade(tmp_path / "in", tmp_path / "out").exit_code == 0
    found = submissions(tmp_path / "out")
    assert sorted(found) == ["René", "René~2", "René~3"]
    assert [found[student]["status"] for student in sorted(found)] == ["needs-review", "graded", "needs-review"]


def test_a_variant_that_stops_at_once_is_told_and_costs_nobody(tmp_path):
    """At tan(phi3) = -2 the first block is singular: its file is at fault, not the program, and the others have their marks."""
    dead = (folder("variants") / "31.toml").read_text(encoding="utf-8").replace("2.87 rad", "2.034443935795703 rad")
    (tmp_path / "dead.toml").write_text(dead, encoding="utf-8")
    for student in ("ada", "bert"):
        hand_in(tmp_path / "in" / student)
    (tmp_path / "roster.csv").write_text("id,name,email,variant\nada,A,a@b,dead.toml\nbert,B,b@b,31\n", encoding="utf-8")
    assert grade(tmp_path / "in", tmp_path / "out", "--roster", tmp_path / "roster.csv").exit_code == 0
    found = rows(tmp_path / "out")
    assert {student: row["status"] for student, row in found.items()} == {"ada": "needs-review", "bert": "graded"}
    assert "the motion stops at once" in found["ada"]["sentence"]
    assert "dead point" in found["ada"]["sentence"]
    assert (tmp_path / "out" / found["ada"]["page"]).is_file()


def test_each_file_of_canvas_counts_also_without_names_and_who_is_not_in_the_export_is_told(tmp_path):
    """Two files of one student have two numbers; while marking is anonymous nobody is in the export, and everybody is marked."""
    hand_in(tmp_path / "made")
    (tmp_path / "in").mkdir()
    for begin in ("anon_aB3xY_77", "LATE_anon_Qz9Kk_80", "rightada_101_55"):
        for number, file in enumerate(("table.csv", "equations.txt")):
            (tmp_path / "in" / f"{begin}{number}_{file}").write_bytes((tmp_path / "made" / file).read_bytes())
    export = tmp_path / "export.csv"
    export.write_text('Student,ID,Work (9)\n    Points Possible,,100\n"Right, Ada",101,\n', encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--canvas", export)
    assert {name: one["score"] for name, one in submissions(tmp_path / "out").items()} == {
        "101": 100, "anon_aB3xY": 100, "anon_Qz9Kk": 100,
    }  # fmt: skip
    assert (tmp_path / "out" / "canvas.csv").read_text(encoding="utf-8-sig").splitlines()[2] == '"Right, Ada",101,100'
    assert "no line of the Canvas export belongs: 2; their points" in done.output
    for file in (tmp_path / "in").glob("*anon*"):
        file.unlink()
    assert "Canvas export" not in grade(tmp_path / "in", tmp_path / "out", "--canvas", export).output
