"""A tree, written out and read again, has the same value; what is no formula is refused with its column, at once."""

import math
import time

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from coursework.variant.formula.reader import MAX_CHARACTERS, parse, parse_equation
from coursework.variant.formula.tree import Formula, FormulaFault, constant, evaluate, number, spelled
from tests.variant.formula.trees import NAMES, VECTORS, any_text, parts, scalar_trees, spoilt, vector_trees


def value(tree):
    try:
        return evaluate(tree, NAMES)
    except FormulaFault:
        return None


def place(tree):
    """Return both components of a vector formula, or the value of a scalar one; what has no value is NaN."""
    if tree.op == "part":
        return place(tree.args[0])[tree.name == "y"]
    if tree.op == "pair":
        return tuple(place(arg) for arg in tree.args)
    if tree.op == "@":
        length, angle = map(place, tree.args)
        return length * math.cos(angle), length * math.sin(angle)
    if tree.op == "name" and tree.name in VECTORS:
        return VECTORS[tree.name]
    if not any(node.op in {"@", "pair", "part"} or node.name in VECTORS for node in tree.walk()):
        found = value(tree)
        return math.nan if found is None else found
    first, *rest = map(place, tree.args)
    if tree.op == "neg":
        return tuple(-x for x in first)
    if tree.op == "*":
        return tuple(first * x for x in rest[0])
    return tuple(a + b if tree.op == "+" else a - b for a, b in zip(first, rest[0], strict=True))


def read(text, **options):
    try:
        return parse(text, **options)
    except FormulaFault as fault:
        assert 1 <= fault.column <= max(len(text), MAX_CHARACTERS) + 1
        return fault


@settings(max_examples=200, deadline=None)
@given(scalar_trees)
@example(Formula("neg", (Formula("^", (Formula("name", name="a"), Formula("number", name="2"))),)))
@example(Formula("^", (Formula("neg", (Formula("name", name="a"),)), Formula("number", name="2"))))
@example(Formula("-", (Formula("name", name="a"), Formula("neg", (Formula("name", name="b"),)))))
def test_written_and_read_again_a_formula_has_the_same_value(tree):
    again = read(spelled(tree))
    # Parts made of numbers alone may be refused (1/0, exp(999)); then the value is none, or an infinite step on the way to it.
    assume(isinstance(again, Formula))
    assert value(again) == value(tree)
    assert again.names() == tree.names()


@settings(max_examples=100, deadline=None)
@given(st.one_of(vector_trees, parts))
def test_vectors_are_written_and_read_again(tree):
    again = read(spelled(tree), vectors=True)
    assume(isinstance(again, Formula))
    assert again.names() == tree.names()
    assert place(again) == pytest.approx(place(tree), rel=1e-15, nan_ok=True)


@settings(max_examples=100, deadline=None)
@given(scalar_trees, scalar_trees)
def test_equations_are_written_and_read_again(left, right):
    try:
        sides = parse_equation(f"{spelled(left)} = {spelled(right)}")
    except FormulaFault:
        return
    assert [value(side) for side in sides] == [value(left), value(right)]


@pytest.mark.long
@settings(max_examples=150, deadline=None)
@given(any_text, st.booleans())
@example("(" * 10_000 + ")" * 10_000, False)
@example("-" * 100_000, False)
@example("sin(" * 5_000, True)
@example("1" * 5_000, False)
@example("a" * 5_000, False)
@example("(" * 2_000, True)
@example(".x" * 900, True)
@example("a" + ".x" * 900, True)
@example("((((((9^8)^8)^8)^8)^8)^8)", False)
@example("1e-999999999", False)
@example("0." + "0" * 1_900 + "1", False)
@example("9" * 1_900, False)
def test_any_text_is_read_or_refused_at_once(text, vectors):
    begun = time.process_time()
    read(text, vectors=vectors)
    for closure in (True, False):
        try:
            parse_equation(text, vectors=closure)
        except FormulaFault as fault:
            assert fault.message
    assert time.process_time() - begun < 2


@settings(max_examples=150, deadline=None)
@given(spoilt(scalar_trees.map(spelled)))
def test_a_spoilt_formula_is_read_or_refused(text):
    again = read(text)
    if isinstance(again, Formula):
        assume(set(again.names()) <= {*NAMES, "pi"})
        evaluated = value(again)
        assert evaluated is None or math.isfinite(evaluated)


@given(st.fractions(min_value=-1000, max_value=1000, max_denominator=10**6))
def test_exact_numbers_are_written_exactly(fraction):
    assert constant(parse(spelled(number(fraction)))) == fraction


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("-a^2", -(0.7**2)), ("2^-1", 0.5), ("a/b/2", 0.7 / 1.3 / 2), ("a/(b/2)", 0.7 / (1.3 / 2)), ("a-b-1", 0.7 - 1.3 - 1),
        ("a-(b-1)", 0.7 - 0.3), ("--a", 0.7), ("+a", 0.7), ("2**3", 8.0), ("a**2*b", 0.49 * 1.3), ("-2^2", -4.0), ("2·a", 1.4),
        ("tg(a)", math.tan(0.7)), ("ctg(a)", math.cos(0.7) / math.sin(0.7)), ("arctg(a)", math.atan(0.7)),
        ("ln(b)", math.log(1.3)),
        ("arcsin(a)", math.asin(0.7)), ("arccos(a)", math.acos(0.7)), ("arctan(a)", math.atan(0.7)), ("a²", 0.7**2),
        ("a³", 0.7**3),
        ("2⋅a×b∙1", 2 * 0.7 * 1.3), ("1÷2", 0.5), ("a−b", 0.7 - 1.3), ("π", math.pi), ("abs(-a)", 0.7), ("1e3", 1000.0),
        ("atan2(a, -b)", math.atan2(0.7, -1.3)), ("a^(1/2)", math.sqrt(0.7)), ("(((((a)))))", 0.7),
    ],
)  # fmt: skip
def test_meaning(text, meaning):
    assert evaluate(parse(text), NAMES) == pytest.approx(meaning, rel=1e-15)
