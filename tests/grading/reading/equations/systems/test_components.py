"""Vectors with factors and names of the student: read as the scalar equations that they are, right and with one slip."""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.notation.test_notations import marked

REST = """w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))
w4 = 2*w3*(cos(phi3) - 2*sin(phi3))
"""
FORMS = {
    "a factor before the right side": "A = [r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), r2*cos(phi2)];\n"
    "b = r3*[w4/2 - w3*cos(phi3); w3*sin(phi3)];\nx = A\\b; w1 = x(1); w2 = x(2);",
    "two vectors": "w1*r1*[sin(phi1), cos(phi1)] + w2*r2*[sin(phi2), cos(phi2)] = r3*[w4/2 - w3*cos(phi3), w3*sin(phi3)]",
    "names that begin like data": "p1r = r3*w4/2 - r3*w3*cos(phi3)\npr = r3*w3*sin(phi3)\ndd = r1*r2*sin(phi1 - phi2)\n"
    "w1 = r2*(p1r*cos(phi2) - pr*sin(phi2))/dd\nw2 = r1*(pr*sin(phi1) - p1r*cos(phi1))/dd",
}


@pytest.mark.parametrize("form", FORMS)
def test_a_system_in_vectors_is_right_and_with_another_function_is_not(form):
    assert marked(REST + FORMS[form], "31").share == 1
    assert marked(REST + FORMS[form].replace("r3*w3*cos", "r3*w3*sin").replace("- w3*cos", "- w3*sin"), "31").share < 1
