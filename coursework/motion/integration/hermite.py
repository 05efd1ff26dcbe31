"""The cubic through both ends of an interval with given slopes there.

Enters: end values, and end slopes times the length of the interval.  Leaves: values between.
Used by `finer.py`, `continuity.py`, `peaks.py`, `unseen_loads.py` and `graph_paper.py`.
"""

from __future__ import annotations

from coursework.system.arrays import Array


def hermite(begin: Array, end: Array, out: Array, into: Array, part: Array) -> Array:
    """Return the values at a `part` of the interval, from 0 at its start to 1 at its end; the shapes must broadcast.

    `out` and `into` are the slopes at `begin` and `end` times the length of the interval.

    >>> hermite(1.0, 8.0, 3.0, 12.0, 0.25) == 1.25**3
    True
    """
    rest = 1 - part
    return begin * (1 + 2 * part) * rest**2 + out * part * rest**2 + end * part**2 * (3 - 2 * part) - into * part**2 * rest
