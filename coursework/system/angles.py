"""Angles and vectors of the plane: the whole turns in a difference of two angles, and products of vectors x + iy.

Enters: differences of angles (rad), vectors.  Leaves: whole turns (rad), products.  Used by every floor above.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from coursework.system.arrays import Array


def whole_turns(differences: ArrayLike) -> Array:
    """Return, for each difference of two angles, the multiple of 2π (rad) nearest to it.

    >>> whole_turns([6.3, -0.2, -12.6]).round(3).tolist()
    [6.283, -0.0, -12.566]
    """
    return np.asarray(2 * np.pi * np.round(np.asarray(differences) / (2 * np.pi)))


def dot(a: complex, b: complex) -> float:
    """Return a . b."""
    return (a.conjugate() * b).real


def cross(a: complex, b: complex) -> float:
    """Return the z component of a x b."""
    return (a.conjugate() * b).imag
