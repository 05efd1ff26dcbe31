"""Lengths written into the formulas of a file stay decimals in what is derived from them; halves of a textbook stay halves."""

from fractions import Fraction

import pytest

import coursework
from coursework.variant.formula.tree import number, spelled
from tests.drawing.plans.moving_groups import HEAD, crank, dyad
from tests.mechanisms.library import mechanism

# A slider-crank of a sewing machine, in no file of the catalogue.
NEEDLE = HEAD.format(
    name="needle bar", drive='w1 = "6"', step="0.01 s", end="0.1 s", hinges='["P"]', rails="",
    coordinates='phi1 = { start = "20 deg", rate = "w1" }\nphi2 = { rate = "w2", unit = "rad" }\n'
    's3 = { rate = "u3", unit = "m" }',
    points='P = "(0, 0)"\nK = "(0, 0)"',
    groups=crank("P", "R", "{r}", "phi1")
    + dyad("RRP", '["R"]', '"T"', '["0.25"]', '["phi2", "s3"]', 'guide = { through = "K", angle = "0" }\n'),
)  # fmt: skip


def solved(text):
    run = coursework.solve(coursework.parse_variant(text))
    return {name: spelled(formula) for pairs in run.solutions for name, formula in pairs}


@pytest.mark.parametrize(("length", "factor"), [("0.02", "0.02"), ("0.0375", "0.0375"), ("0.1/3", "w1*sin(phi1)/30")])
def test_a_length_is_printed_as_the_file_gave_it(length, factor):
    found = solved(NEEDLE.replace("{r}", length))
    term = factor if "/" in factor else f"{factor}*w1*sin(phi1)"
    assert found["u3"] == f"-({term} + 0.25*w2*sin(phi2))"
    if "/" not in factor:
        assert found["w2"].startswith(f"-{spelled(number(Fraction(length) * 4))}*w1*cos(phi1)")


def test_a_quotient_of_two_lengths_that_is_no_decimal_keeps_both():
    found = solved(NEEDLE.replace("{r}", "0.08").replace("0.25", "0.27"))
    assert found["w2"] == "-0.08*w1*cos(phi1)/(0.27*cos(phi2))"


def test_a_root_stands_in_the_denominator_as_a_root():
    """By hand: v = -r w (sin q + cos q (r sin q - e) / sqrt(l^2 - (r sin q - e)^2))."""
    root = "sqrt(l^2 - e^2 - r^2*sin(q1)^2 + 2*e*r*sin(q1))"
    terms = f"(r*sin(q1)*cos(q1)/{root} - e*cos(q1)/{root} + sin(q1))"
    assert solved(mechanism("slider-crank-by-a-root")) == {"v": f"-r*w1*{terms}"}


def test_half_a_link_is_no_decimal():
    shown = str([spelled(formula) for pairs in coursework.solve("31").solutions for _, formula in pairs])
    assert "0.5" not in shown
