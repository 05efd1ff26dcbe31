"""Reactions and drives against numbers of two other methods, and against what was published.

`tests/reference/forces/`: Newton and Euler in 40 digits and constrained Lagrange in body coordinates (their agreement stands in
each file); `andrews_t0.json`: E. Hairer, G. Wanner, Solving ODEs II, VII.7.
"""

import json
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics.flywheel import find_flywheel
from tests.effects.massed import of, of_text
from tests.mechanisms.library import mechanism
from tests.report.real import parts
from tests.report.real import text_of as shown

REFERENCE = Path(__file__).parents[1] / "reference" / "forces"
SHARE = 1e-11  # of the largest force of the file


def reference(name):
    return json.loads((REFERENCE / f"{name}.json").read_text(encoding="utf-8"))


def compare(found, columns):
    """Every reaction and drive of the reference is there, and equal."""
    names = [name for name in columns if name[0] in "RNKTFM" and name not in {"T"}]
    largest = max(np.abs(columns[name]).max() for name in names)
    assert set(names) == set(found.reactions.names)
    for name in names:
        assert np.abs(found.column(name) - columns[name]).max() <= SHARE * largest, name
    beside = [name for name in columns if name in found.beside]
    for name in beside:
        assert np.abs(found.beside[name] - columns[name]).max() <= 1e-11 * max(1.0, np.abs(columns[name]).max()), name
    assert len(beside) >= 2 * len([name for name in columns if name.endswith(".ax")])


@pytest.mark.parametrize("name", ["31", "example-1", "example-2"])
def test_exact_rows(name):
    found, columns = of(f"{name}-forces"), reference(f"kineto_{name}")["cases"]["plain"]["columns"]
    compare(found, columns)
    assert np.abs(found.energy.kinetic - columns["T"]).max() <= 1e-11 * np.abs(columns["T"]).max()
    assert np.abs(found.energy.drive - columns["P"]).max() <= 1e-11 * np.abs(columns["P"]).max()


def test_the_rows_of_a_student():
    columns = reference("kineto_31")["cases"]["euler"]["columns"]
    found = of("31-forces", "euler")
    largest = max(np.abs(columns[name]).max() for name in found.reactions.names)
    for name in found.reactions.names:
        assert np.abs(found.column(name) - columns[name]).max() <= 1e-12 * largest, name
    # Row 20 asks for less than half of what the mechanism needs.
    assert round(found.column("FMy")[19]) == -1254
    assert round(of("31-forces").column("FMy")[19]) == -2564


def test_centres_off_the_lines_tilted_gravity_and_a_force_anywhere():
    text = mechanism(
        "example-1-forces",
        ('inertia = "0.0533 kg*m^2" }', 'inertia = "0.0533 kg*m^2", centre = "A + 0.1 @ theta1 + 0.05 @ (theta1 + pi/2)" }'),
        ('inertia = "0.833 kg*m^2" }', 'inertia = "0.833 kg*m^2", centre = "B + 0.4 @ theta2 + 0.15 @ (theta2 + pi/2)" }'),
        ('inertia = "0.286 kg*m^2" }', 'inertia = "0.286 kg*m^2", centre = "D + 0.3 @ theta3 - 0.1 @ (theta3 + pi/2)" }'),
        ('gravity = "9.81 m/s^2"', 'gravity = "(1.5, -9.5)"'),
        (
            'Q1 = {',
            'F2 = { on = 2, at = "B + 0.6 @ theta2 + 0.3 @ (theta2 + pi/2)", force = "(120, -250)" }\nQ1 = {',
        ),
    )  # fmt: skip
    compare(of_text(text), reference("kineto_example-1")["cases"]["skew"]["columns"])


def test_row_4_of_the_page_of_the_design():
    first, second = of("example-1-forces"), of("example-2-forces")
    assert [round(float(first.column(name)[3]), 7) for name in ("M", "R12x", "R23y")] == [46.2613701, -542.324109, -203.1197702]
    assert [round(float(second.column(name)[3]), 6) for name in ("M", "N03")] == [503.832095, -95.367768]


def test_andrews_published_multipliers():
    published, found = reference("andrews_t0")["published at t=0"], of("andrews-forces")
    force = [float(found.column(name)[0]) for name in ("RE3x", "RE3y")]
    assert force == pytest.approx(published["lambda"][:2], rel=1e-12)
    assert found.column("M")[0] == pytest.approx(0.033, rel=1e-11)
    assert sum(found.column(f"RE{link}x")[5] for link in "2346") == pytest.approx(0.0, abs=1e-12)


def test_the_flywheel_of_the_slider_crank():
    wanted, found = reference("flywheel_example-2"), find_flywheel(of("example-2-forces"), 2 * np.pi / 10)
    assert found.mean == pytest.approx(wanted["mean torque"], rel=1e-13)
    assert found.excess == pytest.approx(wanted["largest excess dA"], rel=1e-12)
    assert found.crossings == pytest.approx(wanted["crossings of the mean (rad)"], abs=1e-10)
    assert found.needed == pytest.approx(wanted["flywheel Jf = the first less the second"], rel=1e-12)
    # What the file asks for, 1/30 at 10 rad/s, is what the page says: the excess of 486.5 J over 100/30, less the crank's own.
    told = [part for part in parts(coursework.solve("example-2-forces", scheme="exact"), "forces") if part["kind"] == "paragraph"]
    mean, excess = (f"{wanted[key]:.1f}\u00a0{unit}" for key, unit in (("mean torque", "N·m"), ("largest excess dA", "J")))
    assert f"is {mean}, and the largest excess of energy over that mean {excess};" in shown(told)
    assert f"needs a flywheel of {486.5 * 30 / 100 - found.own:.1f}\u00a0kg" in shown(told)
