"""V101 … V112 against independently computed tables: Euler rows, exact rows, accelerations, points (40-digit arithmetic)."""

import json
from pathlib import Path

import numpy as np
import pytest

import coursework

REFERENCE = Path(__file__).parents[2] / "reference" / "variants"
NAMES = sorted(path.stem for path in REFERENCE.glob("*.json"))


def reference(name: str) -> dict:
    return json.loads((REFERENCE / f"{name}.json").read_text(encoding="utf-8"))


def close(found: np.ndarray, wanted: list[float], limit: float = 1e-12) -> None:
    column = np.array(wanted)
    assert np.max(np.abs(found - column)) <= limit * max(np.max(np.abs(column)), 1e-300)


@pytest.mark.parametrize("name", NAMES)
def test_euler_rows(name):
    run = coursework.solve(name, quantities=["table", "checks"])
    rows = reference(name)["euler"]
    table = run.table
    assert len(table) == len(rows) == 25
    assert run.passed, [check for check in run.checks if check.verdict == "FAIL"]
    for coordinate in run.variant.coordinates:
        close(table[coordinate.name].to_numpy(), [row["q"][coordinate.name] for row in rows])
        close(table[coordinate.rate].to_numpy(), [row["qdot"][coordinate.name] for row in rows])


@pytest.mark.parametrize("name", NAMES)
def test_exact_rows_with_accelerations_and_points(name):
    variant = coursework.load(name)
    table = coursework.exact(variant, quantities=["table", "accelerations", "points"])
    rows = reference(name)["exact"]
    for coordinate in variant.coordinates:
        close(table[coordinate.name].to_numpy(), [row["q"][coordinate.name]["pos"] for row in rows])
        close(table[coordinate.rate].to_numpy(), [row["q"][coordinate.name]["vel"] for row in rows])
        close(table[f"d{coordinate.rate}"].to_numpy(), [row["q"][coordinate.name]["acc"] for row in rows])
    for point, values in rows[0]["points"].items():
        if f"{point}.x" not in table:
            continue
        for part in values:
            wanted = [row["points"][point][part] for row in rows]
            scale = max(1.0, float(np.max(np.abs(wanted))))
            assert np.max(np.abs(table[f"{point}.{part}"].to_numpy() - wanted)) <= 1e-12 * scale


@pytest.mark.parametrize("name", NAMES)
def test_every_unknown_velocity_of_the_reference_is_in_the_table(name):
    """Whatever its name: each velocity of the reference equals, up to sign, one column of the exact table."""
    variant = coursework.load(name)
    table = coursework.exact(variant, quantities=["table"])
    rows = reference(name)["exact"]
    for quantity in rows[0]["q"]:
        wanted = np.array([row["q"][quantity]["vel"] for row in rows])
        gaps = [np.max(np.abs(table[column].to_numpy() - wanted)) for column in table]
        assert min(gaps) <= 1e-12 * np.max(np.abs(wanted)), quantity
    for derived in rows[0]["derived"]:
        wanted = np.array([row["derived"][derived]["value"] for row in rows])
        gaps = [np.max(np.abs(table[column].to_numpy() - wanted)) for column in table]
        assert min(gaps) <= 1e-12 * np.max(np.abs(wanted)), derived
