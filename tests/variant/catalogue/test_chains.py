"""The chains of the slides against 60-digit closed forms: every coordinate and point, with rates and second rates."""

import json
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism

REFERENCE = Path(__file__).parents[2] / "reference"
CHAINS = {
    "example-1": "example1_fourbar", "example-2": "example2_slidercrank", "example-3": "example3_rrr_rrr",
    "example-4": "example4_rpr", "example-5": "example5_rpp", "example-6": "example6_rpr_rpp",
    "homework": "homework_rrr_rrp", "prp": "example_prp",
}  # fmt: skip
LIMIT = 1e-12


def rows_of(name: str) -> list[dict]:
    return json.loads((REFERENCE / f"{CHAINS[name]}.json").read_text(encoding="utf-8"))["rows"]


@pytest.mark.parametrize("name", CHAINS)
def test_exact_table(name):
    variant = coursework.load(name)
    table = coursework.exact(variant, quantities=["table", "accelerations", "points"])
    rows = rows_of(name)
    metres = 1e-3 if name == "example-3" else 1.0
    for coordinate in variant.coordinates:
        if coordinate.name not in rows[0]["q"]:
            continue
        unit = 1.0 if coordinate.unit == "rad" else metres
        for column, part in ((coordinate.name, "pos"), (coordinate.rate, "vel"), (f"d{coordinate.rate}", "acc")):
            wanted = unit * np.array([row["q"][coordinate.name][part] for row in rows])
            gap = table[column].to_numpy()[: len(rows)] - wanted
            if part == "pos" and coordinate.unit == "rad":
                gap = gap - 2 * np.pi * np.round(gap / (2 * np.pi))
            assert np.max(np.abs(gap)) <= LIMIT * max(np.max(np.abs(wanted)), 1e-3), (column, np.max(np.abs(gap)))
    for point, parts in rows[0]["points"].items():
        for part in parts:
            if f"{point}.{part}" in table:
                wanted = metres * np.array([row["points"][point][part] for row in rows])
                gap = np.abs(table[f"{point}.{part}"].to_numpy()[: len(rows)] - wanted)
                assert np.max(gap) <= LIMIT * max(np.max(np.abs(wanted)), metres), (point, part)


def test_example_3_shows_the_printed_and_the_converged_velocities():
    """The slides print the velocities of the third Newton step; the tool's are the converged ones."""
    table = coursework.exact("example-3")
    crank_60 = table.iloc[6]
    assert abs(crank_60["w2"] + 0.580620086413654) < 1e-13
    assert abs(crank_60["w3"] - 3.25274865848384) < 1e-13
    printed = np.array([-0.580620100031004, 3.252748641369780])
    assert 1e-8 < np.max(np.abs(crank_60[["w2", "w3"]].to_numpy() - printed)) < 2e-8


def test_example_6_distance_of_the_guide():
    """The printed s4 = 0.4 fits a guide 1.0 m above A; with the printed 0.8 m it is 0.2, velocities alike."""
    at_90 = coursework.exact("example-6").iloc[9]
    assert abs(at_90["s4"] - 0.2) < 1e-13
    assert abs(at_90["s2"] - 1.4) < 1e-13
    assert abs(at_90["w3"] - 20 / 7) < 1e-13


@pytest.mark.parametrize("name", [*CHAINS, "variable-crank", "variable-crank-exact", "variable-crank-table"])
def test_velocities_are_the_slopes_of_the_positions(name):
    """Central differences of the exact table on a fine grid confirm its own velocities."""
    variant = coursework.load(name)
    fine = variant.timed(variant.time.end / 4000, variant.time.end)
    table = coursework.exact(fine, quantities=["table"])
    for coordinate in variant.coordinates:
        values, rates = table[coordinate.name].to_numpy(), table[coordinate.rate].to_numpy()
        slopes = np.gradient(values, fine.time.step)[2:-2]
        assert np.max(np.abs(slopes - rates[2:-2])) < 2e-4 * max(1.0, np.max(np.abs(rates)))


def four_bar(mode, *changes):
    """Return a four-bar of crank 0.4 m, coupler 1 m and rocker 0.7 m that turns at 10 rad/s; lengths are written as numbers."""
    return mechanism(
        "four-bar", ('["r1"]', '["0.4"]'), ('["r2", "r3"]', "[1, 0.7]"), *changes, r1=None, r2=None, r3=None, d="1.2 m", n=None,
        w1="10", step="0.01 s", end="0.05 s", period=None, mode=mode,
    )  # fmt: skip


def beside(mode, *changes):
    """Return that four-bar with a gear that its rocker turns, by a written equation."""
    gear = 'psi = { start = "0 rad", rate = "w9" }\n[time]'
    return four_bar(mode, *changes, ("[time]", gear)) + '[[constraint]]\nequation = "0.2*w9 = 0.7*w3"\n'


@pytest.mark.parametrize(("mode", "start"), [("+1", 0.768793548991278), ("-1", -0.768793548991278)])
def test_groups_place_their_coordinates_also_beside_written_equations(mode, start):
    """A gear turned by a four-bar: the groups give the start in the mode that is named, and refuse another one."""
    run = coursework.solve(parse_variant(beside(mode)))
    assert run.motion.column("phi2")[0] == pytest.approx(start, abs=1e-14)
    assert np.allclose(run.exact.column("psi"), 3.5 * (run.exact.column("phi3") - run.exact.column("phi3")[0]), atol=1e-12)
    wrong = beside(mode, ("phi2 = {", f'phi2 = {{ start = "{-start} rad",'))
    with pytest.raises(coursework.InputError, match=r"phi2 = .* does not close the chain: with the `mode` given it begins at"):
        _ = coursework.solve(parse_variant(wrong)).motion


def test_a_driven_slide_may_carry_a_dyad():
    """A coordinate that is driven needs no crank: the chain is whole, exact in closed form, with one freedom."""
    crank = '[[group]]\nkind = "crank"\nfrom = ["A"]\nmeets = "B"\nlengths = ["0.4"]\ncoordinates = ["phi1"]\n'
    text = four_bar(
        "-1", ('phi1 = { start = "0 deg", rate = "w1" }', 's = { start = "0.1 m", rate = "w1" }'), ('"10"', '"0.5"'), (crank, ""),
        ('D = "(d, 0)"', 'D = "(d, 0)"\nB = "(s + 0.3, 0)"'), ('"A", "D"', '"D"'),
    )  # fmt: skip
    run = coursework.solve(parse_variant(text))
    assert run.exact.label == "closed form of the groups"
    assert run.scene.mechanism.mobility.degrees == 1
    ends = run.exact.column("s") + 0.3 + np.cos(run.exact.column("phi2"))
    assert np.allclose(ends, 1.2 + 0.7 * np.cos(run.exact.column("phi3")), atol=1e-14)
    assert np.all(np.sin(run.exact.column("phi2")) < 0)


@pytest.mark.parametrize("group", [True, False], ids=["crank", "angles"])
def test_what_is_driven_altogether_needs_no_equation(group):
    crank = '[[group]]\nkind = "crank"\nfrom = ["A"]\nmeets = "B"\nlengths = ["2 m"]\ncoordinates = ["phi"]\n'
    text = (
        '[drive]\nw1 = "3"\n[coordinates]\nphi = { start = "0 rad", rate = "w1" }\n[time]\nstep = "0.1 s"\nend = "1 s"\n'
        '[points]\nA = "(0, 0)"\n' + (crank if group else 'B = "A + 2 @ phi"\n')
    )
    table = coursework.solve(parse_variant(text), quantities=["table", "checks", "accelerations", "points"]).table
    assert np.allclose(table["phi"], 3 * table.index)
    assert np.allclose(table["B.ax"], -18 * np.cos(table["phi"]), atol=1e-13)
    assert np.all(table["dw1"] == 0)


def test_a_gear_pair_has_accelerations():
    """Equations with constant coefficients only: the differentiated right side is a plain zero."""
    text = (
        '[drive]\nw1 = "3*t"\n[coordinates]\nphi = { start = "0 rad", rate = "w1" }\npsi = { start = "0 rad", rate = "w2" }\n'
        '[time]\nstep = "0.1 s"\nend = "1 s"\n[[constraint]]\nequation = "w2 = 2*w1"\n'
    )
    table = coursework.solve(parse_variant(text), quantities=["table", "accelerations"]).table
    assert np.all(table["dw1"] == 3)
    assert np.all(table["dw2"] == 6)


def test_the_guides_of_a_dyad_are_named_when_they_become_parallel():
    text = (
        '[drive]\nw1 = "1"\n[coordinates]\nphi = { start = "0 rad", rate = "w1" }\ns = { rate = "u1" }\np = { rate = "u2" }\n'
        '[time]\nstep = "0.1 s"\nend = "3 s"\n[points]\nA = "(0, 0)"\nK = "(0.5, 0.3)"\n'
        '[[group]]\nkind = "PRP"\nguides = [{ through = "A", angle = "phi + 0.4" }, { through = "K", angle = "2" }]\n'
        'meets = "C"\ncoordinates = ["s", "p"]\n'
    )
    stop = coursework.solve(parse_variant(text)).stop
    assert stop.time == pytest.approx(1.6, abs=1e-8)
    assert "the two guides are parallel" in stop.meaning


def test_a_mode_that_is_not_written_is_taken_from_the_start_or_asked_for():
    for mode, start in (("+1", 0.768793548991278), ("-1", -0.768793548991278)):
        named = beside(mode)
        other = 1.6871299784681 if mode == "+1" else 4.59605532871149
        by_start = named.replace(f'mode = "{mode}"', "").replace("phi2 = { ", f'phi2 = {{ start = "{start} rad", ')
        by_start = by_start.replace("phi3 = { ", f'phi3 = {{ start = "{other} rad", ')
        assert coursework.solve(parse_variant(by_start)).motion.column("phi2")[0] == pytest.approx(start, abs=1e-14)
    with pytest.raises(coursework.InputError, match=r'RRR closes in two ways. Write mode = "\+1" \(C to the left'):
        _ = coursework.solve(parse_variant(named.replace('mode = "-1"', ""))).motion
