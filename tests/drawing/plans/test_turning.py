"""How fast a link turns, from whatever shows it: a body that turns about a moving point, its motion written down by hand."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.drawing.outline.outline import Bar, Block, Slot
from coursework.drawing.plans.moving import Moving, _turning

# Angle, rate and angular acceleration of the body in two rows; its point A has a motion of its own.
ANGLE, RATE, CHANGE = np.array([0.3, 2.0]), np.array([1.7, -0.4]), np.array([-5.0, 2.5])
OWN = Moving(np.array([1 + 2j, 3 - 1j]), np.array([0.5 - 1j, 2j]), np.array([3 + 0j, -1 - 1j]))
STILL = Moving(*np.zeros((3, 2), complex))


def carried(arm: complex) -> Moving:
    """A point of the body at `arm` from A when the angle is 0."""
    way = arm * np.exp(1j * ANGLE)
    return Moving(OWN.at + way, OWN.velocity + 1j * RATE * way, OWN.acceleration + (1j * CHANGE - RATE**2) * way)


POINTS = {"A": OWN, "B": carried(0.4 + 0.1j), "C": carried(-0.2 + 0.7j), "O": STILL}
MOTION: Any = SimpleNamespace(t=np.zeros(2), velocity_names=("w1", "w2"), velocities=np.array([[9.0, 1.7], [9.0, -0.4]]))
RATES = np.array([[9.0, -5.0], [9.0, 2.5]])


def turning(bar: Bar, **more: Any) -> Any:
    outline: Any = SimpleNamespace(**{"slots": (), "blocks": (), **more})
    return _turning(bar, outline, POINTS, MOTION, RATES)


@pytest.mark.parametrize(
    ("bar", "more"),
    [
        (Bar("2", ("O", "A"), "w2"), {}),  # the column counts, whatever its corners do
        (Bar("2", ("A", "B")), {}), (Bar("2", ("B", "A"), "w9"), {}), (Bar("2", ("A", "B", "C")), {}), (Bar("2", ("C", "B")), {}),
        (Bar("2", ("A",)), {"slots": (Slot("1", "A", "O", "A", ("O",)), Slot("2", "A", "B", "C", ("O",)))}),
        (Bar("2", ("O", "A")), {"slots": (Slot("2", "A", "A", "C", ("O",)),)}),
        (Bar("2", ("A",)), {"blocks": (Block("2", "A", "O", "A"), Block("2", "A", "A", "B", open=True))}),
    ],
)  # fmt: skip
def test_a_link_turns_as_its_column_its_slot_its_points_or_its_sleeve_says(bar: Bar, more: Any) -> None:
    rate, change = turning(bar, **more)
    assert (rate, change) == (pytest.approx(RATE), pytest.approx(CHANGE))


def test_a_link_of_one_point_that_slides_nowhere_turns_no_way() -> None:
    assert [part.tolist() for part in turning(Bar("2", ("A",)), blocks=(Block("2", "A", "O", "B"),))] == [[0, 0], [0, 0]]
