"""The digits that equations, lengths and divisors leave, each just inside and just outside of six, of numbers by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.computed_right import conditioning
from coursework.results.checks.computed_right.conditioning import _condition, _far_apart, _of_equations
from coursework.results.checks.computed_right.divided import Division
from coursework.results.checks.result import Finding

MOTION = SimpleNamespace(t=np.array([0.0, 0.5, 1.0]))


@pytest.mark.parametrize(("number", "verdict", "digits"), [
    (0.9e10, "PASS", 6.0457574906), (1.1e10, "FAIL", 5.9586073148), (10.0, "PASS", 15.0), (1e17, "FAIL", 0.0),
    (np.inf, "FAIL", 0.0),
])  # fmt: skip
def test_the_worst_row_is_told_with_its_digits_and_its_number(number, verdict, digits, monkeypatch):
    monkeypatch.setattr(conditioning, "condition_numbers", lambda _: np.array([3.0, number, 2.0]))
    monkeypatch.setattr(conditioning, "_of_positions", lambda _: None)
    found = _of_equations(SimpleNamespace(motion=MOTION))
    assert (found.verdict, found.value, found.limit, found.row) == (verdict, pytest.approx(digits), 6.0, 2)
    assert [value for _, value, _ in found.rows] == [number, 3.0]
    assert f"{int(digits * 10) / 10:.1f}" in found.sentence and "0.5 s" in found.sentence and "row 2" in found.sentence


@pytest.mark.parametrize(
    ("left", "alike", "is_told"), [(7.9, 16.0, True), (8.1, 16.0, False), (6.9, 9.0, True), (7.1, 9.0, False)]
)
def test_lengths_are_told_where_they_cost_two_digits_more(left, alike, is_told, monkeypatch):
    """The equations leave ten digits, and lengths that were alike so many; with these lengths fewer are left."""
    monkeypatch.setattr(conditioning, "condition_numbers", lambda _: np.array([1.0, 1e6, 1.0]))
    monkeypatch.setattr(conditioning, "_of_positions", lambda _: (left, 2, "phi", alike))
    monkeypatch.setattr(conditioning, "_far_apart", lambda _, *found: found)
    found = _of_equations(SimpleNamespace(motion=MOTION))
    assert found == (left, 2, "phi") if is_told else found.row == 2


@pytest.mark.parametrize(("digits", "verdict"), [(6.01, "PASS"), (5.99, "FAIL")])
def test_lengths_that_leave_six_digits_pass(digits, verdict):
    found = _far_apart(SimpleNamespace(motion=MOTION), digits, 1, "phi")
    assert (found.verdict, found.value, found.limit, found.column, found.row) == (verdict, digits, 6.0, "phi", 2)
    assert "row 2" in found.sentence and "0.5 s" in found.sentence


@pytest.mark.parametrize(("digits", "is_own", "error", "verdict", "headline"), [
    (5.9, False, 0.0, "FAIL", True), (6.1, False, 0.049, "PASS", False), (6.1, False, -0.051, "PASS", True),
    (6.1, True, 0.0, "PASS", True),
    (None, False, 0.0, "PASS", False),
])  # fmt: skip
def test_a_divisor_that_becomes_nought_is_told_first_unless_the_table_is_close(
    digits, is_own, error, verdict, headline, monkeypatch
):
    """Of two divisors the one that leaves less is told; with a coordinate of its own many motions may meet there."""
    monkeypatch.setattr(conditioning, "_of_equations", lambda _: Finding("PASS", "Found.", 12.0))
    both = [Division("a", "x", 0.7, 2, 9.0, False), Division("b", "y", 0.6, 2, digits or 0.0, is_own)]
    monkeypatch.setattr(conditioning, "divisions", lambda _: both if digits is not None else [])
    evidence = SimpleNamespace(
        used=("a",), equations=SimpleNamespace(equations=[SimpleNamespace(name="a")]), compared=3, errors=np.array([[0.0, error]])
    )
    found = _condition(evidence)
    assert (found.verdict, bool(found.headline)) == (verdict, headline)
    assert found.value == (digits if verdict == "FAIL" else 12.0)
    assert digits is None or ("b" in found.sentence and "0.6 s" in found.sentence)
    assert digits is None or verdict == "FAIL" or "between rows 2 and 3" in found.sentence
    evidence.used = ()
    assert _condition(evidence).verdict == "SKIP"
