"""Derivatives of a table by five points, the effect of rounding on them, and the best distance between nodes.

Enters: equally spaced nodes and values.  Leaves: derivatives at the same nodes.  Used for tables of a crank.
Source: procedure poxdf of [Pasika]; its five formulas are exact for polynomials up to degree four.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from coursework.mechanism.groups.assembly import numbers
from coursework.system.arrays import Array

NODES = 5
# Row i: 12 h times the derivative at the i-th of five neighbours, as a sum over all five.
COEFFICIENTS = (
    (-25, 48, -36, 16, -3),
    (-3, -10, 18, -6, 1),
    (1, -8, 0, 8, -1),
    (-1, 6, -18, 10, 3),
    (3, -16, 36, -48, 25),
)
# Independent errors of size sigma in the table give sigma sqrt(1 + 64 + 64 + 1)/(12 h) at an inner node.
AMPLIFICATION = math.sqrt(130) / 12
# A node displaced by a fraction p of the step changes the derivative by about the same fraction p; nodes computed by a
# program are within 1e-9 of their places, nodes typed with four decimals are not.
SPACING = 1e-6


def derivative(nodes: ArrayLike, values: ArrayLike) -> Array:
    """Return dy/dx (n,) of a table: central formula inside, one-sided ones at the two nodes of each end.

    `nodes` x (n,), ascending and equally spaced; `values` y (n,).
    Raises `ValueError` for fewer than five nodes, nodes that are not ascending or not equally spaced, lengths
    that differ, and entries that are not finite numbers.

    >>> from coursework.procedures import derivative
    >>> derivative([0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 0.25, 1.0, 2.25, 4.0]).round(9).tolist()
    [0.0, 1.0, 2.0, 3.0, 4.0]
    """
    y, h = _table(nodes, values)
    return five_point_derivative(y, h)


def five_point_derivative(values: Array, step: float) -> Array:
    """Return dy/dx (n,) for a table already checked: `values` (n,), n >= 5, at the distance `step` h."""
    slope = np.empty_like(values)
    slope[2:-2] = (values[:-4] - values[4:]) + 8.0 * (values[3:-1] - values[1:-3])
    slope[:2] = np.array(COEFFICIENTS[:2], dtype=np.float64) @ values[:NODES]
    slope[-2:] = np.array(COEFFICIENTS[-2:], dtype=np.float64) @ values[-NODES:]
    return slope / (12.0 * step)


def second_derivative(nodes: ArrayLike, values: ArrayLike) -> Array:
    """Return d2y/dx2 (n,) by applying `derivative` twice; the error is of order h^4, near the ends h^3.

    >>> from coursework.procedures import second_derivative
    >>> second_derivative([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 8.0, 27.0, 64.0]).round(9).tolist()
    [0.0, 6.0, 12.0, 18.0, 24.0]
    """
    return derivative(nodes, derivative(nodes, values))


def rounding_error(digit: float) -> float:
    """Return the standard deviation digit/sqrt(12) of a table rounded to multiples of `digit` (the unit of its values).

    >>> from coursework.procedures import rounding_error
    >>> round(rounding_error(0.0001), 8)
    2.887e-05
    """
    return digit / math.sqrt(12.0)


def noise(sigma: float, spacing: float) -> float:
    """Return the standard deviation sigma sqrt(130)/(12 h) of the derivative at an inner node.

    `sigma` is the standard deviation of the values (unit of y), `spacing` is h (unit of x).

    >>> from coursework.procedures import noise
    >>> round(noise(1e-4, spacing=0.1), 6)
    0.00095
    """
    return AMPLIFICATION * sigma / spacing


def truncation(fifth: float, spacing: float) -> float:
    """Return h^4 |f5|/30, the error of the central formula; `fifth` is the fifth derivative, `spacing` is h.

    >>> from coursework.procedures import truncation
    >>> round(truncation(24.0, spacing=0.1), 9)
    8e-05
    """
    return spacing**4 * abs(fifth) / 30.0


def best_spacing(sigma: float, fifth: float) -> float:
    """Return the spacing h at which truncation and noise together are least: 4 h^3 |f5|/30 = sigma sqrt(130)/(12 h^2).

    There the noise is four times the truncation: a closer table has more noise, a wider one more truncation (hard
    case H24).  `sigma` of the values, `fifth` the size of the fifth derivative.  Raises `ValueError` unless both are
    finite and different from zero.

    A length printed with four decimals, 0.5 + 0.05 sin(2 pi t) m: nodes closer than 0.053 s add more noise than they help.

    >>> import math
    >>> from coursework.procedures import best_spacing, rounding_error
    >>> round(best_spacing(rounding_error(1e-4), 0.05 * (2 * math.pi) ** 5), 3)
    0.053
    """
    if not (math.isfinite(sigma) and sigma > 0.0 and math.isfinite(fifth) and fifth != 0.0):
        raise ValueError(
            "five-point derivative: the best spacing needs an error of the values above zero and a fifth "
            f"derivative other than zero, found {sigma:g} and {fifth:g}."
        )
    return float((7.5 * AMPLIFICATION * sigma / abs(fifth)) ** 0.2)


def _table(nodes: ArrayLike, values: ArrayLike) -> tuple[Array, float]:
    x, y = numbers("five-point derivative, nodes", nodes), numbers("five-point derivative, values", values)
    if len(x) != len(y):
        raise ValueError(f"five-point derivative: {len(x)} nodes but {len(y)} values.")
    if len(x) < NODES:
        raise ValueError(f"five-point derivative: at least {NODES} nodes are needed, found {len(x)}.")
    steps = np.diff(x)
    if (steps <= 0.0).any():
        place = int(np.argmax(steps <= 0.0)) + 1
        raise ValueError(f"five-point derivative: nodes must grow, but node {place} ({x[place]:g}) follows {x[place - 1]:g}.")
    h = float(x[-1] - x[0]) / (len(x) - 1)
    uneven = np.abs(steps - h) > SPACING * h
    if uneven.any():
        place = int(np.argmax(uneven))
        raise ValueError(
            f"five-point derivative: nodes must be equally spaced, but nodes {place} and {place + 1} are "
            f"{steps[place]:.10g} apart where {h:.10g} was expected. Nodes rounded for print will not do."
        )
    return y, h
