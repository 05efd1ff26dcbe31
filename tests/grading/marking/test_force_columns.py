"""Columns of forces marked cell by cell: what is right by either table, how near, what is missing, and which slip is named."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.grading.marking.force_columns import mark_forces

EXACT = np.array([10.0, -20.0, 30.0, -40.0, 50.0])  # N; within 1 % of the largest, 0.5 N, and half of the last digit
KEY: Any = SimpleNamespace(
    table=np.zeros((5, 1)),
    forces=SimpleNamespace(columns=lambda name: (EXACT, EXACT + 5, {"no_inertia": EXACT * 3, "no_weight": EXACT * 2})),
)


def marked(values: list[float] | None, digit: float = 0.2) -> Any:
    column = None if values is None else SimpleNamespace(values=tuple(values), last_place=(digit,) * len(values))
    return mark_forces(KEY, SimpleNamespace(column=lambda name: column), ("R01",), 0.5)  # type: ignore[arg-type]


@pytest.mark.parametrize(("values", "right", "missing", "slip", "earned"), [
    ([10, -20, 30, -40, 50], 5, 0, "", 5.0),
    ([15, -15, 30, -35, 55], 5, 0, "", 5.0),  # by the assigned table where it is not exact
    ([10.59, -20.59, 30.59, -39.41, 49.41], 5, 0, "", 5.0),  # 0.5 N and half of 0.2 N
    ([10.61, -20.61, 30.61, -39.39, 49.39], 0, 0, "", 0.0),
    ([10, np.nan, 30, np.nan, 50], 3, 2, "", 3.0),
    ([30, -60, 90, -120, 7], 0, 0, "no_inertia", 2.0),  # four of five: half of each
    ([30, -60, 90, -120, np.nan], 0, 1, "no_inertia", 2.0),
    ([20, -40, 60, -80, 100], 0, 0, "no_weight", 2.5),
    ([30, -60, 90, 7, 7], 0, 0, "", 0.0),  # three of five
    ([30, -60, 90, np.nan, np.nan], 0, 2, "no_inertia", 1.5),  # three of three
    ([10, -20, 30, np.nan, np.nan], 3, 2, "", 3.0),
    ([np.nan] * 5, 0, 5, "", 0.0),
    (None, 0, 5, "", 0.0),
])  # fmt: skip
def test_cells_are_right_by_either_table_and_a_slip_has_a_part_of_what_it_explains(
    values: list[float] | None, right: int, missing: int, slip: str, earned: float
) -> None:
    found = marked(values)
    assert found.plain() == [{"name": "R01", "cells": 5, "right": right, "missing": missing, "slip": slip}]
    assert (found.count, found.earned) == (5, earned)
    assert [(note.code, note.text.key.endswith("_slip")) for note in found.notes()] == (
        [] if right == 5 else [("force_column", bool(slip))]
    )
