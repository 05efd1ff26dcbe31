"""Enclosures of laws: no value on a stretch, and none on its disc beyond the real axis, lies outside; they close in with it."""

import itertools
import math

import mpmath as mp
import numpy as np
import pytest

from coursework.equations.codegen.tabulated import TableLaw
from coursework.motion.geometry.drives.drive import _is_of_time
from coursework.motion.geometry.drives.enclosures import REACH, Enclosure, Laws, _exponential
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import FUNCTIONS
from coursework.variant.record.variant import Law
from tests.sample import first

# Where each function of the language is looked at: arguments that stay in its domain, or leave it, or pass through a pole.
FORMULAS = {
    "sin": "sin(k*t + c)", "cos": "cos(k*t - c)", "tan": "tan(k*t)", "asin": "asin(sin(k*t)*c/4)", "acos": "acos(t/9)",
    "atan": "atan(k*(t - c))", "sqrt": "sqrt(t + c)", "exp": "exp(-k*t)", "log": "log(t + 0.1)", "abs": "abs(k*t - c)",
    "atan2": "atan2(sin(k*t), c + cos(k*t))",
}  # fmt: skip
OPERATORS = {
    "+": "t + c", "-": "t - c*t", "neg": "-t", "*": "(t - c)*(t + k)", "square": "(t - c)*(t - c)",
    "/": "c/(t + 1)",
    "pole": "1/(t - c)",
    "^2": "(t - c)^2", "^3": "(t - c)^3", "^-2": "(t + c)^-2", "^0.5": "t^0.5",
    "^1.5": "(t + 0.2)^1.5", "^-0.5": "(t + 0.1)^-0.5",
}  # fmt: skip
COMPOSED = {
    "pulse": "c + 1e4*exp(-((t - 0.5)/1e-2)^2)", "lorentz": "k/(1 + ((t - c)/0.01)^2)", "switch": "k/(1 + exp(-(t - c)/1e-3))",
    "sign": "k*(t - c)/abs(t - c)", "chirp": "sin(k*t^2)", "decay": "k*exp(-t/1e-3)",
    "root": "sqrt(abs(t - c))", "fold": "abs(sin(k*t))",
    "over pi": "sin(pi*t)/pi", "nested": "exp(sin(k*t)^3)*cos(t)^2/(2 + sin(t))", "atan2 aside": "atan2(1 + t, t - c)",
    "square of a sum": "sqrt((t - c)^2 + 1e-8)",
}  # fmt: skip
EVERY = FORMULAS | OPERATORS | COMPOSED
VALUES = {"k": 3.7, "c": 0.83}


def laws(text, values=VALUES):
    return Laws(values, {"w": Law("w", formula=parse(text))}, {})


def value(text, at, values=VALUES):
    """Return the value of a formula at a complex time in thirty digits, by mpmath and by Python's own reading of the text."""
    names = {name: getattr(mp, name) for name in FUNCTIONS if name != "abs"} | {"abs": lambda x: mp.sqrt(x * x), "pi": mp.pi}
    numbers = {name: mp.mpf(size) for name, size in values.items()}
    return eval(text.replace("^", "**"), {}, names | numbers | {"t": at})


def stretches(seed, count=60, longest=2.0):
    random = np.random.default_rng(seed)
    begin = random.uniform(0, 2, count)
    return begin, begin + longest * 10 ** -random.uniform(0, 7, count)


@pytest.mark.long
@pytest.mark.parametrize("name", EVERY)
def test_no_value_on_a_stretch_lies_outside(name):
    text = EVERY[name]
    begin, end = stretches(1)
    found = laws(text).over("w", begin, end)
    random = np.random.default_rng(2)
    for place, (a, b) in enumerate(zip(begin, end, strict=True)):
        slack = 1e-12 * (1 + abs(found.low[place]) + abs(found.high[place])) if np.isfinite(found.size[place]) else 0.0
        for part in (0.0, 1.0, *random.random(8)):
            seen = value(text, mp.mpf(a + part * (b - a)))
            if mp.im(seen) == 0:
                assert found.low[place] - slack <= seen <= found.high[place] + slack, (a, b)


@pytest.mark.parametrize("name", EVERY)
@pytest.mark.parametrize("count", first(1, (20, 60)))
def test_no_value_on_the_disc_lies_outside(name, count):
    """Also beside the real axis; abs(x) is x or -x there, which is why a disc that x leaves its side in has no bound.

    Where a part of the law is bounded by its values alone, the whole is near the disc on the stretch itself.
    """
    text = EVERY[name]
    begin, end = stretches(3, count)
    found = laws(text).over("w", begin, end)
    random = np.random.default_rng(4)
    assert np.isfinite(found.disc).any()
    for place, (a, b) in enumerate(zip(begin, end, strict=True)):
        within = float((found.radius + found.rest)[place])
        if not np.isfinite(within):
            continue
        about, reach = (a + b) / 2, REACH * (b - a) / 2
        slack = 1e-11 * (1 + abs(found.middle[place]) + within)
        for _ in range(8):
            aside = mp.mpf(reach * math.sqrt(random.random())) * mp.expjpi(2 * random.random())
            if "atan2" in text:
                continue  # of two complex numbers it is what atan of their quotient is: tested by the operators
            seen = value(text, mp.mpc(about) + (aside if np.isfinite(found.disc[place]) else mp.re(aside) / REACH))
            assert mp.im(seen) == 0 or np.isfinite(found.disc[place]) or abs(mp.im(seen)) < slack
            assert abs(seen - found.middle[place]) <= within + slack, (a, b)


@pytest.mark.parametrize("name", [name for name in EVERY if name != "sign"])
def test_enclosures_close_in_with_the_stretch(name):
    """At an ordinary moment: a kink has a bound of its values there, though none beside the real axis."""
    widths = []
    for half in (1e-3, 1e-5, 1e-7):
        found = laws(EVERY[name]).over("w", np.array([1.234 - half]), np.array([1.234 + half]))
        assert np.isfinite(found.radius[0])
        widths.append((float(found.high[0] - found.low[0]), float(found.radius[0])))
    for wide, narrow in itertools.pairwise(widths):
        assert narrow[0] <= wide[0] / 30 + 1e-13
        assert narrow[1] <= wide[1] / 30 + 1e-13


def test_what_no_bound_holds_is_infinite_and_never_no_number():
    begin, end = np.array([0.0, 0.5, 0.82]), np.array([2.0, 1.0, 0.84])
    for text in (
        "1/(t - c)",
        "log(abs(t - c))",
        "tan(t*2)",
        "(t - c)^-0.5",
        "exp(exp(1e3*t))",
        "0*exp(1e4*t)",
        "1/(1 + exp(1e5*(c - t)))",
    ):
        found = laws(text).over("w", begin, end)
        for part in (found.low, found.high, found.middle, found.radius):
            assert not np.any(np.isnan(part)), text
        assert np.all(found.low <= found.high)
    assert laws("1/(t - c)").over("w", begin, end).size.tolist() == [np.inf] * 3


def test_a_sign_stays_between_its_values_also_where_it_changes():
    found = laws("k*(t - c)/abs(t - c)").over("w", np.array([0.8, 0.84]), np.array([0.84, 0.9]))
    assert (found.low[0], found.high[0]) == (-3.7, 3.7)
    assert (found.low[1], found.high[1]) == (3.7, 3.7)


def test_pieces_tables_and_laws_within_laws():
    table = TableLaw("q", tuple((x / 10, math.sin(x / 3)) for x in range(21)), "spline")
    inner = {"q": Law("q", of="t", table=table.rows, method="spline"), "f": Law("f", formula=parse("k*t"))}
    pieces = Law("w", pieces=((0.0, parse("2*f + q")), (1.0, parse("q^2"))))
    several = Laws(VALUES, inner | {"w": pieces}, {"q": table})
    begin, end = np.array([0.31, 0.93, 1.02, 1.71]), np.array([0.34, 0.97, 1.06, 1.79])
    found = several.over("w", begin, end)
    for place, (a, b) in enumerate(zip(begin, end, strict=True)):
        for t in np.linspace(a, b, 21):
            q = table.function(0)(float(t))
            seen = 2 * 3.7 * t + q if t < 1 else q * q
            assert found.low[place] - 1e-12 <= seen <= found.high[place] + 1e-12
        assert found.high[place] - found.low[place] < 1.0
    assert np.all(np.isfinite(found.radius))


@pytest.mark.parametrize("radius", [0.5, 0.999, 1.0, 2.0])
def test_a_power_is_bound_as_closely_as_it_can_be(radius):
    """On a disc the real point furthest to the right is where e^z is furthest from its middle: e^(m + r) - e^m."""
    ends = np.array([0.3 - radius]), np.array([0.3 + radius])
    found = _exponential(Enclosure(*ends, np.array([0.3]), np.array([radius])))
    assert found.radius == pytest.approx([math.exp(0.3 + radius) - math.exp(0.3)])


@pytest.mark.parametrize(("law", "is_of_time"), [
    (Law("f", parse("a*t")), True), (Law("f", parse("a*pi")), False), (Law("f", parse("phi*t")), False),
    (Law("f", parse("phi")), False),
    (Law("f", parse("sin(g) + a")), True), (Law("f", parse("h - a")), False), (Law("f", parse("g*phi")), False),
    (Law("f", pieces=((0.0, parse("1")), (1.0, parse("2")))), True), (Law("f", pieces=((0.0, parse("1")),)), False),
    (Law("f", pieces=((0.0, parse("1")), (1.0, parse("phi")))), False), (Law("f", table=((0.0, 1.0), (1.0, 2.0)), of="t"), True),
    (Law("f", table=((0.0, 1.0), (1.0, 2.0)), of="phi"), False),
])  # fmt: skip
def test_what_changes_with_time_and_with_nothing_else(law, is_of_time):
    """g = t^2, h = 3 and the datum a are known; phi is a coordinate."""
    others = {"g": Law("g", parse("t^2")), "h": Law("h", parse("3"))}
    assert _is_of_time(law, Laws({"a": 2.0}, {law.name: law, **others}, {})) is is_of_time
