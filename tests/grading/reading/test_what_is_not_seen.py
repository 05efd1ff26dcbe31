"""What a file does not show is not taken for work, and what was left out of it is asked about and said."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.limits import FILE_BYTES, INFLATED_BYTES
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.reading.documents.test_hostile_documents import ODT, word, writer
from tests.grading.reading.documents.test_right_work import graded
from tests.grading.reading.table.dialects import archive, document, workbook
from tests.grading.reading.table.misread import HEAD, ROWS, csv
from tests.grading.scenes import expected

EQUATION = "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0"


def read(name: str, content: bytes, **more: bytes) -> StudentWork:
    files = {name: content} | {key.replace("__", "."): other for key, other in more.items()}
    return read_submission(Submission("x", None, tuple(submitted_file(*file) for file in files.items())), expected())


def lines(work: StudentWork) -> list[str]:
    return [line.text for line in work.equations or ()]


def test_hidden_letters_of_an_open_document_say_nothing() -> None:
    styles = b"".join(b'<style:style style:name="%s"><style:text-properties %s/></style:style>' % style for style in (
        (b"A", b'text:display="none"'), (b"B", b'text:display="true"'),
    ))  # fmt: skip
    span = b'<text:span text:style-name="%s">%s</text:span>'
    body = b"<text:p>%s%s%s</text:p>" % (EQUATION[:-4].encode(), span % (b"A", b" + w4"), span % (b"B", b" = 0"))
    assert lines(read("a.odt", writer(styles + body))) == [EQUATION]


def flat(kind: bytes, content: bytes) -> bytes:
    """A file of LibreOffice that is one file of XML."""
    begin = (
        b'<?xml version="1.0" encoding="UTF-8"?>\n<office:document xmlns:x="y" office:version="1.3" office:mimetype="%s"' % kind
    )
    return content.replace(b"<?xml version='1.0'?>", b"").replace(b"<office:document-content", begin, 1).replace(
        b"</office:document-content", b"</office:document"
    )  # fmt: skip


def test_a_flat_open_document_is_read_as_one_that_is_packed() -> None:
    cells = "".join(
        "<table:table-row>" + "".join(f"<table:table-cell><text:p>{cell}</text:p></table:table-cell>" for cell in row)
        + "</table:table-row>" for row in [HEAD, *ROWS]
    )  # fmt: skip
    table = f"<table:table>{cells}</table:table>"
    text = f"<office:document-content><office:text><text:p>{EQUATION}</text:p>{table}</office:text></office:document-content>"
    work = read("a.fodt", flat(ODT, text.encode()))
    assert work.table is not None and work.table.reading.encoding == "odt" and lines(work) == [EQUATION]
    sheet = text.replace("office:text", "office:spreadsheet")
    found = read("a.fods", flat(b"application/vnd.oasis.opendocument.spreadsheet", sheet.encode())).table
    whole = read("a.ods", document(table)).table
    assert found is not None and whole is not None and found.columns == whole.columns


@pytest.mark.parametrize("before", [[], [[""]], [["Похибка, %"]]])
def test_a_table_of_something_else_below_is_a_table_of_its_own(before: list[list[str]]) -> None:
    other = [["t", *(f"Δ{name}" for name in HEAD[1:])], *([row[0], *["0.5"] * (len(HEAD) - 1)] for row in ROWS)]
    work = read("a.csv", "\n".join(map(";".join, [HEAD, *ROWS, *before, *other])).encode())
    whole = read("a.csv", csv(ROWS)).table
    assert work.review is None and work.table is not None and whole is not None and work.table.columns == whole.columns


@pytest.mark.parametrize("sign", [";", "\t"])
def test_a_csv_that_was_not_taken_apart_in_a_spreadsheet_is_read(sign: str) -> None:
    rows = [[f"t:{sign.join(row).replace('.', ',')}"] for row in [HEAD, *ROWS]]
    table, whole = read("a.xlsx", workbook({"Лист1": [["t:Задание 31"], [], *rows]})).table, read("a.csv", csv(ROWS)).table
    assert table is not None and whole is not None and table.reading.sheet == "Лист1"
    assert [column.values for column in table.columns] == [column.values for column in whole.columns]


DOTS = [["..."] * len(HEAD)]
CUT = {
    "rows": [HEAD, *ROWS[:5], *DOTS, *ROWS[-5:]],
    "columns": [[*row[:3], "…", *row[-2:]] for row in [HEAD, *ROWS]],
    "all but the time": [HEAD, *ROWS[:5], ["", *DOTS[0][1:]], *ROWS[-5:]],
}


@pytest.mark.parametrize("case", CUT)
def test_dots_in_place_of_rows_or_columns_ask_a_person(case: str) -> None:
    rows = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in CUT[case])
    grade = graded({"a.html": f"<html><table>{rows}</table>".encode()}, rubric="[parts]\ntable = 100\nequations = 0\n")
    assert grade.status == "needs-review" and grade.total < 100.0
    assert str(grade.reason).startswith("A program printed dots in place of some rows or columns of the table in a.html")


@pytest.mark.parametrize("line", ["# ℹ 15 more rows", " [ reached getOption('max.print') -- omitted 15 rows ]", "# 15 rows"])
def test_words_of_r_for_rows_that_it_did_not_print_ask_a_person_too(line: str) -> None:
    lines = [
        " ".join(f"{cell:>9}" for cell in row) for row in [["", *HEAD], *([str(k), *row] for k, row in enumerate(ROWS[:10], 1))]
    ]
    table = read("a.txt", "\n".join([*lines, line]).encode()).table
    assert table is not None and table.is_cut is ("15 rows" not in line[:10])


def test_dots_where_nothing_is_missing_are_passed_over() -> None:
    for rows in ([HEAD, *ROWS, *DOTS], [[*row, "..."] for row in [HEAD, *ROWS]], [HEAD, *ROWS[:-1]]):
        work = read("a.csv", "\n".join(map(";".join, rows)).encode())
        assert work.table is not None and not work.table.is_cut and work.review is None


@pytest.mark.parametrize("page", [
    "", '<p dir="ltr"></p>', "<!DOCTYPE html><html><head><title></title></head><body><p><br></p></body></html>",
    "<p>&nbsp;</p>", "<p>\u200b</p>", "<table><tr><td></td></tr></table>", "<style>p {color: red}</style><div></div>",
])  # fmt: skip
def test_an_empty_page_of_a_platform_s_editor_says_that_nothing_is_written(page: str) -> None:
    trouble = read("onlinetext.html", page.encode()).trouble
    assert trouble is not None and (trouble.state, trouble.code) == ("unreadable", "empty")
    assert trouble.text == "onlinetext.html is empty: nothing is written in it."
    beside = read("onlinetext.html", page.encode(), t__csv=csv(ROWS))
    assert beside.table is not None and [note.code for note in beside.notes] == ["empty_part"]


PICTURED = "{} holds pictures or objects of other programs, which are not read, and what is missing may be in them."
PAGE = "<html><table>" + "".join(f"<tr>{''.join(f'<td>{cell}' for cell in row)}" for row in [HEAD, *ROWS]) + "</table>"


@pytest.mark.parametrize(("name", "content", "more"), [
    ("a.html", PAGE.encode(), "<img src='eq.png'>"), ("a.md", PAGE[6:].encode(), "![](eq.png)"),
    ("a.tex", b"\\begin{tabular}{c}" + "\\\\".join("&".join(row) for row in [HEAD, *ROWS]).encode() + b"\\end{tabular}",
     "\\includegraphics[width=1cm]{a}"),
])  # fmt: skip
def test_equations_that_may_be_in_pictures_are_asked_about(name: str, content: bytes, more: str) -> None:
    bare, pictured = graded({name: content}), graded({name: content + f"\n{more}".encode()})
    assert bare.status == pictured.status == "needs-review" and bare.total == pictured.total == 60.0
    assert str(pictured.reason).startswith(PICTURED.format(name)) and "pictures" not in str(bare.reason)
    zero = graded({name: content + f"\n{more}".encode()}, rubric='missing_part = "zero"\n')
    assert zero.total == 60.0


@pytest.mark.parametrize("part", ["word/media/image1.wmf", "word/embeddings/oleObject1.bin"])
def test_a_document_of_nothing_but_pictures_says_so(part: str) -> None:
    pictured = archive({"word/document.xml": "<w:document><w:body><w:p/></w:body></w:document>", part: "x"})
    trouble = read("a.docx", pictured).trouble
    assert trouble is not None and trouble.state == "unreadable" and trouble.text.startswith(PICTURED.format("a.docx"))
    bare = read("a.docx", word(b"<w:p/>")).trouble
    assert bare is not None and "no table of numbers and no equation was found" in bare.text


def test_so_much_of_a_text_is_looked_through_for_equations_and_what_is_behind_is_counted() -> None:
    for before, found, unread in ((1_000_000 - len(EQUATION), 1, 0), (1_000_000 - len(EQUATION) + 1, 0, 1), (1_000_000, 0, 1)):
        said = read_lines(" " * (before - 1) + "\n" + EQUATION, "a", expected())
        assert (len(said.equations), said.unread) == (found, unread)


@pytest.mark.parametrize(("size", "is_read"), [(INFLATED_BYTES // 2 - 400, True), (INFLATED_BYTES // 2, False)])
def test_the_bytes_inflated_from_all_files_of_a_student_are_counted_together(size: int, is_read: bool) -> None:
    filled = word(b"<w:p><w:r><w:t>" + EQUATION.encode() + b"</w:t></w:r></w:p><!--" + b" " * size + b"-->")
    work = read("a.docx", filled, b__docx=filled)
    assert len(work.equations or ()) == 1 + is_read
    assert ("attachment" in [note.code for note in work.notes]) is not is_read


def test_a_file_of_the_usual_size_is_read_behind_one_that_is_too_large() -> None:
    large = word(b"<!--" + b" " * INFLATED_BYTES + b"-->")
    for size, is_read in ((FILE_BYTES - 1000, True), (FILE_BYTES, False)):
        filled = word(b"<w:p><w:r><w:t>" + EQUATION.encode() + b"</w:t></w:r></w:p><!--" + b" " * size + b"-->")
        assert len(read("a.docx", large, b__docx=filled).equations or ()) == is_read
