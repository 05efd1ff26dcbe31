"""The types of arrays: floating numbers, and flags.

Enters: nothing.  Leaves: types.  Used by every floor above that computes; a docstring beside a value says shape and unit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Complex = NDArray[np.complex128]
