"""The spots for names of points and numbers of links in the live part: chosen once, clear of the drawing in every position.

Enters: an `Outline`, its positions at the start and in later rows, the words.  Leaves: spots in units of the drawing, y down.
Used by `report/live/drawn.py` and `report/graphs/moving_picture.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.ground import hinge_ground, inward, racks, rail_side
from coursework.drawing.outline.outline import Bar, Outline, Slot
from coursework.drawing.outline.poses import Poses
from coursework.drawing.paper.cover import STILL, clipped, shared
from coursework.system.arrays import Array, Complex, distinct
from coursework.system.frozen import frozen

# Units across the drawing, on a wide screen and on a phone, as in drawing.js; the lengths below are units too.
WIDTHS = (640, 380)
ROWS = 6  # positions that are considered; the first is the start, which counts as much as all others together
LETTER, NUMERAL, HALF_HEIGHT = 9.0, 8.0, 7.0  # width of a letter of a name and of a link's number; half the height of both
TURNS = np.exp(2j * np.pi * (np.arange(12) - 1.5) / 12)  # directions from a point, y down: up and to the right first
GAPS, BLOCK_GAPS = (8.0, 14.0, 22.0), (9.0, 15.0, 22.0)  # from a point to its name, from a slider to the number of its link
PARTS, OFFS = (0.5, 0.35, 0.65, 0.2, 0.8), (6.0, 12.0, 28.0)  # of a number: part along a side of its link, distance from it
SHORT = 24.0  # a shorter side gets no number
LINE, SYMBOL, WORD = (12.0, 1.0), (30.0, 0.3), (80.0, 0.3)  # price of a line, symbol or word met, and per unit of it covered
ANOTHER, OF_ANOTHER = 25.0, 60.0  # price of a name nearer to another point, of a number nearer to another link
APART = 8.0  # words on one line that are nearer read as one
FARTHER, LATER = 0.4, 0.3  # price per unit of distance, and per direction or part after the first


@frozen
class _Choice:
    """The k spots that one word may take, their `prices` (k,), the `middles` (r, k) of the word there, `half` its width."""

    half: float
    spots: list[list[float]]
    prices: Array
    middles: Complex


def spots_of(outline: Outline, poses: Sequence[Poses], names: Sequence[str]) -> list[list[list[float]]]:
    """Return for each of `WIDTHS` the spot of every shown point's name (`names`), then of every link's number.

    A spot of a name is [x, y] from its point; of a number [part, across, side], the part along that side of the link and the
    distance to its left, or [x, y] if no side is long enough; [] for none.  `poses` are those of the true motion, whose first
    row is the start, and of other motions for which the drawing must have room.
    """
    return [_spots(outline, poses[0], scale_of(outline, poses, width), names) for width in WIDTHS]


def scale_of(outline: Outline, poses: Sequence[Poses], width: float) -> float:
    """Return the units per metre, as `refit` in drawing.js computes them."""
    ends = [one.at[name] for one in poses for name in outline.shown]
    for one in poses:
        for centre, rim in outline.circles:
            radius = np.abs(one.at[rim] - one.at[centre]) * (1 + 1j)
            ends += [one.at[centre] - radius, one.at[centre] + radius]
    every = np.concatenate(ends)
    return float(min((width - 90) / max(np.ptp(every.real), 1e-12), (0.2 * width + 200) / max(np.ptp(every.imag), 1e-12)))


def _spots(outline: Outline, poses: Poses, scale: float, names: Sequence[str]) -> list[list[float]]:
    rows = distinct(np.linspace(0, len(poses.t) - 1, ROWS).round().astype(int))
    weight = np.where(rows == 0, max(1, len(rows) - 1), 1) / max(1, 2 * (len(rows) - 1))
    seen = scenery_of(outline, poses, rows, scale)
    # Names have less choice than numbers, so they choose first.
    choices = [_of_point(point, name, outline, seen, weight) for point, name in zip(outline.shown, names, strict=True)]
    choices += [_of_link(outline, bar, seen, weight) for bar in outline.bars]
    found: list[list[float]] = []
    taken, beside = np.zeros((len(rows), 0, 4)), np.array([APART, 0.0])
    for each in choices:
        if not each.spots:
            found.append([])
            continue
        low, high = (pairs(each.middles) + sign * np.array([each.half, HALF_HEIGHT]) for sign in (-1, 1))
        lines = seen.near(low, high)
        paid = _paid(clipped(low, high, seen.begin[:, lines], seen.step[:, lines]) * seen.length[:, None, lines], LINE)
        paid += _paid(_areas(low, high, seen.symbols), SYMBOL) + _paid(_areas(low - beside, high + beside, taken), WORD)
        best = int(np.argmin(np.round(weight @ paid + each.prices, 6)))
        found.append(each.spots[best])
        taken = np.concatenate([taken, np.concatenate([low, high], axis=2)[:, best : best + 1]], axis=1)
    return found


def _areas(low: Array, high: Array, others: Array) -> Array:
    sides = np.maximum(shared(low, high, others), 0.0)
    return np.asarray(sides[..., 0] * sides[..., 1])


def _paid(covered: Array, prices: tuple[float, float]) -> Array:
    """Return the prices (r, k) of words that cover `covered` (r, k, m) of m things: one per thing met, one per unit of it."""
    return np.asarray(prices[0] * np.count_nonzero(covered, axis=2) + prices[1] * covered.sum(axis=2))


def _about(at: Complex, half: float, gaps: Sequence[float]) -> _Choice:
    """Return the spots around a point, at each of which the word touches a circle around it with a radius in `gaps`."""
    reach = np.minimum(half / np.maximum(np.abs(TURNS.real), 1e-9), HALF_HEIGHT / np.maximum(np.abs(TURNS.imag), 1e-9))
    ways = np.concatenate([TURNS * (gap + reach) for gap in gaps])
    spots = np.round(pairs(ways))
    prices = np.add.outer(FARTHER * np.array(gaps), LATER * np.arange(len(TURNS))).ravel()
    return _Choice(half, spots.astype(int).tolist(), prices, at[:, None] + spots @ np.array([1, 1j]))


def _of_point(point: str, name: str, outline: Outline, seen: Scenery, weight: Array) -> _Choice:
    """Return the spots around a point; a spot nearer to another point costs more, since the name would seem to belong to that."""
    choice = _about(seen.at[point], LETTER * len(name.replace("_", "")) / 2 + 1, GAPS)
    far = np.abs(choice.middles - np.array([seen.at[each] for each in outline.shown])[:, :, None])
    nearer = far.min(axis=0) < far[outline.shown.index(point)] - 1
    return replace(choice, prices=choice.prices + ANOTHER * (weight @ nearer))


def _of_link(outline: Outline, bar: Bar, seen: Scenery, weight: Array) -> _Choice:
    """Return the spots beside the long sides of a link, the longest first; without long sides, around its point or wheel.

    A spot nearer to another link costs more, since the number would seem to belong to that.
    """
    half = NUMERAL * len(bar.link) / 2 + 1
    sides = _sides(bar, seen)
    sizes = [round(float(abs(b[0] - a[0])), 6) for a, b in sides]
    order = [side for side in sorted(range(len(sides)), key=lambda k: -sizes[k]) if sizes[side] > SHORT]
    across = [sign * round(off + max(half, HALF_HEIGHT)) for off in OFFS for sign in (1, -1)]
    ways = [*itertools.product(PARTS, across)]
    spots = [[part, off, side] for side in order for part, off in ways]
    if bar.corners and not spots:
        wheel = next((wheel for wheel in outline.wheels if wheel.link == bar.link), None)
        radius = abs(seen.at[wheel.contact][0] - seen.at[wheel.centre][0]) if wheel else 0.0
        beyond = [round(radius) + GAPS[0]] if radius > BLOCK_GAPS[0] else []
        return _about(seen.at[bar.corners[0]], half, (*BLOCK_GAPS, *beyond))
    middles = [np.zeros((len(seen.begin), 0), complex)]
    for a, b in (sides[side] for side in order):
        part, off = np.array(ways).T
        way = (b - a)[:, None]
        middles.append(a[:, None] + way * (part - 1j * off / np.maximum(np.abs(way), 1e-9)))
    places = np.concatenate(middles, axis=1)
    prices = LATER * np.arange(float(len(spots))) + FARTHER * np.array([abs(off) for _, off, _ in spots])
    others = [side for other in outline.bars if other is not bar for side in _sides(other, seen)]
    if spots and others:
        prices += OF_ANOTHER * (weight @ (_away(places, others) < _away(places, sides) - 1))
    return _Choice(half, spots, prices, places)


def _sides(bar: Bar, seen: Scenery) -> list[tuple[Complex, Complex]]:
    return [*itertools.pairwise(seen.at[name] for name in bar.corners)]


def _away(places: Complex, sides: Sequence[tuple[Complex, Complex]]) -> Array:
    """Return the distance of places (r, k) from the nearest of the sides, each given by its two ends (r,)."""
    begin, end = (np.array(ends)[..., None] for ends in zip(*sides, strict=True))
    way, toward = end - begin, places - begin
    part = np.clip((toward * way.conjugate()).real / np.maximum(np.abs(way) ** 2, 1e-9), 0.0, 1.0)
    return np.asarray(np.abs(toward - part * way).min(axis=0))


# As in drawing.js: how far a slot and a rail extend beyond the last place of a rider, how deep a rack and a hatching are, how far
# a rail is from the middle of its block.
SLOT_END, RAIL_END, RACK, HATCH, BESIDE = 10.0, 25.0, 7.0, 6.0, 7.0
RIM = np.exp(2j * np.pi * np.arange(13) / 12)  # a circle as chords


@frozen
class Scenery:
    """What is drawn in r rows: points `at` (name -> (r,)); s lines from `begin` by `step` (r, s, 2), of `length` (r, s).

    `symbols` (r, b, 4) are the boxes of b symbols.
    """

    at: dict[str, Complex]
    begin: Array
    step: Array
    length: Array
    symbols: Array

    def near(self, low: Array, high: Array) -> NDArray[np.intp]:
        """Return the indices of lines that come near any of the boxes with corners `low` and `high` (r, k, 2), in any row."""
        ends = self.begin, self.begin + self.step
        meet = (np.minimum(*ends) <= high.max(axis=1)[:, None]) & (np.maximum(*ends) >= low.min(axis=1)[:, None])
        return np.flatnonzero((meet[..., 0] & meet[..., 1]).any(axis=0))


def scenery_of(outline: Outline, poses: Poses, rows: NDArray[np.int64], scale: float) -> Scenery:
    """Return what is drawn in the rows `rows` of a motion; `scale` are the units per metre."""
    at: dict[str, Complex] = {name: np.asarray(scale * places[rows].conjugate()) for name, places in poses.at.items()}
    lines = [*_moving_lines(outline, poses, rows, scale, at)]
    lines += [(np.full(len(rows), begin), np.full(len(rows), end)) for begin, end in _fixed_lines(outline, poses, scale, at)]
    begin, end = pairs(np.array(lines).reshape(-1, 2, len(rows)).transpose(1, 2, 0))
    step = end - begin
    symbols = [
        np.concatenate([pairs(middle - half), pairs(middle + half)], axis=1)
        for middle, half in _symbols(outline, poses, rows, at)
    ]
    boxes = np.array(symbols).reshape(-1, len(rows), 4).transpose(1, 0, 2)
    return Scenery(at, begin, np.where(step == 0, STILL, step), np.hypot(step[..., 0], step[..., 1]), boxes)


def pairs(places: Complex) -> Array:
    """Return complex numbers as pairs (real, imaginary) along a new last axis."""
    return np.stack([places.real, places.imag], axis=-1)


def _moving_lines(
    outline: Outline, poses: Poses, rows: NDArray[np.int64], scale: float, at: dict[str, Complex]
) -> Iterator[tuple[Complex, Complex]]:
    def along(slot: Slot, deep: float) -> tuple[Complex, Complex]:
        beside, low, high = (scale * each for each in poses.line(slot))
        way = np.conj(poses.along(slot.base, slot.toward)[rows])
        foot = at[slot.at] - 1j * (deep or beside) * way
        return foot + way * (min(low, 0.0) - SLOT_END), foot + way * (max(high, 0.0) + SLOT_END)

    for bar in outline.bars:
        yield from ((at[a], at[b]) for a, b in itertools.pairwise(bar.corners))
    for slot in outline.slots:
        yield along(slot, 0.0)
        beside = scale * poses.line(slot)[0]
        yield at[slot.at], at[slot.at] - 1j * beside * np.conj(poses.along(slot.base, slot.toward)[rows])
    for wheel in outline.wheels:
        yield from itertools.pairwise(at[wheel.centre] + np.abs(at[wheel.contact] - at[wheel.centre]) * RIM[:, None])
        yield at[wheel.centre], at[wheel.contact]
    for rack in racks(outline, poses.pose(0)):
        yield from (along(rack.slot, 0.0), along(rack.slot, RACK * rack.side))


def _fixed_lines(outline: Outline, poses: Poses, scale: float, at: dict[str, Complex]) -> Iterator[tuple[complex, complex]]:
    """Yield fixed circles and rails, and the ends of their hatchings."""
    start = poses.pose(0)
    for track in outline.tracks:
        middle, solid = at[track.centre][0], inward(outline, start, track)
        for depth in (0.0, HATCH * solid) if solid else (0.0,):
            yield from itertools.pairwise((middle + (abs(at[track.rim][0] - middle) - depth) * RIM).tolist())
    for rail in outline.rails:
        _, along, low, high = poses.travel(rail)
        way = along.conjugate()
        foot = complex(at[rail.at][0])
        for off in (0.0, HATCH):
            out = -1j * way * rail_side(outline, start, rail) * (off + (0.0 if rail.rolls or not rail.rider else BESIDE))
            yield foot + out + way * (scale * low - RAIL_END), foot + out + way * (scale * high + RAIL_END)


def _symbols(
    outline: Outline, poses: Poses, rows: NDArray[np.int64], at: dict[str, Complex]
) -> Iterator[tuple[Complex, complex | Complex]]:
    """Yield the middle and the half size of each joint, pivot and block."""
    start = poses.pose(0)
    yield from ((at[name], 5 + 5j) for name in outline.shown)
    yield from ((at[name] + 11 * hinge_ground(outline, start, name).conjugate(), 12 + 12j) for name in outline.hinges)
    for block in outline.blocks:
        way = poses.along(block.base, block.toward)[rows]
        x, y = np.abs(way.real), np.abs(way.imag)
        yield at[block.at], 14 * x + 8 * y + 1j * (14 * y + 8 * x)
