"""What a formula may have been meant as: with a factor less, or with a term inside the call beside which it stands."""

import pytest

from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import spelled
from coursework.variant.judging.dimension_check import _bracketed, _shortened


@pytest.mark.parametrize(("text", "meant"), [
    ("sin(p*t) + alpha", {"sin(p*t + alpha)"}), ("alpha + sin(p*t)", {"sin(p*t + alpha)"}),
    ("alpha - V*cos(t)", {"V*cos(t + alpha)"}),
    ("sin(a) + cos(b)", {"sin(a + cos(b))", "cos(b + sin(a))"}), ("2*(x + sqrt(y))", {"2*sqrt(y + x)"}), ("x + y", set()),
    ("sin(a)*b", set()), ("-(b + sin(a))", {"-sin(a + b)"}),
])  # fmt: skip
def test_a_term_beside_a_call_may_have_been_meant_inside_it(text, meant):
    assert {spelled(one) for one in _bracketed(parse(text))} == meant


@pytest.mark.parametrize(("text", "meant"), [
    ("r*w", {"r", "w"}), ("r/t", {"r"}), ("2*r", {"2"}), ("r*cos(phi)", {"cos(phi)"}), ("sin(p*t)", {"sin(t)", "sin(p)"}),
    ("V*sin(2*t)", {"sin(2*t)", "V", "V*sin(2)"}), ("3*(t + t)", {"3"}), ("3*(t + x)", set()), ("r/2", set()), ("2/r", {"2"}),
])  # fmt: skip
def test_a_name_or_what_depends_on_time_alone_may_be_a_factor_too_many(text, meant):
    assert {spelled(one) for one in _shortened(parse(text))} == meant
