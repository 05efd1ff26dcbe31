"""A written-out derivative by time is the slope of what stands in it, whatever its notation; what has none here is never read."""

from __future__ import annotations

from math import cos, pi, sin
from typing import TYPE_CHECKING

import pytest

from coursework.grading.reading.equations.formulas.equations import names_for, read_line
from coursework.variant.formula.tree import evaluate
from tests.grading.scenes import expected

if TYPE_CHECKING:
    from collections.abc import Callable

AT, RATES, DATA, STEP = (1.1, 0.7, 2.3, 0.4), (1.0, 0.6, -1.7, 2.9), {"r1": 0.9, "r2": 0.8, "r3": 0.5}, 1e-5
NOTATIONS = ("d/dt ({})", "(d/dt)*({})", "d({})/dt", "(d({}))/(dt)", "diff({}, t)", "({})'", "({}).diff(t)", "d/dt [{}]")
# Of t, phi1, phi2 and phi3.
FORMULAS: dict[str, Callable[[float, float, float, float], float]] = {
    "r1*cos(phi1) + r2*sin(phi2)": lambda t, a, b, c: 0.9 * cos(a) + 0.8 * sin(b),
    "-r3*cos(phi3) - 2": lambda t, a, b, c: -0.5 * cos(c) - 2,
    "r1*sin(phi1 - phi2)/r3": lambda t, a, b, c: 0.9 * sin(a - b) / 0.5,
    "phi1^3*r2": lambda t, a, b, c: 0.8 * a**3,
    "2*t*phi2 + pi": lambda t, a, b, c: 2 * t * b + pi,
    "r1 - phi1*sin(phi3)": lambda t, a, b, c: 0.9 - a * sin(c),
}  # fmt: skip


@pytest.mark.parametrize("notation", NOTATIONS)
def test_a_derivative_is_the_slope_of_its_formula(notation: str) -> None:
    names = names_for(expected("31"))
    at = dict(zip(("t", "phi1", "phi2", "phi3"), AT, strict=True)) | dict(zip(("w1", "w2", "w3"), RATES[1:], strict=True))
    for text, value in FORMULAS.items():
        before, after = ([q + way * STEP * rate for q, rate in zip(AT, RATES, strict=True)] for way in (-1, 1))
        read = read_line(f"5 + 3*{notation.format(text)} = 2*w3", "", 1, names)
        assert read.tree is not None, text
        slope = (value(*after) - value(*before)) / (2 * STEP)
        left, right = (evaluate(side, at | DATA) for side in read.tree.args)
        assert left - right == pytest.approx(5 + 3 * slope - 2 * RATES[3], abs=1e-8), text


@pytest.mark.parametrize("text", ["tan(phi1)", "phi1/phi2", "2^phi1", "q9*phi1", "log(phi1)*r1", "phi1*("])
def test_what_has_no_derivative_here_is_not_read(text: str) -> None:
    assert read_line(f"d/dt (2*{text}) = 2*w3", "", 1, names_for(expected("31"))).tree is None


@pytest.mark.parametrize("line", ["diff(r1*phi1) = 2*w3", "5*r1*sin(phi1 - phi2)' = 2*w3"])
def test_neither_a_call_without_the_time_nor_an_argument_is_derived(line: str) -> None:
    assert read_line(line, "", 1, names_for(expected("31"))).tree is None


@pytest.mark.parametrize("text", ["d/dt m*cos(phij) = wj", "(d)/(dt) m*cos(phij) = wj", "∂/∂t m cos phij = wj"])
def test_a_derivative_without_brackets_is_no_quotient_of_a_length_d(text: str) -> None:
    assert read_line(text, "", 1, names_for(expected("jansen"))).tree is None
