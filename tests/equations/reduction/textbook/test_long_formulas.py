"""A printed formula has at most 2000 letters; a page says of a longer one that the velocity is solved numerically."""

import numpy as np
import pytest

import coursework
from coursework.equations.algebra.functions import sine
from coursework.equations.reduction.symbolic import local
from coursework.equations.reduction.textbook import solution
from coursework.equations.reduction.tidying import tidy
from coursework.report.pages import build_model
from coursework.report.pages.html import render_html
from coursework.variant.formula.tree import evaluate, spelled
from tests.hard.scenes import scene, solve
from tests.report.reading import html_text

ONE = "The velocity u follows from equation (1); its formula is too long to print, so it is solved numerically at every row."
TWO = (
    "The 2 velocities u and ω follow from equations (1) and (2); their formulas are too long to print, so they are solved "
    "numerically at every row."
)


NAME = "radius_of_the_driven_wheel"


def long_sum(terms: int, first: int = 1) -> str:
    """A length that is a sum of so many terms, each of about forty letters."""
    return " + ".join(f"{NAME}*sin({number}*phi)^2" for number in range(first, first + terms))


def one_by_one(terms: int) -> str:
    return scene(
        'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }',
        given=f'r = "0.1 m"\n{NAME} = "0.1 m"', drive='v = "2"',
        end=0.2, equations=[f"r*u = v*r*({long_sum(terms)})"],
    )  # fmt: skip


def two_by_two(terms: int) -> str:
    """Cramer's rule multiplies the sums of the rows: the formulas grow faster than what is written."""
    return scene(
        'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }\ny = { start = "0 m", rate = "w" }',
        given=f'r = "0.1 m"\n{NAME} = "0.1 m"', drive='v = "2"', end=0.2,
        equations=[
            f"u*({long_sum(terms)}) + w*({long_sum(terms, 2)}) = v*r^2",
            f"u*({long_sum(terms, 3)}) - w*({long_sum(terms, 4)}) = 0",
        ],
    )  # fmt: skip


def letters(run) -> int:
    return max((len(spelled(formula)) for block in run.solutions for _, formula in block), default=0)


@pytest.mark.parametrize(("written", "terms", "told"), [(one_by_one, 12, ONE), (two_by_two, 4, TWO)])
def test_a_formula_of_the_most_letters_is_printed_and_one_letter_more_is_not(written, terms, told, monkeypatch):
    size = letters(solve(written(terms)))
    assert 100 < size < solution.MOST_LETTERS == 2000
    for most, is_printed in ((size, True), (size - 1, False)):
        monkeypatch.setattr(solution, "MOST_LETTERS", most)
        run = solve(written(terms))
        page = html_text(render_html(build_model(run)))
        assert [bool(block) for block in run.solutions] == [is_printed]
        assert (told in page) is not is_printed
        assert "where it is never zero" not in page
        assert np.isfinite(run.columns()[1]).all()


def test_formulas_that_grow_are_printed_up_to_two_thousand_letters():
    runs = {terms: solve(two_by_two(terms)) for terms in (4, 16)}
    assert 0 < letters(runs[4]) <= 2000
    assert letters(runs[16]) == 0
    table = runs[16].motion
    a, b, c, d = (sum(0.1 * np.sin(k * table.column("phi")) ** 2 for k in range(first, first + 16)) for first in (1, 2, 3, 4))
    u, w = table.column("u"), table.column("w")
    assert np.max(np.abs(a * u + b * w - 2 * 0.01)) < 1e-12
    assert np.max(np.abs(c * u - d * w)) < 1e-12


@pytest.mark.parametrize("spare", [0, -1])
def test_an_expression_of_too_many_parts_is_not_rewritten_and_means_the_same(spare, monkeypatch):
    """(r + sin phi)(r - sin phi) has 11 parts; multiplied out it is r^2 - sin^2 phi."""
    order = coursework.solve("31").scene.equations.order
    length, swing = local("r1"), sine(local("phi1"))
    expression = (length + swing) * (length - swing)
    assert (expression.size, tidy.MOST_PARTS) == (11, 1000)
    monkeypatch.setattr(tidy, "MOST_PARTS", 11 + spare)
    for formula in (tidy.as_formula(expression, order), tidy.as_sum(expression, order)):
        assert (spelled(formula) == "r1^2 - sin(phi1)^2") == (spare == 0)
        assert evaluate(formula, {"r1": 2.0, "phi1": 0.3}) == pytest.approx(4 - np.sin(0.3) ** 2)
    assert len(tidy.product(expression, order).terms) == (2 if spare == 0 else 0)
