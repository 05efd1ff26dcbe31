"""Equations of a shaper that are right and said to be wrong, chains with a wrong side, and where the wrong term stands."""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.test_of_a_shaper import BLOCK, RODS, marked

SPEED = "u = r*w1*sin(phi3 - phi1)"
TURN = "s*w3 = r*w1*cos(phi1 - phi3)\n" + RODS


@pytest.mark.parametrize("line", [
    f"not: ({SPEED})", f"Wrong: {SPEED}", f"{SPEED} (sign reversed)", f"{SPEED} # wrong", f"неверно: {SPEED}", f"nicht {SPEED}",
    f"crossed out: {SPEED}",
])  # fmt: skip
def test_what_a_line_denies_is_a_question_and_costs_nothing_beside_the_right_one(line):
    assert marked(TURN + line).independent == 3 and marked(TURN + line).unread
    both = marked(f"{TURN}{line.replace('- phi1', '+ phi1')}\n{SPEED}")
    assert both.share == 1 and not both.wrong


@pytest.mark.parametrize("line", [
    f"The block does not turn over: {SPEED}", f"{SPEED} (no slip)", f"no. 2: {SPEED}", f"{SPEED} (sign: outward)",
    f"crossed bars, ignore friction: {SPEED}", f"{SPEED} # wrong sign corrected", f"It turns not: {SPEED}", f"{SPEED}, not r",
    "(w1 = 3)\nu - r*w1*sin(phi3 - phi1) = 0", f"with the opposite sign: {SPEED}", "w1 = 2*pi*n/60 = u/(r*sin(phi3 - phi1))",
    "u = r*w1*sin(phi3 - phi1) = -r*w1*sin(phi1 - phi3)", "(s*w3 = r*w1*cos(phi1 - phi3)) e (u = r*w1*sin(phi3 - phi1))",
    "(u, 0) = (r*w1*sin(phi3 - phi1), 0); (w3, 0) = (r*w1*cos(phi1 - phi3)/s, 0)",
])  # fmt: skip
def test_what_denies_nothing_is_right(line):
    assert marked(f"{TURN}{line}").share == 1


@pytest.mark.parametrize("chain", ["2*u = u = r*w1*sin(phi3 - phi1)", "u = r*w1*sin(phi1 - phi3) = r*w1*sin(phi3 - phi1)"])
def test_a_chain_with_a_wrong_side_is_wrong(chain):
    assert len(marked(TURN + chain).wrong) == 1


def test_of_two_sought_velocities_at_once_both_are_said():
    both = marked(TURN + "w3 = u = r*w1*sin(phi3 - phi1)")
    assert both.independent == 3 and (both.wrong or both.unread)


def test_the_line_of_a_hint_is_that_of_the_wrong_term():
    found = marked(BLOCK + "w4 = -L*w3*cos(phi3)/(b*cos(phi4))\nv = -L*w3*sin(phi3)\n  + b*w4*sin(phi4)\n")
    assert [(mark.line.line, mark.hint.column, mark.hint.kind) for mark in found.wrong] == [(5, 3, "sign")]
