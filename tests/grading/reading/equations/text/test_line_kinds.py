"""What kind of line one is: a definition, a datum, a step, a heading, a list; the task is variant 31 of the lectures."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.text import line_kinds as kinds
from coursework.grading.reading.equations.text import list_marks as marks
from coursework.grading.reading.equations.text.own_names import _meet
from coursework.variant.formula.reader import parse
from tests.grading.scenes import expected

LONG = 4000  # characters of an equation that are read


@pytest.fixture(scope="module")
def names():
    return names_for(expected())


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("k = cos(phi3)", "k"), ("let K_1 := r3*w3", "K_1"), ("VCy = r3*w3*cos(phi3) = 0", "VCy"), ("k = 0", "k"), ("k = ", ""),
        ("k = m = 2", ""), ("w3 = 2*w1", ""), ("r1 = 2", ""), ("2*k = r3", ""), ("k = 2*)", ""),
    ],
)  # fmt: skip
def test_a_definition_gives_a_name_of_ones_own_a_formula(line: str, name: str, names) -> None:
    found = kinds.definition(line, names)
    assert (found[0] if found else "") == name.replace("_", "")


@pytest.mark.parametrize(
    ("line", "name"),
    [
        # a capital of a datum is a name of one's own; of a coordinate only with an angle and without a rate in its formula
        ("R1 = 2*r2", "R1"), ("PHI1 = r1*w1", "PHI1"), ("Phi1 = sin(phi2)", "Phi1"), ("Phi1 = sin(phi2)*w1", ""),
        ("Phi1 = 2*phi2", "Phi1"),
        ("Phi1 = 2*r3", "Phi1"), ("Phi1 = r3*t", ""), ("Phi1 = 5", ""),
        # the derivative of a coordinate is none, the sine of one is
        ("dphi2 = r1*w1", ""), ("dphi2 = phi2 - phi1", "dphi2"), ("dphi2 = 5", ""), ("phi2p = r1*w1/r2", ""),
    ],
)  # fmt: skip
def test_a_name_of_ones_own(line: str, name: str, names) -> None:
    assert kinds.own_name(line, names.spellings)[0] == name


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("V = V1*sin(p*t)", "V"), ("V = V1*sin(p*t)*w1", ""), ("V = V1*sin(p)", ""), ("u = V1*sin(p*t)", ""),
        ("V = r1*t*pi", "V"),
        ("V = V1*sin(phi1*t)", ""),
    ],
)  # fmt: skip
def test_what_is_short_for_the_only_speed_of_a_task_may_be_a_law_of_time(line: str, name: str) -> None:
    assert kinds.own_name(line, names_for(expected("v102")).spellings)[0] == name


def test_the_step_may_be_called_as_a_length_of_the_task() -> None:
    task = names_for(expected("example-5"))  # in which h is one
    assert kinds.is_step("s2 = s2 + h*u2", task) and not kinds.is_step("s2 = s2 + r1*u2", task)


def test_a_line_of_more_signs_than_an_equation_has_is_of_no_kind(names) -> None:
    line = "k = r1" + " + r1" * ((LONG - 6) // 5 + 1)
    for length, read in ((LONG, "k"), (LONG + 1, "")):
        assert kinds.own_name(line[:length].ljust(length), names.spellings)[0] == read
    line = "r1*w1*sin(phi1) + r2*w2".ljust(LONG)
    assert kinds.is_equation_without_sign(line, names) and not kinds.is_equation_without_sign(f"{line} ", names)
    line = "v_B = v_A + v_BA".ljust(LONG)
    assert kinds.says_nothing(line, names) and not kinds.says_nothing(f"{line} ", names)


@pytest.mark.parametrize(
    ("line", "holds"),
    [("r1*cos(phi1) = r2", True), ("r1*w1 = 2", False), ("V1 = 4", False), ("k = 2", False), ("alpha = 2", True)],
)
def test_what_names_lengths_and_angles_alone_has_no_velocity(line: str, holds: bool, names) -> None:
    assert kinds.no_velocity(line, names) is holds


@pytest.mark.parametrize(
    ("line", "holds", "continues"),
    [
        ("r1*w1*sin(phi1) + r2*w2", True, True), ("r1*w1 = r2*w2", False, False), ("r1", False, True), ("w3", False, True),
        ("2 + 3", False, False), ("k + m", False, False), ("dividing by r1*w1:", False, True), ("r1*w1:", True, True),
        # not readable, but of names of the task except for one word, and of more words than prose
        ("r1*w1*foo(phi1) + r2*w2*)", True, True), ("r1*w1*foo(bar) + r2*w2*)", False, False), ("r1*w1*r2*)", False, False),
        ("r1*w1*r2*w2*)", False, False), ("r1*w1*r2*w2*r3*)", True, True), ("r1*phi1*r2*phi2*r3*)", False, False),
        ("M", False, False),
    ],
)  # fmt: skip
def test_a_sum_without_a_sign_of_equality_is_one_that_can_be_read_or_is_mostly_names(line, holds, continues, names) -> None:
    assert (kinds.is_equation_without_sign(line, names), kinds.is_part_of_equation(line, names)) == (holds, continues)


def test_the_end_of_a_sum_is_short(names) -> None:
    assert kinds.is_part_of_equation("w3".ljust(80), names) and not kinds.is_part_of_equation("w3".ljust(81), names)


@pytest.mark.parametrize(
    ("lines", "bare"),
    [
        (["- a = b", "- c = d"], ["a = b", "c = d"]), (["- a = b"], ["a = b"]), (["a = b", "c = d"], None),
        (["– a - b = 0", "a = c"], ["a - b = 0", "a = c"]), (["1,a = b", "2,c = d"], ["a = b", "c = d"]),
        (["1,a = b"], None), (["2,a = b", "1,c = d"], None), (["1,5 = b", "2,5 = d"], None), (["1,a = b", "c = d"], None),
        (["1.1 a = b", "1.2 c = d"], ["a = b", "c = d"]), (["1.1 a = b", "1.3 c = d"], None), (["1.1 a = b", "2.2 c = d"], None),
        (["L1 a = b", "L2 c = d"], ["a = b", "c = d"]), (["r1 a = b", "r2 c = d"], None), (["3 a = b"], None),
        (["– a = b", "- c = d", "e = f"], ["a = b", "- c = d", "e = f"]), (["– a = b", "— c = d"], ["a = b", "c = d"]),
        (["1- a = b", "2- c = d"], ["a = b", "c = d"]), (["1- a = b", "3- c = d"], None), (["1- a = b"], None),
        (["1 a = b", "2 c = d", "3 e = f"], ["a = b", "c = d", "e = f"]), (["1 a = b", "2 c = d", "4 e = f"], None),
    ],
)  # fmt: skip
def test_the_marks_of_a_list(lines: list[str], bare: list[str] | None) -> None:
    sign = marks.sign_of_list(lines, {"r1", "r2"}.__contains__)
    assert (sign and [sign.sub("", line) for line in lines]) == bare


@pytest.mark.parametrize(
    ("lines", "dash"),
    [(["– a - b = 0", "a = c"], "–"), (["– a – b = 0", "a = c"], None), (["– a = b", "— c = d"], None), (["– a", "c – d"], None)],
)
def test_a_dash_before_a_line_is_a_mark_if_it_takes_nothing_away(lines: list[str], dash: str | None) -> None:
    assert marks.dash_apart(lines) == dash


@pytest.mark.parametrize(("line", "holds"), [("t=0.02 w1=2.5", True), ("t=0.02", False), ("t=0.02 w1=2.5 wrong", False)])
def test_a_printed_row_has_several_values_and_nothing_else(line: str, holds: bool) -> None:
    assert kinds.is_row(line) is holds


@pytest.mark.parametrize(
    ("numbers", "taken"),
    [("10 20 30", True), ("5 10 15", True), ("100 200 300", True), ("10 20", False), ("1 2 3", False), ("10 20 40", False)],
)
def test_the_numbers_of_lines_of_a_program(numbers: str, taken: bool) -> None:
    text = "\n".join(f"{number} V = 1" for number in numbers.split())
    assert marks.without_line_numbers(text) == ("\n".join(["V = 1"] * len(numbers.split())) if taken else text)
    assert marks.without_line_numbers(f"{text}\nW = 2") == f"{text}\nW = 2"
    assert (marks.without_line_numbers(f"\n{text}\n\n") == f"\n{text}\n\n") is not taken


@pytest.mark.parametrize(
    ("line", "holds"),
    [
        ("phi3[k+1] = phi3[k] + h*w3[k]", True), ("phi3 += h*w3", True), ("phi3 = phi3 + w3*0.02", True),
        ("phi3 = phi3 + h*w2", False),
        ("phi3 = h*w3", False), ("w3 = phi3 + w3", False), ("phi3 = phi3", False), ("phi3 = w3", False),
        ("phi3 += h*phi3", False),
    ],
)  # fmt: skip
def test_a_step_adds_a_coordinate_s_own_rate_to_it(line: str, holds: bool, names) -> None:
    assert kinds.is_step(line, names) is holds


@pytest.mark.parametrize(
    ("line", "holds"),
    [
        ("w1, w2 = f(r1)", True), ("w1, w2 = f(sin(phi1))", False), ("k1, k2 = f(sin(phi1))", True), ("w1 = f(sin(phi1))", False),
        ("t = i*h", True), ("n = 25", True),
        ("for C: r1*w1*sin(phi1) = 0", False), ("if it rolls: r1*w1 = r2*w2", False), ("if w1 == 0*r1:", True),
        ("for (i = 0; sin(phi1) <= 1; i++) {", True), ("if sin(phi1) == 0: return", True),
    ],
)  # fmt: skip
def test_a_statement_that_gives_velocities_from_sines_has_an_equation_in_it(line: str, holds: bool) -> None:
    assert kinds.is_statement(line, ("w1", "w2")) is holds


@pytest.mark.parametrize(
    ("line", "vectors", "nothing"),
    [
        ("V_C = V_B + V_CB", True, True), ("velocities: V_C = V_B + V_CB", True, True), ("V_C = V_B + 2", False, True),
        ("V_C = r1*sin(phi1)", False, False), ("V1 = V1 + V1", False, False), ("r1*cos(phi1) = x_F", False, True),
        ("r1*w1*cos(phi1) = x_F", False, False), ("r1*cos(phi1) = x_F + 1", False, False),
        ("so we get velocities w1", False, False),
        ("so that one point rests", False, True), ("one point", False, False),
        # a tangent, a velocity in words or with a dot: these may be equations that nobody could read
        ("r3*w4 = v_B", False, True),
        ("v_P = v_A + v_PA = r1*w1 + r3*w4 + 0*", False, False), ("r3*w4 = v_B*tan(phi3)", False, False),
        ("On a x = r1*cos(phi1)", False, True), ("On a xdot = r1*cos(phi1)", False, False),
        ("V_C = 2 rr a", False, True), ("V_C = 2 r3 w3 sinn phi3", False, False), ("k = 2 r3 w3", False, False),
    ],
)  # fmt: skip
def test_what_says_nothing_of_the_velocities_sought(line: str, vectors: bool, nothing: bool, names) -> None:
    assert (kinds.is_vector_sum(line, names), kinds.says_nothing(line, names)) == (vectors, nothing)


@pytest.mark.parametrize(
    ("line", "holds"),
    [
        ("r1 = 0.953 m", True), ("w1(0) = 2", True), ("w1 = 2", False), ("w1(t = 0) = 2 1/s", True), ("k = 2", True),
        ("r1 = 2 foo bar", False),
        ("r1 = 2*r2", False), ("r1", False), ("r1 = 2 rad/s", True), ("2*r1 = 2", False), ("(1) r1 = 1e-3", True),
        ("so r1 = 2.", True),
    ],
)  # fmt: skip
def test_a_datum_is_a_name_and_a_number(line: str, holds: bool, names) -> None:
    assert kinds.is_datum(line, names) is holds


def test_a_datum_is_short_and_no_name_of_one_s_own_where_answers_are_asked(names) -> None:
    assert kinds.is_datum("r1 = 2".ljust(80), names) and not kinds.is_datum("r1 = 2".ljust(81), names)
    asked = names_for(expected("31", ("w1",)))
    assert kinds.is_datum("r1 = 2", asked) and not kinds.is_datum("k = 2", asked)


@pytest.mark.parametrize("size", [0.004, -250.0])
@pytest.mark.parametrize(("first", "second", "alike"), [
    ("a", "0.9801*a", True), ("a", "0.9799*a", False), ("0.9801*a", "a", True), ("a", "-a", False),
    ("a + t", "a*sin(pi/2)", True), ("a", "b", True),
])  # fmt: skip
def test_two_ways_about_a_loop_differ_by_two_parts_in_a_hundred(first: str, second: str, alike: bool, size: float) -> None:
    """At t = 0; a name without a value, b, tells nothing."""
    assert _meet(parse(first), parse(second), {"a": size}) is alike


@pytest.mark.parametrize("size", ["0.004", "250"])
@pytest.mark.parametrize(("part", "equal"), [("0.98", True), ("-0.98", True), ("1.02", False), ("-1.02", False)])
def test_formulas_of_nearly_the_same_value_are_equal_at_any_size(size: str, part: str, equal: bool) -> None:
    assert kinds.are_equal(parse(f"{size}*a"), parse(f"{size}*a*(1 + ({part})/1000000000)")) is equal
