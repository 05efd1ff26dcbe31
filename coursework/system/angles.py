"""Whole turns in an angle: what two angles of the same position may differ by.

Enters: differences of angles (rad).  Leaves: whole turns (rad).  Used by every floor above that compares angles.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from coursework.system.arrays import Array


def whole_turns(differences: ArrayLike) -> Array:
    """Return the whole turns (rad) in each difference of two angles.

    >>> whole_turns([6.3, -0.2, -12.6]).round(3).tolist()
    [6.283, -0.0, -12.566]
    """
    return np.asarray(2 * np.pi * np.round(np.asarray(differences) / (2 * np.pi)))
