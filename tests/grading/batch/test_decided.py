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


@pytest.mark.parametrize(("text", "points"), [("80 %", 48), ("80%", 48), ('"33,3 %"', 19.98), ("100 %", 60), ("0 %", 0)])
def test_a_share_is_of_the_part_and_follows_a_changed_rubric(tmp_path, text, points):
    hand_in(tmp_path / "in" / "ada")
    decided, rubric = tmp_path / "overrides.csv", tmp_path / "rubric.toml"
    decided.write_text(f"{HEAD}\nada,table,{text},x\n", encoding="utf-8")
    assert grade(tmp_path / "in", tmp_path / "out", "--overrides", decided).exit_code == 0
    assert submissions(tmp_path / "out")["ada"]["table"]["score"] == points
    rubric.write_text("[parts]\ntable = 30\nequations = 70\n", encoding="utf-8")
    assert grade(tmp_path / "in", tmp_path / "out", "--overrides", decided, "--rubric", rubric).exit_code == 0
    assert submissions(tmp_path / "out")["ada"]["table"]["score"] == pytest.approx(points / 2)


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


@pytest.mark.parametrize(
    ("yes", "no"),
    [("Yes", "No"), ("Да", "Нет"), ("Так", "Ні"), ("Ja", "Nein"), ("Oui", "Non"), ("Sí", "No"), ("是", "否")],
)
@pytest.mark.parametrize("title", ["Grade can be changed", "of no known language"])
def test_a_locked_grade_is_left_as_it_stands(tmp_path, yes, no, title):
    lines = [
        f"Participant {number},{name},{name}@x,s,{before},100.00,{can},-,-,{comment}\r\n"
        for number, name, before, can, comment in (("7000", "Ann Lee", "55.00", no, "old"), ("7001", "Bob Ray", "", yes, ""))
    ]
    for name, number in (("Ann Lee", 7000), ("Bob Ray", 7001)):
        hand_in(tmp_path / "in" / f"{name}_{number}_assignsubmission_file")
    sheet = tmp_path / "sheet.csv"
    sheet.write_bytes((SHEET.replace("Grade can be changed", title) + "".join(lines)).encode())
    done = grade(tmp_path / "in", tmp_path / "out", "--worksheet", sheet)
    assert done.exit_code == 0, done.output
    filled = (tmp_path / "out" / "worksheet.csv").read_bytes().decode()
    assert lines[0] in filled
    assert "Bob Ray@x,s,100.00,100.00" in filled
    assert "does not let be changed" in done.output
    notes = {entry["name"]: [note["code"] for note in entry["notes"]] for entry in submissions(tmp_path / "out").values()}
    assert ("locked" in notes["Ann Lee"], "locked" in notes["Bob Ray"]) == (True, False)


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
