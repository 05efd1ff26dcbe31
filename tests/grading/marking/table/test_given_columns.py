"""A velocity that the task gives for all rows needs no column: the report prints none either."""

from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.cells import mark_cells
from coursework.grading.marking.table.ways import StudentTable
from coursework.grading.precheck import precheck
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file


@cache
def marker():
    return Marker(key_of(coursework.load("example-1")), Rubric())


def handed_in(rows, without=(), heads=True):
    key = marker().key
    kept = [place for place, name in enumerate(key.names) if name not in without]
    lines = [";".join(["t", *(key.names[place] for place in kept)])] if heads else []
    lines += [";".join([f"{t:.4f}", *(f"{row[place]:.4f}" for place in kept)]) for t, row in zip(key.t, rows, strict=True)]
    return Submission("a", None, (submitted_file("table.csv", "\n".join(lines).encode()),))


def marked(rows, **how):
    grade = marker().grade(read_submission(handed_in(rows, **how), Expected(marker().key.grid, marker().key.variant)))
    return grade.part("table")[0], grade.table


def other(change):
    rows = marker().key.table.copy()
    change(rows)
    return rows


def slip(rows):
    rows[8, 0] += 0.01


def clockwise(rows):
    rows[:, 3:] *= -1


def wrong_velocity(rows):
    rows[8, 4] += 0.1


@pytest.mark.long
@pytest.mark.parametrize("heads", [True, False])
@pytest.mark.parametrize("change", [lambda rows: None, slip, clockwise, wrong_velocity])
def test_a_table_without_the_given_column_earns_what_one_with_it_does(change, heads):
    rows = other(change)
    (whole, with_it), (found, without_it) = marked(rows, heads=heads), marked(rows, without={"w1"}, heads=heads)
    assert found == whole > 59
    assert (with_it.cells.wrong == without_it.cells.wrong).all()


def test_a_wrong_column_of_it_counts_and_a_column_that_nobody_gave_is_missing():
    rows = other(lambda rows: rows[:, 3].fill(11.0))
    assert marked(rows)[0] < marked(rows, without={"w1"})[0] == 60
    points, table = marked(marker().key.table, without={"w2"})
    assert table.cells.missing[:, 4].all()
    assert points < 60


def test_precheck_asks_for_no_column_that_the_report_leaves_out():
    def told(*without):
        found = precheck(handed_in(marker().key.table, without), marker().key.variant, lambda text, names: text)
        return [str(one) for one in found.sentences if one.key == "screen.missing_columns"]

    assert told("w1") == []
    (missing,) = told("w1", "w2")
    assert missing.endswith("w2.")
    assert "w1" not in missing


def test_a_cell_more_in_a_given_column_takes_nothing():
    """Left out whole the column costs nothing; with one cell in it the others were missing."""
    key = marker().key
    place = key.names.index("w1")
    lines = [";".join(["t", *key.names])]
    for number, (t, row) in enumerate(zip(key.t, key.table, strict=True)):
        cells = [f"{value:.4f}" if number == 7 or at != place else "" for at, value in enumerate(row)]
        lines.append(";".join([f"{t:.4f}", *cells]))
    files = (submitted_file("table.csv", "\n".join(lines).encode()),)
    grade = marker().grade(read_submission(Submission("a", None, files), Expected(key.grid, key.variant)))
    assert grade.part("table")[0] == 60


def test_a_given_velocity_that_is_a_whole_number_hides_nothing():
    """Of 10 in each row, zeros dropped, no digit is lost: they were missing where no other column told how many there were."""
    key = marker().key
    units = np.where([name in key.given for name in key.names], 1.0, np.full(key.table.shape, 1e-4))
    whole = key.table.copy()
    whole[3, key.names.index("w1")] += 0.4
    cells = mark_cells(key, StudentTable(whole, units))
    assert np.argwhere(cells.missing).tolist() == [[3, key.names.index("w1")]]
