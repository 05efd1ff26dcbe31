"""Tangents of what a fraction is reduced about are written as sines over cosines; all else stays."""

from __future__ import annotations

import pytest

from coursework.equations.algebra.calculus import _by_sines, divisors
from coursework.equations.algebra.expression import Expression
from coursework.equations.algebra.functions import call, cosine, sine
from coursework.equations.reduction.symbolic import symbol

A, P, Q = symbol("a"), symbol("p"), symbol("q")


def tangent(angle: Expression) -> Expression:
    return call("tan", angle)


@pytest.mark.parametrize(
    ("part", "found"),
    [
        (A * tangent(P) + tangent(Q), A * (sine(P) / cosine(P)) + tangent(Q)),
        (tangent(P + Q) ** 2, (sine(P + Q) / cosine(P + Q)) ** 2),
        (sine(tangent(P)), sine(sine(P) / cosine(P))),
        (tangent(tangent(P)), sine(sine(P) / cosine(P)) / cosine(sine(P) / cosine(P))),
        (tangent(Q), tangent(Q)), (sine(P) * A, sine(P) * A), (P, P), (A, A),
    ],
)  # fmt: skip
def test_only_tangents_about_the_name_are_parted(part: Expression, found: Expression) -> None:
    assert _by_sines(part, frozenset({P})) == found


def test_a_tangent_divides_by_its_cosine_and_what_stands_below_by_itself() -> None:
    assert divisors(A / (P + Q) + tangent(P)) == [P + Q, cosine(P)] or divisors(A / (P + Q) + tangent(P)) == [cosine(P), P + Q]
    assert divisors(A * (P + Q) ** 2) == []
