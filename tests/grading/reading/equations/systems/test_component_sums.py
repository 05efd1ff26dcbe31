"""Vectors by components, added by name, as they stand or with i and j: an equation for each axis, wrong with a sign turned."""

from __future__ import annotations

import re

import pytest

from coursework.grading.reading.equations.systems.component_sums import by_axes
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from tests.grading.reading.equations.notation.test_notations import marked

A, BA = "-r1*w1*sin(phi1), r1*w1*cos(phi1)", "-r2*w2*sin(phi2), r2*w2*cos(phi2)"
B = "r3*w3*cos(phi3) - 0.5*r3*w4, r3*w3*sin(phi3)"
NAMED = f"v_A = ({A})\nv_BA = ({BA})\nv_B = ({B})\n"
IN_UNITS = """v_A = -r1*w1*sin(phi1) i + r1*w1*cos(phi1) j
v_BA = -r2*w2*sin(phi2) i + r2*w2*cos(phi2) j
v_B = (r3*w3*cos(phi3) - 0.5*r3*w4) i + r3*w3*sin(phi3) j
"""


@pytest.mark.parametrize("text", [
    f"{NAMED}v_A + v_BA = v_B", f"{NAMED}v_A + v_BA - v_B = 0", f"v_B - v_BA = v_A\n{NAMED}",
    f"v_A = [{A}]\nv_BA = [{BA}]\nv_B = [{B}]\nv_A + v_BA = v_B",
    NAMED.replace("v_", r"\vec{v}_") + r"\vec{v}_A + \vec{v}_{BA} = \vec{v}_B",
    f"{IN_UNITS}v_A + v_BA = v_B", f"({A}) + ({BA}) = ({B})", f"v_B = ({A}) + ({BA})\nv_B = ({B})",
    f"v_A = ({A})\nv_BA = ({BA})\nv_B = v_A + v_BA = ({B})",
    f"m = (-sin(phi1), cos(phi1))\nn = (-sin(phi2), cos(phi2))\nr1*w1*m + r2*w2*n = ({B})",
    f"Pin: v_A = ({A})\nthe rod, v_B = v_A + w2 (-r2*sin(phi2), r2*cos(phi2))\nv_B = ({B})",
    f"v_Ax = -r1*w1*sin(phi1)\nv_Ay = r1*w1*cos(phi1)\nv_A + ({BA}) = [{B}]", f"v_A = ({A})\nv_B = ({B}) = ({BA}) + v_A",
    IN_UNITS.replace("v_A = ", "v_A = 1*(").replace(
        "cos(phi1) j", "cos(phi1) j)") + "v_A + v_BA = v_B",
    r"(-r1*w1*sin(phi1) - r2*w2*sin(phi2)) \vec{i} + (r1*w1*cos(phi1) + r2*w2*cos(phi2)) \vec{j}"
    r" = (r3*w3*cos(phi3) - 0.5*r3*w4) \vec i + r3*w3*sin(phi3) \vec j",
])  # fmt: skip
def test_an_equation_of_vectors_is_one_for_each_axis(text: str) -> None:
    right, slip = marked(text), marked(text.replace("-r1*w1", "r1*w1").replace("(-sin(phi1)", "(sin(phi1)"))
    assert (right.independent, [mark.verdict for mark in right.marks]) == (2, ["right", "right"])
    assert (slip.independent, len(slip.wrong)) == (1, 1)


@pytest.mark.parametrize("text", [
    f"v_A = ({A})\nv_BA = v_B", "w1, w2 = solve(r1, r2)", f"K*({A}) = ({B})", "y = (1.63, 3.37)\ny = (2, 3)", f"v_A = f({A})",
    f"v_A = ({A}, 0)\nv_A = ({B}, 0)", "j = i + i", f"v_A = ({A})\nv_A + r1 = 0",
])  # fmt: skip
def test_what_names_no_two_vectors_is_none(text: str) -> None:
    assert marked(text).independent == 0


@pytest.mark.parametrize("text", [
    "i*r1*w1*(cos(phi1) + i*sin(phi1)) + i*r2*w2*(cos(phi2) + i*sin(phi2)) = r3*w3*(cos(phi3) + i*sin(phi3)) - 0.5*r3*w4",
    "r1 ω1 (-sin φ1 + j cos φ1) + r2 ω2 (-sin φ2 + j cos φ2) = r3 ω3 (cos φ3 + j sin φ3) - ½ r3 ω4",
])  # fmt: skip
def test_an_equation_of_complex_numbers_is_its_two_parts(text: str) -> None:
    right, slip = marked(text), marked(text.replace("i*r2", "-i*r2").replace("-sin φ2", "sin φ2"))
    assert [mark.verdict for mark in right.marks] == ["right", "right"]
    assert slip.independent < 2
    assert len(slip.wrong) == 2 - slip.independent


@pytest.mark.parametrize("text", ["w3 = i*w2", "w1 - i*w3 = (1 - i)*w2", "*".join(["(cos(phi1) + i*sin(phi1))"] * 9) + " = 0"])
def test_a_ratio_is_no_imaginary_unit_and_long_products_are_not_written_out(text: str) -> None:
    assert [mark.verdict for mark in marked(text).marks] == ["unreadable"]


@pytest.mark.parametrize("text", [
    "b = {0}\nA*[w1; w2] = -b", "-b = {1}\nA*[w1; w2] = -b", "b = np.array({0})\nw1, w2 = np.linalg.solve(A, -b)",
    "Φ_t = {0}\nA*q' = -Φ_t\nq' = [w1; w2]", "b = {0}\nx = [w1; w2]\nx = A\\(-b)",
])  # fmt: skip
def test_a_right_side_may_have_a_minus_before_its_name(text: str) -> None:
    text = "A = [r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), r2*cos(phi2)]\n" + text
    minus, plus = "[r3*w3*cos(phi3) - 0.5*r3*w4; -r3*w3*sin(phi3)]", "[0.5*r3*w4 - r3*w3*cos(phi3); r3*w3*sin(phi3)]"
    assert [mark.verdict for mark in marked(text.format(minus, plus)).marks] == ["right", "right"]
    assert marked(text.format(plus, minus)).independent == 0


@pytest.mark.parametrize(("line", "slip"), [
    ("A = [r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), -r2*cos(phi2)]\nb = [p; q]\nA*[w1; w2] = b", "-r2"),
    ("  r1*w1*sin(phi1) + r2*w2*sin(phi2) = p; r1*w1*cos(phi1) - r2*w2*cos(phi2) = q", "- r2"),
    ("16; r1*w1*cos(phi1) - r2*w2*cos(phi2) = q; C is fixed", "- r2"),
])  # fmt: skip
def test_a_hint_has_the_column_in_the_line_of_the_file(line: str, slip: str) -> None:
    text = re.sub(r"\bp\b", "0.5*r3*w4 - r3*w3*cos(phi3)", re.sub(r"\bq\b", "r3*w3*sin(phi3)", line))
    (wrong,) = marked(text).wrong
    assert wrong.hint is not None
    assert text[wrong.hint.column - 1 :].startswith(slip)


@pytest.mark.parametrize(("letters", "is_read"), [(EQUATION_CHARACTERS, True), (EQUATION_CHARACTERS + 1, False)])
def test_an_equation_of_vectors_is_read_up_to_its_most_letters(letters: int, is_read: bool) -> None:
    (found,) = by_axes(["(a) i + b*j = (c, d)".ljust(letters)], {}.get, bool)
    assert (found == "(a) = (c); b = (d)") is is_read
