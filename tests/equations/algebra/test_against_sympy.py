"""SymPy is the judge: what the house makes, differentiates and multiplies out has its values; what is equal has one form."""

import hashlib
import json
import math
import operator
import random
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp

import coursework
from coursework import InputError
from coursework.equations.algebra.calculus import derivative, expand, piecewise, replaced, together
from coursework.equations.algebra.expression import HALF, PI, ZERO, absolute, node, number, power, value
from coursework.equations.algebra.functions import call
from coursework.equations.algebra.symbolic_objects import symbolic, sympy_version
from coursework.equations.reduction.symbolic import local
from coursework.equations.reduction.textbook.cramer import cramer
from coursework.equations.reduction.textbook.solution import shown_equations, solutions
from coursework.scene.model.model import model_of
from coursework.variant.catalogue import entries
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from tests.equations.algebra.systems import chain, system
from tests.sample import first
from tests.solved import loaded

NAMES = ("v_r1", "v_r2", "v_phi1", "v_phi2", "t", "v_s")
MADE = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "exp": sp.exp, "atan": sp.atan}
# First 8 letters of the SHA-256 of what is printed where SymPy (1.14) reduces the equations of the catalogue, and which random
# systems it refuses, with the words that begin the fault.
PRINTED = json.loads((Path(__file__).parents[2] / "reference" / "printed_formulas.json").read_text(encoding="utf-8"))


def pair(dice, depth):
    """Return the same random expression, made by the house and by SymPy."""
    if depth == 0 or dice.random() < 0.15:
        if dice.random() < 0.2:
            value = Fraction(dice.choice((1, 2, 3, -1, -2)), dice.choice((1, 1, 2, 3)))
            return number(value), sp.Rational(value.numerator, value.denominator)
        name = dice.choice(NAMES)
        return local(name), sp.Symbol(name, real=True)
    (a, one), (b, other) = pair(dice, depth - 1), pair(dice, depth - 1)
    match dice.choice("++-****/^ffffr"):
        case "+":
            return a + b, one + other
        case "-":
            return a - b, one - other
        case "*":
            return a * b, one * other
        case "/" if other != 0:
            return a / b, one / other
        case "^":
            power = dice.choice((2, 3))
            return a**power, one**power
        case "f" if a.free_symbols:
            name = dice.choice((*MADE, "sin", "cos"))
            return call(name, a), MADE[name](one)
        case "r":
            return call("sqrt", a**2 + 1), sp.sqrt(one**2 + 1)
    return a, one


PLACE = {name: Fraction(4517 + 1739 * number**2 % 7919, 10007) for number, name in enumerate(NAMES)}


def at_place(own):
    """Return the value of the house's expression."""
    return value(replaced(own, {local(name): number(size) for name, size in PLACE.items()}))


def judged(judge):
    """Return the value of SymPy's."""
    return float(judge.subs({sp.Symbol(name, real=True): sp.Rational(size) for name, size in PLACE.items()}).evalf())


def is_expanded(own):
    return not any(
        (part.op == "*" and any(factor.op == "+" for factor in part.args))
        or (part.op == "^" and part.args[0].op == "+" and abs(part.args[1].value) in {2, 3})
        for part in own.walk()
    )  # fmt: skip


@pytest.mark.parametrize("seed", first(1, range(0, 600, 100)))
def test_expressions_mean_what_those_of_sympy_do(seed):
    for place in range(seed, seed + 100):
        own, judge = pair(random.Random(place), 4)
        if judge.has(sp.zoo, sp.nan, sp.oo, sp.E):
            continue
        wanted = pytest.approx(judged(judge), rel=1e-9, abs=1e-12)
        assert at_place(own) == wanted, place
        assert judged(symbolic(own)) == wanted, place
        assert at_place(expand(own)) == wanted, place
        assert is_expanded(expand(own)), place
        above, below = together(own)
        assert at_place(above) / at_place(below) == wanted, place
        slope = judged(sp.diff(judge, sp.Symbol("v_phi1", real=True)))
        assert at_place(derivative(own, local("v_phi1"))) == pytest.approx(slope, rel=1e-9, abs=1e-12), place


def test_what_is_equal_becomes_nothing_when_it_is_multiplied_out():
    for seed in range(100):
        (a, _), (b, _), (c, _) = (pair(random.Random(3 * seed + place), 2) for place in range(3))
        assert expand(a * (b - c) ** 2 - a * b**2 + 2 * (a * b * c) - c * (a * c)) is ZERO, seed


def test_one_denominator_below_and_none_above():
    a, b, c = map(local, "abc")
    assert together(a / (2 * b + 2 * c) + a / (b + c)) == (Fraction(3, 2) * a, b + c)
    assert together((1 / a + 1 / b) ** -1 + c / a) == (a**2 * b + (a + b) * c, a * (a + b))


@pytest.mark.parametrize(
    ("own", "judge"),
    [("sin", lambda x: sp.sin(x)), ("cos", lambda x: sp.cos(x)), ("tan", lambda x: sp.tan(x).rewrite(sp.tan))],
)
def test_right_angles_and_usual_parts_of_pi(own, judge):
    x = local("x")
    for twelfths in (part for part in range(-30, 31) if part % 2 == 0 or part % 3 == 0):
        for angle in (PI * twelfths / 12, x + PI * twelfths / 12 if twelfths % 6 == 0 else x - PI / 2):
            value = judge(symbolic(angle))
            assert (str(symbolic(call(own, angle))) if value != sp.zoo else "zoo") == str(value), (own, angle)


@pytest.mark.parametrize(
    ("time", "value"), [(0.0, 0.0), (0.9, 0.9), (1.0, 2.0), (1.1, 2.2), (2.9, 5.8), (3.0, 9.0), (50.0, 150.0)]
)
def test_a_law_in_pieces_is_one_of_sympys_too(time, value):
    """t before 1, 2 t before 3, 3 t then: at a break the piece that begins there."""
    t = local("t")
    law = symbolic(piecewise(t, t, number(1), 2 * t, number(3), 3 * t))
    assert law.subs(sp.Symbol("t", real=True), time) == value


@pytest.mark.parametrize("name", ["sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sqrt", "atan2"])
def test_derivatives_of_functions_are_sympys(name):
    x, place = local("x"), {sp.Symbol("x", real=True): sp.Rational(2, 7)}
    own = [2 * x, 3 * x**2 - x][: 2 if name == "atan2" else 1]
    others = [symbolic(part) for part in own]
    slope = symbolic(derivative(call(name, *own), x))
    judge = getattr(sp, name)(*others).diff(sp.Symbol("x", real=True))
    assert float(slope.subs(place)) == pytest.approx(float(judge.subs(place)), rel=1e-12)


def test_of_pieces_of_a_law_only_equal_neighbours_are_one():
    a, b, t = local("a"), local("b"), local("t")
    one, three = number(1), number(3)
    assert [str(part) for part in piecewise(t, a, one, b, three, a).args] == ["t", "a", "1", "b", "3", "a"]
    assert piecewise(t, a, one, a, three, b) is piecewise(t, a, three, b)
    assert piecewise(t, a, one, b, three, b) is piecewise(t, a, one, b)
    assert piecewise(t, a, one, a) is a


@pytest.mark.parametrize("inverse", ["asin", "acos", "atan"])
@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
def test_functions_of_inverse_ones(name, inverse):
    x = local("x")
    judge = getattr(sp, name)(getattr(sp, inverse)(sp.Symbol("x", real=True)))
    assert symbolic(call(name, call(inverse, x))) == judge


def test_of_an_expression_and_its_opposite_one_is_written_with_a_minus():
    for seed in range(300):
        own, judge = pair(random.Random(seed), 3)
        if own is not ZERO and not judge.has(sp.zoo, sp.nan, sp.oo, sp.E):
            assert own.has_minus != (-own).has_minus, seed
            assert call("sin", own) is -call("sin", -own), seed
            assert call("cos", own) is call("cos", -own), seed


def test_roots_and_absolute_values_take_out_what_is_known():
    a, b = local("a"), local("b")
    root = lambda part: power(part, HALF.value)  # noqa: E731
    assert root(number(Fraction(9, 4))) is number(Fraction(3, 2))
    assert root(number(2)) * root(number(2)) is number(2)
    assert power(number(8), Fraction(-2, 3)) is number(Fraction(1, 4))
    assert power(number(2), Fraction(-1, 2)) is HALF * root(number(2))
    assert root(4 * a**2 * b) is 2 * absolute(a) * root(b)
    assert absolute(-3 * a * b**2) is 3 * b**2 * absolute(a)
    assert absolute(b - a) is absolute(a - b)
    assert (absolute(a) ** 2, root(a) ** 4) == (a**2, a**2)


def test_equal_expressions_are_one_object_and_stay_so_in_a_copy():
    import pickle

    a, b = local("a"), local("b")
    assert a * b + 1 is 1 + b * a
    assert pickle.loads(pickle.dumps(call("sin", a) / b)) is call("sin", a) / b
    assert (number(3) is number(3), a - a is ZERO) == (True, True)
    assert node("sin", (-a,)) is not call("sin", -a)


def printed(variant):
    """Return all formulas of the blocks of a variant as text, or what is said where there are none."""
    try:
        model = model_of(variant)
    except InputError as fault:
        return str(fault).partition(" (")[0][:60]
    equations, reduction = model.equations, model.reduction
    lines = [spelled(block.determinant) if block.determinant else block.meaning for block in reduction.blocks]
    lines += [f"{name} = {spelled(formula)}" for solution in solutions(equations, reduction) for name, formula in solution]
    lines += [f"{spelled(one.left)} = {spelled(one.right)}" for one in shown_equations(equations, reduction)]
    for working in cramer(equations, reduction, [True] * len(reduction.blocks)):
        if working is not None:
            rows = (*working.coefficients, working.right_sides, working.numerators, (working.determinant,))
            lines += [spelled(one) for row in rows for one in row]
    return "\n".join(lines)


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:8]


@pytest.mark.parametrize("name", [entry.name for entry in entries() if not loaded(entry.name).forces])
def test_the_formulas_of_a_file_are_those_that_sympy_gave(name):
    assert digest(printed(coursework.load(name))) == PRINTED["files"][name]


MEANING = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "^": operator.pow, "neg": operator.neg}


def evaluated(tree, values):
    """Return the value of a formula, each name that has none yet a number of its own."""
    if tree.op == "number":
        return float(tree.name)
    if tree.op == "name":
        return math.pi if tree.name == "pi" else values.setdefault(tree.name, random.Random(tree.name).uniform(0.4, 1.3))
    args = [evaluated(arg, values) for arg in tree.args]
    if tree.op != "call":
        return MEANING[tree.op](*args)
    return {"abs": abs, "sign": lambda x: math.copysign(1, x)}.get(tree.name, getattr(math, tree.name, None))(*args)


@pytest.mark.parametrize("make", [system, chain])
@pytest.mark.parametrize("begin", first(1, range(0, 500, 50)))
def test_the_formulas_of_random_mechanisms_solve_the_equations_shown(make, begin):
    refused = {seed: told for told, seeds in PRINTED["faults"].items() for seed in seeds.get(make.__name__, ())}
    for seed in range(begin, begin + 50):
        try:
            model = model_of(parse_variant(make(seed), "x.toml"))
        except InputError as fault:
            assert str(fault).partition("  ")[0] == refused.get(seed), seed
            continue
        assert seed not in refused
        equations, reduction, values = model.equations, model.reduction, dict[str, float]()
        found = solutions(equations, reduction)
        for name, formula in [one for solution in found for one in solution]:
            values[name] = evaluated(formula, values)
        for working in filter(None, cramer(equations, reduction, [True] * len(reduction.blocks))) if all(found) else ():
            below = evaluated(working.determinant, values)
            for name, above in zip(working.unknowns, working.numerators, strict=True):
                assert evaluated(above, values) == pytest.approx(values[name] * below, rel=1e-9), (seed, name)
        used = [one for one in shown_equations(equations, reduction) if one.used]
        for one in used if all(found) else ():
            left, right = evaluated(one.left, values), evaluated(one.right, values)
            size = max(abs(left), abs(right), *(abs(values[name]) for solution in found for name, _ in solution))
            assert left == pytest.approx(right, abs=1e-9 * size), (seed, one.name)


def test_the_blocks_of_a_scene_are_sympy_when_asked_for():
    block = coursework.solve("31", quantities=["table"]).scene.reduction.blocks[2]
    assert [[str(entry) for entry in row] for row in block.matrix] == [
        ["v_r1*sin(v_phi1)", "v_r2*sin(v_phi2)"], ["-v_r1*cos(v_phi1)", "-v_r2*cos(v_phi2)"]
    ]  # fmt: skip
    assert all(isinstance(entry, sp.Expr) for entry in block.right_side)


def test_the_version_is_that_of_the_package():
    assert sympy_version() == sp.__version__
