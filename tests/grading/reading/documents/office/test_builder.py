"""What a word processor's paragraphs, cells and formulas become: lines, tables, powers, cells that go on."""

from __future__ import annotations

from typing import Any

import pytest

from coursework.grading.reading.documents.document import MOST_LINES, Document, place_of
from coursework.grading.reading.documents.office.builder import DocumentBuilder
from coursework.grading.reading.limits import CELL_CHARACTERS, LINE_CHARACTERS, Room

MOST_ROWS, MOST_COLUMNS = 4, 5


def built(*steps: Any) -> Document:
    """Return the document that a writer's steps fill: a text, or the name of a method with its arguments."""
    builder = DocumentBuilder("docx", Room(MOST_ROWS, MOST_COLUMNS))
    for step in steps:
        if isinstance(step, str) and not hasattr(builder, step):
            builder.text(step)
        else:
            name, *given = (step,) if isinstance(step, str) else step
            getattr(builder, name)(*given)
    return builder.finished()


def lines(document: Document) -> list[tuple[str, bool]]:
    return [(line.text, line.is_formula) for line in document.lines]


def rows(document: Document) -> list[list[list[str]]]:
    return [[[cell.text for cell in row] for row in table.rows] for table in document.tables]


def table(*cells: Any) -> list[Any]:
    """Return the steps of a table: "/" ends a row, a text is a cell, a tuple a text and what its end says of it."""
    steps: list[Any] = ["open_table", "open_row"]
    for cell in cells:
        if cell == "/":
            steps += ["close_row", "open_row"]
        else:
            text, *given = cell if isinstance(cell, tuple) else (cell,)
            steps += ["open_paragraph", ("text", text), "close_paragraph", ("close_cell", *given)]
    return [*steps, "close_row", "close_table"]


@pytest.mark.parametrize(("pieces", "line"), [
    ([("w", ""), ("1", "sub"), (" = 2", "")], "w1 = 2"), ([("r", ""), ("1", "sub"), ("w", ""), ("1", "sub")], "r1 w1"),
    ([("x", ""), ("2", "super"), ("y", "")], "x^2y"), ([("x", ""), (" -12 ", "super")], "x^-12"),
    ([("x", ""), ("1234", "super")], "x1234"),
    ([("x", ""), ("n", "super")], "xn"), ([("x", ""), ("1", "sub"), ("2", "super")], "x1^2"),
    ([("a", ""), ("1", "sub"), ("2", "sub")], "a12"),
    ([("a", ""), ("1", "sub"), ("+b", "")], "a1+b"),
])  # fmt: skip
def test_what_is_set_lower_is_an_index_and_what_is_set_higher_a_power(pieces: list[tuple[str, str]], line: str) -> None:
    """Behind an index the next letter begins a name of its own."""
    found = built("open_paragraph", *(("text", *piece) for piece in pieces), "close_paragraph")
    assert lines(found) == [(line, False)]


def test_paragraphs_have_numbers_but_blank_ones_have_none() -> None:
    found = built("a = 1", "close_paragraph", "open_paragraph", "close_paragraph", "close_paragraph", "b = 2")
    assert [(line.text, line.place) for line in found.lines] == [
        ("a = 1", place_of("paragraph", number=1)), ("b = 2", place_of("paragraph", number=2)),
    ]  # fmt: skip


def test_a_text_box_is_a_paragraph_inside_another() -> None:
    assert lines(built("open_paragraph", "a = ", "open_paragraph", "in the box", "close_paragraph", "1", "close_paragraph")) == [
        ("in the box", False), ("a = 1", False),
    ]  # fmt: skip


@pytest.mark.parametrize(("steps", "expected"), [
    (["so ", ("formula", "a = 1\nb = 2")], [("a = 1", True), ("b = 2", True), ("so", False)]),
    ([("formula", "a = 1")], [("a = 1", True)]), (["with ", ("formula", "a"), " small"], [("with  a small", False)]),
    ([("formula", "a")], [("a", True)]), ([("formula", "a = 1\nb")], [("a = 1 b", True)]),
    (["f", "open_paragraph", ("formula", "a = 1"), "close_paragraph", "g"], [("a = 1", True), ("fg", False)]),
])  # fmt: skip
def test_an_equation_that_stands_as_a_formula_is_a_line_of_its_own(steps: list[Any], expected: list[tuple[str, bool]]) -> None:
    assert lines(built(*steps)) == expected


def test_a_line_that_is_too_long_ends_where_it_may() -> None:
    assert lines(built("a" * LINE_CHARACTERS, "b")) == [("a" * LINE_CHARACTERS, False)]
    assert lines(built("a" * (LINE_CHARACTERS + 1))) == []


def test_beyond_the_most_paragraphs_nothing_is_read() -> None:
    found = built(*(step for _ in range(MOST_LINES + 1) for step in ("x", "close_paragraph")))
    assert len(found.lines) == MOST_LINES


@pytest.mark.parametrize(("cells", "expected"), [
    (["a", "b", "/", "c", "d"], [["a", "b"], ["c", "d"]]), ([("a", 2), "b"], [["a", "a", "b"]]),
    ([("a", 9), "b"], [["a"] * 5]), (["1", "2", "3", "4", ("5", 2)], [["1", "2", "3", "4", "5"]]),
    (["a", "b", "/", ("", 1, True), "d"], [["a", "b"], ["a", "d"]]),
    (["a", "b", "/", "c", ("", 1, True)], [["a", "b"], ["c", "b"]]),
    (["a", "b", "/", "c", "d", "/", ("", 1, True), "e"], [["a", "b"], ["c", "d"], ["c", "e"]]),
    (["a", "b", "/", ("x", 1, True), "d"], [["a", "b"], ["x", "d"]]), ([("", 1, True), "b"], [["", "b"]]),
    (["a", "b", "/", "c", "d", ("", 1, True)], [["a", "b"], ["c", "d", ""]]),
    (["a", ("", 1, False, True)], [["a", "a"]]), (["a", ("b", 1, False, True)], [["a", "b"]]),
    ([("", 1, False, True), "b"], [["", "b"]]), (["a", "b", ("", 1, False, True)], [["a", "b", "b"]]),
    (["a", "b", "/", "", "", "/", "c", "d"], [["a", "b"], ["c", "d"]]), (["a"], None),
    (["a", "b", *["/", "c", "d"] * 9], [["a", "b"], *[["c", "d"]] * 3]), ([" a\xa0", "b\nc"], [["a", "b c"]]),
])  # fmt: skip
def test_cells_are_repeated_go_on_and_end_where_the_table_may(cells: list[Any], expected: list[list[str]] | None) -> None:
    assert rows(built(*table(*cells))) == ([] if expected is None else [expected])


def test_rows_that_stand_there_several_times_and_columns_left_free() -> None:
    start = ["open_table", ("open_row", 2), "a", "close_paragraph", "close_cell"]
    assert rows(built(*start, ("close_row", 2), "close_table")) == [[["", "", "a"]] * 2]
    assert rows(built(*start, ("close_row", 9), "close_table")) == [[["", "", "a"]] * MOST_ROWS]
    assert rows(built("open_table", ("open_row", 99), "a", "close_cell", "close_row", ("open_row", -1), *"ab")) == []
    several = ["open_table", "open_row", "a", "close_paragraph", "b", "close_paragraph", "close_cell", "c", "close_paragraph"]
    assert rows(built(*several)) == [[["a b", "c"]]]  # what is still open is ended


def test_a_table_inside_a_cell_is_a_table_of_its_own_and_equations_in_cells_are_lines() -> None:
    inner = table("1", "2")
    found = built("open_table", "open_row", "a", "close_paragraph", *inner, "w1 = 2", "close_paragraph", "close_cell",
                  "b", "close_paragraph", "close_cell", "close_row", "close_table")  # fmt: skip
    assert rows(found) == [[["1", "2"]], [["a w1 = 2", "b"]]]
    assert [one.place for one in found.tables] == [place_of("table", number=2), place_of("table", number=1)]
    assert [(line.text, line.place) for line in found.lines] == [("w1 = 2", place_of("table", number=1))]


def test_a_long_cell_is_cut_and_what_belongs_to_no_table_is_left_out() -> None:
    assert rows(built(*table("x" * (CELL_CHARACTERS + 1), "b"))) == [[["x" * CELL_CHARACTERS, "b"]]]
    assert rows(built("open_row", "close_cell", "close_row", "close_table")) == []
