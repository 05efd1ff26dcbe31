"""Words, breaks and cells of a Word file, case by case of its XML."""

from __future__ import annotations

import pytest

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.office.docx import document_of_docx
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.limits import Room
from tests.grading.reading.table.dialects import archive

WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"


def read(body: str) -> Document:
    whole = f'<?xml version="1.0"?><w:document xmlns:w="{WORD}"><w:body>{body}</w:body></w:document>'
    return document_of_docx(Archive(archive({"word/document.xml": whole})), "word/document.xml", Room(20, 20))


def run(text: str, style: str = "") -> str:
    return f"<w:r><w:rPr>{style}</w:rPr><w:t>{text}</w:t></w:r>"


def formula(inside: str) -> str:
    return f'<m:oMath xmlns:m="http://schemas.openxmlformats.org/officeDocument/2006/math">{inside}</m:oMath>'


@pytest.mark.parametrize(("inside", "lines"), [
    (run("a = 1"), ["a = 1"]), (run("a = ") + "<w:r><w:tab/></w:r>" + run("1"), ["a = \t1"]),
    ('<w:pPr><w:tabs><w:tab w:val="left" w:pos="720"/></w:tabs></w:pPr>' + run("a = 1"), ["a = 1"]),
    (run("a = 1") + "<w:r><w:br/></w:r>" + run("b = 2"), ["a = 1", "b = 2"]),
    (run("a = 1") + '<w:r><w:br w:type="page"/></w:r>' + run("2"), ["a = 12"]),
    (run("a = 1") + "<w:r><w:cr/></w:r>" + run("b = 2"), ["a = 1", "b = 2"]),
    (run("a = 1") + "<w:r><w:noBreakHyphen/></w:r>" + run("2"), ["a = 1-2"]),
    (run("r = w") + run("3", '<w:vertAlign w:val="subscript"/>'), ["r = w3"]),
    (run("r = x") + run("2", '<w:vertAlign w:val="superscript"/>'), ["r = x^2"]),
    (run("a = 1") + "<w:del>" + run("2") + "</w:del>", ["a = 1"]),
    (run("r = x") + run("2", '<w:vertAlign w:val="superscript"/>') + run(" 3"), ["r = x^2 3"]),
    (run("a = 1") + "<w:del><w:del>" + run("2") + "</w:del>" + run("3") + "</w:del>" + run(" b"), ["a = 1 b"]),
    (run("a = 1") + "<w:Fallback><w:p>" + run("2") + "</w:p></w:Fallback>" + run(" b"), ["a = 1 b"]),
    (run("a = 1") + run(" + b", "<w:vanish/>") + run(" c"), ["a = 1 c"]), (run("a = 1", '<w:vanish w:val="0"/>'), ["a = 1"]),
    (run("r = w") + run("3", '<w:vanish w:val="true"/><w:vertAlign w:val="subscript"/>'), ["r = w"]),
    (run("a = 1") + "<w:moveFrom>" + run("2") + "</w:moveFrom>" + run(" b"), ["a = 1 b"]),
    ("no<w:r> no <w:t>a = 1</w:t> no </w:r>no", ["a = 1"]), ('<w:vMerge/><w:gridSpan w:val="2"/>' + run("a = 1"), ["a = 1"]),
    (formula("<m:r>no<m:t>a=1</m:t> no </m:r>no"), ["a=1"]),
    (formula("<m:r><w:rPr><w:p/></w:rPr><m:t>a=1</m:t></m:r>"), ["a=1"]),
    (formula("<m:r><m:t>a=1</m:t></m:r><w:del><m:r><m:t>2</m:t></m:r></w:del>"), ["a=1"]),
    (formula("<m:r><m:t>a=1</m:t></m:r>") + run(" and b") + run("3", '<w:vertAlign w:val="subscript"/>'), ["a=1", "and b3"]),
    ('<w:r><w:sym w:font="Symbol" w:char="F066"/></w:r>' + run(" = 1"), ["φ = 1"]),
    ('<w:r><w:sym w:font="Symbol" w:char="F0Z6"/></w:r>' + run(" = 1"), ["= 1"]),
])  # fmt: skip
def test_a_paragraph_is_what_a_reader_sees(inside: str, lines: list[str]) -> None:
    assert [line.text for line in read(f"<w:p>{inside}</w:p>").lines] == lines


@pytest.mark.parametrize(("before", "first"), [("", ["a", "b"]), ('<w:gridBefore w:val="1"/>', ["", "a", "b"])])
def test_a_row_may_begin_further_right(before: str, first: list[str]) -> None:
    cells = "".join(f"<w:tc><w:p>{run(text)}</w:p></w:tc>" for text in "ab")
    (table,) = read(f"<w:tbl><w:tr><w:trPr>{before}</w:trPr>{cells}</w:tr></w:tbl>").tables
    assert [[cell.text for cell in row] for row in table.rows] == [first]


def test_a_cell_may_span_columns_and_go_on_below() -> None:
    wide = '<w:gridSpan w:val="2"/>'
    rows = [[(wide, "a"), ("", "b")], [("", "c"), (wide, "d")], [("<w:vMerge/>", ""), (f"{wide}<w:vMerge/>", "")]]
    cells = ["".join(f"<w:tc><w:tcPr>{look}</w:tcPr><w:p>{run(text)}</w:p></w:tc>" for look, text in row) for row in rows]
    (table,) = read(f"<w:tbl>{''.join(f'<w:tr>{row}</w:tr>' for row in cells)}</w:tbl>").tables
    assert [[cell.text for cell in row] for row in table.rows] == [[*"aab"], [*"cdd"], [*"cdd"]]


def test_a_formula_within_a_formula_ends_with_the_outer_one() -> None:
    """Words behind the inner one are still of the formula."""
    inside = "<m:oMath><m:r><m:t>a=</m:t></m:r><m:oMath><m:r><m:t>b</m:t></m:r></m:oMath><m:r><m:t>+c</m:t></m:r></m:oMath>"
    spaces = 'xmlns:m="http://schemas.openxmlformats.org/officeDocument/2006/math"'
    (line,) = read(f"<w:p {spaces}>{inside}</w:p>").lines
    assert "".join(line.text.split()) == "a=b+c"


@pytest.mark.parametrize(
    ("second", "below"),
    [("", ["", "c"]), ("<w:tcPr><w:vMerge/></w:tcPr>", ["a", "c"]), ('<w:tcPr><w:vMerge w:val="restart"/></w:tcPr>', ["", "c"])],
)
def test_a_cell_that_nobody_filled_is_empty_and_one_merged_with_the_one_above_says_what_it_says(
    second: str, below: list[str]
) -> None:
    cell = "<w:tc>{0}<w:p>{1}</w:p></w:tc>".format
    rows = cell("", run("a")) + cell("", run("b")), cell(second, "") + cell("", run("c"))
    (table,) = read("<w:tbl>" + "".join(f"<w:tr>{row}</w:tr>" for row in rows) + "</w:tbl>").tables
    assert [cell.text for cell in table.rows[1]] == below
