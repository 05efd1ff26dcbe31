"""A sign before a term that is zero with the data of the file cannot be caught there: it is said to be not judged."""

import pytest

import coursework
from tests.mechanisms.library import mechanism

X, Y = "-r*w1*sin(phi1) - l*w2*sin(phi2) = u*cos(g)", "r*w1*cos(phi1) + l*w2*cos(phi2) = u*sin(g)"


def slider_crank(angle, *changes, x=X, y=Y, **values):
    """Return an offset slider-crank whose guide is turned by g from the axis x, with its two equations."""
    text = mechanism(
        "slider-crank", ('"0 deg"', '"40 deg"'), ("[drive]", f'g = "{angle}"\n[drive]'), ('angle = "0", off', 'angle = "g", off'),
        *changes, rails=None, period=None, **{"step": "0.02 s", "end": "0.4 s", **values},
    )  # fmt: skip
    equations = "".join(f'[[constraint]]\nname = "{name}"\nequation = "{one}"\n' for name, one in (("x", x), ("y", y)))
    return f'{text}{equations}[ask]\nquantities = ["table", "checks"]\n'


def agreement(angle, **equations):
    run = coursework.solve(coursework.parse_variant(slider_crank(angle, **equations), "own.toml"))
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
