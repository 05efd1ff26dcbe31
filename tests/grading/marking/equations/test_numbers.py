"""A student's formula with numbers: each operation against Python's own `math` and `cmath`, and what has no value."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from coursework.grading.marking.equations.numbers import NoValue, computed, real, size_of, value_of
from coursework.variant.formula.reader import parse

A, B = 0.3, -0.7
NAMES = {"a": A, "b": B, "row": np.array([1.0, -2.0]), "P": complex(A, B)}
VALUES = [
    ("a + b", A + B), ("a - b", A - B), ("a*b", A * B), ("a/b", A / B), ("-b", -B), ("b^3", B**3), ("a^(1/2)", math.sqrt(A)),
    ("sin(a)", math.sin(A)), ("cos(b)", math.cos(B)), ("tan(a)", math.tan(A)), ("asin(a)", math.asin(A)),
    ("acos(a)", math.acos(A)), ("atan(b)", math.atan(B)), ("sqrt(a)", math.sqrt(A)), ("exp(b)", math.exp(B)),
    ("log(a)", math.log(A)), ("abs(b)", -B), ("atan2(a, b)", math.atan2(A, B)), ("P.x", A), ("P.y", B), ("(b, a)", complex(B, A)),
    ("a @ b", cmath.rect(A, B)), ("(P + a @ b).x", A + A * math.cos(B)), ("(P - a @ b).y", B - A * math.sin(B)),
]  # fmt: skip
# The sum of the sizes of the terms, by hand: brackets are multiplied out, a divisor is what it is.
SIZES = [
    ("a + b", A - B), ("a - b", A - B), ("-b", -B), ("a*(a + b)", A * (A - B)), ("(a - b)*b", (A - B) * -B),
    ("(a + b)/b", (A - B) / -B), ("a/(a + b)", A / abs(A + B)), ("sin(b)", abs(math.sin(B))), ("a*b - b*a", -2 * A * B),
]  # fmt: skip


@pytest.mark.parametrize(("text", "value"), VALUES)
def test_the_value_of_each_operation(text: str, value: complex) -> None:
    assert value_of(parse(text, vectors=True), NAMES) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(("text", "size"), SIZES)
def test_the_size_of_the_terms(text: str, size: float) -> None:
    assert size_of(parse(text), NAMES) == pytest.approx(size, rel=1e-14)


@pytest.mark.parametrize("text", ["sin(P)", "P^2", "P @ a", "atan2(a, P)", "(a, P)"])
def test_a_vector_where_a_number_must_stand_has_no_value(text: str) -> None:
    with pytest.raises(NoValue):
        value_of(parse(text, vectors=True), NAMES)


def test_a_number_stands_for_every_row_and_a_vector_for_none() -> None:
    assert real(2.0, 3).tolist() == [2.0, 2.0, 2.0]
    assert real(value_of(parse("2*row"), NAMES), 2).tolist() == [2.0, -4.0]
    with pytest.raises(NoValue):
        real(NAMES["P"], 3)


def test_what_is_known_of_a_part_is_not_computed_again() -> None:
    tree = parse("a + b*a")
    assert computed(tree, NAMES, {id(tree.args[1]): 5.0}) == A + 5.0
