"""The study of variant 31 against independently computed errors and counts."""

import itertools
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.motion.integration.following import follow_closure
from coursework.motion.schemes import SCHEMES
from coursework.results.accuracy.methods import title_of_corrected, trials
from coursework.results.accuracy.problem import TIMED, Problem
from coursework.results.accuracy.study import make_study
from coursework.results.accuracy.trace import trace
from tests.solved import solved

REFERENCE = json.loads((Path(__file__).parents[2] / "reference" / "work_precision_v31.json").read_text(encoding="utf-8"))
TITLES = {"Euler": "explicit Euler", "Heun": "Heun", "RK4": "Runge-Kutta 4"}


@pytest.fixture(scope="module")
def run():
    return coursework.solve("31", quantities=["table", "checks", "accuracy"])


@pytest.fixture(scope="module")
def scene(run):
    return Problem(run.scene.rates, run.scene.start, 0.02, 24, run.scene.closure, ("rad",) * 3)


@pytest.fixture(scope="module")
def found(scene, run):
    """Every trial of the full study: {(method, setting): (evaluations, errors)}."""
    closure = run.scene.closure
    results = {}
    for trial in trials(scene, TIMED):
        rows, evaluations = trial.run()
        fine = trial.fine or 1
        times = np.arange(24 * fine + 1) * (0.02 / fine)
        results[trial.method, trial.setting] = evaluations, np.abs(rows - follow_closure(closure, scene.rates, times))
    return results


def by_scheme(method, steps, scene, run):
    """One row of the reference that the study does not show."""
    scheme = next(scheme for scheme in SCHEMES.values() if scheme.title == method)
    rows = trace(scheme, scene.rates, scene.start, 0.02, range(25), steps // 24)
    return steps * scheme.slopes, np.abs(rows - run.exact.coordinates)


@pytest.mark.parametrize("row", [row for row in REFERENCE["rows"] if row[0] in TITLES], ids=lambda row: f"{row[0]}-{row[1]}")
def test_errors_and_counts(row, found, scene, run):
    method, steps, evaluations, largest, end = row[:5]
    title = TITLES[method]
    counted, error = found.get((title, str(steps))) or by_scheme(title, steps, scene, run)
    assert counted == evaluations
    tolerance = 1e-3 if largest > 1e-9 else 0.02  # below 1e-9 round-off shares the last digits
    assert np.max(error) == pytest.approx(largest, rel=tolerance)
    assert np.max(error[-1]) == pytest.approx(end, rel=max(tolerance, 1e-13 / end))


@pytest.mark.parametrize("substeps", [24, 48, 96, 192])
def test_projected_euler(substeps, found):
    one, two = REFERENCE["euler_predictor_plus_k_newton_max_err"][f"predictor_newton_n{substeps}"]
    assert found["Euler + 1 Newton projection", str(substeps)][1].max() == pytest.approx(one, rel=1e-3)
    assert found["Euler + 2 Newton projections", str(substeps)][1].max() == pytest.approx(two, rel=1e-3, abs=1e-14)
    assert found["Euler + 1 Newton projection", str(substeps)][0] == 2 * substeps


def test_the_table_of_the_readme_is_what_is_measured(found):
    text = (Path(__file__).parents[3] / "README.md").read_text(encoding="utf-8")
    section = text.partition("## What accuracy costs")[2].partition("\n## ")[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("| ")][1:]
    assert {scheme.title for scheme in SCHEMES.values()} <= {row[0] for row in rows}
    for method, steps, evaluations, _, error in rows:
        counted, measured = found[method, steps]
        assert (str(counted), f"{np.max(measured):.2e}".replace("e-0", "e-")) == (evaluations, error.split()[0])


def test_ratios_over_the_grid_and_at_the_end(found):
    expected = REFERENCE["assertable"]

    def ratios(method, end):
        steps = [24, 48, 96, 192, 384]
        errors = [found[method, str(n)][1] for n in steps]
        values = [np.max(error[-1] if end else error) for error in errors]
        return [a / b for a, b in itertools.pairwise(values)]

    assert ratios("explicit Euler", False) == pytest.approx(expected["euler_ratios_max_err (24->48->96->192->384)"], abs=0.006)
    assert ratios("Heun", False) == pytest.approx(expected["heun_ratios_max_err"], abs=0.01)
    assert ratios("Runge-Kutta 4", False) == pytest.approx(expected["rk4_ratios_max_err"], abs=0.02)
    assert ratios("Heun", True) == pytest.approx(expected["heun_end_ratios"], abs=0.01)
    assert ratios("Runge-Kutta 4", True) == pytest.approx(expected["rk4_end_ratios"], abs=0.05)


def test_measured_orders_and_words(scene, run):
    study = make_study(scene, run.exact, "euler")
    for method, order in {"explicit Euler": 1, "midpoint": 2, "Heun": 2, "Runge-Kutta 4": 4}.items():
        assert study.orders[method] == pytest.approx(order, abs=0.1)
    text = " ".join(study.sentences)
    assert text.count("evaluations, a Newton correction counted as one: ") == 1
    assert "24 steps of explicit Euler: 0.152 rad (8.7°) off at worst" in text
    assert "14\u202f000 times less error than Euler for 4 times the evaluations" in text
    assert "Euler needs about 410\u202f000 steps" in text
    closed = next(row for row in study.rows if row.method.startswith("position closure"))
    assert 0 < closed.max_error < 1e-13  # against the refined run, not against itself
    assert 24 * 5 < closed.evaluations < 24 * 15  # four slopes guess a row, two or three Newton corrections close it
    assert f"with {closed.evaluations} evaluations" in text
    assert study.own[:2] == ("explicit Euler", 24)
    assert all(row.seconds is None for row in study.rows)


def test_a_method_that_fails_is_listed_not_dropped(run):
    def no_value(t, *q):
        raise ZeroDivisionError

    scene = Problem(run.scene.rates, run.scene.start, 0.02, 24, run.scene.closure, ("rad",) * 3)
    broken = Problem(replace(run.scene.rates, evaluate=no_value), scene.start, scene.step, scene.rows, None, scene.units)
    failed = [row for row in make_study(broken, run.exact, "euler").rows if row.failed]
    assert {row.method for row in failed} == {"Dormand-Prince 5(4)"}
    assert all("did not finish" in row.failed for row in failed)


def test_no_error_is_measured_below_what_two_references_differ_by(scene, run):
    """Of a last run that cannot be told from its reference the order of Runge-Kutta 4 would be 3 (a five-bar)."""
    moved = replace(run.exact, coordinates=run.exact.coordinates + 1e-10)
    assert make_study(scene, moved, "euler").floor == pytest.approx(1e-10, rel=0.01)


def test_a_table_is_measured_against_the_motion_its_schemes_solve():
    """Derivatives of a table belong to no curve through it: schemes and closed form come to rest 1e-7 rad apart."""
    run = coursework.solve("variable-crank-table", quantities=["accuracy"])
    study = run.accuracy
    for method, order in {"explicit Euler": 1, "midpoint": 2, "Heun": 2, "Runge-Kutta 4": 4}.items():
        assert study.orders[method] == pytest.approx(order, abs=0.1)
    closed = next(row for row in study.rows if row.method == "position closure (Newton)")
    assert 1e-8 < closed.max_error < 1e-6
    assert "belong to another motion than the positions" in study.reference_label


def test_the_point_of_the_coursework_is_that_of_its_own_table():
    """A corrected table had the error of the scheme without corrections."""
    study = solved("31", scheme="euler", quantities=["table", "checks", "accuracy"], project=1).accuracy
    assert study.own[0] == "Euler + 1 Newton projection"
    assert study.sentences[0].startswith("24 steps of Euler + 1 Newton projection: ")
    drawn = solved("31", scheme="euler", quantities=["table", "checks", "accuracy"], gain=5.0).accuracy
    assert drawn.own is None and "24 steps of explicit Euler without the correction of the drift: 0.152 rad" in drawn.sentences[0]
    untried = [("rk4", 1, 0.0), ("euler", 0, 5.0), ("rk4", 0, 5.0)]
    assert [title_of_corrected(*way) for way in (("rk4", 0, 0.0), *untried)] == ["Runge-Kutta 4", "", "", ""]
