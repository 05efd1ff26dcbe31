"""Vectors of the plane as complex numbers: e(f) = exp(i f), and n(f) = i e(f) is e turned by a quarter turn.

Enters: rows of x, y.  Leaves: one complex number per row, and back.  Used inside `groups` only: one multiplication
then replaces two lines of the textbook, and a 2x2 matrix is two vectors, its columns.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from coursework.system.arrays import Array

Vectors: TypeAlias = NDArray[np.complex128]


def vectors(rows: Array) -> Vectors:
    """Return x + i y, (n,), of rows (n, 2) or (2,)."""
    return np.ascontiguousarray(rows).view(np.complex128).reshape(-1)


def rows_of(z: Vectors, n: int) -> Array:
    """Return rows (n, 2) of the vectors `z`, (n,) or (1,)."""
    whole = np.ascontiguousarray(z if len(z) == n else np.broadcast_to(z, (n,)))
    return whole.view(np.float64).reshape(n, 2)


def direction(angle: Array) -> Vectors:
    """Return e(angle); `angle` in rad."""
    e = np.empty(angle.shape, dtype=np.complex128)
    np.cos(angle, out=e.real)
    np.sin(angle, out=e.imag)
    return e


def angle_of(z: Vectors) -> Array:
    """Return the angle of `z` in (-pi, pi], rad; adding 0.0 removes a negative zero, which would turn pi into -pi."""
    return np.asarray(np.arctan2(z.imag + 0.0, z.real))


def dot(p: Vectors, q: Vectors) -> Array:
    """Return p.q."""
    return np.asarray(p.real * q.real + p.imag * q.imag)


def cross(p: Vectors, q: Vectors) -> Array:
    """Return p x q, positive with q to the left of p; the determinant of the matrix with columns p, q."""
    return np.asarray(p.real * q.imag - p.imag * q.real)
