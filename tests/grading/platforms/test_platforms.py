"""Round trips of the learning platforms: only the cells meant change, byte for byte; results as autograders want them."""

from __future__ import annotations

import io
import json
import zipfile

import pytest

from coursework.grading.collecting.file_lists import FileList
from coursework.grading.collecting.matching import Matched, _run_together, match
from coursework.grading.platforms.autograder import Outcome, PartOutcome, _text, gradescope, prairielearn, results_json
from coursework.grading.platforms.canvas import read_gradebook
from coursework.grading.platforms.cells_of_csv import read_cells
from coursework.grading.platforms.downloads import feedback_zip
from coursework.grading.platforms.roster import read_roster
from coursework.grading.platforms.worksheet import read_worksheet
from coursework.words.errors import InputError

ENGLISH = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission),"
    "Last modified (grade),Feedback comments\r\n"
    '"Participant 7000","Ann Lee",ann@x.edu,"Submitted for grading",,100.00,Yes,"Monday, 1 June 2026, 10:00 AM",-,\r\n'
    'Participant 7001,"Ivan ""Vanya"" Franko",Ivan@X.edu,No submission,"55.50",100.00,Yes,-,-,"old, comment"\r\n'
    "Participant 7002,=cmd(),c@x.edu,x,,100.00,Yes,-,-,\r\n"
)
RUSSIAN = (
    "Идентификатор;Полное имя;Адрес электронной почты;Состояние;Оценка;Максимальная оценка;Оценка может быть изменена;"
    "Последнее изменение (ответ);Последнее изменение (оценка);Отзыв в виде комментария\n"
    "Участник 7000;Лі Анна;ann@x.edu;Отправлено;;100,00;Да;-;-;\n"
    "Участник 7001;Франко Іван;i@x.edu;Отправлено;;100,00;Да;-;-;\n"
)
JAPANESE = (  # a language of which no title is known: told by where the greatest grades stand
    "識別子,氏名,メール,状態,評点,最大評点,変更可,最終更新(提出),最終更新(評点),フィードバック\n"
    "参加者 7000,アン,ann@x.edu,s,,20.00,y,-,-,\n参加者 7001,イワン,i@x.edu,s,,20.00,y,-,-,\n"
)


def test_only_grades_and_comments_of_a_worksheet_change() -> None:
    content = b"\xef\xbb\xbf" + ENGLISH.encode()
    sheet = read_worksheet(content, "grades.csv")
    assert [(row.number, row.name, row.email) for row in sheet.rows] == [
        ("7000", "Ann Lee", "ann@x.edu"), ("7001", 'Ivan "Vanya" Franko', "Ivan@X.edu"), ("7002", "=cmd()", "c@x.edu"),
    ]  # fmt: skip
    sheet.check_total(100, "rubric.toml")
    assert sheet.filled({}) == content
    marked = sheet.filled({1: (87.5, 'row 11: w2 "is" <wrong>\nsee page'), 2: (None, "nothing was handed in")})
    expected = ENGLISH.replace('"Submitted for grading",,100.00', '"Submitted for grading",87.50,100.00').replace(
        '10:00 AM",-,', '10:00 AM",-,row 11: w2 &quot;is&quot; &lt;wrong&gt;<br>see page'
    )
    expected = expected.replace('"old, comment"', "nothing was handed in")
    assert marked == b"\xef\xbb\xbf" + expected.encode()


def test_a_comment_is_neither_formula_nor_page() -> None:
    sheet = read_worksheet(ENGLISH.encode(), "grades.csv")
    text = sheet.filled({3: (0, "=HYPERLINK(1)\u202e"), 1: (100.0, "<script>, end")}).decode()
    assert text.endswith("Participant 7002,=cmd(),c@x.edu,x,0.00,100.00,Yes,-,-,'=HYPERLINK(1)⟨U+202E⟩\r\n")
    assert '"&lt;script&gt;, end"' in text


@pytest.mark.parametrize(
    ("text", "encoding", "grade"),
    [(RUSSIAN, "cp1251", ";87,50;100,00;"), (RUSSIAN, "utf-8", ";87,50;100,00;"), (RUSSIAN.replace(";", ","), "utf-8", ""),
     (RUSSIAN.replace("\n", "\r\n"), "utf-16-le", ";87,50;100,00;")],
)  # fmt: skip
def test_worksheets_in_other_languages(text: str, encoding: str, grade: str) -> None:
    if not grade:
        text, grade = text.replace("100,00", '"100,00"'), ',"87,50","100,00",'
    mark = b"\xff\xfe" if encoding == "utf-16-le" else b""
    content = mark + text.encode(encoding, errors="replace")
    sheet = read_worksheet(content, "оценки.csv")
    assert sheet.maximum == 100
    assert (sheet.columns["grade"], sheet.columns["maximum"], sheet.columns["comment"]) == (4, 5, 9)
    filled = sheet.filled({1: (87.5, "добре")})
    changed = filled[len(mark) :].decode(encoding).replace("\r\n", "\n").split("\n")
    before = content[len(mark) :].decode(encoding).replace("\r\n", "\n").split("\n")
    assert [k for k, (one, other) in enumerate(zip(changed, before, strict=True)) if one != other] == [1]
    assert grade in changed[1]
    assert changed[1].endswith("добре")


@pytest.mark.parametrize(("text", "status"), [(ENGLISH, ""), (RUSSIAN, ""), (RUSSIAN, "Статус"), (RUSSIAN, "Состояние")])
def test_while_marking_is_blind_nobody_is_called_by_a_state(text: str, status: str) -> None:
    lines = [line.replace("Состояние", status or "Состояние") for line in text.splitlines() if "Franko" not in line]
    mark = ";" if ";" in text else ","
    blind = "\n".join(mark.join([line.split(mark)[0], *line.split(mark)[3:]]) for line in lines) + "\n"
    sheet = read_worksheet(blind.encode(), "g.csv")
    assert [(row.number, row.name, row.email) for row in sheet.rows] == [(row.number, "", "") for row in sheet.rows]
    assert sheet.rows[0].number == "7000"
    assert f"{mark}1.00{mark}" in sheet.filled({1: (1.0, "")}).decode().replace(",00", ".00")


def test_a_language_nobody_knows_is_told_by_the_greatest_grades() -> None:
    sheet = read_worksheet(JAPANESE.encode(), "g.csv")
    assert [(row.number, row.name) for row in sheet.rows] == [("7000", "アン"), ("7001", "イワン")]
    assert (sheet.maximum, sheet.columns["email"], sheet.columns["comment"]) == (20, 2, 9)
    assert "参加者 7000,アン,ann@x.edu,s,19.25,20.00,y,-,-,ok" in sheet.filled({1: (19.25, "ok")}).decode()


def test_a_worksheet_that_moodle_would_drop_grades_of_is_refused() -> None:
    sheet = read_worksheet(ENGLISH.encode(), "grades.csv")
    with pytest.raises(InputError, match=r"maximum grade is 100, and rubric\.toml gives 60 points"):
        sheet.check_total(60, "rubric.toml")
    for points in (100.01, -0.01):
        with pytest.raises(InputError, match="outside 0 to 100"):
            sheet.filled({1: (points, "")})
    for text in ("", "a,b\n", "a,b,c\n1,2,x\n3,4,y\n", ENGLISH.replace("100.00,Yes,-,-,\r\n", "90.00,Yes,-,-,\r\n")):
        with pytest.raises(InputError, match=r"grades\.csv"):
            read_worksheet(text.encode(), "grades.csv")


def test_a_letter_that_the_encoding_lacks_is_told() -> None:
    sheet = read_worksheet(RUSSIAN.encode("cp1251", errors="replace"), "g.csv")
    with pytest.raises(InputError, match=r"ω.*cp1251"):
        sheet.filled({1: (1.0, "ω1")})


CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Coursework (555),Quiz (556),Final Score\n"
    "    Points Possible,,,,,100,10,(read only)\n"
    '"Lee, Ann",101,S1,ann,A,,9,\n"Franko, Ivan",102,S2,ivan,A,EX,8,\n"Same, Name",103,,,A,80.0,,\n"Same, Name",104,S4,x,A,,,\n'
    '"Student, Test",105,,,A,,,\n'
)


def test_one_column_of_a_canvas_export_is_filled() -> None:
    book = read_gradebook(CANVAS.encode("utf-8-sig"), "export.csv", 100)
    assert book.cells.records[0][book.column].value == "Coursework (555)"
    assert [book.record_of(keys, name) for keys, name in (
        (("101",), None), (("S2",), None), (("ivan",), None), (("nobody",), "Ann Lee"), (("nobody",), "Lee, Ann"),
        ((), "Same Name"),
        (("105",), None), (("S4",), None),
    )] == [2, 3, 3, 2, 2, None, None, 5]  # fmt: skip
    filled = book.filled({2: 87.5, 3: 90.0, 4: 80.004, 5: 1234.0}).decode("utf-8-sig")
    before, after = CANVAS.split("\n"), filled.split("\n")
    assert after[2] == '"Lee, Ann",101,S1,ann,A,87.5,9,'
    assert after[5] == '"Same, Name",104,S4,x,A,1234,,'
    assert [k for k in range(len(before)) if before[k] != after[k]] == [2, 5]


@pytest.mark.parametrize(("name", "spellings"), [
    ("Lee, Ann", {"leeann", "annlee"}), ("Ann Lee", {"annlee", "leeann"}), ("Ann", {"ann"}), ("", set()),
    ("Ann Mary Lee", {"annmarylee", "leeannmary"}), ("Ó Briain-Lee, Éamon", {"óbriainleeéamon", "éamonóbriainlee"}),
])  # fmt: skip
def test_a_name_runs_together_as_canvas_writes_it(name: str, spellings: set[str]) -> None:
    """Last name first, whichever end of the roster's spelling that is."""
    assert _run_together(name) == spellings


@pytest.mark.parametrize("lines", range(6))
def test_the_points_of_an_assignment_stand_within_the_first_lines_of_a_canvas_export(lines):
    """Canvas writes up to four lines of settings before them; with none found all assignments fit."""
    head, possible, *rest = CANVAS.splitlines(keepends=True)
    export = "".join([head, *["    Muted,,,,,,,\n"] * lines, possible, *rest]).encode()
    if lines < 5:
        book = read_gradebook(export, "export.csv", 100)
        assert book.students == tuple(lines + record for record in (2, 3, 4, 5))
    else:
        with pytest.raises(InputError, match="several assignments"):
            read_gradebook(export, "export.csv", 100)


def test_a_column_that_would_become_a_new_assignment_is_refused() -> None:
    with pytest.raises(InputError, match=r"export[.]csv:1 .*no assignment has 60 points.*Coursework \(555\); Quiz \(556\)"):
        read_gradebook(CANVAS.encode(), "export.csv", 60)
    twice = CANVAS.replace("Quiz (556)", "Again (556)").replace(",100,10,", ",100,100,")
    with pytest.raises(InputError, match=r"export[.]csv:1 .*several assignments have 100 points"):
        read_gradebook(twice.encode(), "export.csv", 100)
    half = twice.replace(",A,80.0,,", ",A,,,").replace(",A,EX,8,", ",A,,8,")
    assert read_gradebook(half.encode(), "export.csv", 100).column == 5  # of two the one that is empty


def test_a_canvas_export_with_two_columns_of_names() -> None:
    export = "LastName,FirstName,ID,Coursework (555)\n    Points Possible,,,100\nLee,Ann,101,\nBob,Ray,102,\n"
    book = read_gradebook(export.encode(), "export.csv", 100)
    assert [book.record_of((), name) for name in ("Ann Lee", "Lee, Ann", "Lee Ann", "Ray Bob", "Ann Bob")] == [2, 2, 2, 3, None]


ROSTER = "id,name,email,variant,group\nann,Ann Lee,ANN@x.edu,31,A\nivan,Ivan Franko,,v101,B\nбр,Іван Бр,b@x.edu,31,B\n"


def test_a_roster_keeps_its_columns_and_tells_its_faults() -> None:
    students = read_roster(ROSTER.encode("utf-8-sig"), "roster.csv")
    assert [(student.id, student.variant, student.more) for student in students] == [
        ("ann", "31", {"group": "A"}), ("ivan", "v101", {"group": "B"}), ("бр", "31", {"group": "B"}),
    ]  # fmt: skip
    assert read_roster(ROSTER.replace("ivan", ",,,,\nivan").encode(), "roster.csv")[2].line == 5  # a line of commas is nobody
    with pytest.raises(InputError) as told:
        read_roster((ROSTER + "Ann,x,,31,\n,nobody,,31,\n").encode(), "roster.csv")
    assert [(fault.line, fault.message.partition(".")[0]) for fault in told.value.faults] == [
        (5, 'the id "Ann" is already in line 2'), (6, "the id of this student is missing"),
    ]  # fmt: skip
    with pytest.raises(InputError, match='no column "id"'):
        read_roster(b"name;variant\nAnn;31\n", "roster.csv")


def file_list(student: str, name: str | None = None, number: str = "") -> FileList:
    return FileList(student, name, (), number)


def ids(matched: Matched) -> dict[str, list[str]]:
    return {student: [found.id for found in file_lists] for student, file_lists in matched.file_lists.items()}


def test_whose_parcel_is_whose() -> None:
    roster = read_roster(ROSTER.encode(), "roster.csv")
    folders = match(roster, [file_list("ANN"), file_list("nobody")], "folder")
    assert ids(folders) == {"ann": ["ANN"]}
    assert [p.id for p in folders.not_on_roster] == ["nobody"]
    moodle = [
        file_list("x_7000_f", "Somebody Else", "7000"),
        file_list("y_7001_f", "Ivan Franko", "7001"),
        file_list("z_1_f", "Ann Lee", "1"),
    ]
    sheet = read_worksheet(ENGLISH.replace('Ivan ""Vanya"" Franko', "ivan  FRANKO").encode(), "g.csv")
    by_sheet = match(roster, moodle, "moodle", sheet)
    assert {student: [p.id for p in found] for student, found in by_sheet.file_lists.items()} == {
        "ann": ["x_7000_f"],
        "ivan": ["y_7001_f"],
    }
    assert [p.id for p in by_sheet.not_on_roster] == ["z_1_f"]
    assert {student: row.number for student, row in by_sheet.rows.items()} == {"ann": "7000", "ivan": "7001"}
    by_name = match(roster, moodle, "moodle")
    assert {student: [p.id for p in found] for student, found in by_name.file_lists.items()} == {
        "ivan": ["y_7001_f"],
        "ann": ["z_1_f"],
    }
    canvas = match(roster, [file_list("101", "leeann", "101"), file_list("102", "іванбр", "102")], "canvas")
    assert set(canvas.file_lists) == {"ann", "бр"}


def test_the_feedback_zip_has_the_names_of_the_download() -> None:
    pages = [("Б Іван_7001_assignsubmission_file", "../../x", b"2"), ("Ann Lee_7000_assignsubmission_file_", "ann", b"1")]
    content = feedback_zip(pages)
    assert content == feedback_zip(reversed(pages))
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        assert file.namelist() == [
            "Ann Lee_7000_assignsubmission_file_/feedback-ann.html",
            "Б Іван_7001_assignsubmission_file/feedback-x-9cdf6a50100a862e.html",
        ]


PARTS = (PartOutcome("table", 40.333, 60, "row 11"), PartOutcome("equations", 40.0, 40, "all right"))


def test_gradescope() -> None:
    results = gradescope(Outcome("graded", 80.33, 100, "first wrong: row 11 w2\u202e", PARTS))
    assert results["score"] == 80.33
    assert sum(test["score"] for test in results["tests"]) == pytest.approx(80.33, abs=1e-9)
    assert sum(test["max_score"] for test in results["tests"]) == 100
    assert [test["status"] for test in results["tests"]] == ["failed", "passed"]
    assert results["output"] == "first wrong: row 11 w2⟨U+202E⟩"
    assert set(results) == {"score", "output", "output_format", "tests"}
    none = gradescope(Outcome("unreadable", None, 100, "The file is empty.", PARTS, ("Save as CSV.",)))
    assert none["score"] == 0
    assert [test["score"] for test in none["tests"]] == [0, 0]
    assert none["output"].startswith("Nothing was marked (unreadable)")
    assert none["output"].endswith("Save as CSV.")


def test_prairielearn() -> None:
    results = prairielearn(Outcome("graded-with-notes", 80.33, 100, "row 11", PARTS))
    assert (results["gradable"], results["score"], results["format_errors"]) == (True, 0.8033, [])
    assert sum(test["points"] for test in results["tests"]) == pytest.approx(80.33)
    lost = prairielearn(Outcome("missing", None, 100, "", PARTS, ("No table was handed in.",)))
    assert (lost["gradable"], lost["score"], lost["format_errors"]) == (False, 0, ["No table was handed in."])
    big = prairielearn(Outcome("graded", 1, 100, "x" * 10**6, [PartOutcome(str(k), 0, 25, "ω" * 10**6) for k in range(4)]))
    assert len(results_json(big)) < 10**6
    assert json.loads(results_json(results)) == results


def test_a_cell_is_found_by_its_title_and_is_empty_where_the_record_ends_before_it() -> None:
    cells = read_cells(b"ID, Name ,id\n7, Ann ,8\n9\n", "r.csv")
    assert (cells.titles, cells.columns) == (["ID", "Name", "id"], {"id": 0, "name": 1})
    assert [*cells.named(("id", "name", "email"))] == [
        (1, {"id": "7", "name": "Ann", "email": ""}),
        (2, {"id": "9", "name": "", "email": ""}),
    ]
    assert (cells.value(1, 2), cells.value(1, 3), cells.value(1, None)) == ("8", "", "")


def test_a_short_first_line_of_a_roster_loses_no_further_column() -> None:
    students = read_roster(b"id,group\na\nb,ME-21\n", "r.csv")
    assert [student.more for student in students] == [{"group": ""}, {"group": "ME-21"}]


@pytest.mark.parametrize(("letters", "end"), [(60_000, "aa"), (60_001, "a…")])
def test_a_text_of_more_than_sixty_thousand_letters_is_cut(letters, end):
    assert (text := _text("a" * letters)).endswith(end) and len(text) == 60_000
