"""A spreadsheet drops zeros at the end of numbers: 6.5 all down a column is as fine as 6.283 beside it, and costs no points."""

import itertools

import numpy as np
import pytest

from coursework.grading.marking.grade import Marker
from coursework.grading.marking.rubric import Rubric
from coursework.grading.reading.numbers import printed
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.grading.reading.table.digits import FINEST, last_places
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import SLIDER_CRANK
from tests.grading.marking.table.desks import Desk
from tests.mechanisms.library import mechanism

STEADY = SLIDER_CRANK.replace(b"w0 + eps*sin(3*t)", b"w0 + 0*eps")


def short(value, digits):
    return f"{value:.{digits}f}".rstrip("0").rstrip(".")


def significant(value, digits):
    return f"{value:.{digits}g}"


def graded(desk, written, mark="."):
    """`written` (row, column, value) gives the text of each cell."""
    lines = [";".join(["t", *desk.key.names])]
    for row, values in enumerate(desk.machine.table()):
        cells = [written(row, place, value) for place, value in enumerate(values)]
        lines.append(";".join([short(row * desk.machine.h, 4), *cells]).replace(".", mark))
    files = (submitted_file("table.csv", "\n".join(lines).encode()),)
    return Marker(desk.key, Rubric()).grade(read_submission(Submission("a", None, files), desk.expected))


BELOW_ONE = "0.1234 0.2345 0.3456 0.4567 0.5678 0.6789 0.7891 1.234 1.235 1.236"


@pytest.mark.parametrize(("cells", "decimals", "places"), [
    ("1.50 2.25 3.10", 2, "2 2 2"), ("1.5 2.25 3.1 4 5.75", 2, "2 2 2 2 2"), ("x y", 0, "0 0"), ("1.5 x 2.25", 2, "2 2 2"),
    ("120 5 7", 0, "0 0 0"), ("1.2e+03 1.3e+02 1.4e+01", 0, "-2 -1 0"),
    ("0 0.123 1.23 12.3 -1.24 124", 2, "2 3 2 1 2 0"),  # three significant digits; a zero shows none
    ("1.234 12.34 0.1234 1.2 123.4", 1, "3 2 4 3 1"), ("1.230 12.34 0.1234 1.2 123.4", 1, "3 2 4 1 1"),  # 1.2 for 1.200, or not
    ("0.1234 0.2345 0.3456 1.234 12345", 4, "4 4 4 3 0"),
    ("0.1234 0.2345 0.3456 1.234 12345.6", 4, "4 4 4 4 4"),  # a whole number may be longer
    # Most numbers below 1 have four decimals either way: three of five above 1 with four digits are enough, three of six not.
    (f"{BELOW_ONE} 1.2 1.3", 4, "4 4 4 4 4 4 4 3 3 3 3 3"), (f"{BELOW_ONE} 1.2 1.3 1.4 0.8912 0.9123", 4, "4 " * 15),
    # A double keeps 15 digits: a zero behind more of them is round-off, and a column of as many was printed in full.
    ("12.345 1.2345 123.45 1.234 4.02000000000000", 3, "3 4 2 3 9"),
    ("12.345 1.2345 123.45 1.234 4.014999999999999", 3, "3 4 2 4 9"),
    ("2345678.1234567 234567.12345678 234567.123456 23456.123456789 234567.12345670", 8, "7 8 6 9 8"),
    ("12345678.1234567 1234567.12345678 1234567.123456 123456.123456789 1234567.12345670", 8, "7 8 8 9 8"),
])  # fmt: skip
def test_the_last_place_of_each_cell(cells: str, decimals: int, places: str) -> None:
    found = last_places([printed(cell, ".") for cell in cells.split()])
    assert found == (decimals, [pytest.approx(10.0 ** -int(place)) for place in places.split()])


@pytest.mark.long
@pytest.mark.parametrize("rate", ["6.5", "6.25", "-6.5", "7", "0.5"])
@pytest.mark.parametrize("style", [short, significant])
def test_a_steady_column_is_as_fine_as_those_beside_it(rate, style):
    desk = Desk(parse_variant(STEADY.replace(b'"7 1/s"', f'"{rate} 1/s"'.encode()), "own.toml", {}))
    least = desk.key.least_decimals + 1 + (style is significant)
    for digits in range(least, 8):
        for mark in ".,":
            grade = graded(desk, lambda row, place, value, to=digits: style(value, to), mark)
            assert grade.part("table")[0] == 60, (digits, mark)


@pytest.mark.parametrize(("cells", "lost"), [({5: ""}, 0), ({5: "13"}, 1), ({5: "#DIV/0!"}, 0), ({2: "8", 9: "6"}, 2)])
def test_a_slip_in_a_steady_column_costs_its_cell_and_not_the_column(cells, lost):
    """A drive of 7 1/s is printed without decimals; one cell that was left out took the other 20 with it.

    The task gives the drive's velocity, so nothing is lost where it is not written.
    """
    desk = Desk(parse_variant(STEADY, "own.toml", {}))
    place_of = desk.key.names.index("w1")
    grade = graded(desk, lambda row, place, value: cells.get(row, "7") if place == place_of else short(value, 5))
    counted = int(grade.table.cells.counted.sum())
    assert grade.part("table")[0] == pytest.approx(60 * (counted - lost) / counted, abs=0.01)


def test_rows_that_are_missing_take_no_digits_from_a_steady_column():
    desk = Desk(parse_variant(STEADY, "own.toml", {}))
    grade = graded(desk, lambda row, place, value: "" if row == 0 or row > 12 else short(value, 5))
    assert not grade.table.cells.too_coarse.any()


@pytest.mark.parametrize("step", ["the task's", "half of it"])
def test_a_jump_in_a_steady_column_takes_no_digits_from_it(step):
    """A row left out, and times numbered on: the driven angle stays in equal steps but for one."""
    desk = Desk(parse_variant(STEADY, "own.toml", {}))
    part = 1.0 if step == "the task's" else 0.5
    lines = [",".join(["t", *desk.key.names])]
    rows = [*desk.machine.table()]
    del rows[7]
    for row, values in enumerate(rows):
        lines.append(",".join([short(row * part * desk.machine.h, 4), *(short(value, 9) for value in values)]))
    files = (submitted_file("table.csv", "\n".join(lines).encode()),)
    grade = Marker(desk.key, Rubric()).grade(read_submission(Submission("a", None, files), desk.expected))
    assert not grade.table.cells.too_coarse.any()


def test_rows_that_stand_twice_in_a_steady_column_take_no_digits_from_it():
    """The key's angle has two decimals in every row, so a row put right among shifted ones tells nothing of how coarse it is."""
    desk = Desk(parse_variant(STEADY, "own.toml", {}))
    right = desk.machine.table()
    table = np.vstack([right[:8], right[9:], right[-1:]])
    table[21] = right[21]
    lines = [",".join(desk.key.names), *(",".join(short(value, 3) for value in row) for row in table)]
    files = (submitted_file("table.csv", "\n".join(lines).encode()),)
    grade = Marker(desk.key, Rubric()).grade(read_submission(Submission("a", None, files), desk.expected))
    assert not grade.table.cells.too_coarse.any()


def test_zeros_that_the_key_has_too_tell_nothing_of_how_coarse_a_column_is():
    """Steps of exactly 1 rad from 0.01 instead of 0: a last mistyped cell put right left only zeros and took all cells along."""
    desk = Desk(parse_variant(mechanism("crank").encode(), "own.toml", {}))
    turned = [0.0, *(row + 0.01 for row in range(1, 10))]
    tables = [np.column_stack([[*turned, last], np.full(11, 10.0)]) for last in (9.702, 10.0)]
    worse, better = (desk.marked(table, equations=None, digits=3) for table in tables)
    assert not better[1].cells.missing.any()
    assert better[0] > worse[0] > 50


def test_a_column_that_is_printed_coarser_than_those_beside_it_is_coarse():
    """As the numbers change, each of one digit behind the point, nothing was dropped."""
    desk = Desk(parse_variant(SLIDER_CRANK, "own.toml", {}))
    coarse = desk.key.names.index("w2")
    grade = graded(desk, lambda row, place, value: short(value, 1 if place == coarse else 4))
    assert grade.plain()["table"]["decimals"]["w2"] == 1
    assert np.all(grade.table.cells.student.units[:, coarse] == pytest.approx(0.1))


def test_significant_digits_that_are_all_there_are_no_dropped_zeros():
    desk = Desk(parse_variant(STEADY.replace(b'"7 1/s"', b'"6.283185 1/s"'), "own.toml", {}))
    grade = graded(desk, lambda row, place, value: significant(value, 4))
    assert grade.table.cells.student.units[0, desk.key.names.index("w1")] == pytest.approx(1e-3)


def test_all_digits_of_a_double_hide_no_zeros_that_were_dropped():
    """Python writes 0.07 beside 0.060000000000000005: seventeen digits times a power of ten end with a zero by chance."""
    angles = list(itertools.accumulate([0.01] * 100, initial=0.0))
    assert {len(repr(angle)) for angle in angles} >= {4, 18, 20}
    assert set(last_places([printed(repr(angle), ".") for angle in angles])[1]) == {FINEST}
