"""The largest rate of every coordinate of the true motion: seen at the steps of a walk, then searched between them.

Enters: the steps of a walk along the flow.  Leaves: (rate, when) per coordinate, the way within any step.  Used by `search.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import field

import numpy as np

from coursework.motion.integration.hermite import hermite
from coursework.motion.singular.scaled_flow import Clock
from coursework.system.arrays import Array
from coursework.system.frozen import changing
from coursework.words.errors import CourseworkError

# Golden section: `_TRIALS` trials shrink the bracket to 1e-4; the error of the rate is the square of that.
_GOLDEN, _TRIALS = (5**0.5 - 1) / 2, 19
# Between two steps of the walk a rate rises by less than a twentieth: only rates above this share of the largest are searched.
_NEAR = 0.95
# Share of a step at which it is tested whether a rate rises.
_GLANCE = 1e-3
# Number of points within a step of the walk at which positions are evaluated.
_LOOKS = 16
# A rate that varies by less than this share of itself is constant, so no time is given for its maximum.
_CONSTANT = 1e-9


@changing
class Piece:
    """One step of a walk: the `state` (position, then t) and `slope` at its start, the `clock`, the `length` in s."""

    state: Array
    slope: Array
    clock: Clock
    length: float

    def rate(self, part: float, coordinate: int) -> tuple[float, float]:
        """Return |dq/dt| of a coordinate and the time (s) after a `part` of the step."""
        state = self.clock.step(self.state, self.slope, part * self.length)[0]
        slope = self.clock.slope(state)
        return abs(float(slope[coordinate] / slope[-1])), float(state[-1])


@changing
class Peaks:
    """The largest and smallest rates seen, the steps beside each largest one, and state and slope at the start of every step."""

    largest: list[float]
    smallest: list[float]
    when: list[float]
    beside: list[tuple[Piece, ...]]
    last: Piece | None = field(default=None)
    way: list[tuple[Array, Array]] = field(default_factory=list)
    _between: dict[tuple[int, float], list[tuple[float, float]]] = field(default_factory=dict)

    @staticmethod
    def of(count: int) -> Peaks:
        """Return the record of a walk that has not begun, for `count` coordinates."""
        return Peaks([-1.0] * count, [math.inf] * count, [0.0] * count, [()] * count)

    def see(self, piece: Piece) -> None:
        """Record a step; if the same step was recorded with another length before, replace that length."""
        self._between.clear()
        if self.last is not None and self.last.state is piece.state:
            self.last.length = piece.length
            return
        self.way.append((piece.state, piece.slope))
        *moved, pace = piece.slope.tolist()
        for coordinate, move in enumerate(moved):
            rate = abs(move / pace) if pace else math.inf
            self.smallest[coordinate] = min(rate, self.smallest[coordinate])
            if rate > self.largest[coordinate]:
                self.largest[coordinate], self.when[coordinate] = rate, float(piece.state[-1])
                self.beside[coordinate] = (piece,) if self.last is None else (self.last, piece)
        self.last = piece

    def found(self, end: float, turning: Sequence[int]) -> tuple[tuple[float, float | None], ...]:
        """Return per coordinate the largest |rate| up to `end` (s) and its time; the time is None for a constant rate.

        For those `turning` coordinates that may be the fastest, the maximum is also searched between the steps of the walk.
        """
        most = max((self.largest[coordinate] for coordinate in turning), default=0.0)
        listed: list[tuple[float, float | None]] = []
        for coordinate, (rate, least) in enumerate(zip(self.largest, self.smallest, strict=True)):
            if rate - least <= _CONSTANT * rate:
                listed.append((rate, None))
                continue
            seen = [(rate, self.when[coordinate])]
            if coordinate in turning and rate >= _NEAR * most:
                seen += self._inside(coordinate, end)
            listed.append(max(seen))
        return tuple(listed)

    def way_within(self, coordinate: int, end: float, repeats: bool) -> Callable[[float], float]:
        """Return a function of a step (s): the longest path (rad, m) of a coordinate within it; back and forth adds up.

        If the motion `repeats` from `end` (s) on, a step may reach beyond it.
        """
        assert self.last is not None
        state = self.last.clock.step(self.last.state, self.last.slope, self.last.length)[0]
        states, slopes = map(np.array, zip(*self.way, (state, self.last.clock.slope(state)), strict=True))
        t, q = states[:, -1], states[:, coordinate]
        with np.errstate(all="ignore"):
            rate = np.where(slopes[:, -1] != 0, slopes[:, coordinate] / slopes[:, -1], 0.0)
        part, length = np.arange(_LOOKS)[:, None] / _LOOKS, np.diff(t)
        inside = hermite(q[:-1], q[1:], rate[:-1] * length, rate[1:] * length, part)
        times, at = np.append((t[:-1] + part * length).T, t[-1]), np.append(inside.T, q[-1])
        way = np.append(0.0, np.cumsum(np.abs(np.diff(at))))
        whole = float(np.interp(end, times, way)) if repeats else 0.0

        def gone(time: Array) -> Array:
            turns = np.floor(time / end) if repeats else 0.0
            return np.asarray(turns * whole + np.interp(time - turns * end, times, way))

        def longest(step: float) -> float:
            step = step if repeats else min(step, end)
            begin = np.concatenate([times, times - step, [end - step]])
            begin = begin[(begin >= 0) & (begin <= (end if repeats else end - step))]
            return float(np.max(gone(begin + step) - gone(begin), initial=0.0))

        return longest

    def _inside(self, coordinate: int, end: float) -> list[tuple[float, float]]:
        """Return the largest rate with its time for each step that may contain it; results are kept for the next table."""
        key = (coordinate, end)
        if key not in self._between:
            self._between[key] = [_highest(piece, coordinate, end) for piece in self._rising(coordinate)]
        return self._between[key]

    def _rising(self, coordinate: int) -> list[Piece]:
        """Return the step beside the largest rate seen in which the rate is larger still; empty if there is none."""
        *before, after = self.beside[coordinate]
        inside = after.rate(_GLANCE, coordinate)[0] > self.largest[coordinate]
        return [after] if inside else before


def _highest(piece: Piece, coordinate: int, end: float) -> tuple[float, float]:
    """Return the largest rate inside a step and its time, by golden section; times beyond `end` count less the later they are."""

    def seen(part: float) -> tuple[float, float]:
        try:
            rate, time = piece.rate(part, coordinate)
        except (ArithmeticError, ValueError, CourseworkError):
            return -np.inf, end
        return (rate, time) if time <= end else (end - time, end)

    low, high = 0.0, 1.0
    left, right = 1 - _GOLDEN, _GOLDEN
    at_left, at_right = seen(left), seen(right)
    for _ in range(_TRIALS):
        if at_left > at_right:
            high, right, at_right = right, left, at_left
            left = high - _GOLDEN * (high - low)
            at_left = seen(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + _GOLDEN * (high - low)
            at_right = seen(right)
    return max(at_left, at_right)
