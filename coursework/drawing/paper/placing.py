"""Finds where a word stands: beside what it names, nearer to it than to anything similar, covering as little as possible.

Enters: what a sheet has so far (mm, y down), the size of a word and what it belongs to.  Leaves: `Stand`.
Used by `sheet.py`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import field

import numpy as np

from coursework.drawing.paper.cover import Lines, Rectangle, Segment, shared, through
from coursework.system.arrays import Array
from coursework.system.frozen import changing, frozen

Place = tuple[complex, complex, float]  # beside this point, preferably in this direction, at this distance (mm)
DIRECTIONS = 16  # directions that are tried
RINGS = (0.0, 1.0, 2.0, 3.2, 4.5, 6.0, 8.0, 12.0, 17.0, 23.0, 30.0, 40.0)  # mm farther out; the last only if words would meet
FIRST, FURTHER = 24, 4  # places rated together, ranked by their least cost; then this many times more
FARTHER = 0.5  # price of standing 1 mm farther off; all prices are in mm of thin lines covered instead
TURNED = 0.6  # price of a quarter turn away from the preferred direction
NEXT = 0.6  # price of each place after the first
MARGIN = 0.5  # mm kept free around a word
CLEAR = 0.4  # mm more kept free beside a heavy line: half of its width
HEAVY = 120.0  # price of covering a heavy line: a link or an arrow
WORD_ON_WORD = 200.0  # price of covering another word
CROSSED = 20.0  # price of every line through the word, beside its length
SYMBOL = (3.0, 6.0)  # price of each covered mm² of a symbol, and of each symbol
GAP, SIDE_BY_SIDE = 2.2, 20.0  # mm: words nearer on one line read as one word; the price of that
LEADING, FRACTION = 0.8, 2.0  # mm: so do words nearer above each other; the same for lengths, which would read as a fraction
BEYOND = 90.0  # price of each mm beyond the field
CLEARLY = 1.0  # mm: a word should be this much nearer to its owner than to any rival
LOST = 5.0  # mm: farther from its owner a word seems to belong to nothing, and a leader line leads to it
LEADER, LEADER_CROSSES = 4.0, (15.0, 100.0, 3.0)  # price of a leader line, and of each heavy line, word, symbol crossed
STEP_OFF = 0.6  # mm: a leader is examined from this far off the line that it leads to
ALONG = (0.35, 0.6, 0.85)  # parts of a leader's length at which it is not to lie on a heavy line
CHEAPEST = 6  # places whose rivals are examined together, the cheapest first
TOUCH = 1.2  # mm: a place this near is beside a point or a line; a place farther off is beside a rim or a block


@frozen
class Owner:
    """What a word belongs to: its `own` segments; `mistaken` is the price of a place where `rivals` could be meant instead."""

    own: Sequence[Segment]
    rivals: Sequence[Segment] = ()
    mistaken: float = 8.0
    lost: float = LOST  # mm: a word farther from its own segments gets a leader line
    leading: float = LEADING  # mm: words this near above or below it are read with it


@frozen
class Stand:
    """The `middle` of a word at one of its places; `leader` is where its leader line begins, None if it needs none."""

    middle: complex
    place: Place
    leader: complex | None


@changing
class Taken:
    """What is on a sheet so far; the lists are those of the sheet, and arrays are made anew when they have grown."""

    segments: list[Segment]
    heavy: list[Segment]
    boxes: list[Rectangle]
    words: list[Rectangle]
    _lines: dict[str, Lines] = field(default_factory=dict)
    _rectangles: Array = field(default_factory=lambda: np.empty((0, 4)))

    def lines(self, name: str) -> Lines:
        """Return the "heavy" segments as arrays, or "all": the segments, then the heavy ones again with the room around them."""
        listed = self.heavy if name == "heavy" else [*self.segments, *self.heavy]
        if name not in self._lines or self._lines[name].count != len(listed):
            self._lines[name] = Lines(listed, None if name == "heavy" else len(self.segments), CLEAR)
        return self._lines[name]

    def rectangles(self) -> Array:
        """Return boxes and words as an array (n, 4)."""
        if len(self._rectangles) != len(self.boxes) + len(self.words):
            self._rectangles = np.array([*self.boxes, *self.words])
        return self._rectangles

    def covered(self, middles: Array, width: float, height: float, room: Rectangle, leading: float = LEADING) -> Array:
        """Return the cost of equal rectangles: mm of lines, more for heavy lines, words, symbols and what is outside `room`."""
        half = np.array([width / 2 + MARGIN, height / 2 + MARGIN])
        low, high = middles - half, middles + half
        edge = np.array(room)
        beyond = np.maximum(edge[:2] - low, 0.0) + np.maximum(high - edge[2:], 0.0)
        symbols, words = np.split(shared(low, high, self.rectangles()), [len(self.boxes)], axis=1)
        areas = np.multiply.reduce(np.maximum(symbols, 0.0), axis=2)
        level = words[..., 1] > 0
        over, beside = level & (words[..., 0] > 0), level & (words[..., 0] > -GAP)
        stacked = (words[..., 0] > 0) & (words[..., 1] > -leading) & ~level
        crossed, length, heavy = self.lines("all").within(low, high)
        cost: Array = BEYOND * beyond.sum(axis=1) + length + CROSSED * crossed + HEAVY * heavy
        cost += SYMBOL[0] * areas.sum(axis=1) + SYMBOL[1] * (areas > 0).sum(axis=1)
        cost += WORD_ON_WORD * over.sum(axis=1) + SIDE_BY_SIDE * (beside | stacked).sum(axis=1)
        return cost

    def stand(self, width: float, height: float, places: Sequence[Place], owner: Owner, room: Rectangle) -> Stand:
        """Return where a word of a width and height (mm) stands best, beside one of the `places`."""
        claimed, owned = Lines([*owner.own, *owner.rivals]), len(owner.own)
        half = np.array([width / 2, height / 2])
        turns = math.tau * np.arange(DIRECTIONS) / DIRECTIONS
        toward = np.array([np.angle(away) if away else -math.pi / 4 for _, away, _ in places])
        units = np.exp(1j * (toward[:, None] + turns))
        reach = np.minimum(half[0] / np.maximum(np.abs(units.real), 1e-9), half[1] / np.maximum(np.abs(units.imag), 1e-9))
        near, gaps = (np.array([place[k] for place in places]) for k in (0, 2))
        fixed = TURNED * (1 - np.cos(turns)) + NEXT * np.arange(len(places))[:, None]
        best, found = math.inf, Stand(places[0][0], places[0], None)
        rings = np.array(RINGS)
        leasts = (FARTHER * rings[:, None, None] + fixed).ravel()
        ranked = np.argsort(leasts, kind="stable")  # if the first ones are good, the others need not be rated
        for begin, end in _growing(len(ranked)):
            kept = np.sort(ranked[begin:end][leasts[ranked[begin:end]] < best])
            if not kept.size:
                break
            ring, place, turn = np.unravel_index(kept, (len(rings), *units.shape))
            unit, gap = units[place, turn], gaps[place]
            # Each rectangle touches the circle of radius `gap + ring` about its point.
            at = near[place] + unit * (gap + rings[ring] + reach[place, turn])
            middles = np.column_stack([at.real, at.imag])
            low, high = middles - half, middles + half
            cost = leasts[kept] + self.covered(middles, width, height, room, owner.leading)
            feet = near[place] + unit * np.maximum(gap - TOUCH, 0.0)
            # Rivals only add to the cost, so they are examined only where the other costs are low.
            order = np.argsort(np.round(cost, 6), kind="stable")
            for some in (order[k : k + CHEAPEST] for k in range(0, len(order), CHEAPEST)):
                if cost[some[0]] >= best - 1e-9:
                    break
                far = claimed.apart(low[some], high[some])
                mine, theirs = far[:, :owned].min(axis=1), far[:, owned:].min(axis=1, initial=math.inf)
                mistaken = theirs < mine + CLEARLY
                led = mistaken | (mine > owner.lost)
                whole = cost[some] + owner.mistaken * mistaken
                if led.any():
                    foot = np.column_stack([feet[some].real, feet[some].imag])
                    whole += led * (LEADER + self._in_the_way(foot, middles[some]))
                k = int(np.argmin(np.round(whole, 6)))
                if whole[k] < best - 1e-9:
                    best, chosen = float(whole[k]), int(some[k])
                    leader = complex(feet[chosen]) if led[k] else None
                    found = Stand(complex(at[chosen]), places[int(place[chosen])], leader)
        return found

    def _in_the_way(self, feet: Array, middles: Array) -> Array:
        """Return the price of what each line crosses between a foot and the middle of its word."""
        way = middles - feet
        long = np.maximum(np.hypot(*way.T), 1e-9)[:, None]
        begin = feet + way / long * np.minimum(STEP_OFF, long)
        step = middles - begin
        price: Array = LEADER_CROSSES[0] * self.lines("heavy").crossed(begin, step)
        if self.heavy:
            at = (feet + np.array(ALONG)[:, None, None] * way).reshape(-1, 2)
            off = self.lines("heavy").feet(at) - at[:, None]
            lies = np.hypot(off[..., 0], off[..., 1]).min(axis=1) < STEP_OFF
            price = price + LEADER_CROSSES[0] * np.count_nonzero(lies.reshape(len(ALONG), -1), axis=0)
        worth = [LEADER_CROSSES[2]] * len(self.boxes) + [LEADER_CROSSES[1]] * len(self.words)
        return np.asarray(price + np.array(worth) @ through(begin, step, self.rectangles()))


def _growing(count: int) -> Iterator[tuple[int, int]]:
    """Yield begin and end of successive parts of `count` items: first a few, then more and more."""
    begin, size = 0, FIRST
    while begin < count:
        yield begin, min(begin + size, count)
        begin, size = begin + size, FURTHER * size
