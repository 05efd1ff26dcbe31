"""Variant 31 against numbers computed independently: closed form in 50-digit arithmetic and an own Euler march.

Provenance: `tests/reference/variant31.json` is a copy of the reference handed out with the task (its `description` says how it
was made); its exact table was checked there against a 30-digit Taylor integration of the velocity equations.
"""

import json
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.motion.schemes import SCHEMES
from coursework.variant.reading.reader import parse_variant

REFERENCE = json.loads((Path(__file__).parent / "reference" / "variant31.json").read_text(encoding="utf-8"))
READING = REFERENCE["readings"]["4.35"]
PAGE = (Path(__file__).parent / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
WRITTEN = PAGE[: PAGE.index("# --- geometry")]
DEAD = REFERENCE["readings"]["0.02"]["events"]
ANGLES, RATES = ["phi1", "phi2", "phi3"], ["w1", "w2", "w3", "w4"]


def column(table, key, place):
    return np.array([float(row[key][place]) for row in table])


def furthest(found, wanted):
    """Return the largest difference, as a part of the largest value of the column."""
    return np.max(np.abs(np.asarray(found) - wanted)) / np.max(np.abs(wanted))


@pytest.fixture(scope="module")
def run():
    return coursework.solve("31", quantities=["table", "accelerations"])


@pytest.fixture(scope="module")
def exact():
    return coursework.exact("31", quantities=["table", "accelerations"])


def test_the_reference_has_the_data_of_the_variant(run):
    data = {
        name: float(REFERENCE["data"][key]) for name, key in (("r1", "r1"), ("r2", "r2"), ("r3", "r3"), ("V1", "V"), ("p", "p"))
    }
    assert run.variant.values == data | {"alpha": 4.35}


def test_euler_table(run):
    reference = READING["euler_dt_0.02"]
    table = run.table
    assert table.index.name == "t"
    assert table.index.tolist() == [i * 0.02 for i in range(25)]
    assert list(table.columns[:7]) == [*ANGLES, *RATES]
    for place, name in enumerate(ANGLES):
        assert furthest(table[name], column(reference, "phi", place)) < 1e-12
    for place, name in enumerate(RATES):
        assert furthest(table[name], column(reference, "omega", place)) < 1e-12


def test_first_row_is_the_start_and_row_four_is_that_of_the_guide(run):
    assert run.table.iloc[0][ANGLES].tolist() == [1.63, 3.37, 2.87]
    row = run.table.iloc[3]
    assert row[ANGLES].tolist() == pytest.approx([1.57468436617, 3.34386868789, 3.18898820072], abs=1e-11)
    assert row[RATES].tolist() == pytest.approx([0.219835996, 0.113615129728, 4.39156138925, -7.94100954258], abs=1e-9)


def test_exact_table(exact):
    reference = READING["exact_table"]
    for place, name in enumerate(ANGLES):
        assert furthest(exact[name], column(reference, "phi", place)) < 1e-12
    for place, name in enumerate(RATES):
        assert furthest(exact[name], column(reference, "omega", place)) < 1e-12


def test_accelerations_of_the_exact_motion(exact):
    reference = READING["exact_table"]
    for place, name in enumerate(RATES):
        assert furthest(exact[f"d{name}"], column(reference, "epsilon", place)) < 1e-12


def test_the_exact_motion_says_how_it_was_found(run):
    assert run.exact.label == "Newton on the position equations, drive integrated to round-off"
    assert run.exact.evaluations == 0


def test_mismatch_of_first_and_last_row(run):
    split = READING["mismatch_row24_minus_row0"]
    found = run.motion.coordinates[-1] - run.motion.coordinates[0]
    assert found == pytest.approx([float(x) for x in split["phi_total"]], abs=1e-10)
    scheme = run.motion.coordinates[-1] - run.exact.coordinates[-1]
    assert scheme == pytest.approx(
        [float(split[key][i]) for key in split if "phi_from_trunc" in key for i in range(3)], abs=1e-10
    )


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("step", [0.02, 0.01, 0.04, 0.007])
@pytest.mark.parametrize("text", [PAGE, WRITTEN], ids=["geometry", "written"])
def test_the_other_phase_stops_at_the_dead_point(scheme, step, text):
    """Whatever the scheme and the step, also where the file has no geometry; a naive loop prints 25 plausible rows."""
    variant = parse_variant(text.replace('"4.35 rad"', '"0.02 rad"'))
    run = coursework.solve(variant, scheme, step=step, quantities=["table"])
    stop = run.stop
    assert stop.kind == "dead point"
    assert stop.time == pytest.approx(float(DEAD["singularity_enter"]), abs=1e-8)
    assert stop.block == ("w3",)
    places = [stop.coordinates[name] for name in ANGLES]
    assert places == pytest.approx([float(x) for x in DEAD["phi_at_singularity"][:3]], abs=1e-6)
    assert len(run.motion.t) == int(stop.time / step) + 1
    assert step != 0.02 or len(run.motion.t) == 6
    assert np.all(np.isfinite(run.columns()[1]))
    assert len(run.exact.t) <= len(run.motion.t)
    assert not run.passed


def test_the_dead_point_is_explained():
    variant = parse_variant(PAGE.replace('"4.35 rad"', '"0.02 rad"'))
    sentence = coursework.solve(variant, quantities=["table"]).stop.sentence
    assert "t = 0.116889 s" in sentence
    assert "2*cos(phi3) + sin(phi3) = 0" in sentence
    assert "phi3 = 2.03444 rad" in sentence
    assert "This is a dead point" in sentence


@pytest.mark.parametrize("alpha", ["alpha_min", "alpha_max"])
def test_the_feasible_phases_end_where_the_reference_says(alpha):
    bound = float(REFERENCE["alpha_feasible"][alpha])
    inwards = 1 if alpha == "alpha_min" else -1
    for distance, possible in ((1e-6, True), (-1e-6, False)):
        variant = parse_variant(PAGE.replace('"4.35 rad"', f'"{bound + inwards * distance!r} rad"'))
        run = coursework.solve(variant, "rk4", step=0.001, quantities=["table"])
        assert (run.scene.search.event is None) == possible


def test_without_geometry_the_motion_is_refined_and_labelled():
    run = coursework.solve(parse_variant(WRITTEN), quantities=["table"])
    reference = READING["exact_table"]
    for place, name in enumerate(ANGLES):
        assert np.max(np.abs(run.exact.column(name) - column(reference, "phi", place))) < 1e-10
    assert run.exact.label.startswith("Runge-Kutta 4")
    assert "agree" in run.exact.label
    assert float(run.exact.label.split()[-1]) < 1e-10


def test_velocities_vanish_when_the_reference_says():
    """w3 = 0 at the two times at which M stands still."""
    times = [float(t) for t in READING["events"]["omega3_zero_times"]]
    for t in times:
        run = coursework.solve("31", step=t, end=t, quantities=["table"])
        assert abs(run.exact.column("w3")[-1]) < 1e-12
