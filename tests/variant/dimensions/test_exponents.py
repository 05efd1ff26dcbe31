"""Exponents of length, time and mass: sums of them, equations between them solved with fractions, and their names."""

from fractions import Fraction

import pytest

from coursework.variant.dimensions.exponents import (
    LENGTH,
    MASS,
    NUMBER,
    TIME,
    System,
    added,
    dimension_of,
    is_known,
    si_unit,
    symbols,
    unit_like,
    units_shown,
    what,
)  # fmt: skip


@pytest.mark.parametrize(("unit", "dimension"), [
    ("m", {LENGTH: 1}), ("m/s", {LENGTH: 1, TIME: -1}), ("1/s", {TIME: -1}), ("rad", {}), ("kg", {MASS: 1}), ("s", {TIME: 1}),
    ("N", {MASS: 1, LENGTH: 1, TIME: -2}), ("kg*m^2", {MASS: 1, LENGTH: 2}),
])  # fmt: skip
def test_a_unit_has_a_dimension_and_is_the_unit_of_it(unit, dimension):
    assert dimension_of(unit) == dimension
    assert si_unit(dimension) == unit
    assert is_known(dimension)


@pytest.mark.parametrize(("first", "second", "times", "product"), [
    ({LENGTH: 1}, {TIME: 1}, -1, {LENGTH: 1, TIME: -1}), ({LENGTH: 1}, {LENGTH: 1}, -1, {}), ({LENGTH: 1}, {}, 2, {LENGTH: 1}),
    ({LENGTH: 1, "a": 2}, {"a": 1, LENGTH: 3}, -2, {LENGTH: -5}), ({}, {"a": 1}, Fraction(1, 2), {"a": Fraction(1, 2)}),
])  # fmt: skip
def test_exponents_are_added_and_none_is_kept_that_is_zero(first, second, times, product):
    assert added(first, second, times) == product


def test_equations_are_solved_as_they_come():
    """a^2 = m^2/s, b = a/s^(1/2) and c = b: a = m s^(-1/2), so b and c are m/s; then b = m cannot be."""
    system = System()
    assert system.equal({"a": 2}, {LENGTH: 2, TIME: -1}) and system.equal({"b": 1}, {"a": 1, TIME: Fraction(-1, 2)})
    assert system.equal({"c": 3}, {"b": 3}) and not system.equal({"b": 1}, {LENGTH: 1}) and system.equal({"b": 2}, {"b": 2})
    assert system.reduced({"a": 1}) == {LENGTH: 1, TIME: Fraction(-1, 2)}
    assert system.reduced({"c": 1, LENGTH: -1}) == {TIME: -1}
    assert [type(exponent) for exponent in system.reduced({"c": 1}).values()] == [int, int]
    assert not is_known({"a": 1}) and is_known(system.reduced({"c": 1})) and system.equal({"d": -1}, {TIME: 1})
    assert system.reduced({"d": 1}) == {TIME: -1}


@pytest.mark.parametrize(("dimension", "text", "unit"), [
    ({LENGTH: 2, TIME: -1}, "m^2/s", "m^2/s"), ({TIME: -3}, "1/s^3", "1/s^3"), ({MASS: 1, LENGTH: 3}, "kg·m^3", "kg·m^3"),
    ({LENGTH: Fraction(1, 2)}, "m^(1/2)", "m^(1/2)"), ({MASS: -1, LENGTH: 1, TIME: -1}, "m/(kg·s)", "m/(kg·s)"), ({}, "1", None),
])  # fmt: skip
def test_what_has_no_unit_is_written_in_symbols(dimension, text, unit):
    assert symbols(dimension) == text
    if unit is not None:
        assert si_unit(dimension) == "" and units_shown(dimension) == unit
        assert what(dimension).values["unit"] == unit


def test_what_has_a_unit_is_called_by_its_quantity():
    assert what(NUMBER).key == "quantity.angle_or_number" and what(NUMBER, "quantity.rad").key == "quantity.rad"
    assert what({LENGTH: 1}) == what(dimension_of("m")) != what(dimension_of("s"))


@pytest.mark.parametrize(("unit", "of", "like"), [
    ("mm", "m/s", "mm/s"), ("m/s", "m", "m"), ("cm/s", "m", "cm"), ("mm/s^2", "m/s", "mm/s"), ("m/s", "m/s^2", "m/s^2"),
    ("mm/s", "m/s^2", "mm/s^2"), ("kg", "m", "m"), ("deg", "1/s", "deg/s"), ("deg/s", "rad", "deg"), ("s", "m", "m"),
    ("мм", "m/s", "мм/с"), ("м/с", "m", "м"), ("кг", "m", "м"), ("кг", "m/s", "м/с"), ("град", "s", "с"),
])  # fmt: skip
def test_the_unit_nearest_to_another_of_the_same_size_and_alphabet(unit, of, like):
    assert unit_like(unit, dimension_of(of)) == like


def test_nothing_is_near_to_what_has_no_unit():
    assert unit_like("m", {LENGTH: 7}) == ""
