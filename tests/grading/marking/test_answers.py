"""Measured answers against the numbers of the coursework's graph-analytical check (row 4 of variant 31)."""

import math
from types import SimpleNamespace

import pytest

import coursework
from coursework.grading.marking.answers import mark_answers
from coursework.grading.marking.grade import Marker
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import Answer, Rubric
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import AnswerLine
from coursework.grading.reading.submission import Submission, SubmittedFile

# The exact motion in row 4, from the reference plans of velocities.
W = {"w1": 0.17465532, "w2": 0.086914667, "w3": 4.4111308, "w4": -8.1550535}
SPEED_OF_M = 4.1044636


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31"))


def answer(name, value, state="read"):
    return AnswerLine(name, value, state)


@pytest.mark.parametrize(
    ("off", "verdict", "share"), [(0.049, "right", 1.0), (0.051, "half", 0.5), (0.099, "half", 0.5), (0.101, "wrong", 0.0)]
)
def test_the_tolerance_is_a_part_of_the_largest_velocity_of_the_row(key, off, verdict, share):
    found = W["w3"] + off * abs(W["w4"])
    marks = mark_answers(key, [Answer("w", "w3", 4)], [answer("w", found)])
    assert marks.marks[0].verdict == verdict
    assert marks.share == share
    assert marks.marks[0].expected == pytest.approx(W["w3"], abs=1e-6)


def test_a_size_without_a_sign_is_right_and_a_wrong_sign_is_not(key):
    asked = [Answer("w", "w4", 4)]
    assert mark_answers(key, asked, [answer("w", 8.15)]).share == 1.0
    asked = [Answer("w", "w3", 4)]
    assert mark_answers(key, asked, [answer("w", -4.41)]).share == 0.0


def test_blank_and_unreadable_are_told_apart(key):
    asked = [Answer("a", "w1", 4), Answer("b", "w2", 4), Answer("c", "w3", 4)]
    lines = [answer("a", None, "blank"), answer("b", None, "unreadable")]
    assert [mark.verdict for mark in mark_answers(key, asked, lines).marks] == ["blank", "unreadable", "blank"]


def test_the_speed_of_a_point(key):
    marks = mark_answers(key, [Answer("vM", "v_M", 4)], [answer("vM", 4.1)])
    assert marks.marks[0].expected == pytest.approx(SPEED_OF_M, abs=1e-6)


def test_an_answer_about_a_row_that_the_motion_does_not_reach_is_not_asked():
    """With alpha = 0.02 variant 31 stops at 0.11688925 s: at steps of 0.02 s rows 1 to 6 are there."""
    stopped = key_of(coursework.load("31").with_data({"alpha": 0.02}))
    last = int(0.11688925 / stopped.step) + 1
    asked = [Answer("a", "w1", last), Answer("b", "w1", last + 1)]
    lines = [answer("a", float(stopped.exact[-1, stopped.names.index("w1")])), answer("b", 1.0)]
    found = mark_answers(stopped, asked, lines)
    assert ([mark.name for mark in found.marks], found.share) == (["a"], 1.0)
    assert mark_answers(stopped, asked[1:], lines).share == 1.0


@pytest.mark.parametrize(("row", "text", "part", "state"), [
    (7, "w4 = 2*w3*(cos(phi3) - 2*sin(phi3))", 10.0, "graded-with-notes"),
    (6, "w4 = 2*w3*(cos(phi3) - 2*sin(phi3))", None, "needs-review"), (7, "", None, "missing"),
])  # fmt: skip
def test_nothing_is_missing_where_nothing_can_be_asked(row, text, part, state):
    """Of a motion of six rows the seventh cannot be; who hands in nothing at all has no points for that."""
    stopped = key_of(coursework.load("31").with_data({"alpha": 0.02}))
    weights = {"table": 0.0, "equations": 90.0, "answers": 10.0} if text else Rubric().weights | {"answers": 10.0}
    marker = Marker(stopped, Rubric(weights=weights, answers=(Answer("a", "w1", row),)))
    files = (SubmittedFile("e.txt", text.encode(), len(text)),) if text else ()
    grade = marker.grade(read_submission(Submission("ada", None, files), Expected(stopped.grid, stopped.variant, ("a",))))
    assert (grade.part("answers")[0], grade.status) == (part, state)


def test_a_force_without_a_value_in_its_row_is_not_asked():
    """Of a reaction that is not unique nothing can be told, whatever is handed in."""
    nothing = SimpleNamespace(
        names=("R01",),
        right=lambda of, row: (math.nan, math.nan, math.nan),
        columns=lambda of: ((), (), {"slip": [math.nan] * 9}),
    )
    blind = SimpleNamespace(
        exact=[0] * 9, forces=nothing, names=(), variant=SimpleNamespace(time=SimpleNamespace(row_of_check=4))
    )
    found = mark_answers(blind, [Answer("r", "R01", 4)], [answer("r", 5.0)])
    assert (found.marks, found.share) == ((), 1.0)


def test_of_two_lines_the_last_counts_and_half_is_half(key):
    asked = [Answer("a", "w3", 4), Answer("b", "w3", 4), Answer("c", "w3", 4)]
    lines = [answer("a", 99.0), answer("a", W["w3"]), answer("b", W["w3"] + 0.08 * abs(W["w4"]))]
    marks = mark_answers(key, asked, lines)
    assert ([mark.verdict for mark in marks.marks], marks.share) == (["right", "half", "blank"], 0.5)
    assert [mark.tolerance for mark in marks.marks] == pytest.approx([0.05 * abs(W["w4"])] * 3, rel=1e-6)
