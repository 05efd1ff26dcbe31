"""Other assemblies that position equations allow: every root from anywhere, once, but for the one that the start leads to."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from coursework.grading.marking.key import branches


@pytest.mark.parametrize("singular", [False, True])
def test_roots_are_looked_for_from_many_places_and_each_is_told_once(singular: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of x = 0.3, 2 and -1.5 rad beside s = 1 m the first is the start's; some guesses find nothing, or no number.

    Where one guess meets a singular position they are followed one by one.
    """
    turn = 2 * math.pi
    roots = [None, (0.3, 1.0), (math.nan, 1.0), (2.0, 1.0), (2.0 - turn, 1.0), (-1.5 + 2 * turn, 1.0), (2.0, 1.1)]
    asked: list[Any] = []

    def newton(t: float, guess: Any, origin: Any) -> Any:
        asked.append(guess)
        root = roots[len(asked) - 1] if len(asked) <= len(roots) else (0.3, 1.0)
        return None if root is None else np.array(root)

    def newton_rows(times: Any, guesses: Any, origins: Any) -> Any:
        if singular:
            raise np.linalg.LinAlgError
        found = [newton(0.0, guess, None) for guess in guesses]
        is_closed = np.array([root is not None and bool(np.isfinite(root).all()) for root in found])
        return np.array([(0.0, 0.0) if root is None else root for root in found]), is_closed

    closure: Any = SimpleNamespace(
        newton=newton, newton_rows=newton_rows, free=[0, 1], start=np.array([0.31, 1.0]), scale=2.0, origin=np.zeros(2)
    )
    monkeypatch.setattr(branches, "closed_start", lambda closure: (None, np.array([0.3, 1.0])))
    variant: Any = SimpleNamespace(coordinates=[SimpleNamespace(unit="rad"), SimpleNamespace(unit="m")])
    found = [root.tolist() for root in branches._roots(closure, variant)]
    assert found == [[2.0, 1.0], [pytest.approx(-1.5), 1.0], [2.0, 1.1]]
    assert len(asked) == 64
    angles, lengths = np.array(asked).T
    assert np.abs(angles).max() <= math.pi and np.abs(lengths).max() <= 2.0
    assert np.ptp(angles) > 5.0 and np.ptp(lengths) > 3.0
    monkeypatch.setattr(branches, "closed_start", lambda closure: (None, None))
    asked.clear()
    assert next(branches._roots(closure, variant)).tolist() == pytest.approx([0.3, 1.0])  # the start itself, 0.31, is no root


def test_positions_are_apart_by_their_largest_difference_but_for_whole_turns() -> None:
    one, turning = np.array([0.1, 3.0]), np.array([True, False])
    assert branches._apart(one, np.array([0.3 + 4 * math.pi, 2.9]), turning) == pytest.approx(0.2)
    assert branches._apart(one, np.array([0.3, 3.0 + 2 * math.pi]), turning) == pytest.approx(2 * math.pi)
