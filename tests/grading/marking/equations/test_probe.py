"""What a law gives where equations are tried: its table at the nodes, its pieces each in its own time."""

from __future__ import annotations

import math

import numpy as np
import pytest

import coursework
from coursework.grading.marking.equations.probe import _law


def test_a_law_from_a_table_has_its_values_at_the_nodes_and_none_beyond() -> None:
    (law,) = [one for one in coursework.load("variable-crank-table").functions if one.table]
    nodes, values = np.array(law.table).T
    assert _law(law, {law.of or "t": nodes}) == pytest.approx(values, rel=1e-12)
    beyond = nodes + 0.5 * (nodes[-1] - nodes[0])
    assert np.isnan(_law(law, {law.of or "t": beyond})).all()


@pytest.mark.parametrize("name", ["VMx", "VMy"])
def test_a_law_of_pieces_has_each_in_its_own_time(name: str) -> None:
    """The hand of the robot goes round a square: right, down, left, up, 0.3 s each."""
    variant = coursework.load("robot-arm")
    law = next(one for one in variant.drive if one.name == name)
    t = np.array([0.0, 0.1, 0.29, 0.3, 0.45, 0.6, 0.75, 0.9, 1.05])
    speed = variant.values["V"] * np.sin(math.pi * t / variant.values["T"]) ** 2
    side = np.floor(t / 0.3 + 1e-9).astype(int)
    way = np.array({"VMx": [1, 0, -1, 0], "VMy": [0, -1, 0, 1]}[name])[side]
    assert _law(law, {**variant.values, "pi": math.pi, "t": t}) == pytest.approx(way * speed, abs=1e-12)
