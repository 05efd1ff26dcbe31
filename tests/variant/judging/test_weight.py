"""A gravity that no planet has is told as a probable slip of its unit."""

import pytest

from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism


@pytest.mark.parametrize(("gravity", "told"), [
    ("9810 m/s^2", "gravity of 9810 m/s² is 1000 times that of the Earth: is its unit right?"),
    ("(0, -G)", None), ("9810 mm/s^2", None), ("0 m/s^2", None), ("1.62 m/s^2", None),
    ("295 m/s^2", "gravity of 295 m/s² is 30.07 times"), ("294 m/s^2", None), ("0.328 m/s^2", None),
    ("0.326 m/s^2", "gravity of 0.326 m/s² is 0.03323 times"),
])  # fmt: skip
def test_a_gravity_of_no_planet_is_remarked_on(gravity, told):
    if gravity.startswith("("):
        text = mechanism(
            "wheel-on-a-rail", ('gravity = "9.81 m/s^2"', 'gravity = "(0, -G)"'), ("[given]", '[given]\nG = "9.81 m/s^2"')
        )
    else:
        text = mechanism("wheel-on-a-rail", ("9.81 m/s^2", gravity))
    found = [remark for remark in parse_variant(text).plausibility if remark.code == "GRAVITY"]
    assert [str(remark.sentence).startswith(told) for remark in found] == [True] * bool(told)
    assert all(text.splitlines()[remark.line - 1].startswith("gravity") for remark in found)
