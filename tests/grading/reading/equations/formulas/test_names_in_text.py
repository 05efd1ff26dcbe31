"""Names that only the size of their letters tells apart, and names in some row."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from coursework.grading.reading.equations.formulas import plain_text
from coursework.grading.reading.equations.formulas.names_in_text import spellings_of
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


@pytest.mark.parametrize(("task", "written", "meant"), [
    # C slides along y in v102 with the only speed of a point that is asked for; no point's speed is asked for in variant 31
    ("v102", "V_C", "u"), ("v102", "v_Cy", "u"), ("v102", "V_Cx", None), ("v102", "v_y", "u"), ("v102", "v_x", None),
    ("31", "V_C", None), ("31", "V_Cy", None), ("31", "v_y", None), ("31", "V_My", "VMy"), ("31", "V_Mx", "VMx"),
    ("whitworth", "V_F", "u5"), ("whitworth", "V_A", None),  # F is a pin on a guide of the frame
    ("31", "omega_AB", "w2"), ("31", "w_BA", "w2"), ("31", "ω_BC", "w3"), ("31", "w_AM", None), ("31", "w_AA", None),
    ("v108", "w_theta", "wc"), ("v107", "v_s", "u"), ("v107", "w_s", None), ("31", "v_phi2", None), ("31", "w_phi4", None),
])  # fmt: skip
def test_speeds_of_points_and_of_links_mean_what_the_task_calls_them(task: str, written: str, meant: str | None) -> None:
    asked = expected(task)
    assert spellings_of(asked.variant, asked.grid.units).canonical(written) == meant


@pytest.mark.parametrize(("task", "angles", "rates"), [
    # phi4 has no letter in the task's data, but its speed is a column
    ("31", "alpha phi1 phi2 phi3", "phi1 phi2 phi3 phi4 xm ym"), ("v102", "alpha phi1 phi2 phi3", "phi1 phi2 phi3 xm yc ym"),
    ("cylinders", "e th1 th2 th3", "rho1 rho2 th1 th2 th3"), ("example-5", "theta1", "s2 s3 theta1"),
])  # fmt: skip
def test_angles_and_what_has_a_rate(task: str, angles: str, rates: str) -> None:
    asked = expected(task)
    found = spellings_of(asked.variant, asked.grid.units)
    assert (" ".join(sorted(found.angles)), " ".join(sorted(found.rates))) == (angles, rates)


@pytest.mark.parametrize(
    ("text", "known", "name"), [("w(3)", set(), "w3"), ("w(3)", {"w"}, "w(3)"), ("w[3]", {"w"}, "w3"), ("w[7]", set(), "w[7]")]
)
def test_an_index_in_parentheses_may_be_a_factor(text: str, known: set[str], name: str) -> None:
    spellings: Any = SimpleNamespace(angle={"w3": "w3"}.get, known=known)
    assert plain_text._INDEXED.sub(lambda found: plain_text._indexed(found, spellings), text) == name
