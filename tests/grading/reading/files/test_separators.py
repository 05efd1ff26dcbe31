"""What parts the cells of a line, and what stands in which column, as a person sees it in a file of plain text."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import LINE_CHARACTERS, Refused, Room

ROWS = "0 1.5 2|0.1 1.6 3|0.2 1.7 4"
BODY = ROWS.replace("|", "\n")


@pytest.mark.parametrize(("text", "separator", "rows"), [
    ("t;x;y\n0;1,5;2\n0,1;1,6;3", ";", "t x y|0 1,5 2|0,1 1,6 3"), ("t,x,y\n0,1.5,2\n0.1,1.6,3", ",", "t x y|0 1.5 2|0.1 1.6 3"),
    ("x;y\n0;1,5\n0,1;1,6", ";", "x y|0 1,5|0,1 1,6"), ("0;a b;2\n1;c d;3\n2;e f;4", ";", "0 a_b 2|1 c_d 3|2 e_f 4"),
    ("| t | x |\n|---|---|\n| 0 | 1.5 |\n| 0.1 | 1.6 |", "|", "t x|--- ---|0 1.5|0.1 1.6"),
    ("0│1.5│2\n1│1.6│3", "|", "0 1.5 2|1 1.6 3"),
    ("0，1.5，2\n0.1，1.6，3", ",", "0 1.5 2|0.1 1.6 3"), ("[[0, 1.5, 2],[0.1, 1.6, 3],[0.2, 1.7, 4]]", "cells", ROWS),
    ("t\nx\ny\n0\n1.5\n2\n0.1\n1.6\n3\n0.2\n1.7\n4", "cells", f"t x y|{ROWS}"),
    ("## t x y\n## 0 1 2\n## 1 2 3", "blanks", "t x y|0 1 2|1 2 3"),
    ("1 2\n3 4\n5 6", "blanks", "1 2|3 4|5 6"), ("hello world\nthis is text", None, ""),
    # heads of several words, and a sign of a remark before them
    (f"time, s  angle, rad  speed\n{BODY}", "blanks", f"time,_s angle,_rad speed|{ROWS}"),
    (f"# t x y\n{BODY}", "blanks", f"t x y|{ROWS}"),
    (f"n t x y\n{BODY}", "blanks", f"n t x y|{ROWS}"), (f"time, s  angle, rad\n{BODY}", "blanks", f"time,_s angle,_rad|{ROWS}"),
    # an empty cell between blanks: the number stands below its column, or below none
    ("0    1.5   2\n0.1  1.6   3\n0.2        4", "blanks", "0 1.5 2|0.1 1.6 3|0.2 - 4"),
    ("0    1.5   2\n0.1  1.6   3\n0.2 1.77777\n0.3  1.8   5", "blanks", "0 1.5 2|0.1 1.6 3|0.2 1.77777 -|0.3 1.8 5"),
    ("0    1.5   2\n0.1  1.6   3\n0.2 1.777777\n0.3  1.8   5", "blanks", "0 1.5 2|0.1 1.6 3||0.3 1.8 5"),
    ("0    1.5   2\n0.1  1.6   3\n0.2      \n0.3  1.8   5", "blanks", "0 1.5 2|0.1 1.6 3|0.2|0.3 1.8 5"),
    ("0 1 2\n1 2 3\n2 3 4\n\nt     u   v\n0     5   6\n1         7\n2     6   8", "blanks",
     "0 1 2|1 2 3|2 3 4||t u v|0 5 6|1 - 7|2 6 8"),
    ("0    1    2\n1    2    3\n2    3    4\n\nt u v\n0 5 6\n1   7\n2 6 8", "blanks",
     "0 1 2|1 2 3|2 3 4||t u v|0 5 6|1 - 7|2 6 8"),
    ('0, "1,5", 2\n1, "1,6", 3', ",", "0 1,5 2|1 1,6 3"), ('0;"1;5";2\n1;1.6;"3\n"', ";", "0 1;5 2|1 1.6 3"),
    # a data frame in print: heads end where their columns end, the numbers of rows have none
    ("     t         y\n0  0.0  1.5  2.0\n1  0.1  1.6  3.0", "blanks", "- t - y|0 0.0 1.5 2.0|1 0.1 1.6 3.0"),
    ("     t         y\n1  0.0  1.5  2.0\n2  0.1  1.6  3.0", "blanks", "- t - y|1 0.0 1.5 2.0|2 0.1 1.6 3.0"),
    ("     t         y\n1  0.0  1.5  2.0\n3  0.1  1.6  3.0", "blanks", "t y|1 0.0 1.5 2.0|3 0.1 1.6 3.0"),
    ("n    t         y\n0  0.0  1.5  2.0\n1  0.1  1.6  3.0", "blanks", "n t y|0 0.0 1.5 2.0|1 0.1 1.6 3.0"),
    ("     t        y \n0  0.0  1.5  2.0\n1  0.1  1.6  3.0", "blanks", "t y|0 0.0 1.5 2.0|1 0.1 1.6 3.0"),
])  # fmt: skip
def test_a_text_is_parted(text: str, separator: str | None, rows: str) -> None:
    """Rows are parted by a bar, cells by blanks; a dash is an empty cell."""
    found = split(text, Room(600, 40))
    assert (found and found.separator) == separator
    assert found is None or "|".join(" ".join(cell.replace(" ", "_") or "-" for cell in row) for row in found.rows) == rows


def test_decimal_commas_between_commas_are_told() -> None:
    """0,1 is two cells there: numbers without any decimals, more than five of them."""
    halves = "0,1,5,2\n0,2,6,3\n"
    found = [
        split(text, Room(600, 40)) for text in (halves, "0,1,5\n0,2,6\n", halves.replace("6", "6.5"), halves.replace(",", ";"))
    ]
    assert [one and one.has_pairs for one in found] == [True, True, False, False]
    few = split("1,5\n2,6\n", Room(600, 40))
    assert few is not None and not few.has_pairs


def test_as_many_lines_and_columns_are_read_as_there_is_room_for() -> None:
    found = split(f"{BODY}\n\n \n0.3 1.8 5\n0.4 1.9 6", Room(4, 2))
    assert found is not None and found.rows == (("0", "1.5"), ("0.1", "1.6"), ("0.2", "1.7"), (), (), ("0.3", "1.8"))


@pytest.mark.parametrize("end", ["", "\n"])
def test_a_line_may_have_just_so_many_characters(end: str) -> None:
    longest = BODY + "\n" + "x" * LINE_CHARACTERS + end
    assert split(longest, Room(600, 40)) is not None
    with pytest.raises(Refused):
        split(f"x{longest[::-1]}"[::-1] if not end else longest[:-1] + "x\n", Room(600, 40))
