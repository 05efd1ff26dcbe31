"""What is read of a number with its unit."""

import re
from fractions import Fraction

import pytest

from coursework.variant.formula import mass_units, motion_units
from coursework.variant.formula.units import UnitFault, known_units, read


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


@pytest.mark.parametrize(("text", "value"), [
    ("-1 m", -1.0), ("0 m", 0.0), ("0.00 mm", 0.0), ("0e7 m", 0.0), ("-1e-300 m", -1e-300), ("1e-400 m", None),
    ("-2e-400 m", None),
])  # fmt: skip
def test_a_number_that_is_nought_only_because_it_is_too_small_is_told(text, value):
    if value is None:
        with pytest.raises(UnitFault) as told:
            read(text, "m")
        assert told.value.message.key == "fault.V135"
    else:
        assert read(text, "m").value == value


# Length, time and mass of the units of which others are made; rad is a number.
BASE = {"m": (1, 0, 0), "s": (0, 1, 0), "kg": (0, 0, 1), "N": (1, -2, 1), "J": (2, -2, 1), "W": (2, -3, 1), "Pa": (-1, -2, 1),
        "rad": (0, 0, 0), "1": (0, 0, 0)}  # fmt: skip
PREFIXED = {"": 1, "k": 1000, "c": Fraction(1, 100), "m": Fraction(1, 1000), "M": 10**6}
SIZES = {"g": ("kg", Fraction(1, 1000)), "t": ("kg", 1000), "kg": ("kg", 1)}


def of_parts(unit):
    """The dimension and the size of a unit in SI, from its parts: "kN*cm" is 10 N*m."""
    dimension, size = [0, 0, 0], Fraction(1)
    for sign, part, power in re.findall(r"(^|[*/])([A-Za-z1]+)(?:\^(\d))?", unit):
        base, scale = SIZES.get(part) or next(
            (part[cut:], PREFIXED[part[:cut]]) for cut in (0, 1) if part[cut:] in BASE and part[:cut] in PREFIXED
        )
        times = int(power or 1) * (-1 if sign == "/" else 1)
        dimension = [one + times * other for one, other in zip(dimension, BASE[base], strict=True)]
        size *= Fraction(scale) ** times
    return tuple(dimension), size


def test_each_unit_has_the_dimension_and_the_size_of_its_parts():
    for unit, (exponents, _) in {**motion_units.KINDS, **mass_units.KINDS}.items():
        assert of_parts(unit)[0] == (*exponents, 0)[:3], unit
    latin = {unit: one for unit, one in mass_units.UNITS.items() if unit.isascii()}
    assert len(latin) > 40
    for unit, (size, kind) in latin.items():
        assert of_parts(unit) == ((*mass_units.KINDS[kind][0],), size), unit
    for unit, (_, shown) in {**motion_units.KINDS, **mass_units.KINDS}.items():
        for one in shown.split(", "):
            if one not in {"deg", "min", "deg/s", "rpm", "deg/s^2"}:
                assert of_parts(one)[0] == of_parts(unit)[0], one


def test_units_of_mass_are_advised_where_forces_are_asked_for_alone():
    plain, whole = known_units(), known_units(of_mass=True)
    assert whole.startswith(plain) and ("kg" in plain, "kg" in whole) == (False, True)
