"""The figure of the accuracy section: error against cost, each line named where it ends, alike methods as one band.

Enters: numbers and labels.  Leaves: SVG text and its height in mm.
Used by `accuracy.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from html import escape
from itertools import pairwise

from coursework.report.graphs.figures import WIDTH
from coursework.report.graphs.graph_paper import INK, LETTERS, words
from coursework.report.graphs.log_paper import RISE, Points, Scale, across, marks, polyline, scale_for, sheet, upward, way_of
from coursework.system.frozen import frozen

# Colours that stay apart for colour-blind readers (Okabe and Ito); dashes (mm) and marks keep them apart in print.
STYLES = (
    ("#0072b2", "", "circle"), ("#d55e00", "1.6 .7", "square"), ("#009e73", "2.7 .7 .4 .7", "up"), ("#000", ".4 .7", "diamond"),
    ("#cc79a7", "2.1 .4 .4 .4 .4 .4", "down"), ("#e69f00", "3.4 .9", "plus"), ("#56b4e9", "1.3 .4", "cross"),
    ("#7b3294", "", "star"), ("#8c510a", "1.6 .7", "left"), ("#000", "2.7 .7 .4 .7", "right"),
)  # fmt: skip
HEIGHT = 70.0  # mm of the whole
LEFT, RIGHT, TOP, BOTTOM = 14.0, 42.0, 6.0, 10.5  # mm around the axes; words stand at the right of the lines
ROOM_X, ROOM_Y = (0.05, 0.05), (0.04, 0.04)  # of the ranges, before and behind what is shown
LETTER, SIGN = 1.73, 3.02  # mm: of a letter, a little more than the mean, and of a Chinese sign
LINE = 4.0  # mm of one line of words
OWN = f'fill="none" stroke="{INK}" stroke-width="0.46"'
OWN_RADIUS = 1.9  # mm
BAND = 'class="order" fill="#e6e6e6" stroke="#555" stroke-width="0.2"'
ROUND_OFF = 'fill="#f2f2f2"'
SMALLEST = 1e-17  # an error of exactly 0 has no place on a logarithmic axis; it is drawn here
BAND_ORDER = 2  # of which there are several methods, hardly apart

Box = tuple[float, float, float, float]


@frozen
class Method:
    """One line: evaluations, seconds (None = not shown) and largest error at each setting, its measured order."""

    name: str
    evaluations: tuple[int, ...]
    seconds: tuple[float | None, ...]
    errors: tuple[float, ...]
    order: float | None

    def points(self, *, timed: bool) -> list[tuple[float, float]]:
        """Return (cost, largest error), from the cheapest on."""
        costs = self.seconds if timed else self.evaluations
        return [
            (float(cost), max(abs(error), SMALLEST))
            for _, cost, error in sorted(zip(self.evaluations, costs, self.errors, strict=True))
            if cost is not None and math.isfinite(error)
        ]


@frozen
class Chart:
    """The whole figure; `own` = (evaluations, seconds, error) of the coursework, `labels` by key of the words file."""

    methods: tuple[Method, ...]
    own: tuple[int, float | None, float] | None
    floor: float
    error_label: str
    labels: dict[str, str]
    band: Callable[[list[str]], str] = ", ".join

    @property
    def timed(self) -> bool:
        """Return whether the cost is running time, else evaluations."""
        return any(seconds is not None for method in self.methods for seconds in method.seconds)


def chart(page: Chart) -> tuple[str, float]:
    """Return error against cost, and mm high."""
    timed = page.timed
    lines = [(method, method.points(timed=timed), *STYLES[index % len(STYLES)]) for index, method in enumerate(page.methods)]
    lines = [line for line in lines if line[1]]
    own = (page.own[1 if timed else 0], max(abs(page.own[2]), SMALLEST)) if page.own else (None, 0.0)
    errors = [error for _, points, *_ in lines for _, error in points] + ([own[1]] if own[0] else [])
    errors += [page.floor / 10] if page.floor > 0 else []
    y = scale_for(errors, HEIGHT - BOTTOM, TOP, ROOM_Y)
    costs = [cost for _, points, *_ in lines for cost, _ in points] + ([own[0]] if own[0] else [])
    x = scale_for(costs, LEFT, WIDTH - RIGHT, ROOM_X)
    inside, named = _ground(page, x, y)
    alike = [line for line in lines if line[0].order is not None and round(line[0].order) == BAND_ORDER and len(line[1]) > 1]
    band = sorted(alike, key=lambda line: line[1][0][1]) if len(alike) > 1 else []
    drawn: list[list[tuple[float, float]]] = []
    if band:
        low, high = ([(x.at(cost), y.at(error)) for cost, error in line[1]] for line in (band[0], band[-1]))
        inside += f'<path {BAND} d="{way_of([*low, *reversed(high)])}z"/>'
        drawn += [low, high]
        named.append((page.band([line[0].name for line in alike]), high[-1]))
    for method, points, ink, dashes, mark in lines:
        if any(method is line[0] for line in band):
            continue
        places = [(x.at(cost), y.at(error)) for cost, error in points]
        pen = f'stroke="{ink}" stroke-width="0.42"' + (f' stroke-dasharray="{dashes}"' if dashes else "")
        inside += polyline(places, pen) + marks(places, mark, ink)
        drawn.append(places)
        named.append((method.name, places[-1]))
    taken: list[Box] = []
    if own[0] is not None:
        at = (x.at(own[0]), y.at(own[1]))
        inside += f'<circle {OWN} cx="{at[0]:.2f}" cy="{at[1]:.2f}" r="{OWN_RADIUS}"/>'
        named.insert(0, (page.labels["own_legend"], at))
        taken.append((at[0] - OWN_RADIUS, at[1] - OWN_RADIUS, at[0] + OWN_RADIUS, at[1] + OWN_RADIUS))
    for text, place in named:
        inside += _name(text, place, drawn, taken)
    return sheet(WIDTH, HEIGHT, inside), HEIGHT


def _ground(page: Chart, x: Scale, y: Scale) -> tuple[str, list[tuple[str, tuple[float, float]]]]:
    """Return axes and the band of round-off, and the name of that."""
    inside, named = "", []
    if page.floor > 0:
        low = y.at(page.floor)
        inside = f'<path {ROUND_OFF} d="M{x.begin:g} {low:.2f}H{x.end:g}V{y.begin:g}H{x.begin:g}z"/>'
        named.append((page.labels["floor_legend"], (x.end - 1.5, (low + y.begin) / 2)))
    inside += across(x, y.begin, y.end, escape(page.labels["seconds" if page.timed else "evaluations"]))
    return inside + upward(y, x.begin, x.end, escape(page.error_label)), named


def _name(text: str, place: tuple[float, float], drawn: Sequence[Points], taken: list[Box]) -> str:
    """Return the name of a line beside its end, where it covers fewest words and lines."""
    wide = sum(SIGN if sign >= "\u2e80" else LETTER for sign in text)
    best: tuple[float, Box] | None = None
    for dx, dy, cost in _places(wide):
        left, top = place[0] + dx, place[1] + dy - LINE / 2
        box = (left, top, left + wide, top + LINE)
        cost += 40 * sum(_meet(box, other) for other in taken) + 4 * sum(_crossed(box, line) for line in drawn)
        cost += 100 * (box[2] > WIDTH or box[0] < LEFT + 1 or box[1] < TOP or box[3] > HEIGHT - BOTTOM)
        if best is None or cost < best[0]:
            best = (cost, box)
    assert best is not None
    taken.append(best[1])
    return words(best[1][0], best[1][1] + LINE / 2 + RISE * LETTERS, escape(text))


def _places(wide: float) -> list[tuple[float, float, float]]:
    """Return where the left middle of words may stand from the end of a line, and how far off that is."""
    found = []
    for step in range(5):
        for dy in {0.0} if step == 0 else {step * LINE * 0.75, -step * LINE * 0.75}:
            found += [(1.8, dy, step), (-wide / 2, dy, step + 0.5 + 9 * (step < 1)), (-wide - 1.8, dy, step + 2.0)]
    return sorted(found, key=lambda one: (one[2], one))


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _crossed(box: Box, line: Points) -> int:
    """Return at how many of some places of a line it lies within a box."""
    count = 0
    for (x0, y0), (x1, y1) in pairwise(line if len(line) > 1 else [*line, *line]):
        steps = max(2, int(math.hypot(x1 - x0, y1 - y0)))
        for k in range(steps + 1):
            x, y = x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps
            count += box[0] < x < box[2] and box[1] < y < box[3]
    return count
