"""The dimension of each name of a variant; what has no unit, or is freed to find a slip, is an unknown of its own."""

from __future__ import annotations

import pytest

import coursework
from coursework.variant.dimensions.exponents import LENGTH, TIME
from coursework.variant.record.places import measures

VARIANT = coursework.load("v102")  # r1 in m, an angle phi2 in rad, a velocity u in m/s
DIMENSIONS = {"length": {LENGTH: 1}, "speed": {LENGTH: 1, TIME: -1}, "rate": {TIME: -1}, "time": {TIME: 1}, "number": {}}


@pytest.mark.parametrize(("name", "dimension", "path"), [
    ("r1", "length", ("given", "r1")), ("phi2", "number", ("coordinates", "phi2")), ("u", "speed", ("unknowns", "u")),
    ("t", "time", None), ("VMx", "speed", None), ("C", "length", None), ("w2", "rate", None), ("pi", "number", None),
])  # fmt: skip
def test_the_dimension_of_a_name(name: str, dimension: str, path: tuple[str, str] | None) -> None:
    known = measures(VARIANT)
    assert known[name] == DIMENSIONS[dimension]
    if path is not None:
        freed = measures(VARIANT, [path])
        assert freed[name] == {name: 1}
        others = known.keys() - {name, "w2" if name == "phi2" else name}  # the rate of an angle goes with it
        assert all(freed[other] == known[other] for other in others)
        elsewhere = measures(VARIANT, [("time", name)])
        assert elsewhere == known
