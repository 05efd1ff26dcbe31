"""Which lines are one equation that goes on: a sign at the end, an open bracket, a sign at the start, a mark of a program."""

from __future__ import annotations

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for
from coursework.grading.reading.equations.text.continued_lines import continued
from tests.grading.scenes import expected

NAMES = names_for(expected())


@pytest.mark.parametrize(("text", "joined"), [
    # a further side below the first
    ("w3 = 2*w1\n & = 3*w2", "w3 = 2*w1 = 3*w2"), ("w3 = 2*w1\n  = 3*w2", "w3 = 2*w1 = 3*w2"),
    ("0 = w3\n & = 2*w1", "0 = w3 = 2*w1"),
    ("w3 = 2*w1\n= 3*w2", "w3 = 2*w1\n= 3*w2"), ("w3 = 0\n & = 2*w1", "w3 = 0\n & = 2*w1"),
    ("= w3\n & = 2*w1", "= w3\n & = 2*w1"),
    # a sum that goes on
    ("r1*w1\n + r2*w2 = 0", "r1*w1 + r2*w2 = 0"), ("r1*w1\n+ r2*w2\n= 0", "r1*w1 + r2*w2 = 0"),
    ("r1*w1 = r2*w2\n-r3*w3", "r1*w1 = r2*w2 -r3*w3"),
    ("r1*w1 = 0\n + r2*w2 = 0", "r1*w1 = 0\n + r2*w2 = 0"), ("r1*w1 = 0\n-r3*w3", "r1*w1 = 0\n-r3*w3"),
    ("r1*w1 +\n+ r2*w2 = 0", "r1*w1 +  r2*w2 = 0"), ("r3*w3 =\nr1*w1", "r3*w3 = r1*w1"),
    ("r3*w3 =\nr1*w1 = 2", "r3*w3 =\nr1*w1 = 2"),
    ("r1*w1 = r2*w2\n+ for the crank", "r1*w1 = r2*w2\n+ for the crank"),
    # brackets
    ("w3 = (r1*w1\n + r2*w2)/r3", "w3 = (r1*w1 + r2*w2)/r3"), ("r3*w3 = (r1*w1\n)", "r3*w3 = (r1*w1 )"),
    ("w3 = r1*w1\n - r2*w2/(cos(phi2)\n + sin(phi2))", "w3 = r1*w1 - r2*w2/(cos(phi2) + sin(phi2))"),
    ("r1*w1 = 0 (\nthe crank", "r1*w1 = 0 (\nthe crank"), ("[[r1, r2],\n[r3, 0]]", "[[r1, r2], [r3, 0]]"),
    # marks of programs
    ("w3 = r1*w1 ...\n- w2", "w3 = r1*w1 - w2"), ("w3 = r1*w1 &\n- w2", "w3 = r1*w1 - w2"),
    ("w3 = r1*w1 - &\nw2", "w3 = r1*w1 - w2"),
    ("w3 = r1*w1 _\n- w2", "w3 = r1*w1 - w2"), ("      w3 = r1*w1\n     &- w2", "      w3 = r1*w1 - w2"),
    ("      w3 = r1*w1\n     1 - w2\n     2 + w4", "      w3 = r1*w1 - w2 + w4"),
    ("      w3 = r1*w1\n     + - w2\n     * + w4", "      w3 = r1*w1 - w2 + w4"),
    ("w3 = r1*w1 +\n     2*w2", "w3 = r1*w1 + 2*w2"),
    ("w3 = r1*w1 \\\nw2 = 0", "w3 = r1*w1 \\\nw2 = 0"), ("from x import *\n+ r1*w1", "from x import *\n+ r1*w1"),
])  # fmt: skip
def test_lines_are_joined_where_the_equation_goes_on(text: str, joined: str) -> None:
    assert "\n".join(line for _, line in continued(enumerate(text.split("\n"), 1), NAMES)) == joined
