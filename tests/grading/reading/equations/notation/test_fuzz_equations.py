"""A right equation is never marked wrong, whatever hand wrote it: read, or a question."""

import random

import pytest

from tests.grading.reading.equations.notation.fuzz_equations import written
from tests.grading.reading.equations.notation.notations import PLAIN
from tests.grading.reading.equations.notation.test_notations import marked

SAMPLE, MANY = 40, 2000
QUESTIONS = 0.02


@pytest.mark.parametrize("first", [0, pytest.param(10_000, marks=pytest.mark.long)])
def test_right_equations_are_read_or_a_question_in_any_hand(first):
    count, asked = MANY if first else SAMPLE, []
    for seed in range(first, first + count):
        chance = random.Random(seed)
        mechanism = chance.choice(list(PLAIN))
        text = written(mechanism, chance)
        found = marked(text, mechanism)
        assert not found.wrong, (seed, text)
        if found.share < 1.0:
            assert found.unread is not None, (seed, text)
            asked.append(seed)
    assert len(asked) <= QUESTIONS * count, asked


@pytest.mark.parametrize(
    "line",
    [
        "[1] .5*r3*w4 = r3*w3*cos(phi3) - 2*r3*w3*sin(phi3)", "Eq. 2 .5 r3 w4 = r3 w3 cos phi3 - 2 r3 w3 sin phi3",
        "so ½ r3 w4 = r3 w3 cos phi3 - 2 r3 w3 sin phi3", "so (0.5 r3 w4) + 2*r3*w3*sin(phi3) = r3*w3*cos(phi3)",
        "thus .5*r3*w4 + 2*r3*w3*sin(phi3) = r3*w3*cos(phi3)",
    ],
)  # fmt: skip
def test_a_number_or_a_bracket_at_the_beginning_is_the_equation_s(line):
    lines = PLAIN["31"].split("\n")
    found = marked("\n".join([lines[0], line, *lines[2:]]), "31")
    assert [mark.verdict for mark in found.marks] == ["right"] * 4, found.marks[1].line.repaired


@pytest.mark.parametrize("line", ["so (at C) {}", "(a) {}", "We have (see Fig. 2): {}", "{} — equation 3", "{}  Gl. (12)"])
def test_an_aside_or_a_number_is_not(line):
    found = marked("\n".join(line.format(one) for one in PLAIN["31"].split("\n")), "31")
    assert found.share == 1.0, [(mark.verdict, mark.line.repaired) for mark in found.marks]


def test_the_number_of_an_equation_behind_an_index_is_no_entry_of_a_vector():
    lines = ["−ω_1 · k=ω_4 (1)", "ω_4 · r_4 · sin(φ_4)−ω_1 · r_1 · sin(φ_1)+r_3 · ω_3 · sin(φ_3) =ω_2 · r_2 · sin(φ_2) (2)"]
    assert [mark.verdict for mark in marked("\n".join(lines), "geared").marks] == ["right", "right"]
