"""By how much printed digits leave a function of cells open.

Enters: a function over rows, the rows, their digits.  Leaves: sums of slopes times digits.
Used by `ways.py`, `claims.py`, `own_equations.py` and `by_rows.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coursework.system.arrays import Array

_DIFFERENCE = 1e-6


def sensitivity(function: Callable[[Array], Array], at: Array, units: Array) -> Array:
    """Return sum over j of |d function / d x_j| u_j, (n, k), for rows `at` (n, m) with digits `units` (n, m), all at once."""
    rows, width = at.shape
    size = _DIFFERENCE * np.maximum(1.0, np.abs(at))
    shifted = np.broadcast_to(at, (2 * width, rows, width)).copy()
    places = np.arange(width)
    shifted[places, :, places] += size.T
    shifted[width + places, :, places] -= size.T
    found = function(shifted.reshape(-1, width)).reshape(2, width, rows, -1)
    slopes = np.abs(found[0] - found[1]) / (2 * size.T[:, :, None])
    # What does not depend on a missing cell has slope zero there; where it does depend, the value itself is missing.
    slopes = np.where(np.isnan(slopes), 0.0, slopes) * np.where(np.isnan(units), 0.0, units).T[:, :, None]
    return np.asarray(slopes.sum(axis=0))
