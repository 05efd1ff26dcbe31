"""Which factor of a determinant vanishes: beside the largest, and by the data alone."""

import math
from types import SimpleNamespace

import pytest

import coursework
from coursework.equations.reduction.meaning import _vanishing, meaning
from coursework.variant.formula.reader import parse
from tests.mechanisms.library import mechanism

BOTH = [parse("sin(x)"), parse("cos(y)")]


def variant(**given):
    return SimpleNamespace(given=[SimpleNamespace(name=name) for name in given], values=given)


@pytest.mark.parametrize(("x", "found"), [(0.9e-3, BOTH[:1]), (1.1e-3, BOTH)])
def test_a_factor_vanishes_that_is_a_thousandth_of_the_largest(x, found):
    assert _vanishing(parse("r*sin(x)*cos(y)"), variant(r=0.3), {"x": x, "y": 0.0}) == found
    assert _vanishing(parse("r*sin(x)*cos(y)"), variant(r=0.3), None) == BOTH
    assert _vanishing(parse("sin(x)*cos(V)"), variant(), {"x": x}) == [parse("sin(x)"), parse("cos(V)")]  # V is a drive


@pytest.mark.parametrize(("beside", "is_nothing"), [(0.0, True), (0.9e-12, True), (1.2e-12, False)])
def test_a_factor_of_data_alone_vanishes_up_to_the_round_off_of_an_angle(beside, is_nothing):
    found = _vanishing(parse("sin(g)*cos(y)/r"), variant(g=math.pi + beside, r=0.3), None)
    assert found == ([parse("sin(g)")] if is_nothing else []) + [parse("cos(y)")]


@pytest.mark.parametrize(("offset", "words"), [
    ("0", "the slider is at the pivot of its guide"), ("0.0", "the slider is at the pivot of its guide"),
    ("0.1", "the slider is level with the pivot of its guide"), ("e", "the slider is level with the pivot of its guide"),
])  # fmt: skip
def test_a_slide_of_no_length_stands_on_the_pivot_where_its_guide_goes_through_it(offset, words):
    group = SimpleNamespace(kind="RPR", coordinates=("phi", "s"), offset=parse(offset))
    made = variant(e=0.1)
    made.coordinates, made.groups, made.points = [SimpleNamespace(name="s", unit="m", rate="u")], [group], ()
    assert meaning(parse("s"), made, ()) == f"the distance s is zero ({words})"


def test_three_equations_whose_determinant_is_one_product_are_told_like_two() -> None:
    """The links lie on one line: at the time when KQ = AK - AQ, from the given motion of M alone."""
    run = coursework.solve(coursework.parse_variant(mechanism("pantograph-on-a-rail")), quantities=("table",))
    (block, _) = run.scene.reduction.blocks
    assert (block.size, block.determinant) == (3, None)
    assert run.stop.time == pytest.approx(0.37467516951291, abs=1e-11)
    assert "sin(phi1 - phi2) = 0, with phi1 = 2.56554 rad" in run.stop.cause
    assert "link 1 and link 2 lie on one line (stretched or folded)" in run.stop.meaning


def test_three_equations_whose_determinant_is_a_sum_are_told_by_their_names() -> None:
    run = coursework.solve(coursework.parse_variant(mechanism("block-of-three-equations")), quantities=("table",))
    (block,) = (one for one in run.scene.reduction.blocks if one.size == 3)
    assert block.condition is None and "the determinant of the 3 equations 1, 2, 3 is zero" in str(block.meaning)


@pytest.mark.parametrize(("coupler", "rocker", "factor", "told"), [
    ("phi2", "phi3", "sin(phi2 - phi3)",
     "the link at angle phi2 and the link at angle phi3 lie on one line (stretched or folded)"),
    ("(-phi2)", "(pi/2 - phi3)", "cos(phi2 - phi3)", "cos(phi2 - phi3) is zero"),
    ("phi2", "(phi2 + phi3)", "sin(phi3)",
     "the link at angle phi2 and the link at angle phi3 lie on one line (stretched or folded)"),
])  # fmt: skip
def test_how_an_angle_counts_is_read_in_closures_too(coupler, rocker, factor, told):
    text = mechanism("four-bar-loop", ("b @ phi2 = (d, 0) + c @ phi3", f"b @ {coupler} = (d, 0) + c @ {rocker}"))
    assert meaning(parse(factor), coursework.parse_variant(text), ()) == told


@pytest.mark.parametrize(("name", "factor", "told"), [
    ("slider-crank-without-rod-angle", "s3 - r1*cos(theta1)", "s3 - r1*cos(theta1) is zero"),  # the rod is upright
    ("four-bar-by-its-points", "d*sin(phi3) + a*sin(phi1 - phi3)", "d*sin(phi3) + a*sin(phi1 - phi3) is zero"),  # rod and rocker
    ("four-bar-by-squared-lengths", "yB*xC - yB*d", "yB*xC - yB*d is zero"),
])  # fmt: skip
def test_lever_arms_are_told_of_no_link_but_those_whose_arms_they_are(name, factor, told):
    """Where a square of a length closes the loop, the link that matters has no angle in the determinant."""
    assert meaning(parse(factor), coursework.parse_variant(mechanism(name)), ()) == told
