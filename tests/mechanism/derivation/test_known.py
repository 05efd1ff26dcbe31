"""What is known of a point on a guide along an axis, and of a vector: on a level guide nothing moves up."""

import math
from fractions import Fraction
from types import SimpleNamespace

import pytest

from coursework.mechanism.derivation.segments import ZERO, Angle, _known, _polar
from coursework.variant.formula.reader import parse


@pytest.mark.parametrize(("angle", "known"), [
    ("0", (None, ZERO)), ("pi", (None, ZERO)), ("pi/2", (ZERO, None)), ("-pi/2", (ZERO, None)), ("pi/3", None), ("beta", None),
])  # fmt: skip
def test_a_guide_along_an_axis_leaves_no_velocity_across_it(angle, known):
    frame = SimpleNamespace(rails=[(parse("B"), parse(angle))])
    variant = SimpleNamespace(
        drive=[], links=[], frame=frame, holds=[], bindings=[], driven=None, values={"beta": math.pi / 5}, given=[],
    )  # fmt: skip
    found = _known(variant, {"A": parse("A"), "B": parse("B")}, {"A"})
    assert [(one.point, one.x, one.y) for one in found] == [("A", ZERO, ZERO), *([("B", *known)] if known else [])]


@pytest.mark.parametrize(("vector", "length", "base", "quarters"), [
    ("r @ phi", "r", "phi", 0), ("-(r @ phi)", "r", "phi", 2), ("r @ (phi - pi/2)", "r", "phi", 3), ("r @ (-pi/2)", "r", None, 3),
    ("(l, 0)", "l", None, 0), ("(0, h)", "h", None, 1), ("-(0, h)", "h", None, 3), ("(l, h)", None, None, 0),
    ("r", None, None, 0),
])  # fmt: skip
def test_a_vector_has_a_length_and_an_angle(vector, length, base, quarters):
    found = _polar(parse(vector, vectors=True))
    expected = parse(length) if length else None, Angle(parse(base) if base else None, Fraction(quarters, 2))
    assert found == (expected if length else None)
