"""Heads in words and what stands below them: read in any order, or a person is asked; nothing is passed over in silence."""

from __future__ import annotations

import math

import pytest

from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.reading.table.misread import HEAD, ROWS, cells, csv, read, refused
from tests.grading.scenes import expected


def test_heads_that_say_more_than_a_name_are_read_and_those_that_name_nothing_are_asked_about() -> None:
    """A column that was not understood was said not to be in the file, and its cells were lost."""
    told = [f"angle of the link {name}" if name.startswith("phi") else f"rate {name}" for name in HEAD[1:]]
    body = csv(ROWS).partition(b"\n")[2]
    table = read(";".join(["t", *told]).encode() + b"\n" + body)
    assert [column.name for column in table.columns] == HEAD[1:]
    for own in (
        ["crank", "rod", "sin phi3", *HEAD[4:]],
        [*HEAD[1:-1], "rate of the wheel"],
        [*HEAD[1:-1], "w5"],
    ):
        table = read(";".join(["t", *own]).encode() + b"\n" + body)
        assert table.asked is not None and table.asked.key == "reading.trouble.unread_heads"
        assert [column.name for column in table.columns] == HEAD[1:]
    more = [["t", "crank", "rod", "other", *HEAD[3:]], *([*row[:3], "1.5", *row[3:]] for row in ROWS)]
    trouble = refused("\n".join(";".join(row) for row in more).encode())
    assert (trouble.state, trouble.code) == ("needs-review", "unread_heads")


WORDS = {
    "angle of link {}": "angular velocity of link {}", "link {} angle": "link {} angular velocity",
    "angle {} (rad)": "speed {} (rad/s)",
    "кут {}-ї ланки": "кутова швидкість {}-ї ланки", "Угол поворота звена {}, рад": "Угловая скорость звена {}, рад/с",
    "Winkel des Gliedes {} in rad": "Winkelgeschwindigkeit des Gliedes {} in rad/s", "杆{}的角度/rad": "杆{}的角速度/(rad/s)",
    "angle of the {o} link": "angular velocity of the {o} link", "Ang{}": "Vel{}", "φ{} - angle of link {}": "φ{}' (1/s)",
}  # fmt: skip


@pytest.mark.parametrize("angle", WORDS)
def test_heads_in_words_are_read_in_any_order(angle: str) -> None:
    """Heads that were not understood were read in the order of the task: a table in another order was all wrong."""
    said = [
        (angle if name.startswith("phi") else WORDS[angle]).format(
            *2 * [name[-1]], o=["first", "second", "third", "fourth"][int(name[-1]) - 1]
        )
        for name in HEAD[1:]
    ]
    order = [6, 4, 5, 3, 0, 2, 1]
    lines = [["time", *(said[at] for at in order)], *([row[0], *(row[1 + at] for at in order)] for row in ROWS)]
    table = read("\n".join(";".join(line) for line in lines).encode())
    assert {found.name: found.values for found in table.columns} == {
        found.name: found.values for found in read(csv(ROWS)).columns
    }


def test_a_head_of_another_quantity_is_none_of_the_task() -> None:
    other = ["error of angle 1", "angular acceleration of link 2", "exact angle of link 3"]
    table = read("\n".join(";".join(line) for line in [[*HEAD, *other], *([*row, "1.5", "2.5", "3.5"] for row in ROWS)]).encode())
    assert [column.name for column in table.columns] == HEAD[1:]


def test_numbers_below_a_head_over_several_columns_are_their_indices() -> None:
    heads = [["t", "φ, рад", "", "", "ω, рад/с", "", "", ""], ["", "1", "2", "3", "1", "2", "3", "4"]]
    table = read("\n".join(";".join(line) for line in [*heads, *ROWS]).encode())
    assert [(column.name, column.by) for column in table.columns] == [(name, "header") for name in HEAD[1:]]
    counted = [["", *map(str, range(8))], *([str(k), *row] for k, row in enumerate(ROWS))]  # as Mathcad shows a matrix
    assert len(read("\n".join("\t".join(line) for line in counted).encode()).columns) == 7


def test_an_angle_in_two_units_is_one_column_and_another_number_is_none() -> None:
    turned = [
        [row[0], *(cell for text in row[1:4] for cell in (f"{math.degrees(float(text)):.2f}", text)), *row[4:]] for row in ROWS
    ]
    heads = ["t", *(f"{name}, {unit}" for name in HEAD[1:4] for unit in ("deg", "rad")), *HEAD[4:]]
    table = read("\n".join(";".join(row) for row in [heads, *turned]).encode())
    assert {found.name: found.values for found in table.columns} == {
        found.name: found.values for found in read(csv(ROWS)).columns
    }
    turned[4][1] = "99.99"
    assert refused("\n".join(";".join(row) for row in [heads, *turned]).encode()).code == "two_columns"


def test_a_column_of_what_is_no_number_is_asked_about() -> None:
    spoilt = [[row[0], f"{int(math.degrees(float(row[1])))}° and a half", *row[2:]] for row in ROWS]
    assert refused(csv(spoilt)).code == "unread_column"


def test_degrees_minutes_and_seconds_are_an_angle() -> None:
    """Angles of 40 to 140 degrees, taken apart with whole numbers here; minutes alone tell a tenth of a degree."""
    for seconds in ('{:02d}"', "{:02d}″", ""):
        turned = []
        for row in ROWS:
            whole = round(math.degrees(float(row[1])) * 3600)
            parts = whole // 3600, whole // 60 % 60, whole % 60
            turned.append([row[0], "{}°{:02d}'".format(*parts) + seconds.format(parts[2]), *row[2:]])
        table = read(csv(turned))
        found = table.column("phi1")
        assert found is not None and found.unit == "deg"
        off = max(abs(value - float(row[1])) for value, row in zip(found.values, ROWS, strict=True))
        assert off <= math.radians((1 if seconds else 60) / 3600) < found.last_place[0]


def test_a_cell_that_may_hold_a_number_and_could_not_be_read_asks_a_person() -> None:
    for text, is_asked in (
        ("<1.5985", True),
        ("1.59 or 1.60", True),
        ("1.5985*", False),
        ("", False),
        ("above", False),
        ("=A1", False),
    ):
        file = submitted_file("t.csv", csv(cells(r2c2=text)))
        work = read_submission(Submission("x", None, (file,)), expected())
        assert work.table is not None
        assert (work.review is not None) is is_asked, text
        assert not is_asked or f"phi1 in row 2: “{text}”" in str(work.review)
