"""A scheme is its tableau: what is refused, what follows from it, and that it is named nowhere else."""

import ast
import json
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.motion.integration import adaptive, order_eight
from coursework.motion.integration.loops import generate_loop
from coursework.motion.schemes import SCHEMES, Scheme, _density, _trees
from coursework.report.formulas.lecture import lines
from coursework.report.pages import build_model
from coursework.variant.record import vocabulary
from tests.report.real import text_of
from tests.sources import files, nodes

ROOT = Path(__file__).parents[2]
HALF, SIXTH = Fraction(1, 2), Fraction(1, 6)
# Kutta's method of order three: a negative number, and nothing the tool knows.
DUMMY = Scheme("kutta3", "Kutta of order three", (0, HALF, 1), ((), (HALF,), (-1, 2)), (SIXTH, 4 * SIXTH, SIXTH), 3)
ADDED = """
from fractions import Fraction as F
from coursework.motion.schemes import SCHEMES, Scheme
from coursework.variant.record import vocabulary
half, sixth = F(1, 2), F(1, 6)
numbers = (0, half, 1), ((), (half,), (-1, 2)), (sixth, 4 * sixth, sixth)
SCHEMES["kutta3"] = Scheme("kutta3", "Kutta of order three", *numbers, order=3)
vocabulary.SCHEME_NAMES = (*vocabulary.SCHEME_NAMES, "kutta3")
from coursework.commands.cli import main
main()
"""


def moments(nodes, weights, count):
    """Return the sums of weights times powers of nodes: 1, 1/2, 1/3 … up to the order of a method, 0 of an estimated error."""
    return [sum(weight * nodes[place] ** power for place, weight in weights.items()) for power in range(count)]


def test_the_pairs_with_a_step_of_their_own_keep_the_conditions_of_their_orders():
    rows = adaptive._ROWS
    assert [sum(row.values()) for row in rows] == pytest.approx(adaptive._NODES, abs=1e-14)
    assert moments(adaptive._NODES, rows[-1], 5) == pytest.approx([1 / k for k in range(1, 6)], abs=1e-14)
    assert moments(adaptive._NODES, adaptive._ERROR, 4) == pytest.approx([0.0] * 4, abs=1e-14)
    nodes = [0.0, *(sum(row.values()) for row in order_eight._ROWS)]
    squares = [moments(nodes, row, 2)[1] for row in order_eight._ROWS[1:]]
    assert squares == pytest.approx([node**2 / 2 for node in nodes[2:]], abs=1e-13)
    assert nodes[-1] == pytest.approx(1.0, abs=1e-13)
    assert moments(nodes, order_eight._RESULT, 8) == pytest.approx([1 / k for k in range(1, 9)], abs=1e-13)
    for error, order in ((order_eight._THIRD, 3), (order_eight._FIFTH, 5)):
        assert moments(nodes, error, order) == pytest.approx([0.0] * order, abs=1e-13)
        assert abs(moments(nodes, error, order + 1)[-1]) > 1e-6


@pytest.fixture
def added(monkeypatch):
    monkeypatch.setitem(SCHEMES, DUMMY.name, DUMMY)
    monkeypatch.setattr(vocabulary, "SCHEME_NAMES", (*vocabulary.SCHEME_NAMES, DUMMY.name))


def test_a_file_may_name_every_scheme_and_no_other():
    assert tuple(SCHEMES) == vocabulary.SCHEME_NAMES


# ---- what a tableau must satisfy


@pytest.mark.parametrize(
    ("nodes", "rows", "weights", "order", "fault"),
    [
        ((0, HALF), ((), (1,)), (0, 1), 2, "row 2 adds up to 1, not to its node 1/2"),
        ((0, HALF), ((), (HALF,)), (HALF, 1), 2, "the weights add up to 3/2, not to 1"),
        ((0, HALF), ((), (HALF,)), (1,), 2, "2 nodes need as many weights, and rows of 0 to 1 numbers"),
        ((0, HALF), ((), (HALF, HALF)), (0, 1), 2, "2 nodes need as many weights"),
        ((0, 0.5), ((), (0.5,)), (0, 1), 2, "whole numbers or fractions"),
        ((0, HALF), ((), (HALF,)), (HALF, HALF), 2, "order 2 is stated, but a condition of order 2 is not met"),
        ((0, HALF), ((), (HALF,)), (0, 1), 1, "order 1 is stated, but every condition of order 2 is met too"),
        ((0, HALF), ((), (HALF,)), (0, 1), 3, "order 3 is stated, but a condition of order 3 is not met"),
        (
            (0, HALF, HALF, 1),
            ((), (HALF,), (0, HALF), (0, 0, 1)),
            (SIXTH, 2 * SIXTH, SIXTH, 2 * SIXTH),
            4,
            "condition of order 2",
        ),
        (
            (0, HALF, HALF, 1),
            ((), (HALF,), (HALF, 0), (0, 0, 1)),
            (SIXTH, 2 * SIXTH, 2 * SIXTH, SIXTH),
            4,
            "condition of order 3",
        ),
    ],
)
def test_numbers_that_are_no_scheme_of_this_order_are_refused(nodes, rows, weights, order, fault):
    with pytest.raises(ValueError, match=re.escape(fault)):
        Scheme("slip", "a slip", nodes, rows, weights, order)


def test_the_trees_are_all_there_once():
    """1, 1, 2, 4, 9, 20, 48 rooted trees; the reciprocals of their densities, each with its weight, add up to known sums."""
    listed = [list(_trees(size)) for size in range(1, 8)]
    assert [len(trees) for trees in listed] == [1, 1, 2, 4, 9, 20, 48]
    assert all(len(set(trees)) == len(trees) for trees in listed)
    assert sorted(map(_density, listed[3])) == [4, 8, 12, 24]  # the conditions of order four of every textbook


def test_the_order_of_a_tableau_with_six_slopes():
    """Butcher's order five with six slopes: conditions beyond those of order four are looked at too."""
    f = Fraction
    rows = ((), (f(1, 4),), (f(1, 8), f(1, 8)), (0, -HALF, 1), (f(3, 16), 0, 0, f(9, 16)))
    rows += ((f(-3, 7), f(2, 7), f(12, 7), f(-12, 7), f(8, 7)),)
    nodes, weights = (0, f(1, 4), f(1, 4), HALF, f(3, 4), 1), (f(7, 90), 0, f(32, 90), f(12, 90), f(32, 90), f(7, 90))
    assert Scheme("butcher", "Butcher", nodes, rows, weights, 5).slopes == 6
    with pytest.raises(ValueError, match="every condition of order 5"):
        Scheme("butcher", "Butcher", nodes, rows, weights, 4)


# ---- what follows from it


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("euler", ["q_{i+1} = q_i + h f(t_i, q_i)"]),
        ("midpoint", ["q_{i+1} = q_i + h f(t_i + h/2, q_i + h/2 f(t_i, q_i))"]),
        ("heun", ["k₁ = f(t_i, q_i), k₂ = f(t_i + h, q_i + h k₁)", "q_{i+1} = q_i + h/2 (k₁ + k₂)"]),
        ("ralston", ["k₁ = f(t_i, q_i), k₂ = f(t_i + 2/3 h, q_i + 2/3 h k₁)", "q_{i+1} = q_i + h/4 (k₁ + 3 k₂)"]),
        (
            "rk4",
            [
                "k₁ = f(t_i, q_i), k₂ = f(t_i + h/2, q_i + h/2 k₁)",
                "k₃ = f(t_i + h/2, q_i + h/2 k₂), k₄ = f(t_i + h, q_i + h k₃)",
                "q_{i+1} = q_i + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)",
            ],
        ),
    ],
)
def test_the_formula_is_that_of_the_lecture(name, shown):
    assert [plain for _, plain in lines(SCHEMES[name])] == shown


def test_a_negative_number_is_shown_as_a_minus():
    assert [plain for _, plain in lines(DUMMY)][1] == "k₃ = f(t_i + h, q_i + h (-k₁ + 2 k₂))"


@pytest.mark.parametrize("name", SCHEMES)
def test_ten_steps_of_a_linear_equation_are_the_polynomial_of_the_scheme(name):
    """For q' = a q a scheme of s = p slopes multiplies by the first terms of exp(a h): worked out here, not by the tool."""
    scheme, factor = SCHEMES[name], -0.7 * 0.1
    grows = sum(factor**power / np.prod(range(1, power + 1)) for power in range(scheme.order + 1))
    q = 1.0
    for index in range(10):
        q = scheme.step(lambda _t, at: -0.7 * at, 0.1 * index, q, 0.1)
    assert q == pytest.approx(grows**10, rel=1e-14)


def test_time_is_taken_at_the_nodes():
    """q' = 3 t^2 from 0 to 1 in one step is the quadrature of the tableau: 1 from order three on, and Ralston's is 1 too."""
    once = {name: scheme.step(lambda t, _q: 3 * t * t, 0.0, 0.0, 1.0) for name, scheme in SCHEMES.items()}
    assert once == pytest.approx({"euler": 0.0, "midpoint": 0.75, "heun": 1.5, "ralston": 1.0, "rk4": 1.0}, abs=1e-15)


# ---- one more scheme, everywhere


def test_an_added_scheme_makes_tables_of_its_order(added):
    """Order, count of slopes and the generated loop are those of the added tableau."""
    errors = []
    for halvings in (3, 4, 5):
        run = coursework.solve("31", "kutta3", step=0.02 / 2**halvings, quantities=["table"])
        errors.append(np.max(np.abs(run.motion.coordinates - run.exact.coordinates)))
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx(3, abs=0.1)
    run = coursework.solve("31", "kutta3", quantities=["table"])
    assert run.motion.evaluations == 24 * 3
    loop = generate_loop(DUMMY, run.scene.rates)
    assert loop(0.0, 24, 0.02, *run.scene.start) == tuple(run.motion.coordinates[-1])


def test_an_added_scheme_is_on_the_page_and_in_the_accuracy_study(added):
    run = coursework.solve("31", "kutta3", quantities=["table", "accuracy"])
    sections = {section["name"]: text_of(section) for section in build_model(run).plain()["sections"]}
    assert "Kutta of order three" in sections["method"]
    assert "h/6 (k₁ + 4 k₂ + k₃)" in sections["method"]
    assert "Kutta of order three" in sections["results"]
    assert {row.method for row in run.accuracy.rows} >= {"Kutta of order three", "Ralston"}
    assert run.accuracy.orders["Kutta of order three"] == pytest.approx(3, abs=0.1)


def test_an_added_scheme_is_in_files_help_and_plan(added, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["run", "31", "--scheme", "kutta3", "--quantities", "table", "--format", "csv"])
    assert done.exit_code == 0
    assert "Kutta of order three, h = 0.02 s, 25 rows" in done.stdout
    assert json.loads(Path("coursework-31/run.json").read_text(encoding="utf-8"))["scheme"] == "kutta3"
    plan = CliRunner().invoke(main, ["run", "31", "--scheme", "kutta3", "--plan"])
    assert "Kutta of order three, 3 evaluations per step" in plan.stdout
    shown = subprocess.run([sys.executable, "-c", ADDED, "run", "--help"], capture_output=True, text=True, encoding="utf-8")
    assert "kutta3" in shown.stdout
    unknown = CliRunner().invoke(main, ["run", "31", "--scheme", "kuta3"])
    assert 'Did you mean "kutta3"?' in unknown.stderr


def test_no_scheme_is_named_outside_its_file():
    """Neither by its name nor by its title nor as a constant, in the program and in the templates.

    The measure `euler_error` is called so in the format of a ranges file.  What a student may have taken for Euler's rule has
    codes of its own, which happen to be called as schemes are.  A sheet of the workbook is called *Euler* in every language.
    """
    named = re.compile("|".join(rf"\b{re.escape(word)}" for s in SCHEMES.values() for word in (s.name, s.title)), re.IGNORECASE)
    found = []
    for path in files():
        if path.name not in {"schemes.py", "vocabulary.py"} and "marking" not in path.parts:
            found += [
                f"{path.name}:{line} {text}"
                for line, text in _texts_and_names(path)
                if named.search(text) and text != "euler_error" and (path.parent.name, text) != ("workbook", "Euler")
            ]
    for path in (*(ROOT / "reports").glob("*.j2"), *(ROOT / "reports").glob("*.typ")):
        found += named.findall(path.read_text(encoding="utf-8"))
    assert found == []


def _texts_and_names(path):
    """Yield (line, text) of every text that is no docstring and of every name in a Python file."""
    blocks = (ast.Module, ast.ClassDef, ast.FunctionDef)
    docs = {id(n.body[0].value) for n in nodes(path) if isinstance(n, blocks) and n.body and isinstance(n.body[0], ast.Expr)}
    for node in nodes(path):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            yield node.lineno, node.value
        elif isinstance(node, (ast.Name, ast.Attribute, ast.alias)):
            yield node.lineno, getattr(node, "id", "") or getattr(node, "attr", "") or getattr(node, "name", "")
