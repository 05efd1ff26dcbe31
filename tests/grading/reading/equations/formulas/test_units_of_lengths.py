"""Lengths in mm or cm, as data of the student's own or typed into the equation, and lines that other readers took for words."""

import pytest

from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.expected import Expected
from coursework.variant.reading.reader import parse_variant

RAM = b"""
format = 1
title = "Rod, crosshead and a second rod"
source = "own"
[given]
a = "0.14 m"
m = "0.7 m"
c = "0.31 m"
lam = "0.2 rad"
[drive]
w1 = "6.2"
[coordinates]
phi1 = { start = "0.9 rad", rate = "w1" }
phi2 = { start = "-0.1 rad", rate = "w2" }
[unknowns]
vF = "m/s"
[time]
step = "0.03 s"
end = "0.3 s"
[[constraint]]
name = "1"
because = "along"
equation = "vF + a*w1*sin(phi1) + m*w2*sin(phi2 + lam) = 0"
[[constraint]]
name = "2"
because = "across"
equation = "a*w1*cos(phi1) + m*w2*cos(phi2 + lam) = 0"
"""
KEY = key_of(parse_variant(RAM, "own.toml", {}))
LINE = "vF + {a}*w1*sin(phi1) + {m}*w2*sin(phi2 + lam) = 0"


def verdicts(text):
    """The verdict on each line; "number": it is right but for one or two numbers that are not the task's."""
    lines = read_lines(text, "equations.txt", Expected(KEY.grid, KEY.variant)).equations
    found = Judge(KEY).mark(lines).marks
    return ["number" if mark.hint and mark.hint.kind == "datum" else mark.verdict for mark in found]


@pytest.mark.parametrize(("data", "verdict"), [
    ("l1 = 140 мм, l2 = 700 мм", "right"), ("l1 = 14 cm; l2 = 700mm", "right"), ("l1 = 0,14 м\nl2 = 0,7 [м]", "right"),
    ("l1 = 140\nl2 = 700", "right"), ("l1 = 14\nl2 = 70", "right"),  # all in one unit, which is not said
    ("l1 = 140 cm, l2 = 700 мм", "number"), ("l1 = 14\nl2 = 700", "number"),
    ("l1 = 1.4\nl2 = 7", "number"),  # in no unit that is tried: two numbers, which cost nothing in two lines either
])  # fmt: skip
def test_own_data_have_the_units_that_are_written_behind_them(data, verdict):
    assert verdicts(f"{data}\n{LINE.format(a='l1', m='l2')}") == [verdict]


@pytest.mark.parametrize(("numbers", "verdict"), [
    (("140", "700"), "right"), (("14", "70"), "right"), (("0,14", "0,7"), "right"), (("140", "0.7"), "number"),
    (("1.4", "7"), "number"),
])  # fmt: skip
def test_an_equation_may_be_in_millimetres(numbers, verdict):
    assert verdicts(LINE.format(a=numbers[0], m=numbers[1])) == [verdict]


@pytest.mark.parametrize("text", [
    "vF = −asin φ1·ω1 − m·sin(φ2 + λ)·ω2", "asin(phi1)*w1 + m*sin(phi2 + lam)*w2 + vF = 0",  # a·sin φ1, where a is a datum
    "vF + a*w1*sin(phi1) + m*w2*sin(phi2 + lambda) = 0",
    "vF +\n a*w1*sin(phi1) +\n m*w2*sin(phi2 + lam) = 0", "vF/a +\n w1*sin(phi1) +\n m*w2*sin(phi2 + lam)/a = 0",
    "F(2) = vF + a*w1*sin(phi1) ...\n + m*w2*sin(phi2 + lam) == 0;", "eq||2 := vF + a*w1*sin(phi1) + m*w2*sin(phi2 + lam) = 0:",
    r"latexmath:[v_F + a \omega_1 \sin\varphi_1 + m \omega_2 \sin(\varphi_2 + \lambda) = 0]",
])  # fmt: skip
def test_a_line_is_read_as_it_is_meant(text):
    assert verdicts(text) == ["right"]


@pytest.mark.parametrize("text", [
    "vF + 0,14·ω1·sin φ1 + 0,7·ω2·sin(φ2 + 11,459156°) = 0",
    r"v_F + a\omega_1\sin\varphi_1 = -m\omega_2\sin(\varphi_2 + 11{,}459156^\circ)",
    r"v_F + a\omega_1\sin\varphi_1 + m\omega_2\sin(\varphi_2 + 11.459156^{\circ}) = 0",
])  # fmt: skip
def test_an_angle_in_degrees_may_have_decimals(text):
    assert verdicts(text) == ["rounded"]
    assert verdicts(text.replace("11", "12")) == ["number"]


def test_a_term_without_a_length_is_no_rounding_of_millimetres():
    text = f"{LINE.format(a='a', m='m')[:-4]} = w2"
    judge = Judge(KEY)
    marks = judge.mark(
        read_lines(f"{text}\na*w1*cos(phi1) + 2*m*w2*0.5*cos(phi2 + lam) + w2 = 0", "", Expected(KEY.grid, KEY.variant)).equations
    )
    assert [mark.verdict for mark in marks.marks] == ["wrong", "wrong"]


@pytest.mark.parametrize(("more", "verdict"), [
    ("", "right"), (" + w1", "wrong"), (" - 2*w2", "wrong"), (" + 2.7*w1", "wrong"), (" - sin(phi1)", "wrong"),
    (" + w1*(1 - 3)", "wrong"),
])  # fmt: skip
def test_a_multiple_of_an_equation_is_in_no_millimetres(more, verdict):
    """A factor is no length in mm, beside which a term without a length would be small enough to be rounded away."""
    assert verdicts(f"12*vF + 12*a*w1*sin(phi1) + 12*m*w2*sin(phi2 + lam){more} = 0") == [verdict]


def test_a_slip_in_an_equation_that_a_program_keeps_under_a_name_has_its_hint():
    lines = read_lines(
        "F(2) = vF - a*w1*sin(phi1) + m*w2*sin(phi2 + lam) == 0;", "f.m", Expected(KEY.grid, KEY.variant)
    ).equations
    (mark,) = Judge(KEY).mark(lines).marks
    assert (mark.verdict, mark.hint.kind) == ("wrong", "sign")


def test_names_written_together_with_a_function_are_no_word_before_the_equation():
    """Read without its first term, the line was wrong in silence; now it is a question."""
    assert verdicts("xycos φ2 + m*w2*sin(phi2) + vF = 0") == ["unreadable"]
