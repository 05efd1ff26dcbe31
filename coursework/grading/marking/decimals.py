"""How many decimals a table needs before its digits show by which scheme and step it was made.

Enters: the one-step gap of Euler's table.  Leaves: decimals asked for on a task sheet, and accepted in a class.
Used by `key.py` and `assigning/`.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.system.arrays import Array

# A table that Euler makes without error shows no gap; its digits are then judged by this part of its largest range.
SMALLEST_GAP = 1e-3
NO_GAP = 1e-9
# Digits that decide: a cell counts as shown up to this part of the gap; the task sheet asks for a fifth of it.
SHOWN, ASKED = 0.6, 5.0
# One number of decimals holds for a class; the gap of a student's own data may be so much smaller than the template's.
SHARED = 2.0
SOLVED = 2  # decimals of a start that the geometry gives, beyond those that the table needs, on a task sheet


def gap_of(slopes: Array, ahead: Array, step: float, ranges: Array) -> Array:
    """Return the one-step gap (…) from rates (…, n, m) in the rows and after a step of Euler; `ranges` (…, m) of coordinates.

    Where nothing but round-off lies between, it is a thousandth of the largest range.

    >>> still = np.zeros((1, 2, 1))
    >>> [gap_of(still, still + ahead, 2.0, np.array([[10.0]])).tolist() for ahead in (2e-8, 5e-9)]
    [[2e-08], [0.01]]
    """
    gaps = np.abs(step / 2 * (ahead - slopes))
    largest = np.nanmax(gaps, axis=(-2, -1), initial=0.0)
    span = np.max(ranges, axis=-1, initial=0.0)
    span = np.where(span > 0, span, 1.0)
    return np.where(largest > NO_GAP * span, largest, SMALLEST_GAP * span)


def decimals_asked(gap: float) -> int:
    """Return how many decimals a task sheet asks for where the one-step gap is this."""
    return max(1, math.ceil(math.log10(ASKED / gap)))


def decimals_accepted(gap: float) -> int:
    """Return with how many decimals, at the least, a table is still marked where the one-step gap is this.

    >>> decimals_asked(0.0199), decimals_accepted(0.0199)
    (3, 2)
    """
    return max(0, math.ceil(-math.log10(SHOWN * gap)))
