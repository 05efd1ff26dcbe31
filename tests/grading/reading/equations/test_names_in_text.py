"""Names that only the size of their letters tells apart, and names in some row."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from coursework.grading.reading.equations import plain_text
from coursework.grading.reading.equations.names_in_text import spellings_of
from tests.grading.scenes import expected


@pytest.mark.parametrize(("written", "meant"), [
    ("u_1", "u1"), ("U_1", "U1"), ("u_{2}", "u2"), ("ω1", "om1"), ("ω_2", "om2"), ("omega_3", "om3"), ("W1", "W1"), ("W_1", "W1"),
    ("θ₁", "th1"), ("theta_3", "th3"), ("om1_i", "om1"), ("ω_2i", "om2"), ("rho1_k", "rho1"), ("vx_n", "vx"),
    ("ω_θ1", "om1"), ("omega_{th3}", "om3"), ("v_{ρ1}", "u1"),
    ("c_k", None), ("U1_i", None), ("om4", None), ("i", None),
])  # fmt: skip
def test_a_spelling_means_the_name_with_letters_of_its_size(written: str, meant: str | None) -> None:
    """A datum U1 beside a drive u1, W1 beside the rate om1: neither was known by any spelling but its own."""
    task = expected("cylinders")
    assert spellings_of(task.variant, task.grid.units).canonical(written) == meant


@pytest.mark.parametrize(
    ("text", "known", "name"), [("w(3)", set(), "w3"), ("w(3)", {"w"}, "w(3)"), ("w[3]", {"w"}, "w3"), ("w[7]", set(), "w[7]")]
)
def test_an_index_in_parentheses_may_be_a_factor(text: str, known: set[str], name: str) -> None:
    spellings: Any = SimpleNamespace(angle={"w3": "w3"}.get, known=known)
    assert plain_text._INDEXED.sub(lambda found: plain_text._indexed(found, spellings), text) == name
