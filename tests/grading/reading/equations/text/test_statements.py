"""What a statement of a program or a calculator says: the equation that it declares, finds, stores or returns; the task is 31."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.names_in_text import spellings_of
from coursework.grading.reading.equations.text.statements import as_value, closed, function_begun, with_sign, without_declarations
from tests.grading.scenes import expected

TASK = expected()
SPELLINGS = spellings_of(TASK.variant, TASK.grid.units)
SOUGHT = TASK.variant.sought  # w1 … w4


@pytest.mark.parametrize(("line", "begun"), [
    ("def calc_w3(t, y):", ("w3", "")), ("def w3(t): return r1*w1", ("w3", "return r1*w1")), ("function w3(t)", ("w3", "")),
    ("double w3(double t) { return r1*w1; }", ("w3", "return r1*w1; ")), ("def f_w3_w4(t):", ("f_w3_w4", "")),
    ("def speed(t):", ("speed", "")), ("w3 = 2", None),
])  # fmt: skip
def test_the_function_that_begins_in_a_line(line: str, begun: tuple[str, str] | None) -> None:
    assert function_begun(line, SOUGHT) == begun


@pytest.mark.parametrize(("line", "equation"), [
    ("double w3 = r1*w1", "w3 = r1*w1"), ("const w3 = 2", "w3 = 2"), ("w3: float = r1*w1", "w3 = r1*w1"),
    ("w3 : real = 2", "w3 = 2"),
    ("{{w3 -> a*b, w4 -> c*d}}", "{w3 =  a*b, w4 =  c*d}"), ("r1*w1→w3", "w3 = r1*w1"), ("w1 -> w3", "w1 -> w3"), ("}", ""),
    ("w3 = (t, y) => r1*w1", "w3 = r1*w1"), ("w3 <- function(t) r1*w1", "w3 = r1*w1"),
    ("w3 = (t) => { return r1*w1; }", "w3 = r1*w1;"),
    # under a name of its own; an index of a velocity is none
    ("eq[1] := w3 = r1*w1", "w3 = r1*w1"), ("F(1) = w3 == r1*w1", "w3 == r1*w1"), ("w[3] := r1*w1 = 2", "w[3] := r1*w1 = 2"),
    ("a, b = r1*w1, r2*w2", "a = r1*w1; b = r2*w2"), ("a, b = y", "a, b = y"), ("a, b = r1*w1, r2, r3", "a, b = r1*w1, r2, r3"),
    ("a, b = 1, 2 = c", "a, b = 1, 2 = c"), ("a, b = c, d", "a, b = c, d"),
])  # fmt: skip
def test_the_equation_that_a_line_declares_finds_stores_or_keeps(line: str, equation: str) -> None:
    assert without_declarations(line, SPELLINGS) == equation


@pytest.mark.parametrize(("line", "function", "value"), [
    ("return r1*sin(phi1)", "w3", "w3 = r1*sin(phi1)"), ("return r1*w1", "w3", "w3 = r1*w1"), ("return r1*w1", "speed", "r1*w1"),
    ("return r1*sin(phi1)", "speed", "speed = r1*sin(phi1)"), ("return r1*sin(phi1)", "", "r1*sin(phi1)"),
    ("return [r1*sin(phi1)]", "w3", "[r1*sin(phi1)]"), ("r1*w1", "w3", "r1*w1"), ("return w3 = r1*w1", "w3", "return w3 = r1*w1"),
])  # fmt: skip
def test_what_a_function_returns_is_its_value(line: str, function: str, value: str) -> None:
    assert as_value(line, function, SOUGHT) == value


@pytest.mark.parametrize(("line", "signed"), [
    ("w3 : r1*w1", "w3 = r1*w1"), ("w.3: r1*w1", "w.3 = r1*w1"), ("w3 : 2", "w3 : 2"), ("k : r1*w1", "k : r1*w1"),
    ("w3 | =r1*w1", "w3 =r1*w1"),
    ("w3 [1/s] | = r1*w1", "w3 = r1*w1"), ("return {w2, w3: r1*w1}", "w3 = r1*w1"), ("x = {w3: r1*w1};", "w3 = r1*w1"),
    ("w3: r1*w1 = 0", "w3: r1*w1 = 0"),
])  # fmt: skip
def test_a_colon_behind_a_velocity_is_a_sign_of_equality(line: str, signed: str) -> None:
    assert with_sign(line, SOUGHT, SPELLINGS) == signed


@pytest.mark.parametrize(("line", "bare"), [
    ("[a = b]", "a = b"), ("[a = b; c = d]", "[a = b; c = d]"), ("[a][b]", "[a][b]"), ("(a = b", "(a = b"), ("a = b)", "a = b)"),
    ("c == d] = 3", "c == d] = 3"), ("x = [a]", "x = [a]"), ("eqs = [a = b", "a = b"),
])  # fmt: skip
def test_the_bracket_of_a_list_over_several_lines_is_cut_away(line: str, bare: str) -> None:
    assert closed(line) == bare
