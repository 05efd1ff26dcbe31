"""A law given as a table: value, first and second derivative between equally spaced nodes.

Enters: nodes.  Leaves: functions of one argument.  Used by `programs.py`.
Source: V. R. Pasika (mathematics.md section 4): the five-point formulas, applied twice for the second derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property, reduce
from typing import Any

import numpy as np

from coursework.system.arrays import Array
from coursework.words.errors import Unplaced
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# Fraction of an interval by which an argument may be outside the table because of round-off.
_SLACK = 1e-6


class OutsideTable(Unplaced):
    """The law `name` was evaluated outside its table."""

    def __init__(self, message: Sentence, name: str) -> None:
        super().__init__(message)
        self.name = name


class TableLaw:
    """A polynomial between adjacent nodes, for the value and both derivatives; computed once, when first needed.

    `method` "five-point": nodal derivatives by the five-point formulas, quartic between nodes; "spline": cubic.
    `pieces[order]` (intervals, degree + 1): coefficients of powers of u = 0 … 1, the lowest first.
    """

    def __init__(self, name: str, rows: tuple[tuple[float, float], ...], method: str) -> None:
        self.name, self.rows, self.method = name, rows, method
        self.first, self.last = rows[0][0], rows[-1][0]
        self.intervals = len(rows) - 1
        self.step = (self.last - self.first) / self.intervals
        self.values = np.array([row[1] for row in rows])
        self._functions: dict[int, Callable[[Any], Any]] = {}

    @cached_property
    def pieces(self) -> list[Array]:
        """Return the coefficients of the value and of both derivatives."""
        return _cubics(self.values, self.step) if self.method == "spline" else _quartics(self.levels)

    @property
    def levels(self) -> list[Array]:
        """Return the nodal data (n,) of the pieces: value and both derivatives, or value and slope for a spline.

        A slope is that of `spline_slopes`, per interval.  A page that stores these instead of pieces needs a fifth of the data.
        """
        if self.method == "spline":
            return [self.values, spline_slopes(self.values.tolist())]
        from coursework.equations.five_point import five_point_derivative

        first = five_point_derivative(self.values, self.step)
        return [self.values, first, five_point_derivative(first, self.step)]

    @property
    def nodes(self) -> Array:
        """Return the arguments (n,) of the nodes."""
        return np.asarray(self.first + self.step * np.arange(self.intervals + 1), dtype=np.float64)

    def function(self, order: int) -> Callable[[Any], Any]:
        """Return the function of the argument (a number or an array) that gives the derivative of `order` 0, 1 or 2.

        Integration evaluates one number at a time, for which plain Python is twenty times as fast as NumPy.
        """
        if order not in self._functions:
            self._functions[order] = self._made(order)
        return self._functions[order]

    def _made(self, order: int) -> Callable[[Any], Any]:
        met: dict[int, tuple[float, ...]] = {}  # intervals used so far, the highest coefficient first

        def law(argument: Any) -> Any:
            place = (argument - self.first) / self.step
            if isinstance(argument, np.ndarray):
                if not np.all(self.covers(argument)):
                    raise self._outside(float(argument.flat[int(np.argmax(np.abs(place - self.intervals / 2)))]))
                inside = np.clip(np.floor(place).astype(int), 0, self.intervals - 1)
                coefficients = np.moveaxis(self.pieces[order][inside], -1, 0)
                return reduce(lambda total, part: total * (place - inside) + part, coefficients[::-1])
            if not -_SLACK <= place <= self.intervals + _SLACK:
                raise self._outside(float(argument))
            interval = min(max(int(place), 0), self.intervals - 1)
            if interval not in met:
                met[interval] = tuple(self.pieces[order][interval, ::-1].tolist())
            u, total = place - interval, 0.0
            for part in met[interval]:
                total = total * u + part
            return total

        return law

    def covers(self, argument: Any) -> Any:
        """Return whether an argument (a number or an array) is inside the table."""
        place = (argument - self.first) / self.step
        return (place >= -_SLACK) & (place <= self.intervals + _SLACK)

    def _outside(self, found: float) -> OutsideTable:
        told = say("fault.V522", name=self.name, first=self.first, last=self.last, found=found)
        return OutsideTable(told, self.name)


def _quartics(levels: list[Array]) -> list[Array]:
    """Return the quartics through the five nodes around each interval: for the values, first and second derivatives."""
    from coursework.equations.five_point import NODES

    intervals = np.arange(len(levels[0]) - 1)
    # The five nodes begin one before the interval; at the ends they are shifted as far as necessary.
    starts = np.clip(intervals - 1, 0, len(levels[0]) - NODES)
    pieces = []
    for level in levels:
        around = level[starts[:, None] + np.arange(NODES)]
        found = np.empty_like(around)
        for offset in np.unique(starts - intervals):
            powers = np.vander(offset + np.arange(NODES, dtype=float), increasing=True)
            same = starts - intervals == offset
            found[same] = np.linalg.solve(powers, around[same].T).T
        pieces.append(found)
    return pieces


def _cubics(values: Array, step: float) -> list[Array]:
    """Return the cubics of the spline and their derivatives."""
    slopes = spline_slopes(values.tolist())
    y0, y1, m0, m1 = values[:-1], values[1:], slopes[:-1], slopes[1:]
    a, b = 2 * y0 - 2 * y1 + m0 + m1, -3 * y0 + 3 * y1 - 2 * m0 - m1
    return [
        np.stack([y0, m0, b, a], axis=1),
        np.stack([m0, 2 * b, 3 * a], axis=1) / step,
        np.stack([2 * b, 6 * a], axis=1) / step**2,
    ]


def spline_slopes(values: Sequence[float]) -> Array:
    """Return the slopes (n,) at the nodes of the cubic spline with not-a-knot ends, per interval.

    Inside, m[i-1] + 4 m[i] + m[i+1] = 3 (y[i+1] - y[i-1]).  The end rows, m[0] - m[2] = 2 (2 y[1] - y[0] - y[2]) and its
    mirror image, are substituted into their neighbours, so that three diagonals are left and n nodes cost n steps.
    """
    right = [3 * (after - before) for before, after in zip(values, values[2:], strict=False)]
    low = 2 * (2 * values[1] - values[0] - values[2])
    high = 2 * (2 * values[-2] - values[-1] - values[-3])
    right[0] -= low
    right[-1] += high
    # (4 2; 1 4 1; …; 1 4 1; 2 4): forward elimination of the entry left of the diagonal, then back substitution.
    above, inner = [2 / 4], [right[0] / 4]
    for place in range(1, len(right)):
        left = 2.0 if place == len(right) - 1 else 1.0
        pivot = 4 - left * above[-1]
        inner.append((right[place] - left * inner[-1]) / pivot)
        above.append(1 / pivot)
    for place in range(len(inner) - 2, -1, -1):
        inner[place] -= above[place] * inner[place + 1]
    return np.array([inner[1] + low, *inner, inner[-2] - high])
