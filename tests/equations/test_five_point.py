"""The five-point derivative: exact on quartics, refused on bad tables, and honest about noise."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from coursework.equations.five_point import (
    COEFFICIENTS,
    best_spacing,
    derivative,
    noise,
    rounding_error,
    second_derivative,
    truncation,
)

REFERENCE = Path(__file__).parents[1] / "reference"
PASIKA = json.loads((REFERENCE / "pasika.json").read_text())


@pytest.mark.parametrize(("place", "name"), list(enumerate(PASIKA["poxdf"])))
def test_each_formula_is_exact_up_to_degree_four_and_no_further(place: int, name: str) -> None:
    factor = Fraction(PASIKA["poxdf"][name]["error_term_h4_f5_factor"])
    for degree in range(6):
        estimate = sum(Fraction(weight * (node - place) ** degree, 12) for node, weight in enumerate(COEFFICIENTS[place]))
        if degree < 5:
            assert estimate == (degree == 1)
        else:  # (x^5)' = 0 at 0, and its fifth derivative is 120
            assert estimate == 120 * factor


@pytest.mark.parametrize(("place", "name"), list(enumerate(PASIKA["poxdf"])))
def test_coefficients_of_the_reference(place: int, name: str) -> None:
    known = PASIKA["poxdf"][name]
    assert list(COEFFICIENTS[place]) == known["coefficients_over_12h"]


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(-9, 9), min_size=5, max_size=5), st.integers(5, 30), st.sampled_from([0.01, 0.5, 3.0]))
def test_quartics_are_differentiated_exactly(coefficients: list[int], count: int, h: float) -> None:
    quartic = np.polynomial.Polynomial(coefficients)
    x = h * np.arange(-3.0, count - 3.0)
    y = quartic(x)
    slack = 1e-14 * (1.0 + np.abs(y).max()) / h
    assert np.abs(derivative(x, y) - quartic.deriv()(x)).max() <= 10 * slack
    assert np.abs(second_derivative(x, y) - quartic.deriv(2)(x)).max() <= 100 * slack / h


def test_order_four_inside_and_one_less_at_the_ends_of_the_second_derivative() -> None:
    errors = []
    for count in (41, 81):
        x = np.linspace(0.0, 2.0, count)
        first = np.abs(derivative(x, np.sin(x)) - np.cos(x))
        second = np.abs(second_derivative(x, np.sin(x)) + np.sin(x))
        errors.append((first.max(), second[4:-4].max(), second[0]))
    orders = np.log2(np.array(errors[0]) / np.array(errors[1]))
    assert orders == pytest.approx([4.0, 4.0, 3.0], abs=0.15)


def test_noise_and_truncation_of_the_hard_case() -> None:
    case = next(case for case in json.loads((REFERENCE / "hard_cases.json").read_text())["cases"] if case["id"] == "H24")
    sigma = rounding_error(1e-4)
    assert sigma == pytest.approx(2.887e-5, rel=1e-4)
    assert noise(1.0, 1.0) == pytest.approx(0.95015, rel=1e-5)
    for h in case["data"]["dt"][:2]:  # at 0.0002 neighbours round alike, and the errors are no longer independent
        t = h * np.arange(round(4.0 / h) + 1)
        r = 0.5 + 0.05 * np.sin(2 * np.pi * t)
        wrong = derivative(t, np.round(r, 4)) - derivative(t, r)
        assert wrong[2:-2].std() == pytest.approx(noise(sigma, h), rel=0.15)


def test_best_spacing_makes_the_sum_of_truncation_and_noise_least() -> None:
    sigma, fifth = rounding_error(1e-4), 0.05 * (2 * np.pi) ** 5
    best = best_spacing(sigma, fifth)
    found = minimize_scalar(lambda h: noise(sigma, h) + truncation(fifth, h), bounds=(0.01, 0.2), options={"xatol": 1e-12})
    assert best == pytest.approx(found.x, rel=1e-6)
    assert noise(sigma, best) == pytest.approx(4 * truncation(fifth, best), rel=1e-12)
    assert best_spacing(32 * sigma, -fifth) == pytest.approx(2 * best, rel=1e-12)

    def worst(h: float) -> float:
        t = h * np.arange(round(20.0 / h) + 1)
        rate = 0.1 * np.pi * np.cos(2 * np.pi * t)
        return float(np.abs(derivative(t, np.round(0.5 + 0.05 * np.sin(2 * np.pi * t), 4)) - rate)[2:-2].max())

    assert worst(best) < worst(best / 4)
    assert worst(best) < worst(2.5 * best)
    with pytest.raises(ValueError, match=r"the best spacing needs .* other than zero, found 0 and 1\."):
        best_spacing(0.0, 1.0)


@pytest.mark.parametrize(
    ("nodes", "values", "sentence"),
    [
        ([0, 1, 2, 3], [0, 1, 2, 3], "five-point derivative: at least 5 nodes are needed, found 4."),
        ([0, 1, 2, 3, 4], [0, 1, 2, 3], "five-point derivative: 5 nodes but 4 values."),
        ([0, 1, 3, 2, 4], [0] * 5, "five-point derivative: nodes must grow, but node 3 (2) follows 3."),
        ([0, 1, 1, 2, 3], [0] * 5, "five-point derivative: nodes must grow, but node 2 (1) follows 1."),
        (
            [0, 1, 2, 3.5, 4],
            [0] * 5,
            "five-point derivative: nodes must be equally spaced, but nodes 2 and 3 are 1.5 apart where 1 was expected.",
        ),
        (
            [0.1745, 0.3491, 0.5236, 0.6981, 0.8727],
            [0] * 5,
            "five-point derivative: nodes must be equally spaced, but nodes 0 and 1 are 0.1746 apart where 0.17455 was "
            "expected. Nodes rounded for print will not do.",
        ),
        (
            [0, 1, 2, "x", 4],
            [0] * 5,
            "five-point derivative, nodes: a number was expected, found 'x' at row 3.",
        ),
        (
            [0, 1, 2, 3, 4],
            [0, None, 0, 0, 0],
            "five-point derivative, values: a number was expected, found None at row 1.",
        ),
        (
            [0, 1, 2, 3, 4],
            [0, 1, np.nan, 0, 0],
            "five-point derivative, values: a finite number was expected, found nan at row 2.",
        ),
        (
            [[0, 1, 2, 3, 4]],
            [0] * 5,
            "five-point derivative, nodes: one number, or one number a row, was expected, found shape (1, 5).",
        ),
    ],
)
def test_bad_tables_are_refused(nodes: list[float], values: list[float], sentence: str) -> None:
    with pytest.raises(ValueError, match="five-point") as caught:
        derivative(nodes, values)
    assert str(caught.value).startswith(sentence)
