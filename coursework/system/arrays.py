"""The array types (floats, flags, complex numbers), and a few functions on arrays that avoid slow imports of NumPy.

Enters: arrays and numbers.  Leaves: types and arrays.
Used by every floor above that computes; the docstring beside a value gives its shape and unit.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Complex = NDArray[np.complex128]


def distinct(*values: NDArray[Any]) -> NDArray[Any]:
    """Return the distinct numbers in ascending order; `np.unique` imports masked arrays, as slow as the checks of a table."""
    ordered = np.sort(np.concatenate(values))
    return ordered[np.diff(ordered, prepend=-np.inf) > 0]


def median(values: NDArray[Any]) -> NDArray[Any]:
    """Return the median of each column, like `np.median`, which would import masked arrays too.

    >>> [float(median(np.array(column))) for column in ([7.0], [7.0, 2.0], [7.0, 2.0, 3.0], [7.0, 2.0, 3.0, 0.0, 4.0, 1.0])]
    [7.0, 4.5, 3.0, 2.5]
    """
    ordered, rows = np.sort(values, axis=0), len(values)
    return np.asarray((ordered[(rows - 1) // 2] + ordered[rows // 2]) / 2)


def as_columns(values: Sequence[Any], shape: tuple[int, ...]) -> Array:
    """Return one array (*shape, k) whose columns are the k `values`: numbers, or arrays of that shape."""
    columns = np.empty((*shape, len(values)))
    for place, value in enumerate(values):
        columns[..., place] = value
    return columns


def cross(one: Array, other: Array) -> Array:
    """Return the cross products (…) of vectors (…, 2): positive where the other one lies anticlockwise of the first."""
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])


def neighbours(flags: Flags) -> Flags:
    """Return for each row of `flags` (n, …) whether both adjacent rows are set; beyond the first and last row counts as set.

    >>> neighbours(np.array([True, False, True, True]))
    array([False,  True, False,  True])
    """
    edge = np.ones_like(flags[:1])
    return np.asarray(np.concatenate([edge, flags[:-1]]) & np.concatenate([flags[1:], edge]))


def shifted(rows: Array, by: int) -> Array:
    """Return the rows moved down by `by` rows (up if negative); rows without a source are NaN."""
    moved = np.full_like(rows, np.nan)
    if by >= 0:
        moved[by:] = rows[: len(rows) - by]
    else:
        moved[:by] = rows[-by:]
    return moved
