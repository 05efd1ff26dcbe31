"""Where a long product with a sum at its end is parted into the terms of that sum."""

import itertools
import re

import pytest

from coursework.report.formulas import display
from coursework.report.formulas.display import math_equation
from coursework.report.formulas.svg import LONG, _gathered, _opened, pieces
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


@pytest.mark.parametrize(("length", "lines"), [(24, 1), (25, 2)])
def test_neighbours_of_up_to_44_signs_share_a_line_and_the_end_has_none_of_its_own(length, lines):
    first, second, end = "a" * 20, "b" * length, " = 0"
    assert _gathered([first, second]) == ([first + second] if lines == 1 else [first, second])
    assert _gathered([first, second, end]) == [*_gathered([first, second])[:-1], _gathered([first, second])[-1] + end]


@pytest.mark.parametrize(("length", "parted"), [(LONG - 1, False), (LONG, True)])
def test_a_formula_of_56_signs_is_long(length, parted):
    formula = "x = " + "a" * 30
    formula += " + " + "b" * (length - len(formula) - 3)
    assert (len(pieces(formula)) > 1) is parted


def width_of(piece):
    """Letters and brackets count one, signs three with their spaces: what fits the line of a printed page is 64 of these."""
    return sum(
        3 if sign in {"+", "-", "="} else len(sign.strip("()")) for sign in piece.replace("quad", "").replace("&", "").split()
    )


@pytest.mark.parametrize("form", ["%s", "k*(%s)"])
def test_each_line_of_a_long_equation_is_as_full_as_it_may_be(form):
    """Lines after the first are indented by four letters; the bracket at the end needs room, too."""
    folded = 0
    for begin, last in itertools.product(((17, 17), (9, 14, 17, 12, 16, 17)), (*range(1, 20, 2), *range(25, 34, 2))):
        total = "+".join("*".join("abcde"[place % 5] for place in range(count)) for count in (*begin, last))
        lines = math_equation(parse("v"), parse(form % total.replace("+", "-", 1))).split(" \\ ")
        folded += len(lines) > 1
        for place, line in enumerate(lines):
            assert width_of(line) <= 64 - 4 * (place > 0)
        for place, (line, following) in enumerate(itertools.pairwise(lines)):
            first, *_ = re.split(r" (?=[+-] )", following.replace("& quad ", ""))
            assert width_of(line) + width_of(first) > 64 - 4 * (place > 0)
    assert 10 < folded < 28  # a product of 61 to 64 letters, which stays whole, is left out


@pytest.mark.parametrize(("left", "right", "told"), [
    (30, 31, "x = a (b + c)"), (30, 32, "& x = a (b + c)"), (30, 64, "& x = a (b + c)"), (30, 65, "& x = a [ b + c ]"),
])  # fmt: skip
def test_an_equation_is_parted_beyond_64_letters_and_its_sum_if_its_right_side_has_more(left, right, told, monkeypatch):
    widths = {"x": left, "a": 1, "b": 30, "c": 30}
    monkeypatch.setattr(display, "_width", lambda tree, _: widths.get(tree.name, right))
    assert math_equation(parse("x"), parse("a*(b + c)")) == told


@pytest.mark.parametrize(("pieces", "lines"), [
    ([60, 4], 1), ([60, 5], 2), ([5, 59], 1), ([5, 60], 2), ([4, 61], 1), ([60, 5, 55], 2), ([60, 5, 56], 3),
])  # fmt: skip
def test_a_line_has_64_letters_and_one_that_goes_on_60(pieces, lines):
    """No line ends behind four letters: the next would have no more room."""
    assert display._folded([(width, "x") for width in pieces]).count("&") == lines
