"""Rectangles on a sheet -> what each of them would cover, and how far it is from lines; many rectangles at once.

Enters: rectangles as corners low and high (n, 2), and what is drawn, all in mm.  Leaves: arrays.
Used by `placing.py`, a thousand times a drawing, and by `report/live/spots.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.system.arrays import Array, Flags, cross

Segment = tuple[complex, complex]
Rectangle = tuple[float, float, float, float]
CLOSE = 1e-9  # mm: lines at most this far from a rectangle are examined exactly
STILL = 1e-150  # stands for a step of 0, so that a line along an axis needs no case of its own; no quotient by it overflows


def shared(low: Array, high: Array, others: Sequence[Rectangle] | Array) -> Array:
    """Return width and height (..., n, m, 2) of what rectangles (..., n, 2) share with `others`; below 0 if they are apart.

    `others` are (left, top, right, bottom), shape (..., m, 4); the leading axes are rows of a motion.
    """
    boxes = np.asarray(others).reshape(*low.shape[:-2], -1, 4)[..., None, :, :]
    return np.asarray(np.minimum(high[..., None, :], boxes[..., 2:]) - np.maximum(low[..., None, :], boxes[..., :2]))


def clipped(low: Array, high: Array, begin: Array, step: Array, free: Array | float = 0.0) -> Array:
    """Return the part (..., n, m), 0 to 1, of each line from `begin` by `step` (..., m, 2) inside each rectangle (..., n, 2).

    For each line the rectangles are enlarged by `free` (m, 1) on every side.
    """
    first = (low[..., None, :] - (begin + free)[..., None, :, :]) / step[..., None, :, :]
    second = (high[..., None, :] - (begin - free)[..., None, :, :]) / step[..., None, :, :]
    enters, leaves = np.minimum(first, second), np.maximum(first, second)
    begins = np.maximum(np.maximum(enters[..., 0], enters[..., 1]), 0.0)
    return np.asarray(np.maximum(np.minimum(np.minimum(leaves[..., 0], leaves[..., 1]), 1.0) - begins, 0.0))


def through(begin: Array, step: Array, boxes: Array) -> Flags:
    """Return whether each line from `begin` (n, 2) by `step` (n, 2) goes through each of the `boxes` (m, 4), as (m, n)."""
    return np.asarray(clipped(boxes[:, :2], boxes[:, 2:], begin, np.where(step == 0, STILL, step)) > 0)


class Lines:
    """The segments on a sheet, or points; rectangles are to stay `free` mm away from those after the first `plain` ones."""

    def __init__(self, segments: Sequence[Segment], plain: int | None = None, free: float = 0.0) -> None:
        ends = np.array([(a.real, a.imag, b.real, b.imag) for a, b in segments]).reshape(-1, 2, 2)
        self.count = len(segments)
        self.begin, self.step = ends[:, 0], ends[:, 1] - ends[:, 0]
        self.end = ends[:, 1]
        self.low, self.high = ends.min(axis=1), ends.max(axis=1)
        self.length = np.hypot(*self.step.T)
        self.step[self.step == 0] = STILL
        self.plain = self.count if plain is None else plain
        self.free: Array = np.where(np.arange(self.count) < self.plain, 0.0, free)[:, None]
        self.reach = (self.low - self.free).T, (self.high + self.free).T

    def within(self, low: Array, high: Array) -> tuple[Array, Array, Array]:
        """Return for each rectangle (n,) how many plain segments it meets, their length in it, and how many others it meets."""
        (left, top), (right, bottom) = (low - CLOSE).T[:, :, None], (high + CLOSE).T[:, :, None]
        (begins, starts), (ends, stops) = self.reach
        # Most lines are far from most rectangles: only those that may meet are clipped.
        one, line = np.nonzero((begins <= right) & (ends >= left) & (starts <= bottom) & (stops >= top))
        part = clipped(low[one, None], high[one, None], self.begin[line, None], self.step[line, None], self.free[line, None])
        part, heavy, count = part.ravel(), line >= self.plain, len(low)
        length = np.bincount(one, np.where(heavy, 0.0, part * self.length[line]), count)
        # Both kinds are counted at once, the heavy ones behind the plain ones.
        met = np.bincount((one + count * heavy)[part > 0], minlength=2 * count).astype(np.float64)
        return met[:count], length.astype(np.float64), met[count:]

    def feet(self, points: Array) -> Array:
        """Return the point (n, m, 2) of each segment nearest to each point (n, 2)."""
        square = np.maximum(self.length**2, STILL)
        off = (points[:, None] - self.begin) * self.step
        way = np.minimum(np.maximum((off[..., 0] + off[..., 1]) / square, 0.0), 1.0)
        return np.asarray(self.begin + way[..., None] * self.step)

    def apart(self, low: Array, high: Array) -> Array:
        """Return the distance (n, m) of each rectangle from each segment, 0 if they meet."""
        corners = np.concatenate([low, high, np.column_stack([low[:, 0], high[:, 1]]), np.column_stack([high[:, 0], low[:, 1]])])
        off = self.feet(corners) - corners[:, None]
        far = np.hypot(off[..., 0], off[..., 1]).reshape(4, len(low), self.count).min(axis=0)
        for end in (self.begin, self.end):
            beyond = np.maximum(np.maximum(low[:, None] - end, end - high[:, None]), 0.0)
            far = np.minimum(far, np.hypot(beyond[..., 0], beyond[..., 1]))
        return np.asarray(np.where(clipped(low, high, self.begin, self.step) > 0, 0.0, far))

    def crossed(self, begin: Array, step: Array) -> Array:
        """Return how many segments each line from `begin` (n, 2) by `step` (n, 2) crosses, as (n,)."""
        between = self.begin - begin[:, None]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            turned = cross(step[:, None], self.step)
            along, across = cross(between, self.step) / turned, cross(between, step[:, None]) / turned
        return np.asarray(np.count_nonzero((along > 0) & (along < 1) & (across > 0) & (across < 1), axis=1))
