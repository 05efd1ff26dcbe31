"""Polylines as the shortest SVG path: relative steps, each number with only the digits it needs.

Enters: points in mm.  Leaves: the d of a path.  Used by `sheet.py` and by the graphs of `report/`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache

import numpy as np

from coursework.system.arrays import Array


def way(at: Sequence[Array], move: str = "l", between: str = "", decimals: int = 2) -> str:
    """Return path data of steps from point to point, x and y in mm; if given, `between` stands before each step.

    Positions are rounded, not steps, so that rounding errors do not add up along a line.

    >>> way([np.array([13.5, 13.84, 14.18]), np.array([22.674, 22.36, 22.36])])
    'M13.5 22.67l.34-.31 .34 0'
    """
    x, y = np.rint(10**decimals * np.stack(at)).astype(int)
    steps = zip(np.diff(x).tolist(), np.diff(y).tolist(), strict=True)
    told = ["".join(_behind(number, decimals) for number in step) for step in steps]
    begin = f"M{numbers_of((int(x[0]), int(y[0])), decimals)}"
    if between:
        return begin + "".join(f"{between}{move}{step.lstrip()}" for step in told)
    return begin + (move + "".join(told).lstrip() if told else "")


def numbers_of(numbers: Iterable[int], decimals: int = 2) -> str:
    """Return whole numbers of hundredths (or of smaller parts, by `decimals`) as text, one after the other."""
    return "".join(_behind(number, decimals) for number in numbers).lstrip()


@lru_cache(maxsize=2048)
def _behind(number: int, decimals: int) -> str:
    """Return a number as it follows another one, as short as SVG can read it: " .34", "-.3"."""
    text = f"{abs(number) / 10**decimals:.{decimals}f}".rstrip("0").rstrip(".")
    return ("-" if number < 0 else " ") + (text.removeprefix("0") or "0")
