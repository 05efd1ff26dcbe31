"""Right tables in shapes that pages, programs and calculators give them: each is read as the table it is."""

from __future__ import annotations

import json
import math

import pytest

from coursework.grading.reading.expected import Grid, GridColumn
from coursework.grading.reading.files.separators import split
from coursework.grading.reading.limits import Room
from coursework.grading.reading.numbers import printed
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.grading.reading.table.columns import find_columns
from coursework.grading.reading.table.layout import layouts_of
from coursework.grading.reading.table.units import turns_of_jumps, unit_of_column, whole_turns
from tests.grading.reading.table.misread import HEAD, ROWS, csv, read
from tests.grading.scenes import expected

TURN = 2 * math.pi


def _values(content: bytes) -> list[tuple[float, ...]]:
    return [column.values for column in read(content).columns]


def _changed(at: int, change: object) -> list[list[str]]:
    return [[change(cell) if place == at else cell for place, cell in enumerate(row)] for row in ROWS]  # type: ignore[operator]


RIGHT = _values(csv(ROWS))
HEADS = ",".join(HEAD)


def _pages(rows: list[list[str]], length: int) -> bytes:
    """Pages with their heads, each of which begins with the last row of the page before."""
    pages = [rows[begin : begin + length] for begin in range(0, len(rows), length - 1)]
    return "\n".join(f"Page {k}\n{HEADS}\n" + "\n".join(map(",".join, page)) for k, page in enumerate(pages, 1)).encode()


SHAPES = {
    "pages that begin with the last row": _pages(ROWS, 10),
    "numbers of steps under the time": csv([[str(k), *row[1:]] for k, row in enumerate(ROWS)]),
    "numbers of rows under the time": csv([[str(k), *row[1:]] for k, row in enumerate(ROWS, 1)]),
    "a minus as accountants write it": csv([[f"({cell[1:]})" if cell[0] == "-" else cell for cell in row] for row in ROWS]),
    "what R printed into a page": "\n".join(
        "## " + " ".join(f"{cell:>9}" for cell in row)
        for row in (["", *HEAD], *([str(k), *row] for k, row in enumerate(ROWS, 1)))
    ).encode(),
    "powers of Mathematica": csv([[f"{float(cell) / 10:.5f}*^1" for cell in row] for row in ROWS]),
}


def test_each_shape_is_the_same_table():
    assert any(cell.startswith("-") for row in ROWS for cell in row)
    for name, content in SHAPES.items():
        assert _values(content) == [pytest.approx(column, abs=1e-9) for column in RIGHT], name


def test_parentheses_beside_a_minus_are_no_minus():
    rows = [list(row) for row in ROWS]
    at = next(place for place in range(1, len(HEAD)) if rows[3][place][0] != "-")
    rows[3][at] = f"({rows[3][at]})"
    assert _values(csv(rows)) == RIGHT


def test_a_time_that_counts_seconds_of_a_long_step_is_a_time():
    """Where the step may be a second, 0, 1, 2 … are seconds."""
    found = read(csv([[f"{k * 0.1:.1f}", *row[1:]] for k, row in enumerate(ROWS)]))
    assert found.own is not None and found.own.step == pytest.approx(0.1)


def test_an_angle_that_is_kept_within_a_turn_is_the_angle():
    """0 to 360 and ±180 degrees: the jump is taken off, and said; a mistyped cell and a wild motion stay what they are."""
    at = HEAD.index("phi3")
    value = RIGHT[at - 1][10]
    for low in (value - TURN / 2, value + 0.01 - TURN):  # the column passes the edge of this turn
        rows = _changed(at, lambda cell, low=low: f"{(float(cell) - low) % TURN + low - TURN:.4f}")
        found = read(csv(rows))
        assert found.columns[at - 1].values == pytest.approx(RIGHT[at - 1], abs=2e-4)
        assert [note.code for note in found.notes] == ["turns"]
    rows = [list(row) for row in ROWS]
    rows[7][at] = f"{float(rows[7][at]) + TURN + 0.3:.4f}"
    mistyped = read(csv(rows)).columns[at - 1]
    assert (mistyped.turns, mistyped.values[7]) == ((), pytest.approx(RIGHT[at - 1][7] + TURN + 0.3, abs=1e-3))
    assert turns_of_jumps([0.0, 2.5, 5.0, 1.2, 3.9]) == [0, 0, 0, 0, 0]
    sixth = TURN / 6  # as far an angle may move in a row in which it jumps
    assert turns_of_jumps([3.0, 3.0 + sixth - 0.01 - TURN]) == [0, -1]
    assert turns_of_jumps([3.0, 3.0 + sixth + 0.01 - TURN]) == [0, 0]


@pytest.mark.parametrize(("first", "unit"), [(57.2958, "deg"), (57.8, "deg"), (58.0, None), (60.1, None), (1.0, "rad")])
def test_a_column_that_begins_as_the_task_in_degrees_is_in_degrees(first: float, unit: str) -> None:
    """A small start counts too; what only comes near is another column, or another start."""
    key = GridColumn("phi1", "rad", (0.05, 1.0, 2.0, 3.0))
    assert unit_of_column(key, "", [0.05 * first, 9.0, 17.0, 23.0]) == unit


def test_a_cell_that_is_right_as_it_stands_keeps_its_turns():
    """Put right in a column that is half a turn off, by another origin, it was moved away from the key."""
    key = GridColumn("phi1", "rad", (1.0, 1.2, 1.4, 1.6))
    assert whole_turns(key, [-2.3, -2.1, math.nan, 1.6]) == (-1, -1, -1, 0)


def test_a_start_in_degrees_above_angles_in_radians_is_no_turns_away():
    """Of 120.32 for 2.1 rad 19 turns were taken off, which leave 0.94; turns that do lead to the key are taken off still."""
    angles = [2.1, 2.3, 2.5, 2.7, 2.9, 3.1]
    key, moves = GridColumn("phi1", "rad", tuple(angles)), [0.2] * 5
    assert whole_turns(key, [math.degrees(2.1), *angles[1:]], moves) == ()
    assert whole_turns(key, [angles[0] + 19 * TURN, *angles[1:]], moves) == (19, 0, 0, 0, 0, 0)


def test_rows_left_out_are_no_turns():
    """A table with every fifth row and two neighbours: the angle went by more than half a turn where no row tells it."""
    angles = [0.5 + 0.1 * row for row in range(60)]
    shown = {*range(0, 60, 5), 51}
    printed = [angle if row in shown else math.nan for row, angle in enumerate(angles)]
    moves = [0.1 if row in shown else math.nan for row in range(59)]
    assert whole_turns(GridColumn("phi1", "rad", tuple(angles)), printed, moves) == ()
    within = [angle - TURN * (angle > math.pi) for angle in printed]
    found = whole_turns(GridColumn("phi1", "rad", tuple(angles)), within, moves)
    assert all(found[row] == -(angles[row] > math.pi) for row in shown)


def test_rows_that_a_notebook_prints_with_names_are_no_equations():
    printed = [" ".join(f"{name}={cell}" for name, cell in zip(HEAD, row, strict=True)) for row in ROWS]
    output = {"output_type": "stream", "name": "stdout", "text": [f"{line}\n" for line in printed]}
    cell = {"cell_type": "code", "source": "", "metadata": {}, "execution_count": 1, "outputs": [output]}
    notebook = json.dumps({"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
    work = read_submission(Submission("x", None, (submitted_file("work.ipynb", notebook.encode()),)), expected())
    assert work.table is not None and work.equations is None


def test_numbers_in_brackets_before_equations_make_no_data_of_a_program():
    lines = "[1] VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0\n[2] 2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0"
    work = read_submission(Submission("x", None, (submitted_file("equations.txt", lines.encode()),)), expected())
    assert work.equations is not None and all(line.tree is not None for line in work.equations)


def test_numbers_each_in_a_line_of_its_own_are_read_to_the_last_row():
    names = [f"x{k}" for k in range(11)]
    found = split("\n\n".join("\n".join(f"{name} = {row}.5" for name in names) for row in range(61)), Room(600, 40))
    assert found is not None and len(found.rows) == 62


@pytest.mark.parametrize("place", [(0, 1), (4, 1), (9, 2)])
@pytest.mark.parametrize(
    "behind", ["", "x" * 90 + "\n", "behind the table\n" * 9000], ids=["", "a line", "more than a cell of csv"]
)
def test_a_quotation_mark_that_nothing_closes_costs_no_rows(place, behind):
    """All that followed it was one cell: 21 of 25 rows were missing from a table with such a mark in row 4."""
    rows = [["t", "phi1", "w1"], *([f"0.{k}", f"1.{k}", f"2.{k}"] for k in range(9))]
    marked = [
        [f'"{cell}' if (row, column) == place else cell for column, cell in enumerate(line)] for row, line in enumerate(rows)
    ]
    found = split("".join(",".join(line) + "\n" for line in marked) + behind, Room(600, 40))
    assert found is not None and [list(row) for row in found.rows[: len(rows)]] == rows


def test_lines_within_closed_quotation_marks_are_one_cell():
    found = split('t,phi1,"w1\nrad/s"\n0,1.5,2.5\n1,1.6,2.6\n2,1.7,"2.7\n(the end)"\n', Room(600, 40))
    assert found is not None and len(found.rows) == 4 and found.rows[3][2] == "2.7\n(the end)"


def test_a_head_with_the_very_name_counts_before_a_word_that_may_mean_it():
    """A column x beside the length s of the task is a place, and seconds may be printed as 60."""
    texts = (["t", "x", "s, m"], ["0", "5", "1"], ["1", "6", "2"], ["2", "7", "4"])
    layout = layouts_of([[printed(cell, ".") for cell in row] for row in texts], ".", [("s", "m")])[0]
    found = find_columns(layout, Grid(1.0, 3, (GridColumn("s", "m", (1.0, 2.0, 4.0)),)))
    assert found.places["s"].at == 2
    assert printed("149°59'60.0\"", ".").value == pytest.approx(150.0)


@pytest.mark.parametrize("row", [0, 3, 6])
@pytest.mark.parametrize("off", [0.0, 2.0, 90.0])
def test_a_row_with_a_misprinted_angle_and_velocity_shifts_no_other_row(row: int, off: float) -> None:
    """A 9 before both made one turn of it, and fifteen right cells below were taken for another axis."""
    angles = [1.4 + 0.01 * k for k in range(12)]
    moves = [0.01] * 11
    values = [*angles[:row], angles[row] + off, *angles[row + 1 :]]
    moves[row] = 1.81
    turns = whole_turns(GridColumn("phi1", "rad", tuple(angles)), values, moves)
    assert not any(turns[:row] + turns[row + 1 :])


@pytest.mark.parametrize("row", [2, 7])
def test_an_angle_within_a_turn_follows_its_velocities_over_a_misprinted_one(row: int) -> None:
    """The key does not tell the jumps of a table that has left it; a velocity ten turns too large tells none either."""
    whole = [0.9 * k for k in range(12)]
    values = [math.remainder(angle, 2 * math.pi) for angle in whole]
    moves = [0.9] * 11
    moves[row] = 63.0
    turns = whole_turns(GridColumn("phi1", "rad", tuple(0.01 * k for k in range(12))), values, moves)
    followed = [value - 2 * math.pi * number for value, number in zip(values, turns, strict=True)]
    assert followed == pytest.approx(whole)
