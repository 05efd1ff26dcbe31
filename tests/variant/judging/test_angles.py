"""Which terms stand for an angle, so that a degree without its sign is seen there."""

from types import SimpleNamespace

import pytest

from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import spelled
from coursework.variant.judging.plausibility import _terms_of_angles


@pytest.mark.parametrize(("key", "wanted", "text", "terms"), [
    ("start", {}, "a + 2*b", ["a", "2*b"]), ("coefficient", {}, "a", []), ("start", {"m": 1}, "a*b", []),
    ("coefficient", {}, "sin(a)", ["a"]), ("start", {"m": 1}, "L*cos(a - b) + tan(c)", ["a", "b", "c"]),
    ("start", None, "L @ (a + b)", ["a", "b"]), ("start", None, "exp(a)", []),
])  # fmt: skip
def test_what_stands_for_an_angle(key, wanted, text, terms):
    """Where an angle is required, in sin, cos and tan and behind @; the coefficient of friction has no unit but is none."""
    place = SimpleNamespace(path=("friction", "A", key), wanted=wanted, formulas=(parse(text, vectors=True),))
    assert [spelled(term) for _, term in _terms_of_angles([place])] == terms
