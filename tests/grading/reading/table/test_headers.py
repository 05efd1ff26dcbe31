"""What a unit at the head of a column is in SI: a degree is a 180th of a half turn, rpm a turn in 60 s."""

import math

import pytest

from coursework.grading.reading.table.headers import PRINTED

PREFIXES = {"": 1.0, "m": 1e-3, "c": 1e-2, "k": 1e3}


@pytest.mark.parametrize(("si", "unit", "factor"), [
    ("rad", "deg", math.pi / 180), ("1/s", "deg/s", math.pi / 180), ("1/s", "rpm", math.tau / 60),
    *((si, f"{prefix}{si}", PREFIXES[prefix]) for si, prefixes in (
        ("rad", [""]), ("1/s", [""]), ("m", ["", "m", "c"]), ("m/s", ["", "m", "c"]), ("s", ["", "m"]), ("N", ["", "k"]),
        ("N·m", ["", "k"]),
    ) for prefix in prefixes),
])  # fmt: skip
def test_a_unit_in_si(si, unit, factor):
    assert PRINTED[si][unit] == pytest.approx(factor, rel=1e-15)
