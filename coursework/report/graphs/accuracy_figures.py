"""Figures of the accuracy section: error against cost, and bars.

Enters: numbers and labels.  Leaves: SVG text and its height in mm.
Used by `accuracy.py`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from coursework.report.graphs.figures import WIDTH
from coursework.report.graphs.graph_paper import INK, LETTERS, words
from coursework.report.graphs.log_paper import RISE, Points, Scale, across, marks, polyline, scale_for, sheet, upward
from coursework.system.frozen import frozen

# Colours that stay apart for colour-blind readers (Okabe and Ito); dashes (mm) and marks keep them apart in print.
STYLES = (
    ("#0072b2", "", "circle"), ("#d55e00", "1.6 .7", "square"), ("#009e73", "2.7 .7 .4 .7", "up"), ("#000", ".4 .7", "diamond"),
    ("#cc79a7", "2.1 .4 .4 .4 .4 .4", "down"), ("#e69f00", "3.4 .9", "plus"), ("#56b4e9", "1.3 .4", "cross"),
    ("#7b3294", "", "star"), ("#8c510a", "1.6 .7", "left"), ("#000", "2.7 .7 .4 .7", "right"),
)  # fmt: skip
OTHERS = ("own_legend", "end_legend", "floor_legend")  # below the methods

PLOT_HEIGHT = 52.0  # mm of the axes with their labels
LEFT, RIGHT, TOP, BOTTOM = 14.0, 4.0, 6.0, 10.5  # mm around the axes
BETWEEN = 6.0  # mm from one panel to the next
ROOM_X, ROOM_Y = (0.05, 0.09), (0.04, 0.04)  # of the ranges, before and behind what is shown; behind stands a slope
LEGEND_COLUMNS = (3, 2, 1)  # as many as have room for their words
LEGEND_LINE = 4.4  # mm of one line of the legend
LEGEND_LEFT, LEGEND_PEN, LEGEND_GAP = 12.0, 9.0, 1.8  # mm: where it begins, of a sample, between it and its words
LETTER, SIGN = 1.73, 3.02  # mm: of a letter, a little more than the mean, and of a Chinese sign
BAR, PITCH = 4.2, 6.7  # mm: a bar, and from one to the next
BAR_LEFT, BAR_TOP, BAR_ROOM = 51.0, 1.5, (0.1, 0.15)
FILL = "#9ecae1"
NEAR = 3.0  # triangles closer than this factor of cost (its square in error) would overlap, its square in half the width
HALO = ' stroke="#fff" stroke-width="0.7" stroke-linejoin="round" paint-order="stroke"'  # around words that may lie on a line
OWN = f'fill="none" stroke="{INK}" stroke-width="0.46"'
OWN_RADIUS = 1.9  # mm
LAST_ROW = 'stroke-width="0.25" stroke-dasharray="1 .5"'
ROUND_OFF = 'fill="#e6e6e6"'
SMALLEST = 1e-17  # an error of exactly 0 has no place on a logarithmic axis; it is drawn here


@frozen
class Method:
    """One line: evaluations, seconds (None = not shown), largest and last-row error at each setting, its order."""

    name: str
    evaluations: tuple[int, ...]
    seconds: tuple[float | None, ...]
    errors: tuple[float, ...]
    end_errors: tuple[float, ...]
    order: float | None
    order_text: str

    def points(self, *, timed: bool) -> list[tuple[float, float, float]]:
        """Return (cost, largest error, error of the last row), from the cheapest on."""
        costs = self.seconds if timed else self.evaluations
        return sorted(
            (float(cost), _shown(error), _shown(end))
            for cost, error, end in zip(costs, self.errors, self.end_errors, strict=True)
            if cost is not None and math.isfinite(error)
        )


@frozen
class Panels:
    """The whole figure; `own` = (evaluations, seconds, error) of the coursework, `labels` by key of the words file."""

    methods: tuple[Method, ...]
    own: tuple[int, float | None, float] | None
    floor: float
    error_label: str
    labels: dict[str, str]

    @property
    def timed(self) -> bool:
        """Return whether there are running times for a second panel."""
        return any(seconds is not None for method in self.methods for seconds in method.seconds)


@frozen
class Triangle:
    """The slope of a line: from `left` to `right` in cost it falls from `top` to `bottom` in error."""

    left: float
    right: float
    top: float
    bottom: float
    text: str
    ink: str


def _shown(error: float) -> float:
    return max(abs(error), SMALLEST)


def panels(page: Panels) -> tuple[str, float]:
    """Return error against evaluations and, where times are shown, against seconds, sharing the error axis; and mm high."""
    legend = _legend_words(page)
    columns = _columns([text for text, _ in legend])
    height = PLOT_HEIGHT + LEGEND_LINE * max(map(len, columns))
    triangles = _triangles(page)
    errors = [error for method in page.methods for _, *each in method.points(timed=False) for error in each]
    errors = [error for error in errors if math.isfinite(error)]
    errors += [value for one in triangles for value in (one.top, one.bottom)]
    errors += [_shown(page.own[2])] if page.own else []
    errors += [page.floor / 10] if page.floor > 0 else []
    y = scale_for(errors, PLOT_HEIGHT - BOTTOM, TOP, ROOM_Y)
    whole = WIDTH - LEFT - RIGHT
    wide = (whole - BETWEEN) / 2 if page.timed else whole
    inside = _panel(page, _costs(page, triangles, LEFT, LEFT + wide, timed=False), y, triangles, timed=False)
    if page.timed:
        inside += _panel(page, _costs(page, (), WIDTH - RIGHT - wide, WIDTH - RIGHT, timed=True), y, (), timed=True)
    return sheet(WIDTH, height, inside + _legend(legend, columns)), height


def _costs(page: Panels, triangles: Sequence[Triangle], begin: float, end: float, *, timed: bool) -> Scale:
    """Return the axis of the costs."""
    shown = [cost for method in page.methods for cost, _, _ in method.points(timed=timed)]
    own = page.own[1 if timed else 0] if page.own else None
    return scale_for([*shown, *([own] if own else []), *(one.right for one in triangles)], begin, end, ROOM_X)


def _panel(page: Panels, x: Scale, y: Scale, triangles: Sequence[Triangle], *, timed: bool) -> str:
    """Return one panel: the band of round-off, axes, broken lines of the last row, lines with their marks, slopes, ring."""
    low = y.at(page.floor) if page.floor > 0 else y.begin
    inside = f'<path {ROUND_OFF} d="M{x.begin:g} {low:.2f}H{x.end:g}V{y.begin:g}H{x.begin:g}z"/>' if page.floor > 0 else ""
    inside += across(x, y.begin, y.end, escape(page.labels["seconds" if timed else "evaluations"]))
    inside += upward(y, x.begin, x.end, "" if timed else escape(page.error_label))
    lines = [(method.points(timed=timed), *STYLES[index % len(STYLES)]) for index, method in enumerate(page.methods)]
    for points, ink, _, _ in lines:
        ends = [(x.at(cost), y.at(end)) for cost, _, end in points if math.isfinite(end)]
        inside += polyline(ends, f'stroke="{ink}" {LAST_ROW}')
    for points, ink, dashes, mark in lines:
        if points:
            places = [(x.at(cost), y.at(error)) for cost, error, _ in points]
            inside += polyline(places, _pen(ink, dashes)) + marks(places, mark, ink)
    for one in triangles:
        left, right, top, bottom = x.at(one.left), x.at(one.right), y.at(one.top), y.at(one.bottom)
        inside += (
            f'<path fill="none" stroke="{one.ink}" stroke-width="0.28" d="M{left:.2f} {top:.2f}H{right:.2f}V{bottom:.2f}z"/>'
        )
        inside += words(right + 0.9, (top + bottom) / 2 + RISE * LETTERS, escape(one.text), more=HALO)
    if page.own and (cost := page.own[1 if timed else 0]) is not None:
        inside += f'<circle {OWN} cx="{x.at(cost):.2f}" cy="{y.at(_shown(page.own[2])):.2f}" r="{OWN_RADIUS}"/>'
    return inside


def _pen(ink: str, dashes: str) -> str:
    return f'stroke="{ink}" stroke-width="0.42"' + (f' stroke-dasharray="{dashes}"' if dashes else "")


def _triangles(page: Panels) -> list[Triangle]:
    """Return the measured slope of each line, above it towards its dear end, where lines are apart."""
    found: list[Triangle] = []
    near = NEAR**2 if page.timed else NEAR
    for index, method in enumerate(page.methods):
        points = method.points(timed=False)
        if method.order is None or len(points) < 3:
            continue
        start = max(1, (2 * len(points)) // 3) - 1
        (left, error, _), (following, _, _) = points[start], points[start + 1]
        right, top = left * min(following / left, 4.0), error * 3
        if any(max(right / a.right, a.right / right) < near and max(top / a.top, a.top / top) < near**2 for a in found):
            continue  # two labels would lie on each other; the note of the table has every order
        bottom = top * (right / left) ** -method.order
        found.append(Triangle(left, right, top, bottom, method.order_text, STYLES[index % len(STYLES)][0]))
    return found


def _legend_words(page: Panels) -> list[tuple[str, str]]:
    """Return the words of the legend and what each shows: a sample 9 mm wide about (0, 0)."""
    ends: Points = ((-LEGEND_PEN / 2, 0), (LEGEND_PEN / 2, 0))
    found = []
    for index, method in enumerate(page.methods):
        if method.points(timed=False) or method.points(timed=True):
            ink, dashes, mark = STYLES[index % len(STYLES)]
            found.append((method.name, polyline(ends, _pen(ink, dashes)) + marks([(0, 0)], mark, ink)))
    samples = {
        "own_legend": f'<circle {OWN} r="{OWN_RADIUS}"/>' if page.own else "",
        "end_legend": polyline(ends, f'stroke="#404040" {LAST_ROW}'),  # one stands for the lines of all colours
        "floor_legend": f'<path {ROUND_OFF} d="M-4.5 -1.2h9v2.4h-9z"/>' if page.floor > 0 else "",
    }
    return [*found, *((page.labels[key], samples[key]) for key in OTHERS if samples[key])]


def _columns(texts: list[str]) -> list[list[str]]:
    """Return the words of a legend in columns that fit side by side."""
    found = [texts]
    for count in LEGEND_COLUMNS:
        rows = -(-len(texts) // count)
        found = [texts[first : first + rows] for first in range(0, len(texts), rows)]
        if LEGEND_LEFT + sum(map(_wide, found)) <= WIDTH:
            break
    return found


def _wide(column: list[str]) -> float:
    """Return mm of a column of the legend, with room behind it."""
    longest = max(sum(SIGN if sign >= "\u2e80" else LETTER for sign in text) for text in column)
    return LEGEND_PEN + 2 * LEGEND_GAP + longest


def _legend(entries: list[tuple[str, str]], columns: list[list[str]]) -> str:
    """Return the legend below the axes, in the middle."""
    inside, samples = "", iter(entries)
    left = max(LEGEND_LEFT, (WIDTH - sum(map(_wide, columns))) / 2)
    for column in columns:
        for row in range(len(column)):
            text, sample = next(samples)
            y = PLOT_HEIGHT + LEGEND_LINE * (row + 0.5)
            inside += f'<g transform="translate({left + LEGEND_PEN / 2:.2f} {y:.2f})">{sample}</g>'
            inside += words(left + LEGEND_PEN + LEGEND_GAP, y + RISE * LETTERS, escape(text))
        left += _wide(column)
    return inside


def bars(labels: Sequence[str], values: Sequence[float], texts: Sequence[str], label: str) -> tuple[str, float]:
    """Return horizontal bars on a logarithmic axis with `texts` at their ends, and the height of the drawing in mm."""
    bottom = BAR_TOP + PITCH * len(values)
    x = scale_for(values, BAR_LEFT, WIDTH - RIGHT, BAR_ROOM)
    inside = across(x, bottom, BAR_TOP, escape(label))
    for row, (name, value, text) in enumerate(zip(labels, values, texts, strict=True)):
        middle, end = BAR_TOP + PITCH * (row + 0.5), x.at(value)
        outline = f"M{BAR_LEFT:g} {middle - BAR / 2:.2f}H{end:.2f}v{BAR:g}H{BAR_LEFT:g}z"
        inside += f'<path fill="{FILL}" stroke="{INK}" stroke-width="0.2" d="{outline}"/>'
        inside += words(BAR_LEFT - 1.5, middle + RISE * LETTERS, escape(name), "end")
        inside += words(end + 1.2, middle + RISE * LETTERS, escape(text))
    height = bottom + BOTTOM
    return sheet(WIDTH, height, inside), height
