"""Files of a course that cannot be used are refused by the line and the code; what only looks odd is read."""

import pytest

from coursework.grading.batch.decisions import Override, read_overrides
from coursework.grading.marking.rubric import Rubric
from coursework.grading.platforms.canvas import read_gradebook
from coursework.grading.platforms.cells_of_csv import read_cells
from coursework.grading.platforms.roster import read_roster
from coursework.grading.platforms.worksheet import read_worksheet
from coursework.words.errors import InputError

KNOWN = ("ada", "Боб")
ONE, TWO = "Student,ID,Ex 1 (7),Ex 2 (8)\n", "    Points Possible,,{},{}\n"


def overrides(content, file):
    return read_overrides(content, file, KNOWN, Rubric())


def gradebook(content, file):
    return read_gradebook(content, file, 100.0)


@pytest.mark.parametrize(("read", "text", "codes"), [
    (overrides, "id,points\nada,3", "G028:1"), (overrides, "id,check,points\nada,table,60", ""),
    (overrides, "", "G028:1"),
    (overrides, "id,check,points\n,,\nada,table,60.01\n", "G031:3"), (overrides, "id,check,points\nada,table,-0.01", "G031:2"),
    (overrides, "id,check,points\nada,total,100\nada,total,100.01", "G031:3"),
    (overrides, "id,check,points\nada,table,x", "G031:2"),
    (overrides, "id,check,points\nbab,table,3\nada,tables,3\nada,table,3", "G029:2 G030:3"),
    (overrides, "id,check,points\nADA,Table,3\nбоб,equations,0", ""),
    (read_roster, "", "G017:None"), (read_roster, "name\nAda", "G018:1"), (read_roster, "id,name\n,\nada,Ada", ""),
    (read_roster, "id,name\n,Ada\nada,Ada\nAda,Other", "G019:2 G020:4"),
    (read_worksheet, "", "G021:None"), (read_worksheet, "Maximum Grade,x\n5,1", "G022:1"), (read_worksheet, "a,b\nc,d", "G022:1"),
    (read_worksheet, "a,b\n1,2", "G022:1"),
    (read_worksheet, "Identifier,Full name,Grade,Maximum Grade\nP1,Ada,,100\nP2,B,,50", "G024:3"),
    (overrides, "id,check,points,reason\nada,table,50,5,x", "G046:2"),
    (overrides, "id,check,points,reason\nada,table,50,x,,", ""),
    (gradebook, "Identifier,Full name\nP1,Ada", "G010:1"),
    (gradebook, "Student,ID,Ex (7)", "G011:None"), (gradebook, f"{ONE}Ada,1,,", "G013:1"),
    (gradebook, f"{ONE}{TWO.format(100, 50)}Ada,1,,", ""), (gradebook, f"{ONE}{TWO.format(50, 50)}Ada,1,,", "G012:1"),
    (gradebook, f"{ONE}{TWO.format('', 100)}Ada,1,7,", ""), (gradebook, f"{ONE}{TWO.format('', 100)}Ada,1,7,7", "G013:1"),
    (gradebook, f"{ONE}{TWO.format('', 100)}Ada,1,,", "G013:1"),
])  # fmt: skip
def test_a_file_is_refused_with_every_fault_of_it(read, text, codes):
    try:
        read(text.encode(), "file.csv")
    except InputError as error:
        assert " ".join(f"{fault.code}:{fault.line or None}" for fault in error.faults) == codes
    else:
        assert codes == ""


def test_blank_lines_between_decisions_end_nothing():
    found = overrides(
        "id,check,points,reason\n,,,\nада,table,3,x\n".replace("ада", "ada").encode() + b",,,\nada,total,40 %,y\n", "f"
    )
    assert found == {"ada": (Override("table", 3.0, "x"), Override("total", 40.0, "y"))}
    (student, other) = read_roster(b"id,name,room\n,,\nada,Ada,7\n,,\nbob,Bob\n", "roster.csv")
    assert (student.id, student.line, student.more, other.id, other.more) == ("ada", 3, {"room": "7"}, "bob", {"room": ""})


def test_a_file_is_read_up_to_its_most_bytes(monkeypatch):
    monkeypatch.setattr("coursework.grading.platforms.cells_of_csv.MOST_BYTES", 9)
    assert read_cells(b"a" * 9, "f").text == "a" * 9
    with pytest.raises(InputError, match=r"G014.* 10 .* 9 "):
        read_cells(b"a" * 10, "f")


@pytest.mark.parametrize(("keys", "name", "record"), [
    (("7",), None, 2), (("ADA1",), None, 3), (("x", "bob"), None, 4), ((), "Lee, Ann", 2), ((), "Ann Lee", 2), ((), "lee ann", 2),
    ((), "Cid", None), (("zz",), "Bob Ray", 4), (("",), None, None), ((), "Same Name", None), (("9",), "Ann Lee", 2),
])  # fmt: skip
def test_a_student_of_canvas_is_found_by_a_key_else_by_a_name_that_is_the_only_one(keys, name, record):
    """Records: 1 the points, 2 Ann Lee, 3 Ada Poe, 4 Bob Ray, 5 and 6 of the same name and the same SIS ID, 7 Canvas's own."""
    text = (
        'Student,ID,SIS User ID,SIS Login ID,Ex (7)\n"    Points Possible",,,,100\n"Lee, Ann",7,,,\n"Poe, Ada",8,ada1,,\n'
        '"Ray, Bob",3,,bob,\n"Name, Same",4,9,,\n"Name, Same",5,9,,\n"Student, Test",99,,,\n'
    )
    assert gradebook(text.encode(), "f").students == (2, 3, 4, 5, 6)
    assert gradebook(text.encode(), "f").record_of(keys, name) == record


@pytest.mark.parametrize("line", ["{},table,3", "ada,{},3", "ada,table,{}"])
def test_of_a_cell_that_cannot_be_used_eighty_letters_are_quoted(line):
    for length in (79, 80, 81):
        with pytest.raises(InputError) as caught:
            overrides(("id,check,points\n" + line.format("x" * length)).encode(), "overrides.csv")
        assert "x" * min(length, 80) in str(caught.value) and "x" * 81 not in str(caught.value)
