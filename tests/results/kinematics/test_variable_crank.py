"""The slider-crank with a crank of variable length: the reference of [Pasika], row by row."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from coursework.equations.five_point import derivative, second_derivative
from coursework.mechanism.groups import AtDeadPoint, CannotAssemble, Guide, Pair, crank, rrp
from coursework.results.kinematics.variable_crank import (
    CrankLaw,
    SliderAnalogs,
    constant_speed_crank,
    outer_position,
    slider_crank,
)

Array = NDArray[np.float64]
PASIKA = json.loads((Path(__file__).parents[2] / "reference" / "pasika.json").read_text())
L1, L2, OMEGA, SPEED = 0.1, 0.4, PASIKA["inputs"]["omega1"], 0.647723
PHI = np.deg2rad([row["phi_deg"] for row in PASIKA["rows"]])
START = PASIKA["rows"][0]["exact_V0.647723"]["x_B"] / L1
EXACT, PRINTED = "exact_V0.647723", "polynomial_13"
POLYNOMIAL = np.polynomial.Polynomial(PASIKA["inputs"]["polynomial_13_coefficients_low_to_high_phi_in_rad"])


def column(reading: str, name: str) -> Array:
    return np.array([row[reading][name] for row in PASIKA["rows"]])


def synthesised(phi: Array) -> CrankLaw:
    return constant_speed_crank(phi, speed=SPEED, omega_1=OMEGA, crank=L1, rod=L2)


def assert_columns(reading: str, found: dict[str, Array], tolerance: float) -> None:
    for name, values in found.items():
        wanted = column(reading, name)
        assert np.abs(values - wanted).max() <= tolerance * max(np.abs(wanted).max(), 1e-3), name


def solved(r: Array, first: Array, second: Array) -> dict[str, Array]:
    found = slider_crank(PHI, r / L1, first / L1, second / L1, l2=L2 / L1, outer=START)
    return {
        "phi2_rad": found.phi2, "s_analog_from_start": found.s, "v_analog": found.v, "a_analog": found.a,
        "omega2_analog": found.omega_2, "eps2_analog": found.epsilon_2,
        "V_m_s": found.v * L1 * OMEGA, "A_m_s2": found.a * L1 * OMEGA**2,
        "omega2_rad_s": found.omega_2 * OMEGA, "eps2_rad_s2": found.epsilon_2 * OMEGA**2,
    }  # fmt: skip


def test_formulas_on_the_exact_crank() -> None:
    found = solved(column(EXACT, "r"), column(EXACT, "dr_dphi"), column(EXACT, "d2r_dphi2"))
    for name in ("a_analog", "A_m_s2"):  # zero in exact numbers
        assert np.abs(found.pop(name)).max() <= 1e-13
    assert_columns(EXACT, found, 1e-12)


def test_formulas_on_the_printed_polynomial() -> None:
    r, first, second = POLYNOMIAL(PHI), POLYNOMIAL.deriv()(PHI), POLYNOMIAL.deriv(2)(PHI)
    assert_columns(PRINTED, {"r": r, "dr_dphi": first, "d2r_dphi2": second}, 1e-12)
    found = solved(r, first, second)
    assert_columns(PRINTED, found, 1e-12)
    for name in ("V", "A"):
        unit = {"V": "V_m_s", "A": "A_m_s2"}[name]
        limits = (PASIKA["stats"][PRINTED][f"{name}_min"], PASIKA["stats"][PRINTED][f"{name}_max"])
        assert (found[unit].min(), found[unit].max()) == pytest.approx(limits, rel=1e-12)


def test_exact_synthesis() -> None:
    law = synthesised(PHI)
    # dx/dr is almost 0 at the start: there the last digit of x is magnified 70 times in r, and by root^-2, root^-4
    # of the small root 0.0058 m in its derivatives
    assert_columns(EXACT, {"r": law.r}, 1e-13)
    assert_columns(EXACT, {"dr_dphi": law.first}, 1e-10)
    assert_columns(EXACT, {"d2r_dphi2": law.second}, 1e-8)
    assert np.abs(law.second - column(EXACT, "d2r_dphi2"))[1:].max() <= 1e-12
    found = solved(law.r, law.first, law.second)
    assert found["V_m_s"] == pytest.approx(SPEED, rel=1e-13)
    assert np.abs(found["A_m_s2"]).max() <= 1e-12
    assert found["s_analog_from_start"][-1] * L1 == pytest.approx(0.0899615277777778, rel=1e-13)


def test_table_of_51_nodes() -> None:
    table = np.array(PASIKA["tabulated_51_nodes"]["rows"])
    phi = np.deg2rad(table[:, 0])
    lr = synthesised(phi).r / L1
    found = tabulated(phi, lr)
    mine = np.column_stack(
        [
            lr, np.rad2deg(found.phi2), (found.s - found.s[0]) * L1, found.omega_2 * OMEGA,
            found.v * L1 * OMEGA, found.epsilon_2 * OMEGA**2, found.a * L1 * OMEGA**2,
        ]
    )  # fmt: skip
    difference = np.abs(mine - table[:, 1:]).max(axis=0)
    # the five-point formulas magnify the last digit of lr by 1/h = 57, applied twice by 3300
    assert np.all(difference <= [1e-13, 1e-12, 1e-14, 1e-10, 1e-12, 1e-7, 1e-9])


def tabulated(phi: Array, lr: Array) -> SliderAnalogs:
    return slider_crank(phi, lr, derivative(phi, lr), second_derivative(phi, lr), l2=L2 / L1)


@pytest.mark.parametrize("nodes", [11, 21, 51, 101, 201])
def test_quality_of_tables(nodes: int) -> None:
    known = PASIKA["stats"]["tabulated_r_with_poxdf"][str(nodes)]
    phi = np.deg2rad(np.linspace(76.72, 126.72, nodes))
    found = tabulated(phi, synthesised(phi).r / L1)
    speed, acceleration = found.v * L1 * OMEGA, found.a * L1 * OMEGA**2
    assert (speed.min(), speed.max()) == pytest.approx((known["V_min"], known["V_max"]), abs=1e-11)
    assert np.abs(acceleration).max() == pytest.approx(known["A_absmax"], abs=1e-7)


def test_rounded_tables() -> None:
    phi = np.deg2rad(np.linspace(76.72, 126.72, 51))
    r = synthesised(phi).r
    coarse, fine = (tabulated(phi, np.round(r, digits) / L1).v * L1 * OMEGA for digits in (4, 6))
    assert (coarse.min(), coarse.max()) == pytest.approx((0.619, 0.699), abs=1e-3)
    assert (fine.min(), fine.max()) == pytest.approx((0.64758, 0.64784), abs=1e-5)


@settings(max_examples=60, deadline=None)
@given(
    st.floats(-3.0, 3.0), st.floats(0.5, 1.5), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(2.0, 6.0),
    st.floats(-0.4, 0.4),
)  # fmt: skip
def test_paper_and_groups_agree(phi: float, lr: float, first: float, second: float, l2: float, l3: float) -> None:
    paper = slider_crank(phi, lr, first, second, l2=l2, l3=l3)
    pin = crank(Pair((0.0, 0.0)), length=(lr, first, second), angle=phi, rate=1.0).meets
    group = rrp(pin, Guide(Pair((0.0, l3)), 0.0), length=l2, mode=1)
    assert group.rates is not None
    assert group.accelerations is not None
    assert group.coordinates[0, 0] == pytest.approx(paper.phi2[0], abs=1e-13)
    assert group.coordinates[0, 1] == pytest.approx(outer_position(lr, l2, l3) - paper.s[0], abs=1e-13)
    assert group.rates[0] == pytest.approx((paper.omega_2[0], -paper.v[0]), abs=1e-12)
    assert group.accelerations[0] == pytest.approx((paper.epsilon_2[0], -paper.a[0]), abs=1e-11)
    # (12) as the paper writes it
    f2, w2 = paper.phi2[0], paper.omega_2[0]
    printed = lr * (np.sin(phi) * np.cos(f2) - w2 * np.cos(phi) * np.sin(f2))
    printed -= first * (2 * np.cos(phi) * np.cos(f2) + w2 * np.sin(phi) * np.sin(f2))
    printed -= second * np.sin(phi) * np.cos(f2)
    assert paper.epsilon_2[0] == pytest.approx(printed / (l2 * np.cos(f2) ** 2), abs=1e-12)


@settings(max_examples=40, deadline=None)
@given(st.floats(0.02, 0.25), st.floats(-0.1, 0.1), st.sampled_from([1, -1]))
def test_synthesis_with_an_offset_holds_the_speed(speed: float, offset: float, mode: int) -> None:
    # about 77 deg crank and rod are perpendicular: on either side of it the pin takes another root
    phi = np.deg2rad(np.linspace(100.0, 120.0, 9) if mode == 1 else np.linspace(20.0, 40.0, 9))
    law = constant_speed_crank(phi, speed=speed, omega_1=2.0, crank=0.1, rod=0.4, offset=offset, mode=mode)
    found = slider_crank(phi, law.r / 0.1, law.first / 0.1, law.second / 0.1, l2=4.0, l3=offset / 0.1)
    assert law.r[0] == pytest.approx(0.1, rel=1e-12)
    assert found.v * 0.1 * 2.0 == pytest.approx(speed, rel=1e-10)
    assert np.abs(found.a).max() <= 1e-9


def test_what_the_formulas_refuse() -> None:
    with pytest.raises(CannotAssemble, match=r"row 1: the pin is off the slider’s line by 1, the rod is 0\.9 long; it"):
        slider_crank([0.0, np.pi / 2], 1.0, l2=0.9)
    with pytest.raises(AtDeadPoint, match="slider-crank is at a dead point at row 0: the rod is perpendicular to the sl"):
        slider_crank(np.pi / 2, 1.0, l2=1.0)
    with pytest.raises(ValueError, match="slider-crank, rod: a finite length above zero was expected, found -1"):
        slider_crank(0.0, 1.0, l2=-1.0)


def test_what_the_synthesis_refuses() -> None:
    asked = {"speed": SPEED, "omega_1": OMEGA, "crank": L1, "rod": L2}
    with pytest.raises(ValueError, match=r"mode -1 starts with 0\.\d+ m where 0\.1 m was asked for; take mode \+1"):
        constant_speed_crank(PHI, **asked, mode=-1)
    with pytest.raises(ValueError, match="assembly mode 0 does not exist"):
        constant_speed_crank(PHI, **asked, mode=0)
    with pytest.raises(ValueError, match=r"a turning crank were expected, found speed 0\.647723, offset 0, omega_1 0"):
        constant_speed_crank(PHI, **{**asked, "omega_1": 0.0})
    with pytest.raises(CannotAssemble, match="the pin is off the slider’s line by"):
        constant_speed_crank(PHI, **{**asked, "rod": 0.05})
    with pytest.raises(CannotAssemble, match="the line of the crank passes the slider at"):
        constant_speed_crank(PHI, **{**asked, "speed": -5.0})
    with pytest.raises(ValueError, match=r"the crank would have to be -0\.\d+ m long at row"):
        constant_speed_crank(np.deg2rad(np.linspace(150.0, 180.0, 8)), **{**asked, "speed": -1.5})
