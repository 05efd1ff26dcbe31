"""What is read of a number with its unit."""

from fractions import Fraction

import pytest

from coursework.variant.formula.units import read


@pytest.mark.parametrize(
    ("text", "quarters"),
    [("270 deg", 3), ("−90°", -1), ("0 deg", 0), ("45 deg", None), ("90 rad", None), ("90 m", None), ("1.8e2 deg", 2)],
)
def test_angles_in_whole_right_angles_are_known_as_such(text, quarters):
    """So that the cosine of 90° is nought and not 6e-17."""
    assert read(text).quarters == (None if quarters is None else Fraction(quarters))


@pytest.mark.parametrize(
    ("text", "wanted", "value", "si"),
    [("4 kg", "kg", 4, "kg"), ("2.5 kN", "N", 2500, "N"), ("3 t", "kg", 3000, "kg"), (2, "kg", 2, "")],
)
def test_a_size_with_or_without_mass_is_read_where_it_is_wanted(text, wanted, value, si):
    found = read(text, wanted)
    assert (found.value, found.si) == (pytest.approx(value), si)
