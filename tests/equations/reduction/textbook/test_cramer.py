"""Cramer's rule and its compact forms as functions: at random points what is shown and what is computed solve the equations."""

import json
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import coursework
from coursework.equations.algebra.calculus import expand, replaced
from coursework.equations.algebra.expression import ZERO, add
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import compile_system
from coursework.equations.reduction.textbook.cramer import cramer
from coursework.equations.reduction.tidying.sums import gathered, written_sums
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import evaluate, spelled
from coursework.variant.reading.reader import parse_variant

CASES = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[3] / "reference" / "hard_cases.json").read_text(encoding="utf-8"))["cases"]
}
HEAD = """[given]
a = "0.7 m"
b = "1.3 m"
c = "2.1 m"
[drive]
V = "3*cos(t + 1)"
{drive}
[coordinates]
{coordinates}
[time]
step = "0.1 s"
end = "0.1 s"
"""
COEFFICIENTS = [
    "a*cos(q{i})", "-b*sin(q{i})", "c", "0.5*b", "-a*sin(q{i} - q{j})", "b*cos(q{i} + q{j})", "(a + b)*cos(q{j})",
    "a*b/c*sin(q{j})", "a*(2*cos(q{i}) + sin(q{j}))", "-(a*cos(q{i}) + b*cos(q{j}))", "a*cos(q{i})^2", "a*tan(0.1*q{j})",
    "c/(2 + cos(q{i}))", "a*q{j}",
    "sqrt(a^2 + b^2*sin(q{j})^2)", "a*exp(0.1*q{i})", "-a*sin(q{i})*cos(q{j})", "a*cos(q{i})*sin(q{j})", "b*sin(q{i})*sin(q{j})",
]  # fmt: skip
RIGHT = ["V", "-2*V*cos(q{i})", "a*V + b", "0", "b*sin(q{j})", "V*(cos(q{i}) - sin(q{j}))"]


@st.composite
def systems(draw):
    """Return the equations of a square system that can be matched; each a list of (column, coefficient) and a right side."""
    size = draw(st.integers(2, 4))
    order = draw(st.permutations(range(size)))
    equations = []
    for row in range(size):
        columns = sorted({order[row], *draw(st.sets(st.integers(0, size - 1), min_size=1, max_size=2))})
        i, j = draw(st.sampled_from([(0, 1), (1, 0), (size - 1, 0), (row, (row + 1) % size)]))
        terms = [(column, draw(st.sampled_from(COEFFICIENTS)).format(i=i, j=j)) for column in columns]
        equations.append((terms, draw(st.sampled_from(RIGHT)).format(i=i, j=j)))
    return size, equations


def as_variant(size, equations):
    coordinates = "\n".join(f'q{k} = {{ start = "{0.3 + 0.2 * k} rad", rate = "u{k}" }}' for k in range(size))
    text = HEAD.format(coordinates=coordinates, drive="")
    for terms, right in equations:
        left = " + ".join(f"({coefficient})*u{column}" for column, coefficient in terms)
        text += f'[[constraint]]\nequation = "{left} = {right}"\n'
    return parse_variant(text, "v.toml")


# Terms that an addition theorem would join but for their divisors, of which each has its own.
OTHER_DIVISORS = (2, [
    ([(0, "c/(2 + cos(q1))"), (1, "-a*sin(q1)*cos(q0)")], "V"), ([(0, "c/(2 + cos(q0))"), (1, "-a*sin(q0)*cos(q1)")], "V"),
])  # fmt: skip


@settings(max_examples=60, deadline=None)
@given(systems(), st.integers(0, 10**6))
@example((2, [([(0, "a*cos(q0)"), (1, "b*cos(q1)")], "V"), ([(0, "-a*sin(q0)"), (1, "-b*sin(q1)")], "0")]), 1)
@example((2, [([(0, "c"), (1, "c")], "V"), ([(0, "a*cos(q0)"), (1, "b*q1")], "0")]), 2)
@example(OTHER_DIVISORS, 0)
def test_shown_and_computed_solve_the_system(system, seed):
    size, equations = system
    try:
        run = coursework.solve(as_variant(size, equations), quantities=["table"])
        blocks, rates = run.reduction.blocks, run.scene.rates
    except coursework.InputError:
        return  # this draw is singular; which equations are to blame is told in other tests
    assert sorted(name for block in blocks for name in block.unknowns) == [f"u{k}" for k in range(size)]
    linear = compile_system(run.scene.equations, run.scene.equations.equations)
    names = run.scene.equations.unknowns
    generator = np.random.default_rng(seed)
    for _ in range(3):
        t, q = generator.uniform(0, 1), generator.uniform(-2, 2, size).tolist()
        matrix, right, _ = linear.matrix(t, q)
        if np.linalg.cond(matrix) > 1e5:
            continue
        wanted = np.linalg.solve(matrix, right)
        try:
            found = rates.evaluate(t, *q)
        except ZeroDivisionError:
            continue
        slack = 1e-9 * (1 + np.max(np.abs(wanted)))
        assert found[:size] == pytest.approx(wanted, rel=0, abs=slack)
        values = {**run.variant.values, "t": t, "V": 3 * np.cos(t + 1), **{f"q{k}": value for k, value in enumerate(q)}}
        values |= dict(zip(names, wanted.tolist(), strict=True))
        for block, solution in zip(blocks, run.solutions, strict=True):
            assert bool(solution) == (block.size <= 2)
            for name, formula in solution:
                assert evaluate(formula, values) == pytest.approx(values[name], rel=0, abs=slack)
            if block.size <= 2:
                numbers = [[evaluated(entry, values) for entry in row] for row in block.matrix]
                assert evaluate(block.determinant, values) == pytest.approx(np.linalg.det(numbers), rel=1e-9, abs=1e-12)


def evaluated(expression, values):
    return float(expression.subs({symbol: values[symbol.name.removeprefix("v_")] for symbol in expression.free_symbols}))


@settings(max_examples=40, deadline=None)
@given(systems())
def test_a_block_uses_earlier_velocities_only(system):
    try:
        run = coursework.solve(as_variant(*system), quantities=["table"])
        blocks = run.reduction.blocks
    except coursework.InputError:
        assume(False)
    known = set()
    for block in blocks:
        entries = [*block.right_side, *(entry for row in block.matrix for entry in row)]
        used = {str(s) for entry in entries for s in entry.free_symbols} & set(run.scene.equations.unknowns)
        assert used <= known
        known |= set(block.unknowns)


def written(equations, unknowns, start="0.3 rad"):
    """Return a variant of these equations; the first unknown is the rate of the angle f."""
    text = HEAD.format(coordinates=f'f = {{ start = "{start}", rate = "{unknowns[0]}" }}', drive='v = "1"')
    text += "[unknowns]\n" + "".join(f'{name} = "1/s"\n' for name in unknowns[1:])
    text = text.replace("[given]\n", '[given]\nr1 = "0.5 m"\n')
    return parse_variant(text + "".join(f'[[constraint]]\nequation = "{equation}"\n' for equation in equations), "v.toml")


def told(equations, unknowns):
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(written(equations, unknowns), quantities=["table"]).columns()
    return str(caught.value)


def test_hard_case_12_over_and_under_determined():
    equations = [equation.replace("=", " = ") for equation in CASES["H12"]["data"]["equations"]]
    sentence = told(equations, ["w1", "w2", "w3", "w4"])
    assert "3 independent equations of 4" in sentence
    assert "Equation 3 contradicts equations 1 and 2 together" in sentence
    assert "Missing: something for w3 and w4." in sentence
    assert "Equations 1, 2 and 3 contain only w1 and w2. w3 and w4 appear only in equation 4." in sentence


def test_hard_case_13_redundant():
    run = coursework.solve(written(["w1*r1*cos(f) = v", "2*w1*r1*cos(f) = 2*v", "w2 = w1"], ["w1", "w2"]), quantities=["table"])
    expected = CASES["H13"]["expected"]
    assert run.motion.velocities[0] == pytest.approx([float(expected["w1"]), float(expected["w2"])], rel=1e-15)
    assert run.reduction.notes == ("Equation 2 says the same as 1; it is not needed and only checked.",)


def test_hard_case_14_contradictory():
    sentence = told(["w1 = 1", "w1 = 1.001", "w2 = w1"], ["w1", "w2"])
    assert "Equation 2 contradicts equation 1: the right sides differ by 0.001 at t = 0." in sentence


def test_hard_case_15_not_linear():
    sentence = told(["w1^2 + w1*w2 = 3", "w2 = 2"], ["w1", "w2"])
    assert sentence.startswith(
        "V402 v.toml:17  constraint 1, column 3: the equation is not linear in the unknown velocities (w1) "
        'because of a power, "w1^2".'
    )
    assert "choose the sign and give the velocity itself" in sentence


@pytest.mark.parametrize(
    ("equations", "sentence"),
    [
        (["w1 = v"], " Missing: something for w2. w2 appears in no equation: write one with it, or leave it out."),
        (["w1 + w2 = v"], "Missing: something for w1 and w2. w1 and w2 appear only in equation 1."),
        (["w1 = v", "0 = 0"], "Equation 2 says nothing about the unknown velocities."),
        (["w1 = v", "w2 = v", "0 = v"], "Equation 3 contradicts 0 = 0: the right sides differ by 1 at t = 0."),
        (["w1 + w2 = v", "2*w1 + 2*w2 = 2*v"], "Equation 2 says the same as 1. Missing: something for w1 and w2."),
        (["w1 = v", "w1*cos(f)^2 + w1*sin(f)^2 = v"], "Equation 2 says the same as 1."),
    ],
)
def test_what_is_missing_or_too_much_is_said_by_name(equations, sentence):
    assert sentence in told(equations, ["w1", "w2"])


def test_no_solver_and_no_simplifier_of_sympy_is_called(monkeypatch):
    def refuse(*_args, **_options):
        raise AssertionError("a solver or simplifier of SymPy was called")

    homes = ("sympy", "sympy.simplify.simplify", "sympy.simplify.trigsimp", "sympy.solvers.solvers", "sympy.solvers.solveset")
    for home in map(import_module, homes):
        for name in ("solve", "linsolve", "solveset", "nonlinsolve", "simplify", "trigsimp", "nsimplify", "solve_linear_system"):
            monkeypatch.setattr(home, name, refuse, raising=False)
    for name in ("31", "v108", "jansen", "example-6", "variable-crank"):
        run = coursework.solve(name, quantities=["table", "accelerations"])
        assert len(run.columns()[1]) == len(run.motion.t)


def test_a_sum_that_the_author_wrote_as_one_length_stays_one():
    run = coursework.solve("v108", quantities=["table"])
    first, _, _ = cramer(run.scene.equations, run.scene.reduction, [True] * 3)
    assert spelled(first.determinant) == "(R0 + R4)*(a*sin(phi3 - theta) + c*cos(phi3 - theta))"
    assert spelled(first.coefficients[0][1]) == "(R0 + R4)*sin(theta)"
    told = " ".join(spelled(formula) for solution in run.solutions for _, formula in solution)
    assert "(R0 + R4)" in told
    values = {given.name: given.value for given in run.variant.given} | {"phi3": 0.7, "theta": 2.1, "VMx": 1.3, "VMy": -0.4}
    (a, b), (c, d) = ([evaluate(one, values) for one in row] for row in first.coefficients)
    assert evaluate(first.determinant, values) == pytest.approx(a * d - b * c)
    assert evaluate(first.numerators[0], values) == pytest.approx(
        evaluate(first.right_sides[0], values) * d - b * evaluate(first.right_sides[1], values)
    )


@pytest.mark.parametrize(("text", "whole"), [("R0 + R4", True), ("R0 + s", False), ("R0 + R4 + s", False), ("R0*R4", False)])
def test_only_what_is_a_sum_of_data_alone_is_one(text, whole):
    assert len(written_sums([parse(f"({text})*sin(phi)")], frozenset({"R0", "R4"}))) == whole


def test_a_length_that_is_a_part_of_a_datum_less_stays_one_length():
    """M + (L1 - L1/k) @ phi4: its derivative is not multiplied out."""
    shown = {one.name: spelled(one.left) for one in coursework.solve("pantograph", quantities=["table"]).equations}
    assert shown["3x"].count("(L1 - L1/k)") == shown["3y"].count("(L1 - L1/k)") == 2
    assert shown["3x"].count("L1") == 4


def test_the_square_of_such_a_length_is_one_factor_too():
    """w2 of the pantograph stands in rows that both have L1 - L1/k as a factor: Cramer's rule multiplies it by itself."""
    run = coursework.solve("pantograph", quantities=["table"])
    working = cramer(run.scene.equations, run.scene.reduction, [True] * 2)[1]
    assert spelled(working.determinant) == "-(L1 - L1/k)*L2*sin(phi2 - phi4)/k"
    assert spelled(working.numerators[0]).startswith("(L1 - L1/k)*((L1 - L1/k)*w1*sin(phi1 - phi4)")
    values = {given.name: given.value for given in run.variant.given} | {"w1": 1.3, "w3": -0.4}
    values |= {"phi1": 2.3, "phi2": 0.7, "phi3": 0.5, "phi4": 2.1}
    (a, b), (c, d) = ([evaluate(one, values) for one in row] for row in working.coefficients)
    first, second = (evaluate(side, values) for side in working.right_sides)
    assert evaluate(working.determinant, values) == pytest.approx(a * d - b * c)
    assert evaluate(working.numerators[0], values) == pytest.approx(first * d - b * second)


@pytest.mark.parametrize("powers", [(2, 0), (2, 1), (3, 0), (0, 1), (1, 2)])
def test_what_is_gathered_is_worth_what_was_multiplied_out(powers):
    a, b, x, y, name = map(symbol, ("a", "b", "x", "y", "s"))
    whole = expand(add(*[(a - b) ** power * factor for power, factor in zip(powers, (x, y), strict=True)]))
    shorter = gathered([*whole.terms], {name: a - b})
    assert expand(replaced(add(*shorter), {name: a - b}) - whole) is ZERO
    assert len(shorter) < len(whole.terms)
