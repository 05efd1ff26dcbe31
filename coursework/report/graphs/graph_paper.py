"""Small graphs as SVG in mm: axes with round ticks, curves, dots, words; the same bytes in every process.

Enters: numbers and symbols.  Leaves: SVG text of a few kilobytes; the curve of a motion between its rows.
Used by `graphs.py` and `tangent.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.drawing.paper.sheet import FONT
from coursework.drawing.paper.ways import numbers_of, way
from coursework.motion.integration.hermite import hermite
from coursework.report.text.numbers import Numbers
from coursework.report.text.symbols import Symbol
from coursework.system.arrays import Array, distinct
from coursework.system.frozen import frozen
from coursework.words.html_table import escaped

if TYPE_CHECKING:
    from coursework.report.text.page_context import PageContext

LETTERS = 3.18  # mm: 9 points on paper, 12 pixels where a screen shows a graph at its size
LEFT, RIGHT, TOP, BOTTOM = 13.5, 3.0, 6.0, 7.0  # mm around the field; longer words at the ticks take more at the left
DIGIT = 0.68  # parts of the height of letters: width of the widest digit or sign
TICK, APART = 0.9, 0.6  # mm: length of a tick, and room between it and its words
PLAIN = Numbers()
MOST_DECIMALS, LARGEST = 5, 1e6  # limits of a number at a tick; beyond them powers of ten are written
TIME_ROOM = 6.0  # mm at the end of the axis of t, for its name
MOST_TICKS = 5  # on the axis of values; a low field has fewer, so that each has room for its words
ROOM = 0.07  # parts of the range of values, left free above and below
RADIUS = 0.62  # mm of a dot
MOST_DOTS = 30
MOST_POINTS = 2000  # of one curve; finer than any printer at this width
BETWEEN = 8  # points of a smooth curve per row
# Weights of a cubic's four control points at BETWEEN + 1 points of it and midway between; weights of these points in its handles.
_PART = np.arange(2 * BETWEEN + 1)[:, None] / (2 * BETWEEN)
_BERNSTEIN = np.hstack([(1 - _PART) ** 3, 3 * _PART * (1 - _PART) ** 2, 3 * _PART**2 * (1 - _PART), _PART**3])
_ENDS = np.zeros((BETWEEN + 1, BETWEEN + 1))
_ENDS[:, [0, -1]] = _BERNSTEIN[::2, [0, 3]]
_HANDLES = np.linalg.pinv(_BERNSTEIN[::2, 1:3]) @ (np.eye(BETWEEN + 1) - _ENDS)
BESIDE_CURVE = 0.004  # mm that a cubic may be off its points: less than a screen or a printer shows
ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)
INK, SCHEME_INK, FAINT = "#111", "#0072b2", "#bbb"
EXACT_PEN = f'class="exact" fill="none" stroke="{INK}" stroke-width="0.42" stroke-linejoin="round"'
SCHEME_PEN = f'class="rows" fill="none" stroke="{SCHEME_INK}" stroke-width="0.25"'
DOT_PEN = f'class="dots" stroke="{SCHEME_INK}" stroke-width="{2 * RADIUS:g}" stroke-linecap="round"'
STOP_INK = "#b4460f"
STOP_PEN = f'class="stop" stroke="{STOP_INK}" stroke-width="0.4" stroke-dasharray="1.8 1.2"'
STOP_WORDS = f' fill="{STOP_INK}"'


@frozen
class Field:
    """The field of a graph: its size in mm and the ranges of t (s) and of the values that it shows."""

    width: float
    height: float
    first: float
    last: float
    low: float
    high: float
    left: float = LEFT

    def x(self, t: Any) -> Any:
        """Return the distance of a time from the left edge in mm."""
        return self.left + (t - self.first) / (self.last - self.first) * (self.width - self.left - RIGHT)

    def y(self, value: Any) -> Any:
        """Return the distance of a value from the upper edge in mm."""
        return self.height - BOTTOM - (value - self.low) / (self.high - self.low) * (self.height - TOP - BOTTOM)

    def path(self, t: Array, values: Array) -> str:
        """Return the path data (`d`) of a line through points; a value that is not finite interrupts it."""
        known = np.flatnonzero(np.isfinite(values))
        lines = np.split(known, np.flatnonzero(np.diff(known) > 1) + 1)
        return "".join(way([self.x(t[line]), self.y(values[line])]) for line in lines if len(line))

    def curve(self, t: Array, values: Array) -> str:
        """Return the path data (`d`) of a smooth line; one cubic replaces `BETWEEN` steps wherever it fits their points."""
        if len(t) % BETWEEN != 1 or not np.isfinite(values).all():
            return self.path(t, values)
        points = np.column_stack([self.x(t), self.y(values)])
        pieces = points[np.arange(0, len(t) - 1, BETWEEN)[:, None] + np.arange(BETWEEN + 1)]
        handles = np.einsum("hp,npx->nhx", _HANDLES, pieces)
        ends = np.concatenate([pieces[:, :1], handles, pieces[:, -1:]], axis=1)
        steps = np.einsum("ph,nhx->npx", _BERNSTEIN, ends)
        steps[:, ::2] -= pieces
        steps[:, 1::2] -= (pieces[:, 1:] + pieces[:, :-1]) / 2
        off = np.abs(steps).max(axis=(1, 2))
        at = np.rint(100 * points[0]).astype(int)
        drawn = way([points[:1, 0], points[:1, 1]])
        last = None  # from the last handle of the previous cubic to its end; a cubic that goes on equally needs no first handle
        for piece, corners, is_line in zip(pieces, ends, off > BESIDE_CURVE, strict=True):
            steps = np.rint(100 * (piece if is_line else corners)[1:]).astype(int)
            told = np.diff(np.vstack([at, steps]), axis=0) if is_line else steps - at
            goes_on = last is not None and bool((told[0] == last).all())
            command, told = ("l", told) if is_line else ("s", told[1:]) if goes_on else ("c", told)
            last = None if is_line else told[-1] - told[-2]
            drawn += command + numbers_of(told.ravel().tolist())
            at = steps[-1]
        return drawn


def field_for(size: tuple[float, float], t: Sequence[Array], values: Sequence[Array], numbers_as: Numbers = PLAIN) -> Field:
    """Return the field that contains all values, with room for tick words at its left; a constant gets room around it."""
    times, numbers = np.concatenate(t), np.concatenate(values)
    numbers = numbers[np.isfinite(numbers)]
    low, high = (float(numbers.min()), float(numbers.max())) if len(numbers) else (0.0, 1.0)
    room = ROOM * (high - low)
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        room = 0.5 * max(abs(low), abs(high)) or 1.0
    first, last = float(times.min()), float(times.max())
    low, high = low - room, high + room
    longest = max((len(text) for _, text in ticks(low, high, _most_ticks(size[1]), numbers_as)), default=0)
    left = max(LEFT, TICK + APART + DIGIT * LETTERS * longest)
    return Field(*size, first, last if last > first else first + 1.0, low, high, left)


def _most_ticks(height: float) -> int:
    """Return how many words fit one above the other beside the field of a graph `height` mm high."""
    return max(1, min(MOST_TICKS, int((height - TOP - BOTTOM) / LETTERS)))


def smooth(t: Array, values: Array, rates: Array, between: int = BETWEEN) -> tuple[Array, Array]:
    """Return times and values of a curve, by cubic Hermite from `values` and `rates` with `between` points per row.

    Many rows get fewer points; very many rows, or rates that are not finite, give the rows themselves, thinned.
    """
    if len(t) < 2 or not np.isfinite(rates).all() or len(t) >= MOST_POINTS:
        return sparse(t), sparse(values)
    between = max(1, min(between, MOST_POINTS // (len(t) - 1)))
    s = np.arange(between) / between
    h = np.diff(t)[:, None]
    cubic = hermite(values[:-1, None], values[1:, None], h * rates[:-1, None], h * rates[1:, None], s)
    times = t[:-1, None] + h * s
    return np.append(times.ravel(), t[-1]), np.append(cubic.ravel(), values[-1])


def sparse(values: Array, most: int = MOST_POINTS) -> Array:
    """Return every k-th of the values, about `most` at most, and the last one."""
    pace = max(1, -(-len(values) // most))
    return values[distinct(np.arange(0, len(values), pace), np.array([len(values) - 1]))] if len(values) else values


def round_ticks(low: float, high: float, most: int) -> tuple[list[float], int]:
    """Return at most `most` round numbers inside a range, and the decimals they need."""
    least = (high - low) / most
    power = 10.0 ** math.floor(math.log10(least))
    pace = next(r * power for r in ROUND if r * power >= least * (1 - 1e-9))
    first = math.ceil(low / pace - 1e-9)
    ticks = [k * pace for k in range(first, math.floor(high / pace + 1e-9) + 1)]
    whole = math.floor(math.log10(pace) + 1e-9)
    halved = abs(pace / 10.0**whole - 2.5) < 1e-6
    return ticks, max(halved - whole, 0)


def tick_texts(ticks: Iterable[float], decimals: int, numbers: Numbers) -> list[str]:
    """Return the words at the ticks, as powers of ten if decimal numbers would be too long."""
    values = list(ticks)
    largest = max((abs(value) for value in values), default=0.0)
    if decimals > MOST_DECIMALS or largest >= LARGEST:
        digits = 1 + max(
            0, math.ceil(math.log10(largest / min(abs(b - a) for a, b in pairwise(values)) if len(values) > 1 else 1))
        )
        return [numbers.power(value, digits) if value else "0" for value in values]
    return [numbers.fixed(value, decimals) if abs(value) > 1e-12 else "0" for value in values]


def ticks(low: float, high: float, most: int, numbers: Numbers) -> list[tuple[float, str]]:
    """Return at most `most` round numbers inside a range, each with its words."""
    values, decimals = round_ticks(low, high, most)
    return list(zip(values, tick_texts(values, decimals, numbers), strict=True))


def dots(field: Field, t: Array, values: Array) -> str:
    """Return the path data (`d`) of dots, lines of no length, at all rows, or at about `MOST_DOTS` of many rows."""
    t, values = sparse(t, MOST_DOTS), sparse(values, MOST_DOTS)
    known = np.isfinite(values)
    return way([field.x(t[known]), field.y(values[known])], "m", "h0") + "h0" if known.any() else ""


def letters(symbol: Symbol) -> str:
    """Return a symbol as the inside of an SVG text, its subscript lowered."""
    slant = "" if symbol.is_word else ' font-style="italic"'
    head = f"<tspan{slant}>{escaped(symbol.head)}</tspan>"
    if not symbol.subscript:
        return head
    upright = symbol.subscript.isdigit()
    low = f'<tspan dy="0.75" font-size="2.3"{"" if upright else slant}>{escaped(symbol.subscript)}</tspan>'
    return f'{head}{low}<tspan dy="-0.75">\u200a</tspan>'


def words(x: float, y: float, inside: str, anchor: str = "start", more: str = "") -> str:
    """Return an SVG text; `inside` must already be escaped."""
    anchored = f' text-anchor="{anchor}"' if anchor != "start" else ""
    return f'<text x="{round(x, 2):g}" y="{round(y, 2):g}"{anchored}{more}>{inside}</text>'


def axes(field: Field, numbers: Numbers, label: str, time: str) -> str:
    """Return frame, ticks, zero line and words of a graph; `label` stands above, `time` at the end of the time axis."""
    left, right, top, bottom = field.left, field.width - RIGHT, TOP, field.height - BOTTOM
    frame, parts = f"M{left:g} {top:g}V{bottom:g}H{right:g}", []
    beside, below = [], []
    if field.low < 0 < field.high:
        parts.append(f'<path class="zero" stroke="{FAINT}" stroke-width="0.15" d="M{left:g} {field.y(0):.2f}H{right:g}"/>')
    for value, text in ticks(field.low, field.high, _most_ticks(field.height), numbers):
        y = field.y(value)
        frame += f"M{left:g} {round(y, 2):g}h{-TICK}"
        beside.append(words(left - TICK - APART, y + 1.0, text))
    for value, text in ticks(field.first, field.last, 6, numbers):
        x = field.x(value)
        frame += f"M{round(x, 2):g} {bottom:g}v{TICK}"
        if x + 0.95 * len(text) <= right - TIME_ROOM:
            below.append(words(x, bottom + TICK + 3.0, text))
    beside.append(words(right, bottom + TICK + 3.0, time))
    parts += [f'<g text-anchor="{anchor}">{"".join(told)}</g>' for anchor, told in (("end", beside), ("middle", below))]
    parts.append(words(left + 1.2, TOP - 2.2, label))
    return f'<path class="axis" fill="none" stroke="{INK}" stroke-width="0.2" d="{frame}"/>' + "".join(parts)


def framed(context: PageContext, field: Field, symbol: Symbol, unit: str) -> str:
    """Return the axes of a graph on a page: a symbol with its unit above, t with its unit at the end of the time axis."""
    label = letters(symbol) + escaped(context.words.behind(unit))
    time = letters(context.symbol("t")) + escaped(context.words.behind(context.unit("s")))
    return axes(field, context.numbers, label, time)


def line_of_rows(field: Field, t: Array, values: Array) -> str:
    """Return the rows of a scheme: a line, and dots on it."""
    line = field.path(sparse(t), sparse(values))
    return f'<path {SCHEME_PEN} d="{line}"/><path {DOT_PEN} d="{dots(field, t, values)}"/>'


def lines(field: Field, exact: tuple[Array, Array], rows: tuple[Array, Array] | None) -> str:
    """Return the line of the exact motion, and above it that of the rows with their dots; each only if it is known and shown."""
    below = f'<path {EXACT_PEN} d="{field.curve(*exact)}"/>' if len(exact[0]) else ""
    return below + line_of_rows(field, *rows) if rows is not None and len(rows[0]) else below


def sheet(field: Field, inside: str) -> str:
    """Return the whole SVG of a graph over time; its ranges are attributes that the live part of a page reads."""
    ranges = (
        f' data-time="{field.first:.9g} {field.last:.9g}" data-values="{field.low:.9g} {field.high:.9g}" '
        f'data-box="{field.left:g} {TOP:g} {field.width - RIGHT:g} {field.height - BOTTOM:g}"'
    )
    return picture(field.width, field.height, inside, ranges)


def picture(width: float, height: float, inside: str, more: str = "") -> str:
    """Return a whole SVG; `more` are further attributes of its element."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" viewBox="0 0 {width:g} {height:g}" '
        f'font-family="{FONT}" font-size="{LETTERS}" fill="{INK}"{more}>{inside}</svg>'
    )
