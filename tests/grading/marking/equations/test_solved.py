"""Two velocities solved out of two equations, with a slip in one of these or in each formula."""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.notation.test_notations import marked

GUIDE = "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0\n2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0"
FIRST, SECOND = "(0.5*r3*w4 - r3*w3*cos(phi3))", "(r3*w3*sin(phi3))"
SLIP, OTHER = FIRST.replace(" - ", " + "), SECOND.replace("sin", "cos")
BELOW = "(r1*r2*sin(phi1 - phi2))"


def solved(first: tuple[str, str], second: tuple[str, str]) -> str:
    """Return the guide of C, and w1 and w2 out of r1·w1·sin φ1 + r2·w2·sin φ2 = a, r1·w1·cos φ1 + r2·w2·cos φ2 = b."""
    w1 = f"w1 = ({first[0]}*r2*cos(phi2) - {first[1]}*r2*sin(phi2))/{BELOW}"
    w2 = f"w2 = (r1*sin(phi1)*{second[1]} - r1*cos(phi1)*{second[0]})/{BELOW}"
    return f"{GUIDE}\n{w1}\n{w2}"


@pytest.mark.parametrize(("first", "second", "share", "different"), [
    ((FIRST, SECOND), (FIRST, SECOND), 1.0, 0), ((SLIP, SECOND), (SLIP, SECOND), 0.75, 1),
    ((FIRST, OTHER), (FIRST, OTHER), 0.75, 1), ((SLIP, SECOND), (FIRST, SECOND), 0.75, 1),
    ((SLIP, SECOND), (FIRST, OTHER), 0.5, 2), ((SLIP, OTHER), (SLIP, OTHER), 0.5, 2),
])  # fmt: skip
def test_a_slip_in_one_equation_is_one_in_the_velocities_solved_out_of_it(first, second, share, different):
    """It took 20 of 40 points where the equations themselves, with the same slip, lost 10."""
    found = marked(solved(first, second))
    assert (found.share, found.different) == (share, different)
    told = [mark for mark in found.marks if "one wrong equation" in str(mark.lack)]
    assert len(told) == (len(found.wrong) == 2 and different == 1)


@pytest.mark.parametrize("beside", ["r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0",
                                    "0.5*r3*w4 - r3*w3*cos(phi3) - r2*w2*sin(phi2) - r1*w1*sin(phi1) = 0"])  # fmt: skip
def test_a_right_equation_beside_them_lowers_nothing(beside):
    wrong = solved((SLIP, SECOND), (SLIP, SECOND))
    assert marked(f"{wrong}\n{beside}").share >= marked(wrong).share


@pytest.mark.parametrize(("line", "term"), [
    ("r3*w3*sin(phi3) - r2*w2*cos(phi2) = 0", "r1*w1*cos(phi1)"), ("r2*w2*cos(phi2) + r1*w1*cos(phi1) = 0", "r3*w3*sin(phi3)"),
    ("r3*w3*sin(phi3) = 0", None), ("r3*w3*sin(phi3) - 2*r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0", None),
])  # fmt: skip
def test_the_one_term_that_a_wrong_line_is_short_of_is_told(line, term):
    (mark,) = marked(line).wrong
    assert str(mark.lack) == (f"A term is missing: {term}." if term else "")
