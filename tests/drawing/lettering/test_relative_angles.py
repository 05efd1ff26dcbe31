"""Links whose angles are counted from other links: drawn once, with the rates, arcs and projections that are theirs."""

import math

import pytest

import coursework
from coursework import parse_variant
from coursework.drawing.lettering.turns import turns
from coursework.drawing.outline.tracing import read_outline
from coursework.mechanism.derivation.derive import derive
from coursework.mechanism.derivation.segments import point_graph
from coursework.mechanism.mechanism import build
from coursework.variant.formula.tree import evaluate_any
from tests.mechanisms.library import mechanism

FILE = "four-bar-with-relative-angles"
LISTED = [("1", ("A", "B"), "w1"), ("2", ("B", "C"), ""), ("3", ("D", "C"), "")]
WITHOUT_LINKS = ('\n1 = { points = ["A", "B"] }\n2 = { points = ["B", "C"] }\n3 = { points = ["D", "C"] }', "")


@pytest.mark.parametrize("changes", [(), (WITHOUT_LINKS,)], ids=["listed", "found"])
def test_each_link_is_drawn_once(changes):
    outline = read_outline(build(parse_variant(mechanism(FILE, *changes))))
    assert [(bar.link, bar.corners, bar.rate) for bar in outline.bars] == LISTED
    assert outline.cranks == (("w1", "A"),)


@pytest.mark.parametrize("place", [
    "P + a @ phi2 + c @ (phi2 + pi/2)", "(P.x + a*cos(phi2) - c*sin(phi2), P.y + a*sin(phi2) + c*cos(phi2))",
])  # fmt: skip
def test_a_point_beside_its_link_is_drawn_with_it(place):
    outline = read_outline(build(parse_variant(mechanism("four-bar-by-its-points", ("[closure]", f'E = "{place}"\n[closure]')))))
    assert ("2", ("P", "R", "E"), "w2") in [(bar.link, bar.corners, bar.rate) for bar in outline.bars]


def test_an_angle_is_measured_where_fewest_others_stand_between_it_and_the_axis():
    variant = parse_variant(mechanism(FILE))
    values = {**variant.values, "pi": math.pi, **{one.name: one.start for one in variant.coordinates}}
    for name, formula in variant.points:
        values[name] = evaluate_any(formula, values)
    found = {turn.coordinate: turn.at for turn in turns(build(variant), values)}
    assert found == {"q1": (values["A"],), "q2": (values["B"],), "q3": (values["D"],)}


def test_projections_turn_at_the_sum_of_the_rates():
    run = coursework.solve(parse_variant(mechanism(FILE)), quantities=["table"])
    rows = [dict(zip(run.motion.coordinate_names, row, strict=True)) for row in run.motion.coordinates[:3].tolist()]
    found = derive(run.scene.mechanism, rows)
    assert (found.rank, found.followed, found.beyond) == (2, ("1", "2"), ())
    terms = [(term.sign, term.rate, term.length.name) for term in found.projections[0].projection.terms]
    assert sorted(terms) == [(-1, rate, length) for rate, length in (
        ("w1", "r1"), ("w1", "r2"), ("w1", "r3"), ("w2", "r2"), ("w2", "r3"), ("w3", "r3"))]  # fmt: skip


@pytest.mark.parametrize("sign", ["+", "-"])
def test_a_projection_has_the_sense_in_which_each_angle_counts(sign):
    """The crank counts clockwise from x, the others do not: its terms have the other sign."""
    text = mechanism(FILE, ("A + r1 @ q1", f"A + r1 @ ({sign.strip('+')}q1)"))
    (crank,) = [one for one in point_graph(build(parse_variant(text))).segments if (one.start, one.end) == ("A", "B")]
    assert crank.turning == (("w1", 1 if sign == "+" else -1),)


def test_a_closure_that_is_zero_is_a_gap_between_its_points():
    """The arm of q3 begins at D, though the sum C - D - r3 @ q3 = (0, 0) begins elsewhere."""
    arms = ('holds = ["(C - B - r2 @ (q1 + q2)).x", "(C - B - r2 @ (q1 + q2)).y"]', "")
    loop = ("[points]", '[[constraint]]\nclosure = "D - C + r3 @ (q1 + q2 + q3) = (0, 0)"\n[points]')
    built = build(parse_variant(mechanism(FILE, arms, loop, ("D + r3 @ (q1 + q2 + q3)", "B + r2 @ (q1 + q2)"))))
    variant = built.variant
    values = {**variant.values, "pi": math.pi, **{one.name: one.start for one in variant.coordinates}}
    for name, formula in variant.points:
        values[name] = evaluate_any(formula, values)
    assert {turn.coordinate: turn.at for turn in turns(built, values)}["q3"] == (values["D"],)


def test_a_link_has_a_number_that_no_other_has():
    relative = (("q1 + q2 + q3", "q3"), ("q1 + q2", "q2 + q3"), WITHOUT_LINKS)
    outline = read_outline(build(parse_variant(mechanism(FILE, *relative))))
    assert {(bar.link, bar.corners) for bar in outline.bars} == {("1", ("A", "B")), ("2", ("B", "C")), ("3", ("D", "C"))}
