"""Pieces of a text exchanged at once, and where what is new stands then."""

import pytest

from coursework.desk.answering.edits import changed

TEXT = "a = 1\nb = 22\nc = 3\n"


@pytest.mark.parametrize(("pieces", "text", "ranges"), [
    ([(4, 5, "10")], "a = 10\nb = 22\nc = 3\n", [(1, 5, 1, 7)]),
    ([(10, 12, "5"), (4, 5, "100")], "a = 100\nb = 5\nc = 3\n", [(1, 5, 1, 8), (2, 5, 2, 6)]),  # in whichever order they come
    ([(5, 5, "\nx = 0")], "a = 1\nx = 0\nb = 22\nc = 3\n", [(1, 6, 2, 6)]),
    ([(4, 5, ""), (17, 18, "4")], "a = \nb = 22\nc = 4\n", [(3, 5, 3, 6)]),  # what is taken away is nowhere
    ([], TEXT, []),
])  # fmt: skip
def test_what_is_new_is_shown_where_it_stands(pieces, text, ranges):
    found = changed(TEXT, pieces)
    assert found["text"] == text
    assert [(one["line"], one["column"], one["end_line"], one["end_column"]) for one in found["ranges"]] == ranges
