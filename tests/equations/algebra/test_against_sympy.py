"""SymPy is the judge: what the house makes, differentiates and multiplies out is SymPy's, down to the order of parts."""

import hashlib
import json
import random
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp

import coursework
from coursework import InputError
from coursework.equations.algebra.calculus import derivative, expand
from coursework.equations.algebra.expression import PI, node, number, variable
from coursework.equations.algebra.functions import call
from coursework.equations.algebra.symbolic_objects import symbolic, sympy_version
from coursework.equations.algebra.tree import has_minus
from coursework.equations.reduction.cramer import cramer
from coursework.equations.reduction.solution import shown_equations, solutions
from coursework.scene.model.model import model_of
from coursework.variant.catalogue import entries
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from tests.equations.algebra.systems import chain, system

NAMES = ("v_r1", "v_r2", "v_phi1", "v_phi2", "t", "v_s")
MADE = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "exp": sp.exp, "atan": sp.atan}
OPS = {"Add": "+", "Mul": "*", "Pow": "^"}
# First 8 letters of the SHA-256 of what is printed where SymPy (1.14) reduces the equations.
PRINTED = json.loads((Path(__file__).parents[2] / "reference" / "printed_formulas.json").read_text(encoding="utf-8"))


def pair(dice, depth):
    """Return the same random expression, made by the house and by SymPy."""
    if depth == 0 or dice.random() < 0.15:
        if dice.random() < 0.2:
            value = Fraction(dice.choice((1, 2, 3, -1, -2)), dice.choice((1, 1, 2, 3)))
            return number(value), sp.Rational(value.numerator, value.denominator)
        name = dice.choice(NAMES)
        return variable(name), sp.Symbol(name, real=True)
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


def shape(expr):
    """Return a SymPy expression as nested tuples, its parts in their order."""
    if not expr.args:
        return str(expr)
    name = type(expr).__name__
    return OPS.get(name, name), *map(shape, expr.args)


def own_shape(expr):
    """Return the house's expression in the same way."""
    return (expr.op, *map(own_shape, expr.args)) if expr.args else expr.name or (expr.op if expr.op == "pi" else str(expr.value))


@pytest.mark.parametrize("seed", range(0, 600, 100))
def test_expressions_are_those_of_sympy(seed):
    for place in range(seed, seed + 100):
        own, judge = pair(random.Random(place), 4)
        if judge.has(sp.zoo, sp.nan, sp.oo, sp.E):
            continue
        angle = sp.Symbol("v_phi1", real=True)
        assert own_shape(own) == shape(judge), place
        assert own_shape(derivative(own, variable("v_phi1"))) == shape(sp.diff(judge, angle)), place
        assert own_shape(expand(own)) == shape(sp.expand(judge)), place
        assert symbolic(own) == judge, place


@pytest.mark.parametrize(
    ("own", "judge"),
    [
        ("sin", lambda x: sp.sin(x)), ("cos", lambda x: sp.cos(x)), ("tan", lambda x: sp.tan(x)), ("cot", lambda x: sp.cot(x)),
    ],
)  # fmt: skip
def test_right_angles_and_usual_parts_of_pi(own, judge):
    x = variable("x")
    for twelfths in (part for part in range(-30, 31) if part % 2 == 0 or part % 3 == 0):
        for angle in (PI * twelfths / 12, x + PI * twelfths / 12 if twelfths % 6 == 0 else x - PI / 2):
            value = judge(symbolic(angle))
            assert (str(symbolic(call(own, angle))) if value != sp.zoo else "zoo") == str(value), (own, angle)


@pytest.mark.parametrize("inverse", ["asin", "acos", "atan"])
@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
def test_functions_of_inverse_ones(name, inverse):
    x = variable("x")
    judge = getattr(sp, name)(getattr(sp, inverse)(sp.Symbol("x", real=True)))
    assert symbolic(call(name, call(inverse, x))) == judge


def test_a_minus_is_seen_where_sympy_sees_it():
    for seed in range(300):
        own, judge = pair(random.Random(seed), 3)
        if not judge.has(sp.zoo, sp.nan, sp.oo, sp.E):
            assert has_minus(own) == judge.could_extract_minus_sign(), (seed, judge)


def test_equal_expressions_are_one_object_and_stay_so_in_a_copy():
    import pickle

    a, b = variable("a"), variable("b")
    assert a * b + 1 is 1 + b * a
    assert pickle.loads(pickle.dumps(call("sin", a) / b)) is call("sin", a) / b
    assert (a == 0, number(3) == 3, a - a == 0) == (False, True, True)
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


@pytest.mark.parametrize("name", [entry.name for entry in entries()])
def test_the_formulas_of_a_file_are_those_that_sympy_gave(name):
    assert digest(printed(coursework.load(name))) == PRINTED["files"][name]


# Not compared: what SymPy makes of atan(1) and of atan(tan(2)), and formulas that are zero, at which the tool stopped.
OTHERWISE = {("system", 300), ("system", 309), ("chain", 125), ("chain", 360)}


@pytest.mark.parametrize("make", [system, chain])
@pytest.mark.parametrize("begin", range(0, 500, 100))
def test_the_formulas_of_random_mechanisms_are_those_that_sympy_gave(make, begin):
    wanted = PRINTED[make.__name__].split()
    for seed in range(begin, begin + 100):
        if (make.__name__, seed) not in OTHERWISE:
            try:
                variant = parse_variant(make(seed), "x.toml")
            except InputError as fault:
                found = str(fault).partition(" (")[0][:60]
            else:
                found = printed(variant)
            assert digest(found) == wanted[seed], seed


def test_the_blocks_of_a_scene_are_sympy_when_asked_for():
    block = coursework.solve("31", quantities=["table"]).scene.reduction.blocks[2]
    assert [[str(entry) for entry in row] for row in block.matrix] == [
        ["v_r1*sin(v_phi1)", "v_r2*sin(v_phi2)"], ["-v_r1*cos(v_phi1)", "-v_r2*cos(v_phi2)"]
    ]  # fmt: skip
    assert all(isinstance(entry, sp.Expr) for entry in block.right_side)


def test_the_version_is_that_of_the_package():
    assert sympy_version() == sp.__version__
