"""Rows of tables that programs print in pieces, as lists, by names or in Typst; what only looks like one is left as it is."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.printed import in_whole_lines, listed_rows, named_rows, rows_of_typst
from coursework.grading.reading.limits import Room


@pytest.mark.parametrize(("lines", "whole"), [
    ("1.0e+03 *|0 1.5|done now|0 1.5", "|0 1.5e+03|done now|0 1.5"), ("0 1 2|1 2 3|2 3 4", "0 1 2|1 2 3|2 3 4"),
    ("x y|0 1 2|3|1 2 3|4|2 3 4|5|end", "x y|0 1 2 3|1 2 3 4|2 3 4 5|end"),
    ("a b c|d|0 1 2|3|1 2 3|4|2 3 4|5", "a b c d|0 1 2 3|1 2 3 4|2 3 4 5"),
    ("0 1|2 3|4|1 2|3 4|5|2 3|4 5|6", "0 1 2 3 4|1 2 3 4 5|2 3 4 5 6"),
    # the last row is not whole; the second line is longer; two rows are too few
    ("0 1 2|3|1 2 3|4|2 3 4", "0 1 2|3|1 2 3|4|2 3 4"), ("0|1 2|1|2 3|2|3 4", "0|1 2|1|2 3|2|3 4"),
    ("0 1 2|3|1 2 3|4", "0 1 2|3|1 2 3|4"),
])  # fmt: skip
def test_a_row_over_several_lines_is_one_where_all_are(lines: str, whole: str) -> None:
    assert "|".join(in_whole_lines(lines.split("|"))) == whole


@pytest.mark.parametrize(("text", "room", "rows"), [
    ("[0 1; 1 2; 2 3]", (3, 9), "0 1|1 2|2 3"), ("[0 1; 1 2]", (9, 9), ""), ("[0 1; 1 2; 2 3]", (2, 9), ""),
    ("[0,1; 1,2; 2,3]", (9, 9), "0 1|1 2|2 3"),
    ("[0 1 5; 1 2 5; 2 3 5]", (9, 2), "0 1|1 2|2 3"), ("[0 1; 1 2; 2 3; 3 4 5]", (9, 9), "0 1|1 2|2 3"),
    ("[0, 1; 1, x; 2, 3; 3, 4]", (9, 9), "0 1|2 3|3 4"), ('h = ["t", "w"]; T = [0 1; 1 2; 2 3]', (9, 9), "t w|0 1|1 2|2 3"),
    ('h = ["t", "w", "x"]; T = [0 1; 1 2; 2 3]', (9, 9), "0 1|1 2|2 3"), ("a = [0, 1]\n[1, 2]\n[2, 3]", (9, 9), "0 1|1 2|2 3"),
    ("a = [0, 1]\nb = [1, 2]\nc = [2, 3]", (9, 9), "a 0 1|b 1 2|c 2 3"),
    ("a = [0, 1]\nb = [1, 2]\nc = [2, 3]", (9, 2), "a 0 1|b 1 2"),
])  # fmt: skip
def test_rows_of_lists_of_equal_length(text: str, room: tuple[int, int], rows: str) -> None:
    assert "|".join(map(" ".join, listed_rows(text, Room(*room)))) == rows


@pytest.mark.parametrize(("text", "most", "rows"), [
    ("t=0 w=5\nt=1 w=6\nt=2 w=7", 9, "t w|0 5|1 6|2 7"), ("t=0, w=5, t=1, w=6, t=2, w=7,", 9, "t w|0 5|1 6|2 7"),
    ("t=0 w=5\nt=1 w=6", 9, ""), ("t=0\nt=1\nt=2", 9, ""), ("t=0 w=5\nt=1 w=6\nt=2 w=7\nt=3 w=9", 3, "t w|0 5|1 6|2 7"),
])  # fmt: skip
def test_rows_of_numbers_behind_their_names(text: str, most: int, rows: str) -> None:
    assert "|".join(map(" ".join, named_rows(text, most))) == rows


@pytest.mark.parametrize(("table", "most", "rows"), [
    ("(columns: 2, [t], [w], [0], [5])", 9, "t w|0 5"), ("(columns: (1fr, 2fr), [t], [w], [0], [5])", 9, "t w|0 5"),
    ("(columns: (auto,) * 3, [t], [w], [x], [0], [5], [6])", 9, "t w x|0 5 6"),
    ('(columns: 2, $t$, [*w*], [0], "5")', 9, "t w|0 5"),
    ("(columns: 2, [t], [w]) #table(columns: 2, [t], [u], [0], [5])", 9, "t u|0 5"), ("([t], [w], [0], [5])", 9, ""),
    ("(columns: 2, [t], [w], [a], [b])", 9, ""), ("(columns: 2, [t], [w], [0], [5], [1], [6])", 2, "t w|0 5"),
    ("(columns: 1, [t], [0], [5])", 9, ""),
])  # fmt: skip
def test_rows_of_the_largest_table_of_typst(table: str, most: int, rows: str) -> None:
    assert "|".join(map(" ".join, rows_of_typst(f"#table{table}", most))) == rows
