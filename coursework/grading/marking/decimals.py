"""How many decimals a table needs so that its digits show by which scheme and step it was made.

Enters: the one-step gap of Euler's table.  Leaves: the decimals that a task sheet asks for, and those accepted from a class.
Used by `key.py` and `assigning/`.
"""

from __future__ import annotations

import math

import numpy as np

from coursework.system.arrays import Array

# If Euler makes a table without error, there is no gap; this part of the largest range of a coordinate then stands in for it.
SMALLEST_GAP = 1e-3
NO_GAP = 1e-9
# A cell counts as shown if the unit of its last place is at most SHOWN times the gap; the task sheet asks for gap / ASKED.
SHOWN, ASKED = 0.6, 5.0
# A class shares one number of decimals; the gap of a student's own data may be smaller than the template's by up to this factor.
SHARED = 2.0
SOLVED = 2  # on a task sheet, starts that follow from the geometry get so many decimals more than the table needs


def gap_of(slopes: Array, ahead: Array, step: float, ranges: Array) -> Array:
    """Return the one-step gap (…) from the rates (…, n, m) in the rows (`slopes`) and one Euler step later (`ahead`).

    If the two differ by round-off only, return a thousandth of the largest of the coordinates' `ranges` (…, m).

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
    """Return how many decimals a task sheet asks for, from the one-step gap."""
    return max(1, math.ceil(math.log10(ASKED / gap)))


def decimals_accepted(gap: float) -> int:
    """Return the least number of decimals with which a table is still marked, from the one-step gap.

    >>> decimals_asked(0.0199), decimals_accepted(0.0199)
    (3, 2)
    """
    return max(0, math.ceil(-math.log10(SHOWN * gap)))
