"""What a unit at the head of a column is in SI: a degree is a 180th of a half turn, rpm a turn in 60 s."""

import math

import pytest

from coursework.grading.reading.numbers import printed
from coursework.grading.reading.table.headers import PRINTED, read_head
from coursework.grading.reading.table.layout import layouts_of
from coursework.grading.reading.unit_names import unit_of

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


@pytest.mark.parametrize(("text", "unit"), [
    ("rad·s⁻¹", "1/s"), ("(m·s⁻¹)", "m/s"), ("м·с⁻¹", "m/s"), ("mm s^-1", "mm/s"), ("°·s⁻¹", "deg/s"), ("m/seg", "m/s"),
    ("s⁻¹", "1/s"), ("rad/sec", "1/s"), ("grados", "deg"), ("tr/min", "rpm"), ("kg/s", ""), ("m/sekel", ""),
])  # fmt: skip
def test_a_unit_as_countries_write_it(text, unit):
    assert unit_of(text) == unit


@pytest.mark.parametrize(("heads", "places"), [
    ("t phi s w Comment", {"t": 0, "phi": 1, "s": 2, "w": 3}), ("t s phi rad s m w 1/s", {"t": 0, "phi": 1, "s": 2, "w": 3}),
])  # fmt: skip
def test_a_column_s_is_no_unit_of_the_head_before_it_though_a_column_stands_empty(heads, places):
    """A remark without remarks made w1 stand over s: 40 of 60 points."""
    rows = [heads.split(), *([f"{k / 10}", "1.5", f"0.{k}7", "-2.4"] for k in range(1, 6))]
    columns = [("phi", "rad"), ("s", "m"), ("w", "1/s")]
    (layout,) = layouts_of([[printed(text, ".") for text in row] for row in rows], ".", columns)
    assert {head.candidates[0]: at for at, head in enumerate(layout.heads) if head.candidates} == places


@pytest.mark.parametrize(("head", "means"), [
    ("speed of the slider, m/s", ["v"]), ("speed of the slider", ["v"]), ("скорость ползуна, м/с", ["v"]),
    ("speed of the crank 1", ["w1"]), ("speed of the crank 3", []), ("angle of the crank", ["phi"]),
])  # fmt: skip
def test_words_mean_the_one_column_of_their_kind(head, means):
    known = [("phi", "rad"), ("w1", "1/s"), ("w2", "1/s"), ("v", "m/s")]
    assert [*read_head(head, known).told] == means
    assert means != ["v"] or read_head(head, [*known, ("u", "m/s")]).told == ()


@pytest.mark.parametrize(("unit", "turning", "moving", "both", "neither"), [
    # an angle · a speed · the speed of an angle · no quantity, each of link 2
    ("", "phi2", "", "w2", ""), ("rad", "phi2", "w2", "w2", ""), ("deg", "phi2", "w2", "w2", ""), ("m", "phi2", "", "w2", "s2"),
    ("1/s", "phi2", "w2", "w2", "w2"), ("deg/s", "phi2", "w2", "w2", "w2"), ("rad/s", "phi2", "w2", "w2", "w2"),
    ("m/s", "phi2", "u2", "w2", "u2"), ("mm/s", "phi2", "u2", "w2", "u2"),
])  # fmt: skip
def test_quantity_unit_and_number_together_mean_one_column_or_none(unit, turning, moving, both, neither):
    known = [("phi1", "rad"), ("w1", "1/s"), ("phi2", "rad"), ("w2", "1/s"), ("s2", "m"), ("u2", "m/s")]
    said = (("angle of link", turning), ("speed of link", moving), ("angular speed of link", both), ("for link", neither))
    for words, means in said:
        head = read_head(f"{words} 2{', ' if unit else ''}{unit}", known)
        assert (head.candidates or head.told) == ((means,) if means else ()), words
        assert read_head(f"{words} 2 and 1{', ' if unit else ''}{unit}", known).told == ()
