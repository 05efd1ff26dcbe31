"""Pipe tables, formulas and lines of Markdown stand where a reader sees them."""

from __future__ import annotations

import pytest

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.markdown import document_of_markdown, is_markdown


def rows(document: Document) -> list[list[list[str]]]:
    return [[[cell.text for cell in row] for row in table.rows] for table in document.tables]


def lines(document: Document) -> list[tuple[str, int, bool]]:
    return [(line.text, line.place.values["line"], line.is_formula) for line in document.lines]


@pytest.mark.parametrize(("text", "is_one"), [
    ("a|b\n-|-\n1|2", True), ("a|b\n--\n", False), ("a|b\n1|2", False), ("|:---:|:-|\n", True), ("a - b\n---", False),
    ("so $x = 1$ is", True), ("it costs 5$ or", False), ("$$\nx = 1\n$$", True), ("\\$x$", False), ("", False),
    ("so\n<table><tr><td>1</table>", True), ("a <tablet>", False),
])  # fmt: skip
def test_markdown_is_known_by_a_table_or_a_formula(text: str, is_one: bool) -> None:
    assert is_markdown(text) is is_one


@pytest.mark.parametrize(("text", "tables", "left"), [
    ("| a | b |\n|---|:-:|\n| 1 | 2 |\n| 3 | 4 |\nend", [[["a", "b"], ["1", "2"], ["3", "4"]]], [("end", 5, False)]),
    ("a|b\n-|-\n1|2\n\nc|d\n-|-\n3|4", [[["a", "b"], ["1", "2"]], [["c", "d"], ["3", "4"]]], []),
    ("a|b\n-|-", [[["a", "b"]]], []), ("a|b\n1|2", [], [("a|b", 1, False), ("1|2", 2, False)]),
    ("**a**|`b`\n-|-\n$1$|2\\|3", [[["a", "b"], ["1", "2|3"]]], []),
    ("a|b\n-|-\nw = 1|2\nend", [[["a", "b"], ["w = 1", "2"]]], [("w = 1|2", 3, False), ("end", 4, False)]),
    ("# So\n> **w1 = 2**\n\n* `w2 = 3`", [], [("# So", 1, False), ("w1 = 2", 2, False), ("w2 = 3", 4, False)]),
    ("one\n$$w1 = 2$$\ntwo", [], [("one", 1, False), ("w1 = 2", 2, True), ("two", 3, False)]),
    ("$$\nw1 =\n2\n$$\n$$w2 = 3$$\nend", [], [("w1 = 2", 1, True), ("w2 = 3", 5, True), ("end", 6, False)]),
    ("a\n$$\\begin{aligned} w1 &= 2 \\\\[2mm] w2 &= 3\\end{aligned}$$", [],
     [("a", 1, False), ("w1 = 2", 2, True), ("w2 = 3", 2, True)]),
    ("so $w1 = 2$ and $a$", [], [("w1 = 2", 1, True), ("a", 1, False), ("so  and", 1, False)]),
    ("a\\_1 = 2", [], [("a_1 = 2", 1, False)]),
    ("- $w1 = 2$\n- w2 = 3", [], [("w1 = 2", 1, True), ("w2 = 3", 2, False)]),
    ("$w1 = 2$\n- w2 = 3", [], [("w1 = 2", 1, True), ("- w2 = 3", 2, False)]),
    ("```\nw1 = r1 ...\n  + w2\n* w3 = 4\n```\n+ w4 = 5", [],
     [(text, place, False) for place, text in enumerate(("```", "w1 = r1 ...", "+ w2", "* w3 = 4", "```", "w4 = 5"), 1)]),
    ("so\n<table>\n<tr><td>a<td>b\n<tr><td>1<td>2</table>\nw1 = 2\n\na|b\n-|-\n", [[["a", "b"], ["1", "2"]], [["a", "b"]]],
     [("so", 1, False), ("w1 = 2", 5, False)]),
    ("with $a$ alone", [], [("with a alone", 1, False)]),
])  # fmt: skip
def test_tables_formulas_and_lines_stand_at_their_lines(
    text: str, tables: list[list[list[str]]], left: list[tuple[str, int, bool]]
) -> None:
    found = document_of_markdown(text, "utf-8")
    assert (rows(found), lines(found), found.is_whole) == (tables, left, False)


def test_a_table_stands_where_its_heads_do_and_ends_before_the_next_line_without_a_bar() -> None:
    found = document_of_markdown("so\na|b\n-|-\n1|2\nend\nc|d\n-|-\nend\ne|f\n-|-\n", "utf-8")
    assert [table.place.values["line"] for table in found.tables] == [2, 6, 9]
    assert rows(found) == [[["a", "b"], ["1", "2"]], [["c", "d"]], [["e", "f"]]]
    assert lines(found) == [("so", 1, False), ("end", 5, False), ("end", 8, False)]
