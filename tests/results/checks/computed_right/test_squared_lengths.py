"""Position equations in squares of lengths, or between angles of points: told and limited as what they mean."""

import math

import numpy as np
import pytest

from coursework import parse_variant, solve
from tests.mechanisms.library import mechanism

FILE = "four-bar-by-squared-lengths"
FORMS = {
    "squares": (),
    "products": (("(xC - xB)^2", "(xC - xB)*(xC - xB)"), ("xB^2", "xB*xB")),
    "points": (("(xC - xB)^2 + (yC - yB)^2", "(C.x - B.x)^2 + (C.y - B.y)^2"), ("(xC - d)^2 + yC^2", "(C - D).x^2 + C.y*C.y")),
}


def checks_of(*changes, **values):
    run = solve(parse_variant(mechanism(FILE, *changes, **values)), quantities=["table", "checks"])
    return run.table, {check.code: check for check in run.checks}


@pytest.mark.parametrize("form", FORMS)
def test_drift_is_the_length_by_which_links_of_the_table_are_too_long(form):
    table, checks = checks_of(*FORMS[form])
    x_b, y_b, x_c, y_c = (table[name].to_numpy() for name in ("xB", "yB", "xC", "yC"))
    off = [np.hypot(x_c - x_b, y_c - y_b) - 0.4, np.hypot(x_c - 0.42, y_c) - 0.3, np.hypot(x_b, y_b) - 0.1]
    largest = max(float(np.max(np.abs(one))) for one in off)
    assert checks["DRIFT"].verdict == "COARSE"
    assert checks["DRIFT"].value == pytest.approx(largest / 0.1, rel=1e-9)
    assert f"(as a length) is {largest:.3g} m off" in checks["DRIFT"].sentence


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("share", "verdict"), [(0.9, "PASS"), (1.1, "FAIL")])
def test_a_start_is_open_by_the_length_of_the_rod_that_would_fit(form, share, verdict):
    """The limit is a millionth of the largest length, 0.42 m."""
    off = share * 0.42e-6
    x_b, y_b = 0.1 * math.cos(0.3), 0.1 * math.sin(0.3)
    x_c, y_c = 0.42 + 0.3 * math.cos(1.66597173472231), 0.3 * math.sin(1.66597173472231)
    way = complex(x_c - x_b, y_c - y_b) / 0.4  # C lies this far beyond the rod, turned about D as little as can be
    tangent = 1j * complex(x_c - 0.42, y_c) / 0.3
    c = complex(x_c, y_c) + tangent * off / (way.conjugate() * tangent).real
    starts = ((f'"{x_c!r} m"', f'"{c.real!r} m"'), (f'"{y_c!r} m"', f'"{c.imag!r} m"'))
    _, checks = checks_of(*FORMS[form], *starts)
    assert (checks["START"].verdict, checks["START"].unit) == (verdict, "m")
    assert checks["START"].value == pytest.approx(off, rel=1e-3)


def test_a_square_that_only_keeps_its_value_is_not_judged():
    _, checks = checks_of(("xB^2 + yB^2 - r1^2", "xB^2 + yB^2"))
    assert checks["START"].verdict == "PASS"
    assert "xB^2 + yB^2 = " in checks["START"].sentence


def test_an_angle_between_points_drifts_as_an_angle():
    run = solve(parse_variant(mechanism("slotted-lever-by-an-angle")), quantities=["table", "checks"])
    crank, lever = run.table["q1"].to_numpy(), run.table["q3"].to_numpy()
    largest = float(np.max(np.abs(lever - np.arctan2(0.2 + 0.1 * np.sin(crank), 0.1 * np.cos(crank)))))
    drift = next(check for check in run.checks if check.code == "DRIFT")
    assert (drift.value, drift.unit) == (pytest.approx(largest, rel=1e-9), "relative")
