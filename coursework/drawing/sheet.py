"""A sheet of paper in millimetres: lines, circles, arrows, and labels that keep out of each other's way.

Enters: points in mm as complex numbers, x to the right and y **down**.  Leaves: SVG, one user unit = 1 mm.
Used by `drawing/painter.py`, `drawing/board.py`, `drawing/figures.py` and `plans/drawing.py`; knows nothing of mechanisms.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

from coursework.drawing.cover import Lines, common

FONT = "'DejaVu Sans', Verdana, 'Segoe UI', sans-serif"
LETTER = 3.2  # mm, 9 pt
AXIS_LETTER = 2.85  # mm, 8 pt: as small as print gets
SIZES = (LETTER, 2.3, 2.7)  # mm: of a word, of what is set lower, of what follows
BROAD = frozenset("MWmwωΩΨΦφψЖШЩЮФМжшщюфмы%@…—=+−<>")
LONGEST = 60  # letters of a text; what is longer would run over the drawing
PITCH = 1.6  # mm between the strokes of a hatch
DIRECTIONS = 16  # in which a place is looked for
RINGS = (0.0, 2.0, 4.5, 8.0, 12.0, 17.0, 23.0, 30.0, 40.0)  # mm farther out; the last ones only where words would meet
WORD_ON_WORD = 200.0  # mm of lines that a word rather covers than another word
GAP, SIDE_BY_SIDE = 2.2, 4.0  # mm: words nearer on one line read as one; mm of lines that a word rather covers
CROSSED = 3.0  # mm of way that a word with its value rather takes than lying on a line; a name stays near what it names
CROWDED = 8.0  # mm of lines: directions of the axes among more than that are not seen
BEYOND, MARGIN = 30.0, 0.5  # mm of lines for each mm beyond the field; mm kept free around a word
MISTAKEN = 8.0  # mm of lines that a word rather covers than standing nearer to what another word belongs to
BOLD, ITALIC = 'font-weight="bold"', 'font-style="italic"'
Rectangle = tuple[float, float, float, float]
Word = tuple[str, str, str]  # text, what is set lower, what follows
Place = tuple[complex, complex, float]  # beside this point, rather in this direction, at this distance
_NO_LINES = Lines(())


def plain(text: str, longest: int = LONGEST) -> str:
    """Return text fit for SVG: printable letters only, escaped, not too long."""
    kept = "".join(letter for letter in text if letter.isprintable())
    return escape(kept if len(kept) <= longest else kept[: longest - 1] + "…")


def width(text: str) -> float:
    """Return the width of a text in heights of its letters, on the generous side; a letter of Chinese is a square."""
    return sum(
        1.02 if ord(letter) > 0x2E80 else 0.9 if letter in BROAD else 0.71 if letter.isupper() else 0.64 for letter in text
    )


def number(value: float) -> str:
    """Return a coordinate to 0.1 µm, without a minus before zero."""
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def inside(a: complex, b: complex, box: Rectangle) -> tuple[complex, complex] | None:
    """Return the part of a segment within a rectangle (left, top, right, bottom), None where there is none."""
    low, high = 0.0, 1.0
    step = b - a
    for at, rate, least, most in ((a.real, step.real, box[0], box[2]), (a.imag, step.imag, box[1], box[3])):
        if rate == 0:
            if not least <= at <= most:
                return None
            continue
        first, second = sorted(((least - at) / rate, (most - at) / rate))
        low, high = max(low, first), min(high, second)
    return (a + low * step, a + high * step) if low < high else None


class Sheet:
    """What is drawn so far, and which room it takes."""

    def __init__(self, width: float, height: float, field: Rectangle) -> None:
        self.width, self.height, self.field = width, height, field
        self.items: list[str] = []
        self.segments: list[tuple[complex, complex]] = []
        self.boxes: list[Rectangle] = []  # symbols that words keep off
        self.words: list[Rectangle] = []  # words so far
        self._lines = _NO_LINES  # the segments as arrays, made anew when there are more

    def line(self, a: complex, b: complex, pen: str, data: str = "") -> None:
        """Draw a segment, clipped to the drawing field."""
        if part := inside(a, b, self.field):
            a, b = part
            ends = f'x1="{number(a.real)}" y1="{number(a.imag)}" x2="{number(b.real)}" y2="{number(b.imag)}"'
            self.items.append(f"<line {ends} {pen}{data}/>")
            self.segments.append((a, b))

    def path(self, points: Sequence[complex], look: str, *, closed: bool = False, blocks: bool = True) -> None:
        """Draw a line through points; `look` says stroke and fill."""
        text = "L".join(f"{number(p.real)} {number(p.imag)}" for p in points)
        self.items.append(f'<path d="M{text}{"Z" if closed else ""}" {look}/>')
        if blocks:
            self.segments += itertools.pairwise(points)

    def circle(self, at: complex, radius: float, look: str, data: str = "", *, rim: bool = False, blocks: bool = True) -> None:
        """Draw a circle; small ones keep labels off their disc, a `rim` off the line only."""
        self.items.append(f'<circle cx="{number(at.real)}" cy="{number(at.imag)}" r="{number(radius)}" {look}{data}/>')
        if not blocks:
            return
        if rim:
            turn = [at + cmath.rect(radius, math.tau * k / 32) for k in range(33)]
            self.segments += itertools.pairwise(turn)
        else:
            self.boxes.append((at.real - radius, at.imag - radius, at.real + radius, at.imag + radius))

    def arrow(self, a: complex, b: complex, pen: str, data: str = "", head: float = 2.6) -> None:
        """Draw an arrow from a to b with a filled head."""
        along = (b - a) / abs(b - a)
        neck = b - along * min(head, abs(b - a))
        self.line(a, neck, pen, data)
        side = 0.32 * head * 1j * along
        self.path([b, neck + side, neck - side], f'fill="black" stroke="none"{data}', closed=True)

    def axes(self, length: float = 7.0, highest: float = 0.0) -> None:
        """Draw the directions of x and y in the corner where they cover least; below, where that is much and `highest` allows."""
        left, top, right, bottom = self.field
        wide = high = length + 3.5
        corners = [complex(x, y) for y in (bottom - high, top) for x in (left, right - wide)]
        costs = self._covered([corner + complex(wide, high) / 2 for corner in corners], wide, high)
        corner = corners[costs.index(min(costs))]
        if min(costs) > CROWDED + 2 * BEYOND * MARGIN and self.height + high <= highest:
            self.height, self.field = self.height + high, (left, top, right, bottom + high)
            corner = complex(left, bottom)
        at = corner + complex(1, high - 1.5)
        pen = 'stroke="black" stroke-width="0.2"'
        for way, name, shift in ((complex(length), "x", 0.5 + 0.9j), (-length * 1j, "y", 1.0 + 1.2j)):
            self.arrow(at, at + way, pen, head=1.6)
            self.text(at + way + shift, (name, "", ""), ITALIC, AXIS_LETTER)
        self.words.append((corner.real, corner.imag, corner.real + wide, corner.imag + high))

    def hatch(self, a: complex, b: complex, away: complex) -> None:
        """Hatch one side of a segment: short strokes that lean towards `away` (a direction)."""
        if a == b or not away:
            return  # at this scale too small to have sides
        count = max(1, round(abs(b - a) / PITCH))
        along = (b - a) / count
        lean = (away / abs(away) - along / abs(along)) * 1.3
        strokes = [(a + (k + 0.5) * along, a + (k + 0.5) * along + lean) for k in range(count)]
        kept = [(p, q) for p, q in strokes if inside(p, q, self.field)]
        text = "".join(f"M{number(p.real)} {number(p.imag)}L{number(q.real)} {number(q.imag)}" for p, q in kept)
        self.items.append(f'<path d="{text}" fill="none" stroke="black" stroke-width="0.15"/>')
        self.segments += kept

    def label(
        self,
        word: Word,
        places: Iterable[Place],
        look: str = "",
        *,
        turn: int = 0,
        others: Sequence[complex] = (),
        mistaken: float = MISTAKEN,
    ) -> Place:
        """Write a word beside the place where it covers least; return that place.

        `turn` +1 or -1 puts an arc with an arrow before the word: counter-clockwise or clockwise.  `others` are points that
        words alike belong to: a reader takes the nearest, which is worth `mistaken` mm of way.
        """
        lead = 6.6 if turn else 0.0
        wide = lead + sum(size * width(part[:LONGEST]) for part, size in zip(word, SIZES, strict=True))
        height = 5.8 if turn else LETTER * 0.95 + (0.6 if word[1] else 0)
        crossing = CROSSED if word[2] else 1.0
        (_, middle), chosen = min(
            ((self._room(wide, height, place, others, (crossing, mistaken)), place) for place in places),
            key=lambda found: found[0][0],
        )
        left, top = middle.real - wide / 2, middle.imag - height / 2
        self.words.append((left, top, left + wide, top + height))
        if turn:
            self.sense(complex(left + 3, middle.imag), turn)
        base = middle.imag + LETTER * 0.37 - (0.3 if word[1] else 0)
        self.text(complex(left + lead, base), word, look)
        return chosen

    def text(self, at: complex, word: Word, look: str = "", size: float = LETTER) -> None:
        """Write a word, its base line beginning at a point, on a white halo."""
        head, low, tail = (plain(part) for part in word)
        if tail.startswith(" "):
            tail = "\u00a0" + tail[1:]  # a space at the beginning of a piece may be left out by whoever sets the drawing
        below = f'<tspan dy="0.8" font-size="{SIZES[1]}">{low}</tspan>' if low else ""
        beside = (
            f'<tspan{" dy=" + chr(34) + "-0.8" + chr(34) if low else ""} font-size="{SIZES[2]}">{tail}</tspan>' if tail else ""
        )
        halo = 'stroke="white" stroke-width="0.9" stroke-linejoin="round" paint-order="stroke"'
        place = f'x="{number(at.real)}" y="{number(at.imag)}" font-size="{size}"'
        self.items.append(f"<text {place} {halo}{' ' if look else ''}{look}>{head}{below}{beside}</text>")

    def sense(self, at: complex, turn: int, radius: float = 2.3) -> None:
        """Draw the sense of a rotation: an arc of 250 degrees with an arrowhead, +1 counter-clockwise as seen."""
        angles = [math.radians(90 + turn * (-125 + 250 * k / 20)) for k in range(21)]
        arc = [at + radius * cmath.exp(1j * angle).conjugate() for angle in angles]
        self.path(arc, 'fill="none" stroke="black" stroke-width="0.3"', blocks=False)
        along = (arc[-1] - arc[-2]) / abs(arc[-1] - arc[-2])
        tip = arc[-1] + 1.7 * along
        self.path([tip, arc[-1] + 0.9j * along, arc[-1] - 0.9j * along], 'fill="black" stroke="none"', closed=True, blocks=False)

    def _room(
        self, width: float, height: float, place: Place, others: Sequence[complex], costs: tuple[float, float]
    ) -> tuple[float, complex]:
        """Return what the freest of the rectangles around a point covers, and its middle.

        `costs` (mm) are those of each line under it, and of standing nearer to one of `others`.
        """
        crossing, mistaken = costs
        near, away, gap = place
        toward = cmath.phase(away) if away else -math.pi / 4
        best, found = math.inf, near
        for ring in RINGS:
            if 0.5 * ring >= best:
                break
            middles, prices = [], []
            # No rectangle of this ring is nearer than its ring to what lies farther off.
            farthest = 2 * (gap + ring) + math.hypot(width, height)
            close = [other for other in others if abs(other - near) < farthest]
            for k in range(DIRECTIONS):
                turned = math.tau * k / DIRECTIONS
                unit = cmath.rect(1.0, toward + turned)
                # The rectangle touches the circle of radius `gap + ring` about the point.
                reach = min(width / 2 / max(abs(unit.real), 1e-9), height / 2 / max(abs(unit.imag), 1e-9))
                middles.append(near + unit * (gap + ring + reach))
                is_mistaken = any(_apart(middles[-1], width, height, other) < gap + ring for other in close)
                prices.append(0.5 * ring + 0.6 * (1 - math.cos(turned)) + mistaken * is_mistaken)
            for middle, price, covered in zip(middles, prices, self._covered(middles, width, height, crossing), strict=True):
                if price + covered < best - 1e-9:
                    best, found = price + covered, middle
        return best, found

    def _covered(self, middles: Sequence[complex], width: float, height: float, crossing: float = 1.0) -> list[float]:
        """Return how much each of the equal rectangles covers: mm of lines, more for other labels and beyond the field."""
        half = np.array([width / 2 + MARGIN, height / 2 + MARGIN])
        at = np.array([(middle.real, middle.imag) for middle in middles])
        low, high = at - half, at + half
        field = np.array(self.field)
        beyond = np.maximum(field[:2] - low, 0.0) + np.maximum(high - field[2:], 0.0)
        symbols, words = common(low, high, self.boxes), common(low, high, self.words)
        if self._lines.count != len(self.segments):
            self._lines = Lines(self.segments)
        gap = np.array([GAP, 0.0])
        beside = common(low - gap, high + gap, self.words)
        crossed, covered = self._lines.within(low, high)
        cost = BEYOND * beyond.sum(axis=1) + 3.0 * symbols.sum(axis=1) + covered + crossing * crossed
        cost += 6.0 * np.count_nonzero(symbols, axis=1) + WORD_ON_WORD * np.count_nonzero(words, axis=1)
        cost += SIDE_BY_SIDE * np.count_nonzero(beside, axis=1)
        return [float(value) for value in cost]

    def svg(self) -> str:
        """Return the drawing."""
        size = f'width="{number(self.width)}mm" height="{number(self.height)}mm"'
        return "\n".join((
            f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {number(self.width)} {number(self.height)}">',
            f'<g font-family="{FONT}" fill="black" stroke-linecap="round">',
            *self.items,
            "</g>",
            "</svg>",
        ))  # fmt: skip


def _apart(middle: complex, width: float, height: float, point: complex) -> float:
    """Return how far a point is from a rectangle (mm)."""
    off = point - middle
    return math.hypot(max(abs(off.real) - width / 2, 0.0), max(abs(off.imag) - height / 2, 0.0))


def middle_of(points: Iterable[complex]) -> complex:
    """Return the mean of points."""
    listed = list(points)
    return sum(listed, 0j) / len(listed) if listed else 0j
