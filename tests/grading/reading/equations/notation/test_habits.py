"""Habits of students round right equations: what is asked, struck out, said behind, counted or put in; and a slip among it."""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.notation.test_notations import marked

RIGHT = "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"
ROUND = {
    "a Roman number": "VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3) ---- (iv)",
    "a number in a circle": "VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3) … ①",
    "asked": "VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3)   ??? please check",
    "an axis behind an arrow": "VMy = 2*r3*w3*cos(phi3) + r3*w3*sin(phi3) → y axis",
    "struck out": f"~~VMy = 2*r3*w3*cos(phi3) - r3*w3*sin(phi3)~~\n{RIGHT}",
    "a dash behind a colon": f"Along y:- {RIGHT}",
    "a frame": f"[{RIGHT}]",
    "a parenthesis that opens": f"(\n{RIGHT}\n",
    "a question": f"{RIGHT}\nQuestion: why is w3 = 0 at the dead point?",
    "numbers put in": "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3))) = 4.5/(0.9*(2*cos(0.3) + sin(0.3))) = 2.27 1/s",
    "two steps": "D = r3*(2*cos(phi3) + sin(phi3)) = 2*r3*cos(phi3) + r3*sin(phi3)\nw3 = VMy/D",
    "a list of names": f"a, b, c are the angles phi1, phi2 and phi3\n{RIGHT.replace('phi3', 'c')}",
}


@pytest.mark.parametrize("text", ROUND.values(), ids=list(ROUND))
def test_a_right_equation_with_a_habit_of_students_is_right_and_with_a_slip_wrong(text):
    found = marked(text)
    assert {mark.verdict for mark in found.marks} == {"right"} and found.independent == 1
    slip = marked(text[::-1].replace("3w*3r", "2w*3r", 1).replace("yMV", "xMV", 1)[::-1])
    assert slip.independent == 0
