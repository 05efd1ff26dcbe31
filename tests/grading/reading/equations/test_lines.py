"""The equations of a text: how many lines are tried, which are values of some row, what one's own names stand for."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from coursework.grading.reading.equations.formulas.equations import most_lines
from coursework.grading.reading.equations.lines import read_lines
from coursework.variant.formula.tree import evaluate_any
from tests.grading.reading.equations.notation.test_notations import marked
from tests.grading.scenes import expected

MOST = most_lines(expected())
EQUATION, EQUATION_18 = "w3 = 2*r1*w1", "r1*w1*cos(phi1) - r3*w3*sin(phi3) + r2*w2*cos(phi2)"
KNOWN = {
    "r1": 0.3,
    "r2": 0.7,
    "r3": 1.1,
    "w1": 1.3,
    "w2": -0.4,
    "w3": 0.6,
    "w4": 2.1,
    "phi1": 0.2,
    "phi2": 1.9,
    "phi3": -0.8,
    "VMy": 3.0,
}
BESIDE: Any = SimpleNamespace(separator="tab")  # a table in the same text


def texts(text: str, beside: Any = None) -> list[str]:
    return [line.text for line in read_lines(text, "own.txt", expected(), beside).equations]


@pytest.mark.parametrize(("before", "read"), [(10 * MOST - 1, [EQUATION]), (10 * MOST, [])])
def test_ten_lines_are_tried_for_each_equation_that_may_be_handed_in(before: int, read: list[str]) -> None:
    found = read_lines("r1 = 2\n" * before + f"{EQUATION}\n(nothing)", "own.txt", expected())
    assert ([line.text for line in found.equations], found.unread) == (read, 1 - len(read))


@pytest.mark.parametrize(("many", "unread"), [(MOST + 1, 0), (MOST + 2, 1)])
def test_one_equation_more_than_may_be_handed_in_is_read(many: int, unread: int) -> None:
    found = read_lines(f"{EQUATION}\n" * many, "own.txt", expected())
    assert (len(found.equations), found.unread) == (MOST + 1, unread)


@pytest.mark.parametrize(
    ("line", "of_one_row"),
    [
        ("w3 = 6.12", True), ("w3 = 6", False), ("w3 = 6.12*w1", True), ("w3 = 6.12*r1*w1", False), ("w3 = 0", False),
        ("w4 = w3", False),
        ("r1*w1 = 1.08", True), ("r1*w1 - r3*w3 = 0", False), ("r1*w1 = 1.08*w2", False),
        ("w3 = 2.03 rad/s", True),
    ],
)  # fmt: skip
def test_a_line_of_velocities_and_numbers_alone_may_be_a_value_of_some_row(line: str, of_one_row: bool) -> None:
    first, second = read_lines(f"{EQUATION}\n{line}", "own.txt", expected()).equations
    assert (first.may_be_datum, second.may_be_datum) == (False, of_one_row)
    (alone,) = read_lines(line, "own.txt", expected()).equations  # it is all that there is
    assert not alone.may_be_datum


@pytest.mark.parametrize(
    ("line", "of_one_row"),
    [("V = 0", True), ("so it rests, V = 0", True), ("V = 0*w3", False), ("u = 0", False), ("r1*w1 = 0", False)],
)
def test_the_speed_of_a_point_is_zero_for_a_reason(line: str, of_one_row: bool) -> None:
    found = read_lines(f"{EQUATION}\n{line}", "own.txt", expected("v102")).equations
    assert [one.may_be_datum for one in found] == [False, of_one_row]


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("w3 = 2*r1\nw4 = )r1", ["w3 = 2*r1", "w4 = )r1"]), ("w4 = )r1", []), ("h = 0.02 s\nw1 = 13.08\nw1 = 2*t", []),
        ("w3 = 2*r1\t5", []), ('"w3 = 2*r1";', ["w3 = 2*r1"]), ("1 = 2", []), ("0.1\t2.5\t3.5", []),
    ],
)  # fmt: skip
def test_beside_a_table_an_equation_gives_a_velocity_by_something_else(text: str, read: list[str]) -> None:
    assert texts(text, BESIDE) == read


A, B, C = "2*w3*cos(phi3)", "r1*w1*sin(phi1)", "r2*w2*sin(phi2)"


@pytest.mark.parametrize(
    ("line", "read"),
    [
        (f"w4 = {A} = {B}", [f"w4 = {A}", f"w4 = {B}"]), (f"w4 = {A} = {B} = {C}", [f"w4 = {A}", f"w4 = {B}", f"w4 = {C}"]),
        (f"w4 = {A} = {B} = {C} = 2", [f"w4 = {A} = {B} = {C} = 2"]),
        (f"w4 = {A} = 4*w3*cos(phi3)", [f"w4 = {A} = 4*w3*cos(phi3)"]),
        (f"w4 = {A} = r1*w1", [f"w4 = {A} = r1*w1"]), (f"k = {A} = {B}", [f"k = {A} = {B}"]),
        (f"w4 = {A} + {B} = {B}", [f"w4 = {A} + {B} = {B}"]),
        (f"{A} = {B} = w4.", [f"{A} = w4.", f"{B} = w4."]), (f"{A} = {B} = k", [f"{A} = {B} = k"]),
        # as the law of sines has it: each side of another velocity
        (f"{A} = {B} = {C}", [f"{A} = {B}", f"{B} = {C}"]), (f"{A} = {B} = 4*w3*cos(phi3)", [f"{A} = {B} = 4*w3*cos(phi3)"]),
        (f"2*cos(phi3) = {B} = {C}", [f"2*cos(phi3) = {B} = {C}"]),
    ],
)  # fmt: skip
def test_a_velocity_by_different_others_is_several_equations(line: str, read: list[str]) -> None:
    assert [" ".join(text.split()) for text in texts(line)] == read


@pytest.mark.parametrize(
    ("text", "by_hand"),
    [
        ("k = m*r1\nm = 2*w2\nw3 = k*VMy", 0.6 - 2 * -0.4 * 0.3 * 3),
        ("w3 = k*VMy\nk = m*r1\nm = n*2\nn = r2*w2", 0.6 - 0.7 * -0.4 * 2 * 0.3 * 3),
        # what a program calls anew in its next system; the first formula of a velocity defines it, another is an equation
        ("k = r1*w1\nw3 = k*w4\nk = r2*w2\nw2 = k*w4", (0.6 - 0.3 * 1.3 * 2.1, -0.4 - 0.7 * -0.4 * 2.1)),
        ("VBx = r1*w1\nVBx = r2*w2\nw3 = VBx*w4", (0.3 * 1.3 - 0.7 * -0.4, 0.6 - 0.3 * 1.3 * 2.1)),
        ("k = r1*w1\nk = r1*w1\nw3 = k*w4", 0.6 - 0.3 * 1.3 * 2.1), ("(1) r1*w1 = k\nw3 = k*w4", 0.6 - 0.3 * 1.3 * 2.1),
        ("r1*w1 = k\nr2*w2 = k\nw3 = k*w4", (0.3 * 1.3 - 0.7 * -0.4, 0.6 - 0.3 * 1.3 * 2.1)),
        ("k = c*w1\nw3 = k*w4\nk = r2*w2\nw2 = k*w4\nk = r2*w1\nw4 = k*w3\nc = 2*r1",
         (0.6 - 0.6 * 1.3 * 2.1, -0.4 - 0.7 * -0.4 * 2.1, 2.1 - 0.7 * 1.3 * 0.6)),  # what the first of three uses stands last
        ("VD = k*w1 - w3 = 0\nVD = k*w2 - w4 = 0\nk = 2*r1", (0.6 * 1.3 - 0.6, 0.6 * -0.4 - 2.1)),  # a label of two sums
    ],
)  # fmt: skip
def test_names_of_ones_own_stand_for_their_formulas(text: str, by_hand: float | tuple[float, ...]) -> None:
    read = [abs(evaluate_any(line.difference, KNOWN)) for line in read_lines(text, "own.txt", expected()).equations]
    assert read == pytest.approx([*map(abs, by_hand if isinstance(by_hand, tuple) else (by_hand,))])


def test_a_sum_of_velocities_of_points_counts_if_its_parts_are_defined_and_it_is_right() -> None:
    parts = "v_M = VMx\nv_CM = (a + c)*w3*sin(phi3)\n"
    for text, found in ((f"{parts}v_C = v_M + v_CM", [("v_C = v_M + v_CM", True)]), ("v_C = v_M + v_CM", [])):
        assert [(one.text, one.may_be_datum) for one in read_lines(text, "", expected("v110")).equations] == found


@pytest.mark.parametrize(("text", "verdicts"), [
    # two formulas for one name of the student, of which one has a velocity, are an equation
    ("n = w2/w1; n = 1 - R0/R", ["right"]), ("n = w2/w1\nn = 1 + R0/R", ["wrong"]), ("n = 1 - R0/R\nn = w2/w1", ["right"]),
    ("n = w2/w1\nn = 1 - R0/R\nu = -(R0 - R)*w1*sin(phi1) - R*n*w1*sin(psi2)", ["right", "right"]),
    ("S = (R0 - R)*w1\nS = -R*w2", ["right"]), ("S = (R0 - R)*w1\nS = R*w2", ["wrong"]), ("n = w2/w1\nn = w2/w1", []),
    ("n = w2/w1\nn = (R - R0)/R = 1 - R0/R", ["right"]), ("n = w2/w1\nn = (R + R0)/R = 1 + R0/R", ["wrong"]),
    # however long the name is
    ("gear_ratio = w2/w1\ngear_ratio = 1 - R0/R", ["right"]), ("gear_ratio = w2/w1\ngear_ratio = 1 + R0/R", ["wrong"]),
    ("speed_A = (R0 - R)*w1\nspeed_A = -R*w2", ["right"]), ("speed_A = (R0 - R)*w1\nspeed_A = R*w2", ["wrong"]),
    # without one, nobody can tell which of them is meant, nor what a name is to which something is added
    ("k = R0 - R\nk = R0 + R\nk*w1 + R*w2 = 0", ["unreadable"] * 3), ("k = R0 - R\nk = -R + R0\nk*w1 + R*w2 = 0", ["right"]),
    ("k = (R0 - R)*w1\nk = k + R0*w1\nk + R*w2 = 0", ["unreadable"] * 3),
    ("k = (R0 - R)*w1\nk += R0*w1\nk + R*w2 = 0", ["unreadable"] * 3),
])  # fmt: skip
def test_a_name_with_two_formulas_relates_them_or_is_a_question(text: str, verdicts: list[str]) -> None:
    assert [mark.verdict for mark in marked(text, "cardan").marks] == verdicts


@pytest.mark.parametrize("text", [
    "we divide by r1*w1", "Делим на r3*w3", "substitute r1*w1", "the speed of C is 2*r3*w3*cos(phi3) + r3*w3*sin(phi3)",
])  # fmt: skip
def test_a_term_that_a_sentence_names_is_no_equation(text: str) -> None:
    right, slip = f"so {EQUATION_18}", f"so {EQUATION_18.replace('-', '+')}"
    assert [len(marked(f"{text}\n{line}").wrong) for line in (right, slip)] == [0, 1]


@pytest.mark.parametrize("text", [
    "V_P = R*w2 + R0*w1 - R*w1\nV_P = V_A + V_PA", "V_A = (R0 - R)*w1\nV_PA = R*w2\nV_P = V_A + V_PA\nV_P = 0",
    "V_P = V_A + R*w2\nV_A = (R0 - R)*w1", "V_P = R*w2 + (R0 - R)*w1\nV_A = V_P - R*w2",
])  # fmt: skip
def test_the_velocity_of_a_point_at_rest_is_an_equation_though_another_line_names_it(text: str) -> None:
    assert [marked(one, "cardan").independent for one in (text, text.replace("R*w2", "2*R*w2"))] == [1, 0]
