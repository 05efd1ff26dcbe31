"""A divisor that changes its sign between two rows is zero there, or passes a pole; what the equations of a file divide by."""

import math

import numpy as np
import pytest

import coursework
from coursework.results.checks.computed_right.divided import Division, _zero, divisions

STATES = np.array([[2.0, 1.0], [4.0, -3.0]])  # t and q: at a share x of the way 2 + 2x and 1 - 4x


@pytest.mark.parametrize(("value", "share"), [
    (lambda t, q: q, 0.25), (lambda t, q: t - 3.5, 0.75), (lambda t, q: q * abs(q), 0.25), (lambda t, q: 1 / (q - 1e-9), None),
    (lambda t, q: math.tan(math.pi * (t - 2) / 2 + 1e-3), None),
])  # fmt: skip
def test_where_between_two_rows_a_divisor_is_zero(value, share):
    found = _zero(value, STATES)
    assert found == (share if share is None else pytest.approx(share, abs=1e-6))


TWO_CRANKS = """
format = 1
title = "Two cranks"
[coordinates]
phi = { start = "0 rad", rate = "w" }
psi = { start = "0 rad", rate = "u" }
[time]
step = "0.02 s"
end = "0.4 s"
[drive]
w = "2 rad/s"
[[constraint]]
name = "gear"
equation = "u = w*(1 + sin(phi - at)/tan(phi - at))"
[ask]
quantities = ["table"]
"""


@pytest.mark.parametrize(("at", "row"), [(0.51, 13), (0.33, 9), (0.81, None)])
def test_a_divisor_of_a_file_passes_zero_where_its_angle_does(at, row):
    """phi = 2 t up to 0.8, rows 0.04 rad apart: tan(phi - 0.51) is zero at 0.255 s, 0.03 behind row 13 and 0.01 before row 14."""
    found = divisions(coursework.solve(coursework.parse_variant(TWO_CRANKS.replace("at)", f"{at})"))).results.evidence)
    digits = 16 + math.log10(math.tan(0.01) / math.tan(max(at, 0.8 - at)))
    by = Division("gear", f"tan(phi - {at})", pytest.approx(at / 2), row, pytest.approx(digits), False)
    assert found == ([by] if row else [])
