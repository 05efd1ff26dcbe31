"""A sign before a term that is zero with the data of the file cannot be caught there: it is said to be not judged."""

import pytest

import coursework

# An offset crank and slider of my own; its guide is turned by g from the axis x.
SLIDER = """
[given]
a = "0.11 m"
b = "0.43 m"
e = "0.05 m"
g = "{angle}"
n = "70 rpm"
[drive]
w1 = "n"
[coordinates]
phi = {{ start = "40 deg", rate = "w1" }}
psi = {{ rate = "w2", unit = "rad" }}
s = {{ rate = "u", unit = "m" }}
[time]
step = "0.02 s"
end = "0.4 s"
[points]
O = "(0, 0)"
[[group]]
kind = "crank"
from = ["O"]
lengths = ["a"]
meets = "A"
coordinates = ["phi"]
[[group]]
kind = "RRP"
from = ["A"]
guide = {{ through = "O", angle = "g", offset = "e" }}
lengths = ["b"]
meets = "B"
coordinates = ["psi", "s"]
mode = "+1"
[[constraint]]
name = "x"
because = "B runs on the guide"
equation = "{x}"
[[constraint]]
name = "y"
because = "B runs on the guide"
equation = "{y}"
[ask]
quantities = ["table", "checks"]
"""
X, Y = "-a*w1*sin(phi) - b*w2*sin(psi) = u*cos(g)", "a*w1*cos(phi) + b*w2*cos(psi) = u*sin(g)"


def agreement(angle, x=X, y=Y):
    run = coursework.solve(coursework.parse_variant(SLIDER.format(angle=angle, x=x, y=y), "own.toml"))
    return next(finding for finding in run.checks if finding.code == "AGREEMENT"), str(run.summary)


@pytest.mark.parametrize("angle", ["0 deg", "90 deg", "17 deg"])
def test_right_equations_agree_whatever_is_zero_with_their_data(angle):
    assert agreement(angle)[0].verdict == "PASS"


def test_a_term_left_out_because_it_is_zero_is_no_slip():
    assert agreement("0 deg", y=Y.replace("u*sin(g)", "0"))[0].verdict == "PASS"


@pytest.mark.parametrize(
    ("angle", "wrong", "term"),
    [("0 deg", {"y": Y.replace("u*sin", "-u*sin")}, "u*sin(g)"), ("90 deg", {"x": X.replace("u*cos", "-u*cos")}, "u*cos(g)")],
)
def test_a_sign_turned_where_the_term_is_zero_is_not_praised(angle, wrong, term):
    found, summary = agreement(angle, **wrong)
    assert found.verdict == "SKIP"
    assert f"With these data {term} in equation {next(iter(wrong))} is zero" in str(found.sentence)
    assert f"computed right; the sign of {term} in equation" in summary
    with pytest.raises(coursework.InputError, match=f"V302.* equation {next(iter(wrong))} contradicts"):
        agreement("17 deg", **wrong)
