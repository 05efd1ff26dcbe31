"""Invariants of a stroke: both ways, the constant crank of the reference, and the trap of the printed S_a."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursework.results.kinematics.invariants import (
    crank_stroke,
    from_analogs,
    from_true,
    to_analogs,
    to_true,
)
from coursework.results.kinematics.variable_crank import slider_crank

PASIKA = json.loads((Path(__file__).parents[2] / "reference" / "pasika.json").read_text())
CASES = PASIKA["constant_crank"]["cases"]


def column(case: dict[str, Any], name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([row[name] for row in case["rows"]], dtype=np.float64)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"offset {case['lambda3']}")
def test_every_row_of_the_constant_crank(case: dict[str, Any]) -> None:
    stroke = crank_stroke(case["lambda2"], case["lambda3"])
    assert stroke.length == pytest.approx(case["stroke_S_analog"], rel=1e-14)
    assert stroke.angle == pytest.approx(case["Phi"], rel=1e-14)
    assert stroke.outer_angle == pytest.approx(case["phi_outer"], abs=1e-14)
    assert stroke.inner_angle == pytest.approx(case["phi_inner"], rel=1e-14)
    assert stroke.outer_position == pytest.approx(case["outer_extreme_position_sqrt((1+l2)^2-l3^2)"], rel=1e-14)

    analogs = slider_crank(column(case, "phi_rad"), 1.0, l2=case["lambda2"], l3=case["lambda3"])
    invariants = from_analogs(analogs.s, analogs.v, analogs.a, stroke=stroke.length, angle=stroke.angle)
    found = {
        "s_analog": analogs.s, "v_analog": analogs.v, "a_analog": analogs.a, "phi2_rad": analogs.phi2,
        "omega2_analog": analogs.omega_2, "eps2_analog": analogs.epsilon_2,
        "a_k": invariants.a, "b_k": invariants.b, "c_k": invariants.c,
    }  # fmt: skip
    for name, values in found.items():
        wanted = column(case, name)
        assert np.abs(values - wanted).max() <= 1e-14 * max(1.0, np.abs(wanted).max()), name


def test_only_the_stroke_brings_a_k_to_one() -> None:
    stroke = crank_stroke(4.0)
    phi = stroke.outer_angle + np.linspace(0.0, 1.0, 11) * stroke.angle
    analogs = slider_crank(phi, 1.0, l2=4.0)
    right = from_analogs(analogs.s, analogs.v, analogs.a, stroke=stroke.length, angle=stroke.angle)
    printed = from_analogs(analogs.s, analogs.v, analogs.a, stroke=stroke.outer_position, angle=stroke.angle)
    assert (right.a[0], right.a[-1]) == pytest.approx((0.0, 1.0), abs=1e-15)
    assert printed.a[-1] == pytest.approx(2.0 / 5.0, abs=1e-15)


def test_invariants_of_the_printed_polynomial() -> None:
    interval = PASIKA["interval_invariants"]
    rows = [row["polynomial_13"] for row in PASIKA["rows"]]
    scale = {"stroke": interval["S_m_exact"], "angle": interval["Phi_rad"], "omega_1": PASIKA["inputs"]["omega1"]}
    s, v, a = ([row[name] for row in rows] for name in ("displacement_from_start", "V_m_s", "A_m_s2"))
    found = from_true(s, v, a, **scale)
    wanted = [row["polynomial_13_invariants_with_exact_S"] for row in PASIKA["rows"]]
    for name, values in (("a_k", found.a), ("b_k", found.b), ("c_k", found.c)):
        expected = np.array([row[name] for row in wanted])
        assert np.abs(values - expected).max() <= 1e-13 * np.abs(expected).max()
    assert (found.b.min(), found.b.max()) == pytest.approx((1.00113, 1.02728), abs=1e-5)
    assert (found.c.min(), found.c.max()) == pytest.approx((0.0073, 0.0544), abs=1e-4)


NUMBERS = st.lists(st.floats(-10.0, 10.0), min_size=3, max_size=3)


@settings(max_examples=60, deadline=None)
@given(NUMBERS, st.floats(0.01, 10.0), st.floats(0.1, 6.0), st.floats(0.1, 100.0), st.floats(-50.0, 50.0))
def test_both_ways(known: list[float], stroke: float, angle: float, omega: float, epsilon: float) -> None:
    s, v, a = (np.array([entry]) for entry in known)
    invariants = from_analogs(s, v, a, stroke=stroke, angle=angle)
    for found, wanted in zip(to_analogs(invariants), (s, v, a), strict=True):
        assert found == pytest.approx(wanted, rel=1e-14)
    again = from_true(*to_true(invariants, omega, epsilon), stroke=stroke, angle=angle, omega_1=omega, epsilon_1=epsilon)
    slack = 1e-13 * (1.0 + abs(epsilon) / omega**2 * np.abs(invariants.b) * angle)
    assert again.a == pytest.approx(invariants.a, rel=1e-13)
    assert again.b == pytest.approx(invariants.b, rel=1e-13)
    assert np.abs(again.c - invariants.c) <= slack * (1.0 + np.abs(invariants.c))


def test_constant_omega_gives_the_formulas_with_the_time_of_a_stroke() -> None:
    invariants = from_analogs([0.2], [0.3], [0.4], stroke=0.5, angle=2.0)
    time = 2.0 / 8.0
    s, velocity, acceleration = to_true(invariants, 8.0)
    assert s == pytest.approx([0.2])
    assert velocity == pytest.approx(invariants.b * 0.5 / time)
    assert acceleration == pytest.approx(invariants.c * 0.5 / time**2)


@pytest.mark.parametrize(
    ("rod", "offset"),
    [(1.0, 0.0), (0.5, 0.0), (2.0, 1.0), (2.0, -1.5), (np.nan, 0.0)],
)
def test_a_crank_that_cannot_turn_has_no_stroke(rod: float, offset: float) -> None:
    with pytest.raises(ValueError, match=r"^slider-crank: the crank turns fully only if rod - crank > \|offset\|"):
        crank_stroke(rod, offset)


@pytest.mark.parametrize(("stroke", "angle", "name"), [(0.0, 1.0, "stroke S"), (1.0, -1.0, "crank angle Phi")])
def test_scales_must_be_above_zero(stroke: float, angle: float, name: str) -> None:
    with pytest.raises(ValueError, match=f"^invariants: a {name} above zero was expected, found "):
        from_analogs([0.0], [0.0], [0.0], stroke=stroke, angle=angle)
