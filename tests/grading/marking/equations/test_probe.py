"""What a law gives where equations are tried: its table at the nodes, its pieces each in its own time."""

from __future__ import annotations

import math

import numpy as np
import pytest

import coursework
from coursework.grading.marking.equations.probe import _law, random_probe
from coursework.grading.marking.key.key import key_of


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


def test_equations_are_tried_near_the_positions_of_the_table_and_at_other_ones() -> None:
    """Half of what the table goes through to each side: in the wider box there are eight points, not all within the table."""
    key = key_of(coursework.load("31"))
    q = np.column_stack([random_probe(key).names[one] for one in ("phi1", "phi2", "phi3")])
    low, high = key.table[:, :3].min(axis=0), key.table[:, :3].max(axis=0)
    assert q.shape == (8, 3)
    assert (np.abs(q - (low + high) / 2) <= high - low).all()
    assert not (np.abs(q - (low + high) / 2) <= (high - low) / 2).all()
