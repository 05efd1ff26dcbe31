"""Forms that are seldom written: what says something is read, and what says nothing stays as it is, for a person."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.equations.formulas.equations import names_for, read_line
from coursework.grading.reading.equations.systems.drawn import in_one_line
from coursework.grading.reading.equations.systems.matrices import in_rows
from coursework.grading.reading.equations.systems.of_r import in_brackets
from coursework.grading.reading.equations.systems.parts import parts_of, rows_of
from coursework.grading.reading.equations.text.line_kinds import own_name
from tests.grading.reading.equations.notation.test_notations import PLAIN, marked
from tests.grading.scenes import expected

if TYPE_CHECKING:
    from collections.abc import Callable

FIRST, SECOND = PLAIN.split("\n")[:2]


@pytest.mark.parametrize("half", [r"\frac {r_3} 2 w4", r"\frac{r_3}  {2}w4", r"\frac1 2 r_3 w4"])
def test_blanks_before_the_parts_of_a_fraction_are_no_parts(half: str) -> None:
    assert marked(SECOND.replace("0.5*r3*w4", half)).independent == 1


@pytest.mark.parametrize("name", ["V M y", "V  My", "VM y"])
def test_an_index_apart_from_its_name_is_its_index(name: str) -> None:
    assert marked(FIRST.replace("VMy", name)).independent == 1


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("We get $a = b + c$ and, as $r_1$ is known, $c = d$ too.", ["a = b + c", "c = d"]),
        ("We get $a = b$ with $r_1$ = c, $c = d$.", ["We get $a = b$ with $r_1$ = c", "$c = d$."]),
        ("as $r_1$ is, and $abc$ too.", ["as $r_1$ is, and $abc$ too."]),
    ],
)
def test_of_prose_between_formulas_the_equations_are_left(text: str, parts: list[str]) -> None:
    assert parts_of(text) == parts


@pytest.mark.parametrize(
    ("way", "text", "read"),
    [
        (in_brackets, "A <- matrix(c(a, b, c, d), 2, 2)", "A = [[a, c], [b, d]]"),
        (in_brackets, "A <- matrix(c(a, b, c, d), ncol=2, byrow=TRUE)", "A = [[a, b], [c, d]]"),
        (in_brackets, "A <- matrix(c(a, b, c, d, e, f), 2, byrow=T)", "A = [[a, b, c], [d, e, f]]"),
        (in_brackets, "A <- matrix(c(a, b, c, d, e, f), ncol=3)", "A = [[a, c, e], [b, d, f]]"),
        (in_brackets, "A <- rbind(c(a, b), c(d, e))", "A = [[a, b], [d, e]]"),
        (in_brackets, "A <- cbind(c(a, b), c(d, e))", "A = [[a, d], [b, e]]"),
        (in_brackets, "A <- rbind(c(a, b, c), c(d, e, f))", "A = [[a, b, c], [d, e, f]]"),
        (in_brackets, "A <- cbind(c(a, b, c), c(d, e, f))", "A = [[a, d], [b, e], [c, f]]"),
        (in_brackets, "A <- rbind(c(a, b), d)", "A = rbind(c(a, b), d)"),
        (in_brackets, "A <- matrix(c(a, b, c, d), 3)", "A = matrix(c(a, b, c, d), 3)"),
        (in_brackets, "A <- matrix(c(a, b, c, d), q, ncol=2)", "A = matrix(c(a, b, c, d), q, ncol=2)"),
        (in_one_line, "[ a   0 ] [x]   [ -e ]\n[ c  -d  5 ] [y] = [ 0 ]", None),
        (in_one_line, "v = c + a*w1 - d\n        ----\n         b", "v = c + (a*w1)/(b) - d\n\n"),
        (in_one_line, "v = c + a*w1\n    --------\n       b", "v = (c + a*w1)/(b)\n\n"),
        (in_one_line, "v = c + a*w1\n      -----\n       b", None),
        (in_rows, "w1 = Det[{{a, b}, {c, d}}]/e", "w1 = ((a)*(d) - (b)*(c))/e"),
        (in_rows, "w1 = Det({{a, b}, {c, d}})", "w1 = ((a)*(d) - (b)*(c))"),
        (in_rows, "w1 = det([a, b; c]) + 1", None), (in_rows, "w1 = det(a", None),
        (in_rows, "A = [a, b; c]; k = [e; f];\nw1, w2 = np.linalg.solve(A, k)", None),
        (in_rows, "A = [a, b; c, d]; k = [e; f; g];\nw1, w2 = np.linalg.solve(A, k)", None),
    ],
)  # fmt: skip
def test_a_matrix_is_read_if_its_rows_are_of_one_length(way: Callable[[str], str], text: str, read: str | None) -> None:
    assert way(text) == (text if read is None else read)


@pytest.mark.parametrize(("content", "rows"), [("[w1, w2]", [["w1", "w2"]]), ("[a, b], [c]", [["a", "b"], ["c"]])])
def test_a_row_in_brackets_of_its_own_is_a_row(content: str, rows: list[list[str]]) -> None:
    assert rows_of(content) == rows


@pytest.mark.parametrize("text", ["w3 = frac(VMy + 2", "w3 = frac(VMy) + 2", "w3 = [VMy, sin(1/phi3", "w3 = 2*sin(1/0)^"])
def test_half_a_form_is_not_read(text: str) -> None:
    assert read_line(text, "", 1, names_for(expected())).tree is None


def test_an_angle_that_divides_is_in_no_degrees() -> None:
    others = read_line("w3 = sin(phi3*pi/180)*cos(1/phi3)", "", 1, names_for(expected())).others
    assert "w3 = sin(phi3)*cos(1/phi3)" in [one.text for one in others]


@pytest.mark.parametrize(
    ("text", "value"), [("w1 = 3", 3.0), ("w1 = 60 rpm", 6.283185307179586), ("w1 = 3 g", 0.003), ("w1 = 3 foo", None)]
)
def test_an_answer_is_a_number_in_a_known_unit(text: str, value: float | None) -> None:
    answer = read_answer(text, ("w1",))
    assert answer is not None
    assert answer.value == (value if value is None else pytest.approx(value))


@pytest.mark.parametrize("rates", ["dydt[0] = w1\ndydt[1] = w2\ndydt[2] = w3", "dydt[0] = w1; dydt[1] = w2; dydt[2] = w3;"])
def test_rates_put_into_a_vector_name_the_entries_of_the_state(rates: str) -> None:
    text = FIRST.replace("phi3", "y[2]")
    assert marked(f"def f(t, y):\n    {text}\n{rates}").independent == 1


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("r3w3sinphi3 = r2", ""), ("r3w3 = 5*r2", ""), ("r2sinphi2 = r3", ""), ("r2r3 = 0.4", "r2r3"), ("k = 2*r3", "k"),
        ("w3 = 2", ""), ("K3 := r3*w3", "K3"),
    ],
)  # fmt: skip
def test_a_product_without_signs_is_no_name_of_a_student(text: str, name: str) -> None:
    assert own_name(text, names_for(expected()).spellings)[0] == name


def test_entries_of_a_vector_that_nothing_names_are_no_velocities() -> None:
    """Two of four may be any two of them: a person is asked."""
    found = marked(PLAIN.replace("w2", "x[0]").replace("w1", "x[1]"))
    assert (found.independent, len(found.wrong), found.unread is not None) == (2, 0, True)


def test_a_list_without_end_that_is_returned_takes_nothing_away() -> None:
    assert marked(f"{FIRST}\n{SECOND}\nreturn [w1, w2, w3").independent == 2


def test_a_term_with_a_number_is_no_drive_that_rests() -> None:
    assert marked("r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0.5*w1").independent == 0


@pytest.mark.parametrize("sign", ["//", "#", "%", "/*", "(*", "!"])
def test_a_term_in_a_comment_is_a_question(sign: str) -> None:
    """It may be meant or put away: with it, or without it, the equation is right."""
    before = FIRST.replace(" - r3*w3*sin(phi3) = 0", " = 0")
    for line, term in ((FIRST, "+ r1*w1"), (before, "- r3*w3*sin(phi3)")):
        assert marked(f"{line} {sign} {term}").unread is not None
    assert marked(f"{FIRST} // - upwards, r1 rests").independent == 1


@pytest.mark.parametrize("remark", ["(with a minus sign)", "minus the speed of C", "and a minus before"])
def test_a_spoken_sign_before_words_is_no_sign_of_a_remark(remark: str) -> None:
    """As "- sign" it was cut away in silence."""
    line = "VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3)"
    assert marked(f"{line} {remark}").unread is not None
    assert marked(line.replace("+", "plus")).independent == 1
