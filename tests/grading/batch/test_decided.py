"""What the instructor decided: shares, further columns; grades that a platform locks; submissions that are there no more."""

import csv
import json
from pathlib import Path

import jsonschema
import pytest

from tests.grading.batch.classroom import hand_in
from tests.grading.batch.test_batch import grade, submissions

SCHEMA = json.loads((Path(__file__).parent / "grades.schema.json").read_text(encoding="utf-8"))
HEAD = "id,check,points,reason"
SHEET = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission),"
    "Last modified (grade),Feedback comments\r\n"
)


def changes(out):
    with (out / "changes.csv").open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


SHARES = {"80 %": 48, "80%": 48, '"33,3 %"': 19.98, "100 %": 60, "0 %": 0}


def test_a_share_is_of_the_part_and_follows_a_changed_rubric(tmp_path):
    decided, rubric = tmp_path / "overrides.csv", tmp_path / "rubric.toml"
    for number in range(len(SHARES)):
        hand_in(tmp_path / "in" / f"s{number}")
    lines = [f"s{number},table,{text},x" for number, text in enumerate(SHARES)]
    decided.write_text("\n".join([HEAD, *lines]), encoding="utf-8")
    rubric.write_text("[parts]\ntable = 30\nequations = 70\n", encoding="utf-8")
    for options, share in (((), 1), (("--rubric", rubric), 1 / 2)):
        assert grade(tmp_path / "in", tmp_path / "out", "--overrides", decided, *options).exit_code == 0
        found = [entry["table"]["score"] for entry in submissions(tmp_path / "out").values()]
        assert found == pytest.approx([points * share for points in SHARES.values()])


def test_a_share_of_the_total_is_of_the_points_of_the_rubric(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    decided, rubric = tmp_path / "overrides.csv", tmp_path / "rubric.toml"
    decided.write_text(f"{HEAD}\nada,total,45 %,x\n", encoding="utf-8")
    rubric.write_text("points = 20\n", encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--overrides", decided, "--rubric", rubric)
    assert submissions(tmp_path / "out")["ada"]["score"] == 9
    assert done.output.count("The parts of the rubric sum to 100 and are scaled to 20 points.") == 1


@pytest.mark.parametrize("text", ["100.01 %", "-1 %", "%", "80 %%", "8o %"])
def test_a_share_that_is_none_stops_before_anything_is_graded(tmp_path, text):
    hand_in(tmp_path / "in" / "ada")
    decided = tmp_path / "overrides.csv"
    decided.write_text(f"{HEAD}\nada,table,{text},x\n", encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--overrides", decided)
    assert done.exit_code == 2
    assert f'found "{text}"' in done.output


def test_parts_that_sum_to_the_points_are_not_remarked_upon(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    rubric = tmp_path / "rubric.toml"
    rubric.write_text("points = 20\n[parts]\ntable = 15\nequations = 5\n", encoding="utf-8")
    assert "scaled" not in grade(tmp_path / "in", tmp_path / "out", "--rubric", rubric).output


def test_further_columns_are_kept_and_the_student_reads_what_is_said_to_him(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    decided = tmp_path / "overrides.csv"
    decided.write_text(
        f"{HEAD},say,appeal,by,at,marker\nada,table,50 %,scan,See <me> on Friday.,a1,Dr. K,2026-12-02T10:00:00+08:00,2\n"
        "ada,equations,40,x,,,,,\n",
        encoding="utf-8",
    )
    assert grade(tmp_path / "in", tmp_path / "out", "--overrides", decided).exit_code == 0
    jsonschema.validate(json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8")), SCHEMA)
    assert submissions(tmp_path / "out")["ada"]["overrides"] == [
        {"check": "table", "points": 30.0, "reason": "scan", "say": "See <me> on Friday.", "appeal": "a1", "by": "Dr. K",
         "at": "2026-12-02T10:00:00+08:00", "marker": "2"},
        {"check": "equations", "points": 40.0, "reason": "x"},
    ]  # fmt: skip
    page = (tmp_path / "out" / "feedback" / "ada.html").read_text(encoding="utf-8")
    assert "See &lt;me&gt; on Friday." in page
    assert "Dr. K" not in page
    sentence = next(csv.DictReader((tmp_path / "out" / "grades.csv").read_text(encoding="utf-8-sig").splitlines()))["sentence"]
    assert "60 points. See <me> on Friday. " in sentence and sentence.endswith("equations, 40 of 40 points.")


@pytest.mark.parametrize(("head", "rest", "read"), [
    (HEAD, "copied from bob", "copied from bob"), (f"{HEAD},say", "copied from bob,Please see me", "Please see me"),
    (f"{HEAD},say", "copied from bob,", ""),
    (f"{HEAD},by", "copied from bob,Dr. K", "copied from bob"),
])  # fmt: skip
@pytest.mark.parametrize("check", ["table", "total"])
def test_a_reason_is_the_teacher_s_as_soon_as_a_column_is_for_the_student(tmp_path, check, head, rest, read):
    """On the page, in grades.csv and for the platforms; grades.json keeps the reason."""
    hand_in(tmp_path / "in" / "ada")
    (tmp_path / "decided.csv").write_text(f"{head}\nada,{check},30,{rest}\n", encoding="utf-8")
    out = tmp_path / "out"
    assert grade(tmp_path / "in", out, "--overrides", tmp_path / "decided.csv").exit_code == 0
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        sentence = next(csv.DictReader(file))["sentence"]
    assert sentence.endswith(f" points. {read}." if read else " points.")
    page = (out / "feedback" / "ada.html").read_text(encoding="utf-8")
    assert ("copied" in page) is (read == "copied from bob") and read in page
    assert submissions(out)["ada"]["overrides"][0]["reason"] == "copied from bob"


def test_a_student_is_marked_again_when_the_reason_becomes_the_teacher_s(tmp_path):
    hand_in(tmp_path / "in" / "ada")
    for head, end in ((HEAD, "a secret."), (f"{HEAD},say", " points.")):
        (tmp_path / "decided.csv").write_text(f"{head}\nada,table,30,a secret\n", encoding="utf-8")
        assert grade(tmp_path / "in", tmp_path / "out", "--overrides", tmp_path / "decided.csv").exit_code == 0
        page = (tmp_path / "out" / "feedback" / "ada.html").read_text(encoding="utf-8")
        assert ("a secret" in page) is (end == "a secret.")


CAN = [("Yes", "No"), ("Да", "Нет"), ("Так", "Ні"), ("Ja", "Nein"), ("Oui", "Non"), ("Sí", "No"), ("是", "否")]


@pytest.mark.parametrize("title", ["Grade can be changed", "of no known language"])
def test_a_locked_grade_is_left_as_it_stands(tmp_path, title):
    """Of each two one is locked, in every language."""
    head, out = SHEET.replace("Grade can be changed", title), tmp_path / "out"
    for number, can in enumerate(word for pair in CAN for word in pair):
        before, comment = ("55.00", "old") if number % 2 else ("", "")
        head += f"Participant {7000 + number},N{number},n{number}@x,s,{before},100.00,{can},-,-,{comment}\r\n"
        hand_in(tmp_path / "in" / f"N{number}_{7000 + number}_assignsubmission_file")
    (tmp_path / "sheet.csv").write_bytes(head.encode())
    done = grade(tmp_path / "in", out, "--worksheet", tmp_path / "sheet.csv")
    assert done.exit_code == 0, done.output
    assert "has locked" in done.output
    filled = (out / "worksheet.csv").read_bytes().decode().splitlines()[1:]
    notes = {entry["name"]: [note["code"] for note in entry["notes"]] for entry in submissions(out).values()}
    for number, (line, before) in enumerate(zip(filled, head.splitlines()[1:], strict=True)):
        assert (line == before) is (number % 2 == 1)
        assert f"n{number}@x,s,{'55.00' if number % 2 else '100.00'},100.00" in line
        assert ("locked" in notes[f"N{number}"]) is (number % 2 == 1)


@pytest.mark.parametrize("is_of_groups", [False, True])
def test_who_handed_in_nothing_is_missing_and_told_so(tmp_path, is_of_groups):
    """But nobody is missing where the folders are those of groups: their numbers are in no row."""
    rows = "".join(f"Participant {number},N{number},n{number}@x,s,,100.00,Yes,-,-,\r\n" for number in (7000, 7187))
    (tmp_path / "sheet.csv").write_bytes((SHEET + rows).encode())
    number, out = 12 if is_of_groups else 7000, tmp_path / "out"
    hand_in(tmp_path / "in" / f"N7000_{number}_assignsubmission_file")
    assert grade(tmp_path / "in", out, "--worksheet", tmp_path / "sheet.csv").exit_code == 0
    filled = (out / "worksheet.csv").read_bytes().decode().splitlines()
    if is_of_groups:
        assert list(submissions(out)) == ["12"] and filled[2] == rows.splitlines()[1]
        return
    found = submissions(out)["7187"]
    assert (found["name"], found["status"], found["score"]) == ("N7187", "missing", None)
    assert filled[2] == rows.splitlines()[1] + "No file was found under this name."
    assert "N7187" in (out / "class.html").read_text(encoding="utf-8")


def test_the_page_of_a_withdrawn_submission_is_removed_and_told(tmp_path):
    for name in ("ada", "bert", "carl"):
        hand_in(tmp_path / "in" / name)
    out = tmp_path / "out"
    assert grade(tmp_path / "in", out).exit_code == 0
    own = out / "feedback" / "carl.html"
    own.write_text("my own page", encoding="utf-8")
    for name in ("bert", "carl"):
        (tmp_path / "in" / name).rename(tmp_path / f"{name} withdrawn")
    assert grade(tmp_path / "in", out).exit_code == 0
    assert sorted(path.name for path in (out / "feedback").iterdir()) == ["ada.html", "carl.html"]
    assert own.read_text(encoding="utf-8") == "my own page"
    assert changes(out) == [
        {"id": name, "before": "100.00", "after": "", "reason": "withdrawn"} for name in ("bert", "carl")
    ]  # fmt: skip
    assert "withdrawn" in (out / "class.html").read_text(encoding="utf-8")
    assert grade(tmp_path / "in", out).exit_code == 0
    assert changes(out) == []


def test_a_missing_part_that_the_instructor_read_elsewhere_gives_a_number(tmp_path):
    source, out = tmp_path / "in", tmp_path / "out"
    for student in ("ada", "bert"):
        hand_in(source / student)
        (source / student / "equations.txt").unlink()
    decided = tmp_path / "overrides.csv"
    decided.write_text("id,check,points,reason\nada,equations,30,read on paper\nbert,table,50,a scan\n", encoding="utf-8")
    assert grade(source, out, "--overrides", decided).exit_code == 0
    found = submissions(out)
    assert (found["ada"]["status"], found["ada"]["score"], found["ada"]["proposed"]) == ("graded-with-notes", 90, None)
    assert found["ada"]["equations"] == {"score": 30, "max": 40, "independent": 0, "needed": 0, "items": []}
    assert (found["bert"]["status"], found["bert"]["score"], found["bert"]["proposed"]) == ("needs-review", None, 50)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("adda,total,5,x", 'nobody has the id "adda". Did you mean "ada"?'),
        ("ada,tabel,5,x", 'there is no part "tabel". Did you mean "table"?'),
        ("ada,table,60.01,x", "points from 0 to 60"),
        ("ada,table,lots,x", 'found "lots"'),
    ],
)
def test_decisions_that_cannot_be_meant_stop_before_anything_is_graded(tmp_path, line, told):
    hand_in(tmp_path / "in" / "ada")
    decided = tmp_path / "overrides.csv"
    decided.write_text(f"id,check,points,reason\n{line}\n", encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--overrides", decided)
    assert done.exit_code == 2
    assert told in done.output
    assert not (tmp_path / "out").exists()
