"""Graphs with logarithmic axes as SVG in mm: decades, marks that stay apart without colour, dashes.

Enters: positive numbers and escaped words.  Leaves: pieces of SVG, the same bytes in every process.
Used by `accuracy_figures.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from coursework.drawing.paper.ways import way
from coursework.report.graphs.graph_paper import APART, INK, LETTERS, TICK, words
from coursework.report.text.numbers import superscript
from coursework.system.frozen import frozen

RISE = 0.36  # parts of the height of letters, from their middle to their baseline
MOST_TICKS = 8  # of one axis
FEWEST_DECADES = 2  # an axis with fewer also has ticks at 2 and 5 times the powers of ten
GRID = "#d0d0d0"
RADIUS = 0.75  # mm of a mark
Points = Sequence[tuple[float, float]]

# Corners of the marks in radii; a circle has none.
_CROSS = ((-0.4, -1), (0.4, -1), (0.4, -0.4), (1, -0.4), (1, 0.4), (0.4, 0.4), (0.4, 1), (-0.4, 1), (-0.4, 0.4), (-1, 0.4),
          (-1, -0.4), (-0.4, -0.4))  # fmt: skip
_TURNED = tuple(((x - y) * 0.75, (x + y) * 0.75) for x, y in _CROSS)
_STAR = tuple(
    (math.sin(k * math.pi / 5) * (1.25, 0.55)[k % 2], -math.cos(k * math.pi / 5) * (1.25, 0.55)[k % 2]) for k in range(10)
)
MARKS: dict[str, Points] = {
    "circle": (), "square": ((-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)), "up": ((0, -1), (1, 0.9), (-1, 0.9)),
    "diamond": ((0, -1.2), (1.2, 0), (0, 1.2), (-1.2, 0)), "down": ((0, 1), (1, -0.9), (-1, -0.9)), "plus": _CROSS,
    "cross": _TURNED, "star": _STAR, "left": ((-1, 0), (0.9, -1), (0.9, 1)), "right": ((1, 0), (-0.9, -1), (-0.9, 1)),
}  # fmt: skip


@frozen
class Scale:
    """One axis: the values from 10^`low` to 10^`high` lie between `begin` and `end` (mm)."""

    begin: float
    end: float
    low: float
    high: float

    def at(self, value: float) -> float:
        """Return the place of a value in mm; a value that is too small for the axis lies at `begin`."""
        power = math.log10(value) if value > 0 else self.low
        return self.begin + (max(power, self.low) - self.low) / (self.high - self.low) * (self.end - self.begin)

    def ticks(self) -> list[tuple[float, str]]:
        """Return the places (mm) of round values inside the axis with their words: "10⁻³", on a short axis also "2·10⁻³"."""
        first, last = math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9)
        if last - first + 1 >= FEWEST_DECADES:
            pace = -(-(last - first + 1) // MOST_TICKS)
            shown = [(1, k) for k in range(first, last + 1) if k % pace == 0]
        else:
            between = ((n, k) for k in range(first - 1, last + 1) for n in (1, 2, 5))
            shown = [(n, k) for n, k in between if self.low <= math.log10(n * 10.0**k) <= self.high]
        return [(round(self.at(n * 10.0**k), 2), _power(n, k)) for n, k in shown]


def scale_for(values: Iterable[float], begin: float, end: float, room: tuple[float, float]) -> Scale:
    """Return the axis that contains all values, with `room` before and after them in parts of their range."""
    powers = [math.log10(value) for value in values if value > 0] or [0.0]
    low, high = min(powers), max(powers)
    wide = max(high - low, 0.5)
    return Scale(begin, end, low - room[0] * wide, high + room[1] * wide)


def _power(times: int, exponent: int) -> str:
    return f"{times}·10{superscript(str(exponent))}" if times > 1 else f"10{superscript(str(exponent))}"


def across(x: Scale, bottom: float, top: float, label: str) -> str:
    """Return the horizontal axis at height `bottom` (mm), its grid up to `top`, its ticks, and `label` below it."""
    ticks = x.ticks()
    grid = "".join(f"M{at:g} {bottom:g}V{top:g}" for at, _ in ticks)
    axis = f"M{x.begin:g} {bottom:g}H{x.end:g}" + "".join(f"M{at:g} {bottom:g}v{TICK}" for at, _ in ticks)
    told = [words(at, bottom + TICK + 3.0, text, "middle") for at, text in ticks]
    return _lines(grid, axis) + "".join(told) + words((x.begin + x.end) / 2, bottom + TICK + 7.4, label, "middle")


def upward(y: Scale, left: float, right: float, label: str) -> str:
    """Return the vertical axis at `left` (mm), its grid up to `right`, its ticks, and `label` above it."""
    ticks = y.ticks()
    grid = "".join(f"M{left:g} {at:g}H{right:g}" for at, _ in ticks)
    axis = f"M{left:g} {y.begin:g}V{y.end:g}" + "".join(f"M{left:g} {at:g}h{-TICK}" for at, _ in ticks)
    told = [words(left - TICK - APART, at + RISE * LETTERS, text, "end") for at, text in ticks]
    return _lines(grid, axis) + "".join(told) + words(left + 1.2, y.end - 1.6, label)


def _lines(grid: str, axis: str) -> str:
    return f'<path stroke="{GRID}" stroke-width="0.1" d="{grid}"/><path stroke="{INK}" stroke-width="0.2" d="{axis}"/>'


def way_of(points: Points) -> str:
    """Return the path data (`d`) of a line through points (mm)."""
    return way(list(np.array(points).T))


def marks(points: Points, mark: str, ink: str) -> str:
    """Return a mark, white inside, at each point (mm)."""
    r, corners = RADIUS, MARKS[mark]
    if corners:
        left, above = corners[0]
        steps = way(list(r * np.array([(0, 0), *np.subtract(corners[1:], corners[0])]).T)).removeprefix("M0 0")
    else:
        left, above, steps = -1.0, 0.0, f"a{r} {r} 0 1 0 {2 * r:g} 0 {r} {r} 0 1 0{-2 * r:g} 0"
    path = "".join(f"M{round(x + r * left, 2):g} {round(y + r * above, 2):g}{steps}z" for x, y in points)
    return f'<path fill="#fff" stroke="{ink}" stroke-width="0.3" d="{path}"/>'
