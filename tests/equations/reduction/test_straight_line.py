"""Generated lines mean what the expressions mean, for floats and for arrays, and compute every value once."""

import math
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from coursework import InputError
from coursework.equations.algebra.calculus import derivative, piecewise
from coursework.equations.algebra.expression import PI, POLE, absolute, add, number
from coursework.equations.algebra.expression import value as value_of
from coursework.equations.algebra.functions import call, cosine, sine
from coursework.equations.algebra.symbolic_objects import symbolic
from coursework.equations.codegen.programs import Assign, Solve, compile_function, program
from coursework.equations.reduction.symbolic import expanded, local

x, y, c = map(local, ("x", "y", "c"))
CONSTANTS = {"c": -0.75}
LEAVES = st.sampled_from([x, y, c, number(2), number(Fraction(-3, 7)), PI])
# Powers stand over something with x in it: those of numbers alone are worked out, and nested ones have no end of digits.
NODES = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] - pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] / (pair[1] ** 2 + 1)),
        st.tuples(inner, st.sampled_from([2, 3, 5])).map(lambda pair: (pair[0] + x) ** pair[1]),
        inner.map(sine), inner.map(cosine), inner.map(lambda e: call("atan", e)), inner.map(absolute),
        inner.map(lambda e: call("sqrt", (e + x) ** 2 + 1)), inner.map(lambda e: ((e - x) ** 2 + 1) ** Fraction(-3, 2)),
    ),
    max_leaves=12,
)  # fmt: skip


def compiled(*wanted, arrays=False, definitions=None):
    """Return the function of x and y for some expressions."""
    results = [f"_out{place}" for place in range(len(wanted))]
    statements = [Assign(local(name), expr) for name, expr in zip(results, wanted, strict=True)]
    body = program(statements, definitions or {}, list(CONSTANTS), {}).bind(CONSTANTS)
    return compile_function("values", ["x", "y"], body, results, numpy=arrays)


@settings(max_examples=75, deadline=None, derandomize=True)  # a sine of 1e9 has few digits: none is drawn anew each run
@given(st.lists(NODES, min_size=1, max_size=3))
def test_the_lines_mean_the_expressions(wanted):
    points = [(0.3, -1.1), (1.7, 0.4), (-0.9, 2.2)]
    one, many = compiled(*wanted), compiled(*wanted, arrays=True)
    columns = many(*map(np.array, zip(*points, strict=True)))
    for place, (a, b) in enumerate(points):
        try:
            found = one(a, b)
        except OverflowError:
            continue
        for value, column, expr in zip(found, columns, wanted, strict=True):
            meant = float(
                sp.N(
                    symbolic(expr).subs(
                        dict(zip(map(symbolic, (x, y, c)), (sp.Float(a, 30), sp.Float(b, 30), sp.Rational(-3, 4)), strict=True))
                    ),
                    30,
                )
            )
            assert value == pytest.approx(meant, rel=1e-9, abs=1e-9 * max(1.0, abs(meant)))
            assert np.broadcast_to(column, 3)[place] == pytest.approx(value, rel=1e-12, abs=1e-12)


def test_a_value_read_twice_is_computed_once():
    source = compiled(c * sine(x) * y, -c * sine(x) * y, sine(x) ** 2 * (y - x), (x - y) * cosine(x)).__doc__
    assert source.count("sin(") == 1
    assert source.count("cos(") == 1
    assert source.count("x - y") + source.count("y - x") == 1, source


def test_a_definition_is_written_where_it_is_first_read():
    source = compiled(y * x, local("v") + 1, definitions={local("v"): sine(x)}).__doc__
    lines = [line.strip() for line in source.splitlines()]
    assert lines[1:] == ["_out0 = x*y", "v = sin(x)", "_out1 = v + 1.0", "return (_out0, _out1)"]


def test_only_the_piece_that_holds_is_computed():
    pieces = piecewise(x, x, number(1), call("sqrt", x - 1) + call("log", x - 1))
    one, many = compiled(pieces, pieces * y), compiled(pieces, arrays=True)
    assert one(0.25, 2.0) == (0.25, 0.5)
    assert one(2.0, 1.0)[0] == 1.0
    with np.errstate(invalid="ignore"):
        assert many(np.array([0.25, 2.0]), np.zeros(2))[0].tolist() == [0.25, 1.0]


def test_the_slope_of_a_jump_is_nothing():
    second = derivative(derivative(absolute(sine(x)), x), x)
    assert compiled(second)(2.0, 0.0)[0] == pytest.approx(-math.sin(2.0), rel=1e-15)


@pytest.mark.parametrize("value", [1.0, -0.8])
def test_functions_that_are_written_otherwise(value):
    for expr, meant in (
        (call("tan", PI / 2 - x), 1 / math.tan(value)),
        (1 / cosine(x) ** 2, 1 / math.cos(value) ** 2),
        (call("exp", x) ** 2, math.exp(2 * value)),
        (call("sqrt", number(2)) * x, math.sqrt(2) * value),
        (call("sign", x), math.copysign(1, value)),
    ):
        found = compiled(expr)(value, 0.0)[0]
        assert found == pytest.approx(meant, rel=1e-15) and type(found) is float  # NumPy's would divide by zero in silence


@pytest.mark.parametrize(
    ("name", "slope"),
    [
        ("sin", math.cos), ("cos", lambda v: -math.sin(v)), ("tan", lambda v: 1 / math.cos(v) ** 2),
        ("asin", lambda v: 1 / math.sqrt(1 - v * v)), ("acos", lambda v: -1 / math.sqrt(1 - v * v)),
        ("atan", lambda v: 1 / (1 + v * v)), ("exp", math.exp), ("log", lambda v: 1 / v), ("sqrt", lambda v: 0.5 / math.sqrt(v)),
        ("abs", lambda v: 1.0), ("sign", lambda v: 0.0),
    ],
)  # fmt: skip
def test_every_function_has_its_slope(name, slope):
    assert compiled(derivative(call(name, 2 * x), x))(0.18, 0.0)[0] == pytest.approx(2 * slope(0.36), rel=1e-14)


def test_the_angle_of_two_lengths_turns_as_each_of_them_asks():
    angle = call("atan2", x, y)
    assert compiled(derivative(angle, x), derivative(angle, y))(3.0, 4.0) == pytest.approx((4 / 25, -3 / 25))


@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
def test_a_function_of_an_inverse_one_is_made_of_the_sides_of_a_triangle(name):
    of = getattr(math, name)
    angles = (math.asin(0.3), math.acos(0.3), math.atan(0.3), math.atan2(0.3, -0.7))
    wanted = [call(name, call(inverse, x)) for inverse in ("asin", "acos", "atan")] + [call(name, call("atan2", x, y))]
    assert compiled(*wanted)(0.3, -0.7) == pytest.approx([of(angle) for angle in angles], rel=1e-14)
    assert not any(part.op in {"sin", "cos", "tan", "atan2"} for expr in wanted for part in expr.walk())


def test_what_is_known_of_a_function_without_its_argument_is_worked_out():
    assert (call("exp", number(0)), call("log", number(1)), call("log", call("exp", x))) == (number(1), number(0), x)
    assert [call("sign", number(by)) for by in (-2, 0, 3)] == [number(-1), number(0), number(1)]
    assert (call("sign", 3 * x), call("sign", -3 * x)) == (call("sign", x), -call("sign", x))
    assert math.isnan(value_of(call("abs", call("log", number(-1)))))


def test_pieces_are_the_same_for_sympy():
    pieces = symbolic(piecewise(x, y, number(1), 2 * y, number(3), 3 * y))
    places = dict(zip(("y", "x"), (symbolic(y), symbolic(x)), strict=True))
    assert [float(pieces.subs({places["y"]: 5, places["x"]: at})) for at in (0.5, 1, 2.5, 3)] == [5, 10, 10, 15]


def test_a_root_without_a_real_value_raises_and_is_no_number_in_arrays():
    root = x ** Fraction(1, 3)
    with pytest.raises(ValueError, match="math domain error"):
        compiled(root)(-1.0, 0.0)
    with np.errstate(invalid="ignore"):
        assert np.isnan(compiled(root, arrays=True)(np.array([-1.0]), np.zeros(1))[0][0])


@pytest.mark.parametrize("expr", [POLE, POLE + x, x / (x - x), call("gamma", x)])
def test_what_has_no_real_value_is_refused(expr):
    with pytest.raises(InputError, match="a formula of the variant leads to"):
        compiled(expr)


def test_large_blocks_are_solved_by_their_entries():
    names = list(map(local, ("u", "v", "w", "det")))
    entries = (x, *map(number, (1, 0, 0)), y, *map(number, (1, 1, 0, 2, 1, 2, 3)))
    body = program([Solve(tuple(names[:3]), names[3], entries)], {}, (), {}).free()
    one = compile_function("values", ["x", "y"], body, ["u", "v", "w", "det"])
    many = compile_function("values", ["x", "y"], body, ["u", "v", "w", "det"], numpy=True)
    matrix = np.array([[3.0, 1, 0], [0, 4.0, 1], [1, 0, 2]])
    meant = [*np.linalg.solve(matrix, [1, 2, 3]), np.linalg.det(matrix)]
    assert one(3.0, 4.0) == pytest.approx(meant, rel=1e-13)
    assert [column[0] for column in many(np.array([3.0]), np.array([4.0]))] == pytest.approx(meant, rel=1e-13)


@pytest.mark.parametrize("power", [Fraction(16), Fraction(31, 2), Fraction(17), Fraction(33, 2), Fraction(-16), Fraction(-17)])
def test_powers_up_to_sixteen_are_products_and_roots(power):
    made = compiled((x + y) ** power)
    assert ("pow(" in made.__doc__) == (abs(power) > 16)
    assert made(0.7, 0.4)[0] == pytest.approx(1.1 ** float(power), rel=1e-14)


def test_what_has_more_than_a_hundred_terms_is_not_multiplied_out():
    """(a1 + … + a10)(b1 + … + b10) has them; a power of a sum has as many as ways to share it out."""
    sums = [add(*[local(f"{letter}{k}") for k in range(10)]) for letter in "ab"]
    eleven = sums[1] + local("b10")
    assert len(expanded(sums[0] * sums[1]).terms) == 100
    assert expanded(sums[0] * eleven) == sums[0] * eleven
    assert len(expanded((x + y + c) ** 12).terms) == 14 * 13 // 2  # 91
    assert expanded((x + y + c) ** 13) == (x + y + c) ** 13  # 105
    assert len(expanded(sums[0] + 2 * eleven).terms) == 21
