"""A law given as a table: value, first and second derivative between equally spaced nodes.

Enters: nodes.  Leaves: functions of one argument.  Used by `programs.py`.
Source: V. R. Pasika (mathematics.md section 4): the five-point formulas, applied twice for the second derivative.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.errors import CourseworkError

Array = NDArray[np.float64]
# Part of an interval by which round-off may lie beyond the table.
_SLACK = 1e-6


class OutsideTable(CourseworkError):
    """A law was asked for beyond its table."""


class TableLaw:
    """A polynomial between every two nodes, for the value and both derivatives.

    `method` "five-point": nodal derivatives by the five-point formulas, quartic between nodes; "spline": cubic.
    `pieces[order]` (intervals, degree + 1): coefficients in u = 0 … 1, the lowest first.
    """

    def __init__(self, name: str, rows: tuple[tuple[float, float], ...], method: str) -> None:
        self.name = name
        self.first, self.last = rows[0][0], rows[-1][0]
        self.intervals = len(rows) - 1
        self.step = (self.last - self.first) / self.intervals
        values = np.array([row[1] for row in rows])
        self.pieces = _cubics(values, self.step) if method == "spline" else _quartics(values, self.step)

    def function(self, order: int) -> Callable[[Any], Any]:
        """Return the function of the law's argument (a number or an array) that gives its derivative of `order` 0, 1 or 2.

        A march asks for one number at a time, so there plain Python is twenty times as fast as NumPy.
        """
        pieces = self.pieces[order]
        listed = [tuple(reversed(piece)) for piece in pieces.tolist()]

        def law(argument: Any) -> Any:
            place = (argument - self.first) / self.step
            if isinstance(argument, np.ndarray):
                if not np.all(self.covers(argument)):
                    raise self._outside(float(argument.flat[int(np.argmax(np.abs(place - self.intervals / 2)))]))
                inside = np.clip(np.floor(place).astype(int), 0, self.intervals - 1)
                return reduce(lambda total, part: total * (place - inside) + part, np.moveaxis(pieces[inside], -1, 0)[::-1])
            if not -_SLACK <= place <= self.intervals + _SLACK:
                raise self._outside(float(argument))
            interval = min(max(int(place), 0), self.intervals - 1)
            u, total = place - interval, 0.0
            for part in listed[interval]:
                total = total * u + part
            return total

        return law

    def covers(self, argument: Any) -> Any:
        """Return whether the table reaches an argument (a number or an array)."""
        place = (argument - self.first) / self.step
        return (place >= -_SLACK) & (place <= self.intervals + _SLACK)

    def _outside(self, found: float) -> OutsideTable:
        covered = f"{self.first:.9g} to {self.last:.9g}"
        return OutsideTable(
            f"the table of {self.name} covers {covered}, but {found:.9g} is asked for. Add nodes, or end the motion before."
        )


def _quartics(values: Array, step: float) -> list[Array]:
    """Return the quartics through five nodes around each interval: of the values, their derivatives, and those of these."""
    from coursework.five_point import five_point_derivative

    first = five_point_derivative(values, step)
    last = len(values) - 1
    pieces = []
    for level in (values, first, five_point_derivative(first, step)):
        found = []
        for interval in range(last):
            start = min(max(interval - 1, 0), last - 4)
            powers = np.vander(np.arange(start, start + 5) - float(interval), increasing=True)
            found.append(np.linalg.solve(powers, level[start : start + 5]))
        pieces.append(np.array(found))
    return pieces


def _cubics(values: Array, step: float) -> list[Array]:
    """Return the cubics of the spline and their derivatives."""
    slopes = _spline_slopes(values, step) * step
    y0, y1, m0, m1 = values[:-1], values[1:], slopes[:-1], slopes[1:]
    a, b = 2 * y0 - 2 * y1 + m0 + m1, -3 * y0 + 3 * y1 - 2 * m0 - m1
    return [
        np.stack([y0, m0, b, a], axis=1),
        np.stack([m0, 2 * b, 3 * a], axis=1) / step,
        np.stack([2 * b, 6 * a], axis=1) / step**2,
    ]


def _spline_slopes(values: Array, step: float) -> Array:
    """Return the nodal slopes of the cubic spline with not-a-knot ends."""
    n = len(values)
    matrix = np.zeros((n, n))
    right = np.zeros(n)
    for i in range(1, n - 1):
        matrix[i, i - 1 : i + 2] = 1.0, 4.0, 1.0
        right[i] = 3 * (values[i + 1] - values[i - 1]) / step
    matrix[0, :3] = 1.0, 0.0, -1.0
    right[0] = 2 * (2 * values[1] - values[0] - values[2]) / step
    matrix[-1, -3:] = 1.0, 0.0, -1.0
    right[-1] = 2 * (2 * values[-2] - values[-3] - values[-1]) / step
    return np.asarray(np.linalg.solve(matrix, right))
