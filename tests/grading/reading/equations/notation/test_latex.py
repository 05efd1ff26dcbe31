"""Signs of LaTeX become those that people type: what follows from an equation is another one, what is equivalent is equal."""

import pytest

from coursework.grading.reading.equations.notation.latex import without_latex
from coursework.grading.reading.equations.systems.parts import parts_of

ARROWS = (
    "Rightarrow", "Longrightarrow", "implies", "rightarrow", "longrightarrow", "to", "Leftrightarrow", "iff", "therefore",
    "leadsto",
)  # fmt: skip
EQUAL = ("equiv", "approx", "simeq", "cong", "doteq", "coloneqq", "triangleq")
PLAIN = {"cdot": "*", "times": "*", "ast": "*", "div": "/", "omega": "ω", "varphi": "φ", "vartheta": "θ", "lambda": "λ"}


@pytest.mark.parametrize("arrow", ARROWS)
def test_what_follows_is_another_equation(arrow):
    parts = parts_of(without_latex(f"w_1 = 2 w_2 \\{arrow} w_2 = V/r"))
    assert ["".join(part.split()) for part in parts] == ["w_1=2w_2", "w_2=V/r"]


@pytest.mark.parametrize("sign", EQUAL)
def test_what_is_equivalent_is_equal(sign):
    assert without_latex(f"w_1 \\{sign} V").split() == ["w_1", "=", "V"]


@pytest.mark.parametrize("sign", PLAIN)
def test_a_sign_or_a_letter(sign):
    assert without_latex(f"a \\{sign} b").split() == ["a", PLAIN[sign], "b"]
