"""Rectangles on a sheet -> what each of them would cover: symbols, words, lines; many rectangles at once.

Enters: rectangles as corners low and high (n, 2), and what is drawn, all in mm.  Leaves: arrays.
Used by `sheet.py`, which asks a thousand times a drawing.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Segment = tuple[complex, complex]
_STILL = 1e-300  # stands for a step of 0, so that a line along an axis needs no case of its own


def common(low: Array, high: Array, others: Sequence[tuple[float, float, float, float]]) -> Array:
    """Return the area (n, m) that rectangles share with others (left, top, right, bottom), 0 where they are apart."""
    boxes = np.array(others).reshape(-1, 4)
    sides = np.minimum(high[:, None], boxes[:, 2:]) - np.maximum(low[:, None], boxes[:, :2])
    areas: Array = np.multiply.reduce(np.maximum(sides, 0.0), axis=2)
    return areas


class Lines:
    """The segments on a sheet."""

    def __init__(self, segments: Sequence[Segment]) -> None:
        ends = np.array([(a.real, a.imag, b.real, b.imag) for a, b in segments]).reshape(-1, 2, 2)
        self.count = len(segments)
        self.begin, self.step = ends[:, 0], ends[:, 1] - ends[:, 0]
        self.low, self.high = ends.min(axis=1), ends.max(axis=1)
        self.length = np.hypot(*self.step.T)
        self.step[self.step == 0] = _STILL

    def within(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return in how many segments (n,) each rectangle has a part, and how long those parts are together."""
        near = np.flatnonzero(np.all((self.low <= high.max(axis=0)) & (self.high >= low.min(axis=0)), axis=1))
        with np.errstate(over="ignore"):
            first = (low[:, None] - self.begin[near]) / self.step[near]
            second = (high[:, None] - self.begin[near]) / self.step[near]
        enters = np.maximum(np.minimum(first, second).max(axis=2), 0.0)
        leaves = np.minimum(np.maximum(first, second).min(axis=2), 1.0)
        part = np.maximum(leaves - enters, 0.0)
        return np.count_nonzero(part, axis=1), part @ self.length[near]
