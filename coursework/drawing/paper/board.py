"""What is to be drawn -> a scale from round numbers, and a sheet that just holds it.

Enters: circles that a drawing needs at a scale.  Leaves: `Board`.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

import bisect
from collections.abc import Callable, Iterable

from coursework.drawing.paper.cover import Rectangle
from coursework.drawing.paper.sheet import Sheet
from coursework.drawing.paper.symbols import ratio
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence

EDGE = 2.0  # mm
COLUMN = 170.0  # mm: the text of an A4 page with margins of 20 mm
# Denominators that are easily read with a ruler; a construction uses the scales of the drawing standards instead.
_ROUND = [m * 10.0**k for k in range(12) for m in (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)]
SCALES = tuple(sorted({*_ROUND, *(1 / m for m in _ROUND if m < 1e8)}))  # for an enlargement the other number is round
_SPEEDS = tuple(sorted(m * 10.0**k for k in range(-12, 12) for m in (1.0, 2.0, 5.0)))

Circle = tuple[complex, float]  # a place (mm, y down) and the radius of the room around it


@frozen
class Board:
    """A sheet of `width` by `height` mm; `scale` is 10 for 1:10; `origin` is where the point (0, 0) lies on the sheet."""

    scale: float
    width: float
    height: float
    origin: complex

    @property
    def mm(self) -> float:
        """Return how many mm on paper stand for 1 m."""
        return 1000 / self.scale

    @property
    def scale_text(self) -> Sentence:
        """Return "1:10", or "5:1" for an enlargement."""
        return ratio(self.scale)

    def put(self, z: complex) -> complex:
        """Return the place on the sheet (mm, y down) of a point (complex, m)."""
        return self.origin + (z * self.mm).conjugate()

    def sheet(self) -> Sheet:
        """Return the empty sheet."""
        return Sheet(self.width, self.height, (EDGE, EDGE, self.width - EDGE, self.height - EDGE))


def fit(room: Callable[[float], Iterable[Circle]], highest: float, narrowest: float = 100.0) -> Board:
    """Return the board with the largest scale at which everything fits within a column and `highest` mm.

    `room(mm)` gives the circles that the drawing needs at `mm` mm per metre.
    """
    scale = largest_scale(room, COLUMN - 2 * EDGE, highest - 2 * EDGE)
    left, top, right, bottom = around(room(1000 / scale))
    width = max(narrowest, right - left + 2 * EDGE)
    return Board(scale, width, bottom - top + 2 * EDGE, complex((width - right - left) / 2, EDGE - top))


def largest_scale(room: Callable[[float], Iterable[Circle]], wide: float, high: float) -> float:
    """Return the largest scale at which everything fits within `wide` by `high` mm; `room` is that of `fit`."""

    def holds(scale: float) -> bool:
        left, top, right, bottom = around(room(1000 / scale))
        return right - left <= wide and bottom - top <= high

    # At a smaller scale everything takes less room, so a bisection finds it.
    return SCALES[min(bisect.bisect_left(SCALES, True, key=holds), len(SCALES) - 1)]


def vector_scale(longest: float, room: float) -> float:
    """Return units per mm of vectors: the smallest of 1, 2, 5 · 10^k at which the longest is at most `room` mm."""
    return next((scale for scale in _SPEEDS if longest / scale <= room * (1 + 1e-12)), _SPEEDS[-1])


def around(circles: Iterable[Circle]) -> Rectangle:
    """Return left, top, right, bottom of the rectangle around circles; a point if there are none."""
    listed = list(circles) or [(0j, 0.0)]
    return (
        min(at.real - r for at, r in listed), min(at.imag - r for at, r in listed),
        max(at.real + r for at, r in listed), max(at.imag + r for at, r in listed),
    )  # fmt: skip
