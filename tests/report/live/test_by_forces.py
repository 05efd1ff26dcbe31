"""What the script of a page with forces is told: masses and loads as data, units, arrows, drives; read without a browser."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

import coursework
from coursework.equations.codegen.programs import Assign
from coursework.equations.reduction.symbolic import local, symbol
from coursework.report.live.by_forces import given_once, moved_by, said_of, with_weights
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import evaluate
from coursework.variant.record.entries import Given
from coursework.variant.record.forces import Load, Mass
from coursework.words.sentences import load_phrases
from tests.solved import solved


def more(variant: Any) -> dict[str, tuple[float, str, str]]:
    """Return the data that are no data of the file, with values and units."""
    known = {one.name for one in coursework.load("example-1-forces").given}
    return {one.name: (one.value, one.unit, one.si) for one in variant.given if one.name not in known}


def test_masses_and_loads_given_as_numbers_are_data_and_inertia_goes_along() -> None:
    variant = with_weights(coursework.load("example-1-forces"))
    masses = {f"m_{link}": (mass, "kg", "kg") for link, mass in ((1, 4.0), (2, 10.0), (3, 7.0))}
    assert more(variant) == masses | {"Q1": (-60.0, "N*m", "N*m")}  # F1 has a datum of its own
    data = {**variant.values, "m_2": 15.0, "Q1": -90.0}
    assert [evaluate(mass.mass, data) for mass in variant.forces.masses] == [4.0, 15.0, 7.0]
    assert [evaluate(mass.inertia, data) for mass in variant.forces.masses] == pytest.approx([0.0533, 1.2495, 0.286])
    force, torque = variant.forces.loads
    assert evaluate(torque.torque, data) == -90.0 and force == coursework.load("example-1-forces").forces.loads[0]


def test_other_loads_have_a_factor_and_what_a_file_names_itself_is_left() -> None:
    """A mass or a load that data give has them already, and a name that the file has is not taken; a shape stays a shape."""
    variant = coursework.load("example-1-forces")
    loads = (
        Load("F1", "3", parse("C"), parse("(30, -40)", vectors=True), None), Load("P2", "3", None, None, parse("-2*F0*r1")),
        Load("Q0", "3", None, None, parse("5*w1")), Load("Z", "3", None, None, parse("0")),
        Load("r2", "3", None, None, parse("7")),
    )  # fmt: skip
    masses = (
        Mass("1", parse("4"), "rod", None), Mass("2", parse("5*r1"), parse("5*r1/6"), None),
        Mass("3", parse("0"), parse("0"), None), Mass("4", parse("2"), parse("r1"), None), Mass("5", parse("6"), "rod", None),
    )  # fmt: skip
    given = (*variant.given, Given("m_5", 1.0, "m", "", "m"))
    found = with_weights(replace(variant, given=given, forces=replace(variant.forces, loads=loads, masses=masses)))
    assert more(found) == {
        "m_1": (4.0, "kg", "kg"), "m_4": (2.0, "kg", "kg"), "m_5": (1.0, "m", "m"),
        "F1": (1.0, "", "1"), "Q0": (1.0, "", "1"), "Z": (1.0, "", "1"),
    }  # fmt: skip
    assert [one.inertia for one in found.forces.masses] == ["rod", *(one.inertia for one in masses[1:])]
    assert len(found.given) == len(given) + 5 and found.forces.masses[4] == masses[4]
    assert found.forces.masses[1:3] == masses[1:3] and (found.forces.loads[1], found.forces.loads[4]) == (loads[1], loads[4])
    f1, _, q0, *_ = found.forces.loads
    assert (f1.force.op, f1.force.args[0].name, f1.force.args[1], f1.torque) == ("*", "F1", loads[0].force, None)
    assert evaluate(q0.torque, {"w1": 3.0, "Q0": -2.0}) == -30.0 and q0.force is None


@pytest.mark.parametrize(("name", "drives", "arrows"), [
    ("31-forces", ["FMx", "FMy"], {"R_01": [0, 1], "R_12": [2, 3], "T_04": [8], "N_04": [9], "F_M": [10, 11]}),
    ("example-1-forces", ["M"], {"R_01": [0, 1], "R_03": [6, 7]}),
    ("example-2-motor", [], {"R_23": [4, 5], "N_03": [6]}),
])  # fmt: skip
def test_drives_and_the_places_of_arrows(name: str, drives: list[str], arrows: dict[str, list[int]]) -> None:
    """Two components make one arrow, a couple none; what the motor makes is no unknown drive."""
    told = moved_by(solved(name), []).numbers["forces"]
    found = {head: places for head, *places in told["arrows"]}
    assert told["drives"] == drives and {head: found[head] for head in arrows} == arrows
    names = [unknown[0] for unknown in told["unknowns"]]
    assert sorted(place for places in found.values() for place in places) == [
        place for place, one in enumerate(names) if one[0] not in "KM"
    ]


def test_a_free_motion_has_its_rates_as_coordinates_and_its_start() -> None:
    found = moved_by(solved("example-2-motor"), [])
    assert found.numbers["coordinates"] == ["theta1", "theta2", "s3", "w1"]
    assert found.numbers["velocities"] == ["w1", "w2", "u3", "dw1"]
    assert found.numbers["start"] == [0.0, 0.0, pytest.approx(1.6), 0.0]
    assert found.numbers["forces"]["more"] == 2  # w2 and u3 are in no row
    assert {name for name, one in found.numbers["schemes"].items() if one.get("early")} == {"semi-implicit"}
    assert (found.numbers["scheme"], found.numbers["own"]) == ("euler", True)
    assert found.pieces(["a", "b", "c"]) == ["a", "free_motion", "b", "acting", "forces", "free_laboratory", "c"]
    assert moved_by(solved("31-forces"), []).pieces(["a", "b", "c"]) == ["a", "b", "acting", "forces", "c"]
    exact = moved_by(solved("example-2-motor", scheme="exact"), [])
    assert (exact.numbers["scheme"], exact.numbers["own"]) == ("euler", False)


@pytest.mark.parametrize(("free", "unknowns", "units"), [
    ({}, [["R01x", 0, -1, 0, 0, 0], ["FMx", 0, -1, 0, 0, 1], ["MD", 0, -1, -1, 0, 1], ["T1", 0, -1, -1, 2, 1]],
     {"E": "[J]", "FMx": "[N]", "MD": "[N·m]", "T1": "[N·m]"}),
    ({"free": [0]}, [], {"E": "[J]"}),
])  # fmt: skip
def test_units_and_labels_of_what_forces_add(free: Any, unknowns: Any, units: dict[str, str]) -> None:
    variant = SimpleNamespace(values={"m_1": 4.0, "r1": 0.4})
    found = SimpleNamespace(numbers={"forces": {"unknowns": unknowns, **free}}, scene=SimpleNamespace(variant=variant))
    said = {"labels": {"x": "X"}, "unit_words": {"x": "m"}, "behind": {"x": " m"}, "words": {"a": "b"}}
    labels = {"m_1": "m₁", "FMx": "F"}
    got = said_of(found, said, load_phrases(), lambda name: labels.get(name, name), "[{}]".format)  # type: ignore[arg-type]
    assert got["unit_words"] == {"x": "m"} | units and {*got["behind"]} == {"x", *units}
    assert got["labels"] == {"x": "X", "m_1": "m₁"} | ({} if free else {"FMx": "F"})
    assert {*got["words"]} == ({"a", "scheme_semi-implicit"} if free else {"a"})


def test_a_value_is_given_once() -> None:
    one, again, energy = Assign(local("a"), symbol("x")), Assign(local("a"), symbol("y")), Assign(local("_kinetic"), symbol("x"))
    assert [*given_once([one, energy, again, Assign(local("b"), symbol("x"))])] == [one, Assign(local("b"), symbol("x"))]
