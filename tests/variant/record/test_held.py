"""What is held has the unit of what it measures, whatever the size of the mechanism."""

import pytest

import coursework
from coursework.variant.formula.reader import parse
from coursework.variant.record.held import unit_of

CRANK = """[given]
a = "A m"
b = "B m"
[drive]
w = { pieces = [["0 s", "1"], ["0.5 s", "2"]] }
[coordinates]
p = { start = "90 deg", rate = "w" }
x = { start = "B m", rate = "u" }
[time]
step = "0.1 s"
end = "1 s"
[[constraint]]
equation = "u = -a*w*sin(p)"
"""


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e7])
def test_a_square_of_lengths_is_no_angle_in_micrometres_and_a_rate_in_pieces_no_speed(size):
    """The law of cosines is in m²; of velocity equations it is the unit times seconds."""
    variant = coursework.parse_variant(CRANK.replace("A m", f"{0.2 * size!r} m").replace("B m", f"{size!r} m"))
    units = {"a^2 + b^2 - 2*a*b*cos(p)": "m²", "x - a*cos(p)": "m", "u + a*w*sin(p)": "m", "w - 2": "rad", "a*u": "m²"}
    assert {text: unit_of(parse(text), variant) for text in units} == units
