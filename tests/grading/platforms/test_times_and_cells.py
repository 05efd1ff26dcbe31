"""Times that Moodle writes, and cells of CSV files: what they state, where they stand, and what they do not state."""

from __future__ import annotations

from datetime import datetime

import pytest

from coursework.grading.platforms import cells_of_csv
from coursework.grading.platforms.cells_of_csv import read_cells
from coursework.grading.platforms.moodle_times import moodle_time
from coursework.grading.platforms.roster import read_roster
from coursework.words.errors import InputError

DAY = (2026, 12, 1)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Tuesday, 1 December 2026, 11:59 PM", (*DAY, 23, 59)), ("1 December 2026, 12:05 AM", (*DAY, 0, 5)),
        ("1 December 2026, 12:05 PM", (*DAY, 12, 5)),
        ("1 December 2026, 1:05 PM", (*DAY, 13, 5)), ("1 December 2026, 13:05 PM", (*DAY, 13, 5)),
        ("1 December 2026, 11:05 AM", (*DAY, 11, 5)),
        ("1 December 2026, 00:05 PM", (*DAY, 0, 5)), ("1 December 2026, 23:59:58", (*DAY, 23, 59, 58)),
        ("2026-12-01 8.05", (*DAY, 8, 5)),
        ("2026年12月1日 下午 8:05", (*DAY, 20, 5)), ("2026年12月1日 上午 8:05", (*DAY, 8, 5)),
        ("1 de December de 2026 8:05", (*DAY, 8, 5)),
        # no time, two times, no day, a day or an hour that there is not
        ("1 December 2026", None), ("1 December 2026, 8:05 9:05", None), ("8:05", None), ("31 November 2026, 8:05", None),
        ("1 December 2026, 24:00", None), ("1 Foo 2026, 8:05", None), ("-", None),
    ],
)  # fmt: skip
def test_a_time_of_moodle(text: str, told: tuple[int, ...] | None) -> None:
    assert moodle_time(text) == (None if told is None else datetime(*told))


def test_a_file_of_cells_may_have_its_most_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cells_of_csv, "MOST_BYTES", 8)  # of 64 million a test would be slow
    assert read_cells(b"a" * 8, "own.csv").titles == ["a" * 8]
    with pytest.raises(InputError):
        read_cells(b"a" * 9, "own.csv")


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_cells_know_their_lines_and_are_replaced_where_they_stand(end: str) -> None:
    """A line end in quotation marks counts; a blank line is no record, but a line."""
    lines = ['id,"a;b;c;d",Name', f'1,"two{end}lines",x', "", '2,"say ""so""",y', "3"]
    cells = read_cells(end.join(lines).encode(), "own.csv")
    assert [[cell.value for cell in record] for record in cells.records] == [
        ["id", "a;b;c;d", "Name"], ["1", f"two{end}lines", "x"], ["2", 'say "so"', "y"], ["3"],
    ]  # fmt: skip
    assert [record[0].line for record in cells.records] == [1, 2, 5, 6]
    assert [cells.value(3, column) for column in (0, 1, None)] == ["3", "", ""]
    assert [*cells.named(["name"])] == [(1, {"name": "x"}), (2, {"name": "y"}), (3, {"name": ""})]
    changed = cells.replaced({(2, 1): cells.quoted("a, b"), (1, 0): cells.quoted(" 7"), (3, 0): cells.quoted("plain")})
    assert changed.decode() == end.join([lines[0], f'" 7","two{end}lines",x', "", '2,"a, b",y', "plain"])


def test_of_equal_titles_the_first_column_counts() -> None:
    assert read_cells(b"A;b;a\n1;2;3", "own.csv").columns == {"a": 0, "b": 1}


def test_a_roster_keeps_further_columns_and_leaves_blank_lines_out() -> None:
    students = read_roster(b"ID,Name,group\n7,Ann,  A \n,,\n8,Bob", "own.csv")
    assert [(one.id, one.name, one.email, one.variant, one.more, one.line) for one in students] == [
        ("7", "Ann", "", "", {"group": "A"}, 2), ("8", "Bob", "", "", {"group": ""}, 4),
    ]  # fmt: skip
