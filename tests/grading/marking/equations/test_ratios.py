"""Velocities below strokes are multiplied out where the line stays one that can be judged."""

from __future__ import annotations

import pytest

from coursework.grading.marking.equations.other_forms import multiplied_out
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import spelled


@pytest.mark.parametrize(("text", "shown"), [
    ("w4/w3 - 2*k", "w4 - 2*k*w3"), ("w4/k - w3", "w4/k - w3"), ("-w4/(w3 + w1) + 1", "-w4 + w3 + w1"),
    ("w4/w3 - w1/w3", "w4 - w1"), ("w4/w3/w3 - 1", "w4 - w3*w3"), ("sin(w4/w3)", "sin(w4/w3)"),
])  # fmt: skip
def test_what_stands_below_goes_to_the_other_terms(text: str, shown: str) -> None:
    found = spelled(multiplied_out(parse(text), {"w1", "w3", "w4"}))
    assert found.replace("(", "").replace(")", "").replace("1*", "") == shown.replace("(", "").replace(")", "")


@pytest.mark.parametrize(("terms", "is_left"), [(15, False), (40, True)])
def test_a_long_sum_is_not_written_out_in_front_of_every_term(terms: int, is_left: bool) -> None:
    """So many names below a stroke are as many times as long: 29 nodes 15 times are short of 500, 79 nodes 40 times are not."""
    line = parse(f"w4/({' + '.join(['w3'] * terms)})" + " + w1" * terms)
    assert (multiplied_out(line, {"w1", "w3", "w4"}) is line) == is_left
