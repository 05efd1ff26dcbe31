"""Equations that hold with the other sign of all angular velocities, and those in which one linear speed has a wrong sign."""

from __future__ import annotations

import pytest

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.reading.equations.lines import read_lines
from tests.grading.reading.equations.notation.test_notations import judge
from tests.grading.scenes import expected

LOOP = "a*wa*cos(alpha) + b*wb*cos(beta) = 0\n"
# Of v102, every w turned; the given velocity of M tells that.
TURNED = """VMx - a*w3*sin(phi3) - c*w3*cos(phi3) = 0
VMy + a*w3*cos(phi3) - c*w3*sin(phi3) = u
VMx - a*w3*sin(phi3) - r2*w2*sin(phi2) - r1*w1*sin(phi1) = 0
VMy + a*w3*cos(phi3) + r2*w2*cos(phi2) + r1*w1*cos(phi1) = 0"""


def marks(text: str, name: str = "offset", *, is_told: bool = False) -> EquationMarks:
    return judge(name).mark(read_lines(text, "", expected(name)).equations, turning=True, is_told=is_told)


@pytest.mark.parametrize("line", [
    "v = a*wa*sin(alpha) + b*wb*sin(beta)", "-v = -a*wa*sin(alpha) - b*wb*sin(beta)", "-v + a*wa*sin(alpha) + b*wb*sin(beta) = 0",
])  # fmt: skip
def test_a_wrong_sign_of_one_linear_speed_is_no_turning_unless_a_table_tells_so(line: str) -> None:
    guessed, told = marks(LOOP + line), marks(LOOP + line, is_told=True)
    assert [(mark.verdict, mark.hint and mark.hint.kind) for mark in guessed.marks] == [("right", None), ("wrong", "sign")]
    assert (guessed.turned, told.turned, told.share) == (False, True, 1)


def test_a_whole_set_that_is_turned_is_taken_and_a_mirrored_one_is_right_as_it_stands() -> None:
    whole = marks(TURNED, "v102")
    assert (whole.turned, whole.share) == (True, 1)
    mirrored = marks("a*wa*cos(-alpha) + b*wb*cos(-beta) = 0\nv = a*wa*sin(-alpha) + b*wb*sin(-beta)")
    assert (mirrored.turned, mirrored.share) == (False, 1)


@pytest.mark.parametrize(("lines", "wrong", "asks"), [
    ("vx = -a*wa*sin(alpha)\nvc = vx - b*wb*sin(beta)", 0, True), ("vx = -a*wa*sin(alpha)", 1, False),
    ("v_C = a*wa*sin(alpha) - b*wb*sin(beta)\nv = v_C", 1, False),
])  # fmt: skip
def test_a_speed_under_another_name_beside_another_one_is_asked_about(lines: str, wrong: int, asks: bool) -> None:
    """Both names, vx and vc, may be v; a slip that is found is named."""
    found = marks(LOOP + lines)
    assert (len(found.wrong), found.unread is not None) == (wrong, asks)
