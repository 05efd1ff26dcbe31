"""Where a long product with a sum at its end is parted into the terms of that sum."""

import random
import re
from itertools import pairwise

import pytest

from coursework.report.formulas.display import math_equation
from coursework.report.formulas.svg import LONG, _opened
from coursework.variant.formula.reader import parse

END = "e sin phi_2 " + "a" * LONG


@pytest.mark.parametrize(
    ("piece", "parts"),
    [
        (f"g (a - b (c + d) + {END})", ["g \\(a", " - b (c + d)", f" + {END}\\)"]),
        (f"g (a - b) (c + {END})", [f"g (a - b) (c + {END})"]),  # the parenthesis at the end is another one
        ("g (a - b)", ["g (a - b)"]),
    ],
)
def test_a_sum_in_parentheses_of_its_own_is_parted_at_its_signs(piece, parts):
    assert [*map(str.rstrip, _opened(piece))] == parts


def width_of(piece):
    """Letters and brackets count one, signs three with their spaces: what fits the line of a printed page is 64 of these."""
    return sum(
        3 if sign in {"+", "-", "="} else len(sign.strip("()")) for sign in piece.replace("quad", "").replace("&", "").split()
    )


@pytest.mark.parametrize("form", ["%s", "k*(%s)", "-k*(%s)"])
def test_each_line_of_a_long_equation_is_as_full_as_it_may_be(form):
    """Lines after the first are indented by four letters; the bracket at the end needs room, too."""
    chance, folded = random.Random(7), 0
    for _ in range(20):
        terms = ["*".join(chance.choices("abcdefgh", k=chance.randint(1, 17))) for _ in range(chance.randint(2, 13))]
        text = math_equation(parse("v"), parse(form % "+".join(terms).replace("+", chance.choice("+-"), 1)))
        lines = text.split(" \\ ")
        folded += len(lines) > 1
        for place, line in enumerate(lines):
            assert width_of(line) <= 64 - 4 * (place > 0), text
        for place, (line, following) in enumerate(pairwise(lines)):
            first, *_ = re.split(r" (?=[+-] )", following.replace("& quad ", ""))
            assert width_of(line) + width_of(first) > 64 - 4 * (place > 0), text
    assert folded > 5
