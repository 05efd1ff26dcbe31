"""What makes dimensions good ones: each term of their score by itself."""

from __future__ import annotations

import itertools
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.mechanism.drafts.candidates import End, Placement, _score, _trials
from coursework.mechanism.groups import RRR

CIRCLE = np.exp(1j * np.linspace(0, 2 * np.pi, 25))
TURNING, SWINGING = np.linspace(-3.0, 9.0, 25), np.sin(np.linspace(0, 6, 25))


def score(
    det: float = 0.7, radius: float = 1.0, third: Any = SWINGING, pivots: tuple[complex, ...] = (5 + 0j,), angle: int = 0,
    carried: int | None = None, taken: tuple[complex, ...] = (),
) -> float:  # fmt: skip
    """Return the score of a dyad that hangs on a point going round a circle of 1 m; the point it makes has its own circle."""
    met = radius * CIRCLE + 20
    found: Any = SimpleNamespace(
        meets=SimpleNamespace(position=np.column_stack([met.real, met.imag])),
        scaled_determinant=np.array([-0.9, det]), coordinates=np.column_stack([TURNING, third]),
    )  # fmt: skip
    kind: Any = SimpleNamespace(name="RRP")
    placement = Placement(pivots, ((9j, angle),), (2.0,), carried)
    return _score(kind, found, placement, [End("A", CIRCLE, "", TURNING)], None, taken)


@pytest.mark.parametrize(("changed", "lost"), [
    ({"det": 0.6}, 0.0), ({"det": 0.5}, 0.1), ({"det": -0.5}, 0.1), ({"radius": 2.0}, 0.3), ({"radius": 0.5}, 0.3),
    ({"angle": 90}, 0.0), ({"angle": 45}, 0.02), ({"carried": 90}, 0.0), ({"carried": 30, "angle": 15}, 0.04),
    ({"taken": (5.99 + 0j,)}, 0.3), ({"taken": (6.01 + 0j,)}, 0.0), ({"taken": (20.5 + 0j, 9.5j)}, 0.6),
    ({"third": 0.049 * CIRCLE.real}, 0.3), ({"third": 0.051 * CIRCLE.real}, 0.0),
])  # fmt: skip
def test_what_makes_dimensions_worse(changed: dict[str, Any], lost: float) -> None:
    """Near a dead point, another amplitude, angles that are odd, new places near others, what hardly moves."""
    assert score() == pytest.approx(0.6)
    assert score() - score(**changed) == pytest.approx(lost)


def test_an_angle_that_swings_about_half_a_turn_is_as_still_as_another() -> None:
    about_pi = np.remainder(math.pi + 0.04 * CIRCLE.real + math.pi, 2 * math.pi) - math.pi  # from -pi to pi, as atan2 gives it
    assert np.ptp(about_pi) > 6
    assert score() - score(third=about_pi) == pytest.approx(0.3)


@pytest.mark.parametrize("moved", [0, 40 - 7j])
def test_between_two_points_lengths_follow_from_their_distance_wherever_they_are(moved: complex) -> None:
    """Two points 7.5 m apart: a third of it is the size; the lengths are 2, 2.5, 3 and 4 of it, in tenths of a metre."""
    ends = [End("A", CIRCLE + moved, "", TURNING), End("B", CIRCLE + moved + 7.5, "", TURNING)]
    assert [trial.lengths for trial in _trials(RRR, ends, None)] == list(itertools.product((5.0, 6.2, 7.5, 10.0), repeat=2))
