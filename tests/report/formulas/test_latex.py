"""LaTeX of the page's formulas: what TeX would refuse is nowhere, and read again it is the formula that it was."""

from __future__ import annotations

import pytest
from matplotlib.mathtext import MathTextParser

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.equations.lines import read_lines
from coursework.report.formulas.latex import latex
from coursework.report.text.parts import Display, Equations
from coursework.variant.catalogue import names
from tests.grading.scenes import expected
from tests.report.made import model_of, solved

IN_GATE = ("31", "cardan")


def displays(name: str, language: str = "en") -> list[Display]:
    parts = (part for section in model_of(solved(name), language).sections for part in section.parts)
    return [item for part in parts if isinstance(part, Equations) for item in part.items]


@pytest.mark.parametrize(
    ("typst", "wanted"),
    [
        ("ω_1 = -frac(r_3 ω_3, sin(φ_1 - φ_2))", r"\omega_1=-\frac{r_3\omega_3}{\sin(\varphi_1-\varphi_2)}"),
        ("V_(M y) = V_1 sin(p t + α)", r"V_{My}=V_1\sin(pt+\alpha)"),
        ("π t slash T + 15 degree", r"\pi t/T+15^\circ"),
        ("& a = b \\ & quad + c", "a=b+c"),
        ('φ_1 (1) = "1.63 + (−1.5) · 0.02 = 1.6"', r"\varphi_1(1)=1.63+(-1.5)\cdot0.02=1.6"),
        ('"1,5" + "−6·10⁻⁴" + "6.8²"', "1{,}5+-6\\cdot10^{-4}+6.8^{2}"),
        ('"ss" thin ω_3 dot dot(u)', r"\text{ss}\,\omega_3\cdot\dot{u}"),
        ("sin^(2) φ_0 frac(partial ω_1, partial t)", r"\sin^2\varphi_0\frac{\partial\omega_1}{\partial t}"),
        ('cases(0 quad "at 0 s", a quad "else")', r"\begin{cases}0\quad\text{at 0 s}\\a\quad\text{else}\end{cases}"),
        ("underline(underline(arrow(F)))_(12) + sqrt(abs(x))", r"\underline{\underline{\vec{F}}}_{12}+\sqrt{\left|x\right|}"),
    ],
)  # fmt: skip
def test_typst_becomes_latex(typst: str, wanted: str) -> None:
    assert latex(typst) == wanted


@pytest.mark.long
@pytest.mark.parametrize("name", [name if name in IN_GATE else pytest.param(name, marks=pytest.mark.long) for name in names()])
def test_tex_would_take_every_formula_of_a_page(name: str) -> None:
    reader = MathTextParser("path")
    for item in displays(name):
        text = latex(item.math)
        assert text.isascii() and "  " not in text, text
        if "{cases}" not in text:
            reader.parse(f"${text}$".replace(r"\underline", ""))


def test_a_decimal_comma_is_no_list() -> None:
    told = [latex(item.math) for item in displays("31", "ru")]
    assert r"\varphi_1(1)=1{,}63+(-1{,}57554)\cdot0{,}02=1{,}59849" in told


@pytest.mark.parametrize("name", ["31", "v107"])
def test_what_is_copied_is_marked_right_where_it_is_handed_in(name: str) -> None:
    variant = coursework.load(name)
    labels = {one.name for one in variant.constraints}
    chosen = {item.name: latex(item.math) for item in displays(name) if item.name in labels}
    assert len(chosen) == len(labels)
    read = read_lines("\n".join(f"${text}$" for text in chosen.values()), "equations.tex", expected(name)).equations
    marks = Judge(key_of(variant)).mark(read)
    assert {mark.verdict for mark in marks.marks} == {"right"}
    assert marks.share == 1.0
