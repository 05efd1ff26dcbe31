"""Forces as answers of a rubric: right on the exact rows or on the assigned table, a wrong one with the slip that gives it."""

import pytest

import coursework
from coursework.effects.kinetostatics.misread import SLIPS, slipped
from coursework.grading.marking.answers import mark_answers
from coursework.grading.marking.key.key import key_of
from coursework.grading.marking.rubric import Answer, Rubric, check_rubric
from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.student_work import AnswerLine
from coursework.words.sentences import say
from tests.effects.massed import of


@pytest.fixture(scope="module")
def key():
    return key_of(coursework.load("31-forces"))


def line(value):
    return AnswerLine("F", value, "read")


def mark(key, of_what, value, row=4, tolerance=0.02):
    return mark_answers(key, [Answer("F", of_what, row, tolerance)], [line(value)]).marks[0]


def test_a_force_of_the_exact_row_or_of_the_table_is_right(key):
    exact, table = of("31-forces"), of("31-forces", "euler")
    assert abs(exact.column("FMy")[3] - table.column("FMy")[3]) > 1
    for found in (exact, table):
        assert mark(key, "FMy", float(found.column("FMy")[3])).verdict == "right"
    size = float((exact.column("R23x")[3] ** 2 + exact.column("R23y")[3] ** 2) ** 0.5)
    assert mark(key, "R23", size).verdict == "right"
    assert mark(key, "R23", 1.5 * size).verdict == "wrong"


@pytest.mark.parametrize("code", SLIPS)
def test_a_slip_is_named_by_the_force_that_it_gives(key, code):
    exact = of("31-forces")
    names, wrong = exact.reactions.names, slipped(exact)
    # The reaction on which this slip shows most, and no other slip gives nearly the same.
    rows, right = wrong[code][3], exact.reactions.rows[3]
    place = max(range(len(names)), key=lambda k: min(abs(rows[k] - other[3][k]) for c, other in wrong.items() if c != code))
    assert abs(rows[place] - right[place]) > 1
    found = mark(key, names[place], float(rows[place]), tolerance=1e-3)
    assert (found.verdict, found.slip) == ("wrong", code)
    assert found.plain()["slip"] == code


def test_an_answer_that_no_slip_gives_has_none(key):
    found = mark(key, "FMx", 12345.0)
    assert (found.verdict, found.slip) == ("wrong", "")
    assert "slip" not in found.plain()


def test_a_rubric_may_ask_for_forces_of_a_variant_that_has_them():
    rubric = Rubric(answers=(Answer("F", "R23", 4, 0.02),))
    check_rubric(rubric, coursework.load("31-forces"))
    with pytest.raises(coursework.InputError, match="R23"):
        check_rubric(rubric, coursework.load("31"))


@pytest.mark.parametrize(
    ("text", "value"), [("M = 46.3 N*m", 46.3), ("M = 0.0463 kN·m", 46.3), ("M = 46,3 Н·м", 46.3), ("M = 46.3", 46.3)]
)
def test_answers_with_units_of_forces_are_read(text, value):
    assert read_answer(text, ["M"]).value == pytest.approx(value)


@pytest.mark.parametrize("code", SLIPS)
def test_each_slip_is_said_on_the_page(code):
    assert str(say(f"forces.slip.{code}")).startswith("too far off: it is the result")
