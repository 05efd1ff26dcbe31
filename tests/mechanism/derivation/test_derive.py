"""Equations from the points alone: those of the guide for variant 31, and the written ones of the whole catalogue."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework import parse_variant
from coursework.mechanism.derivation.constants import named_angles
from coursework.mechanism.derivation.contours import contours_of
from coursework.mechanism.derivation.derive import Derivation, _solved, derive
from coursework.mechanism.derivation.segments import _part_of_pi, point_graph
from coursework.mechanism.mechanism import build
from coursework.variant.formula.reader import parse, parse_equation
from coursework.variant.formula.tree import spelled
from tests.mechanisms.library import mechanism
from tests.report.real import changed


def found(variant: Any) -> Derivation:
    run = coursework.solve(variant, quantities=["table"])
    rows = [dict(zip(run.motion.coordinate_names, row, strict=True)) for row in run.motion.coordinates.tolist()]
    made = derive(run.scene.mechanism, rows)
    assert made is not None
    return made


def test_variant_31_has_the_vector_equations_and_projections_of_the_guide() -> None:
    """Guide, (5) to (19): paths, eight projections, rank four, the four chosen ones and what the others are."""
    made = found("31")
    assert ["-".join(path.points) for path in made.paths] == ["M-B-C", "M-B-C-P", "M-B-A-D", "P-C-B-A-D", "C-B-A-D"]
    assert [(one.name, one.projection.path.points[-1] + one.projection.axis) for one in made.projections] == [
        ("11", "Cy"), ("12", "Px"), ("13", "Py"), ("14", "Dx"), ("15", "Dy"), ("16", "Dx"), ("17", "Dy"), ("18", "Dy"),
    ]  # fmt: skip
    assert made.rank == 4
    assert {one.name: {name: sign for sign, name in one.terms} for one in made.dependent} == {
        "13": {"11": 1}, "14": {"12": 1, "16": 1}, "15": {"11": 1, "18": 1}, "17": {"18": 1},
    }  # fmt: skip
    assert made.followed == ("11", "12", "16", "18")
    assert made.beyond == ()


def test_angles_are_those_of_the_drawing() -> None:
    """Guide: M to B is phi3 + pi, B to C phi3 + pi/2, C to P 3 pi/2, A to D phi1 + pi."""
    angles = {}
    for path in found("31").paths:
        for one in path.segments:
            angles[one.start + one.end] = (one.angle.base.name if one.angle.base else "", one.angle.offset)
    half, whole = Fraction(1, 2), Fraction(1)
    assert angles["MB"] == ("phi3", whole)
    assert angles["BC"] == ("phi3", half)
    assert angles["CP"] == ("", 3 * half)
    assert angles["BA"] == ("phi2", whole)
    assert angles["AD"] == ("phi1", whole)
    assert angles["PC"] == ("", half)
    assert angles["CB"] == ("phi3", 3 * half)


@pytest.mark.parametrize(
    ("name", "beyond"),
    [("v101", ()), ("v102", ()), ("v104", ()), ("v105", ()), ("v107", ()), ("v108", ()), ("v110", ()), ("robot-arm", ()),
     ("andrews", ()), ("pantograph", ()), ("v112", ("3", "4", "5")), ("epicyclic", ("1",))],
)  # fmt: skip
def test_written_equations_are_combinations_of_the_projections(name: str, beyond: tuple[str, ...]) -> None:
    """All but those of gears and racks, whose teeth no path between points knows."""
    made = found(name)
    assert made.beyond == beyond
    assert made.followed


@pytest.mark.parametrize("wrong", ["VMy + 2*r3*w3*cos(phi3)", "VMy - 2.000001*r3*w3*cos(phi3)"])
def test_a_wrong_sign_is_no_combination(wrong: str) -> None:
    unjudged = replace(changed({"VMy - 2*r3*w3*cos(phi3)": wrong}), driven=None, holds=())
    assert "11" in found(unjudged).beyond


def test_a_right_equation_in_other_words_is_one() -> None:
    text = {"driven = ": "#driven = ", "holds  = ": "#holds = "}
    right = "-(VMy - (1 + 1)*r3*w3*cos(phi3)) + r3*w3*sin(phi3) = 0"
    made = found(changed({**text, "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0": right}))
    assert made.beyond == ()


def test_contacts_belong_to_their_wheel() -> None:
    graph = point_graph(coursework.solve("cardan", quantities=["table"]).scene.mechanism)
    assert all("P" not in (one.start, one.end) for one in graph.segments)


@pytest.mark.parametrize("gap", [
    "R - Q - c @ phi3", "Q + c @ phi3 - R", "c @ phi3 - R + Q", "R - (Q + (c*cos(phi3), c*sin(phi3)))",
])  # fmt: skip
@pytest.mark.parametrize("axes", ["xy", "x", "y"])
def test_a_held_gap_is_a_segment_in_any_order_if_it_is_held_along_both_axes(gap: str, axes: str) -> None:
    held = "[{}]".format(", ".join(f'"({gap}).{axis}"' for axis in axes))
    graph = point_graph(build(parse_variant(mechanism("four-bar-by-its-points", holds=held))))
    between = [one for one in graph.segments if {one.start, one.end} == {"Q", "R"}]
    found = [one if one.start == "Q" else one.reversed() for one in between]
    assert [(spelled(one.length), spelled(one.angle.base), one.angle.offset, one.turning) for one in found] == (
        [("c", "phi3", 0, (("w3", 1),))] if axes == "xy" else []
    )


@pytest.mark.parametrize("y", ["R.y - Q.y - c*sin(phi3)", "Q.y + c*sin(phi3) - R.y", "(Q - R).y + sin(phi3)*c"])
def test_two_held_components_are_the_vector_they_belong_to(y: str) -> None:
    text = mechanism("four-bar-by-its-points", holds=f'["R.x - c*cos(phi3) - Q.x", "{y}"]')
    graph = point_graph(build(parse_variant(text)))
    assert [spelled(one.length) for one in graph.segments if {one.start, one.end} == {"Q", "R"}] == ["c"]
    other = parse_variant(text.replace("R.x - c*cos(phi3)", "R.x - c*cos(phi2)"))
    assert not [one for one in point_graph(build(other)).segments if {one.start, one.end} == {"Q", "R"}]


def test_a_chain_has_a_contour_for_each_group() -> None:
    contours = contours_of(coursework.solve("example-3", quantities=["table"]).scene.mechanism)
    assert [one.name for one in contours] == ["G2", "G3"]
    assert [spelled(side) for side in contours[0].left_parts] == ["B.x + r2*cos(theta2)", "B.y + r2*sin(theta2)"]
    assert [spelled(side) for side in contours[0].right_parts] == ["r4 + r3*cos(theta3)", "r3*sin(theta3)"]


def test_two_forms_of_one_constant_angle_have_one_name() -> None:
    short, long = "acos((b^2 + d^2 - e^2)/(2*b*d))", "acos(b/(2*d) + d/(2*b) - e^2/(2*b*d))"
    formulas = [parse(f"cos(phi + {long})"), parse(f"sin(phi - {short})"), parse("acos((b^2 + d^2 - e^2)/(2*b*e))")]
    data = {"b": 3.0, "d": 4.0, "e": 4.0}  # two sides alike: only other data tell d from e
    named = named_angles(formulas, {"phi"}, {"phi", *data}, data)
    assert [spelled(angle) for name, angle in named.angles if name == "beta1"] == [spelled(parse(short))]
    assert len(named.angles) == 2
    assert spelled(named.put_in(formulas[0])) == "cos(phi + beta1)"
    assert spelled(named.put_in(formulas[1])) == "sin(phi - beta1)"
    assert len(named_angles(formulas, {"phi"}, {"phi", *data}).angles) == 3, "without data nothing is known to be alike"


def test_constant_angles_get_names_that_are_free() -> None:
    formulas = [parse("r*cos(phi + acos(b/(2*d)))"), parse("sin(phi - acos(b/(2*d))) + asin(b/d)"), parse("asin(phi/d)")]
    named = named_angles(formulas, {"phi"}, {"phi", "b", "d", "r", "beta1"})
    assert [name for name, _ in named.angles] == ["beta_1", "beta_2"]
    assert spelled(named.put_in(formulas[1])) == "sin(phi - beta_1) + beta_2"
    assert named.put_in(formulas[2]) == formulas[2]


def test_contours_are_those_of_every_closure_wherever_it_stands() -> None:
    """Between equations that are written; A + r @ f = B and B + s @ g = A close, the others do not."""

    def one(name: str, text: str) -> SimpleNamespace:
        left, right = parse_equation(text, vectors=True)
        return SimpleNamespace(name=name, is_closure=" @ " in text, left=left, right=right)

    mechanism = SimpleNamespace(
        variant=SimpleNamespace(coordinates=[SimpleNamespace(name="f"), SimpleNamespace(name="g")]),
        points=[("A", parse("(0, 0)", vectors=True)), ("B", parse("(b, 0)", vectors=True))],
        constraints=[one("1", "u = r*w"), one("2", "A + r @ f = B"), one("3", "w = u"), one("4", "B + s @ g = A")],
    )
    assert [contour.name for contour in contours_of(mechanism)]  # type: ignore[arg-type] == ["2", "4"]


@pytest.mark.parametrize(("written", "parts"), [
    (
        "-(A + b @ phi2) = -((d, 0) + c @ phi3)",
        ["-(A.x + b*cos(phi2))", "-(A.y + b*sin(phi2))", "-(d + c*cos(phi3))", "-c*sin(phi3)"],
    ),
    (
        "(A + b @ phi2)/2 = ((d, 0) + c @ phi3)/2",
        ["(A.x + b*cos(phi2))/2", "(A.y + b*sin(phi2))/2", "(d + c*cos(phi3))/2", "c*sin(phi3)/2"],
    ),
])  # fmt: skip
def test_a_loop_turned_round_or_stretched_is_projected(written: str, parts: list[str]) -> None:
    text = mechanism("four-bar-loop", ("A + b @ phi2 = (d, 0) + c @ phi3", written))
    contours = contours_of(coursework.solve(coursework.parse_variant(text), quantities=["table"]).scene.mechanism)
    assert [spelled(part) for one in contours for part in (*one.left_parts, *one.right_parts)] == parts


@pytest.mark.parametrize(("pivot", "x"), [
    ("(r4, 0)", "r4"), ("A + 0.5*((2*r4, 0) - A)", "0.5*(2*r4)"), ("(A + (2*r4, 0))/2", "2*r4/2"), ("(r4 + 0)*(1, 0)", "r4*1"),
    ("-(-r4, 0)", "-(-r4)"),
])  # fmt: skip
def test_a_pivot_written_otherwise_has_the_same_velocities_and_its_contour_is_shown(pivot: str, x: str) -> None:
    text = coursework.load("example-1").path.read_text(encoding="utf-8").replace('D = "(r4, 0)"', f'D = "{pivot}"')
    run = coursework.solve(coursework.parse_variant(text), quantities=["table"])
    (one,) = contours_of(run.scene.mechanism)
    assert [spelled(part) for part in one.right_parts] == [f"{x} + r3*cos(theta3)", "r3*sin(theta3)"]
    assert np.allclose(run.table, coursework.solve("example-1", quantities=["table"]).table, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize(("share", "is_sum"), [(0.9e-8, True), (1.1e-8, False)])
def test_what_is_left_of_a_row_is_judged_by_its_length(size: float, share: float, is_sum: bool) -> None:
    rows, wanted = np.array([[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]), np.array([3.0, 4.0, 5 * share]) * size
    assert (_solved(rows, wanted) is not None) == is_sum


@pytest.mark.parametrize(
    ("written", "part"),
    [("pi", "1"), ("pi/6", "1/6"), ("2*pi/3", "2/3"), ("-pi/4", "-1/4"), ("pi*3", "3"), ("3*(pi/4)", "3/4"), ("pi/2/5", "1/10")],
)
def test_an_angle_that_is_a_share_of_pi_is_known_exactly(written: str, part: str) -> None:
    assert _part_of_pi(parse(written)) == Fraction(part)
