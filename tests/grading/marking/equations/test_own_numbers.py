"""A number or a law of the drive that is not the task's costs the equations nothing, as with letters; a slip of form does."""

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.equations import own_numbers
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.equations.own_numbers import _rounds
from coursework.grading.marking.equations.probe import random_probe
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.equations.lines import read_lines
from coursework.grading.reading.expected import Expected
from coursework.variant.formula.reader import parse_equation
from tests.grading.reading.equations.notation.notations import PLAIN

KEY = key_of(coursework.load("v102"))
JUDGE = Judge(KEY)
LAW = "V1*sin(p*t + alpha)"
LETTERS = PLAIN["v102"].replace("VMx", LAW).replace("VMy", "0")


def numbers(text, **copied):
    """The text with data put in, some of them `copied` wrongly."""
    for name, value in {**KEY.variant.values, **copied}.items():
        text = re.sub(rf"\b{name}\b", f"{value:g}", text)
    return text


def marked(text):
    return JUDGE.mark(read_lines(text, "equations.txt", Expected(KEY.grid, KEY.variant)).equations)


@pytest.mark.parametrize(("written", "value", "holds"), [
    ("0.95", 0.953, True), ("0.95", 0.9550, True), ("0.95", 0.9551, False), ("0.950", 0.9503, True), ("0.950", 0.953, False),
    ("950", 953.0, True), ("950", 955.1, False), ("950.", 950.4, True), ("950.0", 950.4, False),
    ("1", 1.05, True), ("1", 1.06, False), ("4", 4.2, True), ("4", 4.3, False),  # by at most a twentieth of the datum
    ("2*pi/3", 2.0943951024, True), ("2*pi/3", 2.0944, False),
    *(
        (f"{size}*pi", math.pi * size * (1 + part), abs(part) < 1e-9)
        for size in (0.002, 80) for part in (0.98e-9, -0.98e-9, 1.02e-9, -1.02e-9)
    ),
])  # fmt: skip
def test_a_number_may_round_a_datum_to_its_last_digit(written, value, holds):
    assert _rounds(parse_equation(f"{written} = 0")[0], value, random_probe(KEY)) is holds


@pytest.mark.parametrize(("text", "told"), [
    *((numbers(LETTERS, **{name: x + 0.1}), f"{x + 0.1:g}|{name} = {x:g}") for name, x in KEY.variant.values.items()),
    (LETTERS.replace(LAW, "V1*cos(p*t + alpha)"), f"V1*cos(p*t + alpha)|VMx = {LAW}"),
    (numbers(LETTERS.replace("t +", "t -")), f"2*sin(10.47*t - 4.96)|VMx = {LAW}"),
    (LETTERS.replace("p*t", "2*pi*5*t"), "2*pi*5|p = 10.47"),
])  # fmt: skip
def test_a_number_or_a_law_that_is_not_the_tasks_is_named_and_costs_nothing(text, told):
    found = marked(text)
    assert (found.share, found.wrong) == (1, ())
    (note,) = (str(one.text) for one in found.notes if one.code == "data_differ")
    assert all(part in note for part in told.split("|"))
    hints = {(mark.hint.text, mark.hint.term.split(" = ")[0]) for mark in found.marks if mark.hint and mark.hint.kind == "datum"}
    assert hints == {(told.split("|")[0], told.split("|")[1].split(" = ")[0])}


@pytest.mark.parametrize("text", [
    numbers(LETTERS, r1=KEY.variant.values["r2"]), numbers(LETTERS, r1=0.65),  # another length of the mechanism, and it rounded
    numbers(LETTERS, r1=2.126), numbers(LETTERS, r1=0.53), numbers(LETTERS, V1=4.0),  # 2*r1, r1/2 rounded, 2*V1
    numbers(LETTERS.replace("+ r1", "- r1")), numbers(LETTERS.replace("r1*", "2*r1*")),
    LETTERS.replace("r1*", "0.5*r1*"), LETTERS.replace(LAW, f"(-{LAW})"), LETTERS.replace(LAW, f"2*{LAW}"),
    LETTERS.replace("0 - a", f"{LAW} - a"),  # the law of the other direction
    numbers(LETTERS, r1=1.2, r2=0.7),  # two numbers in one line
    "2*VMx + 2*a*w3*sin(phi3) + 2*r2*w2*sin(phi2) + 3*r1*w1*sin(phi1) = 0",  # V1 is 2 m/s by chance
])  # fmt: skip
def test_a_slip_of_form_stays_one_whatever_stands_for_the_data(text):
    found = marked(text)
    assert found.share < 1 and not any(note.code == "data_differ" for note in found.notes)


@pytest.mark.parametrize("size", [0.004, -0.004, 250.0])
@pytest.mark.parametrize(("share", "is_one"), [(0.98e-9, True), (1.02e-9, False)])
def test_a_drive_that_is_steady_to_nine_digits_is_a_number_of_the_task(size, share, is_one, monkeypatch):
    monkeypatch.setattr(own_numbers, "_laws", lambda *_: [("w1", size * np.array([1.0, 1.0 + share]))])
    line = parse_equation(f"{1.5 * abs(size):g}*x = 0")[0]
    found = [*own_numbers._numbers_in(line, (), SimpleNamespace(given=()), random_probe(KEY))]
    assert bool(found) is is_one


IN_MM = {"r1": 1063, "r2": 649, "a": 613, "c": 683, "V1": 2000}


@pytest.mark.parametrize("changed", [{}, {"r1": 1150}, {"a": 631}, {"V1": 2}])
def test_a_number_that_is_not_the_tasks_costs_nothing_in_millimetres_either(changed):
    found = marked(numbers(LETTERS.replace("= u", "= 1000*u"), **IN_MM | changed))
    told = [str(note.text) for note in found.notes if note.code == "data_differ"]
    assert found.share == 1 and len(told) == len(changed)
    assert all(f" {x} stands where the task has {name} = {IN_MM[name]} mm" in told[0] for name, x in changed.items())
    assert marked(numbers(LETTERS.replace("= u", "= 1000*u"), **IN_MM | {"r1": 650})).share < 1  # r2, rounded


@pytest.mark.parametrize(("data", "lines"), [
    ({"p": 10.5, "r1": 1.06}, "1, 3, 4"),
    ({"p": 10, "alpha": 5.0, "r1": 1.1, "r2": 0.65, "a": 0.61, "c": 0.68}, "1, 2, 3, 4"),
    ({**IN_MM, "p": 10.5, "r1": 1100}, "1, 3, 4"),
])  # fmt: skip
def test_data_that_are_rounded_cost_nothing_however_many_stand_in_a_line(data, lines):
    right = LETTERS.replace("= u", "= 1000*u") if "V1" in data else LETTERS
    found = marked(numbers(right, **data))
    assert (found.share, str(found.notes[0].text)) == (1, f"Numbers are rounded in lines that count as right: {lines}.")
    for slip in ("+ r1|- r1", "cos(phi1)|sin(phi1)", "+ r2|+ 2*r2", "c*w3*cos|a*w3*cos"):
        assert marked(numbers(right.replace(*slip.split("|")), **data)).share == 0.75
    assert marked(numbers(right.replace("V1", "2*V1"), **data)).share == 0.5
    law = marked(numbers(right.replace("sin(p*t", "cos(p*t"), **data))
    assert law.share == 1 and f"*cos({data['p']:g}*t + " in str(law.notes[0].text)  # with the numbers that were written
    copied = {"r2": 2 * data.get("r2", 0.649) + 0.1}  # beside rounded ones: r1 in line 4, p in line 3
    assert marked(numbers(right, **data | copied)).share == 1


@pytest.mark.parametrize("text", [
    "VMx + (1.2, 3.4)*w1 = 0", "VMx + 2 @ 3*w1 = u", "VMx + w1/0 = 0", "VMx + w1*log(-1) + sin((1, 2)) = 0",
    "VMx + " + " + ".join(f"{k}.5*w1*sin({k}.7*t)" for k in range(60)) + " = 0",
])  # fmt: skip
def test_numbers_that_are_none_and_lines_that_never_end_are_no_copies(text):
    """Vectors, no value at all, and more numbers than are tried."""
    found = marked(text)
    assert found.share == 0 and not found.notes


def test_two_numbers_cost_as_much_in_one_line_as_in_two():
    both = marked(numbers(LETTERS, r1=1.17, r2=0.749))
    each = marked(numbers(LETTERS, r1=1.17)), marked(numbers(LETTERS, r2=0.749))
    assert both.share == each[0].share == each[1].share == 1
    assert any("1.17" in str(note.text) and "r2 = 0.649" in str(note.text) for note in both.notes)
    assert marked(numbers(LETTERS.replace("+ r1", "- r1"), r1=1.17, r2=0.749)).share < 1  # a sign beside them is a slip


@pytest.mark.parametrize("law", ["t", "3*t + 1", "exp(t)", "sqrt(p*t)"])
def test_a_function_of_time_that_is_no_form_of_the_law_is_wrong(law):
    found = marked(LETTERS.replace(LAW, f"({law})"))
    assert found.share < 1 and not any(note.code == "data_differ" for note in found.notes)


def test_a_velocity_without_its_length_is_no_number_copied_wrongly():
    found = marked(numbers(LETTERS.replace("r1*w1", "1*w1")))
    assert found.share < 1 and not any(note.code == "data_differ" for note in found.notes)
