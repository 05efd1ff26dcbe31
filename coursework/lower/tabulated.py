"""A law given as a table: value, first and second derivative between equally spaced nodes.

Enters: nodes.  Leaves: functions of one argument.  Used by `programs.py`.
Source: V. R. Pasika (mathematics.md section 4): the five-point formulas, applied twice for the second derivative.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursework.errors import CourseworkError

Array = NDArray[np.float64]


class OutsideTable(CourseworkError):
    """A law was asked for beyond its table."""


class TableLaw:
    """`method` "five-point": nodal derivatives by the five-point formulas, quartic between nodes; "spline": cubic."""

    def __init__(self, name: str, rows: tuple[tuple[float, float], ...], method: str) -> None:
        from coursework.five_point import five_point_derivative

        self.name = name
        self.nodes: Array = np.array([row[0] for row in rows])
        self.step = float(self.nodes[-1] - self.nodes[0]) / (len(rows) - 1)
        values = np.array([row[1] for row in rows])
        self.method = method
        if method == "spline":
            self.levels = [values, _spline_slopes(values, self.step)]
        else:
            first = five_point_derivative(values, self.step)
            self.levels = [values, first, five_point_derivative(first, self.step)]

    def function(self, order: int) -> Callable[[Any], Any]:
        """Return the function of the law's argument that gives its derivative of `order` 0, 1 or 2."""
        return lambda argument: self._evaluate(argument, order)

    def _evaluate(self, argument: Any, order: int) -> Any:
        place = (np.asarray(argument, dtype=float) - self.nodes[0]) / self.step
        last = len(self.nodes) - 1
        if np.any(place < -1e-6) or np.any(place > last + 1e-6):
            found = float(np.asarray(argument, dtype=float).flat[int(np.argmax(np.abs(place - last / 2)))])
            covered = f"{self.nodes[0]:.9g} to {self.nodes[-1]:.9g}"
            raise OutsideTable(
                f"the table of {self.name} covers {covered}, but {found:.9g} is asked for. Add nodes, or end the motion before."
            )
        inside = np.clip(np.floor(place).astype(int), 0, last - 1)
        result = self._hermite(place, inside, order) if self.method == "spline" else self._quartic(place, inside, order)
        return result if isinstance(argument, np.ndarray) else float(result)

    def _quartic(self, place: Array, inside: NDArray[np.int_], order: int) -> Array:
        """Interpolate the nodal values of one level by the quartic through five nodes around the interval."""
        start = np.clip(inside - 1, 0, len(self.nodes) - 5)
        x = place - start
        total = np.zeros_like(x)
        for node in range(5):
            weight = np.ones_like(x)
            for other in range(5):
                if other != node:
                    weight = weight * (x - other) / (node - other)
            total = total + weight * self.levels[order][start + node]
        return total

    def _hermite(self, place: Array, inside: NDArray[np.int_], order: int) -> Array:
        values, slopes = self.levels
        u = place - inside
        y0, y1 = values[inside], values[inside + 1]
        m0, m1 = slopes[inside] * self.step, slopes[inside + 1] * self.step
        a, b = 2 * y0 - 2 * y1 + m0 + m1, -3 * y0 + 3 * y1 - 2 * m0 - m1
        if order == 0:
            return np.asarray(((a * u + b) * u + m0) * u + y0)
        if order == 1:
            return np.asarray(((3 * a * u + 2 * b) * u + m0) / self.step)
        return np.asarray((6 * a * u + 2 * b) / self.step**2)


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
