"""Equations mean what the formula means, in text and in Typst, and look like the textbook."""

from __future__ import annotations

import math
import random
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from string import ascii_lowercase, ascii_uppercase
from types import ModuleType
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework.report.formulas import display, svg, typst_math
from coursework.report.formulas.svg import UNITS, draw, outline
from coursework.report.formulas.typesetting import typeset
from coursework.report.text.symbols import Rates
from coursework.variant.formula.reader import parse, parse_equation
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate
from coursework.words.custom_templates import templates_of

NAMES = ("r1", "r3", "w3", "phi1", "phi3", "VMx", "alpha", "t", "speed", "speed2", "AB", "wA", "p")


def random_tree(dice: random.Random, depth: int) -> Formula:
    if depth == 0 or dice.random() < 0.15:
        if dice.random() < 0.3:
            return Formula("number", name=dice.choice(("2", "0.5", "3", "1e-3", "2.5e2", "1")))
        return Formula("name", name=dice.choice(NAMES))
    kind = dice.choice(("+", "-", "*", "*", "*", "/", "/", "neg", "^", "call", "call"))
    if kind == "neg":
        return Formula("neg", (random_tree(dice, depth - 1),))
    if kind == "call":
        name = dice.choice(("sin", "cos", "tan", "sin", "cos", "sqrt", "abs", "exp", "log", "atan", "atan2"))
        count = 2 if name == "atan2" else 1
        return Formula("call", tuple(random_tree(dice, depth - 1) for _ in range(count)), name)
    if kind == "^":
        exponent = dice.choice((parse("2"), parse("3"), parse("-1"), parse("1/2"), parse("1"), parse("-(1/2)")))
        return Formula("^", (random_tree(dice, depth - 1), exponent))
    return Formula(kind, (random_tree(dice, depth - 1), random_tree(dice, depth - 1)))


@pytest.mark.long
@pytest.mark.parametrize("typst", [False, True], ids=["text", "typst"])
def test_an_equation_reads_back_to_the_same_number(reading: ModuleType, typst: bool) -> None:
    dice = random.Random(31)
    compared = 0
    for _ in range(4000):
        tree = random_tree(dice, dice.randint(1, 5))
        values = {name: dice.uniform(0.3, 2.0) for name in NAMES}
        source = typst_math.math(tree) if typst else typst_math.text(tree)
        try:
            expected = evaluate(tree, values)
            found = reading.value_of(source, values, typst=typst)
        except (FormulaFault, ValueError, ArithmeticError):
            continue  # the root or logarithm of a negative number, 0 as a divisor
        assert isinstance(found, float), source
        if abs(expected) < 1e9:
            assert found == pytest.approx(expected, rel=1e-6, abs=1e-9), (source, tree)
            compared += 1
    assert compared > 2000


def test_every_random_equation_is_typst() -> None:
    dice = random.Random(7)
    trees = [random_tree(dice, 4) for _ in range(150)]
    assert len(draw([typst_math.math(tree) for tree in trees]).pictures) > 100


def placed(element: Any, x: float = 0.0, y: float = 0.0, up: float = -1.0) -> Iterator[tuple[str, float, float]]:
    """Yield glyph and place (pt) of every copy in an SVG of Typst, shift by shift down to it."""
    kind, numbers = re.match(r"(\w*)\(?([^)]*)", element.get("transform", "")).groups()
    shift = [float(number) for number in numbers.split()] or [0.0, 0.0]
    x, y, up = x + shift[-2], y - up * shift[-1], 1.0 if kind == "matrix" else up
    if "href" in (own := {key.split("}")[-1]: value for key, value in element.attrib.items()}):
        yield own["href"][1:], x + float(own["x"]), y - up * float(own["y"])
    for below in element:
        if not below.tag.endswith("defs"):
            yield from placed(below, x, y, up)


def test_every_letter_of_a_formula_stands_where_typst_sets_it_and_none_has_a_shift_of_its_own() -> None:
    dice = random.Random(8)
    sources = list({typst_math.math(random_tree(dice, 4)): None for _ in range(40)})
    sources.append("mat(a_1; b; c; d; e) = sqrt(frac(x, sqrt(y + 1)))")
    pictures, pages = draw(sources).pictures, [typeset("equation.typ", [one], "svg").decode() for one in sources]
    letters = sorted({letter for page in pages for letter in re.findall(r'<symbol id="([^"]+)"', page)})
    used = Counter(letter for page in pages for letter in {glyph for glyph, *_ in placed(ElementTree.fromstring(page))})
    often = sorted(letters, key=lambda letter: (-used[letter], letter))  # the shortest names are for what stands everywhere
    names = {letter: (ascii_uppercase + ascii_lowercase)[place : place + 1] or f"g{place}" for place, letter in enumerate(often)}
    for source, typst in zip(sources, pages, strict=True):
        svg = pictures[source].svg
        assert "transform" not in svg
        top = float(re.search(r'viewBox="0 (\S+) ', svg)[1])
        found = []
        for line in re.finditer(r'<path class="([A-Za-z]|g\d+)" d="M0 0([^"]*)z"/>', svg):
            y = 0.0
            for step in re.findall(r"H[^HL]*|[L -][^HL]*", line[2]):
                numbers = [float(number) for number in re.findall(r"-?\d+", step)]
                for x, y in [(x, y) for x in numbers] if step[0] == "H" else zip(numbers[::2], numbers[1::2], strict=True):
                    found.append((line[1], x / UNITS, (y - top) / UNITS))
        wanted = sorted((names[glyph], x, y) for glyph, x, y in placed(ElementTree.fromstring(typst)))
        assert [glyph for glyph, _, _ in sorted(found)] == [glyph for glyph, _, _ in wanted]
        assert np.allclose([at[1:] for at in sorted(found)], [at[1:] for at in wanted], rtol=0, atol=0.501 / UNITS)


def test_a_formula_that_repeats_is_drawn_once() -> None:
    drawn = draw(["x_1 = y", "y", "x_1 = y"])
    assert drawn.glyphs.count('<g id="f') == 1
    assert re.search(r'<use href="#(f\d+)"/></svg>', drawn.pictures["x_1 = y"].svg)[1] in drawn.glyphs
    assert "<use" not in drawn.pictures["y"].svg


def test_an_own_template_may_set_each_formula_on_a_page_of_its_own(tmp_path: Path) -> None:
    each = 'page(width: auto, height: auto, margin: (x: 0pt, y: 2pt), math.equation(block: true, eval(source, mode: "math")))'
    (tmp_path / "equation.typ").write_text(f'#for source in json("/data.json").last() {{ {each} }}', encoding="utf-8")
    with templates_of(tmp_path):
        drawn = draw(["x_1 = y", "frac(a, b)"])
    assert [picture.svg.count("<path class=") for picture in drawn.pictures.values()] == [4, 2]
    assert drawn.glyphs.count("<marker") == 6


def test_a_letter_of_many_formulas_is_kept_once() -> None:
    """A desk draws a few new formulas with every page: they hold places, and share the outlines of their letters."""
    draw([f"omega_1 = {number}.5" for number in range(40)])
    outlines = [outline for _, glyphs in svg._cache.values() for outline in glyphs.values()]
    assert len({id(outline) for outline in outlines}) == len(set(outlines))


def test_no_rounding_adds_up_along_an_outline() -> None:
    dice = random.Random(3)
    steps = [(dice.choice("lhv"), round(dice.uniform(-9, 9), 5), round(dice.uniform(-9, 9), 5)) for _ in range(500)]
    way = "".join(f"{kind} {x} {y}" if kind == "l" else f"{kind} {x if kind == 'h' else y}" for kind, x, y in steps)
    exact, drawn = np.zeros(2), np.zeros(2)
    told = iter(re.findall(r"-?\d+", outline("M 0 0" + way)))  # a command is said once for all that follow
    for kind, x, y in steps:
        numbers = [float(next(told)) for _ in range(2 if kind == "l" else 1)]
        exact += {"l": (x, -y), "h": (x, 0), "v": (0, -y)}[kind]
        drawn += {"l": numbers, "h": [*numbers, 0], "v": [0, *numbers]}[kind]
        assert np.abs(drawn / UNITS - exact).max() < 0.501 / UNITS


@pytest.mark.parametrize(
    ("formula", "text", "typst"),
    [
        ("VMy/(r3*(2*cos(phi3)+sin(phi3)))", "V_My / (r₃ (2 cos φ₃ + sin φ₃))", "frac(V_(M y), r_3 (2 cos φ_3 + sin φ_3))"),
        ("-0.5*r3*w4 + r1*w1*sin(phi1)", "−0.5 r₃ ω₄ + r₁ ω₁ sin φ₁", "-0.5 r_3 ω_4 + r_1 ω_1 sin φ_1"),
        ("sin(phi1 - phi2)^2", "sin²(φ₁ − φ₂)", "sin^(2) (φ_1 - φ_2)"),
        ("sin(a)^2*cos(b)", "sin² a cos b", "sin^(2) a cos b"),
        ("sin(a)*b", "sin a · b", "sin a dot b"),
        ("a/b*c", "(a / b) c", "frac(a, b) c"),
        ("a/b/c", "(a / b) / c", "frac(frac(a, b), c)"),
        ("a-(b-c)", "a − (b − c)", "a - (b - c)"),
        ("a-(-b)", "a + b", "a + b"),
        ("a*(-b)", "a (−b)", "a (-b)"),
        ("(-a)^2", "(−a)²", "(-a)^(2)"),
        ("-a^2", "−a²", "-a^(2)"),
        ("2*3", "2 · 3", "2 dot 3"),
        ("sin(x)^(-1)", "(sin x)⁻¹", "(sin x)^(-1)"),
        ("x^(1/2)", "x^(1 / 2)", "x^(1 slash 2)"),
        ("asin(a)+atan(b)", "arcsin a + arctan b", "arcsin a + arctan b"),
        ("1e-3*x", "10⁻³ x", "10^(-3) x"),
        ("cos(phi5 - 0.2617993877991494)", "cos(φ₅ − 15°)", "cos(φ_5 - 15 degree)"),
        ("cos(phi5 - 0.58119464091)", "cos(φ₅ − 0.58119464091)", "cos(φ_5 - 0.58119464091)"),  # 33.3°, but too few digits
        ("cos(phi5 - 0.5811946409142)", "cos(φ₅ − 0.5811946409142)", "cos(φ_5 - 0.5811946409142)"),  # 2e-14 beside 33.3°
    ],
)
def test_equations_look_like_the_textbook(formula: str, text: str, typst: str) -> None:
    tree = parse(formula)
    assert typst_math.text(tree) == text
    assert typst_math.math(tree) == typst


def test_points_are_set_as_vectors() -> None:
    tree = parse("B + 2*r3 @ phi3", vectors=True)
    assert typst_math.text(tree) == "B + 2 r₃ ∠ φ₃"
    assert typst_math.text(parse("(C - (0, r3/2)).x", vectors=True)) == "(C − (0, r₃ / 2))_x"
    assert typst_math.text(parse("C.y", vectors=True)) == "y_C"
    assert len(draw([typst_math.math(tree), typst_math.math(parse("(C - (0, 1)).x", vectors=True))]).pictures) == 2


def test_a_derivative_takes_a_dot_only_where_it_is_one() -> None:
    w1 = Rates(frozenset({"w1"}))
    assert typst_math.text(Formula("name", name="dw1"), w1) == "ω̇₁" and typst_math.text(Formula("name", name="dw1")) == "dw₁"
    assert typst_math.text(Formula("name", name="du"), Rates(frozenset({"u"}))) == "u̇"
    assert typst_math.text(Formula("name", name="du")) == "du"
    assert typst_math.math(Formula("name", name="dw1"), w1) == "dot(ω)_1"


def test_a_long_sum_continues_on_the_next_line() -> None:
    terms = " + ".join(f"r{i}*w{i}*cos(phi{i})*sin(phi{i} - phi1)" for i in range(1, 12))
    source = display.math_equation(*parse_equation(f"{terms} = 0"))
    lines = source.split(r" \ ")
    assert len(lines) >= 4
    assert all(line.startswith("& ") for line in lines)
    assert lines[-1].endswith("= 0")
    draw([source])


def test_a_left_side_no_wider_than_the_indent_is_no_line_of_its_own() -> None:
    """A product that just does not fit would be no shorter below it; below a longer left side it is."""
    wide = parse("0.06*9.42478^2*sin(1.309)*1.98834*0.115662*0.278389*1.41421356*2.71828")
    assert display._width(wide, typst_math.Setter(typst=False)) > display.LINE - 4
    for name, left in (("w4", "ω_4"), ("r1*w4", "r_1 ω_4")):
        assert display.math_equation(parse(name), wide).startswith(f"& {left} = ")
    assert display.math_equation(parse("r1*w4 + r3"), wide).startswith(r"& r_1 ω_4 + r_3 \ & quad = ")


def test_a_wide_quotient_becomes_a_short_one_before_brackets(reading: ModuleType) -> None:
    terms = " + ".join(f"r{i}*w{i}*cos(phi{i} - phi{i + 1})*sin(alpha)" for i in range(1, 9))
    tree = parse(f"-r1*({terms})/(r2*sin(phi1 - phi2))")
    source = display.math_equation(parse("w4"), tree)
    assert r" \ & quad " in source
    assert "-frac(r_1, r_2 sin(φ_1 - φ_2)) [ r_1 ω_1" in source
    draw([source])
    plain = source.removeprefix("& ω_4 = ").replace("[", "(").replace("]", ")").replace(r"\ & quad", "")
    values = {name: math.sin(7 * place) + 1.5 for place, name in enumerate(tree.names())}
    assert reading.value_of(plain, values, typst=True) == pytest.approx(evaluate(tree, values))


def test_a_long_sum_behind_a_minus_continues_on_the_next_line(reading: ModuleType) -> None:
    """It was one line, which paper shrank until nobody could read it."""
    tree = parse("-(" + " + ".join(f"r{i}*w{i}*cos(phi{i} - phi{i + 1})*sin(alpha)" for i in range(1, 9)) + ")")
    source = display.math_equation(parse("u"), tree)
    assert source.startswith("& u = - [ r_1 ω_1") and source.count(r" \ & quad ") >= 2
    draw([source])
    plain = source.removeprefix("& u = ").replace("[", "(").replace("]", ")").replace(r"\ & quad", "")
    values = {name: math.sin(7 * place) + 1.5 for place, name in enumerate(tree.names())}
    assert reading.value_of(plain, values, typst=True) == pytest.approx(evaluate(tree, values))


@pytest.mark.parametrize(
    ("text", "wide", "is_negative"),
    [
        ("k*(a + b)", "a + b", False), ("-(k*(a + b))", "a + b", True), ("k*(a + b)/(c*k)", "a + b", False),
        ("(-(k*(a + b)))/c", "a + b", True), ("-((-(k*(a + b)))/c)", "a + b", False), ("(a + b)*(a + b + c)", "a + b + c", False),
    ],
)  # fmt: skip
def test_what_stands_before_brackets_times_the_sum_in_them_is_the_whole(text: str, wide: str, is_negative: bool) -> None:
    values, tree = {"a": 2.0, "b": 3.0, "c": 7.0, "k": 11.0}, parse(text)
    found = display._spread(tree, typst_math.Setter(typst=False))
    assert found is not None and (found[0], found[2]) == (is_negative, parse(wide))
    assert found[1] is not None
    assert evaluate(found[1], values) * evaluate(found[2], values) * (-1 if found[0] else 1) == pytest.approx(
        evaluate(tree, values)
    )
    for plain in ("a + b", "a*b/c"):
        assert display._spread(parse(plain), typst_math.Setter(typst=False)) is None
