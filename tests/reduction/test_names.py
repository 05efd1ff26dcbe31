"""Whatever a file calls its things, the numbers stay the same: generated code keeps its own names apart."""

import re

import numpy as np
import pytest

import coursework
from coursework.accuracy.trace import trace
from coursework.integration.loops import generate_loop
from coursework.schemes import SCHEMES
from coursework.variant.reader import parse_variant

PLAIN = """
format = 1
[given]
ell = "0.4 m"
speed = "3 rad/s"
[drive]
V = "speed*cos(2*t)"
[functions]
r = "0.1 + 0.02*sin(phi)"
[coordinates]
phi = { start = "0.3 rad", rate = "V" }
x = { start = "0.2 rad", rate = "u" }
[unknowns]
k = "m/s"
[time]
step = "0.01 s"
end = "0.3 s"
[[constraint]]
name = "1"
because = "the slope of r(phi) and the second rates are needed"
equation = "ell*u*cos(x) + r*V*cos(phi) = 0"
[[constraint]]
name = "2"
because = "a velocity that is no rate"
equation = "k = ell*u*sin(x) - r*V*sin(phi)"
"""
# What generated code, SymPy, NumPy and math call theirs.
NAMES = [
    {"x": "h", "u": "steps", "phi": "i"},
    {"x": "u_1", "u": "u_2", "k": "u"},
    {"x": "begin", "u": "loop", "k": "values"},
    {"speed": "V_t", "ell": "V_t_"},
    {"speed": "dV", "ell": "du", "k": "dk"},
    {"ell": "r_phi", "speed": "r_phi_phi"},
    {"x": "array", "u": "dot", "k": "where", "ell": "linalg", "speed": "nan"},
    {"x": "S", "u": "N", "k": "Q", "ell": "I", "speed": "E"},
    {"x": "lambda", "u": "def", "k": "None", "ell": "class"},
    {"x": "range", "u": "gamma", "k": "beta", "speed": "zeta"},
]


def computed(text):
    run = coursework.solve(parse_variant(text, "names"), quantities=["accelerations"])
    values = run.values
    loop = generate_loop(SCHEMES["rk4"].step, values["rates"])
    rows = trace(loop, values["start"], run.step, 10, 2)
    return np.hstack([run.columns()[1], run.exact.rows]), rows


@pytest.mark.parametrize("names", NAMES, ids=lambda names: " ".join(names.values()))
def test_any_name_gives_the_same_numbers(names):
    text = re.sub("|".join(rf"\b{name}\b" for name in names), lambda word: names[word[0]], PLAIN)
    for found, meant in zip(computed(text), computed(PLAIN), strict=True):
        assert np.max(np.abs(found - meant)) < 1e-12
