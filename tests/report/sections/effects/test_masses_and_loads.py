"""What has mass and what acts stands below the data of the task, as the file gives it."""

from __future__ import annotations

from typing import Any

import pytest

import coursework
from tests.mechanisms.library import mechanism
from tests.report.made import model_of
from tests.report.sections.verdict.test_conclusion import plain

LOAD = 'F1 = { on = "3", at = "C", force = "(-c*u3, 0)" }'
SPRING = 'S1 = { spring = ["A", "C"], stiffness = "0.2 kN/m", free = "90 cm", damping = "3 N*s/m" }'
RUBBING = '[friction]\nB = { coefficient = "0.1", radius = "20 mm" }\n\n[motor] '


def acting(text: str, language: str = "en") -> list[tuple[str, ...]]:
    """Return the rows of the table, nothing where there is none."""
    run = coursework.solve(coursework.parse_variant(text), quantities=("table",))
    (section,) = (section for section in model_of(run, language).sections if section.name == "statement")
    tables: list[Any] = [part for part in section.parts if getattr(part, "id", "") == "acting"]
    return [
        tuple(plain(cell).strip().replace("\u2007", "").replace("\u2008", "") for cell in row)
        for one in tables
        for row in one.rows
    ]


def test_every_mass_and_force_of_a_file_is_on_its_page_in_si() -> None:
    text = mechanism(
        "example-2-motor", ("0.0533 kg*m^2", "rod"), (LOAD, f"{LOAD}\n{SPRING}"), ("[motor] ", RUBBING), ("12 kg", "12000 g")
    )
    assert acting(text) == [
        ("link 1", "mass", "4", "kg"), ("", "moment of inertia", "of a rod", ""),
        ("link 2", "mass", "12", "kg"), ("", "moment of inertia", "1.5", "kg·m²"), ("", "centre of mass", "B + 0.4 ∠ θ2", "m"),
        ("block C", "mass", "20", "kg"), ("", "moment of inertia", "0.6", "kg·m²"),
        ("gravity", "acceleration along y", "−9.81", "m/s²"),
        ("F1, on link 3", "force at C", "(−c u3, 0)", "N"),
        ("S1, from A to C", "stiffness", "200", "N/m"), ("", "free length", "0.9", "m"), ("", "damping", "3", "N·s/m"),
        ("friction at B", "coefficient of friction", "0.1", ""), ("", "radius of the pin", "0.02", "m"),
        ("flywheel on link 1", "moment of inertia", "5", "kg·m²"),
    ]  # fmt: skip


def test_a_file_without_masses_has_no_such_table() -> None:
    assert acting(mechanism("31")) == []


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_the_table_is_in_the_language_of_the_page(language: str) -> None:
    told = [cell for row in acting(mechanism("example-2-motor"), language) for cell in row[:2]]
    assert len(told) == 20 and not {"mass", "gravity", "link 1"} & {*told}
