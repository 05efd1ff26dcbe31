"""What an equation may be off by in a row: round-off, and more where equations nearly agree."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.computed_right import equations
from coursework.results.checks.computed_right.equations import every_row


def evidence(off, used=("b", "c")):
    """Return three rows of equations a, b and c, of which c is off in the second, and a, which is left out, by one half."""
    relative = np.zeros((3, 3))
    relative[0, 0], relative[1, 2], relative[2, 1] = 0.5, off, 0.9e-11
    return SimpleNamespace(
        residuals=(("a", "b", "c"), relative), used=used, agreed=True, motion=SimpleNamespace(t=np.array([0.0, 0.5, 1.0]))
    )


@pytest.mark.parametrize(("off", "near", "verdict", "limit"), [
    (0.99e-11, 1e-11, "PASS", 1e-11), (1.01e-11, 1e-11, "FAIL", 1e-11), (1.99e-11, 2e-11, "PASS", 2e-11),
    (2.01e-11, 2e-11, "FAIL", 2e-11),
])  # fmt: skip
def test_an_equation_may_be_off_by_round_off_or_by_what_its_row_allows(off, near, verdict, limit, monkeypatch):
    monkeypatch.setattr(equations, "_limits", lambda _: np.array([5e-11, near, 1e-11]))
    found = every_row(evidence(off))
    assert (found.verdict, found.value, found.limit, found.column, found.row) == (verdict, off, limit, "c", 2)
    assert [(str(one[0].values["name"]), one[1]) for one in found.rows] == [("a", 0.5)]
    values = found.sentence.values
    assert verdict == "PASS" or (values["name"], values["row"], values["time"]) == ("c", 2, 0.5)


def test_the_row_that_is_worst_for_what_it_allows_is_told(monkeypatch):
    """By 4e-11 of 5e-11 in the second row, by 0.9e-11 of 1e-11 in the third: the third is nearer to its limit."""
    monkeypatch.setattr(equations, "_limits", lambda _: np.array([1e-11, 5e-11, 1e-11]))
    found = every_row(evidence(4e-11))
    assert (found.verdict, found.value, found.limit, found.column, found.row) == ("PASS", 0.9e-11, 1e-11, "b", 3)


def test_where_nothing_is_solved_no_row_is_judged():
    assert every_row(evidence(1.0, used=())).verdict == "SKIP"


@pytest.mark.parametrize(("condition", "limit"), [(1.0, 1e-11), (0.9e5, 1e-11), (1e7, 1e-9), (1e9, 1e-7), (1e12, 1e-6)])
def test_what_a_row_allows_grows_with_its_condition_up_to_six_digits(condition, limit, monkeypatch):
    monkeypatch.setattr(equations, "condition_numbers", lambda _: np.array([condition]))
    assert equations._limits(None) == pytest.approx([limit])
