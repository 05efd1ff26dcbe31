"""The figure of the accuracy section: error against cost, a name at the end of each line, similar methods as one band.

Enters: numbers and labels.  Leaves: SVG text and its height in mm.
Used by `accuracy.py`.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Iterable, Iterator
from itertools import accumulate, pairwise

import numpy as np

from coursework.drawing.paper.sheet import width
from coursework.report.graphs.figures import WIDTH
from coursework.report.graphs.graph_paper import INK, LETTERS, picture, words
from coursework.report.graphs.log_paper import RISE, Points, Scale, across, marks, scale_for, upward, way_of
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import frozen
from coursework.words.html_table import escaped

# Colours that stay apart for colour-blind readers (Okabe and Ito); dashes (mm) and marks keep them apart in print.
STYLES = (
    ("#0072b2", "", "circle"), ("#d55e00", "1.6 .7", "square"), ("#009e73", "2.7 .7 .4 .7", "up"), ("#000", ".4 .7", "diamond"),
    ("#cc79a7", "2.1 .4 .4 .4 .4 .4", "down"), ("#e69f00", "3.4 .9", "plus"), ("#56b4e9", "1.3 .4", "cross"),
    ("#7b3294", "", "star"), ("#8c510a", "1.6 .7", "left"), ("#000", "2.7 .7 .4 .7", "right"),
)  # fmt: skip
HEIGHT = 70.0  # mm, of the whole figure
LEFT, RIGHT, TOP, BOTTOM = 14.0, 42.0, 6.0, 10.5  # mm around the axes; names stand at the right of the lines
ROOM_X, ROOM_Y = (0.05, 0.05), (0.04, 0.1)  # parts of the ranges left free at both ends; a name stands above the first line
LINE = 4.3  # mm, height of one line of words
KEY_WIDE, KEY = 7.0, 8.5  # mm: length of the sample of a line before a name away from that line's end; from its begin to the name
BESIDE = (1.8, 0.0)  # mm from the end of a line to a name right behind it
PEN = 0.42  # mm, default width of a line
OWN = f'fill="none" stroke="{INK}" stroke-width="0.46"'
OWN_RADIUS = 1.9  # mm
BAND = 'class="order" fill="#e6e6e6" stroke="#555" stroke-width="0.2"'
HALO = ' stroke="#fff" stroke-width="0.8" stroke-linejoin="round" paint-order="stroke"'  # of a name that covers a line
ROUND_OFF = 'fill="#f2f2f2"'
SMALLEST = 1e-17  # an error of exactly 0 has no place on a logarithmic axis; it is drawn here
BAND_ORDER = 2  # measured order of the methods that are drawn as one band, because their lines are hardly apart

STRIDE, FARTHER = 10.0, 6.0  # mm between the places of a name anywhere in the picture, and the extra cost of such a place
STANDS = 40  # the cheapest places of a name, from which one is chosen
ON_A_LINE = 60.0  # cost of each dot of a line that a name covers
CLEAR = np.array([-0.5, 0.2, 0.5, -0.2])  # mm added to a box before covered dots are counted: letters are lower than their line
MEETING = 400.0  # cost of a name that stands on another one

Box = tuple[float, float, float, float]
Named = tuple[str, tuple[float, float], str]  # words, the end of the line they name, a sample of it as SVG, KEY_WIDE mm long


@frozen
class Method:
    """One line: `points` (cost, largest error, at least `SMALLEST`) in order of cost, and its measured `order`."""

    name: str
    points: tuple[tuple[float, float], ...]
    order: float | None


@frozen
class Chart:
    """The whole figure; `own` = (cost, error) of the coursework; `floor` = the error that round-off leaves, 0 if not shown.

    `labels` by key of the words file; `timed`: cost is running time, else evaluations; `band` writes the names of a band.
    """

    methods: tuple[Method, ...]
    own: tuple[float, float] | None
    floor: float
    error_label: str
    labels: dict[str, str]
    timed: bool
    band: Callable[[list[str]], str] = ", ".join


def chart(page: Chart) -> tuple[str, float]:
    """Return the figure of error against cost as SVG, and its height in mm."""
    lines = [(one, one.points, *STYLES[index % len(STYLES)]) for index, one in enumerate(page.methods) if one.points]
    shown = [point for _, points, *_ in lines for point in points] + ([page.own] if page.own else [])
    y = scale_for([*(error for _, error in shown), page.floor / 10], HEIGHT - BOTTOM, TOP, ROOM_Y)
    x = scale_for((cost for cost, _ in shown), LEFT, WIDTH - RIGHT, ROOM_X)
    inside, named = _ground(page, x, y)
    alike = [line for line in lines if line[0].order is not None and round(line[0].order) == BAND_ORDER and len(line[1]) > 1]
    band = sorted(alike, key=lambda line: line[1][0][1]) if len(alike) > 1 else []
    drawn: list[list[tuple[float, float]]] = []
    if band:
        low, high = ([(x.at(cost), y.at(error)) for cost, error in line[1]] for line in (band[0], band[-1]))
        inside += f'<path {BAND} d="{way_of([*low, *reversed(high)])}z"/>'
        drawn += [low, high]
        piece = f'<path {BAND} d="M0-1h{KEY_WIDE:g}v2h{-KEY_WIDE:g}z"/>'
        named.append((page.band([line[0].name for line in alike]), high[-1], piece))
    for method, points, ink, dashes, mark in lines:
        if any(method is line[0] for line in band):
            continue
        places = [(x.at(cost), y.at(error)) for cost, error in points]
        inside += _pen(places, ink, dashes) + marks(places, mark, ink)
        drawn.append(places)
        named.append((method.name, places[-1], _piece(mark, ink, dashes)))
    # Each mark counts as four dots more than a place between marks.
    dots = np.array([dot for line in drawn for dot in (*_dotted(line), *4 * line)]).reshape(-1, 2)
    ring: list[Box] = []
    first = ""
    if page.own:
        at = (x.at(page.own[0]), y.at(page.own[1]))
        inside += f'<circle {OWN} cx="{at[0]:.2f}" cy="{at[1]:.2f}" r="{OWN_RADIUS}"/>'
        piece = f'<circle {OWN} cx="{KEY_WIDE / 2:g}" r="{OWN_RADIUS}"/>'
        ring.append((at[0] - OWN_RADIUS, at[1] - OWN_RADIUS, at[0] + OWN_RADIUS, at[1] + OWN_RADIUS))
        own_name = _stands(page.labels["own_legend"], (at[0] + OWN_RADIUS, at[1]), piece, dots)[0]
        first = _written(own_name, piece, 0)
        ring.append(own_name.box)
    names = first + _names(named, dots, ring)
    return picture(WIDTH, HEIGHT, inside + names, f' stroke-width="{PEN}" style="--lines:{names.count("<text")}"'), HEIGHT


def _ground(page: Chart, x: Scale, y: Scale) -> tuple[str, list[Named]]:
    """Return the axes and the band of round-off as SVG, and a list with the name of that band, empty without one."""
    inside, named = "", []
    if page.floor > 0:
        low = y.at(page.floor)
        inside = f'<path {ROUND_OFF} d="M{x.begin:g} {low:.2f}H{x.end:g}V{y.begin:g}H{x.begin:g}z"/>'
        piece = f'<path {ROUND_OFF} d="M0-1.5h{KEY_WIDE:g}v3h{-KEY_WIDE:g}z"/>'
        named.append((page.labels["floor_legend"], (x.end - 1.5, (low + y.begin) / 2), piece))
    inside += across(x, y.begin, y.end, escaped(page.labels["seconds" if page.timed else "evaluations"]))
    return inside + upward(y, x.begin, x.end, escaped(page.error_label)), named


def _names(named: list[Named], dots: Array, taken: list[Box]) -> str:
    """Return the names of lines as SVG, placed clear of each other and of the boxes `taken`, covering few `dots` (n, 2).

    First each name takes its best free place.  Then, twice, each name tries all its places: names that stand there are placed
    anew, and the change is kept if the total cost falls.
    """
    stands = [_stands(*one, dots) for one in named]
    boxes = np.array([*taken, *(stand.box for one in stands for stand in one)]).reshape(-1, 4)
    left, top, right, bottom = boxes.T
    meet = (left[:, None] < right) & (left < right[:, None]) & (top[:, None] < bottom) & (top < bottom[:, None])
    masks = [int.from_bytes(row.tobytes(), "little") for row in np.packbits(meet, axis=1, bitorder="little")]
    begins = [*accumulate(map(len, stands), initial=len(taken))]
    ground = functools.reduce(operator.or_, masks[: len(taken)], 0)

    def settle(at: dict[int, int], names: Iterable[int]) -> dict[int, int]:
        """Return `at` with each of `names` added, in the best place that the names before it leave free."""
        for k in names:
            full = functools.reduce(operator.or_, (masks[begins[other] + place] for other, place in at.items()), ground)
            free = (place for place in range(len(stands[k])) if not full >> begins[k] + place & 1)
            at = at | {k: next(free, 0)}
        return at

    def cost(at: dict[int, int]) -> float:
        full, total = ground, 0.0
        for k, place in at.items():
            total += stands[k][place].cost + MEETING * (full >> begins[k] + place & 1)
            full |= masks[begins[k] + place]
        return total

    order = sorted(range(len(named)), key=lambda k: (stands[k][0].cost, -width(named[k][0])))
    best = settle({}, order)
    least = cost(best)
    everywhere = [(name, place) for name in order for place in range(len(stands[name]))]
    for k, place in 2 * everywhere:
        met = masks[begins[k] + place]
        kept = {other: own for other, own in best.items() if other != k and not met >> begins[other] + own & 1}
        other = settle(kept | {k: place}, [name for name in order if name != k and name not in kept])
        if (found := cost(other)) < least - 1e-9:
            best, least = other, found
    chosen = [(stands[k][best[k]], named[k][2]) for k in range(len(named))]
    belows = accumulate((len(stand.rows) for stand, _ in chosen), initial=1)
    return "".join(_written(stand, piece, below) for (stand, piece), below in zip(chosen, belows, strict=False))


@frozen
class Stand:
    """A place of a name: its lines `rows`, the `box` they fill (mm), the width `before` them for a sample of the line (mm).

    `cost` is that of standing there; `covers`: it covers a line.
    """

    rows: tuple[str, ...]
    box: Box
    before: float
    cost: float
    covers: bool


def _stands(text: str, place: tuple[float, float], piece: str, dots: Array) -> list[Stand]:
    """Return the cheapest places of a name first: on one line, on two, or on lines that fit the room beside the axes."""
    key = KEY if piece else 0.0
    listed = list(dict.fromkeys(((text,), _rows(text, 0.68 * LETTERS * width(text)), _rows(text, RIGHT - BESIDE[0]))))
    tried = []
    for number, rows in enumerate(listed):
        wide, high, more = LETTERS * max(map(width, rows)), LINE * len(rows), LINE * (len(rows) - 1)
        near = _places(wide + key, WIDTH - RIGHT - place[0])
        dx, dy, cost = np.concatenate([near, _anywhere(place, wide + key)] if piece else [near]).T
        before = np.where((dx == BESIDE[0]) & (dy == BESIDE[1]), 0.0, key)
        left, top = place[0] + dx, place[1] + dy - high / 2
        right, bottom = left + before + wide, top + high
        outside = (right > WIDTH) | (left < LEFT + 1) | (top < TOP - 1) | (bottom > HEIGHT - BOTTOM)
        tried.append([left, top, right, bottom, before, cost + more + 4000 * outside, np.full(len(cost), number)])
    every = np.concatenate(tried, axis=1).T
    covered = _covered(every[:, :4] + CLEAR, dots)
    costs = every[:, 5] + ON_A_LINE * covered
    best = np.argsort(costs, kind="stable")[:STANDS]
    told = zip(every[best].tolist(), costs[best].tolist(), covered[best].tolist(), strict=True)
    return [Stand(listed[int(one[6])], (one[0], one[1], one[2], one[3]), one[4], cost, count > 0) for one, cost, count in told]


def _written(stand: Stand, piece: str, below: int) -> str:
    """Return a name with the sample of its line before it; the sample is hidden if the name stands right behind the line.

    A phone is too small for names in the picture, so it lists all names with samples below it, this one in line `below`.
    """
    left, top, _, bottom = stand.box
    base, more = LINE / 2 + RISE * LETTERS - (bottom - top) / 2, HALO if stand.covers else ""
    rows = (words(stand.before, base + LINE * k, escaped(row), more=more) for k, row in enumerate(stand.rows))
    at = f'style="--at:{below}" transform="translate({left:.4g} {(top + bottom) / 2:.4g})"'
    shown = piece if stand.before else f'<g display="none">{piece}</g>'
    return f'<g class="called{"" if stand.before else " end"}" {at}>{shown}{"".join(rows)}</g>'


def _rows(text: str, room: float) -> tuple[str, ...]:
    """Return a name broken into lines at most `room` mm long; a longer word stays whole."""
    rows = [""]
    for word in text.split(" "):
        longer = f"{rows[-1]} {word}".lstrip()
        if rows[-1] and LETTERS * width(longer) > room:
            rows.append(word)
        else:
            rows[-1] = longer
    return tuple(rows)


def _covered(boxes: Array, dots: Array) -> Array:
    """Return how many of the `dots` (m, 2) lie in each of the `boxes` (n, 4)."""
    left, top, right, bottom = boxes.T
    inside = _between(left, right, dots[:, 0]) & _between(top, bottom, dots[:, 1])
    return np.asarray(np.count_nonzero(inside, axis=1))


def _between(low: Array, high: Array, at: Array) -> Flags:
    """Return whether each of `at` (m,) lies between `low` and `high` (n,), as (n, m)."""
    kinds, kind = np.unique(low + 1j * high, return_inverse=True)  # boxes stand in few columns and few rows
    return np.asarray(((kinds.real[:, None] < at) & (at < kinds.imag[:, None]))[kind])


def _piece(mark: str, ink: str, dashes: str) -> str:
    return _pen([(0.0, 0.0), (KEY_WIDE, 0.0)], ink, dashes) + marks([(KEY_WIDE / 2, 0.0)], mark, ink)


def _pen(places: Points, ink: str, dashes: str) -> str:
    if len(places) < 2:
        return ""
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<path fill="none" stroke="{ink}"{dashed} d="{way_of(places)}"/>'


def _places(wide: float, axes: float) -> Array:
    """Return places (n, 3) of a name near its line as (dx, dy, cost), best first; dx and dy lead from the line's end to its left.

    `wide` is the width of the name, `axes` the distance from the line's end to the right end of the axes (mm).
    """
    found = []
    for step in range(12):
        far = step + step * step / 8
        for dy in {0.0} if step == 0 else {step * LINE * 0.75, -step * LINE * 0.75}:
            found += [(BESIDE[0], dy, far), (-wide - BESIDE[0], dy, far + 2.0), (axes + BESIDE[0], dy, far + axes / LINE)]
            found += [(-wide * part, dy, far + 0.5 + 9 * (step < 1)) for part in (0.25, 0.5, 0.75)]
    return np.array(sorted(found, key=lambda one: (one[2], one)))


def _anywhere(place: tuple[float, float], wide: float) -> Array:
    """Return places (n, 3) all over the picture, where a name is understood because a sample of its line precedes it."""
    left, middle = np.arange(LEFT + 1.5, WIDTH - max(RIGHT, wide), STRIDE), np.arange(TOP, HEIGHT - BOTTOM, LINE)
    dx, dy = np.repeat(left, len(middle)) - place[0], np.tile(middle, len(left)) - place[1]
    return np.column_stack([dx, dy, FARTHER + 2 * np.sqrt(dx * dx + dy * dy) / LINE])


def _dotted(line: Points) -> Iterator[tuple[float, float]]:
    """Yield points along a line, about 1 mm apart."""
    for (x0, y0), (x1, y1) in pairwise(line if len(line) > 1 else [*line, *line]):
        steps = max(2, int(math.hypot(x1 - x0, y1 - y0)))
        for k in range(steps + 1):
            yield x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps
