"""Components that make a length at an angle are read as one, without a change of their value."""

import cmath
from itertools import product

import numpy as np
import pytest

from coursework import parse_variant
from coursework.variant import catalogue
from coursework.variant.formula.arms import with_arms
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import Formula, evaluate_any, mapped, spelled
from tests.mechanisms.library import changed, mechanism

VALUES = {"r": 0.7, "a": 2.0, "phi": 0.4, "psi": -1.9, "d": 0.3, "h": -0.8, "pi": np.pi, "A": 0.5 - 0.9j, "B": -1.1 + 0.2j}
LENGTHS = ["r", "2*r", "r/2", "r*a/3"]
ANGLES = ["phi", "phi + psi", "phi - psi", "2*phi"]
SIDES = [("cos", "sin"), ("sin", "cos")]


@pytest.mark.parametrize("kind", SIDES)
@pytest.mark.parametrize("signs", list(product(["", "-"], repeat=2)))
@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("angle", ANGLES)
def test_an_arm_of_every_sign_and_function_is_one_length_at_one_angle(kind, signs, length, angle):
    text = "({}{}*{}({}), {}{}*{}({}))".format(
        *(part for s, f in zip(signs, kind, strict=True) for part in (s, length, f, angle))
    )
    arm = with_arms(parse(text, vectors=True))
    assert arm.op == "@" and spelled(arm.args[0]) == spelled(parse(length))
    assert cmath.isclose(evaluate_any(arm, VALUES), evaluate_any(parse(text, vectors=True), VALUES), rel_tol=1e-14)


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("(A.x + r*cos(phi), A.y + r*sin(phi))", "A + r @ phi"),
        ("(cos(phi)*r + A.x, sin(phi)*r + A.y - h)", "A - (0, h) + r @ phi"),
        ("((A + B).x + r*sin(phi), (A + B).y - r*cos(phi))", "A + B + r @ (phi - pi/2)"),
        ("(r*cos(phi) + a*cos(psi) + d, r*sin(phi) + a*sin(psi))", "(d, 0) + r @ phi + a @ psi"),
        ("A - (r*cos(phi), r*sin(phi))", "A - r @ phi"),
        ("(-d - r*cos(phi), r*sin(phi) - h)", "(-d, -h) + r @ (pi - phi)"),
        ("(cos(phi), sin(phi))", "1 @ phi"),
        ("A + r*(sin(phi), cos(phi))", "A + r @ (pi/2 - phi)"),
        ("A - r/2*(cos(phi), -sin(phi))*a", "A - r*a/2 @ (-phi)"),
        ("(r*cos(phi), r*sin(phi))/2", "r/2 @ phi"),
        ("2*(1 @ phi)/a", "2/a @ phi"),
        ("-3*(r @ phi)", "(-3)*r @ phi"),
    ],
)
def test_sums_of_components_are_sums_of_vectors(text, read):
    vector = parse(text, vectors=True)
    assert spelled(with_arms(vector)) == read
    assert cmath.isclose(evaluate_any(with_arms(vector), VALUES), evaluate_any(vector, VALUES), rel_tol=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        "(r*cos(phi), r*sin(psi))",
        "(r*cos(phi), a*sin(phi))",
        "(r*cos(phi), r*cos(phi))",
        "(A.x, B.y)",
        "(A.y, A.x)",
        "(A.x, -A.y)",
        "(r/cos(phi), r/sin(phi))",
        "(r*cos(phi)^2, r*sin(phi)^2)",
        "(d, h)",
        "(r*cos(phi)*sin(psi), r*sin(phi)*sin(psi))",
    ],
)
def test_other_components_stay_as_they_are(text):
    assert with_arms(parse(text, vectors=True)) == parse(text, vectors=True)


def test_a_file_by_components_is_read_as_one_by_arms():
    """So links, figures, derivation and the names of its lengths are the same in both."""
    components = {
        "D + r1 @ phi1": "D + (r1*cos(phi1), r1*sin(phi1))",
        "A + r2 @ phi2": "(A.x + r2*cos(phi2), A.y + r2*sin(phi2))",
        "B + 2*r3 @ phi3": "(2*r3*cos(phi3) + B.x, 2*r3*sin(phi3) + B.y)",
        "B + r3 @ (phi3 + pi/2)": "(B.x - r3*sin(phi3), B.y + r3*cos(phi3))",
        "C - (0, r3/2)": "(C.x, C.y - r3/2)",
    }
    by_arms, by_components = parse_variant(mechanism("31")), parse_variant(mechanism("31", *components.items()))
    assert by_components.points == by_arms.points


def test_a_closure_by_components_too():
    by_components = mechanism("clockwise-four-bar")
    by_arms = parse_variant(
        changed(by_components, ("(c*cos(f3), -c*sin(f3))", "c @ (-f3)"), ("(a*cos(f1), -a*sin(f1))", "a @ (-f1)"))
    )
    assert parse_variant(by_components).constraints[0].sides == by_arms.constraints[0].sides


def test_every_arm_of_the_catalogue_is_found_again_in_its_components():
    def by_components(tree):
        tree = mapped(tree, by_components)
        if tree.op != "@":
            return tree
        length, angle = tree.args
        return Formula("pair", tuple(Formula("*", (length, Formula("call", (angle,), turn))) for turn in ("cos", "sin")))

    formulas = [formula for name in catalogue.names() for _, formula in catalogue.load(name).formulas()]
    arms = [formula for formula in formulas if any(node.op == "@" for node in formula.walk())]
    assert len(arms) > 50
    assert [with_arms(by_components(arm)) for arm in arms] == arms
