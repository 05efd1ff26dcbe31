"""Tables of what forces move, as students make them: marked row by row, a slip carried on, nonsense earns nothing."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics.misread import SLIPS
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.forces import with_forces as force_grid
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.reasons.reasons import reasons, summary
from coursework.grading.marking.rubric import Rubric, check_rubric, read_rubric
from coursework.grading.marking.table.by_rows import marked, points_of
from coursework.grading.marking.table.first_wrong import first_wrong
from coursework.grading.marking.table.ways import StudentTable
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.words.sentences import say
from tests.effects.moved import free_31
from tests.mechanisms.library import mechanism


@cache
def key(name="falling-arm", end=0.6):
    variant = coursework.parse_variant(free_31()) if name == "free 31" else coursework.load(name)
    return key_of(variant.timed(end=end))


def printed(rows, decimals=4):
    return StudentTable(np.round(rows, decimals), np.full(rows.shape, 10.0**-decimals))


def share(of, rows, decimals=4):
    cells = marked(of, printed(rows, decimals))
    return points_of(of, cells).share, cells


def marched(of, change=lambda row, state: state, start=None):
    """Rows from Euler's steps of the mechanism's own accelerations, `change` between rows."""
    state, rows = list(of.free.state), []
    now = of.table[0, state] if start is None else start
    f = len(state) // 2
    for row in range(len(of.table)):
        whole = of.free.rows_of(np.tile(now, (len(of.table), 1)))[row]
        rows.append(whole[: of.table.shape[1]])
        now = change(row, now + of.step * np.concatenate([now[f:], whole[of.table.shape[1] :]]))
    return np.array(rows)


@pytest.mark.parametrize("name", ["falling-arm", "example-2-motor", "free 31"])
def test_euler_s_rows_have_no_wrong_cell(name):
    of = key(name, 0.04 if name == "free 31" else 0.6)
    for decimals in (3, 4, 6):
        earned, cells = share(of, of.table, decimals)
        assert not cells.wrong.any(), (decimals, np.argwhere(cells.wrong)[:4])
        assert earned == pytest.approx(1.0) or cells.missing.any()


def test_a_slip_that_is_carried_on_costs_its_own_row():
    of = key()

    def slipped(row, state):
        return state + np.array([0.0, 0.0, 0.8, 0.0]) * (row == 20)

    earned, cells = share(of, marched(of, slipped))
    assert sorted(map(tuple, np.argwhere(cells.wrong))) == [(21, 2)]
    assert earned > 0.95
    told = first_wrong(of, cells)
    assert told.row == 22
    assert "Euler’s step from your own row 21" in str(told.sentence)


@pytest.mark.parametrize("slip", ["weight", "copied", "noise"])
def test_a_table_that_forces_did_not_make_earns_little(slip):
    of = key()
    if slip == "weight":
        weightless = coursework.parse_variant(mechanism("falling-arm", ('gravity = "9.81 m/s^2"', 'gravity = "4.9 m/s^2"')))
        rows = key_of(weightless.timed(end=0.6)).table
    elif slip == "copied":
        rows = np.tile(of.table[:1], (len(of.table), 1))
    else:
        rows = of.table + 0.2 * np.sin(np.arange(of.table.size)).reshape(of.table.shape)
    assert share(of, rows)[0] < 0.1


def handed_in(of, rows):
    lines = [",".join(["t", *of.names])]
    lines += [",".join([f"{t:.2f}", *(f"{value:.4f}" for value in row)]) for t, row in zip(of.t, rows, strict=True)]
    submission = Submission("a", "A. Student", (submitted_file("table.csv", "\n".join(lines).encode()),))
    return read_submission(submission, Expected(of.grid, of.variant))


def test_a_class_is_marked_without_a_person():
    of, marker = key(), Marker(key(), Rubric())
    right = marker.grade(handed_in(of, of.table))
    assert (right.status, right.total) == ("graded", 100.0)
    assert right.verdicts.integration == "right"
    flat = marker.grade(handed_in(of, np.tile(of.table[:1], (len(of.table), 1))))
    assert flat.total < 10
    assert flat.plain()["table"]["state"] == "marked"


@cache
def with_forces():
    """The key of 31 with masses, the rubric that asks for three columns, and the task's grid with them."""
    of = key_of(coursework.load("31-forces"))
    rubric = Rubric(weights={"table": 100.0, "equations": 0.0, "answers": 0.0}, forces=("FMx", "FMy", "R23"))
    check_rubric(rubric, of.variant)
    return of, Marker(of, rubric), Expected(force_grid(of.grid, of.forces, rubric.forces), of.variant)


def student(forces, heads=("FMx, N", "F_My (Н)", "R23, kN")):
    """The file of a student whose motion is right, with these columns of forces."""
    of, _, expected = with_forces()
    sizes = [1000.0 if "kN" in head else 1.0 for head in heads]
    lines = [";".join(["t", *of.names, *heads[: len(forces)]])]
    for row, t in enumerate(of.t):
        cells = [f"{value:.5f}" for value in of.table[row]]
        lines.append(
            ";".join([f"{t:.2f}", *cells, *(f"{one[row] / size:.4g}" for one, size in zip(forces, sizes, strict=False))])
        )
    return read_submission(Submission("a", "A", (submitted_file("t.csv", "\n".join(lines).encode()),)), expected)


def columns(pick):
    of, *_ = with_forces()
    return [pick(*of.forces.columns(name)) for name in ("FMx", "FMy", "R23")]


@pytest.mark.parametrize("which", ["exact", "table"])
def test_columns_of_forces_are_right_by_the_motion_or_by_the_table(which):
    _, marker, _ = with_forces()
    grade = marker.grade(student(columns(lambda exact, table, _: exact if which == "exact" else table)))
    found = grade.plain()["table"]["forces"]
    assert [(one["name"], one["right"], one["missing"]) for one in found] == [(name, 25, 0) for name in ("FMx", "FMy", "R23")]
    assert grade.total == 100.0


@pytest.mark.parametrize("code", SLIPS)
def test_a_class_in_which_each_has_one_slip_of_forces_is_told_it(code):
    _, marker, _ = with_forces()
    grade = marker.grade(student(columns(lambda exact, table, slips: slips[code])))
    found = grade.plain()["table"]["forces"]
    assert code in {one["slip"] for one in found}
    assert 70 < grade.total < 100
    why = " ".join(str(one.text) for one in reasons(grade))
    summed = re.search(r"\(100 · \(([\d.]+) \+ ([\d.]+)\) / (\d+)\)", why)
    assert summed and "No number is wrong" not in " ".join(map(str, summary(grade))), why
    motion, forces, cells = map(float, summed.groups())
    assert 100 * (motion + forces) / cells == pytest.approx(grade.total, abs=0.006)
    told = [str(one.text) for one in grade.notes if one.code == "force_column"]
    assert any(str(say(f"forces.slip.{code}")) in text for text in told)


def test_a_column_of_forces_that_is_not_there_earns_nothing():
    _, marker, _ = with_forces()
    grade = marker.grade(student(columns(lambda exact, *_: exact)[:1]))
    assert [one["missing"] for one in grade.plain()["table"]["forces"]] == [0, 25, 25]
    assert grade.total == pytest.approx(100 * (172 + 25) / (172 + 75), abs=0.01)


def test_a_rubric_asks_for_columns_of_forces_that_there_are():
    rubric = read_rubric('[table]\nforces = ["FMx", "R99"]\n')
    assert rubric.plain()["table"]["forces"] == ["FMx", "R99"]
    with pytest.raises(coursework.InputError, match="R99"):
        check_rubric(rubric, coursework.load("31-forces"))
    with pytest.raises(coursework.InputError, match="FMx"):
        check_rubric(rubric, coursework.load("31"))
    assert "forces" not in Rubric().plain()["table"]
