"""What precheck and the pages of feedback tell of a frame saw's work: once, at the right place, with a lead that can be right."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import pandas
import pytest

import coursework
from tests.command import call
from tests.variant.judging.test_advice_followed import SAW

pytestmark = pytest.mark.usefixtures("folder")
RIGHT = "-l*om*sin(q) - L*ws*sin(s) = vB\nl*om*cos(q) + L*ws*cos(s) = 0\n"


def handed_in(table: str | None = None, equations: str = RIGHT) -> Path:
    Path("saw.toml").write_text(SAW, encoding="utf-8")
    place = Path("work/ada")
    place.mkdir(parents=True)
    plain = coursework.solve("saw", quantities=["table"]).table.reset_index().round(5).to_csv(index=False)
    (place / "table.csv").write_text(plain if table is None else table, encoding="utf-8")
    (place / "equations.txt").write_text(equations, encoding="utf-8")
    return place


def prechecked(place: Path) -> str:
    return str(call("precheck", *sorted(place.iterdir()), "--variant", "saw").output)


def test_a_table_that_cannot_be_read_is_told_once() -> None:
    told = prechecked(handed_in("t,q,s\n0,00,0,43,-0,12\n0,01,0,53,-0,14\n0,02,0,62,-0,16\n"))
    assert told.count("Save with semicolons, or as xlsx.") == 1
    assert "kept for your instructor" not in told


def test_greek_letters_of_ones_own_are_no_misspelt_pi_and_have_their_place() -> None:
    told = prechecked(place := handed_in(equations="vB = -l*om*sin φ - L*ws*sin(s)\nl*om*cos(q) + L*ws*cos(s) = 0\n"))
    assert 'symbol "phi" is not declared. Known: q, s, om, ws, vB, l, L, n.' in told and "pi" not in re.findall('"(..)"', told)
    call("grade", place.parent, "--variant", "saw", "--out", "marks")
    assert "Column 16: symbol" in re.sub("<[^>]*>", "", Path("marks/feedback/ada.html").read_text(encoding="utf-8"))


def test_an_equation_of_positions_is_told_as_that_even_where_the_start_is_not_quite_closed() -> None:
    place = handed_in(equations="l*sin(q) + L*sin(s) = 0\nl*om*cos(q) + L*ws*cos(s) = 0\n")
    call("grade", place.parent, "--variant", "saw", "--out", "marks")
    page = re.sub("<[^>]*>", "", Path("marks/feedback/ada.html").read_text(encoding="utf-8"))
    assert "It is an equation of positions and names none of the velocities" in page
    assert "its derivative with respect to time is wanted" in page


def test_an_empty_file_is_told_once_and_by_name() -> None:
    place = handed_in("")
    assert prechecked(place).count(
        "empty"
    ) == 1 and "Table: not read. table.csv is empty: nothing is written in it." in prechecked(place)
    call("grade", place.parent, "--variant", "saw", "--out", "marks")
    assert Path("marks/feedback/ada.html").read_text(encoding="utf-8").count("table.csv is empty: nothing is written in it.") == 1


@pytest.mark.parametrize(("head", "kind"), [(b"Rar!\x1a\x07", "RAR"), (b"7z\xbc\xaf\x27\x1c", "7z"), (b"\x1f\x8b\x08", "gzip")])
def test_an_archive_of_another_kind_is_handed_in_as_zip(head: bytes, kind: str) -> None:
    place = handed_in()
    files = [*place.iterdir()]
    with zipfile.ZipFile(place / "work.zip", "w") as packed:
        for file in files:
            packed.write(file, file.name)
    assert "Every step of the angles follows" in str(call("precheck", place / "work.zip", "--variant", "saw").output)
    (place / "work.rar").write_bytes(head + bytes(99))
    told = str(call("precheck", place / "work.rar", "--variant", "saw").output)
    assert f"The file is really {kind}, an archive that is not opened. Hand in the files themselves, or a zip of them." in told


def test_what_a_program_leaves_beside_an_open_file_is_no_work() -> None:
    place = handed_in()
    (place / "~$table.xlsx").write_bytes(b"\x05Ada" + bytes(160))
    (place / ".~lock.table.csv#").write_text(",ada,desk;", encoding="utf-8")
    assert "lock" not in prechecked(place) and "~$" not in prechecked(place)


def test_a_table_that_is_a_picture_is_not_said_to_be_not_handed_in() -> None:
    place = handed_in()
    (place / "table.csv").rename(place / "photo.jpg")
    (place / "photo.jpg").write_bytes(b"\xff\xd8\xff\xe0JFIF")
    call("grade", place.parent, "--variant", "saw", "--out", "marks")
    page = re.sub("<[^>]*>", "", Path("marks/feedback/ada.html").read_text(encoding="utf-8"))
    assert "Nothing that can be read was handed in for one part: table." in page


def test_two_sheets_with_other_numbers_are_told_but_where_one_is_called_after_the_scheme() -> None:
    place = handed_in()
    frame = pandas.read_csv(place / "table.csv")
    (place / "table.csv").unlink()
    other = frame.assign(q=frame["q"] + 0.1)
    for name, second, told in (
        ("mine", other, True),
        ("Euler 1", other, False),
        ("mine", frame, False),
        ("mine", other[:60], False),
    ):
        with pandas.ExcelWriter(place / "table.xlsx", engine="openpyxl") as book:
            second.to_excel(book, sheet_name="again", index=False)
            frame.to_excel(book, sheet_name=name, index=False)
        text = "Two tables have the same number of cells of the task: table.xlsx (again) and table.xlsx (mine). Hand in one."
        assert (text in prechecked(place)) is told


def test_a_column_of_words_is_not_said_to_be_missing() -> None:
    place = handed_in()
    frame = pandas.read_csv(place / "table.csv").assign(vB="see below")
    frame.to_csv(place / "table.csv", index=False)
    assert "Columns of the task without numbers in the file: vB." in prechecked(place)
    call("grade", place.parent, "--variant", "saw", "--out", "marks")
    page = re.sub("<[^>]*>", "", Path("marks/feedback/ada.html").read_text(encoding="utf-8"))
    assert "Columns of the task without numbers in the file: vB." in page
