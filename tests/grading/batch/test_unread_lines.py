"""A line that nobody could read: the part waits, the page says so, and a decision about the part or the total settles it."""

import json

import numpy as np
import pytest

from coursework.commands.grade import grade_source
from coursework.grading.precheck import precheck
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.reading.reader import read_variant
from tests.grading.batch.classroom import EQUATIONS, hand_in
from tests.grading.batch.in_this_process import in_this_process
from tests.grading.marking import students
from tests.grading.pages.truths import VARIANT

UNREAD = "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*zeta(phi1) = 0"


def graded(tmp_path, overrides="", equations=(*EQUATIONS[:3], UNREAD), table=None):
    if not (tmp_path / "in").exists():
        hand_in(tmp_path / "in" / "ada", table, equations=equations)
    decided = tmp_path / "overrides.csv"
    decided.write_text(overrides, encoding="utf-8")
    with in_this_process():
        status = grade_source(
            tmp_path / "in", variant="31", roster=None, out=tmp_path / "out", rubric=None,
            overrides=decided if overrides else None,
            worksheet=None, canvas=None, results=None, no_pages=False, jobs=1, scheduler=None, limit=60, memory=1024,
            language="en",
        )  # fmt: skip
    assert status == 0
    (entry,) = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))["submissions"]
    return entry, (tmp_path / "out" / "feedback" / "ada.html").read_text(encoding="utf-8")


def test_the_page_says_that_the_part_is_not_marked_yet(tmp_path):
    entry, page = graded(tmp_path)
    assert entry["status"] == "needs-review"
    assert entry["equations"]["score"] is None
    assert entry["proposed"] == 90.0
    assert entry["verdicts"]["equations"] == "none"
    assert "The equations are not marked yet" in page
    assert "(table 60 of 60; equations: not marked yet)" in page  # four lines were handed in: none is missing
    assert "not yet right" not in page
    assert "of the 4 needed" not in page


def test_with_the_fourth_equation_readable_the_same_line_is_a_remark(tmp_path):
    entry, page = graded(tmp_path, equations=(*EQUATIONS, UNREAD))
    assert (entry["status"], entry["score"]) == ("graded", 100.0)
    assert "Could not be read" in page


def test_a_decision_about_the_part_or_the_total_settles_it(tmp_path):
    """Each in turn; what changes is told against the run before."""
    graded(tmp_path)
    before = "needs-review"
    for check, points, score in (("equations", 35, 95.0), ("total", 70, 70.0)):
        entry, _ = graded(tmp_path, f"id,check,points,reason\nada,{check},{points},read by hand\n")
        assert (entry["status"], entry["score"]) == ("graded-with-notes", score)
        changes = (tmp_path / "out" / "changes.csv").read_text(encoding="utf-8-sig").splitlines()
        assert changes[1] == f"ada,{before},{score:.2f},overrides"
        before = f"{score:.2f}"


def test_a_decision_about_another_part_does_not(tmp_path):
    graded(tmp_path)
    entry, _ = graded(tmp_path, "id,check,points,reason\nada,table,50,agreed\n")
    assert (entry["status"], entry["score"]) == ("needs-review", None)
    assert (tmp_path / "out" / "changes.csv").read_text(encoding="utf-8-sig").splitlines()[1:] == [
        "ada,needs-review,needs-review,overrides"
    ]


@pytest.mark.parametrize(("half", "codes"), [("0.5", []), ("0.5001", ["rounded"]), ("0.502", ["rounded"])])
def test_a_rounded_number_in_a_right_line_is_told(tmp_path, half, codes):
    entry, page = graded(tmp_path, equations=(EQUATIONS[0], EQUATIONS[1].replace("0.5", half), *EQUATIONS[2:]))
    assert [note["code"] for note in entry["notes"]] == codes
    assert entry["score"] == 100.0
    assert ("Numbers are rounded in lines that count as right: 2." in page) == bool(codes)


def test_latex_is_a_way_of_writing_and_a_missing_zero_is_added(tmp_path):
    latex = r"$r_3\omega_3\sin\varphi_3 - r_2\omega_2\cos\varphi_2 - r_1\omega_1\cos\varphi_1 = 0$"
    assert graded(tmp_path / "a", equations=(*EQUATIONS[:3], latex))[0]["status"] == "graded"
    entry, _ = graded(tmp_path / "b", equations=(*EQUATIONS[:3], EQUATIONS[3].removesuffix(" = 0")))
    assert [note["code"] for note in entry["notes"]] == ["repaired"]


def test_a_variant_file_that_is_no_toml_waits_for_a_person(tmp_path):
    hand_in(tmp_path / "in" / "ada", equations=())
    broken = VARIANT.read_text(encoding="utf-8").replace("[time]", '[drive]\nVMx = "0"\n[time]')
    (tmp_path / "in" / "ada" / "mine.toml").write_text(broken, encoding="utf-8")
    (tmp_path / "in" / "ada" / "equations.txt").unlink()
    entry, page = graded(tmp_path)
    (item,) = entry["equations"]["items"]
    assert (entry["status"], entry["proposed"]) == ("needs-review", 60.0)
    assert item["line"] == broken[: broken.rindex("[drive]")].count("\n") + 1
    assert f"Line {item['line']} of the equations could not be read" in page


def test_no_reason_is_promised_where_a_decision_stands_for_it(tmp_path):
    table = students.table(printed=lambda t, q: students.velocities(t, q) * [1.2 + 0.1 * np.sin(90 * t), 1, 1, 1])
    _, page = graded(tmp_path, equations=EQUATIONS, table=table)
    assert "the reason is given above" in page and "<b>○</b>" in page
    _, page = graded(tmp_path, "id,check,points,reason\nada,total,0,copied\n")
    assert "Decided by your instructor: total, 0 of 100 points. copied" in page
    assert "the reason is given above" not in page and "<b>○</b>" not in page


PROSE = "Step {}: the velocity of point D is V_D = V_M + V_DM"
MOST = 2 * 4 + 20  # lines that are read of the 4 equations needed


def test_a_sentence_uses_up_no_place_of_an_equation(tmp_path):
    entry, _ = graded(tmp_path, equations=(*map(PROSE.format, range(MOST + 1)), *EQUATIONS))
    assert (entry["status"], entry["score"], entry["equations"]["independent"]) == ("graded", 100.0, 4)


@pytest.mark.parametrize(("number", "status"), [(MOST - 4, "graded"), (MOST - 3, "needs-review")])
def test_where_an_equation_may_be_lost_a_person_looks(tmp_path, number, status):
    entry, page = graded(tmp_path, equations=(*[UNREAD] * number, *EQUATIONS))
    assert entry["status"] == status
    assert ("Lines that may be equations were not read, since there are too many before them: 1." in page) == (number > MOST - 4)
    files = [submitted_file(one.name, one.read_bytes()) for one in (tmp_path / "in" / "ada").iterdir()]
    told = precheck(Submission("ada", None, tuple(files)), read_variant(VARIANT), lambda text, names: text)
    assert not told.fine  # these lines could not be read, or were not
    assert (told.sentences[-1].key == "reading.review.lines_dropped") == (number > MOST - 4)


def test_lines_of_several_files_are_named_by_their_files(tmp_path):
    """Line 1 of the second said the same as "line 1"; of one file the number is enough."""
    hand_in(tmp_path / "in" / "ada")
    (tmp_path / "in" / "ada" / "second.txt").write_text("\n".join((EQUATIONS[0], EQUATIONS[1].replace("+ ", "- "))), "utf-8")
    entry, page = graded(tmp_path)
    assert "equations.txt (line 1) and adds nothing" in page
    assert "says the same as line 1" not in page
    assert "second.txt (line 2)" in page
    assert {one["place"] for one in entry["equations"]["items"]} >= {"equations.txt (line 1)", "second.txt (line 1)"}
    (tmp_path / "in" / "ada" / "second.txt").unlink()
    entry, page = graded(tmp_path)
    assert "equations.txt (line" not in page


def test_a_formula_is_quoted_in_tables_as_it_can_be_searched(tmp_path):
    """The places to break long words are for pages only."""
    slip = EQUATIONS[3].replace("- r1", "+ r1").replace(" ", "")
    entry, _ = graded(tmp_path, equations=(*EQUATIONS[:3], slip))
    hint = entry["equations"]["items"][3]["hint"]["text"]
    assert len(hint) > 24
    written = {path.name: path.read_text(encoding="utf-8") for path in (tmp_path / "out").iterdir() if path.is_file()}
    assert f"“{hint}”" in written["grades.csv"]
    assert not any("\u200b" in written[name] for name in ("grades.csv", "grades.json", "class.json") if name in written)
