"""TABLE-DIGITS: what the last printed digit of a tabulated crank does, against weights taken by hand and against true tables."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.equations import five_point
from coursework.results.checks.computed_right import digits
from coursework.variant.reading.reader import read_variant
from tests.results.checks.scenes import evidence_of, finding, found

VARIANTS = Path(__file__).parents[4] / "variants"
TEXT = (VARIANTS / "variable-crank-table.toml").read_text(encoding="utf-8")
ROWS = [line.split(",") for line in (VARIANTS / "variable-crank-table.csv").read_text(encoding="utf-8").splitlines()[1:]]


@pytest.fixture
def crank(tmp_path):
    def made(places: int | None, method: str = "five-point", deviation: float = 0.0):
        random = np.random.default_rng(7)
        lengths = [(phi, repr(float(r) + random.normal(0, deviation)) if deviation else r) for phi, r in ROWS]
        rows = [f"{phi},{r if places is None else format(float(r), f'.{places}f')}" for phi, r in lengths]
        (tmp_path / "variable-crank-table.csv").write_text("\n".join(["phi1,r", *rows]), encoding="utf-8")
        file = tmp_path / "crank.toml"
        file.write_text(TEXT.replace('"five-point"', f'"{method}"'), encoding="utf-8")
        return coursework.solve(read_variant(file), quantities=["table", "checks"])

    return made


def test_the_weights_of_the_five_point_rule():
    """0.75 q/d inside and 5.33 at the end; applied twice 1.125 and 16.4: half the sums of sizes of the coefficients."""
    inside, end = (0.5 * np.sum(np.abs(five_point.COEFFICIENTS[row])) / 12 for row in (2, 0))
    assert (inside, end) == (0.75, pytest.approx(5.3333, abs=1e-4))
    slopes, curvatures = digits.amplification("five-point", 1), digits.amplification("five-point", 2)
    assert (slopes[-1], slopes[0]) == (pytest.approx(inside), pytest.approx(end))
    assert (curvatures[-1], curvatures[0]) == (pytest.approx(1.125), pytest.approx(16.4, abs=0.05))
    assert [round(value, 2) for value in curvatures[1:3]] == [1.98, 1.82]


def test_the_weights_of_a_spline_bound_what_rounding_does():
    from coursework.equations.codegen.tabulated import TableLaw

    random = np.random.default_rng(3)
    nodes = np.linspace(0, 1, 31)
    for method in ("five-point", "spline"):
        for order in (1, 2):
            bound = digits.amplification(method, order)
            for _ in range(50):
                errors = random.choice([-0.5, 0.5], 31)
                law = TableLaw("", tuple(zip(nodes.tolist(), errors.tolist(), strict=True)), method).function(order)
                found = np.abs(law(nodes)) * (1 / 30) ** order
                limits = [bound[min(place, 30 - place, len(bound) - 1)] for place in range(31)]
                assert np.all(found <= np.array(limits) * (1 + 1e-9))


@pytest.mark.parametrize(("texts", "places"), [
    (["0.1", "0.1000", "0.1"], 1), (["0.1", "0.12", "0.3"], 2), (["1", "2", "3"], 0), (["0.10001", "0.1", "0.2"], 5),
    (["0.0001", "1234.5678"], 4), (["0.10000322152634923", "0.1", "0.2"], None),
])  # fmt: skip
def test_the_last_place_that_all_values_share(texts, places):
    law = replace(
        coursework.load("variable-crank-table").functions[0], table=tuple((float(i), float(t)) for i, t in enumerate(texts))
    )
    assert digits.decimals(law) == places


def test_a_table_rounded_to_a_tenth_of_a_millimetre_is_too_coarse(crank):
    judged = found(crank(4), "TABLE-DIGITS")
    assert judged.verdict == "COARSE"
    assert judged.step is None
    assert (
        "r as printed (decimals: 4) allows u to be off by 0.027 m/s inside the table and by 0.19 m/s at its ends"
        in judged.sentence
    )
    assert "Take a table with more decimals" in judged.sentence
    assert found(coursework.solve("variable-crank-table", quantities=["table", "checks"]), "TABLE-DIGITS").verdict == "PASS"
    assert found(coursework.solve("31", quantities=["table", "checks"]), "TABLE-DIGITS").verdict == "SKIP"


@pytest.mark.parametrize("method", ["five-point", "spline"])
def test_what_is_told_bounds_what_the_rounded_table_really_does(crank, method):
    exact, rounded = crank(None, method), crank(4, method)
    error = np.abs(rounded.exact.column("u") - exact.exact.column("u"))
    noise = next(noise for noise in digits._noises(rounded.results.evidence, rounded.variant.functions[0]) if noise.column == "u")
    assert 0.2 * noise.inside < float(np.max(error[6:-6])) <= noise.inside * 1.01
    assert float(np.max(error)) <= noise.end * 1.01


@pytest.mark.parametrize(("factor", "verdict"), [(0.999, "PASS"), (1.001, "COARSE")])
def test_the_limit(crank, factor, verdict):
    evidence = crank(6).results.evidence
    noises = digits._noises(evidence, evidence.variant.functions[0])
    worst = next(noise for noise in noises if noise.column == "u")
    scaled = evidence_of(crank(6))
    scaled.__dict__["scale"] = {**evidence.scale, "u": worst.worst / (0.05 * factor)}
    named = replace(scaled.variant, ask=("table", "checks"))
    judged = replace(scaled, variant=named)
    judged.__dict__["scale"] = scaled.__dict__["scale"]
    assert digits.table_digits(judged).verdict == verdict
    assert finding("TABLE-DIGITS", evidence).value > 0


def table_of(values):
    rows = tuple(zip(np.linspace(0, 1, len(values)).tolist(), np.asarray(values).tolist(), strict=True))
    return replace(coursework.load("variable-crank-table").functions[0], table=rows)


def test_measured_points_scatter_about_a_smooth_law():
    """Twice the deviation that was put in; nothing for a law with six nodes a period, a kink, dwells, or digits of a program."""
    random, nodes = np.random.default_rng(5), np.linspace(0, 6, 61)
    for deviation in (1e-5, 1e-3):
        found = digits.scatter(table_of(np.sin(nodes) + random.normal(0, deviation, 61)))
        assert found == pytest.approx(2 * deviation, rel=0.35)
    smooth = [np.sin(2 * np.pi * np.arange(61) / 6), np.abs(nodes - 3), np.clip(np.sin(nodes), 0, 0.5), np.sin(nodes), 0 * nodes]
    assert [digits.scatter(table_of(values)) for values in smooth] == [0] * len(smooth)
    assert digits.scatter(table_of(np.sin(nodes[:15]) + random.normal(0, 1e-3, 15))) == 0


@pytest.mark.parametrize(("deviation", "verdict"), [(1e-7, "PASS"), (1e-4, "COARSE")])
def test_points_that_scatter_are_told(crank, deviation, verdict):
    judged = found(crank(None, deviation=deviation), "TABLE-DIGITS")
    assert judged.verdict == verdict and "The points of r scatter by about ±" in judged.sentence
    assert ("Smooth the points" in judged.sentence) == (verdict == "COARSE")


DRIVEN = (VARIANTS / "31.toml").read_text(encoding="utf-8").replace('"plots", "checks"', '"accelerations", "checks"')


@pytest.fixture
def driven(tmp_path):
    """Return a function that makes variant 31 with its drive tabulated every 0.01 s with so many decimals."""

    def made(places):
        times = np.arange(49) * 0.01
        rows = [f"{t:.2f},{4.5 * np.sin(13.08 * t + 4.35):.{places}f}" for t in times.tolist()]
        (tmp_path / "law.csv").write_text("\n".join(["t,V", *rows]), encoding="utf-8")
        law = '{ table = "law.csv", of = "t", method = "five-point" }'
        (tmp_path / "31.toml").write_text(DRIVEN.replace('"V1*sin(p*t + alpha)"', law), encoding="utf-8")
        return coursework.solve(tmp_path / "31.toml", "exact")

    return made


@pytest.mark.parametrize("places", [1, 2])
def test_a_drive_is_one_derivative_further_than_a_length(driven, places):
    """What is told bounds what the rounding really does to velocities and accelerations, and is not far beyond it."""
    rounded, full = driven(places), driven(15)
    noises = digits._noises(rounded.results.evidence, rounded.variant.drive[1])
    assert len(noises) == 2
    (names, rows), (_, wanted) = rounded.columns(), full.columns()
    for noise in noises:
        error = np.abs(rows - wanted)[:, names.index(noise.column)]
        assert 0.2 * noise.inside < float(np.max(error[3:-3])) <= 1.1 * noise.inside
        assert float(np.max(error)) <= 1.1 * noise.end


def test_few_decimals_of_a_tabulated_drive_are_too_coarse_for_accelerations(driven):
    judged = found(driven(1), "TABLE-DIGITS")
    assert (judged.verdict, judged.column, judged.step) == ("COARSE", "dw3", None)
    assert "allows d w3/d t to be off" in judged.sentence
    assert found(driven(5), "TABLE-DIGITS").verdict == "PASS"


@pytest.mark.parametrize(("exact", "restricted"), [
    (SimpleNamespace(t=[]), False), (SimpleNamespace(t=[0.0, 0.1]), True),
])  # fmt: skip
def test_what_digits_do_is_not_known_without_the_motion_or_without_all_its_columns(exact, restricted):
    law = SimpleNamespace(name="r", table=((0.0, 1.0),))
    variant = SimpleNamespace(laws=(law,))
    judged = digits.table_digits(SimpleNamespace(variant=variant, exact=exact, restricted=restricted))
    assert judged.verdict == "SKIP"
