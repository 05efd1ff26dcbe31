"""What functions of rows gave for the same rows: the causes of a wrong table are all tried at its rows, and at those beside them.

Enters: functions of arrays, arrays.  Leaves: arrays of the caller's own.  Used by `key.py`, `ways.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from coursework.scene.model.data import Data
from coursework.system.arrays import Array

Asked = tuple[tuple[int, ...], bytes]
# So many results are kept in a process, each of at most so many numbers: some megabytes.
_KEPT, FEW_NUMBERS = 768, 1024


def kept(function: Callable[..., Array], data: Data, *rows: Array) -> Array:
    """Return `function(*rows, data=data)`, computed anew only if none of the last results was for these arrays."""
    if rows[-1].size > FEW_NUMBERS:
        return function(*rows, data=data)
    return _found(function, data, *((one.shape, np.asarray(one, dtype=float).tobytes()) for one in rows)).copy()


@lru_cache(_KEPT)
def _found(function: Callable[..., Array], data: Data, *rows: Asked) -> Array:
    return function(*(np.frombuffer(numbers).reshape(shape) for shape, numbers in rows), data=data)
