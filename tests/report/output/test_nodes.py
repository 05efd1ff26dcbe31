"""What finds where a formula fails knows how each function of a formula moves."""

import numpy as np
import pytest

from coursework.report.output.reason import Moving, applied
from coursework.variant.formula.reader import parse

AT, BY = np.array([0.2, 0.55, 0.9]), 1e-6


@pytest.mark.parametrize(
    "text", ["sin(x)", "cos(x)", "tan(x)", "asin(x)", "acos(x)", "atan(x)", "sqrt(x)", "exp(x)", "log(x)", "abs(x)", "-x",
             "x + x", "x - x", "x*x", "x/x", "x^3", "atan2(x, x)", "x @ x", "(x, x)"],
)  # fmt: skip
def test_the_slope_of_each_function_is_that_of_its_values(text):
    """Against central differences of the values; the second argument is 2 + x/2, so that no two arguments are alike."""
    node = parse(text, vectors=True)

    def at(x, slope):
        moving = [Moving(x, slope), Moving(2 + x / 2, slope / 2) if node.op != "^" else Moving(x * 0 + 3, x * 0)]
        return applied(node, moving[: len(node.args)])

    still = np.zeros(3)
    quotient = (at(AT + BY, still).value - at(AT - BY, still).value) / (2 * BY)
    assert at(AT, np.ones(3)).slope == pytest.approx(quotient, rel=1e-8)
    assert not at(AT, still).slope.any()
