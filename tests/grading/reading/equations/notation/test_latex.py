"""Signs of LaTeX become those that people type: what follows from an equation is another one, what is equivalent is equal."""

import pytest

from coursework.grading.reading.equations.notation.latex import matrices_in_one_piece, with_formulas_joined, without_latex
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


@pytest.mark.parametrize(("text", "plain"), [
    (r"\frac{a}{b}c", "((a)/(b))c"), (r"\frac ab c", "((a)/(b))c"), (r"\frac {a + \frac{b}{c}} d", "((a+((b)/(c)))/(d))"),
    (r"\dv{\varphi_3}{t}", "((dφ_3)/(dt))"), (r"\dv{t} x", "((d)/(dt))x"), (r"\dv{x}\dv{t}", "((d)/(dx))((d)/(dt))"),
    (r"\dot\varphi_3 + \dot{\varphi}_3", "φ\u0307_3+φ\u0307_3"), (r"V_\mathrm{M} \mathrm{sin}", "V_{M}sin"),
    (r"a^{\prime}", "a'"),
    (r"\underbrace{a+b}_{=c} d", "(a+b)d"), (r"\boxed{a = b}", "a=b"), (r"2~\si{\per\second}", "2[1/s]"), ("a & b", "a&b"),
])  # fmt: skip
def test_a_command_becomes_what_people_type(text, plain):
    assert "".join(without_latex(text).split()) == plain


@pytest.mark.parametrize(("text", "piece"), [
    (r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}", "[a,b;c,d]"), ("\\begin{bmatrix}\na \\\\\nb\n\\end{bmatrix}", "[a;b]"),
    (r"\begin{vmatrix} a & b \\ c & d \end{vmatrix}", "((a)*(d)-(b)*(c))"),
    (r"\det\begin{pmatrix} a & b \\ c & d \end{pmatrix}", "((a)*(d)-(b)*(c))"),
    (r"\left|\begin{array}{cc} a & b \\ c & d \end{array}\right|", "((a)*(d)-(b)*(c))"),
    (r"\begin{pmatrix} a = 1 \\ b = 2 \end{pmatrix}", r"\begin{pmatrix}a=1\\b=2\end{pmatrix}"),  # equations
])  # fmt: skip
def test_a_matrix_stands_in_one_piece_with_as_many_lines(text, piece):
    found = matrices_in_one_piece(text)
    assert ("".join(found.split()), found.count("\n")) == (piece, text.count("\n"))


@pytest.mark.parametrize(("text", "joined"), [
    ("$a$ - $b$", "$a - b$"), ("$a$ -- $b$ + $c$", "$a - b + c$"), ("$a$ and $b$", "$a$ and $b$"), ("$a$ = $b$", "$a$ = $b$"),
])  # fmt: skip
def test_formulas_with_a_sign_between_them_are_one(text, joined):
    assert with_formulas_joined(text) == joined
