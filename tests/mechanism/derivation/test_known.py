"""What is known of a point on a guide along an axis: on a level one nothing moves up, on an upright one nothing aside."""

import math
from types import SimpleNamespace

import pytest

from coursework.mechanism.derivation.segments import ZERO, _known
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
