"""How uncertain a function of printed cells is because of their rounding.

Enters: a function over rows, the rows, the units of their last places.  Leaves: its values, sums of slopes times units.
Used by `ways.py`, `claims.py`, `own_equations.py` and `by_rows.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.system.arrays import Array

_DIFFERENCE = 1e-6


def with_spread(function: Callable[[Array], Array], at: Array, units: Array) -> tuple[Array, Array]:
    """Return a function's values (n, k) at rows `at` (n, m) with `units` u (n, m) of the last places, and how uncertain they are.

    That is the sum (n, k) over j of |d function / d x_j| u_j. The function is called once, with all rows that this takes.
    """
    rows, width = at.shape
    size = _DIFFERENCE * np.maximum(1.0, np.abs(at))
    shifted = np.empty((1 + 2 * width, rows, width))
    shifted[:] = at
    places = np.arange(width)
    shifted[1 + places, :, places] += size.T
    shifted[1 + width + places, :, places] -= size.T
    found = function(shifted.reshape(-1, width)).reshape(1 + 2 * width, rows, -1)
    slopes = np.abs(found[1 : 1 + width] - found[1 + width :]) / (2 * size.T[:, :, None])
    # A function that does not depend on a missing cell has slope zero there; if it does depend on it, its own value is missing.
    slopes = np.where(np.isnan(slopes), 0.0, slopes) * np.where(np.isnan(units), 0.0, units).T[:, :, None]
    return found[0], np.asarray(slopes.sum(axis=0))
