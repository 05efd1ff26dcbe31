"""A printed formula has at most 2000 letters; a page says of a longer one that the velocity is solved numerically."""

import numpy as np
import pytest

from coursework.formula.tree import spelled
from coursework.reduction import solution
from coursework.report import build_model
from coursework.report.html import render_html
from tests.hard.scenes import scene, solve
from tests.report.reading import html_text

ONE = "The velocity u follows from equation (1); its formula is too long to print, so it is solved numerically at every row."
TWO = (
    "The 2 velocities u and ω follow from equations (1) and (2); their formulas are too long to print, so they are solved "
    "numerically at every row."
)


def long_sum(terms: int) -> str:
    """A length that is a sum of so many terms, each of about twenty letters: r*sin(7*phi)^2."""
    return " + ".join(f"r*sin({number}*phi)^2" for number in range(1, terms + 1))


def one_by_one(terms: int) -> str:
    return scene(
        'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }', given='r = "0.1 m"', drive='v = "2"',
        end=0.2, equations=[f"r*u = v*r*({long_sum(terms)})"],
    )  # fmt: skip


def two_by_two(terms: int) -> str:
    return scene(
        'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }\ny = { start = "0 m", rate = "w" }',
        given='r = "0.1 m"', drive='v = "2"', end=0.2,
        equations=[f"3*u + w = v*({long_sum(terms)})", "u - 2*w = v*r"],
    )  # fmt: skip


def letters(run) -> int:
    return max((len(spelled(formula)) for block in run.solutions for _, formula in block), default=0)


@pytest.mark.parametrize(("written", "told"), [(one_by_one, ONE), (two_by_two, TWO)])
def test_a_formula_of_the_most_letters_is_printed_and_one_letter_more_is_not(written, told, monkeypatch):
    size = letters(solve(written(12)))
    assert 100 < size < solution.MOST_LETTERS == 2000
    for most, is_printed in ((size, True), (size - 1, False)):
        monkeypatch.setattr(solution, "MOST_LETTERS", most)
        run = solve(written(12))
        page = html_text(render_html(build_model(run)))
        assert [bool(block) for block in run.solutions] == [is_printed]
        assert (told in page) is not is_printed
        assert "where it is never zero" not in page
        assert np.isfinite(run.columns()[1]).all()


def test_formulas_that_grow_are_printed_up_to_two_thousand_letters():
    sizes = {terms: letters(solve(one_by_one(terms))) for terms in (20, 60, 140)}
    assert 0 < sizes[20] < sizes[60] <= 2000
    assert sizes[140] == 0
    table = solve(one_by_one(140)).motion
    phi = table.column("phi")
    wanted = 2 * sum(0.1 * np.sin(number * phi) ** 2 for number in range(1, 141))
    assert np.max(np.abs(table.column("u") - wanted)) < 1e-12
