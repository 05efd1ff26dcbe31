"""Tabulated laws: the spline is the not-a-knot one, five points reproduce quartics, and work grows as the table does."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import coursework
from coursework.equations.codegen import tabulated
from coursework.equations.codegen.tabulated import OutsideTable, TableLaw, spline_slopes
from coursework.equations.reduction.structure import structures
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from tests.benchmarks.timer import ratio

METHODS = ("five-point", "spline")


def law_of(function, count, method):
    nodes = np.linspace(0.4, 2.4, count)
    return nodes, TableLaw("r", tuple(zip(nodes.tolist(), function(nodes).tolist(), strict=True)), method)


@pytest.mark.parametrize("count", [5, 6, 7, 20, 400])
def test_the_spline_is_that_of_others(count):
    values = np.random.default_rng(count).normal(size=count)
    other = CubicSpline(np.arange(count), values, bc_type="not-a-knot")
    assert np.max(np.abs(other(np.arange(count), 1) - spline_slopes(values.tolist()))) < 1e-13
    law = TableLaw("r", tuple(enumerate(values.tolist())), "spline")
    places = np.linspace(0, count - 1, 997)
    for order in range(3):
        assert np.max(np.abs(law.function(order)(places) - other(places, order))) < 1e-12


@pytest.mark.parametrize(("method", "degree"), [("five-point", 4), ("spline", 3)])
@pytest.mark.parametrize("count", [5, 6, 9, 50])
def test_a_polynomial_of_its_degree_is_met(method, degree, count):
    polynomial = np.polynomial.Polynomial([0.3, -0.2, 0.7, 0.1, -0.05][: degree + 1])
    _, law = law_of(polynomial, count, method)
    places = np.linspace(0.4, 2.4, 301)
    for order, allowed in ((0, 1e-14), (1, 1e-11), (2, 1e-8)):
        wanted = polynomial.deriv(order)(places) if order else polynomial(places)
        assert np.max(np.abs(law.function(order)(places) - wanted)) < allowed * count


@pytest.mark.parametrize("method", METHODS)
def test_a_number_and_an_array_are_the_same(method):
    nodes, law = law_of(np.sin, 30, method)
    places = np.concatenate([nodes, np.linspace(0.4, 2.4, 211)])
    for order in range(3):
        one = [law.function(order)(place) for place in places.tolist()]
        assert law.function(order)(places) == pytest.approx(np.array(one), rel=1e-14, abs=1e-14)


@pytest.mark.parametrize("place", [0.4 - 1e-4, 2.4 + 1e-4, np.array([1.0, 2.5])])
def test_beyond_the_table_there_is_nothing(place):
    _, law = law_of(np.sin, 30, "spline")
    with pytest.raises(OutsideTable, match=r"the table of r covers 0\.4 to 2\.4, but"):
        law.function(0)(place)


@pytest.mark.parametrize("method", METHODS)
def test_work_grows_as_the_table_does(method):
    """Twice the nodes cost about twice the time: solved as a full system they would cost eight times."""
    assert ratio(lambda: law_of(np.sin, 8000, method)[1].pieces, lambda: law_of(np.sin, 4000, method)[1].pieces, most=3.0) <= 3.0


@pytest.mark.parametrize("method", METHODS)
def test_a_law_is_worked_out_once_a_scene(method, tmp_path, monkeypatch):
    made = []
    for name in ("_quartics", "_cubics"):
        whole = getattr(tabulated, name)
        monkeypatch.setattr(tabulated, name, lambda *given, whole=whole: made.append(np.shape(given[0])[-1]) or whole(*given))
    structures.cache_clear()  # another test may have worked out the same law
    variant = coursework.load("variable-crank-table")
    law = variant.functions[0]
    chosen = replace(variant, functions=(replace(law, method=method),))
    run = coursework.solve(chosen)
    assert run.checks and run.columns() and run.extra_tables and len(run.exact.t)
    coursework.write_report(run, tmp_path / "report.html")
    assert made == [51]


def test_a_law_asked_beyond_its_table_names_the_line_of_its_own_file(tmp_path):
    """Variants that differ in their data share one law; each is told by its own file."""
    place = folder("variants")
    text = (place / "variable-crank-table.toml").read_text(encoding="utf-8").replace("76.72 deg", "70.72 deg")
    (tmp_path / "variable-crank-table.csv").write_bytes((place / "variable-crank-table.csv").read_bytes())
    for name in ("first.toml", "second.toml"):
        (tmp_path / name).write_text(text, encoding="utf-8")
        with pytest.raises(InputError) as told:
            _ = coursework.solve(tmp_path / name, quantities=["table"]).motion
        (fault,) = told.value.faults
        assert (fault.code, Path(fault.file).name, text.splitlines()[fault.line - 1].split()[0]) == ("V522", name, "r")


@pytest.mark.parametrize("end", [0.4, 2.4])
def test_a_table_reaches_a_millionth_of_a_step_beyond_its_ends(end):
    _, law = law_of(np.sin, 21, "spline")
    outward = 0.1 if end > 1 else -0.1
    for beyond, is_inside in ((0.9e-6, True), (1.1e-6, False)):
        place = end + beyond * outward
        assert bool(law.covers(place)) == is_inside
        for argument in (place, np.array([1.0, place])):
            if is_inside:
                assert np.max(np.abs(law.function(0)(argument) - np.sin(argument))) < 1e-5
            else:
                with pytest.raises(OutsideTable):
                    law.function(0)(argument)


SWING = """
[functions]
law = { table = "law.csv", of = "phi", method = "spline" }
[drive]
w = "6*cos(6*t)"
[coordinates]
phi = { start = "0 rad", rate = "w" }
x = { start = "1 m", rate = "u" }
[time]
step = "pi/150"
end = "pi/3"
[[constraint]]
closure = "x = law"
"""


def test_a_motion_may_fill_its_table_and_a_scheme_that_leaves_it_ends_there(tmp_path):
    """The motion turns back at both ends, or begins and ends there, where deviations are asked for as well."""
    nodes = np.linspace(-1, 1, 41)
    lines = [f"{one!r},{value!r}\n" for one, value in zip(nodes.tolist(), np.cos(nodes).tolist(), strict=True)]
    (tmp_path / "law.csv").write_text("".join(lines))
    through = SWING.replace("6*cos(6*t)", "2").replace("0 rad", "-1 rad").replace("1 m", "0.54030230586814 m")
    through = through.replace("pi/150", "0.02 s").replace("pi/3", "1 s")
    for name, text in (("swing", SWING), ("through", through)):
        (tmp_path / f"{name}.toml").write_text(text)
    exact, euler, crossing = (
        coursework.solve(tmp_path / f"{name}.toml", scheme=scheme, quantities=["table", "checks"])
        for name, scheme in (("swing", "exact"), ("swing", "euler"), ("through", "euler"))
    )
    assert exact.checks
    assert exact.exact.column("x") == pytest.approx(np.cos(np.sin(6 * exact.exact.t)), abs=1e-6)
    assert (len(euler.motion.t), euler.stop.kind) == (11, "step too large")
    assert "leads beyond the table of law. Add nodes to it" in f"{euler.stop.cause} {euler.stop.meaning}"
    assert crossing.checks
    assert crossing.stop is None
